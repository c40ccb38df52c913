//! Largest values along an integrated flight.
//!
//! ```text
//! t_top = ½ (t₀ + t₁ + (t₂ − t₀) d₀/(d₀ − d₂)),   d₀ = (q₁ − q₀)/(t₁ − t₀),   d₂ = (q₂ − q₁)/(t₂ − t₁)
//! ```
//!
//! with q₁ a quantity between two steps and q₀ and q₂ its neighbors, t in s: a step in which it rises at first and falls at last is
//! searched from there for the zero of the slope on the dense output, or by Brent's method. Where there is none, the place
//! between two steps is the peak: a kink.
//!
//! # Valid
//! Quantities with at most one maximum within a step.
//!
//! # References
//! - \[brent-1973\] for the search.

use super::Peak;
use super::integration::{Leg, Record};
use super::motion::{Motion, head};
use super::phase::Stage;
use super::sample::{self, Loads};
use numerics::ode::event;
use numerics::scalar::Single;

/// Fraction of the largest value that an end of a step must reach for the step to be searched: a peak may exceed both
/// ends.
const NEARLY: f64 = 0.9;
/// A peak this close to an end of its step, as a fraction of the step, may continue in the next.
const AT_END: f64 = 1e-3;
/// Distance from an end of a step for its slope there, as a fraction of the step.
const LITTLE: f64 = 1e-3;

/// The loads along a record, ready to be searched.
pub struct Peaks<'r, M, const N: usize, S: Single = f64> {
    motion: M,
    record: &'r Record<N, S>,
}

type Along<'f, M, const N: usize, S> = dyn Fn(&M, S, &[S; N]) -> S + 'f;

impl<'a, 'r, M: Motion<'a, N, S>, const N: usize, S: Single> Peaks<'r, M, N, S> {
    /// The loads of a record of a motion.
    pub fn new(motion: M, record: &'r Record<N, S>) -> Self {
        Peaks { motion, record }
    }

    /// The peak of a quantity computed from the loads.
    pub fn of(&self, value: impl Fn(&Loads<S>) -> S) -> Peak<S> {
        let legs = &self.record.legs;
        let mut nodes = Vec::with_capacity(legs.len() + 1);
        nodes.push(value(&self.record.start_loads).value());
        nodes.extend(legs.iter().map(|leg| value(&leg.loads).value()));
        let along = |motion: &M, t: S, y: &[S; N]| value(&motion.loads(t, y));
        self.highest(&nodes, &along)
    }

    /// The peak of any quantity along the flight.
    pub fn of_motion(&self, along: impl Fn(&M, S, &[S; N]) -> S) -> Peak<S> {
        let mut nodes = Vec::with_capacity(self.record.legs.len() + 1);
        nodes.push(self.start(&along).value.value());
        nodes.extend(self.record.legs.iter().map(|leg| {
            let motion = self.motion.in_stage(&leg.stage);
            along(&motion, leg.step.t1, &leg.step.y1).value()
        }));
        self.highest(&nodes, &along)
    }

    /// The peak of a quantity of which the values at the start and between the steps are known.
    fn highest(&self, nodes: &[f64], along: &Along<M, N, S>) -> Peak<S> {
        let legs = &self.record.legs;
        let largest = nodes.iter().copied().fold(0.0, f64::max);
        let mut peak: Option<Peak<S>> = None;
        let mut take = |other: Peak<S>| {
            let higher = |peak: &Peak<S>| other.value.value() > peak.value.value();
            if peak.as_ref().is_none_or(higher) {
                peak = Some(other);
            }
        };
        if nodes.first().is_some_and(|first| *first >= largest) {
            take(self.start(along));
        }
        for (leg, ends) in nodes.windows(2).enumerate() {
            let high = ends[0].max(ends[1]);
            if high < NEARLY * largest {
                continue;
            }
            let within =
                self.rises(leg, End::First, along) > 0.0 && self.rises(leg, End::Last, along) < 0.0;
            if within {
                take(self.searched(leg, self.part(leg, nodes), along));
            } else if ends[1] >= largest
                && let Some(Leg { step, stage, .. }) = legs.get(leg)
            {
                // A kink, or the end of the flight: the place between the steps is the peak.
                take(self.peak(step.t1, &step.y1, stage, along));
            }
        }
        // A phase begins with a jump.
        for (t, y, stage) in &self.record.begun {
            take(self.peak(*t, y, stage, along));
        }
        peak.unwrap_or_else(|| self.start(along))
    }

