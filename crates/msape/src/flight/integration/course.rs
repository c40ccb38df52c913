//! The course of one flight from step to step: what each step runs into, and what follows.
//!
//! ```text
//! boundary of the atmosphere, ground, way out   the step ends there on its dense output
//! kink of heating or drag, end of radiation     the step is taken again so that it ends there
//! ```
//!
//! Beyond a boundary the formula of the piece goes on smoothly, so that the dense output holds up to it at no cost; across a
//! kink nothing is smooth.
//!
//! # Valid
//! As [`super`].
//!
//! # References
//! - Own convention.

use super::gate::Gate;
use super::node::{Node, Place};
use super::{Leg, Record};
use crate::aero::DragTable;
use crate::flight::motion::Motion;
use crate::heating::Radiation;
use crate::outcome::Outcome;
use crate::planet::Gravity;
use crate::flight::sample::Loads;
use numerics::ode::{OdeError, Step};
use numerics::scalar::Single;

/// Longest flight, s: 30 days.
const LONGEST_FLIGHT_S: f64 = 30.0 * 86_400.0;
/// Nothing falls deeper, m.
const DEEPEST_M: f64 = -5_000.0;
/// Below this Mach number the rows of a drag table no longer matter to peaks and heat loads.
const KINKS_FROM_MACH: f64 = 3.0;
/// Legs for which there is room at first.
const USUAL_LEGS: usize = 256;

/// What flights through the same air may run into.
#[derive(Clone, Debug)]
pub(super) struct Marks {
    /// Speeds at which a heating relation has a kink, m/s, ascending.
    pub kinks_m_s: Vec<f64>,
    /// Speed below which radiative heating is nothing, m/s.
    pub onset_m_s: Option<f64>,
    /// Mach numbers of the rows of the drag table, ascending, from [`KINKS_FROM_MACH`] on.
    pub kinks_mach: Vec<f64>,
    /// Altitude that ends a fall, m.
    pub ground_m: f64,
    /// Time that ends a flight, s.
    pub end_s: f64,
}

impl Marks {
    /// The marks of a motion.
    pub fn of<'a, M: Motion<'a, N, S>, const N: usize, S: Single>(motion: &M) -> Self {
        let mission = motion.point().mission;
        let heating = &mission.heating;
        let mut kinks_m_s = heating.radiative.kinks_m_s();
        kinks_m_s.extend(heating.convective.kink_m_s());
        kinks_m_s.sort_by(f64::total_cmp);
        let rows = motion.drag_table().into_iter().flat_map(DragTable::rows);
        Self {
            kinks_m_s,
            onset_m_s: heating.radiative.onset_m_s(),
            kinks_mach: rows
                .map(|(mach, _)| mach)
                .filter(|mach| *mach >= KINKS_FROM_MACH)
                .collect(),
            ground_m: mission.stop.altitude_m.unwrap_or(DEEPEST_M),
            end_s: mission.stop.time_s.unwrap_or(LONGEST_FLIGHT_S),
        }
    }
}

/// A flight under way.
pub(super) struct Course<'m, M, const N: usize, S> {
    pub(super) marks: &'m Marks,
    /// The motion as it is now: in its piece of the atmosphere, with or without radiation.
    pub motion: M,
    /// What has been flown.
    pub record: Record<N, S>,
    /// Where the next step must end at the latest, s.
    pub limit_s: f64,
    /// Index of the piece of the atmosphere.
    pub(super) layer: usize,
    /// Altitude above which the vehicle has left, m; none where gravity always brings it back.
    pub(super) exit_m: Option<f64>,
    /// Whether the flight has turned from falling to rising.
    pub(super) turned_up: bool,
    /// Where the integration stands.
    pub(super) here: Place,
    /// What the step that ends at the limit runs into.
    awaited: Option<Gate>,
}

/// How a flight goes on after a step.
pub(super) enum Next<const N: usize, S> {
    /// As it stands.
    On,
    /// As it stands, under another right-hand side.
    Changed,
    /// From another instant and state.
    From(S, [S; N]),
    /// No further.
    Over,
}

impl<'a, 'm, M: Motion<'a, N, S>, const N: usize, S: Single> Course<'m, M, N, S> {
    /// A flight that begins.
    pub fn new(marks: &'m Marks, mut motion: M, start: [S; N]) -> Self {
        let point = motion.point();
        let mission = point.mission;
        let local = mission.planet.local([start[0], start[1], start[2]]);
        let altitude_m = local.altitude_m.value();
        let layer = mission.atmosphere.layer(altitude_m);
        let exit_m = match mission.planet.gravity {
            Gravity::Zonal { .. } => Some(mission.planet.entry_interface_m.max(altitude_m)),
            Gravity::Uniform { .. } => None,
        };
        motion = motion.in_layer(layer);
        if let Some(onset_m_s) = marks.onset_m_s {
            motion.point_mut().radiation = match speed_m_s(&start).value() > onset_m_s {
                true => Radiation::continued(onset_m_s),
                false => Radiation::over(),
            };
        }
        let (here, loads) = Node::of(&motion, S::constant(0.0), &start).lane(0);
        Self {
            marks,
            motion,
            record: Record {
                start,
                start_layer: layer,
                start_loads: loads,
                legs: Vec::with_capacity(USUAL_LEGS),
                outcome: Outcome::Stopped,
                reason: None,
                evaluations: 0,
            },
            limit_s: marks.end_s,
            layer,
            exit_m,
            turned_up: false,
            here,
            awaited: None,
        }
    }

