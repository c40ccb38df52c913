//! The passes: Gauss-Seidel over the modules, accelerated; closed-form flight first, integrated flight near convergence.
//!
//! ```text
//! x ← x − Σ γⱼ Δxⱼ + ω (f(x) − x − Σ γⱼ Δrⱼ)      until |Σ γⱼ ΔMⱼ| + u s < criterion
//! answer: the vehicle of f(x) with the flight of the vehicle of x
//! ```
//!
//! with x the entry load, stagnation pressure, speed at impact and both heat-shield thicknesses; f runs through geometry,
//! mass, impact and structure, then flight, heating, soak and heat shield; ω the relaxation, M the entry mass in kg, Δ the
//! last two steps and γ their parts ([`numerics::fixed_point`]). Σ γⱼ ΔMⱼ is how far the mass stands from its fixed point
//! as the last steps tell it; u is the largest part of a coupling number that they leave unexplained, s the steepest
//! change of the mass for such a part that they saw.
//!
//! The answer's walls, foam and heat shields are made for the flight that it prints. That flight was flown by the vehicle
//! before, whose mass differs by less than the criterion: the one place where two passes meet.
//!
//! # Valid
//! Always ends: converged, not converged after the last pass, not closed, with a flight that leaves the atmosphere, or given
//! up at a limit of work or where a number is not finite.
//!
//! # References
//! - \[samareh-2014\] section 2.2, steps 4 to 12; \[anderson-1965\].

use super::flown::{Flown, with_history};
use super::given;
use super::inputs::DesignInput;
use super::misfit;
use super::sized::Sized;
use super::{Design, Pass, Solution};
use crate::finding::Finding;
use crate::flight::mission::{Body, Model};
use crate::flight::{self, Request};
use crate::outcome::Outcome;
use crate::tps::limits;
use crate::vehicle::impact::landing::{Landing, TouchdownVelocity};
use crate::vehicle::impact::remarks;
use crate::vehicle::{self, NotClosed, Vehicle, VehicleInput};
use numerics::fixed_point::Anderson;
use numerics::math::FRAC_PI_2;

/// The closed form is left when a pass changes the mass by less than this part of it.
const HIGH_FIDELITY_BELOW: f64 = 0.05;

/// Numbers that couple the passes.
const NUMBERS: usize = 5;

/// Accuracy of a flight, as a part of what the criterion is of the mass: the numbers of a pass scatter by as much.
const FLIGHT_PART: f64 = 0.05;
/// Finest tolerance of a flight: below it the steps meet rounding.
const FINEST_TOLERANCE: f64 = 1e-10;

/// Work after which a design is given up, in evaluations of the equations of motion: the default of twenty passes, each with a
/// flight of the classical method at its own limit, is 16 million.
const MOST_WORK: u64 = 20_000_000;
/// Work of a pass beside its flight, in evaluations: geometry, masses and heat shields.
const WORK_OF_PASS: u64 = 10_000;

/// Designs a vehicle.
pub fn solve(input: &DesignInput, request: Request) -> Solution {
    // its own, as the flights of a small criterion are integrated more finely
    let mut input = input.clone();
    let mut vehicle_input = input.vehicle.clone();
    let mut passes: Vec<Pass> = Vec::new();
    let mut model = Model::AllenEggers;
    // a step beyond what a pass found may lead where no vehicle closes; the acceleration goes as far as the passes say
    let mut anderson = Anderson::new(input.relaxation.min(1.0));
    let mut damped: Option<[f64; NUMBERS]> = None;
    let mut work = 0;
    loop {
        let number = passes.len() as u32 + 1;
        let vehicle = match (vehicle::build(&vehicle_input), damped.take()) {
            (Ok(vehicle), _) => vehicle,
            // the acceleration may lead where no vehicle closes though a plain pass does not
            (Err(_), Some(damped)) => {
                anderson.forget();
                take(&mut vehicle_input, damped);
                continue;
            }
            (Err(not_closed), None) => return unclosed(not_closed, &vehicle_input, passes),
        };
        let mass_kg = vehicle.mass.mass_kg;
        let mass_before_kg = passes.last().map(|pass| pass.mass_kg);
        let change_kg = mass_before_kg.map(|before| mass_kg - before);
        if model != input.mission.solver.model
            && change_kg.is_some_and(|change| change.abs() < HIGH_FIDELITY_BELOW * mass_kg)
        {
            model = input.mission.solver.model;
            anderson.change_function();
            let solver = &mut input.mission.solver;
            let enough = FLIGHT_PART * input.mass_criterion_kg / mass_kg;
            solver.tolerance = solver.tolerance.min(enough.max(FINEST_TOLERANCE));
        }
        let body = input.body(&vehicle);
        let mut flown = Flown::fly(&input, &body, model);
        let sized = Sized::new(&input, &vehicle, &flown);
        if let Some(name) = sized.not_finite() {
            flown.give_up(name);
        }
        work += WORK_OF_PASS + flown.flight.evaluations;
        let found = found(&flown, &sized);
        let proposal = anderson.propose(taken(&vehicle_input), found, mass_kg);
        let distance_kg = proposal.distance;
        let same_model = passes
            .last()
            .is_some_and(|before| before.flight_model == model);
        passes.push(Pass {
            number,
            flight_model: model,
            crossings: crossings(&vehicle, &flown, &sized),
            mass_kg,
            mass_change_kg: change_kg,
            mass_distance_kg: distance_kg,
        });
        let high_fidelity = model == input.mission.solver.model;
        let departed = matches!(flown.outcome, Outcome::SkippedOut | Outcome::Captured);
        if flown.outcome == Outcome::GaveUp || high_fidelity && departed {
            return flown.departed(&input, request, &body, passes);
        }
        let near = |kg: f64| kg.abs() < input.mass_criterion_kg;
        let settled = high_fidelity && same_model && distance_kg.is_some_and(near);
        let is_last = number >= input.max_iterations || work >= MOST_WORK;
        if settled || is_last {
            let mut closing_input = vehicle_input.clone();
            take(&mut closing_input, found);
            let closing = match vehicle::build(&closing_input) {
                Ok(closing) => closing,
                Err(not_closed) => return unclosed(not_closed, &closing_input, passes),
            };
            let settled = settled && near(closing.mass.mass_kg - mass_kg);
            if settled || is_last {
                if let Some(last) = passes.last_mut() {
                    last.crossings = crossings(&closing, &flown, &sized);
                    last.mass_kg = closing.mass.mass_kg;
                    last.mass_change_kg = mass_before_kg.map(|before| last.mass_kg - before);
                }
                return Finished {
                    input: &input,
                    request,
                    vehicle: closing,
                    body,
                    flown,
                    sized,
                    passes,
                    outcome: if settled {
                        Outcome::Converged
                    } else if work >= MOST_WORK {
                        Outcome::GaveUp
                    } else {
                        Outcome::NotConverged
                    },
                }
                .solution();
            }
        }
        // the first pass replaces the guesses
        let next = if number == 1 { found } else { proposal.next };
        damped = (number > 1 && next != proposal.damped).then_some(proposal.damped);
        take(&mut vehicle_input, next);
    }
}

