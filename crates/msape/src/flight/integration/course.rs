//! Progress of one flight from step to step: the events that each step meets, and their consequences.
//!
//! ```text
//! end of a row, ground, exit, when slow      the step ends there on its dense output
//! all of them when fast, kink                the step is taken again so that it ends there
//! ```
//!
//! Beyond the end of a row the row continues smoothly, so that the dense output holds up to it at no cost, but it is
//! less accurate than a step: this is accepted once peaks and heat loads are behind. Across a kink nothing is smooth.
//!
//! # Valid
//! Range of [`super`].
//!
//! # References
//! - Own convention.

use super::gate::Gate;
use super::ladder::{Of, Rungs};
use super::marks::Marks;
use super::node::{Node, Place};
use super::watch::Energy;
use super::{Keep, Leg, Record};
use crate::flight::LANDED_WITHIN_M;
use crate::flight::motion::Motion;
use crate::flight::phase::Stage;
use crate::flight::reach::Span;
use crate::flight::sample::Loads;
use crate::outcome::Outcome;
use crate::planet::Gravity;
use numerics::ode::Step;
use numerics::scalar::{Scalar, Single};

/// Speed below which a step may end on its dense output, m/s.
const SLOW_M_S: f64 = 1_000.0;
/// A load below this fraction of its largest value is low.
const QUIET: f64 = 0.25;
/// Number of legs allocated at first.
const USUAL_LEGS: usize = 256;

/// A flight in progress.
pub(super) struct Course<'m, M, const N: usize, S> {
    pub(super) marks: &'m Marks,
    /// Motion before its first step, with which its record is read.
    pub first: M,
    /// Present motion: by the rows that hold, in its phase.
    pub motion: M,
    /// Record of the flight so far.
    pub record: Record<N, S>,
    /// Latest end of the next step, s.
    pub limit_s: S,
    /// Rows that hold and phase.
    pub(super) stage: Stage<S>,
    /// Position among the ends of rows.
    pub(super) rungs: Rungs,
    /// Time at which the parachute is full, s, where that is ahead.
    pub(super) full_s: Option<f64>,
    /// Whether each phase's value was passed before the phase was next in order.
    pub(super) passed: Vec<bool>,
    /// Energy so far, where it is checked.
    pub(super) energy: Energy,
    /// Altitude at the start, m.
    start_m: f64,
    /// Altitude above which the vehicle has left, m; `None` where gravity always brings it back.
    pub(super) exit_m: Option<f64>,
    /// Whether the flight has changed from falling to rising.
    pub(super) turned_up: bool,
    /// Present position of the integration.
    pub(super) here: Place,
    /// Event expected at the end of a step that ends at its limit.
    awaited: Option<Gate>,
    /// Largest value of each load so far: deceleration, dynamic pressure, convective and radiative heating.
    largest: [f64; 4],
    /// Whether the last step kept, and the state at its end, have low loads.
    quiet: [bool; 2],
}

/// Continuation of a flight after a step.
pub(super) enum Next<const N: usize, S> {
    /// From the present state.
    On,
    /// From the present state, with another right-hand side.
    Changed,
    /// From another instant and state.
    From(S, [S; N]),
    /// End of the flight.
    Over,
}

impl<'a, 'm, M: Motion<'a, N, S>, const N: usize, S: Single> Course<'m, M, N, S> {
    /// A flight that begins.
    pub fn new(marks: &'m Marks, mut motion: M, start: [S; N]) -> Self {
        let first = motion;
        let point = motion.point();
        let mission = point.mission;
        let local = mission.planet.local([start[0], start[1], start[2]]);
        let altitude_m = local.altitude_m.value();
        let exit_m = match mission.planet.gravity {
            Gravity::Zonal { .. } => Some(mission.planet.entry_interface_m.max(altitude_m)),
            Gravity::Uniform { .. } => None,
        };
        let rungs = Rungs::at(&marks.ladders, &motion.place(&start));
        let stage = Stage::about(rungs.amid());
        motion = motion.within(&stage.within);
        let (here, loads) = Node::of(&motion, S::constant(0.0), &start).lane(0);
        let mut course = Self {
            marks,
            first,
            motion,
            record: Record {
                start,
                start_stage: stage,
                start_loads: loads,
                legs: Vec::with_capacity(USUAL_LEGS),
                altitudes: Span::at(altitude_m),
                spans: vec![Span::EMPTY; marks.axes.len()],
                refused: None,
                pushed: None,
                begun: Vec::new(),
                exits: 0,
                outcome: Outcome::Stopped,
                reason: None,
                evaluations: 0,
            },
            limit_s: S::constant(marks.end_s),
            stage,
            rungs,
            full_s: None,
            passed: vec![false; mission.phases.len()],
            energy: Energy::UNKNOWN,
            start_m: altitude_m,
            exit_m,
            turned_up: false,
            here,
            awaited: None,
            largest: [0.0; 4],
            quiet: [false; 2],
        };
        course.look(S::constant(0.0), &start);
        course.is_unstable(&start);
        course
    }

