//! Linear interpolation of the logarithm, for quantities that fall exponentially.
//!
//! ```text
//! ln y = ln yᵢ + (x - xᵢ) (ln yᵢ₊₁ - ln yᵢ) / (xᵢ₊₁ - xᵢ)
//! ```

use super::{End, Table1, TableError};
use crate::math;
use crate::scalar::Scalar;

/// Table of y > 0 against x, linear in ln y between its rows.
#[derive(Clone, Debug, PartialEq)]
pub struct LogTable1 {
    logarithm: Table1,
}

impl LogTable1 {
    /// The table through the points (`x`, `y`), `x` ascending, `y` above zero.
    ///
    /// # Errors
    /// Errors of [`Table1::try_new`], and the first value that is not above zero.
    pub fn try_new(x: &[f64], y: &[f64], end: End) -> Result<Self, TableError> {
        if let Some((index, &value)) = y.iter().enumerate().find(|(_, y)| **y <= 0.0) {
            return Err(TableError::NotPositive { index, value });
        }
        let logarithms: Vec<f64> = y.iter().map(|y| math::ln(*y)).collect();
        match Table1::try_new(x, &logarithms, end) {
            Ok(logarithm) => Ok(Self { logarithm }),
            // The value as it was given, not its logarithm.
            Err(TableError::NotFinite { index, .. }) => {
                let given = [x.get(index), y.get(index)]
                    .into_iter()
                    .flatten()
                    .find(|value| !value.is_finite());
                Err(TableError::NotFinite {
                    index,
                    value: given.copied().unwrap_or(f64::NAN),
                })
            }
            Err(other) => Err(other),
        }
    }

    /// Value at `x`.
    #[inline]
    pub fn at<S: Scalar>(&self, x: S) -> S {
        self.logarithm.at(x).exp()
    }

    /// Logarithm of the value at `x`.
    #[inline]
    pub fn ln_at<S: Scalar>(&self, x: S) -> S {
        self.logarithm.at(x)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn halfway_is_the_geometric_mean() {
        let table = LogTable1::try_new(&[0.0, 2.0], &[1.0, 100.0], End::Extrapolate).unwrap();
        assert!((table.at(1.0) - 10.0).abs() < 1e-14);
        assert!((table.at(3.0) - 1000.0).abs() < 1e-11);
        assert_eq!(table.ln_at(0.0), 0.0);
    }

    #[test]
    fn held_end_keeps_the_value() {
        let table = LogTable1::try_new(&[0.0, 2.0], &[1.0, 100.0], End::Hold).unwrap();
        assert_eq!(table.at(-1.0), 1.0);
    }

    #[test]
    fn zero_and_infinite_are_refused_as_given() {
        let x = [0.0, 1.0];
        let refused = |y: [f64; 2]| LogTable1::try_new(&x, &y, End::Hold).unwrap_err();
        assert_eq!(
            refused([1.0, 0.0]),
            TableError::NotPositive {
                index: 1,
                value: 0.0
            }
        );
        assert_eq!(
            refused([f64::INFINITY, 1.0]),
            TableError::NotFinite {
                index: 0,
                value: f64::INFINITY
            }
        );
    }
}
