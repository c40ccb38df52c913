//! The trajectories on which the mass-estimating relations were fitted, and findings for an entry outside them.

use super::{Environment, PA_PER_ATM};
use crate::data::Data;
use crate::finding::range::{Check, Range};
use crate::finding::{Finding, Severity};
use crate::heating::PER_CM2;
use crate::quantity::input;
use serde::Deserialize;

/// The trajectories on which the relations were fitted, from `tps/mer-fit-space.toml`.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FitSpace {
    /// Key of the reference.
    pub source: String,
    /// Place in the source.
    pub place: String,
    /// Number of trajectories.
    pub trajectories: u32,
    /// Entry speed, km/s.
    pub speed_km_s: Range,
    /// Entry angle below the horizon, deg.
    pub flight_path_angle_deg: Range,
    /// Ballistic coefficient, kg/m².
    pub ballistic_coefficient_kg_m2: Range,
    /// Forebody peak heat flux, cold wall, W/cm².
    pub heat_flux_w_cm2: Range,
    /// Forebody heat load, cold wall, J/cm².
    pub heat_load_j_cm2: Range,
    /// Forebody peak pressure, atm.
    pub pressure_atm: Range,
}

impl FitSpace {
    /// Reads the ranges from the text of their file.
    pub fn parse(data: Data) -> Result<Self, String> {
        data.read()
    }

    /// Findings for an entry outside the fitted trajectories; `forebody` is what its heat
    /// shield is judged by.
    pub fn findings(
        &self,
        forebody: &Environment,
        ballistic_coefficient_kg_m2: f64,
    ) -> Vec<Finding> {
        let place = forebody.point.place();
        let (flux_of, load_of) = (
            format!("Peak heat flux {place}"),
            format!("Heat load {place}"),
        );
        let speed = Check {
            severity: Severity::Extrapolated,
            model: "mer",
            key: "entry_relative_speed_m_s",
            quantity: "Entry speed",
            value: forebody.entry_speed_m_s / 1000.0,
            range: self.speed_km_s,
            unit: "km/s",
            si_per_unit: 1000.0,
            meaning: "the thickness relations were not fitted there",
            source: "NASA/TM-2014-218507, Tables 5 and 6",
            field: Some(input::entry::SPEED_M_S.key),
        };
        let angle = Check {
            key: "entry_relative_flight_path_angle_deg",
            quantity: "Entry angle below the horizon",
            value: forebody.entry_depth_deg(),
            range: self.flight_path_angle_deg,
            unit: "deg",
            si_per_unit: 1.0,
            field: Some(input::entry::FLIGHT_PATH_ANGLE_DEG.key),
            ..speed
        };
        let ballistic = Check {
            key: "ballistic_coefficient_kg_m2",
            quantity: "Ballistic coefficient",
            value: ballistic_coefficient_kg_m2,
            range: self.ballistic_coefficient_kg_m2,
            unit: "kg/m²",
            si_per_unit: 1.0,
            field: Some(input::design::DIAMETER_M.key),
            ..speed
        };
        let flux = Check {
            key: forebody.point.heat_flux_key(),
            quantity: &flux_of,
            value: forebody.peak_heat_flux_w_m2 / PER_CM2,
            range: self.heat_flux_w_cm2,
            unit: "W/cm²",
            si_per_unit: PER_CM2,
            ..speed
        };
        let load = Check {
            key: forebody.point.heat_load_key(),
            quantity: &load_of,
            value: forebody.heat_load_j_m2 / PER_CM2,
            range: self.heat_load_j_cm2,
            unit: "J/cm²",
            si_per_unit: PER_CM2,
            ..speed
        };
        let pressure = Check {
            key: "peak_stagnation_pressure_pa",
            quantity: "Forebody peak pressure",
            value: forebody.peak_pressure_pa / PA_PER_ATM,
            range: self.pressure_atm,
            unit: "atm",
            si_per_unit: PA_PER_ATM,
            ..speed
        };
        [speed, angle, ballistic, flux, load, pressure]
            .iter()
            .filter_map(Check::finding)
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tps::Point;
    use numerics::math::RADIANS_PER_DEGREE;

    /// 12 km/s at −9°, 12 kJ/cm², 800 W/cm², half an atmosphere: quiet for PICA.
    const FOREBODY: Environment = Environment {
        point: Point::Stagnation,
        peak_heat_flux_w_m2: 800e4,
        heat_load_j_m2: 12_000e4,
        peak_pressure_pa: 0.5 * PA_PER_ATM,
        entry_speed_m_s: 12e3,
        entry_flight_path_angle_rad: -9.0 * RADIANS_PER_DEGREE,
        time_above_limit_s: None,
    };

    #[test]
    fn entry_outside_the_840_trajectories_is_said_once_for_each_quantity() {
        let space =
            FitSpace::parse(include_str!("../../data/tps/mer-fit-space.toml").into()).unwrap();
        assert_eq!(space.findings(&FOREBODY, 60.0), []);
        let steep = Environment {
            entry_speed_m_s: 9e3,
            entry_flight_path_angle_rad: -30.0 * RADIANS_PER_DEGREE,
            heat_load_j_m2: 2000e4,
            ..FOREBODY
        };
        let keys: Vec<String> = space
            .findings(&steep, 40.0)
            .into_iter()
            .map(|finding| finding.key)
            .collect();
        assert_eq!(
            keys,
            [
                "entry_relative_speed_m_s",
                "entry_relative_flight_path_angle_deg",
                "ballistic_coefficient_kg_m2",
                "total_margined_heat_load_j_m2"
            ]
        );
    }
}
