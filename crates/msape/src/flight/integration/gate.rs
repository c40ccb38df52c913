//! Gates, at which a step ends early: ends of rows of tables, the ground, the exit from the atmosphere, phases.
//!
//! ```text
//! g(t) = 0 on the dense output, on parts of the step where the altitude only rises or falls
//! ```
//!
//! with g an altitude less a level, m, or the argument of a row over its end, less one.
//!
//! # Valid
//! Steps in which the vertical speed changes its sign at most once. A row of speed or Mach number is left where the end of a step
//! is beyond it; one that is left and entered again within a step goes on.
//!
//! # References
//! - [`numerics::ode::event`].

use super::course::Course;
use super::ladder::{Of, Way};
use super::node::Place;
use crate::flight::equations::{Equations, Surroundings};
use crate::flight::motion::{Motion, head};
use numerics::ode::Step;
use numerics::ode::event::root_between;
use numerics::scalar::Single;

/// Tolerance of the time of a gate, as a fraction of the step.
const TOLERANCE: f64 = 1e-12;

/// Event at which a step leaves a row of a table, or the flight ends.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Gate {
    /// Leaves the row of a table.
    Row(Of, Way),
    /// Falls through the altitude that ends the flight.
    Ground,
    /// Rises out of the atmosphere.
    Exit,
    /// Begins the next phase.
    Phase,
    /// Fills the parachute.
    Full,
    /// Leaves a table of the case, at this axis, where the case refuses to continue.
    Refused(usize),
}

impl<'a, M: Motion<'a, N, S>, const N: usize, S: Single> Course<'_, M, N, S> {
    /// The first gate that a step passes, and its time.
    pub(super) fn first_gate(&mut self, step: &Step<N, S>, there: Place) -> Option<(S, Gate)> {
        let ends = [step.t0.value(), step.t1.value()];
        let falls = [self.here.climb_m_s < 0.0, there.climb_m_s < 0.0];
        let found = if falls[0] == falls[1] {
            let ends_m = [self.here.altitude_m, there.altitude_m];
            self.gate_in(step, ends, ends_m)
        } else {
            let climb = |y: &[S; N]| self.climb_m_s(y);
            let t_turn = self.when(step, ends, climb).value();
            let turn_m = self.altitude_m(&step.at(step.time(t_turn))).value();
            let before = self.gate_in(step, [ends[0], t_turn], [self.here.altitude_m, turn_m]);
            self.turned_up |= falls[0];
            before.or_else(|| {
                let ends_m = [turn_m, there.altitude_m];
                self.gate_in(step, [t_turn, ends[1]], ends_m)
            })
        };
        let refused = self.refused_in(step);
        let kinks = [
            self.row_in(step, Of::Speed, there.speed_m_s, |_, around| {
                around.air_speed_m_s
            }),
            self.row_in(step, Of::Mach, there.mach, |point, around| {
                around.air_speed_m_s / point.sound_m_s(around.altitude_m)
            }),
            self.phase_in(step),
            self.filled_in(step),
            refused.map(|(t, axis)| (t, Gate::Refused(axis))),
        ];
        kinks
            .into_iter()
            .flatten()
            .fold(found, |first, kink| match first {
                Some(gate) if gate.0.value() <= kink.0.value() => Some(gate),
                _ => Some(kink),
            })
    }

    /// The gate at which a step leaves a row of drag or heating, chosen by `argument`, and its time.
    fn row_in(
        &self,
        step: &Step<N, S>,
        of: Of,
        there: f64,
        argument: impl Fn(&Equations<S>, &Surroundings<S>) -> S,
    ) -> Option<(S, Gate)> {
        let [low, high] = self.rungs.ends(of);
        let (level, way) = match there {
            there if there < low => (low, Way::Down),
            there if there > high => (high, Way::Up),
            _ => return None,
        };
        let part = |y: &[S; N]| {
            let point = self.motion.point();
            argument(point, &point.surroundings(&head(y))) / level - 1.0
        };
        let before = part(&step.y0).value();
        let beyond = match way {
            Way::Down => before <= 0.0,
            Way::Up => before >= 0.0,
        };
        let t = match beyond {
            true => step.t0,
            false => self.when(step, [step.t0.value(), step.t1.value()], part),
        };
        Some((t, Gate::Row(of, way)))
    }

    /// The gate in a part of a step in which the altitude only rises or only falls.
    fn gate_in(
        &self,
        step: &Step<N, S>,
        span: [f64; 2],
        [start_m, end_m]: [f64; 2],
    ) -> Option<(S, Gate)> {
        let [floor_m, ceiling_m] = self.rungs.ends(Of::Altitude);
        if span[0] >= span[1] {
            return None;
        }
        if end_m < start_m {
            let (level_m, gate) = match floor_m > self.marks.ground_m {
                true => (floor_m, Gate::Row(Of::Altitude, Way::Down)),
                false => (self.marks.ground_m, Gate::Ground),
            };
            if gate == Gate::Ground && start_m < level_m {
                // The vehicle was below the ground, climbed and now falls: it will not rise above it any more.
                return Some((step.time(span[0]), gate));
            }
            let below = end_m < level_m;
            return below.then(|| (self.reaches(step, span, level_m), gate));
        }
        let leaves =
            |exit_m: &f64| end_m > *exit_m && (self.turned_up || self.energy_j_kg(&step.y1) >= 0.0);
        let exit_m = self.exit_m.filter(leaves);
        let (level_m, gate) = match exit_m {
            Some(exit_m) if exit_m <= ceiling_m => (exit_m, Gate::Exit),
            _ => (ceiling_m, Gate::Row(Of::Altitude, Way::Up)),
        };
        (end_m > level_m).then(|| (self.reaches(step, span, level_m), gate))
    }

    pub(super) fn reaches(&self, step: &Step<N, S>, span: [f64; 2], level_m: f64) -> S {
        self.when(step, span, |y| self.altitude_m(y) - level_m)
    }

    /// When `g` is zero between two instants of a step at which its signs differ, on their later side; the later one where
    /// they do not.
    fn when(&self, step: &Step<N, S>, span: [f64; 2], g: impl Fn(&[S; N]) -> S) -> S {
        self.when_at(step, span, |y, _| g(y))
    }

    /// Time of a zero as in `when`, for a quantity that also depends on the time.
    pub(super) fn when_at(
        &self,
        step: &Step<N, S>,
        span: [f64; 2],
        g: impl Fn(&[S; N], S) -> S,
    ) -> S {
        let along = |t: S| g(&step.at(t), t);
        let tolerance = TOLERANCE * (step.t1 - step.t0).value();
        root_between(step, along, span, tolerance).unwrap_or(step.time(span[1]))
    }

    fn altitude_m(&self, y: &[S; N]) -> S {
        let ellipsoid = self.motion.point().ellipsoid;
        ellipsoid.local([y[0], y[1], y[2]]).altitude_m
    }

    fn climb_m_s(&self, y: &[S; N]) -> S {
        let [u, v, w] = self.motion.point().ellipsoid.local([y[0], y[1], y[2]]).up;
        y[3] * u + y[4] * v + y[5] * w
    }
}
