//! Checks of the rows of a user's table, which report all faults at once.

use thiserror::Error;

/// Largest number of listed faults, assumed; a file that is not a table at all would else name every line.
pub const MOST_FAULTS: usize = 100;

/// Rule for the numbers of a column, besides being finite.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rule {
    /// Each above the one before.
    Ascending,
    /// Above zero.
    Positive,
    /// Any finite number.
    Finite,
}

/// A column: its key, its unit and its rule.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Column {
    /// Key as in the case file.
    pub name: &'static str,
    /// Unit.
    pub unit: &'static str,
    /// Rule for its numbers.
    pub rule: Rule,
}

/// The least that a table must have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shape {
    /// Rows.
    pub fewest_rows: usize,
    /// Columns.
    pub fewest_columns: usize,
}

/// One thing wrong with a table; rows are counted from 1.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum RowFault {
    /// Too few rows.
    #[error("got {rows} rows, must be at least {fewest}")]
    TooFewRows {
        /// Rows given.
        rows: usize,
        /// Least number.
        fewest: usize,
    },
    /// Number of values in a row that differs from the first row, or exceeds the number of columns.
    #[error("row {row}: got {columns} numbers, must be {expected}")]
    Ragged {
        /// Row.
        row: usize,
        /// Numbers in it.
        columns: usize,
        /// Allowed values.
        expected: String,
    },
    /// NaN or an infinite number.
    #[error("row {row}: {column}: got {value} {unit}, must be finite")]
    NotFinite {
        /// Row.
        row: usize,
        /// Column.
        column: &'static str,
        /// Value given.
        value: f64,
        /// Unit.
        unit: &'static str,
    },
    /// Zero or negative.
    #[error("row {row}: {column}: got {value} {unit}, must be above 0 {unit}")]
    NotPositive {
        /// Row.
        row: usize,
        /// Column.
        column: &'static str,
        /// Value given.
        value: f64,
        /// Unit.
        unit: &'static str,
    },
    /// Density, temperature and pressure of no gas.
    #[error(
        "row {row}: density, temperature and pressure make a gas of {molar_mass_kg_kmol:.4} kg/kmol, must be {lightest} to {heaviest} kg/kmol; are density in kg/m³, temperature in K and pressure in Pa?"
    )]
    ImpossibleGas {
        /// Row.
        row: usize,
        /// Molar mass, kg/kmol.
        molar_mass_kg_kmol: f64,
        /// Least molar mass, kg/kmol.
        lightest: f64,
        /// Largest molar mass, kg/kmol.
        heaviest: f64,
    },
    /// Value not above that of the row before.
    #[error(
        "row {row}: {column}: got {value} {unit}, must be above {before} {unit} of the row before"
    )]
    NotAscending {
        /// Row.
        row: usize,
        /// Column.
        column: &'static str,
        /// Value given.
        value: f64,
        /// Value of the row before.
        before: f64,
        /// Unit.
        unit: &'static str,
    },
}

/// Checks all rows; the faults in the order of the rows, [`MOST_FAULTS`] at most.
pub fn check(rows: &[Vec<f64>], columns: &[Column], shape: Shape) -> Result<(), Vec<RowFault>> {
    let Shape {
        fewest_rows,
        fewest_columns,
    } = shape;
    let mut faults = Vec::new();
    if rows.len() < fewest_rows {
        faults.push(RowFault::TooFewRows {
            rows: rows.len(),
            fewest: fewest_rows,
        });
    }
    let width = rows.first().map_or(0, Vec::len);
    let width_allowed = (fewest_columns..=columns.len()).contains(&width);
    let mut before: Option<&Vec<f64>> = None;
    for (index, values) in rows.iter().enumerate() {
        if faults.len() >= MOST_FAULTS {
            break;
        }
        let row = index + 1;
        if values.len() != width || !width_allowed {
            let expected = if width_allowed {
                format!("{width} as in row 1")
            } else if fewest_columns == columns.len() {
                format!("{fewest_columns}")
            } else {
                format!("{fewest_columns} to {}", columns.len())
            };
            faults.push(RowFault::Ragged {
                row,
                columns: values.len(),
                expected,
            });
        }
        for (i, (value, column)) in values.iter().zip(columns).enumerate() {
            let (
                value,
                Column {
                    name: column,
                    unit,
                    rule,
                },
            ) = (*value, *column);
            if !value.is_finite() {
                faults.push(RowFault::NotFinite {
                    row,
                    column,
                    value,
                    unit,
                });
            } else if rule == Rule::Positive && value <= 0.0 {
                faults.push(RowFault::NotPositive {
                    row,
                    column,
                    value,
                    unit,
                });
            } else if rule == Rule::Ascending
                && let Some(before) = before.and_then(|b| b.get(i)).copied()
                && value <= before
            {
                faults.push(RowFault::NotAscending {
                    row,
                    column,
                    value,
                    before,
                    unit,
                });
            }
        }
        before = Some(values);
    }
    if faults.is_empty() {
        Ok(())
    } else {
        Err(faults)
    }
}
