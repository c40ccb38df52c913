//! The heat shields and the payload's temperature of one pass of the coupling.

use super::flown::Flown;
use super::inputs::DesignInput;
use crate::flight::Flight;
use crate::soak::SoakInput;
use crate::tps::environment::OffStagnation;
use crate::tps::mer::{self, Sizing};
use crate::tps::{Environment, Point};
use crate::vehicle::Vehicle;

/// Heat shields and payload temperature of one pass.
#[derive(Debug)]
pub(super) struct Sized {
    /// The stagnation point, from which the other points follow.
    pub(super) stagnation: Environment,
    /// Point of the forebody at which its heat shield is sized.
    pub(super) environment: Environment,
    /// The hottest point off the stagnation point.
    pub(super) off: OffStagnation,
    pub(super) aft_environment: Environment,
    pub(super) forebody: Sizing,
    pub(super) aftbody: Sizing,
    pub(super) soak: SoakInput,
    pub(super) payload_temperature_k: f64,
}

impl Sized {
    /// The heat shields that a flight requires.
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
        let off = match &input.mission.heating.body {
            Some(_) => of_points(flight, &stagnation),
            None => {
                let ratio = 2.0 * dimensions.shoulder_radius_m / dimensions.diameter_m;
                OffStagnation::shoulder(input.shoulder.ratio(ratio))
            }
        };
        let environment = input.judged_at.environment(&stagnation, &off);
        let aft_environment = stagnation.aftbody(&input.afterbody);
        let given = &input.given;
        let forebody =
            mer::size(&input.forebody_material, &environment).or_given(given.forebody_tps_m);
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
            aftbody: mer::size(&input.aftbody_material, &aft_environment)
                .or_given(given.aftbody_tps_m),
            payload_temperature_k: (given.payload_temperature_k)
                .unwrap_or_else(|| input.soak.peak_temperature_k(&soak)),
            stagnation,
            environment,
            off,
            aft_environment,
            soak,
        }
    }

    /// Name of a result that is not a finite number.
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

/// The hottest point of a case that gives heat fluxes along the body.
fn of_points(flight: &Flight, stagnation: &Environment) -> OffStagnation {
    let along = flight.points.iter().skip(1).map(|point| {
        [
            ratio(point.peak_heat_flux_w_m2, stagnation.peak_heat_flux_w_m2),
            ratio(point.heat_load_j_m2, stagnation.heat_load_j_m2),
        ]
    });
    let largest =
        |[flux, load]: [f64; 2], other: [f64; 2]| [flux.max(other[0]), load.max(other[1])];
    let [heat_flux_ratio, heat_load_ratio] = along.fold([0.0; 2], largest);
    OffStagnation {
        point: Point::Given,
        heat_flux_ratio,
        heat_load_ratio,
    }
}

/// Ratio of `value` to `of`; 0 if `of` is 0.
fn ratio(value: f64, of: f64) -> f64 {
    if of > 0.0 { value / of } else { 0.0 }
}
