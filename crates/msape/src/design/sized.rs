//! The heat shields and the payload's temperature of one pass of the coupling.

use super::flown::Flown;
use super::inputs::DesignInput;
use crate::soak::SoakInput;
use crate::tps::mer::{self, Sizing};
use crate::tps::{Environment, Point};
use crate::vehicle::Vehicle;

/// Heat shields and payload temperature of one pass.
pub(super) struct Sized {
    /// The stagnation point, from which the other points follow.
    pub(super) stagnation: Environment,
    /// The point of the forebody at which its heat shield is judged.
    pub(super) environment: Environment,
    /// Heat flux on the shoulder over that at the stagnation point.
    pub(super) shoulder_factor: f64,
    pub(super) aft_environment: Environment,
    pub(super) forebody: Sizing,
    pub(super) aftbody: Sizing,
    pub(super) soak: SoakInput,
    pub(super) payload_temperature_k: f64,
}

impl Sized {
    /// The heat shields that a flight asks for.
    pub(super) fn new(input: &DesignInput, vehicle: &Vehicle, flown: &Flown) -> Sized {
        let flight = &flown.flight;
        let stagnation = Environment {
            point: Point::Stagnation,
            peak_heat_flux_w_m2: flight.peak_total_margined_heat_flux_w_m2.value,
            heat_load_j_m2: flight.total_margined_heat_load_j_m2(),
            peak_pressure_pa: flight.peak_stagnation_pressure_pa.value,
            entry_speed_m_s: flight.entry_relative.speed_m_s,
            entry_flight_path_angle_rad: flight.entry_relative.flight_path_angle_rad,
            time_above_limit_s: None,
        };
        let dimensions = &vehicle.dimensions;
        let shoulder_factor = input
            .shoulder
            .ratio(2.0 * dimensions.shoulder_radius_m / dimensions.diameter_m);
        let environment = input.judged_at.environment(&stagnation, shoulder_factor);
        let aft_environment = stagnation.aftbody(&input.afterbody);
        let forebody = mer::size(&input.forebody_material, &environment);
        // the correlation was fitted to the stagnation point
        let soak = SoakInput {
            peak_heat_flux_w_m2: stagnation.peak_heat_flux_w_m2,
            heat_load_j_m2: stagnation.heat_load_j_m2,
            diameter_m: dimensions.diameter_m,
            concept: input.vehicle.concept,
            forebody_tps_thickness_m: forebody.thickness_m,
        };
        Sized {
            forebody,
            aftbody: mer::size(&input.aftbody_material, &aft_environment),
            payload_temperature_k: input.soak.peak_temperature_k(&soak),
            stagnation,
            environment,
            shoulder_factor,
            aft_environment,
            soak,
        }
    }

    /// A result that is not a finite number, by its name.
    pub(super) fn not_finite(&self) -> Option<&'static str> {
        let named = [
            ("peak heat flux", self.stagnation.peak_heat_flux_w_m2),
            ("heat load", self.stagnation.heat_load_j_m2),
            ("forebody heat-shield thickness", self.forebody.thickness_m),
            ("aftbody heat-shield thickness", self.aftbody.thickness_m),
            ("payload temperature", self.payload_temperature_k),
        ];
        let mut wild = named.into_iter().filter(|(_, value)| !value.is_finite());
        wild.next().map(|(name, _)| name)
    }
}
