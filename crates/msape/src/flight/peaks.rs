//! Largest values along an integrated flight.
//!
//! ```text
//! q(s) ≈ a + c₁ s + c₂ s²,  c₁ = −3 a + 4 m − b,  c₂ = 2 (a − 2 m + b)
//! ```
//!
//! with a, m, b a quantity at the beginning, middle and end of a step and s its part: the step with the largest estimate
//! is searched on the dense output for the zero of the slope, or by Brent's method, and so are others whose top is nearly as
//! high.
//!
//! # Valid
//! Quantities with at most one maximum within a step.
//!
//! # References
//! - \[brent-1973\] for the search.

use super::Peak;
use super::integration::{Leg, Record};
use super::motion::{Motion, head};
use super::sample::{self, Loads};
use numerics::ode::event;
use numerics::scalar::Single;

/// Steps whose loads reach this part of the largest are looked at in their middle, too.
const BUSY: f64 = 0.5;
/// Steps whose estimate reaches this part of the peak are searched, too; the parabola is good to 0.1 % in most.
const NEARLY: f64 = 0.99;
/// A peak this close to an end of its step, as a part of the step, may go on in the next.
const AT_END: f64 = 1e-3;

/// The loads along a record, ready to be searched.
pub struct Peaks<'r, M, const N: usize, S: Single = f64> {
    motion: M,
    record: &'r Record<N, S>,
    /// Loads in the middle of the busy steps.
    middles: Vec<Option<Loads<S>>>,
}

type Along<'f, M, const N: usize, S> = dyn Fn(&M, S, &[S; N]) -> S + 'f;

impl<'a, 'r, M: Motion<'a, N, S>, const N: usize, S: Single> Peaks<'r, M, N, S> {
    /// Computes the loads that the record does not have.
    pub fn new(motion: M, record: &'r Record<N, S>) -> Self {
        let measures: [fn(&Loads<S>) -> S; 3] = [
            |l| l.deceleration_earth_g,
            |l| l.heat_flux.convective_w_m2,
            |l| l.heat_flux.radiative_w_m2,
        ];
        let mut limits = [0.0_f64; 3];
        for leg in &record.legs {
            for (limit, of) in limits.iter_mut().zip(measures) {
                *limit = limit.max(BUSY * of(&leg.loads).value());
            }
        }
        let busy = |loads: &Loads<S>| {
            measures.iter().zip(limits).any(|(of, limit)| of(loads).value() > limit)
        };
        let mut before = busy(&record.start_loads);
        let middles = record.legs.iter().map(|leg| {
            let after = busy(&leg.loads);
            let looked_at = before || after;
            before = after;
            looked_at.then(|| {
                let t = (leg.step.t0 + leg.step.t1) * 0.5;
                motion.in_layer(leg.layer).loads(t, &leg.step.at(t))
            })
        });
        let middles = middles.collect();
        Peaks {
            motion,
            record,
            middles,
        }
    }

    /// The peak of a quantity made of the loads.
    pub fn of(&self, value: impl Fn(&Loads<S>) -> S) -> Peak<S> {
        let mut before = value(&self.record.start_loads).value();
        let legs = self.record.legs.iter().zip(&self.middles);
        let estimates: Vec<Top> = legs
            .map(|(leg, middle)| {
                let [a, b] = [before, value(&leg.loads).value()];
                before = b;
                let m = middle.as_ref().map(|loads| value(loads).value());
                m.map_or(Top::at_end([a, b]), |m| parabola_top([a, m, b]))
            })
            .collect();
        let along = |motion: &M, t: S, y: &[S; N]| value(&motion.loads(t, y));
        let mut best = 0;
        for (leg, estimate) in estimates.iter().enumerate() {
            if estimate.value > estimates[best].value {
                best = leg;
            }
        }
        let start = |leg: usize| estimates.get(leg).map_or(0.5, |top| top.part);
        let mut peak = self.searched(best, start(best), &along);
        let first = (best, peak.time_s.value());
        for (leg, estimate) in estimates.iter().enumerate() {
            let nearly = leg != best && estimate.value > NEARLY * peak.value.value();
            if nearly && (estimate.is_within() || self.beside(leg, first)) {
                let other = self.searched(leg, start(leg), &along);
                if other.value.value() > peak.value.value() {
                    peak = other;
                }
            }
        }
        peak
    }

