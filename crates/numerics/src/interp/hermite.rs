//! Cubic interpolation with given slopes.
//!
//! ```text
//! y = yᵢ + d (mᵢ + d (c₂ + d c₃))         d = x - xᵢ    Δ = xᵢ₊₁ - xᵢ    s = (yᵢ₊₁ - yᵢ) / Δ
//! c₂ = (3 s - 2 mᵢ - mᵢ₊₁) / Δ            c₃ = (mᵢ + mᵢ₊₁ - 2 s) / Δ²
//! ```

use super::rows::{Rows, Search};
use super::{End, TableError, check, range, within};
use crate::scalar::Scalar;

/// Table of y and its slope against x; value and slope are continuous.
#[derive(Clone, Debug, PartialEq)]
pub struct HermiteTable {
    range: [f64; 2],
    /// xᵢ, yᵢ, mᵢ, c₂, c₃.
    rows: Rows<5>,
}

impl HermiteTable {
    /// The table through the points (`x`, `y`) with the slopes `slope`, `x` ascending.
    ///
    /// # Errors
    /// Errors of [`super::Table1::try_new`].
    pub fn try_new(x: &[f64], y: &[f64], slope: &[f64], end: End) -> Result<Self, TableError> {
        check(x, &[y, slope])?;
        Ok(Self::from_knots(
            Search::Binary(x.to_vec()),
            x,
            y,
            slope,
            end,
        ))
    }

    /// The table with evenly spaced knots from the first to the last of `span`, which are found without a search.
    ///
    /// # Errors
    /// Errors of [`super::Table1::try_new`].
    pub fn try_uniform(
        span: [f64; 2],
        y: &[f64],
        slope: &[f64],
        end: End,
    ) -> Result<Self, TableError> {
        let intervals = y.len().saturating_sub(1) as f64;
        let [first, last] = span;
        let length = last - first;
        let x: Vec<f64> = (0..y.len())
            .map(|i| first + length * (i as f64 / intervals))
            .collect();
        check(&x, &[y, slope])?;
        let search = Search::Uniform {
            first,
            per_knot: intervals / length,
        };
        Ok(Self::from_knots(search, &x, y, slope, end))
    }

    fn from_knots(search: Search, x: &[f64], y: &[f64], slope: &[f64], end: End) -> Self {
        let points = || x.iter().zip(y).zip(slope).map(|((x, y), m)| [*x, *y, *m]);
        let line = |[x, y, m]: [f64; 3]| [x, y, m, 0.0, 0.0];
        let mut rows: Vec<[f64; 5]> = points().zip(points().skip(1)).map(cubic).collect();
        rows.extend(points().next_back().map(line));
        let before = points().next().map(line).unwrap_or_default();
        Self {
            range: range(x, end),
            rows: Rows::new(search, before, rows),
        }
    }

    /// Value at `x`.
    #[inline]
    pub fn at<S: Scalar>(&self, x: S) -> S {
        let x = within(x, self.range);
        let [x_i, y_i, m_i, c2, c3] = x.lookup(|x| self.rows.row(x));
        let d = x - x_i;
        y_i + d * (m_i + d * (c2 + d * c3))
    }
}

/// Row of the cubic between two points with slopes.
fn cubic(([x, y, m], [x1, y1, m1]): ([f64; 3], [f64; 3])) -> [f64; 5] {
    let delta = x1 - x;
    let s = (y1 - y) / delta;
    [
        x,
        y,
        m,
        (3.0 * s - 2.0 * m - m1) / delta,
        (m + m1 - 2.0 * s) / (delta * delta),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// y = x³ at 0, 1, 2 with slopes 3 x².
    const Y: [f64; 3] = [0.0, 1.0, 8.0];
    const SLOPE: [f64; 3] = [0.0, 3.0, 12.0];

    #[test]
    fn cube_is_reproduced_by_both_searches() {
        let uneven = HermiteTable::try_new(&[0.0, 1.0, 2.0], &Y, &SLOPE, End::Hold).unwrap();
        let even = HermiteTable::try_uniform([0.0, 2.0], &Y, &SLOPE, End::Hold).unwrap();
        for table in [uneven, even] {
            assert_eq!(
                [0.0, 0.5, 1.0, 1.5, 2.0].map(|x| table.at(x)),
                [0.0, 0.125, 1.0, 3.375, 8.0]
            );
            assert_eq!([-1.0, 9.0].map(|x| table.at(x)), [0.0, 8.0]);
        }
    }

    #[test]
    fn end_is_extrapolated_by_a_line() {
        let table = HermiteTable::try_uniform([0.0, 2.0], &Y, &SLOPE, End::Extrapolate).unwrap();
        // 8 + 12·1
        assert_eq!(table.at(3.0), 20.0);
        assert_eq!(table.at(-3.0), 0.0);
    }

    #[test]
    fn span_without_length_is_refused() {
        let refused = HermiteTable::try_uniform([1.0, 1.0], &Y, &SLOPE, End::Hold).unwrap_err();
        assert_eq!(
            refused,
            TableError::Unsorted {
                index: 1,
                value: 1.0,
                before: 1.0
            }
        );
        assert_eq!(
            HermiteTable::try_uniform([0.0, 1.0], &[1.0], &[1.0], End::Hold).unwrap_err(),
            TableError::TooFew { count: 1 }
        );
    }
}
