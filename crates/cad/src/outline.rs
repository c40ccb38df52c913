//! Outlines from files: CSV of points, DXF drawings. Both give the rows that `outline.points` holds.
//!
//! ```text
//! 1 in = 0.0254 m        1 ft = 0.3048 m
//! ```
//!
//! Rows are x and r in m and the bulge of the piece to the next point.
//!
//! # Valid
//! The kind of file is told by the ending of its name.
//!
//! # References
//! - \[nist-sp-811\] appendix B for the factors.

pub mod chain;
pub mod csv;
pub mod dxf;
pub mod half_section;
pub mod halves;

use crate::table::TableFault;
use crate::text::{Decoded, decode};
use dxf::group::Place;
use msape::quantity::choice::Choice;
use msape::quantity::input;
use thiserror::Error;

pub use msape::quantity::choice::LengthUnit;

/// Faults are listed up to this number, assumed.
pub const MOST_FAULTS: usize = 100;
/// Characters of a text from a file that a message shows.
const MOST_SHOWN: usize = 40;

/// Metres in a unit.
fn metres(unit: LengthUnit) -> f64 {
    match unit {
        LengthUnit::Metre => 1.0,
        LengthUnit::Centimetre => 0.01,
        LengthUnit::Millimetre => 0.001,
        LengthUnit::Inch => 0.0254,
        LengthUnit::Foot => 0.3048,
    }
}

/// The unit of a symbol.
pub fn unit_of(symbol: &str) -> Option<LengthUnit> {
    match symbol.to_lowercase().as_str() {
        "meter" | "metre" | "meters" | "metres" => Some(LengthUnit::Metre),
        "inch" | "inches" | "\"" => Some(LengthUnit::Inch),
        "feet" | "foot" => Some(LengthUnit::Foot),
        name => LengthUnit::named(name),
    }
}

/// One thing wrong with a file; lines are counted from 1.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum ImportFault {
    /// The file holds no point.
    #[error("the file holds no {0}")]
    Empty(&'static str),
    /// Neither the file nor the case says the unit.
    #[error(
        "the file does not say its unit; name it in the header, such as \"x (mm), r (mm)\", or with {}",
        input::outline::FILE_UNIT
    )]
    NoUnitInHeader,
    /// Neither the drawing nor the case says the unit.
    #[error(
        "the drawing has no $INSUNITS; name its unit with {}",
        input::outline::FILE_UNIT
    )]
    NoUnitInDrawing,
    /// A field that is not a number.
    #[error("line {line}: column {column}: got \"{text}\", must be a number")]
    NotANumber {
        /// Line of the file.
        line: u64,
        /// Column, from 1.
        column: usize,
        /// The field, shortened.
        text: String,
    },
    /// A heading that is not known, or comes twice, or is missing.
    #[error("header: {0}")]
    Header(String),
    /// A fault of a table of points.
    #[error("{0}")]
    Table(TableFault),
    /// A line that cannot be read.
    #[error("line {line}: {reason}")]
    Unreadable {
        /// Line of the file.
        line: u64,
        /// Why.
        reason: String,
    },
    /// Something in a drawing that cannot be read.
    #[error("{place}: {reason}")]
    Drawing {
        /// Where.
        place: Place,
        /// Why.
        reason: String,
    },
    /// A drawing in another format.
    #[error("the file is a DWG drawing ({0}); save it as DXF")]
    Dwg(String),
    /// A file that is too large.
    #[error("the file is larger than {0} MiB")]
    TooLarge(usize),
    /// A kind of entity that may be part of an outline and is not read.
    #[error(
        "{place}: {kind} is not read; draw the outline with lines, arcs, polylines, ellipses and splines"
    )]
    Entity {
        /// Where.
        place: Place,
        /// Its name in the drawing.
        kind: String,
    },
    /// A point that is nowhere.
    #[error(
        "point {0} of the outline comes out at no finite place in m, or its piece as no arc; the numbers of the file are too large or too small"
    )]
    NotFinite(usize),
    /// Pieces that do not make one chain.
    #[error("{0}")]
    Chain(String),
    /// Bytes that are no text.
    #[error("is not text: byte {0} is not UTF-8")]
    NotText(usize),
    /// A kind of file that is not read.
    #[error("\"{0}\" is neither a CSV nor a DXF file; the name must end in .csv, .txt or .dxf")]
    UnknownKind(String),
}

/// A text from a file, short enough for a message.
fn shown(text: &str) -> String {
    text.chars().take(MOST_SHOWN).collect()
}

/// An outline from a file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Imported {
    /// Rows of x and r in m, and the bulge to the next.
    pub rows: Vec<Vec<f64>>,
    /// What a reader of the file should know: what was left out, mirrored, or read in another unit.
    pub remarks: Vec<String>,
}

/// The outline in the bytes of the file `name`, or everything that is wrong with it. A unit that is given stands above that of a
/// drawing.
///
/// ```
/// use cad::outline::read;
///
/// let cone = read("cone.csv", b"x (mm); r (mm)\n0; 0\n500,0; 500\n500; 0\n", None).unwrap();
/// assert_eq!(cone.rows[1], [0.5, 0.5, 0.0]);
/// ```
///
/// # Errors
/// Every fault of the file, up to [`MOST_FAULTS`].
pub fn read(
    name: &str,
    bytes: &[u8],
    unit: Option<LengthUnit>,
) -> Result<Imported, Vec<ImportFault>> {
    let imported = of_kind(name, bytes, unit)?;
    let wild = |row: &[f64]| row.iter().any(|value| !value.is_finite());
    match imported.rows.iter().position(|row| wild(row)) {
        None => Ok(imported),
        Some(row) => Err(vec![ImportFault::NotFinite(row + 1)]),
    }
}

/// The outline by the kind of file that the ending of its name tells.
fn of_kind(
    name: &str,
    bytes: &[u8],
    unit: Option<LengthUnit>,
) -> Result<Imported, Vec<ImportFault>> {
    let ending = name.rsplit('.').next().unwrap_or("").to_lowercase();
    if ending == "dxf" || ending == "dwg" {
        return dxf::read(bytes, unit);
    }
    if !["csv", "txt", "tsv", "dat"].contains(&ending.as_str()) {
        return Err(vec![ImportFault::UnknownKind(shown(name))]);
    }
    let of_text = |fault| vec![ImportFault::Table(TableFault::NotText(fault))];
    let Decoded { text, encoding } = decode(bytes).map_err(of_text)?;
    let mut imported = if half_section::is_half_section(&text) {
        half_section::read(&text, unit)?
    } else {
        csv::read(&text, unit)?
    };
    let remark = encoding.map(|encoding| format!("the file is read as {encoding}"));
    imported.remarks.splice(0..0, remark);
    Ok(imported)
}