/// The coupling numbers of a vehicle.
fn taken(vehicle: &VehicleInput) -> [f64; NUMBERS] {
    [
        vehicle.loads.entry_load_earth_g,
        vehicle.loads.peak_stagnation_pressure_pa,
        vehicle.loads.terminal_speed_m_s,
        vehicle.forebody.tps_thickness_m,
        vehicle.aftbody_tps_thickness_m,
    ]
}

/// Gives a vehicle other coupling numbers.
fn take(vehicle: &mut VehicleInput, numbers: [f64; NUMBERS]) {
    [
        vehicle.loads.entry_load_earth_g,
        vehicle.loads.peak_stagnation_pressure_pa,
        vehicle.loads.terminal_speed_m_s,
        vehicle.forebody.tps_thickness_m,
        vehicle.aftbody_tps_thickness_m,
    ] = numbers;
}

/// The coupling numbers that a pass finds.
fn found(flown: &Flown, sized: &Sized) -> [f64; NUMBERS] {
    [
        flown.flight.peak_deceleration_earth_g.value,
        flown.flight.peak_stagnation_pressure_pa.value,
        flown.impact_speed_m_s,
        sized.forebody.thickness_m,
        sized.aftbody.thickness_m,
    ]
}

/// Values of [`super::crossings::CROSSINGS`] in one pass.
fn crossings(vehicle: &Vehicle, flown: &Flown, sized: &Sized) -> Vec<f64> {
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
        sized.stagnation.peak_heat_flux_w_m2,
        sized.stagnation.heat_load_j_m2,
        sized.forebody.thickness_m,
        sized.aftbody.thickness_m,
    ]
}

fn unclosed(not_closed: NotClosed, input: &VehicleInput, passes: Vec<Pass>) -> Solution {
    let mut reason = not_closed.reason.clone();
    if let [first, .., last] = passes.as_slice() {
        // a vehicle closed before: the loads and heat shields that the passes asked for since have outgrown every diameter
        reason.push_str(&format!(
            " Pass 1 closed with {:.2} kg, pass {} with {:.2} kg: each vehicle asks for a heavier one, up to here.",
            first.mass_kg, last.number, last.mass_kg
        ));
    }
    Solution {
        outcome: Outcome::NotClosed,
        findings: misfit::findings(&not_closed, input),
        reason: Some(reason),
        flight: None,
        design: None,
        adjustments: Vec::new(),
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
        let flight = with_history(input, request, &body, flown.flight);
        let adjustments = vehicle.adjustments.clone();
        let last = passes.last();
        let reason = match outcome {
            Outcome::NotConverged | Outcome::GaveUp => {
                let which = match outcome {
                    Outcome::GaveUp => format!(
                        "after which the limit of work was reached, {MOST_WORK} evaluations of the equations of motion, a pass being {WORK_OF_PASS}"
                    ),
                    _ => "the last one allowed".to_string(),
                };
                let far = last.map_or(String::new(), |pass| match pass.mass_distance_kg {
                    Some(kg) => format!(", an estimated {kg:.3e} kg from where it settles"),
                    None => String::new(),
                });
                Some(format!(
                    "the mass had not settled in pass {}, {which}{far}",
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
            shoulder_heat_flux_w_m2: sized.stagnation.peak_heat_flux_w_m2
                * sized.off.heat_flux_ratio,
            shoulder_heat_load_j_m2: sized.stagnation.heat_load_j_m2 * sized.off.heat_load_ratio,
            shoulder_heat_flux_ratio: sized.off.heat_flux_ratio,
            forebody_judged: sized.environment,
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
            mass_residual_kg: last.and_then(|pass| pass.mass_distance_kg),
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
        let integrated = flown.flight.model == Model::ThreeDof;
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
        if input.mission.heating.body.is_none() {
            findings.extend(input.shoulder.findings(shoulder_ratio));
        }
        findings.push(sized.environment.judged(input.judged_at, &sized.off));
        if input.given.payload_temperature_k.is_none() {
            findings.extend(input.soak.findings(&sized.soak));
        }
        findings.extend(given::findings(input, vehicle, sized));
        findings.extend(vehicle.findings.iter().cloned());
        findings
    }
}
