//! Vertical transport of the gases between 86 and 150 km, with its integral.
//!
//! ```text
//! v = Q (z − U)² exp(−W (z − U)³) + q (u − z)² exp(−w (u − z)³)           the second part below u only
//! ∫ v dz = Q/(3 W) [exp(−W (86 − U)³) − exp(−W (z − U)³)] + q/(3 w) [exp(−w (u − z)³) − exp(−w (u − 86)³)]
//! ```
//!
//! with z, U, u in km, Q, q, W, w in 1/km³ and v in 1/km.
//!
//! # Valid
//! 86 to 150 km; nought above.
//!
//! # References
//! - \[coesa-1976\] equation 37 and Table 7.

use super::super::definition::Species;
use numerics::math;

/// Above this v is nought, km.
pub const FLUX_TOP_KM: f64 = 150.0;

/// v, 1/m.
pub fn flux_per_m(species: &Species, z_m: f64) -> f64 {
    let Species {
        q_capital_per_km3: q1,
        u_capital_km: u1,
        w_capital_per_km3: w1,
        ..
    } = *species;
    let Species {
        q_small_per_km3: q2,
        u_small_km: u2,
        w_small_per_km3: w2,
        ..
    } = *species;
    let z = z_m / 1000.0;
    if z >= FLUX_TOP_KM {
        return 0.0;
    }
    let a = z - u1;
    let b = (u2 - z).max(0.0);
    (q1 * a * a * math::exp(-w1 * a * a * a) + q2 * b * b * math::exp(-w2 * b * b * b)) / 1000.0
}

/// ∫ v dz from 86 km.
pub fn flux_integral(species: &Species, z_m: f64) -> f64 {
    let Species {
        q_capital_per_km3: q1,
        u_capital_km: u1,
        w_capital_per_km3: w1,
        ..
    } = *species;
    let Species {
        q_small_per_km3: q2,
        u_small_km: u2,
        w_small_per_km3: w2,
        ..
    } = *species;
    let z = (z_m / 1000.0).min(FLUX_TOP_KM);
    let falling = |x: f64| {
        let a = x - u1;
        math::exp(-w1 * a * a * a)
    };
    let rising = |x: f64| {
        let b = (u2 - x).max(0.0);
        math::exp(-w2 * b * b * b)
    };
    let mut integral = 0.0;
    if w1 > 0.0 {
        integral += q1 / (3.0 * w1) * (falling(86.0) - falling(z));
    }
    if w2 > 0.0 {
        integral += q2 / (3.0 * w2) * (rising(z) - rising(86.0));
    }
    integral
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_integral_has_the_flux_as_its_slope() {
        let text = include_str!("../../../../../data/atmospheres/us-1976.toml");
        let definition = super::super::super::definition::Definition::parse(text).unwrap();
        for species in &definition.species {
            for z in [88e3, 96e3, 110e3, 149e3, 200e3] {
                let slope =
                    (flux_integral(species, z + 10.0) - flux_integral(species, z - 10.0)) / 20.0;
                // Central difference over 20 m: (10 m)²/6 of a curvature below 1e-10/m³ · v
                assert!(
                    (slope - flux_per_m(species, z)).abs() < 1e-9,
                    "{} {z}",
                    species.name
                );
            }
        }
    }
}
