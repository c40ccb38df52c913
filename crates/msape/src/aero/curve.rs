//! Coefficients over the angle of attack on an even grid, smooth enough for integrators of high order.
//!
//! ```text
//! f(α) = h₀₀ fᵢ + h₁₀ Δ fᵢ' + h₀₁ fᵢ₊₁ + h₁₁ Δ fᵢ₊₁'        fᵢ' = (fᵢ₊₁ − fᵢ₋₁)/(2Δ)
//! ```
//!
//! with α in rad, Δ the step in rad, h the cubic Hermite polynomials. At 0 and π the axial force is even and normal force and moment are
//! odd, so that slopes there follow from symmetry.
//!
//! # Valid
//! Bodies of revolution, 0…π.
//!
//! # References
//! - Cubic Hermite interpolation.

use super::integral::Loads;
use numerics::math::PI;
use serde::{Deserialize, Serialize};

/// Steps from 0 to 180 deg: 2.5 deg each.
pub const STEPS: usize = 72;

/// Coefficients from 0 to π rad.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Curve {
    /// Value and slope times step at each angle.
    nodes: Vec<[Loads; 2]>,
}

/// Position of an angle on the grid.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    index: usize,
    weights: [f64; 4],
}

impl Place {
    /// The place of an angle of 0…π rad.
    #[inline]
    pub fn new(alpha_rad: f64) -> Place {
        let t = (alpha_rad * (STEPS as f64 / PI)).clamp(0.0, STEPS as f64);
        let index = (t as usize).min(STEPS - 1);
        let u = t - index as f64;
        let v = 1.0 - u;
        Place {
            index,
            weights: [
                v * v * (1.0 + 2.0 * u),
                u * v * v,
                u * u * (1.0 + 2.0 * v),
                -u * u * v,
            ],
        }
    }
}

impl Curve {
    /// The angle of a node, rad.
    pub fn angle_rad(node: usize) -> f64 {
        if node >= STEPS {
            PI
        } else {
            PI * (node as f64 / STEPS as f64)
        }
    }

    /// A curve through the values at 0, 2.5, … 180 deg; missing ones are zero.
    pub fn new(values: &[Loads]) -> Curve {
        let value = |n: usize| values.get(n).copied().unwrap_or_default();
        // Beyond the ends: even axial force, odd normal force and moment.
        let mirrored = |n: usize| {
            let Loads { ca, cn, cm } = value(n);
            Loads {
                ca,
                cn: -cn,
                cm: -cm,
            }
        };
        let nodes = (0..=STEPS)
            .map(|n| {
                let after = if n == STEPS {
                    mirrored(STEPS - 1)
                } else {
                    value(n + 1)
                };
                let before = if n == 0 { mirrored(1) } else { value(n - 1) };
                [value(n), after.mixed(0.5, &before, -0.5)]
            })
            .collect();
        Curve { nodes }
    }

    /// Coefficients at a place.
    #[inline]
    pub fn at(&self, place: &Place) -> Loads {
        let [a, b, c, d] = place.weights;
        match self.nodes.get(place.index..place.index + 2) {
            Some(&[[f0, g0], [f1, g1]]) => Loads {
                ca: a * f0.ca + b * g0.ca + c * f1.ca + d * g1.ca,
                cn: a * f0.cn + b * g0.cn + c * f1.cn + d * g1.cn,
                cm: a * f0.cm + b * g0.cm + c * f1.cm + d * g1.cm,
            },
            _ => Loads::default(),
        }
    }

    /// Coefficients nose first.
    pub fn first(&self) -> Loads {
        self.nodes.first().map(|[f, _]| *f).unwrap_or_default()
    }

    /// Slopes nose first, by the angle, per rad.
    pub fn first_slope(&self) -> Loads {
        let [_, slope] = self.nodes.first().copied().unwrap_or_default();
        slope.mixed(STEPS as f64 / PI, &Loads::default(), 0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use numerics::math::{cos, sin};

    #[test]
    fn sine_and_cosine_to_the_fourth_power_of_the_step() {
        let values: Vec<Loads> = (0..=STEPS)
            .map(|n| {
                let a = Curve::angle_rad(n);
                Loads {
                    ca: cos(a),
                    cn: sin(a),
                    cm: -sin(2.0 * a),
                }
            })
            .collect();
        let curve = Curve::new(&values);
        // slopes are good to Δ²/6 of the third derivative, which u v (v − u) Δ takes to 0.1·Δ³/6: 1.4e-6, ×8 for 2α
        for n in 0..1000 {
            let a = PI * f64::from(n) / 999.0;
            let got = curve.at(&Place::new(a));
            assert!((got.ca - cos(a)).abs() < 2e-6, "{a}");
            assert!((got.cn - sin(a)).abs() < 2e-6, "{a}");
            assert!((got.cm + sin(2.0 * a)).abs() < 1.2e-5, "{a}");
        }
        assert!((curve.first_slope().cn - 1.0).abs() < 4e-4);
    }
}
