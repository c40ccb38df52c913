//! The passes: Gauss-Seidel over the modules, closed-form flight first, integrated flight near convergence.
//!
//! ```text
//! x ← x + ω (f(x) − x)      until |M − M before| < criterion
//! ```
//!
//! ω halves each time the change of the mass turns its sign and is not much smaller, down to an eighth: a pass that
//! overshoots.
//!
//! with x the entry load, stagnation pressure, terminal speed and both heat-shield thicknesses, ω the relaxation, M the
//! entry mass in kg; f runs through geometry, mass, impact and structure, then flight, heating, soak and heat shield.
//!
//! # Valid
//! Always ends: converged, not converged after the last pass, not closed, or with a flight that leaves the atmosphere.
//!
//! # References
//! - \[samareh-2014\] section 2.2, steps 4 to 12.

use super::inputs::DesignInput;
use super::misfit;
use super::{Design, Pass, Solution};
use crate::finding::Finding;
use crate::flight::mission::{Body, Model};
use crate::flight::{self, Flight, Request, allen_eggers, summary, three_dof};
use crate::outcome::Outcome;
use crate::soak::SoakInput;
use crate::tps::mer::{self, Sizing};
use crate::tps::{Environment, Side, limits};
use crate::vehicle::impact::landing::{Landing, TouchdownVelocity};
use crate::vehicle::impact::remarks;
use crate::vehicle::{self, Vehicle, VehicleInput};
use numerics::math::FRAC_PI_2;

/// The closed form is left when a pass changes the mass by less than this part of it.
const HIGH_FIDELITY_BELOW: f64 = 0.05;

/// Least relaxation that overshooting passes lead to, as a part of the one asked for.
const LEAST_RELAXATION: f64 = 0.125;
/// A change of the mass with the other sign overshoots when it is larger than this part of the one before.
const OVERSHOOT: f64 = 0.3;

/// Designs a vehicle.
pub fn solve(input: &DesignInput, request: Request) -> Solution {
    let mut vehicle_input = input.vehicle.clone();
    let mut passes: Vec<Pass> = Vec::new();
    let mut model = Model::AllenEggers;
    let mut mass_before_kg: Option<f64> = None;
    let mut change_before_kg: Option<f64> = None;
    let mut relaxation = input.relaxation;
    loop {
        let number = passes.len() as u32 + 1;
        let vehicle = match vehicle::build(&vehicle_input) {
            Ok(vehicle) => vehicle,
            Err(not_closed) => {
                let findings = misfit::findings(&not_closed, &vehicle_input);
                return unclosed(not_closed.reason, findings, passes);
            }
        };
        let mass_kg = vehicle.mass.mass_kg;
        let change_kg = mass_before_kg.map(|before| mass_kg - before);
        if input.mission.solver.model == Model::ThreeDof
            && change_kg.is_some_and(|change| change.abs() < HIGH_FIDELITY_BELOW * mass_kg)
        {
            model = Model::ThreeDof;
        }
        let body = input.body(&vehicle);
        let flown = Flown::fly(input, &body, model);
        let sized = Sized::new(input, &vehicle, &flown);
        passes.push(Pass {
            number,
            flight_model: flown.flight.model.clone(),
            crossings: crossings(&vehicle, &vehicle_input, &flown, &sized),
            mass_kg,
            mass_change_kg: change_kg,
        });
        let high_fidelity = model == input.mission.solver.model;
        let settled = change_kg.is_some_and(|change| change.abs() < input.mass_criterion_kg);
        let outcome = match flown.outcome {
            _ if !high_fidelity => None,
            Outcome::SkippedOut | Outcome::Captured => Some(flown.outcome),
            _ if settled && three_dof_before(&passes, model) => Some(Outcome::Converged),
            _ => None,
        };
        let outcome = outcome.or((number >= input.max_iterations).then_some(Outcome::NotConverged));
        if let Some(outcome) = outcome {
            return Finished {
                input,
                request,
                vehicle,
                body,
                flown,
                sized,
                passes,
                outcome,
            }
            .solution();
        }
        if let (Some(before), Some(now)) = (change_before_kg, change_kg)
            && now * before < 0.0
            && now.abs() > OVERSHOOT * before.abs()
        {
            relaxation = (0.5 * relaxation).max(LEAST_RELAXATION * input.relaxation);
        }
        relax(&mut vehicle_input, relaxation, number, &flown, &sized);
        change_before_kg = change_kg;
        mass_before_kg = Some(mass_kg);
    }
}

