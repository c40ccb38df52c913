//! Layout of a kind of table, and the intermediate results of the steps of reading.
//!
//! # Valid
//! One table per file.
//!
//! # References
//! - Own convention.

use super::TableFault;
use super::cells::Line;
use super::quantity::Quantity;
use std::borrow::Cow;

/// Largest number of names in a message.
const MOST_NAMES: usize = 12;

/// Columns that a kind of table may hold.
#[derive(Clone, Copy, Debug)]
pub struct Layout {
    /// Quantities read.
    pub quantities: &'static [Quantity],
    /// Columns of a table without heading, in order, and the least number of them.
    pub bare: (&'static [Quantity], usize),
    /// Whether a row with a missing number is a fault; otherwise it is left out.
    pub whole: bool,
}

/// Column that is read.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Column {
    /// Quantity of the column.
    pub quantity: Quantity,
    /// Index in the file, from 0.
    pub place: usize,
    /// Whether the file names the unit.
    pub named_unit: bool,
    /// Whether another column with the same quantity in another unit is used instead.
    pub spare: bool,
    /// Factor from the column's unit to SI units, or deg.
    pub factor: f64,
    /// Offset added after the factor.
    pub offset: f64,
}

/// Numbers of a table in SI.
#[derive(Clone, Debug, PartialEq)]
pub struct Sheet {
    /// Columns.
    pub columns: Vec<Column>,
    /// Line of the file, and one number per column; none is missing.
    pub rows: Vec<(u64, Vec<f64>)>,
    /// Whether the file names its columns.
    pub headed: bool,
    /// Names of columns that were left out.
    pub unknown: Vec<String>,
    /// Faults of the spare columns, in order; reported where no row has a number to compare with the column used.
    pub twice: Vec<TableFault>,
    /// Decisions made on the way, for the user.
    pub remarks: Vec<String>,
}

impl Sheet {
    /// Whether there is a column of a quantity.
    pub fn has(&self, quantity: Quantity) -> bool {
        self.place(quantity).is_some()
    }

    /// Index of a quantity's column.
    pub fn place(&self, quantity: Quantity) -> Option<usize> {
        self.columns
            .iter()
            .position(|column| column.quantity == quantity)
    }

    /// Whether the file names the unit of a quantity; true for a quantity that it does not have.
    pub fn has_unit(&self, quantity: Quantity) -> bool {
        let column = self.place(quantity).and_then(|n| self.columns.get(n));
        column.is_none_or(|column| column.named_unit)
    }

    /// Value of a quantity in a row.
    pub fn value(&self, row: &[f64], quantity: Quantity) -> Option<f64> {
        row.get(self.place(quantity)?).copied()
    }

    /// Fault that names the missing column and those that the file has.
    pub fn missing(&self, name: &'static str) -> TableFault {
        TableFault::MissingColumn {
            name,
            others: listed(&self.unknown),
        }
    }
}

pub(super) type Cells<'t> = Vec<Cow<'t, str>>;

/// Line split into cells.
pub(super) struct Cut<'t> {
    pub line: Line<'t>,
    pub cells: Cells<'t>,
    /// Whether the cells are mostly numbers.
    pub data: bool,
    /// Whether the cells were assigned by column position, blanks included.
    pub placed: bool,
}

/// Whether a line is only a separator rule.
pub(super) fn is_rule(cells: &[Cow<str>]) -> bool {
    cells.iter().all(|cell| {
        cell.chars()
            .all(|c| matches!(c, '-' | '=' | '_' | '+' | '|' | ':' | '*'))
    })
}

/// Names in quotes, as many as a message shows.
pub(super) fn listed(names: &[String]) -> String {
    let shown = names
        .iter()
        .take(MOST_NAMES)
        .map(|name| format!("\"{name}\""));
    let more = names.len().saturating_sub(MOST_NAMES);
    let list = shown.collect::<Vec<_>>().join(", ");
    if more > 0 {
        format!("{list} and {more} more")
    } else {
        list
    }
}
