//! Entries from a set of attitudes and rates as a table.

use super::Table;
use crate::answer::turning::{COLUMNS, Cell};
use crate::flight::six_dof::turning::Turning;
use crate::units::number::shortest;

/// Table with one row for each entry; headers are keys in SI units, angles in degrees.
pub fn turning(turning: &Turning) -> Table {
    let text = |cell: Cell| match cell {
        Cell::Number(number) => number.map_or_else(String::new, shortest),
        Cell::Word(word) => word.to_string(),
    };
    Table {
        headers: COLUMNS.iter().map(|c| c.key.to_string()).collect(),
        rows: turning
            .entries
            .iter()
            .map(|entry| COLUMNS.iter().map(|c| text((c.cell)(entry))).collect())
            .collect(),
    }
}