/// Whether the mass of this pass already rests on a flight of the same model.
fn three_dof_before(passes: &[Pass], model: Model) -> bool {
    let same = |pass: &Pass| (pass.flight_model == "three-dof") == (model == Model::ThreeDof);
    passes.len() >= 2 && passes.iter().rev().skip(1).take(1).all(same)
}

/// Moves the coupling variables towards what the pass found; the first pass replaces the guesses.
fn relax(vehicle: &mut VehicleInput, relaxation: f64, number: u32, flown: &Flown, sized: &Sized) {
    let omega = if number == 1 { 1.0 } else { relaxation };
    let towards = |value: &mut f64, target: f64| *value += omega * (target - *value);
    towards(
        &mut vehicle.loads.entry_load_earth_g,
        flown.flight.peak_deceleration_earth_g.value,
    );
    towards(
        &mut vehicle.loads.peak_stagnation_pressure_pa,
        flown.flight.peak_stagnation_pressure_pa.value,
    );
    towards(
        &mut vehicle.loads.terminal_speed_m_s,
        flown.impact_speed_m_s,
    );
    towards(
        &mut vehicle.forebody.tps_thickness_m,
        sized.forebody.thickness_m,
    );
    towards(
        &mut vehicle.aftbody_tps_thickness_m,
        sized.aftbody.thickness_m,
    );
}

/// A flight of one pass.
struct Flown {
    flight: Flight,
    outcome: Outcome,
    reason: Option<String>,
    terminal_speed_m_s: f64,
    /// Speed at impact, or the terminal speed where the flight does not come down.
    impact_speed_m_s: f64,
}

impl Flown {
    fn fly(input: &DesignInput, body: &Body, model: Model) -> Flown {
        let mission = &input.mission;
        let (flight, outcome, reason) = match model {
            Model::AllenEggers => (
                allen_eggers::fly(mission, body, Request::Nothing),
                Outcome::Landed,
                None,
            ),
            Model::ThreeDof => {
                let record = three_dof::integrate(mission, body);
                let flight =
                    summary::summarize(three_dof::motion(mission, body), &record, Request::Nothing);
                (flight, record.outcome, record.reason)
            }
        };
        let ground_m = mission.stop.altitude_m.unwrap_or(0.0);
        let terminal_speed_m_s = allen_eggers::terminal_speed_m_s(mission, body, ground_m);
        let came_down = matches!(outcome, Outcome::Landed | Outcome::Stopped);
        let impact_speed_m_s = if came_down {
            flight.final_speed_m_s
        } else {
            terminal_speed_m_s
        };
        Flown {
            flight,
            outcome,
            reason,
            terminal_speed_m_s,
            impact_speed_m_s,
        }
    }
}

/// Heat shields and payload temperature of one pass.
struct Sized {
    environment: Environment,
    aft_environment: Environment,
    forebody: Sizing,
    aftbody: Sizing,
    soak: SoakInput,
    payload_temperature_k: f64,
}

