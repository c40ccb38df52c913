//! Tables from text files with one common reader: atmosphere, wind, heating, drag, lift, bank, aerodynamic
//! coefficients, damping and the points of an outline.
//!
//! A file is read in four steps, each in a module of its own: bytes to text ([`crate::text`]), text to cells, cells to
//! columns with names and units, columns to the rows of an input of a case. Decisions made on the way are returned as
//! messages; an ambiguity that cannot be resolved is a fault with its line.

mod aerodynamics;
mod altitude;
mod atmosphere;
mod cells;
mod columns;
mod curve;
mod fault;
mod heading;
mod heating;
mod in_depth;
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
use msape::library::{named, names};
use msape::planet::atmosphere::Atmosphere;
use msape::quantity::input::{self, Input};
use msape::{Case, Library};

pub use fault::TableFault;

/// Largest number of faults reported.
pub(crate) const MOST_FAULTS: usize = 100;
/// Characters of file text quoted in a message.
const MOST_SHOWN: usize = 40;

/// Properties of the planet that some columns need.
#[derive(Clone, Debug)]
pub struct Ground {
    /// Radius used to convert geopotential to geometric altitude, m.
    pub radius_m: f64,
    /// Gas constant of the atmosphere, J/(kg K), where known.
    pub gas_constant_j_kg_k: Option<f64>,
    /// Standard atmosphere that defines pressure altitude; only for the Earth.
    pub standard: Option<Atmosphere>,
}

/// Name of the Earth's standard atmosphere.
const STANDARD: &str = "us-1976";

/// Effective radius of the Earth in the standard atmosphere, m; \[coesa-1976\].
const EARTH_RADIUS_M: f64 = 6_356_766.0;

impl Ground {
    /// Properties of the planet of a case, read as the check of the case reads it; for a `[planet]` table of the case
    /// its mean radius and the gas of the planet that it names. Faults of the case are left to that check.
    pub fn of(case: &Case, library: &Library) -> Ground {
        let mut reader = Reader::new(case);
        let name = reader
            .name(&input::entry::PLANET, &names(&library.planets))
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

    /// Properties of the Earth, as in its standard atmosphere.
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
    /// Rows, in SI and degrees.
    pub rows: Vec<Vec<f64>>,
    /// Decisions of the reader and parts left out, one sentence each without its full stop.
    pub remarks: Vec<String>,
}

/// Reader of the text of a file, for one input of its kind where that is known.
type Rows = fn(&str, Option<&Input>, &Ground) -> Result<Table, Vec<TableFault>>;

/// Inputs that name a file, each with its reader.
static READERS: [(&Input, Rows); 10] = [
    (&input::tps::ENVIRONMENT, |text, _, _| {
        in_depth::environment(text)
    }),
    (&input::tps::SURFACE_TEMPERATURE, |text, _, _| {
        in_depth::surface_temperature(text)
    }),
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

/// Inputs that name a file of a table.
pub fn files() -> impl Iterator<Item = &'static Input> {
    READERS.iter().map(|(file, _)| *file)
}

/// The rows of a file that a case names by the input `file`, or all faults of the file.
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
/// All faults of the file, up to a hundred.
pub fn read(file: &Input, bytes: &[u8], ground: &Ground) -> Result<Table, Vec<TableFault>> {
    rows_of(file, None, bytes, ground)
}

/// Like [`read`], for the one input `table` that is to take the rows. The input decides the meaning of columns without
/// heading, and which of several named columns are used.
///
/// # Errors
/// Like [`read`]; also columns of another input.
pub fn read_for(table: &Input, bytes: &[u8], ground: &Ground) -> Result<Table, Vec<TableFault>> {
    let file = table.file().unwrap_or(table);
    let read = rows_of(file, Some(table), bytes, ground)?;
    if read.key == table.key {
        return Ok(read);
    }
    let (found, wanted) = (read.key, table.to_string());
    Err(vec![TableFault::OtherTable { found, wanted }])
}

/// Rows of a file for an input, or for the input that its columns indicate.
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

/// Text with all line ends replaced by `\n`.
pub(crate) fn with_plain_line_ends(text: String) -> String {
    if text.contains('\r') {
        text.replace("\r\n", "\n").replace('\r', "\n")
    } else {
        text
    }
}

/// File text, shortened for a message.
fn shown(text: &str) -> String {
    text.chars().take(MOST_SHOWN).collect()
}

#[cfg(test)]
mod tests;