    /// Whether the flight ends where it starts.
    pub fn is_over(&mut self) -> bool {
        if self.here.altitude_m <= self.marks.ground_m && self.here.climb_m_s < 0.0 {
            self.land();
            return true;
        }
        let refused = self.refused(S::constant(0.0), &self.record.start);
        if let Some(axis) = refused {
            self.refuse(axis);
        }
        refused.is_some()
    }

    /// Part of the fall that is done, 0 to 1.
    pub fn part_done(&self) -> f64 {
        let fall_m = (self.start_m - self.marks.ground_m).max(1.0);
        ((self.start_m - self.here.altitude_m) / fall_m).clamp(0.0, 1.0)
    }

    /// The record of the flight.
    pub fn into_record(self) -> Record<N, S> {
        self.record
    }

    /// Advances the flight by the step of a lane, which ends at a node.
    #[inline]
    pub fn advance<V: Scalar<Lane = S>>(
        &mut self,
        step: &Step<N, V>,
        node: &Node<V>,
        lane: usize,
    ) -> Next<N, S> {
        let end_s = step.t1.lane(lane).value();
        let (there, loads) = node.lane(lane);
        if self.marks.wind_energy_j_kg.is_some() && self.is_unstable(&step.lane(lane).y1) {
            // The step is not kept: its numbers are not those of a flight.
            return self.blow_up();
        }
        if let Some(gate) = self.awaited {
            // The step was restarted to end at the gate; the integrator may still divide it.
            if end_s < self.limit_s.value() {
                self.add_lane(step, lane, there, loads);
                return Next::On;
            }
            self.awaited = None;
            self.limit_s = S::constant(self.marks.end_s);
            return self.arrive(gate, step.lane(lane), there, loads);
        }
        if !self.is_watched() && self.is_clear(&there) {
            self.add_lane(step, lane, there, loads);
            if end_s >= self.marks.end_s {
                return self.run_out();
            }
            return Next::On;
        }
        self.stopped(step.lane(lane), there, loads)
    }

    /// Continues the flight from the end of a step that was repeated to end at a gate.
    fn arrive(
        &mut self,
        gate: Gate,
        step: Step<N, S>,
        there: Place,
        loads: Loads<S>,
    ) -> Next<N, S> {
        let above_m = there.altitude_m - self.marks.ground_m;
        if gate != Gate::Ground || above_m.abs() <= LANDED_WITHIN_M {
            self.add(step, there, loads);
            return self.pass(gate);
        }
        // The dense output, which predicted the end, is less exact than the step.
        if above_m > 0.0 {
            self.add(step, there, loads);
            return Next::On;
        }
        let span = [step.t0.value(), step.t1.value()];
        let t = self.reaches(&step, span, self.marks.ground_m);
        self.cut(step, t, gate)
    }

    /// Ends a step at the instant at which it passes a gate.
    fn cut(&mut self, step: Step<N, S>, t: S, gate: Gate) -> Next<N, S> {
        let step = step.cut(t);
        let (t1, y1) = (step.t1, step.y1);
        let (there, loads) = Node::of(&self.motion, t1, &y1).lane(0);
        self.add(step, there, loads);
        match self.pass(gate) {
            Next::Over => Next::Over,
            _ => Next::From(t1, y1),
        }
    }

    /// Continues the flight after a step that may meet a gate.
    fn stopped(&mut self, step: Step<N, S>, there: Place, loads: Loads<S>) -> Next<N, S> {
        let end_s = step.t1.value();
        let Some((t, gate)) = self.first_gate(&step, there) else {
            self.add(step, there, loads);
            if end_s >= self.marks.end_s {
                return self.run_out();
            }
            return Next::On;
        };
        if t.value() <= step.t0.value() {
            // The step began on the boundary: it is repeated from there, on the other side.
            let (t0, y0) = (step.t0, step.y0);
            return match self.pass(gate) {
                Next::Over => Next::Over,
                _ => Next::From(t0, y0),
            };
        }
        if t.value() >= end_s {
            self.add(step, there, loads);
            return self.pass(gate);
        }
        let smooth = match gate {
            Gate::Row(Of::Mach, _) => self.marks.holds_drag,
            Gate::Full | Gate::Phase => false,
            _ => true,
        };
        let at_once = matches!(gate, Gate::Refused(_)) || smooth && there.speed_m_s <= SLOW_M_S;
        if at_once {
            return self.cut(step, t, gate);
        }
        self.awaited = Some(gate);
        self.limit_s = t;
        Next::From(step.t0, step.y0)
    }