impl Sized {
    fn new(input: &DesignInput, vehicle: &Vehicle, flown: &Flown) -> Sized {
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

/// Values of [`super::crossings::CROSSINGS`] in one pass.
fn crossings(vehicle: &Vehicle, given: &VehicleInput, flown: &Flown, sized: &Sized) -> Vec<f64> {
    vec![
        vehicle.dimensions.diameter_m,
        vehicle.dimensions.nose_radius_m,
        vehicle.mass.cg_x_m,
        vehicle.mass.mass_kg,
        vehicle.impact.required_stroke_m,
        vehicle.impact.foam_density_kg_m3,
        vehicle.structure.forebody.thickness_m,
        vehicle.structure.primary.thickness_m,
        flown.impact_speed_m_s,
        flown.flight.peak_deceleration_earth_g.value,
        flown.flight.peak_stagnation_pressure_pa.value,
        sized.environment.peak_heat_flux_w_m2,
        sized.environment.heat_load_j_m2,
        given.forebody.tps_thickness_m,
        given.aftbody_tps_thickness_m,
    ]
}

fn unclosed(reason: String, findings: Vec<Finding>, passes: Vec<Pass>) -> Solution {
    Solution {
        outcome: Outcome::NotClosed,
        reason: Some(reason),
        flight: None,
        design: None,
        adjustments: Vec::new(),
        findings,
        passes,
    }
}

/// The last pass, made into a solution.
struct Finished<'a> {
    input: &'a DesignInput,
    request: Request,
    vehicle: Vehicle,
    body: Body,
    flown: Flown,
    sized: Sized,
    passes: Vec<Pass>,
    outcome: Outcome,
}

impl Finished<'_> {
    fn solution(self) -> Solution {
        let mut findings = self.findings();
        let landing = self.landing();
        findings.extend(remarks::findings(
            &self.vehicle,
            &landing,
            &self.input.vehicle.impact.ground,
        ));
        let Finished {
            input,
            request,
            vehicle,
            body,
            flown,
            sized,
            passes,
            outcome,
        } = self;
        let flight = match request {
            Request::Nothing => flown.flight,
            // Only the last flight keeps its history.
            _ => flight::fly(&input.mission, &body, request).0,
        };
        let adjustments = vehicle.adjustments.clone();
        let shoulder_ratio =
            2.0 * vehicle.dimensions.shoulder_radius_m / vehicle.dimensions.diameter_m;
        let shoulder_factor = input.shoulder.ratio(shoulder_ratio);
        let last = passes.last();
        let reason = match outcome {
            Outcome::NotConverged => {
                let change = last
                    .and_then(|pass| pass.mass_change_kg)
                    .unwrap_or(f64::NAN);
                Some(format!(
                    "the mass still changed by {change:.3e} kg in pass {}, the last one allowed",
                    passes.len()
                ))
            }
            _ => flown.reason,
        };
        let design = Design {
            forebody_tps: sized.forebody,
            aftbody_tps: sized.aftbody,
            forebody_tps_density_kg_m3: input.vehicle.forebody.tps_density_kg_m3,
            aftbody_tps_density_kg_m3: input.vehicle.aftbody_tps_density_kg_m3,
            aftbody_heat_flux_w_m2: sized.aft_environment.peak_heat_flux_w_m2,
            aftbody_heat_load_j_m2: sized.aft_environment.heat_load_j_m2,
            shoulder_heat_flux_w_m2: sized.environment.peak_heat_flux_w_m2 * shoulder_factor,
            shoulder_heat_flux_ratio: shoulder_factor,
            aftbody_pressure_pa: sized.aft_environment.peak_pressure_pa,
            payload_temperature_k: sized.payload_temperature_k,
            impact_drag_coefficient: input.drag.subsonic(),
            terminal_speed_m_s: flown.terminal_speed_m_s,
            cone_half_angle_rad: input.vehicle.cone_half_angle_rad,
            payload_mass_kg: input.vehicle.payload_mass_kg,
            structural: None,
            stability: None,
            turning: None,
            passes: passes.len() as u32,
            mass_residual_kg: last.and_then(|pass| pass.mass_change_kg),
            landing,
            vehicle,
        };
        Solution {
            outcome,
            reason,
            flight: Some(flight),
            design: Some(design),
            adjustments,
            findings,
            passes,
        }
    }

    fn landing(&self) -> Landing {
        let flown = &self.flown;
        // the closed form keeps its angle to the ground: only the integrated flight knows where it comes down from
        let integrated = flown.flight.model == "three-dof";
        let angle_rad = match flown.outcome {
            Outcome::Landed | Outcome::Stopped if integrated => {
                flown.flight.final_flight_path_angle_rad
            }
            _ => -FRAC_PI_2,
        };
        let velocity = TouchdownVelocity::new(flown.impact_speed_m_s, angle_rad);
        Landing::new(&self.input.vehicle, &self.vehicle, velocity)
    }

    fn findings(&self) -> Vec<Finding> {
        let Finished {
            input,
            vehicle,
            body,
            flown,
            sized,
            ..
        } = self;
        let shoulder_ratio =
            2.0 * vehicle.dimensions.shoulder_radius_m / vehicle.dimensions.diameter_m;
        let mut findings = limits::findings(
            &input.forebody_material,
            &sized.environment,
            &sized.forebody,
        );
        findings.extend(limits::findings(
            &input.aftbody_material,
            &sized.aft_environment,
            &sized.aftbody,
        ));
        findings.extend(
            input
                .fit_space
                .findings(&sized.environment, flown.flight.ballistic_coefficient_kg_m2),
        );
        findings.extend(flight::findings(&input.mission, body, &flown.flight));
        findings.extend(input.shoulder.findings(shoulder_ratio));
        findings.extend(input.soak.findings(&sized.soak));
        findings.extend(vehicle.findings.iter().cloned());
        findings
    }
}
