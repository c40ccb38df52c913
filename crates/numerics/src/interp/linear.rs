//! Linear interpolation.
//!
//! ```text
//! y = yᵢ + (x - xᵢ) (yᵢ₊₁ - yᵢ) / (xᵢ₊₁ - xᵢ)
//! ```

use super::rows::{Rows, Search};
use super::{End, TableError, check, range, within};
use crate::scalar::Scalar;

/// Table of y against x, linear between its rows; exact at each row.
#[derive(Clone, Debug, PartialEq)]
pub struct Table1 {
    ends: [f64; 2],
    range: [f64; 2],
    /// xᵢ, yᵢ, slope.
    rows: Rows<3>,
}

impl Table1 {
    /// The table through the points (`x`, `y`), `x` ascending.
    ///
    /// # Errors
    /// Names the first row that is not finite or not ascending, columns that differ in length, or a single row.
    pub fn try_new(x: &[f64], y: &[f64], end: End) -> Result<Self, TableError> {
        check(x, &[y])?;
        let points = || x.iter().copied().zip(y.iter().copied());
        let mut rows: Vec<[f64; 3]> = points()
            .zip(points().skip(1))
            .map(|((x, y), (x1, y1))| [x, y, (y1 - y) / (x1 - x)])
            .collect();
        let before = rows.first().copied().unwrap_or_default();
        let last_slope = rows.last().map_or(0.0, |row| row[2]);
        // The last row's line passes through the last point itself.
        rows.extend(points().next_back().map(|(x, y)| [x, y, last_slope]));
        let ends = range(x, End::Hold);
        Ok(Self {
            ends,
            range: range(x, end),
            rows: Rows::new(Search::Binary(x.to_vec()), before, rows),
        })
    }

    /// First and last abscissa.
    pub fn ends(&self) -> [f64; 2] {
        self.ends
    }

    /// Value at `x`.
    #[inline]
    pub fn at<S: Scalar>(&self, x: S) -> S {
        let x = within(x, self.range);
        let [x_i, y_i, slope] = x.lookup(|x| self.rows.row(x));
        y_i + (x - x_i) * slope
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const X: [f64; 3] = [0.0, 1.0, 3.0];
    const Y: [f64; 3] = [2.0, 4.0, 3.0];

    #[test]
    fn halfway_is_the_mean_and_rows_are_exact() {
        let table = Table1::try_new(&X, &Y, End::Hold).unwrap();
        assert_eq!(table.at(0.5), 3.0);
        assert_eq!(table.at(2.0), 3.5);
        assert_eq!(X.map(|x| table.at(x)), Y);
    }

    #[test]
    fn ends_hold_even_at_infinity() {
        let table = Table1::try_new(&X, &Y, End::Hold).unwrap();
        assert_eq!([-5.0, f64::NEG_INFINITY].map(|x| table.at(x)), [2.0, 2.0]);
        assert_eq!([5.0, f64::INFINITY].map(|x| table.at(x)), [3.0, 3.0]);
    }

    #[test]
    fn ends_extrapolate_with_the_last_slope() {
        let table = Table1::try_new(&X, &Y, End::Extrapolate).unwrap();
        // 2 - 1·2 = 0; 3 - 2·½ = 2
        assert_eq!([-1.0, 5.0].map(|x| table.at(x)), [0.0, 2.0]);
    }

    #[test]
    fn not_a_number_is_not_hidden() {
        for end in [End::Hold, End::Extrapolate] {
            assert!(Table1::try_new(&X, &Y, end).unwrap().at(f64::NAN).is_nan());
        }
    }
}
