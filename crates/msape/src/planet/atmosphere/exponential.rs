//! Atmosphere of one scale height, for published analytic cases.
//!
//! ```text
//! ρ = ρ₀ exp(−h/H)
//! ```
//!
//! with ρ in kg/m³ and h, H in m. Temperature and gas are those of the planet's own atmosphere, p = ρ R T.
//!
//! # Valid
//! Everywhere by definition; as a model of the Earth, within tens of per cent between 0 and 100 km.
//!
//! # References
//! - \[allen-eggers-1958\].

use super::{Air, PlanetAir};
use numerics::scalar::Scalar;
use thiserror::Error;

/// The atmosphere.
#[derive(Clone, Debug, PartialEq)]
pub struct Exponential {
    surface_density_kg_m3: f64,
    scale_height_m: f64,
    air: PlanetAir,
}

/// Fault of the two numbers.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum ExponentialFault {
    /// Density at the surface.
    #[error("density_kg_m3: got {value} kg/m³, must be above 0 and finite")]
    Density {
        /// Value given, kg/m³.
        value: f64,
    },
    /// Scale height.
    #[error("scale_height_m: got {value} m, must be above 0 and finite")]
    ScaleHeight {
        /// Value given, m.
        value: f64,
    },
}

impl Exponential {
    /// The atmosphere, or all that is wrong with it.
    pub fn try_new(
        surface_density_kg_m3: f64,
        scale_height_m: f64,
        air: PlanetAir,
    ) -> Result<Self, Vec<ExponentialFault>> {
        let mut faults = Vec::new();
        if !(surface_density_kg_m3 > 0.0 && surface_density_kg_m3.is_finite()) {
            faults.push(ExponentialFault::Density {
                value: surface_density_kg_m3,
            });
        }
        if !(scale_height_m > 0.0 && scale_height_m.is_finite()) {
            faults.push(ExponentialFault::ScaleHeight {
                value: scale_height_m,
            });
        }
        if faults.is_empty() {
            Ok(Self {
                surface_density_kg_m3,
                scale_height_m,
                air,
            })
        } else {
            Err(faults)
        }
    }

    /// Density, kg/m³.
    #[inline]
    pub fn density_kg_m3<S: Scalar>(&self, altitude_m: S) -> S {
        let Self {
            surface_density_kg_m3: rho_0,
            scale_height_m: scale,
            ..
        } = *self;
        (altitude_m / -scale).exp() * rho_0
    }

    /// Everything at an altitude, m.
    #[inline]
    pub fn air<S: Scalar>(&self, altitude_m: S) -> Air<S> {
        let temperature_k = self.air.temperature.kinetic_k(altitude_m);
        (self.air.gas).air(self.density_kg_m3(altitude_m), temperature_k, None, None)
    }

    /// The planet's own air, of which temperature and gas are.
    pub fn planet_air(&self) -> &PlanetAir {
        &self.air
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::planet::atmosphere::us_1976::UsStandard1976;

    fn standard() -> PlanetAir {
        UsStandard1976::parse(include_str!("../../../data/atmospheres/us-1976.toml").into())
            .unwrap()
            .1
            .planet_air()
    }

    #[test]
    fn one_scale_height_up_the_density_is_one_over_e() {
        let air = Exponential::try_new(1.2, 7000.0, standard()).unwrap();
        assert!((air.density_kg_m3(7000.0) - 1.2 * 0.36787944117144233).abs() < 1e-15);
        // ρ R T = 1.2 × 287.0529 × 288.15
        assert!((air.air(0.0).pressure_pa - 99257.1).abs() < 0.5);
    }

    #[test]
    fn both_faults_are_reported() {
        let faults = Exponential::try_new(-1.0, f64::NAN, standard()).unwrap_err();
        assert_eq!(faults.len(), 2);
        assert!(faults[0].to_string().contains("-1 kg/m³"));
    }
}
