//! The passes of one design: Gauss-Seidel over the modules, accelerated; closed-form flight first, integrated flight near convergence.
//!
//! ```text
//! x ← x − Σ γⱼ Δxⱼ + ω (f(x) − x − Σ γⱼ Δrⱼ)      until |Σ γⱼ ΔMⱼ| + u s < criterion
//! answer: the vehicle of f(x) with the flight of the vehicle of x
//! ```
//!
//! with x the entry load, stagnation pressure, speed at impact and both heat-shield thicknesses; f runs through geometry,
//! mass, impact and structure, then flight, heating, soak and heat shield; ω the relaxation, M the entry mass in kg, Δ the
//! last two steps and γ their weights ([`numerics::fixed_point`]). Σ γⱼ ΔMⱼ is the distance of the mass from its fixed point
//! estimated from the last steps; u is the largest part of a coupling number that they leave unexplained, s the steepest
//! change of the mass with such a part in these steps.
//!
//! The answer's walls, foam and heat shields are made for the flight that it prints. That flight was flown by the vehicle
//! before, whose mass differs by less than the criterion: the only place where the answer combines two passes.
//!
//! They begin with the guesses of the input, or with numbers that earlier ones found. Steps are remembered separately for vehicles
//! of the requested diameter and for those that had to grow: where growth begins f has a kink.
//!
//! # References
//! - \[samareh-2014\] section 2.2, steps 4 to 12; \[anderson-1965\].

use super::Pass;
use super::crossings::{CROSSINGS, Crossed};
use super::flown::Flown;
use super::inputs::DesignInput;
use super::sized::Sized;
use super::start::{Memories, Numbers, Start};
use crate::flight::mission::{Body, Model};
use crate::outcome::Outcome;
use crate::progress::Progress;
use crate::vehicle::{self, NotClosed, Vehicle, VehicleInput};
use numerics::fixed_point::Anderson;
use std::borrow::Cow;

/// Relative change of the mass in a pass below which the integrated flight replaces the closed form; assumed.
const HIGH_FIDELITY_BELOW: f64 = 0.05;

/// Accuracy of a flight, as a fraction of the relative mass criterion, assumed: the numbers of a pass scatter by as much.
const FLIGHT_PART: f64 = 0.05;
/// Smallest tolerance of a flight, assumed: below it rounding limits the steps.
const FINEST_TOLERANCE: f64 = 1e-10;

/// Work after which a design is given up, in evaluations of the equations of motion, assumed: the default of twenty passes, each with
/// a flight of the classical method at its own limit, is 16 million.
pub(super) const MOST_WORK: u64 = 20_000_000;
/// Work of a pass in addition to its flight, in evaluations, assumed: geometry, masses and heat shields.
pub(super) const WORK_OF_PASS: u64 = 10_000;

/// Work of all passes of a design, in evaluations of the equations of motion, with their observer.
pub(super) struct Work<'a> {
    done: u64,
    most: u64,
    passes: u32,
    progress: &'a mut dyn Progress,
    is_stopped: bool,
}

/// Passes after which progress is reported as one half, assumed: the number needed is not known before.
const HALF_DONE: f64 = 5.0;

impl<'a> Work<'a> {
    /// No work done yet, with an upper limit.
    pub(super) fn up_to(most: u64, progress: &'a mut dyn Progress) -> Work<'a> {
        Work {
            done: 0,
            most,
            passes: 0,
            progress,
            is_stopped: false,
        }
    }

    /// The work done, with an additional allowance.
    #[cfg(test)]
    pub(super) fn with_limit(self, more: u64) -> Work<'a> {
        Work {
            most: self.done.saturating_add(more),
            ..self
        }
    }

    /// Records a pass and reports it to the observer.
    fn add(&mut self, evaluations: u64) {
        self.done += WORK_OF_PASS + evaluations;
        self.passes += 1;
        let passes = f64::from(self.passes);
        let told = self.progress.advance(passes / (passes + HALF_DONE));
        self.is_stopped |= told.is_break();
    }

    /// Whether the limit is reached, or the observer has stopped the passes.
    pub(super) fn is_spent(&self) -> bool {
        self.is_stopped || self.done >= self.most
    }

    /// Reason to stop the passes, if there is one.
    pub(super) fn end(&self) -> Option<Cut> {
        match self.is_stopped {
            true => Some(Cut::Stopped),
            false => self.is_spent().then_some(Cut::Work(self.most)),
        }
    }
}

/// Reason why passes were cut short.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Cut {
    /// The limit of work was reached, in evaluations of the equations of motion.
    Work(u64),
    /// The caller stopped the passes.
    Stopped,
}