    /// Whether the flight ends where it starts.
    pub fn is_over(&mut self) -> bool {
        let over = self.here.altitude_m <= self.marks.ground_m && self.here.climb_m_s < 0.0;
        if over {
            self.land();
        }
        over
    }

    /// What has been flown.
    pub fn into_record(self) -> Record<N, S> {
        self.record
    }

    /// The flight after a step, at whose end it is `there`, under the loads there.
    #[inline]
    pub fn advance(&mut self, step: Step<N, S>, (there, loads): &(Place, Loads<S>)) -> Next<N, S> {
        if let Some(gate) = self.awaited {
            // The step was begun again to end at the gate; a part of it may come first.
            let end = step.t1;
            self.add(step, *there, *loads);
            if end.value() < self.limit_s {
                return Next::On;
            }
            self.awaited = None;
            self.limit_s = self.marks.end_s;
            return self.pass(gate);
        }
        let Some((t, gate)) = self.first_gate(&step, *there) else {
            let end = step.t1;
            self.add(step, *there, *loads);
            if end.value() >= self.marks.end_s {
                return self.run_out();
            }
            return Next::On;
        };
        if t.value() <= step.t0.value() {
            // The step began on the boundary: it is taken anew from there, on the other side.
            let (t0, y0) = (step.t0, step.y0);
            return match self.pass(gate) {
                Next::Over => Next::Over,
                _ => Next::From(t0, y0),
            };
        }
        if t.value() >= step.t1.value() {
            self.add(step, *there, *loads);
            return self.pass(gate);
        }
        if matches!(gate, Gate::Kink | Gate::Onset) {
            self.awaited = Some(gate);
            self.limit_s = t.value();
            return Next::From(step.t0, step.y0);
        }
        let step = step.cut(t);
        let (t1, y1) = (step.t1, step.y1);
        let (there, loads) = Node::of(&self.motion, t1, &y1).lane(0);
        self.add(step, there, loads);
        match self.pass(gate) {
            Next::Over => Next::Over,
            _ => Next::From(t1, y1),
        }
    }

    fn add(&mut self, step: Step<N, S>, there: Place, loads: Loads<S>) {
        self.here = there;
        self.record.legs.push(Leg {
            step,
            layer: self.layer,
            loads,
        });
    }

    /// The flight behind a gate.
    fn pass(&mut self, gate: Gate) -> Next<N, S> {
        match gate {
            Gate::Ground => {
                self.land();
                return Next::Over;
            }
            Gate::Exit => {
                self.leave();
                return Next::Over;
            }
            Gate::Floor => self.enter(self.layer.saturating_sub(1)),
            Gate::Ceiling => self.enter(self.layer + 1),
            Gate::Onset => self.motion.point_mut().radiation = Radiation::over(),
            Gate::Kink => return Next::On,
        }
        Next::Changed
    }

    fn enter(&mut self, layer: usize) {
        self.layer = layer;
        self.motion = self.motion.in_layer(layer);
    }

    /// The state at which the integration stands.
    fn state(&self) -> [S; N] {
        (self.record.legs.last()).map_or(self.record.start, |leg| leg.step.y1)
    }

    fn land(&mut self) {
        let (outcome, reason) = match self.motion.point().mission.stop.altitude_m {
            Some(altitude_m) if altitude_m > 0.0 => (Outcome::Stopped, None),
            Some(_) => (Outcome::Landed, None),
            None => (
                Outcome::Landed,
                Some(format!("fell to {DEEPEST_M} m, below any ground")),
            ),
        };
        (self.record.outcome, self.record.reason) = (outcome, reason);
    }

    fn leave(&mut self) {
        let exit_km = self.exit_m.unwrap_or_default() / 1e3;
        let bound = self.energy_j_kg(&self.state()) < 0.0;
        let (outcome, orbit) = match bound {
            true => (Outcome::Captured, "on a bound orbit"),
            false => (Outcome::SkippedOut, "faster than escape speed"),
        };
        self.record.outcome = outcome;
        self.record.reason = Some(format!("rose through {exit_km:.0} km again, {orbit}"));
    }

    fn run_out(&mut self) -> Next<N, S> {
        let unasked = self.motion.point().mission.stop.time_s.is_none();
        self.record.reason = unasked.then(|| "still in flight after 30 days".to_string());
        Next::Over
    }

    /// Ends a flight that cannot be integrated further.
    pub fn give_up(&mut self, fault: &OdeError) {
        self.record.reason = Some(format!("the integration was given up: {fault}"));
    }

    /// Energy of the inertial motion over mass, J/kg; negative on a bound orbit.
    pub(super) fn energy_j_kg(&self, y: &[S; N]) -> f64 {
        let planet = &self.motion.point().mission.planet;
        let Gravity::Zonal { mu_m3_s2, .. } = planet.gravity else {
            return -1.0;
        };
        let [x, y, z, vx, vy, vz] = [y[0], y[1], y[2], y[3], y[4], y[5]].map(S::value);
        let omega = planet.rotation_rate_rad_s;
        let (vx, vy) = (vx - omega * y, vy + omega * x);
        let radius_m = (x * x + y * y + z * z).sqrt();
        0.5 * (vx * vx + vy * vy + vz * vz) - mu_m3_s2 / radius_m
    }
}

/// Speed relative to the planet, m/s.
#[inline]
pub(super) fn speed_m_s<const N: usize, S: Single>(y: &[S; N]) -> S {
    (y[3] * y[3] + y[4] * y[4] + y[5] * y[5]).sqrt()
}
