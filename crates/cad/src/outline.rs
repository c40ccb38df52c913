//! Outlines from files: CSV of points, DXF drawings. Both give the rows of `outline.points`.
//!
//! ```text
//! 1 in = 0.0254 m        1 ft = 0.3048 m
//! ```
//!
//! Rows are x and r in m and the bulge of the segment to the next point.
//!
//! # Valid
//! The file name extension selects the reader.
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
use msape::units::Unit;
use thiserror::Error;

pub use msape::quantity::choice::LengthUnit;

/// Largest number of faults reported; assumed.
pub const MOST_FAULTS: usize = 100;
/// Characters of file text quoted in a message.
const MOST_SHOWN: usize = 40;

/// Length of one unit, m.
fn meters(unit: LengthUnit) -> f64 {
    Unit::find(unit.name()).map_or(1.0, |unit| unit.to_canonical(1.0))
}

/// Unit with a symbol.
pub fn unit_of(symbol: &str) -> Option<LengthUnit> {
    match symbol.to_lowercase().as_str() {
        "meter" | "metre" | "meters" | "metres" => Some(LengthUnit::Meter),
        "inch" | "inches" | "\"" => Some(LengthUnit::Inch),
        "feet" | "foot" => Some(LengthUnit::Foot),
        name => LengthUnit::named(name),
    }
}

/// Fault of a file; lines are counted from 1.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum ImportFault {
    /// File without points.
    #[error("the file holds no {0}")]
    Empty(&'static str),
    /// Unit given neither by the file nor by the case.
    #[error(
        "the file does not say its unit; name it in the header, such as \"x (mm), r (mm)\", or with {}",
        input::outline::FILE_UNIT
    )]
    NoUnitInHeader,
    /// Unit given neither by the drawing nor by the case.
    #[error(
        "the drawing has no $INSUNITS; name its unit with {}",
        input::outline::FILE_UNIT
    )]
    NoUnitInDrawing,
    /// Field that is not a number.
    #[error("line {line}: column {column}: got \"{text}\", must be a number")]
    NotANumber {
        /// Line of the file.
        line: u64,
        /// Column, from 1.
        column: usize,
        /// The field, shortened.
        text: String,
    },
    /// Heading that is unknown, repeated or missing.
    #[error("header: {0}")]
    Header(String),
    /// Fault of a table of points.
    #[error("{0}")]
    Table(TableFault),
    /// Line that cannot be read.
    #[error("line {line}: {reason}")]
    Unreadable {
        /// Line of the file.
        line: u64,
        /// Reason.
        reason: String,
    },
    /// Part of a drawing that cannot be read.
    #[error("{place}: {reason}")]
    Drawing {
        /// Place in the file.
        place: Place,
        /// Reason.
        reason: String,
    },
    /// File in the DWG format.
    #[error("the file is a DWG drawing ({0}); save it as DXF")]
    Dwg(String),
    /// File that is too large.
    #[error("the file is larger than {0} MiB")]
    TooLarge(usize),
    /// Entity that may be part of an outline and is not supported.
    #[error(
        "{place}: {kind} is not read; draw the outline with lines, arcs, polylines, ellipses and splines"
    )]
    Entity {
        /// Place in the file.
        place: Place,
        /// Entity type.
        kind: String,
    },
    /// Point with non-finite coordinates.
    #[error(
        "point {0} of the outline comes out at no finite place in m, or its piece as no arc; the numbers of the file are too large or too small"
    )]
    NotFinite(usize),
    /// Pieces that do not form one chain.
    #[error("{0}")]
    Chain(String),
    /// Bytes that are not text.
    #[error("is not text: byte {0} is not UTF-8")]
    NotText(usize),
    /// Unsupported file type.
    #[error("\"{0}\" is neither a CSV nor a DXF file; the name must end in .csv, .txt or .dxf")]
    UnknownKind(String),
}

/// File text, shortened for a message.
fn shown(text: &str) -> String {
    text.chars().take(MOST_SHOWN).collect()
}

/// Imported outline.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Imported {
    /// Rows of x and r in m, and the bulge of the segment to the next point.
    pub rows: Vec<Vec<f64>>,
    /// Messages for the user: parts left out, mirrored, or read in another unit.
    pub remarks: Vec<String>,
}

/// The outline in the file `name`, or all of its faults. A given unit overrides that of a drawing.
///
/// ```
/// use cad::outline::read;
///
/// let cone = read("cone.csv", b"x (mm); r (mm)\n0; 0\n500,0; 500\n500; 0\n", None).unwrap();
/// assert_eq!(cone.rows[1], [0.5, 0.5, 0.0]);
/// ```
///
/// # Errors
/// All faults of the file, up to [`MOST_FAULTS`].
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

/// The outline, read according to the file name extension.
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
