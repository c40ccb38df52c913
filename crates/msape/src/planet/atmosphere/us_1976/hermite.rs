//! Equally spaced cubic Hermite interpolation along one span of altitude.
//!
//! ```text
//! y = c₀ + t (c₁ + t (c₂ + t c₃)),   t = z − z₀,
//! c₀ = y₀, c₁ = y₀′, c₂ = (3 s − 2 y₀′ − y₁′)/w, c₃ = (y₀′ + y₁′ − 2 s)/w²,   s = (y₁ − y₀)/w
//! ```
//!
//! with z in m, w the width of a cell in m and y in any unit. The first and the last cubic go on beyond the ends.
//!
//! # Valid
//! Any span of at least one cell.
//!
//! # References
//! - \[dlmf\] section 3.3(i).

use numerics::scalar::Scalar;

/// A value and its slope.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Knot {
    /// Value in the unit of the curve.
    pub value: f64,
    /// Slope, that unit per m.
    pub slope_per_m: f64,
}

/// A curve through equally spaced knots with their slopes.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    first_m: f64,
    cells_per_m: f64,
    rows: Vec<[f64; 5]>,
}

impl Curve {
    /// The curve that begins at `first_m` and has a knot every `cell_m`.
    pub fn new(first_m: f64, cell_m: f64, knots: &[Knot]) -> Self {
        let rows = knots.windows(2).enumerate().filter_map(|(i, pair)| {
            let [a, b] = pair else { return None };
            let s = (b.value - a.value) / cell_m;
            let c_2 = (3.0 * s - 2.0 * a.slope_per_m - b.slope_per_m) / cell_m;
            let c_3 = (a.slope_per_m + b.slope_per_m - 2.0 * s) / (cell_m * cell_m);
            Some([
                first_m + i as f64 * cell_m,
                a.value,
                a.slope_per_m,
                c_2,
                c_3,
            ])
        });
        Self {
            first_m,
            cells_per_m: 1.0 / cell_m,
            rows: rows.collect(),
        }
    }

    /// The line through one knot.
    pub fn line(through_m: f64, knot: Knot) -> Self {
        let rows = vec![[through_m, knot.value, knot.slope_per_m, 0.0, 0.0]];
        Self {
            first_m: through_m,
            cells_per_m: 0.0,
            rows,
        }
    }

    /// The value at `z_m`.
    #[inline]
    pub fn at<S: Scalar>(&self, z_m: S) -> S {
        let [z_0, c_0, c_1, c_2, c_3] = z_m.lookup(|z| {
            let cell = ((z - self.first_m) * self.cells_per_m) as usize;
            self.rows
                .get(cell)
                .or(self.rows.last())
                .copied()
                .unwrap_or_default()
        });
        let t = z_m - z_0;
        c_0 + t * (c_1 + t * (c_2 + t * c_3))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cubic_is_met_exactly_within_and_beyond_the_ends() {
        // y = z³ − 2 z: y(1.25) = 1.953125 − 2.5, y(−1) = 1, y(4) = 56
        let knot = |z: f64| Knot {
            value: z * z * z - 2.0 * z,
            slope_per_m: 3.0 * z * z - 2.0,
        };
        let curve = Curve::new(0.0, 0.5, &[0.0, 0.5, 1.0, 1.5, 2.0].map(knot));
        for (z, y) in [(1.25, -0.546875), (-1.0, 1.0), (4.0, 56.0)] {
            assert!((curve.at(z) - y).abs() < 1e-12, "{z}: {}", curve.at(z));
        }
    }
}
