//! Faults of a table file, in messages that say where they are and what to do.
//!
//! # References
//! - Own convention.

use crate::text::NotText;
use thiserror::Error;

/// Fault of a table file; lines are counted from 1.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum TableFault {
    /// Bytes that are not text.
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
    /// Blank cell where every number is needed.
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
    /// Number that is too large in SI units.
    #[error("line {line}: column {column}: got \"{text}\", which is no finite number in SI")]
    TooLarge {
        /// Line of the file.
        line: u64,
        /// Column, from 1.
        column: usize,
        /// The cell, shortened.
        text: String,
    },
    /// Row with a derived value that is not finite.
    #[error("row {row}: got {value} where the columns give the rest, must be a finite number")]
    NotFinite {
        /// Row of the table, from 1.
        row: usize,
        /// Derived value.
        value: f64,
    },
    /// Too few or too many cells.
    #[error("line {line}: got {found} fields, must be {wanted}")]
    Fields {
        /// Line of the file.
        line: u64,
        /// Number of cells in the line.
        found: usize,
        /// Number of cells of the other lines.
        wanted: usize,
    },
    /// Decimal points and decimal commas in one file.
    #[error("both signs stand for the decimal sign: \"{}\" (line {}) and \"{}\" (line {}); use one of them", texts[0], lines[0], texts[1], lines[1])]
    TwoDecimalSigns {
        /// One line for each decimal sign.
        lines: [u64; 2],
        /// Cells, shortened.
        texts: [String; 2],
    },
    /// Sign that may be a thousands separator or a decimal sign.
    #[error(
        "line {line}: got \"{text}\", which may be thousands or decimals; write it without the sign, or with other decimals"
    )]
    Thousands {
        /// Line of the file.
        line: u64,
        /// The cell, shortened.
        text: String,
    },
    /// Heading without any known name.
    #[error("line {line}: header: got {names}; must be of {expected}, with their units")]
    UnknownHeading {
        /// Line of the file.
        line: u64,
        /// Cells of the heading, shortened.
        names: String,
        /// Known names.
        expected: String,
    },
    /// Rows without heading that need one.
    #[error(
        "the rows have {columns} columns and no heading names them; name {expected} above them"
    )]
    NoHeading {
        /// Number of columns.
        columns: usize,
        /// Known names.
        expected: String,
    },
    /// Column named twice.
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
        /// Quantity.
        name: &'static str,
    },
    /// Quantity in two units whose values disagree.
    #[error(
        "line {line}: {name} is {} in column {} and {} in column {}, both in SI; take the wrong one of the two columns out",
        values[0], columns[0], values[1], columns[1]
    )]
    Disagree {
        /// Line of the file.
        line: u64,
        /// Quantity.
        name: &'static str,
        /// The two columns, from 1.
        columns: [usize; 2],
        /// Their values, in SI.
        values: [f64; 2],
    },
    /// Unknown unit of a column.
    #[error(
        "header: column {column}: got the unit \"{unit}\", must be one of {expected}; if the column is no {name}, give it another name"
    )]
    UnknownUnit {
        /// Column, from 1.
        column: usize,
        /// The unit, shortened.
        unit: String,
        /// Quantity.
        name: &'static str,
        /// Known units.
        expected: &'static str,
    },
    /// Required column that is missing.
    #[error("header: no column for {name}{}", if others.is_empty() { String::new() } else { format!("; the others are {others}") })]
    MissingColumn {
        /// Quantity.
        name: &'static str,
        /// Unknown columns.
        others: String,
    },
    /// Line between heading and numbers that is neither.
    #[error("line {line}: neither units of the heading above nor numbers")]
    NeitherUnitsNorNumbers {
        /// Line of the file.
        line: u64,
    },
    /// Angles that appear to be in radians under a heading without unit.
    #[error(
        "header: the largest angle is {0}, which is pi or a part of it, or a whole number of deg in rad; name its unit, alpha_deg or alpha_rad"
    )]
    Radians(f64),
    /// Column "H" on the Earth, which may be geopotential or geometric altitude.
    #[error(
        "header: H is geopotential altitude in standard atmospheres and height elsewhere; name it geopotential_altitude or altitude"
    )]
    CapitalH,
    /// Table without heading whose second column is not density.
    #[error(
        "line {line}: the second column grows with height, as no density does; name the columns in a heading"
    )]
    NotADensity {
        /// Line of the file.
        line: u64,
    },
    /// Table without heading whose second column is larger than any density.
    #[error(
        "line {line}: the second column is {value}, which is no density in kg/m3; name the columns in a heading"
    )]
    TooDense {
        /// Line of the file.
        line: u64,
        /// Value in the second column.
        value: f64,
    },
    /// Quantity without unit whose values do not fit the assumed unit.
    #[error(
        "line {line}: the heading names no unit for {name}, and {value} is no {name} there in {taken}; name its unit, {such}"
    )]
    NoUnit {
        /// Line of the file.
        line: u64,
        /// Quantity.
        name: &'static str,
        /// Value.
        value: f64,
        /// Assumed unit.
        taken: &'static str,
        /// Example of a heading with unit.
        such: &'static str,
    },
    /// Altitude without unit that is not in m.
    #[error(
        "header: the altitude has no unit and is no m: density would be {fall:.1} times less {rise} m higher; name it with its unit, altitude_km"
    )]
    Steep {
        /// Altitude of the highest row above the lowest, m.
        rise: f64,
        /// Ratio of density at the bottom to that at the top.
        fall: f64,
    },
    /// Rows of equal Mach number that belong to several curves.
    #[error(
        "line {line}: at mach {mach} {name} goes from {} to {}, and the columns left out tell its rows apart: {others}; keep the rows of one curve",
        range[0], range[1]
    )]
    Curves {
        /// Line of the file.
        line: u64,
        /// Mach number.
        mach: f64,
        /// Quantity.
        name: &'static str,
        /// Smallest and largest value.
        range: [f64; 2],
        /// Columns left out, which distinguish the curves.
        others: String,
    },
    /// Mach numbers that rise and fall, as along a flight.
    #[error(
        "line {line}: mach falls here and in {more} more lines, as along a flight; keep one row a Mach number, or the rows of one branch, in ascending order"
    )]
    Branches {
        /// Line of the file.
        line: u64,
        /// Number of other lines in which it falls.
        more: usize,
    },
    /// Density missing and not computable from pressure and temperature, as the gas is unknown.
    #[error(
        "header: no column for density; it is not found from pressure and temperature, as the gas of this planet is not known"
    )]
    UnknownGas,
    /// Pressure altitude on another planet, or without temperature and density.
    #[error("header: pressure altitude is a pressure; {0}")]
    PressureAltitude(&'static str),
    /// Rows that are not in order.
    #[error("line {line}: {name} {value} after {before}; rows must ascend in it, or descend")]
    Order {
        /// Line of the file.
        line: u64,
        /// Quantity.
        name: &'static str,
        /// Value.
        value: f64,
        /// Value of the previous row.
        before: f64,
    },
    /// Columns of another input than the one to be filled.
    #[error("the columns are those of {found}, must be those of {wanted}")]
    OtherTable {
        /// Key of the input that takes such columns.
        found: &'static str,
        /// Key of the input to be filled.
        wanted: String,
    },
    /// Input that does not name a file of a table.
    #[error("{0} names no file of a table")]
    NoFile(String),
    /// Fault found by the check of the table's rows.
    #[error("{0}")]
    Rows(String),
}
