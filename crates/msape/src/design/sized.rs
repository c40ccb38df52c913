//! The heat shields and the payload's temperature of one pass of the coupling.

use super::flown::Flown;
use super::inputs::DesignInput;
use crate::soak::SoakInput;
use crate::tps::mer::{self, Sizing};
use crate::tps::{Environment, Side};
use crate::vehicle::Vehicle;

/// Heat shields and payload temperature of one pass.
pub(super) struct Sized {
    pub(super) environment: Environment,
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
        let environment = Environment {
            side: Side::Forebody,
            peak_heat_flux_w_m2: flight.peak_total_margined_heat_flux_w_m2.value,
            heat_load_j_m2: flight.total_margined_heat_load_j_m2(),
            peak_pressure_pa: flight.peak_stagnation_pressure_pa.value,
            entry_speed_m_s: flight.entry_relative.speed_m_s,
            entry_flight_path_angle_rad: flight.entry_relative.flight_path_angle_rad,
            time_above_limit_s: None,
        };
        let aft_environment = environment.aftbody(&input.afterbody);
        let soak = SoakInput {
            peak_heat_flux_w_m2: environment.peak_heat_flux_w_m2,
            heat_load_j_m2: environment.heat_load_j_m2,
            diameter_m: vehicle.dimensions.diameter_m,
        };
        Sized {
            forebody: mer::size(&input.forebody_material, &environment),
            aftbody: mer::size(&input.aftbody_material, &aft_environment),
            payload_temperature_k: input.soak.peak_temperature_k(&soak),
            environment,
            aft_environment,
            soak,
        }
    }
}
