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
//! 86 to 150 km; zero above.
//!
//! # References
//! - \[coesa-1976\] equation 37 and Table 7.

use crate::definition::Species;
use numerics::math;

/// Above this v is zero, km.
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

/// ∫ v dz of one gas, with what does not depend on the altitude at hand.
pub struct FluxIntegral<'a> {
    species: &'a Species,
    falling_at_86_km: f64,
    rising_at_86_km: f64,
    /// Integral from 86 km to the top.
    whole: f64,
}

impl<'a> FluxIntegral<'a> {
    /// The integral of a gas.
    pub fn new(species: &'a Species) -> Self {
        let mut integral = Self {
            species,
            falling_at_86_km: falling(species, 86.0),
            rising_at_86_km: rising(species, 86.0),
            whole: 0.0,
        };
        integral.whole = integral.up_to(FLUX_TOP_KM);
        integral
    }

    /// Integral from 86 km to an altitude, m.
    pub fn at(&self, z_m: f64) -> f64 {
        match z_m / 1000.0 {
            z if z < FLUX_TOP_KM => self.up_to(z),
            _ => self.whole,
        }
    }

    fn up_to(&self, z: f64) -> f64 {
        let Species {
            q_capital_per_km3: q1,
            w_capital_per_km3: w1,
            q_small_per_km3: q2,
            w_small_per_km3: w2,
            ..
        } = *self.species;
        let mut integral = 0.0;
        if w1 > 0.0 {
            integral += q1 / (3.0 * w1) * (self.falling_at_86_km - falling(self.species, z));
        }
        if w2 > 0.0 {
            integral += q2 / (3.0 * w2) * (rising(self.species, z) - self.rising_at_86_km);
        }
        integral
    }
}

/// exp(−W (z − U)³), z in km.
fn falling(species: &Species, z: f64) -> f64 {
    let a = z - species.u_capital_km;
    math::exp(-species.w_capital_per_km3 * a * a * a)
}

/// exp(−w (u − z)³), 1 above u, z in km.
fn rising(species: &Species, z: f64) -> f64 {
    let b = (species.u_small_km - z).max(0.0);
    math::exp(-species.w_small_per_km3 * b * b * b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_integral_has_the_flux_as_its_slope() {
        for species in &crate::sample::definition().species {
            let integral = FluxIntegral::new(species);
            for z in [88e3, 96e3, 110e3, 149e3, 200e3] {
                let slope = (integral.at(z + 10.0) - integral.at(z - 10.0)) / 20.0;
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
