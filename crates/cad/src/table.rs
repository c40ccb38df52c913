//! Tables from text files, one reader for all of them: atmosphere, wind, heating, drag, lift, bank, aerodynamic coefficients, damping
//! and the points of an outline.
//!
//! A file is read in four steps, each in a module of its own: bytes to text ([`crate::text`]), text to cells, cells to columns
//! with names and units, columns to the rows that an input of a case takes. What had to be decided on the way comes back as
//! remarks; what cannot be decided is a fault with its line.

mod aerodynamics;
mod altitude;
mod atmosphere;
mod cells;
mod columns;
mod curve;
mod heading;
mod heating;
pub(crate) mod layout;
mod number;
mod places;
pub(crate) mod quantity;
mod separator;
pub(crate) mod sheet;
mod squeezed;
mod units;
mod wind;

use crate::text::{NotText, decode};
use msape::case::Reader;
use msape::library::named;
use msape::planet::atmosphere::Atmosphere;
use msape::{Case, Library};
use thiserror::Error;

/// Faults are listed up to this number.
pub(crate) const MOST_FAULTS: usize = 100;
/// Characters of a text from a file that a message shows.
const MOST_SHOWN: usize = 40;

/// Facts of the planet that some columns need.
#[derive(Clone, Debug)]
pub struct Ground {
    /// Radius by which geopotential altitudes become geometric, m.
    pub radius_m: f64,
    /// Gas constant of the air, J/(kg K), where it is known.
    pub gas_constant_j_kg_k: Option<f64>,
    /// The standard atmosphere to which pressure altitudes belong: of the Earth only.
    pub standard: Option<Atmosphere>,
}

/// Name of the standard atmosphere of the Earth.
const STANDARD: &str = "us-1976";

/// Effective radius of the Earth in the standard atmosphere, m; \[coesa-1976\].
const EARTH_RADIUS_M: f64 = 6_356_766.0;

impl Ground {
    /// That of the planet of a case, read as the case's check reads it; of a `[planet]` of the case its mean radius and the gas of
    /// the planet that it names. What is faulty is left to that check.
    pub fn of(case: &Case, library: &Library) -> Ground {
        let mut reader = Reader::new(case);
        let names: Vec<&str> = library.planets.iter().map(|(name, _)| &**name).collect();
        let name = reader.choice("entry.planet", &names).unwrap_or_default();
        let world = named(&library.planets, name);
        let planet = world.map(|world| &world.planet);
        let mean = |equatorial_m: f64, polar_m: f64| (2.0 * equatorial_m + polar_m) / 3.0;
        let own_m = reader
            .number("planet.equatorial_radius_m")
            .map(|equatorial_m| {
                let polar_m = reader.number("planet.polar_radius_m");
                mean(equatorial_m, polar_m.unwrap_or(equatorial_m))
            });
        let gas = world.filter(|_| own_m.is_none() || reader.given("entry.planet"));
        match (own_m, planet) {
            (None, Some(planet)) if planet.atmosphere == STANDARD => Ground::earth(library),
            (None, None) => Ground::earth(library),
            (own_m, planet) => Ground {
                radius_m: own_m
                    .or_else(|| {
                        planet.map(|planet| mean(planet.equatorial_radius_m, planet.polar_radius_m))
                    })
                    .unwrap_or(EARTH_RADIUS_M),
                gas_constant_j_kg_k: gas.map(|world| gas_constant_j_kg_k(&world.atmosphere)),
                standard: None,
            },
        }
    }

    /// That of the Earth, as in its standard atmosphere.
    pub fn earth(library: &Library) -> Ground {
        let standard = named(&library.atmospheres, STANDARD).map(|(_, standard)| standard);
        Ground {
            radius_m: EARTH_RADIUS_M,
            gas_constant_j_kg_k: standard.map(gas_constant_j_kg_k),
            standard: standard.cloned(),
        }
    }
}

/// Gas constant of an atmosphere, J/(kg K).
fn gas_constant_j_kg_k(atmosphere: &Atmosphere) -> f64 {
    atmosphere.planet_air().gas.gas_constant_j_kg_k
}

/// Rows for an input of a case.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// Key of the input, such as `atmosphere.table`.
    pub key: &'static str,
    /// Its rows, in SI and degrees.
    pub rows: Vec<Vec<f64>>,
    /// What the reader decided or left out, one sentence each without its full stop.
    pub remarks: Vec<String>,
}