    /// Whether a step follows, or is followed by, the step with the first peak found, and may hold a higher one: across a
    /// boundary of the atmosphere, or when that peak is at an end of its step.
    fn beside(&self, leg: usize, (first, t): (usize, f64)) -> bool {
        let legs = &self.record.legs;
        let (Some(other), Some(Leg { step, layer, .. })) = (legs.get(leg), legs.get(first)) else {
            return false;
        };
        let [t0, t1] = [step.t0, step.t1].map(S::value);
        let at_end = (t - t0).min(t1 - t) <= AT_END * (t1 - t0);
        leg.abs_diff(first) == 1 && (other.layer != *layer || at_end)
    }

    /// The peak of the pressure at the stagnation point in entry, which lies beside that of the dynamic pressure; near the
    /// ground the air itself may press harder.
    pub fn of_stagnation_pressure(&self, dynamic_pressure: &Peak<S>) -> Peak<S> {
        let legs = &self.record.legs;
        let time_s = dynamic_pressure.time_s.value();
        let near = legs.partition_point(|leg| leg.step.t1.value() < time_s);
        let last = legs.len().saturating_sub(1);
        let pressure = |motion: &M, _: S, y: &[S; N]| {
            sample::stagnation_pressure(motion.point(), &head(y))
        };
        let mut peak = self.searched(near.min(last), 0.5, &pressure);
        for side in [near.saturating_sub(1), near + 1] {
            let side = side.min(last);
            if self.beside(side, (near, peak.time_s.value())) {
                let other = self.searched(side, 0.5, &pressure);
                if other.value.value() > peak.value.value() {
                    peak = other;
                }
            }
        }
        peak
    }

    /// The largest value within one step, its ends included; that of the start where there is no step.
    fn searched(&self, leg: usize, part: f64, along: &Along<M, N, S>) -> Peak<S> {
        let Some(Leg { step, layer, .. }) = self.record.legs.get(leg) else {
            let zero = S::constant(0.0);
            return self.peak(zero, &self.record.start, self.record.start_layer, along);
        };
        let motion = self.motion.in_layer(*layer);
        let t = event::top(step, |t| along(&motion, t, &step.at(t)), part);
        self.peak(t, &step.at(t), *layer, along)
    }

    fn peak(&self, t: S, y: &[S; N], layer: usize, along: &Along<M, N, S>) -> Peak<S> {
        let motion = self.motion.in_layer(layer);
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

/// Largest value in a step by the parabola, and at which part of the step.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Top {
    value: f64,
    part: f64,
}

impl Top {
    /// The larger of the two ends.
    fn at_end([a, b]: [f64; 2]) -> Self {
        match a > b {
            true => Top { value: a, part: 0.0 },
            false => Top { value: b, part: 1.0 },
        }
    }

    fn is_within(&self) -> bool {
        self.part > 0.0 && self.part < 1.0
    }
}

/// Top of the parabola through three equally spaced values, or the larger end where it has none in between.
fn parabola_top([a, m, b]: [f64; 3]) -> Top {
    let (c_1, c_2) = (4.0 * m - 3.0 * a - b, 2.0 * (a - 2.0 * m + b));
    let s = -c_1 / (2.0 * c_2);
    if c_2 < 0.0 && s > 0.0 && s < 1.0 {
        let value = a.max(m).max(b).max(a + s * (c_1 + s * c_2));
        Top { value, part: s }
    } else {
        Top::at_end([a, b])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parabola_through_0_3_4_over_4_peaks_at_1() {
        // 4 s (2 − s)/4 at s = 0, 1/2, 1 is 0, 3/4, 1: the top is the end; 1 − (2 s − 1)² peaks at 1 in the middle.
        assert_eq!(parabola_top([0.0, 0.75, 1.0]), Top { value: 1.0, part: 1.0 });
        assert_eq!(parabola_top([0.0, 1.0, 0.0]), Top { value: 1.0, part: 0.5 });
        // 1 − (s − 0.75)²: 0.4375, 0.9375, 0.9375, top 1.
        let top = parabola_top([0.4375, 0.9375, 0.9375]);
        assert!((top.value - 1.0).abs() < 1e-15 && (top.part - 0.75).abs() < 1e-15);
    }
}