impl Cut {
    /// The reason as part of a sentence.
    pub(super) fn reason(self) -> String {
        match self {
            Cut::Work(most) => format!(
                "the limit of work was reached, {most} evaluations of the equations of motion, a pass being {WORK_OF_PASS}"
            ),
            Cut::Stopped => "it was stopped".to_string(),
        }
    }
}

/// Passes and how they ended.
#[derive(Debug)]
pub(super) struct Run<'a> {
    /// The input, its flights integrated as finely as its mass criterion asks.
    pub(super) input: Cow<'a, DesignInput>,
    pub(super) passes: Vec<Pass>,
    pub(super) memories: Memories,
    pub(super) end: End,
}

impl Run<'_> {
    /// This run with an owned input.
    pub(super) fn into_owned(self) -> Run<'static> {
        Run {
            input: Cow::Owned(self.input.into_owned()),
            passes: self.passes,
            memories: self.memories,
            end: self.end,
        }
    }

    /// Start for the passes of a neighbor; `None` if these passes did not converge.
    pub(super) fn start(&self) -> Option<Start> {
        let numbers = self.converged()?.numbers();
        let mut memories = self.memories.clone();
        memories.iter_mut().for_each(Anderson::change_function);
        Some(Start { numbers, memories })
    }

    /// Vehicle to which the passes converged.
    pub(super) fn converged(&self) -> Option<&Made> {
        match &self.end {
            End::Vehicle(made) if made.outcome == Outcome::Converged => Some(made),
            _ => None,
        }
    }
}

/// How passes ended.
#[derive(Debug)]
pub(super) enum End {
    /// A vehicle was designed for its flight, converged or not.
    Vehicle(Box<Made>),
    /// The flight leaves the atmosphere or a table, or was given up.
    Departed { body: Body, flown: Box<Flown> },
    /// No vehicle closes for these numbers.
    Unclosed(NotClosed, Box<VehicleInput>),
}

/// A vehicle, the flight that it was made for, and the body that flew it.
#[derive(Debug)]
pub(super) struct Made {
    pub(super) vehicle: Vehicle,
    pub(super) body: Body,
    pub(super) flown: Flown,
    pub(super) sized: Sized,
    pub(super) outcome: Outcome,
}

impl Made {
    /// Coupling numbers of the vehicle.
    pub(super) fn numbers(&self) -> Numbers {
        found(&self.flown, &self.sized)
    }
}

/// Where passes begin and when they are cut short.
#[derive(Clone, Copy, Default)]
pub(super) struct Way<'a> {
    /// Numbers of the first pass; the guesses of the input if absent.
    pub(super) from: Option<Numbers>,
    /// Memory of the acceleration from the passes of a neighbor.
    pub(super) taught: Option<&'a Memories>,
    /// Largest mass of an acceptable vehicle of the requested diameter, kg: passes that lead to another vehicle are cut short.
    pub(super) as_asked_below_kg: Option<f64>,
}

