//! Where a step ends before its time: boundaries of the atmosphere, the ground, the way out, kinks of heating and drag.
//!
//! ```text
//! g(t) = 0 on the dense output, on parts of the step where the altitude only rises or falls
//! ```
//!
//! with g an altitude less a level, m, or a speed less a level, m/s.
//!
//! # Valid
//! Steps in which the vertical speed changes its sign once at most.
//!
//! # References
//! - [`numerics::ode::event`].

use super::course::{Course, speed_m_s};
use super::node::Place;
use crate::flight::motion::{Motion, head};
use crate::flight::sample;
use crate::heating::Radiation;
use numerics::ode::Step;
use numerics::ode::event::root_between;
use numerics::scalar::{Mask, Single};

/// A gate is met within this part of a step.
const TOLERANCE: f64 = 1e-12;
/// A gate that was met within this speed is behind, m/s.
pub(super) const BEHIND_M_S: f64 = 1e-2;
/// The same for a row of the drag table, as a part of its Mach number.
pub(super) const BEHIND_MACH: f64 = 1e-6;

/// Where a step leaves the piece of the atmosphere, or the flight ends.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Gate {
    /// Falls into the piece below.
    Floor,
    /// Rises into the piece above.
    Ceiling,
    /// Falls through the altitude that ends the flight.
    Ground,
    /// Rises out of the atmosphere.
    Exit,
    /// Slows down to where radiative heating ends at once.
    Onset,
    /// Slows down to a kink of heating or drag.
    Kink,
    /// Begins the next phase.
    Phase,
    /// Fills the parachute.
    Full,
    /// Leaves a table of the case, of which this is the axis, where the case refuses to go on.
    Refused(usize),
}

impl<'a, M: Motion<'a, N, S>, const N: usize, S: Single> Course<'_, M, N, S> {
    /// The first gate through which a step passes, and when.
    pub(super) fn first_gate(&mut self, step: &Step<N, S>, there: Place) -> Option<(S, Gate)> {
        let boundaries = self.motion.point().mission.atmosphere.boundaries_m();
        let layer = self.stage.layer;
        let floor_m = layer
            .checked_sub(1)
            .and_then(|below| boundaries.get(below))
            .copied();
        let ceiling_m = boundaries.get(layer).copied();
        let ends = [step.t0.value(), step.t1.value()];
        let falls = [self.here.climb_m_s < 0.0, there.climb_m_s < 0.0];
        let found = if falls[0] == falls[1] {
            let ends_m = [self.here.altitude_m, there.altitude_m];
            self.gate_in(step, ends, ends_m, [floor_m, ceiling_m])
        } else {
            let climb = |y: &[S; N]| self.climb_m_s(y);
            let t_turn = self.when(step, ends, climb).value();
            let turn_m = self.altitude_m(&step.at(step.time(t_turn))).value();
            let before = self.gate_in(
                step,
                [ends[0], t_turn],
                [self.here.altitude_m, turn_m],
                [floor_m, ceiling_m],
            );
            self.turned_up |= falls[0];
            before.or_else(|| {
                let ends_m = [turn_m, there.altitude_m];
                self.gate_in(step, [t_turn, ends[1]], ends_m, [floor_m, ceiling_m])
            })
        };
        let refused = self.refused_in(step);
        let kinks = [
            self.speed_kink(step),
            self.mach_kink(step, there),
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

    /// Where a step slows down to a row of the drag table.
    fn mach_kink(&self, step: &Step<N, S>, there: Place) -> Option<(S, Gate)> {
        let kinks = &self.marks.kinks_mach;
        let ahead = self.here.mach * (1.0 - BEHIND_MACH);
        let below = kinks.partition_point(|kink| *kink < ahead);
        let level = *kinks.get(below.checked_sub(1)?)?;
        if there.mach >= level {
            return None;
        }
        let ends = [step.t0.value(), step.t1.value()];
        let gap = |y: &[S; N]| self.mach(y) / level - 1.0;
        Some((self.when(step, ends, gap), Gate::Kink))
    }

    /// Where a step slows down to a kink of a heating relation; with radiation over, takes it up again when the speed rises.
    fn speed_kink(&mut self, step: &Step<N, S>) -> Option<(S, Gate)> {
        let onset_m_s = self.marks.onset_m_s.unwrap_or(0.0);
        let [before, after] = [&step.y0, &step.y1].map(|y| speed_m_s(y).value());
        let mut radiates = self.motion.point().radiation.on.any();
        if !radiates && after > onset_m_s + BEHIND_M_S {
            self.motion.point_mut().radiation = Radiation::continued(onset_m_s);
            radiates = true;
        }
        let kinks = &self.marks.kinks_m_s;
        let below = kinks.partition_point(|kink| *kink < before - BEHIND_M_S);
        let (level_m_s, gate) = match below.checked_sub(1).and_then(|kink| kinks.get(kink)) {
            Some(kink) if !radiates || *kink > onset_m_s => (*kink, Gate::Kink),
            _ if radiates => (onset_m_s, Gate::Onset),
            _ => return None,
        };
        if after >= level_m_s {
            return None;
        }
        if before <= level_m_s {
            return Some((step.t0, gate));
        }
        let gap = |y: &[S; N]| speed_m_s(y) - level_m_s;
        let ends = [step.t0.value(), step.t1.value()];
        Some((self.when(step, ends, gap), gate))
    }

    /// The gate of a part of a step in which the altitude only rises or only falls.
    fn gate_in(
        &self,
        step: &Step<N, S>,
        span: [f64; 2],
        [start_m, end_m]: [f64; 2],
        [floor_m, ceiling_m]: [Option<f64>; 2],
    ) -> Option<(S, Gate)> {
        if span[0] >= span[1] {
            return None;
        }
        if end_m < start_m {
            let (level_m, gate) = match floor_m {
                Some(floor_m) if floor_m > self.marks.ground_m => (floor_m, Gate::Floor),
                _ => (self.marks.ground_m, Gate::Ground),
            };
            if gate == Gate::Ground && start_m < level_m {
                // It was below, climbed and now falls: it will not come above any more.
                return Some((step.time(span[0]), gate));
            }
            let below = end_m < level_m;
            return below.then(|| (self.reaches(step, span, level_m), gate));
        }
        let leaves =
            |exit_m: &f64| end_m > *exit_m && (self.turned_up || self.energy_j_kg(&step.y1) >= 0.0);
        let exit_m = self.exit_m.filter(leaves);
        let (level_m, gate) = match (ceiling_m, exit_m) {
            (Some(ceiling_m), Some(exit_m)) if ceiling_m < exit_m => (ceiling_m, Gate::Ceiling),
            (_, Some(exit_m)) => (exit_m, Gate::Exit),
            (Some(ceiling_m), None) => (ceiling_m, Gate::Ceiling),
            (None, None) => return None,
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

    /// The same for a quantity that depends on the time, too.
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

    fn mach(&self, y: &[S; N]) -> S {
        sample::mach(self.motion.point(), &head(y))
    }
}
