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
mod fault;
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

use crate::text::decode;
use msape::case::Reader;
use msape::library::named;
use msape::planet::atmosphere::Atmosphere;
use msape::quantity::input::{self, Input};
use msape::{Case, Library};

pub use fault::TableFault;

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
        let name = reader
            .name(&input::entry::PLANET, &names)
            .unwrap_or_default();
        let world = named(&library.planets, name);
        let planet = world.map(|world| &world.planet);
        let mean = |equatorial_m: f64, polar_m: f64| (2.0 * equatorial_m + polar_m) / 3.0;
        let own_m = reader
            .number(&input::planet::EQUATORIAL_RADIUS_M)
            .map(|equatorial_m| {
                let polar_m = reader.number(&input::planet::POLAR_RADIUS_M);
                mean(equatorial_m, polar_m.unwrap_or(equatorial_m))
            });
        let gas = world.filter(|_| own_m.is_none() || reader.given(&input::entry::PLANET));
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

/// Reads the text of a file, for one of its inputs where that is known.
type Rows = fn(&str, Option<&Input>, &Ground) -> Result<Table, Vec<TableFault>>;

/// The inputs that name a file, each with what reads it.
static READERS: [(&Input, Rows); 8] = [
    (&input::atmosphere::FILE, |text, _, ground| {
        atmosphere::read(text, ground)
    }),
    (&input::wind::FILE, |text, _, ground| {
        wind::read(text, ground)
    }),
    (&input::heating::FILE, |text, table, _| {
        heating::read(text, table)
    }),
    (&input::vehicle::DRAG_FILE, |text, _, _| curve::drag(text)),
    (&input::vehicle::LIFT_FILE, |text, _, _| curve::lift(text)),
    (&input::vehicle::BANK_FILE, |text, table, _| {
        curve::bank(text, table)
    }),
    (&input::vehicle::AERODYNAMICS_FILE, |text, _, _| {
        aerodynamics::read(text)
    }),
    (&input::vehicle::AERODYNAMICS_DAMPING_FILE, |text, _, _| {
        aerodynamics::damping(text)
    }),
];

/// The inputs that name a file of a table.
pub fn files() -> impl Iterator<Item = &'static Input> {
    READERS.iter().map(|(file, _)| *file)
}

/// The rows of a file that a case names by the input `file`, or everything that is wrong with it.
///
/// ```
/// use cad::table::{Ground, read};
/// use msape::Library;
/// use msape::quantity::input::atmosphere::FILE;
///
/// let earth = Ground::earth(&Library::builtin().unwrap());
/// let file = "T [°C];Höhe (km);Dichte (g/m³)\n15,0;0;1225,0\n-56,5;11;364,8\n";
/// let table = read(&FILE, file.as_bytes(), &earth).unwrap();
/// assert_eq!(table.key, "atmosphere.table");
/// assert_eq!(table.rows[1][0], 11_000.0);
/// ```
///
/// # Errors
/// Every fault of the file, up to a hundred.
pub fn read(file: &Input, bytes: &[u8], ground: &Ground) -> Result<Table, Vec<TableFault>> {
    rows_of(file, None, bytes, ground)
}

/// As [`read`], for the one input `table` that is to take the rows. It says what the columns are that no heading names, and which of
/// several named ones count.
///
/// # Errors
/// As [`read`], and columns of another input.
pub fn read_for(table: &Input, bytes: &[u8], ground: &Ground) -> Result<Table, Vec<TableFault>> {
    let file = table.file().unwrap_or(table);
    let read = rows_of(file, Some(table), bytes, ground)?;
    if read.key == table.key {
        return Ok(read);
    }
    let (found, wanted) = (read.key, table.to_string());
    Err(vec![TableFault::OtherTable { found, wanted }])
}

/// The rows of a file for an input, or for whichever of its inputs the file is.
fn rows_of(
    file: &Input,
    table: Option<&Input>,
    bytes: &[u8],
    ground: &Ground,
) -> Result<Table, Vec<TableFault>> {
    let decoded = decode(bytes).map_err(|fault| vec![fault.into()])?;
    let text = with_plain_line_ends(decoded.text);
    let reader = READERS.iter().find(|(known, _)| *known == file);
    let mut table = match reader {
        Some((_, read)) => read(&text, table, ground),
        None => Err(vec![TableFault::NoFile(file.to_string())]),
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
