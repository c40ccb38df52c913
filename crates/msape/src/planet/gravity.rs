//! Gravity of an oblate planet by zonal harmonics, or of constant magnitude.
//!
//! ```text
//! U = μ/r (1 − Σ Jₙ (R/r)ⁿ Pₙ(s)),   s = z/r,   n = 2, 3, 4
//! g = ∇U = −μ/r² { r̂ [1 − Σ Jₙ (R/r)ⁿ P′ₙ₊₁(s)] + ẑ Σ Jₙ (R/r)ⁿ P′ₙ(s) }
//! ```
//!
//! with g in m/s², μ in m³/s², r and the reference radius R of the harmonics in m, z along the pole. R belongs to the
//! Jₙ and is not always the equatorial radius.
//!
//! # Valid
//! Outside the planet. The centrifugal acceleration is not part of it.
//!
//! # References
//! - \[vallado-2013\] section 8.7.1 (the derivative follows from the recurrences of the Legendre polynomials).

use numerics::scalar::Scalar;
use serde::{Deserialize, Serialize};

/// A model of gravity.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "form", rename_all = "kebab-case", deny_unknown_fields)]
pub enum Gravity {
    /// Zonal harmonics; those that are not given are zero.
    Zonal {
        /// Gravitational parameter, m³/s².
        mu_m3_s2: f64,
        /// Second zonal harmonic.
        #[serde(default)]
        j2: f64,
        /// Third zonal harmonic.
        #[serde(default)]
        j3: f64,
        /// Fourth zonal harmonic.
        #[serde(default)]
        j4: f64,
        /// Radius to which the harmonics refer, m.
        reference_radius_m: f64,
    },
    /// Constant magnitude, toward the center.
    Uniform {
        /// Acceleration, m/s².
        acceleration_m_s2: f64,
    },
}

impl Gravity {
    /// Acceleration at planet-fixed coordinates, m, in m/s².
    #[inline]
    pub fn acceleration_m_s2<S: Scalar>(&self, r: [S; 3]) -> [S; 3] {
        let [x, y, z] = r;
        let r2 = x * x + y * y + z * z;
        let inverse = S::constant(1.0) / r2.sqrt();
        match *self {
            Self::Zonal {
                mu_m3_s2: mu,
                j2,
                j3,
                j4,
                reference_radius_m,
            } => {
                let q = inverse * reference_radius_m;
                let q2 = q * q;
                let s = z * inverse;
                let s2 = s * s;
                let [k2, k3, k4] = [q2 * j2, q2 * q * j3, q2 * q2 * j4];
                // P′₃, P′₄, P′₅
                let radial = k2 * (s2 * 7.5 - 1.5)
                    + k3 * s * (s2 * 17.5 - 7.5)
                    + k4 * (s2 * (s2 * 39.375 - 26.25) + 1.875);
                // P′₂, P′₃, P′₄
                let polar = k2 * s * 3.0 + k3 * (s2 * 7.5 - 1.5) + k4 * s * (s2 * 17.5 - 7.5);
                let g = inverse * inverse * -mu;
                let along = g * inverse * (S::constant(1.0) - radial);
                [x * along, y * along, z * along + g * polar]
            }
            Self::Uniform { acceleration_m_s2 } => {
                let along = inverse * -acceleration_m_s2;
                [x * along, y * along, z * along]
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const EARTH: Gravity = Gravity::Zonal {
        mu_m3_s2: 3.986004418e14,
        j2: 1.08263e-3,
        j3: -2.53e-6,
        j4: -1.62e-6,
        reference_radius_m: 6_378_137.0,
    };

    #[test]
    fn at_the_equator_j2_adds_one_and_a_half_j2() {
        // μ/R² (1 + 3/2 J₂) = 9.7982855 × 1.001623945 = 9.8141974
        let gravity = Gravity::Zonal {
            mu_m3_s2: 3.986004418e14,
            j2: 1.08263e-3,
            j3: 0.0,
            j4: 0.0,
            reference_radius_m: 6_378_137.0,
        };
        let [x, y, z] = gravity.acceleration_m_s2([6_378_137.0, 0.0, 0.0]);
        assert!((x + 9.8141974).abs() < 2e-7, "{x}");
        assert_eq!((y, z), (0.0, 0.0));
        // over the pole at the same distance: 1 − 3 J₂
        let [_, _, z] = gravity.acceleration_m_s2([0.0, 0.0, 6_378_137.0]);
        assert!(
            (z + 9.7982855 * (1.0 - 3.0 * 1.08263e-3)).abs() < 2e-7,
            "{z}"
        );
    }

    #[test]
    fn the_harmonics_refer_to_their_own_radius() {
        // Equator, r = 2 R: μ/(4 R²) (1 + 3/2 J₂/4)
        let gravity = Gravity::Zonal {
            mu_m3_s2: 4e14,
            j2: 1e-3,
            j3: 0.0,
            j4: 0.0,
            reference_radius_m: 5e6,
        };
        let [x, _, _] = gravity.acceleration_m_s2([1e7, 0.0, 0.0]);
        assert!((x + 4.0 * 1.000375).abs() < 1e-14);
    }

    #[test]
    fn acceleration_is_the_gradient_of_the_potential() {
        let Gravity::Zonal {
            mu_m3_s2: mu,
            j2,
            j3,
            j4,
            reference_radius_m,
        } = EARTH
        else {
            panic!("zonal")
        };
        // Harmonics a thousand times too large, so that an error in any of them shows.
        let strong = Gravity::Zonal {
            mu_m3_s2: mu,
            j2,
            j3: j3 * 1e3,
            j4: j4 * 1e3,
            reference_radius_m,
        };
        let potential = |r: [f64; 3]| {
            let d = (r[0] * r[0] + r[1] * r[1] + r[2] * r[2]).sqrt();
            let (s, q) = (r[2] / d, reference_radius_m / d);
            let p2 = (3.0 * s * s - 1.0) / 2.0;
            let p3 = (5.0 * s * s * s - 3.0 * s) / 2.0;
            let p4 = (35.0 * s * s * s * s - 30.0 * s * s + 3.0) / 8.0;
            mu / d
                * (1.0
                    - j2 * q * q * p2
                    - 1e3 * j3 * q * q * q * p3
                    - 1e3 * j4 * q * q * q * q * p4)
        };
        for r in [[4e6, 3e6, 4.5e6], [-1e6, 6e6, -3e6], [1e5, -2e5, 6.6e6]] {
            let g = strong.acceleration_m_s2(r);
            for axis in 0..3 {
                let (mut high, mut low) = (r, r);
                high[axis] += 100.0;
                low[axis] -= 100.0;
                let slope = (potential(high) - potential(low)) / 200.0;
                // Central difference: (100/r)² × g ≈ 2e-9, rounding of U 6e7 × 1e-16 / 200 ≈ 4e-11 each side
                assert!(
                    (slope - g[axis]).abs() < 2e-8,
                    "{r:?} {axis}: {slope} {}",
                    g[axis]
                );
            }
        }
    }

    #[test]
    fn uniform_gravity_points_to_the_center() {
        let gravity = Gravity::Uniform {
            acceleration_m_s2: 9.81,
        };
        // 3-4-12-13
        let g = gravity.acceleration_m_s2([3e6, 4e6, 12e6]);
        for (ours, expected) in
            g.iter()
                .zip([-9.81 * 3.0 / 13.0, -9.81 * 4.0 / 13.0, -9.81 * 12.0 / 13.0])
        {
            assert!((ours - expected).abs() < 1e-14);
        }
    }
}
