//! What is wrong with a table from a file, in words that say where and what to do.
//!
//! # References
//! - Own convention.

use crate::text::NotText;
use thiserror::Error;

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
    /// Columns of another input than the rows are for.
    #[error("the columns are those of {found}, must be those of {wanted}")]
    OtherTable {
        /// Key of the input that takes such columns.
        found: &'static str,
        /// Key of the input that the rows are for.
        wanted: String,
    },
    /// An input that names no file of a table.
    #[error("{0} names no file of a table")]
    NoFile(String),
    /// What the table itself says of its rows.
    #[error("{0}")]
    Rows(String),
}
