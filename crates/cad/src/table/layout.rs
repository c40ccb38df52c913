//! What a kind of table may hold, and a table as it is read: what the steps of reading hand on.
//!
//! # Valid
//! One table a file.
//!
//! # References
//! - Own convention.

use super::TableFault;
use super::cells::Line;
use super::quantity::Quantity;
use std::borrow::Cow;

/// Names that a remark lists.
const MOST_NAMES: usize = 12;

/// What a kind of table may hold.
#[derive(Clone, Copy, Debug)]
pub struct Layout {
    /// Quantities that are understood.
    pub quantities: &'static [Quantity],
    /// Columns of a table without heading, in their order, and how many of them it must have.
    pub bare: (&'static [Quantity], usize),
    /// Whether a row without a number is a fault; else it is left out.
    pub whole: bool,
}

/// A column that is understood.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Column {
    /// What it holds.
    pub quantity: Quantity,
    /// Its place in the file, from 0.
    pub place: usize,
    /// Whether the file names its unit.
    pub named_unit: bool,
    /// Whether another column has the same quantity in another unit and is the one that is read.
    pub spare: bool,
    /// SI units, or deg, in its unit.
    pub factor: f64,
    /// What is added to it.
    pub offset: f64,
}

/// The numbers of a table in SI.
#[derive(Clone, Debug, PartialEq)]
pub struct Sheet {
    /// Its columns.
    pub columns: Vec<Column>,
    /// Line of the file and a number a column; none is missing.
    pub rows: Vec<(u64, Vec<f64>)>,
    /// Whether the file names its columns.
    pub headed: bool,
    /// Columns that were left out.
    pub unknown: Vec<String>,
    /// Faults of the spare columns, in their order, where no number tells that they agree with those that are read.
    pub twice: Vec<TableFault>,
    /// What was decided on the way.
    pub remarks: Vec<String>,
}

impl Sheet {
    /// Whether it has a column of a quantity.
    pub fn has(&self, quantity: Quantity) -> bool {
        self.place(quantity).is_some()
    }

    /// Place of a quantity among the columns.
    pub fn place(&self, quantity: Quantity) -> Option<usize> {
        self.columns
            .iter()
            .position(|column| column.quantity == quantity)
    }

    /// Whether the file names the unit of a quantity; of one that it has not, too.
    pub fn has_unit(&self, quantity: Quantity) -> bool {
        let column = self.place(quantity).and_then(|n| self.columns.get(n));
        column.is_none_or(|column| column.named_unit)
    }

    /// The number of a quantity in a row.
    pub fn value(&self, row: &[f64], quantity: Quantity) -> Option<f64> {
        row.get(self.place(quantity)?).copied()
    }

    /// A fault that says which column is missing, and which the file has.
    pub fn missing(&self, name: &'static str) -> TableFault {
        TableFault::MissingColumn {
            name,
            others: listed(&self.unknown),
        }
    }
}

pub(super) type Cells<'t> = Vec<Cow<'t, str>>;

/// A line in cells.
pub(super) struct Cut<'t> {
    pub line: Line<'t>,
    pub cells: Cells<'t>,
    /// Whether most of it are numbers.
    pub data: bool,
    /// Whether its cells stand where the heading says, blanks among them.
    pub placed: bool,
}

/// Whether a line only divides others.
pub(super) fn is_rule(cells: &[Cow<str>]) -> bool {
    cells.iter().all(|cell| {
        cell.chars()
            .all(|c| matches!(c, '-' | '=' | '_' | '+' | '|' | ':' | '*'))
    })
}

/// Names in quotes, no more than a message takes.
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
