//! Start of phases, and end of the inflation of a parachute.
//!
//! ```text
//! x(t) − value changes its sign in the direction of the phase
//! ```
//!
//! with x an altitude in m, a Mach number, a dynamic pressure in Pa or a deceleration in Earth g.
//!
//! # Valid
//! Quantities that pass their value at most once in a quarter of a step. A quantity that passed it before its phase was
//! next in order, or at that instant by a change of the previous phase, and is still beyond it, begins the phase at
//! once: a switch that closes and stays closed until the sequence reads it. A quantity that has been beyond its value
//! since the start has not passed it.
//!
//! # References
//! - Own convention.

use super::course::Course;
use super::gate::Gate;
use crate::flight::motion::{Motion, head};
use crate::flight::phase::{Begin, Direction, Mark, Phase};
use crate::flight::sample;
use numerics::ode::Step;
use numerics::scalar::Single;

/// Number of parts of a step, at the ends of which the quantities are evaluated.
const PARTS: u32 = 4;

impl<'a, M: Motion<'a, N, S>, const N: usize, S: Single> Course<'_, M, N, S> {
    /// The phase that is to begin next.
    fn next_phase(&self) -> Option<&'a Phase> {
        let mission = self.motion.point().mission;
        mission.phases.get(self.stage.phases)
    }

    /// The time within a step at which the parachute is full.
    pub(super) fn filled_in(&self, step: &Step<N, S>) -> Option<(S, Gate)> {
        let full_s = self.full_s?;
        (step.t1.value() >= full_s).then(|| (step.time(full_s.max(step.t0.value())), Gate::Full))
    }

    /// Records from a step which phases had their value passed in their direction, before they were next in order or
    /// where another gate ended the step.
    pub(super) fn look_ahead(&mut self, step: &Step<N, S>) {
        let mission = self.motion.point().mission;
        let ends = [(step.t0, &step.y0), (step.t1, &step.y1)];
        for (index, phase) in mission.phases.iter().enumerate().skip(self.stage.phases) {
            let beyond = ends.map(|(t, y)| self.is_beyond(&phase.begin, t, y));
            if let (Some(passed), true) = (self.passed.get_mut(index), beyond[0] != beyond[1]) {
                *passed = beyond[1];
            }
        }
    }

    /// Whether a quantity is beyond the value of a phase in its direction; never so for a time.
    fn is_beyond(&self, begin: &Begin, t: S, y: &[S; N]) -> bool {
        if begin.mark == Mark::Time {
            return false;
        }
        let gap = self.quantity(begin.mark, t, y).value() - begin.value;
        match begin.direction {
            Direction::Rising => gap >= 0.0,
            Direction::Falling => gap <= 0.0,
        }
    }

    /// Whether the quantity of each phase that has not begun stands beyond its value.
    fn beyond(&self, t: S, y: &[S; N]) -> Vec<bool> {
        let phases = self.motion.point().mission.phases.iter();
        let ahead = phases.skip(self.stage.phases);
        ahead
            .map(|phase| self.is_beyond(&phase.begin, t, y))
            .collect()
    }

    /// The time within a step at which the next phase begins.
    pub(super) fn phase_in(&self, step: &Step<N, S>) -> Option<(S, Gate)> {
        if self.passed.get(self.stage.phases) == Some(&true) {
            return self.next_phase().map(|_| (step.t0, Gate::Phase));
        }
        let Begin {
            mark,
            value,
            direction,
        } = self.next_phase()?.begin;
        let (t0, t1) = (step.t0.value(), step.t1.value());
        if mark == Mark::Time {
            return (t1 >= value).then(|| (step.time(value.max(t0)), Gate::Phase));
        }
        let sign = match direction {
            Direction::Rising => -1.0,
            Direction::Falling => 1.0,
        };
        let gap = |y: &[S; N], t: S| (self.quantity(mark, t, y) - value) * sign;
        let (mut from, mut before) = (t0, gap(&step.y0, step.t0).value());
        for i in 1..=PARTS {
            let to = match i {
                PARTS => t1,
                _ => t0 + (t1 - t0) * (f64::from(i) / f64::from(PARTS)),
            };
            let t = step.time(to);
            let after = gap(&step.at(t), t).value();
            if before > 0.0 && after <= 0.0 {
                return Some((self.when_at(step, [from, to], gap), Gate::Phase));
            }
            (from, before) = (to, after);
        }
        None
    }

    fn quantity(&self, mark: Mark, t: S, y: &[S; N]) -> S {
        let point = self.motion.point();
        match mark {
            Mark::Time => t,
            Mark::Altitude => point.ellipsoid.local([y[0], y[1], y[2]]).altitude_m,
            Mark::Mach => sample::mach(point, &head(y)),
            Mark::DynamicPressure => self.motion.loads(t, y).dynamic_pressure_pa,
            Mark::Deceleration => self.motion.loads(t, y).deceleration_earth_g,
        }
    }

    /// Begins the next phase at the present position.
    pub(super) fn begin_phase(&mut self) {
        let Some(phase) = self.next_phase() else {
            return;
        };
        let (t, y) = self.now();
        self.stage.phases += 1;
        if phase.change.canopy.is_some() {
            self.stage.canopy_since_s = t;
        }
        if let Some(canopy) = phase.change.canopy {
            let inflates = canopy.inflation_s > 0.0;
            self.full_s = inflates.then(|| t.value() + canopy.inflation_s);
        }
        let before = self.beyond(t, &y);
        self.motion.point_mut().change(&phase.change, t);
        let now = self.beyond(t, &y);
        let later = self.passed.iter_mut().skip(self.stage.phases);
        for (passed, (before, now)) in later.zip(before.into_iter().zip(now)) {
            if before != now {
                *passed = now;
            }
        }
        self.record.begun.push((t, y, self.stage));
    }
}
