//! Pressure and shear without collisions between the molecules, after Schaaf and Chambre.
//!
//! ```text
//! C_p = {[(2 − σₙ) S s/√π + σₙ/2 √(T_w/T)] e^(−S²s²) + [(2 − σₙ)(S²s² + ½) + σₙ/2 √(π T_w/T) S s][1 + erf(S s)]}/S²
//! C_t = g cos δ     g = σₜ/(S √π) {e^(−S²s²) + √π S s [1 + erf(S s)]}
//! ```
//!
//! with s = sin δ, δ the angle between air and surface in rad; S = V/√(2RT) the speed ratio; σₙ and σₜ the accommodation of normal and
//! tangential momentum, 0 (specular) to 1 (diffuse); T_w/T the ratio of the wall's temperature to that of the air.
//!
//! # Valid
//! Mean free path much longer than the body; molecules that leave the wall and meet it again are not followed.
//!
//! # References
//! - \[schaaf-chambre-1961\] section 5 (pressure and shear on an element); \[bird-1994\] chapter 7 (the same, and the sphere).

use numerics::math::{PI, erf, exp};

/// Beyond |S s| of this, the exponential and 1 − |erf| are below 2e-9.
pub const REACH: f64 = 4.5;

/// The gas and the wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gas {
    /// Speed ratio; infinity is the cold limit.
    pub speed_ratio: f64,
    /// Ratio of the wall's temperature to that of the air.
    pub wall_temperature_ratio: f64,
    /// Accommodation of normal momentum.
    pub normal_accommodation: f64,
    /// Accommodation of tangential momentum.
    pub tangential_accommodation: f64,
}

impl Gas {
    /// Full accommodation on a wall as warm as the air.
    pub fn diffuse(speed_ratio: f64) -> Gas {
        Gas {
            speed_ratio,
            wall_temperature_ratio: 1.0,
            normal_accommodation: 1.0,
            tangential_accommodation: 1.0,
        }
    }

    /// C_p − g s, the load along the inward normal, and g, the load along the air.
    pub fn loads(&self, s: f64) -> [f64; 2] {
        let root_pi = PI.sqrt();
        let z = self.speed_ratio * s;
        if z <= -REACH {
            return [0.0, 0.0];
        }
        if z >= REACH {
            let [p0, p1, p2, g1] = self.far();
            return [p0 + (p1 + p2 * s) * s, g1 * s];
        }
        let Gas {
            speed_ratio,
            wall_temperature_ratio,
            normal_accommodation: n,
            tangential_accommodation: t,
        } = *self;
        let (e, f) = (exp(-z * z), 1.0 + erf(z));
        let half_wall = 0.5 * n * wall_temperature_ratio.sqrt();
        let pressure = (((2.0 - n) * z / root_pi + half_wall) * e
            + ((2.0 - n) * (z * z + 0.5) + half_wall * root_pi * z) * f)
            / (speed_ratio * speed_ratio);
        let g = t / (speed_ratio * root_pi) * (e + root_pi * z * f);
        [pressure - g * s, g]
    }

    /// Coefficients far on the windward side: p₀ + p₁ s + p₂ s² and g₁ s.
    pub fn far(&self) -> [f64; 4] {
        let (n, t) = (self.normal_accommodation, self.tangential_accommodation);
        let inverse = 1.0 / self.speed_ratio;
        [
            (2.0 - n) * inverse * inverse,
            n * (PI * self.wall_temperature_ratio).sqrt() * inverse,
            2.0 * (2.0 - n) - 2.0 * t,
            2.0 * t,
        ]
    }

    /// Width of the zone about s = 0 in which the exponential counts.
    pub fn zone(&self) -> f64 {
        REACH / self.speed_ratio
    }
}

/// Drag coefficient of a sphere in diffuse reflection, referred to its cross-section.
///
/// ```text
/// C_D = (2S² + 1)/(√π S³) e^(−S²) + (4S⁴ + 4S² − 1)/(2S⁴) erf S + 2√π/(3S) √(T_w/T)
/// ```
pub fn sphere_drag(speed_ratio: f64, wall_temperature_ratio: f64) -> f64 {
    let (s, s2) = (speed_ratio, speed_ratio * speed_ratio);
    (2.0 * s2 + 1.0) / (PI.sqrt() * s2 * s) * exp(-s2)
        + (4.0 * s2 * s2 + 4.0 * s2 - 1.0) / (2.0 * s2 * s2) * erf(s)
        + 2.0 * PI.sqrt() / (3.0 * s) * wall_temperature_ratio.sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_plate_across_the_flow() {
        // diffuse, S = 10, T_w = T: C_p = 2 (1 + 1/(2S²))/… = (2 − 1)(1 + 0.005)·2 + √π/10 = 2.18725, and no shear
        let [normal, along] = Gas::diffuse(10.0).loads(1.0);
        assert!((normal + along - 2.187_245_385).abs() < 1e-9);
        // specular: 4 (1 + 1/(2S²)) = 4.02
        let specular = Gas {
            normal_accommodation: 0.0,
            tangential_accommodation: 0.0,
            ..Gas::diffuse(10.0)
        };
        assert!((specular.loads(1.0)[0] - 4.02).abs() < 1e-12);
    }

    #[test]
    fn near_and_far_meet() {
        let gas = Gas {
            normal_accommodation: 0.8,
            tangential_accommodation: 0.9,
            wall_temperature_ratio: 0.5,
            ..Gas::diffuse(25.0)
        };
        let edge = gas.zone();
        for sign in [-1.0, 1.0] {
            let (a, b) = (
                gas.loads(sign * edge * (1.0 - 1e-9)),
                gas.loads(sign * edge * (1.0 + 1e-9)),
            );
            assert!(
                (a[0] - b[0]).abs() < 1e-8 && (a[1] - b[1]).abs() < 1e-8,
                "{a:?} {b:?}"
            );
        }
    }

    #[test]
    fn sphere_at_speed_ratio_5() {
        assert!((sphere_drag(5.0, 1.0) - 2.315_53).abs() < 5e-6);
    }
}