    /// Records the step of a lane.
    #[inline]
    fn add_lane<V: Scalar<Lane = S>>(
        &mut self,
        step: &Step<N, V>,
        lane: usize,
        there: Place,
        loads: Loads<S>,
    ) {
        if self.is_watched() || self.marks.looks_along() {
            return self.add(step.lane(lane), there, loads);
        }
        self.here = there;
        let (t1, y1) = step.end_of_lane(lane);
        self.record.altitudes.take(there.altitude_m, t1.value());
        let passed_over = self.is_passed_over(&loads);
        match self.record.legs.last_mut() {
            Some(last) if passed_over => {
                last.step.draw_out(t1, y1);
                (last.stage, last.loads) = (self.stage, loads);
            }
            _ => self.keep(step.lane(lane), loads),
        }
    }

    #[inline]
    fn add(&mut self, step: Step<N, S>, there: Place, loads: Loads<S>) {
        self.here = there;
        let t_s = step.t1.value();
        self.record.altitudes.take(there.altitude_m, t_s);
        self.look_along(&step);
        self.look_ahead(&step);
        if self.is_passed_over(&loads) {
            self.record.legs.pop();
        }
        self.keep(step, loads);
    }

    #[inline]
    fn keep(&mut self, step: Step<N, S>, loads: Loads<S>) {
        let stage = self.stage;
        self.record.legs.push(Leg { step, stage, loads });
    }

    /// Whether a step that ends under these loads has low loads and follows another such step, so that only its end
    /// matters.
    #[inline]
    fn is_passed_over(&mut self, loads: &Loads<S>) -> bool {
        if self.marks.keep == Keep::All {
            return false;
        }
        let heat = &loads.heat_flux;
        let values = [
            loads.deceleration_earth_g,
            loads.dynamic_pressure_pa,
            heat.convective_w_m2,
            heat.radiative_w_m2,
        ];
        let mut quiet = true;
        for (largest, value) in self.largest.iter_mut().zip(values.map(S::value)) {
            *largest = largest.max(value);
            quiet &= value <= QUIET * *largest;
        }
        let [last_quiet, end_quiet] = self.quiet;
        self.quiet = [end_quiet && quiet, quiet];
        last_quiet && self.quiet[0]
    }

    /// The flight behind a gate.
    fn pass(&mut self, gate: Gate) -> Next<N, S> {
        match gate {
            Gate::Ground => {
                self.land();
                return Next::Over;
            }
            Gate::Exit => {
                let bound = self.energy_j_kg(&self.now().1) < 0.0;
                if bound && self.record.exits < self.marks.exits {
                    // Gravity brings the vehicle back: the next exit is the one after the next turn upward.
                    self.record.exits += 1;
                    self.turned_up = false;
                    return Next::On;
                }
                self.leave();
                return Next::Over;
            }
            Gate::Refused(axis) => {
                self.refuse(axis);
                return Next::Over;
            }
            Gate::Row(of, way) => {
                self.rungs.leave(&self.marks.ladders, of, way);
                self.stage.within = self.rungs.amid();
                self.motion = self.motion.within(&self.stage.within);
            }
            Gate::Phase => self.begin_phase(),
            Gate::Full => self.full_s = None,
        }
        Next::Changed
    }

    /// Whether no event can have occurred between the present place and another.
    #[inline]
    fn is_clear(&self, there: &Place) -> bool {
        let level = (self.here.climb_m_s < 0.0) == (there.climb_m_s < 0.0);
        let inside = self.exit_m.is_none_or(|exit_m| there.altitude_m <= exit_m);
        level && inside && there.altitude_m >= self.marks.ground_m && self.rungs.hold(there)
    }

    /// Time and state at the present position.
    pub(super) fn now(&self) -> (S, [S; N]) {
        let zero = S::constant(0.0);
        (self.record.legs.last())
            .map_or((zero, self.record.start), |leg| (leg.step.t1, leg.step.y1))
    }
}