/// Runs passes; `work` is what was done before, and grows.
pub(super) fn run<'a>(input: &'a DesignInput, way: Way, work: &mut Work) -> Run<'a> {
    let mut input = Cow::Borrowed(input);
    let mut vehicle_input = input.vehicle.clone();
    let mut body_before: Option<Body> = None;
    let mut passes: Vec<Pass> = Vec::new();
    let mut model = Model::AllenEggers;
    if let Some(numbers) = way.from {
        take(&mut vehicle_input, numbers);
    }
    // a step beyond the result of a pass may lead to where no vehicle closes: only the acceleration goes further
    let mut memories = way.taught.cloned().unwrap_or_else(|| {
        let memory = Anderson::new(input.relaxation.min(1.0));
        [memory.clone(), memory]
    });
    let mut next_damped: Option<Numbers> = None;
    let end = loop {
        let number = passes.len() as u32 + 1;
        let damped = next_damped.take();
        let vehicle = match (vehicle::build(&vehicle_input), damped) {
            (Ok(vehicle), _) => vehicle,
            // the acceleration may lead where no vehicle closes though a plain pass does not
            (Err(_), Some(damped)) => {
                memories.iter_mut().for_each(Anderson::forget);
                take(&mut vehicle_input, damped);
                continue;
            }
            (Err(not_closed), None) => {
                break End::Unclosed(not_closed, Box::new(vehicle_input));
            }
        };
        let grown = vehicle.dimensions.diameter_m > vehicle_input.diameter_m;
        if let (true, Some(damped), Some(_)) = (grown, damped, way.as_asked_below_kg) {
            take(&mut vehicle_input, damped);
            continue;
        }
        let mass_kg = vehicle.mass.mass_kg;
        let mass_before_kg = passes.last().map(|pass| pass.mass_kg);
        let change_kg = mass_before_kg.map(|before| mass_kg - before);
        if model != input.mission.solver.model
            && (way.from.is_some()
                || change_kg.is_some_and(|change| change.abs() < HIGH_FIDELITY_BELOW * mass_kg))
        {
            model = input.mission.solver.model;
            memories.iter_mut().for_each(Anderson::change_function);
            let enough = (FLIGHT_PART * input.mass_criterion_kg / mass_kg).max(FINEST_TOLERANCE);
            // the flights of a small criterion are integrated more finely
            if enough < input.mission.solver.tolerance {
                input.to_mut().mission.solver.tolerance = enough;
            }
        }
        let body = input.body(&vehicle, body_before.take());
        let mut flown = Flown::fly(&input, &body, model);
        let sized = Sized::new(&input, &vehicle, &flown);
        if let Some(name) = sized.not_finite() {
            flown.give_up(name);
        }
        work.add(flown.flight.evaluations);
        let found = found(&flown, &sized);
        let proposal = memories[usize::from(grown)].propose(taken(&vehicle_input), found, mass_kg);
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
        if flown.outcome == Outcome::GaveUp || high_fidelity && !flown.came_down {
            let flown = Box::new(flown);
            break End::Departed { body, flown };
        }
        if number > 1
            && way
                .as_asked_below_kg
                .is_some_and(|most_kg| grown || high_fidelity && mass_kg >= most_kg)
        {
            break End::Vehicle(Box::new(Made {
                vehicle,
                body,
                flown,
                sized,
                outcome: Outcome::NotConverged,
            }));
        }
        let near = |kg: f64| kg.abs() < input.mass_criterion_kg;
        let settled = high_fidelity && same_model && distance_kg.is_some_and(near);
        let is_last = number >= input.max_iterations || work.is_spent();
        if settled || is_last {
            take(&mut vehicle_input, found);
            let closing = match vehicle::build(&vehicle_input) {
                Ok(closing) => closing,
                Err(not_closed) => {
                    break End::Unclosed(not_closed, Box::new(vehicle_input));
                }
            };
            let settled = settled && near(closing.mass.mass_kg - mass_kg);
            if settled || is_last {
                if let Some(last) = passes.last_mut() {
                    last.crossings = crossings(&closing, &flown, &sized);
                    last.mass_kg = closing.mass.mass_kg;
                    last.mass_change_kg = mass_before_kg.map(|before| last.mass_kg - before);
                }
                let outcome = if settled {
                    Outcome::Converged
                } else if work.is_spent() {
                    Outcome::GaveUp
                } else {
                    Outcome::NotConverged
                };
                break End::Vehicle(Box::new(Made {
                    vehicle: closing,
                    body,
                    flown,
                    sized,
                    outcome,
                }));
            }
        }
        // the first pass replaces the guesses
        let guessed = number == 1 && way.taught.is_none();
        let next = if guessed { found } else { proposal.next };
        next_damped = (!guessed && next != proposal.damped).then_some(proposal.damped);
        take(&mut vehicle_input, next);
        body_before = Some(body);
    };
    Run {
        input,
        passes,
        memories,
        end,
    }
}

/// The coupling numbers of a vehicle.
fn taken(vehicle: &VehicleInput) -> Numbers {
    [
        vehicle.loads.entry_load_earth_g,
        vehicle.loads.peak_stagnation_pressure_pa,
        vehicle.loads.terminal_speed_m_s,
        vehicle.forebody.tps_thickness_m,
        vehicle.aftbody_tps_thickness_m,
    ]
}

/// Replaces the coupling numbers of a vehicle.
pub(super) fn take(vehicle: &mut VehicleInput, numbers: Numbers) {
    [
        vehicle.loads.entry_load_earth_g,
        vehicle.loads.peak_stagnation_pressure_pa,
        vehicle.loads.terminal_speed_m_s,
        vehicle.forebody.tps_thickness_m,
        vehicle.aftbody_tps_thickness_m,
    ] = numbers;
}

/// The coupling numbers that a pass finds.
fn found(flown: &Flown, sized: &Sized) -> Numbers {
    [
        flown.flight.peak_deceleration_earth_g.value,
        flown.flight.peak_stagnation_pressure_pa.value,
        flown.impact_speed_m_s,
        sized.forebody.thickness_m,
        sized.aftbody.thickness_m,
    ]
}

/// Values of [`CROSSINGS`] in one pass.
fn crossings(vehicle: &Vehicle, flown: &Flown, sized: &Sized) -> [f64; CROSSINGS.len()] {
    let pass = Crossed {
        vehicle,
        flown,
        sized,
    };
    pass.values()
}