    /// Change of a quantity over a small part of a step at one of its ends, forward in time.
    fn rises(&self, leg: usize, end: End, along: &Along<M, N, S>) -> f64 {
        let Some(Leg { step, stage, .. }) = self.record.legs.get(leg) else {
            return 0.0;
        };
        let motion = self.motion.in_stage(stage);
        let little = (step.t1 - step.t0) * LITTLE;
        let [from, to] = match end {
            End::First => [step.t0, step.t0 + little],
            End::Last => [step.t1 - little, step.t1],
        };
        let [from, to] = [from, to].map(|t| along(&motion, t, &step.at(t)).value());
        to - from
    }

    /// Fraction of a step at which the parabola through its higher end and the neighbors of that end has its maximum.
    fn part(&self, leg: usize, nodes: &[f64]) -> f64 {
        let legs = &self.record.legs;
        let later = nodes.get(leg) < nodes.get(leg + 1);
        let Some(before) = (leg + usize::from(later)).checked_sub(1) else {
            return 0.5;
        };
        let (Some(first), Some(last)) = (legs.get(before), legs.get(before + 1)) else {
            return 0.5;
        };
        let [t0, t1, t2] = [first.step.t0, first.step.t1, last.step.t1].map(S::value);
        let Some([v0, v1, v2]) = nodes.get(before..before + 3).and_then(|v| v.first_chunk()) else {
            return 0.5;
        };
        let (d0, d2) = ((v1 - v0) / (t1 - t0), (v2 - v1) / (t2 - t1));
        // The slope of the parabola is d₀ in the middle of the first step and d₂ in the middle of the second.
        let top = 0.5 * ((t0 + t1) + (t2 - t0) * d0 / (d0 - d2));
        let Some(Leg { step, .. }) = legs.get(leg) else {
            return 0.5;
        };
        let [start, end] = [step.t0, step.t1].map(S::value);
        let part = (top - start) / (end - start);
        if part > 0.0 && part < 1.0 { part } else { 0.5 }
    }

    /// The peak of the stagnation pressure in entry, which is near that of the dynamic pressure; near the ground the
    /// pressure of the air itself may be larger.
    pub fn of_stagnation_pressure(&self, dynamic_pressure: &Peak<S>) -> Peak<S> {
        let legs = &self.record.legs;
        let time_s = dynamic_pressure.time_s.value();
        let near = legs.partition_point(|leg| leg.step.t1.value() < time_s);
        let near = near.min(legs.len().saturating_sub(1));
        let pressure =
            |motion: &M, _: S, y: &[S; N]| sample::stagnation_pressure(motion.point(), &head(y));
        let Some(Leg { step, .. }) = legs.get(near) else {
            return self.start(&pressure);
        };
        let [t0, t1] = [step.t0, step.t1].map(S::value);
        let mut peak = self.searched(near, (time_s - t0) / (t1 - t0), &pressure);
        let part = (peak.time_s.value() - t0) / (t1 - t0);
        let beside = match part {
            part if part < AT_END => near.checked_sub(1),
            part if part > 1.0 - AT_END => Some(near + 1).filter(|leg| *leg < legs.len()),
            _ => None,
        };
        if let Some(beside) = beside {
            let other = self.searched(beside, 0.5, &pressure);
            if other.value.value() > peak.value.value() {
                peak = other;
            }
        }
        peak
    }

    /// The largest value within one step, its ends included; that of the start where there is no step.
    fn searched(&self, leg: usize, part: f64, along: &Along<M, N, S>) -> Peak<S> {
        let Some(Leg { step, stage, .. }) = self.record.legs.get(leg) else {
            return self.start(along);
        };
        let motion = self.motion.in_stage(stage);
        let t = event::top(step, |t| along(&motion, t, &step.at(t)), part);
        self.peak(t, &step.at(t), stage, along)
    }

    /// The value at the start.
    fn start(&self, along: &Along<M, N, S>) -> Peak<S> {
        let Record {
            start, start_stage, ..
        } = self.record;
        self.peak(S::constant(0.0), start, start_stage, along)
    }

    fn peak(&self, t: S, y: &[S; N], stage: &Stage<S>, along: &Along<M, N, S>) -> Peak<S> {
        let motion = self.motion.in_stage(stage);
        let around = motion.point().surroundings(&head(y));
        Peak {
            value: along(&motion, t, y),
            time_s: t,
            altitude_m: around.altitude_m,
            speed_m_s: (y[3] * y[3] + y[4] * y[4] + y[5] * y[5]).sqrt(),
            density_kg_m3: around.density_kg_m3,
        }
    }
}

/// An end of a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum End {
    First,
    Last,
}
