//! Equally spaced cubic Hermite interpolation along one span of altitude.
//!
//! ```text
//! y = c₀ + t (c₁ + t (c₂ + t c₃)),   t = z − z₀,
//! c₀ = y₀, c₁ = y₀′, c₂ = (3 s − 2 y₀′ − y₁′)/w, c₃ = (y₀′ + y₁′ − 2 s)/w²,   s = (y₁ − y₀)/w
//! ```
//!
//! with z in m, w the width of a cell in m and y in any unit. The relative error for an exponential of scale height H
//! is (w/H)⁴/384.
//!
//! # Valid
//! Any span of at least one cell; the caller decides the values beyond its ends.
//!
//! # References
//! - \[dlmf\] section 3.3(i).

use numerics::scalar::Scalar;
use us1976::Knot;

/// z₀, c₀, c₁, c₂, c₃ of one cell.
pub type Cubic = [f64; 5];

/// A curve through equally spaced knots with their slopes.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    first_m: f64,
    cells_per_m: f64,
    cells: Vec<Cubic>,
}

/// Value of a cubic at an altitude, m.
#[inline]
pub fn value<S: Scalar>(altitude_m: S, cubic: [S; 5]) -> S {
    let [z_0, c_0, c_1, c_2, c_3] = cubic;
    let t = altitude_m - z_0;
    c_0 + t * (c_1 + t * (c_2 + t * c_3))
}

/// The line through one knot.
pub fn line(through_m: f64, knot: Knot) -> Cubic {
    [through_m, knot.value, knot.slope_per_m, 0.0, 0.0]
}

impl Curve {
    /// The curve that begins at `first_m` and has a knot every `cell_m`.
    pub fn new(first_m: f64, cell_m: f64, knots: &[Knot]) -> Self {
        let cells = knots.windows(2).enumerate().filter_map(|(i, pair)| {
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
            cells: cells.collect(),
        }
    }

    /// The cubics of the cells, upward.
    pub fn into_cells(self) -> Vec<Cubic> {
        self.cells
    }

    /// The cubic that holds at an altitude, m; nothing beyond the ends.
    #[inline]
    pub fn cubic(&self, altitude_m: f64) -> Option<Cubic> {
        let cell = (altitude_m - self.first_m) * self.cells_per_m;
        // A negative number as an index would be the first cell.
        if cell >= 0.0 {
            self.cells.get(cell as usize).copied()
        } else {
            None
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cubic_is_met_exactly_and_nothing_is_said_beyond_the_ends() {
        // y = z³ − 2 z: y(1.25) = 1.953125 − 2.5
        let knot = |z: f64| Knot {
            value: z * z * z - 2.0 * z,
            slope_per_m: 3.0 * z * z - 2.0,
        };
        let curve = Curve::new(0.0, 0.5, &[0.0, 0.5, 1.0, 1.5, 2.0].map(knot));
        let y = value(1.25, curve.cubic(1.25).unwrap());
        assert!((y + 0.546875).abs() < 1e-14, "{y}");
        assert_eq!(
            (curve.cubic(-0.1), curve.cubic(2.1), curve.cubic(f64::NAN)),
            (None, None, None)
        );
        assert_eq!(
            value(
                3.0,
                line(
                    1.0,
                    Knot {
                        value: 5.0,
                        slope_per_m: 2.0
                    }
                )
            ),
            9.0
        );
    }
}
