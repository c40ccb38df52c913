//! Faults of tables and numbers.

/// Reason why a material, a stack or an environment is refused.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum Fault {
    /// A number beyond its range.
    #[error("{of}: {key}: got {value}, must be {least} to {most}")]
    Range {
        /// Part that holds the number.
        of: &'static str,
        /// Key of the number.
        key: &'static str,
        /// Number as given.
        value: f64,
        /// Least that is allowed.
        least: f64,
        /// Most that is allowed.
        most: f64,
    },
    /// An infinite number, or none.
    #[error("{of}: {key}: row {row} holds no finite number")]
    NotFinite {
        /// Part that holds the number.
        of: &'static str,
        /// Key of the number.
        key: &'static str,
        /// Row, from 1; 0 for a number outside any table.
        row: usize,
    },
    /// A row not above the one before.
    #[error("{of}: {key}: row {row} is not above the one before")]
    Unsorted {
        /// Part that holds the table.
        of: &'static str,
        /// Key of the column.
        key: &'static str,
        /// Row, from 1.
        row: usize,
    },
    /// No rows, or too few.
    #[error("{of}: {key}: {rows} rows, needs at least {least}")]
    TooFew {
        /// Part that holds the table.
        of: &'static str,
        /// Key of the column.
        key: &'static str,
        /// Number of rows.
        rows: usize,
        /// Least number of rows.
        least: usize,
    },
    /// Rows that do not fill a regular table.
    #[error("{of}: {key}: not every combination of the other columns is there once")]
    Irregular {
        /// Part that holds the table.
        of: &'static str,
        /// Key of the column.
        key: &'static str,
    },
}

/// Refuses numbers of a row, each with its key and least value, that are not finite or below it.
pub(crate) fn check_row(
    of: &'static str,
    row: usize,
    numbers: &[(&'static str, f64, f64)],
) -> Result<(), Fault> {
    for &(key, value, least) in numbers {
        if !value.is_finite() {
            return Err(Fault::NotFinite { of, key, row });
        }
        if value < least {
            return Err(Fault::Range {
                of,
                key,
                value,
                least,
                most: f64::MAX,
            });
        }
    }
    Ok(())
}

/// Refuses rows of an abscissa and a value: empty, not ascending, not finite, values below `least`.
pub(crate) fn column(
    of: &'static str,
    key: &'static str,
    rows: &[[f64; 2]],
    least: f64,
) -> Result<(), Fault> {
    if rows.is_empty() {
        return Err(Fault::TooFew {
            of,
            key,
            rows: 0,
            least: 1,
        });
    }
    let mut before = f64::NEG_INFINITY;
    for (&[x, y], row) in rows.iter().zip(1..) {
        check_row(of, row, &[(key, x, f64::MIN), (key, y, least)])?;
        if x <= before {
            return Err(Fault::Unsorted { of, key, row });
        }
        before = x;
    }
    Ok(())
}