/// One thing wrong with a file; lines are counted from 1.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum TableFault {
    /// Bytes that are no text.
    #[error("{0}")]
    NotText(#[from] NotText),
    /// No line of numbers.
    #[error("the file holds no row of numbers")]
    Empty,
    /// A cell that is not a number.
    #[error("line {line}: column {column}: got \"{text}\", must be a number")]
    NotANumber {
        /// Line of the file.
        line: u64,
        /// Column, from 1.
        column: usize,
        /// The cell, shortened.
        text: String,
    },
    /// A blank cell where every number counts.
    #[error(
        "line {line}: column {column}: got \"{text}\", must be a number; the table has a hole there"
    )]
    Hole {
        /// Line of the file.
        line: u64,
        /// Column, from 1.
        column: usize,
        /// The cell, shortened.
        text: String,
    },
    /// A number beyond what can be reckoned with once it stands in SI.
    #[error("line {line}: column {column}: got \"{text}\", which is no finite number in SI")]
    TooLarge {
        /// Line of the file.
        line: u64,
        /// Column, from 1.
        column: usize,
        /// The cell, shortened.
        text: String,
    },
    /// A row of which something derived is no finite number.
    #[error("row {row}: got {value} where the columns give the rest, must be a finite number")]
    NotFinite {
        /// Row of the table, from 1.
        row: usize,
        /// What came out.
        value: f64,
    },
    /// Too few or too many cells.
    #[error("line {line}: got {found} fields, must be {wanted}")]
    Fields {
        /// Line of the file.
        line: u64,
        /// Cells in it.
        found: usize,
        /// Cells of the other lines.
        wanted: usize,
    },
    /// Decimal points and decimal commas in one file.
    #[error("both signs stand for the decimal sign: \"{}\" (line {}) and \"{}\" (line {}); use one of them", texts[0], lines[0], texts[1], lines[1])]
    TwoDecimalSigns {
        /// Lines of the two.
        lines: [u64; 2],
        /// The cells, shortened.
        texts: [String; 2],
    },
    /// A sign that groups thousands, or stands for decimals.
    #[error(
        "line {line}: got \"{text}\", which may be thousands or decimals; write it without the sign, or with other decimals"
    )]
    Thousands {
        /// Line of the file.
        line: u64,
        /// The cell, shortened.
        text: String,
    },
    /// A heading of which nothing is known.
    #[error("line {line}: header: got {names}; must be of {expected}, with their units")]
    UnknownHeading {
        /// Line of the file.
        line: u64,
        /// Its cells, shortened.
        names: String,
        /// Names that are understood.
        expected: String,
    },
    /// Rows that no heading names, and that may not go without.
    #[error(
        "the rows have {columns} columns and no heading names them; name {expected} above them"
    )]
    NoHeading {
        /// Columns of the rows.
        columns: usize,
        /// Names that are understood.
        expected: String,
    },
    /// A column that is named twice.
    #[error(
        "line {line}: header: column {column}: \"{text}\" is {name} a second time; take one of the two out"
    )]
    TwiceNamed {
        /// Line of the file.
        line: u64,
        /// Column, from 1.
        column: usize,
        /// The heading, shortened.
        text: String,
        /// The quantity.
        name: &'static str,
    },
    /// One quantity in two units that do not say the same.
    #[error(
        "line {line}: {name} is {} in column {} and {} in column {}, both in SI; take the wrong one of the two columns out",
        values[0], columns[0], values[1], columns[1]
    )]
    Disagree {
        /// Line of the file.
        line: u64,
        /// The quantity.
        name: &'static str,
        /// The two columns, from 1.
        columns: [usize; 2],
        /// What they say, in SI.
        values: [f64; 2],
    },
    /// A unit that is not known for its column.
    #[error(
        "header: column {column}: got the unit \"{unit}\", must be one of {expected}; if the column is no {name}, give it another name"
    )]
    UnknownUnit {
        /// Column, from 1.
        column: usize,
        /// The unit, shortened.
        unit: String,
        /// The quantity.
        name: &'static str,
        /// Units that are understood.
        expected: &'static str,
    },
    /// A needed column is missing.
    #[error("header: no column for {name}{}", if others.is_empty() { String::new() } else { format!("; the others are {others}") })]
    MissingColumn {
        /// The quantity.
        name: &'static str,
        /// Columns that are not understood.
        others: String,
    },
    /// A line between heading and numbers that is neither.
    #[error("line {line}: neither units of the heading above nor numbers")]
    NeitherUnitsNorNumbers {
        /// Line of the file.
        line: u64,
    },
    /// Angles in radians under a heading that does not say so.
    #[error(
        "header: the largest angle is {0}, which is pi or a part of it, or a whole number of deg in rad; name its unit, alpha_deg or alpha_rad"
    )]
    Radians(f64),
    /// A plain H on the Earth.
    #[error(
        "header: H is geopotential altitude in standard atmospheres and height elsewhere; name it geopotential_altitude or altitude"
    )]
    CapitalH,
    /// A table without heading whose second column is no density.
    #[error(
        "line {line}: the second column grows with height, as no density does; name the columns in a heading"
    )]
    NotADensity {
        /// Line of the file.
        line: u64,
    },
    /// The same of one that is denser than any air.
    #[error(
        "line {line}: the second column is {value}, which is no density in kg/m3; name the columns in a heading"
    )]
    TooDense {
        /// Line of the file.
        line: u64,
        /// What stands there.
        value: f64,
    },
    /// A quantity without unit that is not in the one taken.
    #[error(
        "line {line}: the heading names no unit for {name}, and {value} is no {name} there in {taken}; name its unit, {such}"
    )]
    NoUnit {
        /// Line of the file.
        line: u64,
        /// The quantity.
        name: &'static str,
        /// What stands there.
        value: f64,
        /// The unit taken.
        taken: &'static str,
        /// A heading that may be meant.
        such: &'static str,
    },
    /// An altitude without unit that is not in m.
    #[error(
        "header: the altitude has no unit and is no m: density would be {fall:.1} times less {rise} m higher; name it with its unit, altitude_km"
    )]
    Steep {
        /// From the lowest row to the highest, m.
        rise: f64,
        /// Density of the one in that of the other.
        fall: f64,
    },
    /// Rows of one Mach number that belong to several curves.
    #[error(
        "line {line}: at mach {mach} {name} goes from {} to {}, and the columns left out tell its rows apart: {others}; keep the rows of one curve",
        range[0], range[1]
    )]
    Curves {
        /// Line of the file.
        line: u64,
        /// Mach number.
        mach: f64,
        /// The quantity.
        name: &'static str,
        /// Least and largest value.
        range: [f64; 2],
        /// The columns.
        others: String,
    },
    /// Mach numbers that rise and fall, as along a flight.
    #[error(
        "line {line}: mach falls here and in {more} more lines, as along a flight; keep one row a Mach number, or the rows of one branch, in ascending order"
    )]
    Branches {
        /// Line of the file.
        line: u64,
        /// Other lines in which it does.
        more: usize,
    },
    /// A pressure that gives no density, as the gas is not known.
    #[error(
        "header: no column for density; it is not found from pressure and temperature, as the gas of this planet is not known"
    )]
    UnknownGas,
    /// Pressure altitudes off the Earth, or without temperature and density.
    #[error("header: pressure altitude is a pressure; {0}")]
    PressureAltitude(&'static str),
    /// Rows that are in no order.
    #[error("line {line}: {name} {value} after {before}; rows must ascend in it, or descend")]
    Order {
        /// Line of the file.
        line: u64,
        /// The quantity.
        name: &'static str,
        /// Its value.
        value: f64,
        /// That of the row before.
        before: f64,
    },
    /// What the table itself says of its rows.
    #[error("{0}")]
    Rows(String),
}

