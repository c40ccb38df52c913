//! Exponent of the nose radius in radiative heating: shrinks as the layer behind the shock absorbs itself.
//!
//! ```text
//! a = min(cap(Rₙ), a₀ V^m ρ^n)
//! ```
//!
//! with a₀, m, n from the data, V in m/s, ρ in kg/m³, Rₙ in m. The caps are steps in Rₙ, as printed.
//!
//! # Valid
//! Range of the correlation that uses it.
//!
//! # References
//! - \[tauber-sutton-1991\]; \[brandis-johnston-2014\].

use numerics::scalar::Scalar;
use serde::Deserialize;

/// Coefficients of the exponent.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct NoseExponent {
    /// Factor a₀.
    pub coefficient: f64,
    /// Exponent of speed, m.
    pub speed_exponent: f64,
    /// Exponent of density, n.
    pub density_exponent: f64,
    /// Caps, tried in order.
    pub caps: Vec<Cap>,
}

/// The largest exponent of a class of noses.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Cap {
    /// The largest exponent.
    pub cap: f64,
    /// Nose radius below which it holds, m.
    pub below_m: Option<f64>,
    /// Nose radius up to which it holds, m.
    pub up_to_m: Option<f64>,
}

impl NoseExponent {
    /// The largest exponent for a nose radius in m.
    pub fn cap(&self, nose_radius_m: f64) -> f64 {
        self.caps
            .iter()
            .find(|row| {
                row.below_m.is_none_or(|limit| nose_radius_m < limit)
                    && row.up_to_m.is_none_or(|limit| nose_radius_m <= limit)
            })
            .map_or(f64::INFINITY, |row| row.cap)
    }

    /// The exponent, from the logarithms of speed in m/s and density in kg/m³, for a nose radius in m.
    #[inline]
    pub fn value<S: Scalar>(&self, ln_v: S, ln_rho: S, nose_radius_m: S) -> S {
        // a = a₀ V^m ρ^n
        let a =
            (ln_v * self.speed_exponent + ln_rho * self.density_exponent).exp() * self.coefficient;
        let [cap] = nose_radius_m.lookup(|radius_m| [self.cap(radius_m)]);
        a.min(cap)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use numerics::math;

    fn stepped() -> NoseExponent {
        let cap = |cap, below_m, up_to_m| Cap {
            cap,
            below_m,
            up_to_m,
        };
        let caps = vec![
            cap(1.0, Some(1.0), None),
            cap(0.6, None, Some(2.0)),
            cap(0.5, None, None),
        ];
        NoseExponent {
            coefficient: 12.0,
            speed_exponent: -1.0,
            density_exponent: 0.0,
            caps,
        }
    }

    #[test]
    fn caps_step_at_one_and_two_meters() {
        let radii = [0.999, 1.0, 2.0, 2.001, 50.0];
        assert_eq!(radii.map(|r| stepped().cap(r)), [1.0, 0.6, 0.6, 0.5, 0.5]);
    }

    #[test]
    fn twelve_over_v_is_capped_below_twelve() {
        assert!((stepped().value(math::ln(24.0), 0.0, 0.3) - 0.5).abs() < 1e-15);
        assert_eq!(stepped().value(math::ln(6.0), 0.0, 0.3), 1.0);
    }
}
