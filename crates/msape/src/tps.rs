//! Heat shield: thickness from mass-estimating relations, and the limits of its materials.
//!
//! - [`material`]: a material's relation, limits and properties, one file each in `data/materials`.
//! - [`mer`]: thickness from heat load and entry speed.
//! - [`limits`]: findings, where a material or a relation is used beyond what is known.
//! - [`fit_space`]: the trajectories behind the relations.
//! - [`concept`]: a forebody's heat shield, bond and carrier together, one file each in `data/concepts`.
//!
//! Loads come in cold-wall and with the user's margins; the relations themselves carry no margin (section 3.5.1).
//!
//! Deliberately absent: in-depth conduction and ablation, which a later model adds beside the relations.

pub mod concept;
pub mod fit_space;
pub mod limits;
pub mod material;
pub mod mer;

use crate::heating::afterbody::Afterbody;
use numerics::math::RADIANS_PER_DEGREE;
use serde::{Deserialize, Serialize};

/// Pascals in an atmosphere.
pub const PA_PER_ATM: f64 = 101_325.0;

/// Side of the vehicle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Side {
    /// Before the shoulder.
    Forebody,
    /// Behind it.
    Aftbody,
}

impl Side {
    /// The word for it, as in keys.
    pub fn name(self) -> &'static str {
        match self {
            Self::Forebody => "forebody",
            Self::Aftbody => "aftbody",
        }
    }
}

/// What a heat shield goes through, at its own place: an aftbody's values are already those of the aftbody.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Environment {
    /// Where it is.
    pub side: Side,
    /// Peak total heat flux, cold wall, with margins, W/m².
    pub peak_heat_flux_w_m2: f64,
    /// Total heat load, cold wall, with margins, J/m².
    pub heat_load_j_m2: f64,
    /// Peak pressure, Pa.
    pub peak_pressure_pa: f64,
    /// Entry speed, m/s.
    pub entry_speed_m_s: f64,
    /// Entry flight-path angle against the horizon, negative down, rad.
    pub entry_flight_path_angle_rad: f64,
    /// Time for which the heat flux is above the material's limit, s; unknown is `None`.
    pub time_above_limit_s: Option<f64>,
}

impl Environment {
    /// Entry angle below the horizon, deg.
    pub fn entry_depth_deg(&self) -> f64 {
        -self.entry_flight_path_angle_rad / RADIANS_PER_DEGREE
    }

    /// What the aftbody goes through when the forebody goes through this.
    pub fn aftbody(&self, fractions: &Afterbody) -> Self {
        Self {
            side: Side::Aftbody,
            peak_heat_flux_w_m2: self.peak_heat_flux_w_m2 * fractions.heat_flux_fraction,
            heat_load_j_m2: self.heat_load_j_m2 * fractions.heat_load_fraction,
            peak_pressure_pa: self.peak_pressure_pa * fractions.pressure_fraction,
            time_above_limit_s: None,
            ..*self
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn aftbody_has_a_twentieth_of_the_heating_and_half_the_pressure() {
        let fractions = Afterbody::parse(include_str!("../data/heating/afterbody.toml")).unwrap();
        let forebody = Environment {
            side: Side::Forebody,
            peak_heat_flux_w_m2: 2e7,
            heat_load_j_m2: 2e8,
            peak_pressure_pa: 1e5,
            entry_speed_m_s: 12e3,
            entry_flight_path_angle_rad: -RADIANS_PER_DEGREE,
            time_above_limit_s: Some(1.0),
        };
        let aft = forebody.aftbody(&fractions);
        assert_eq!(
            [
                aft.peak_heat_flux_w_m2,
                aft.heat_load_j_m2,
                aft.peak_pressure_pa
            ],
            [1e6, 1e7, 5e4]
        );
        assert_eq!(
            (aft.side, aft.time_above_limit_s, aft.entry_depth_deg()),
            (Side::Aftbody, None, 1.0)
        );
    }
}
