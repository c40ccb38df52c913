//! Tables of one variable: linear, linear in the logarithm, and cubic with given slopes.
//!
//! A table is built once, with `try_new`, which refuses invalid columns; look-ups then cannot fail. The rows are chosen
//! by value and evaluated in any [`Scalar`], so that derivatives are carried through.
//!
//! ```
//! use numerics::interp::{End, Table1};
//!
//! let drag = Table1::try_new(&[0.8, 1.0, 3.0], &[0.7, 1.0, 1.4], End::Hold)?;
//! assert_eq!(drag.at(2.0), 1.2);
//! assert_eq!(drag.at(30.0), 1.4);
//! # Ok::<(), numerics::interp::TableError>(())
//! ```

mod hermite;
mod linear;
mod log_linear;
mod rows;

use crate::scalar::Scalar;
pub use hermite::HermiteTable;
pub use linear::Table1;
pub use log_linear::LogTable1;

/// Rule beyond the ends of a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// The last value.
    Hold,
    /// The straight line with the last slope.
    Extrapolate,
}

/// Reason why columns of numbers are not a table.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum TableError {
    /// Fewer than two rows.
    #[error("{count} rows: a table needs at least two")]
    TooFew {
        /// Number of rows.
        count: usize,
    },
    /// Columns of different lengths.
    #[error("{abscissae} abscissae, but {values} values")]
    Lengths {
        /// Number of abscissae.
        abscissae: usize,
        /// Number of values, or of slopes.
        values: usize,
    },
    /// An infinite number, or none.
    #[error("row {index}: {value} is not a finite number")]
    NotFinite {
        /// Row, from 0.
        index: usize,
        /// Value in the row.
        value: f64,
    },
    /// An abscissa not above the one before.
    #[error("row {index}: abscissa {value} is not above the one before, {before}")]
    Unsorted {
        /// Row, from 0.
        index: usize,
        /// Abscissa of the row.
        value: f64,
        /// Abscissa of the row before.
        before: f64,
    },
    /// A value without a logarithm.
    #[error("row {index}: value {value} is not above zero")]
    NotPositive {
        /// Row, from 0.
        index: usize,
        /// Value in the row.
        value: f64,
    },
}

/// Refuses columns that are not a table.
fn check(x: &[f64], columns: &[&[f64]]) -> Result<(), TableError> {
    for column in columns {
        if column.len() != x.len() {
            return Err(TableError::Lengths {
                abscissae: x.len(),
                values: column.len(),
            });
        }
    }
    if x.len() < 2 {
        return Err(TableError::TooFew { count: x.len() });
    }
    for column in core::iter::once(&x).chain(columns) {
        if let Some((index, &value)) = column
            .iter()
            .enumerate()
            .find(|(_, value)| !value.is_finite())
        {
            return Err(TableError::NotFinite { index, value });
        }
    }
    for (n, (&before, &value)) in x.iter().zip(x.iter().skip(1)).enumerate() {
        if value <= before {
            return Err(TableError::Unsorted {
                index: n + 1,
                value,
                before,
            });
        }
    }
    Ok(())
}

/// `x` kept within `range`; not a number stays so.
#[inline]
fn within<S: Scalar>(x: S, [low, high]: [f64; 2]) -> S {
    S::constant(high).min(x.max(S::constant(low)))
}

/// The range of abscissae for which the table answers: beyond it the end holds.
fn range(x: &[f64], end: End) -> [f64; 2] {
    match (end, x) {
        (End::Hold, [first, .., last]) => [*first, *last],
        _ => [f64::NEG_INFINITY, f64::INFINITY],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faults_name_row_and_value() {
        assert_eq!(
            check(&[0.0], &[&[1.0]]),
            Err(TableError::TooFew { count: 1 })
        );
        assert_eq!(
            check(&[0.0, 1.0], &[&[1.0]]),
            Err(TableError::Lengths {
                abscissae: 2,
                values: 1
            })
        );
        assert_eq!(
            check(&[0.0, 1.0], &[&[1.0, f64::INFINITY]]),
            Err(TableError::NotFinite {
                index: 1,
                value: f64::INFINITY
            })
        );
        assert_eq!(
            check(&[0.0, 2.0, 2.0], &[&[1.0, 1.0, 1.0]]),
            Err(TableError::Unsorted {
                index: 2,
                value: 2.0,
                before: 2.0
            })
        );
        assert_eq!(check(&[0.0, 1.0], &[&[1.0, 1.0]]), Ok(()));
    }

    #[test]
    fn message_reads_as_a_sentence() {
        let fault = TableError::Unsorted {
            index: 2,
            value: 1.0,
            before: 3.5,
        };
        assert_eq!(
            fault.to_string(),
            "row 2: abscissa 1 is not above the one before, 3.5"
        );
    }
}