/// The keys that name a file.
pub const FILES: [&str; 8] = [
    "atmosphere.file",
    "wind.file",
    "heating.file",
    "vehicle.drag_file",
    "vehicle.lift_file",
    "vehicle.bank_file",
    "vehicle.aerodynamics.file",
    "vehicle.aerodynamics.damping_file",
];

/// The rows of a file that a case names under `key`, or everything that is wrong with it.
///
/// ```
/// use cad::table::{Ground, read};
/// use msape::Library;
///
/// let earth = Ground::earth(&Library::builtin().unwrap());
/// let file = "T [°C];Höhe (km);Dichte (g/m³)\n15,0;0;1225,0\n-56,5;11;364,8\n";
/// let table = read("atmosphere.file", file.as_bytes(), &earth).unwrap();
/// assert_eq!(table.key, "atmosphere.table");
/// assert_eq!(table.rows[1][0], 11_000.0);
/// ```
///
/// # Errors
/// Every fault of the file, up to a hundred.
pub fn read(key: &str, bytes: &[u8], ground: &Ground) -> Result<Table, Vec<TableFault>> {
    let decoded = decode(bytes).map_err(|fault| vec![fault.into()])?;
    let text = with_plain_line_ends(decoded.text);
    let mut table = match key {
        "wind.file" => wind::read(&text, ground),
        "heating.file" => heating::read(&text),
        "vehicle.drag_file" => curve::drag(&text),
        "vehicle.lift_file" => curve::lift(&text),
        "vehicle.bank_file" => curve::bank(&text),
        "vehicle.aerodynamics.file" => aerodynamics::read(&text),
        "vehicle.aerodynamics.damping_file" => aerodynamics::damping(&text),
        _ => atmosphere::read(&text, ground),
    }?;
    let wild = table.rows.iter().zip(1..).find_map(|(cells, row)| {
        let value = cells.iter().find(|value| !value.is_finite())?;
        Some(TableFault::NotFinite { row, value: *value })
    });
    if let Some(fault) = wild {
        return Err(vec![fault]);
    }
    if let Some(encoding) = decoded.encoding {
        table
            .remarks
            .insert(0, format!("the file is read as {encoding}"));
    }
    Ok(table)
}

/// Ends of lines of Unix in the place of others.
pub(crate) fn with_plain_line_ends(text: String) -> String {
    if text.contains('\r') {
        text.replace("\r\n", "\n").replace('\r', "\n")
    } else {
        text
    }
}

/// A text from a file, short enough for a message.
fn shown(text: &str) -> String {
    text.chars().take(MOST_SHOWN).collect()
}

#[cfg(test)]
mod tests;
