//! Largest values along an integrated flight.
//!
//! ```text
//! q(s) ≈ a + c₁ s + c₂ s²,  c₁ = −3 a + 4 m − b,  c₂ = 2 (a − 2 m + b)
//! ```
//!
//! with a, m, b a quantity at the beginning, middle and end of a step and s its part: the step with the largest estimate
//! is searched by Brent's method on the dense output, and so are others whose top is nearly as high.
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
use numerics::root;

/// A peak is placed within this part of a step.
const TOLERANCE: f64 = 1e-4;
/// Steps whose loads reach this part of the largest are looked at in their middle, too.
const BUSY: f64 = 0.5;
/// Steps whose estimate reaches this part of the peak are searched, too; the parabola is good to 0.1 % in most.
const NEARLY: f64 = 0.99;

/// The loads along a record, ready to be searched.
pub struct Peaks<'r, M, const N: usize> {
    motion: M,
    record: &'r Record<N>,
    /// Loads between the steps: one more than steps.
    nodes: Vec<Loads>,
    /// Loads in the middle of the busy steps.
    middles: Vec<Option<Loads>>,
}

type Along<'f, M, const N: usize> = dyn Fn(&M, f64, &[f64; N]) -> f64 + 'f;

impl<'a, 'r, M: Motion<'a, N>, const N: usize> Peaks<'r, M, N> {
    /// Computes the loads.
    pub fn new(motion: M, record: &'r Record<N>) -> Self {
        let loads = |layer, t: f64, y: &[f64; N]| motion.in_layer(layer).loads(t, y);
        let mut nodes = Vec::with_capacity(record.legs.len() + 1);
        nodes.push(loads(record.start_layer, 0.0, &record.start));
        let ends = |leg: &Leg<N>| loads(leg.layer, leg.step.t1, &leg.step.y1);
        nodes.extend(record.legs.iter().map(ends));
        let largest = |of: fn(&Loads) -> f64| nodes.iter().map(of).fold(0.0, f64::max);
        let measures: [fn(&Loads) -> f64; 3] = [
            |l| l.deceleration_earth_g,
            |l| l.heat_flux.convective_w_m2,
            |l| l.heat_flux.radiative_w_m2,
        ];
        let limits = measures.map(|of| BUSY * largest(of));
        let middles = record.legs.iter().zip(nodes.windows(2)).map(|(leg, ends)| {
            let busy =
                |(of, limit): (&fn(&Loads) -> f64, &f64)| ends.iter().any(|l| of(l) > *limit);
            let middle = 0.5 * (leg.step.t0 + leg.step.t1);
            measures
                .iter()
                .zip(&limits)
                .any(busy)
                .then(|| loads(leg.layer, middle, &leg.step.at(middle)))
        });
        let middles = middles.collect();
        Peaks {
            motion,
            record,
            nodes,
            middles,
        }
    }

    /// The peak of a quantity made of the loads.
    pub fn of(&self, value: impl Fn(&Loads) -> f64) -> Peak {
        let estimates: Vec<Top> = self
            .nodes
            .windows(2)
            .zip(&self.middles)
            .map(|(ends, middle)| {
                let [a, b] = [&ends[0], &ends[1]].map(&value);
                let m = middle.as_ref().map(&value);
                m.map_or(Top::AtEnd(a.max(b)), |m| parabola_top([a, m, b]))
            })
            .collect();
        let along = |motion: &M, t: f64, y: &[f64; N]| value(&motion.loads(t, y));
        let mut best = 0;
        for (leg, estimate) in estimates.iter().enumerate() {
            if estimate.value() > estimates[best].value() {
                best = leg;
            }
        }
        let mut peak = self.searched(best, &along);
        let first = (best, peak.time_s);
        for (leg, estimate) in estimates.iter().enumerate() {
            let nearly = leg != best && estimate.value() > NEARLY * peak.value;
            if nearly && (matches!(estimate, Top::Within(_)) || self.beside(leg, first)) {
                let other = self.searched(leg, &along);
                if other.value > peak.value {
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
        let (Some(other), Some(Leg { step, layer })) = (legs.get(leg), legs.get(first)) else {
            return false;
        };
        let to_end = (t - step.t0).min(step.t1 - t);
        let at_end = to_end <= 10.0 * TOLERANCE * (step.t1 - step.t0);
        leg.abs_diff(first) == 1 && (other.layer != *layer || at_end)
    }

    /// The peak of the pressure at the stagnation point in entry, which lies beside that of the dynamic pressure; near the
    /// ground the air itself may press harder.
    pub fn of_stagnation_pressure(&self, dynamic_pressure: &Peak) -> Peak {
        let legs = &self.record.legs;
        let near = legs.partition_point(|leg| leg.step.t1 < dynamic_pressure.time_s);
        let sides = [near.saturating_sub(1), near, near + 1];
        let pressure = |motion: &M, _: f64, y: &[f64; N]| {
            sample::stagnation_pressure(motion.point(), &head(y))
        };
        let last = legs.len().saturating_sub(1);
        let peaks = sides.map(|i| self.searched(i.min(last), &pressure));
        peaks.into_iter().fold(
            peaks[0],
            |best, peak| if peak.value > best.value { peak } else { best },
        )
    }

    /// The largest value within one step, its ends included; that of the start where there is no step.
    fn searched(&self, leg: usize, along: &Along<M, N>) -> Peak {
        let Some(Leg { step, layer }) = self.record.legs.get(leg) else {
            return self.peak(0.0, &self.record.start, self.record.start_layer, along);
        };
        let motion = self.motion.in_layer(*layer);
        let tolerance = TOLERANCE * (step.t1 - step.t0);
        let (t, _) = root::maximum(
            |t| along(&motion, t, &step.at(t)),
            step.t0,
            step.t1,
            tolerance,
        );
        self.peak(t, &step.at(t), *layer, along)
    }

    fn peak(&self, t: f64, y: &[f64; N], layer: usize, along: &Along<M, N>) -> Peak {
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

/// Largest value in a step by the parabola, and where it is.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Top {
    /// Between the ends.
    Within(f64),
    /// At an end.
    AtEnd(f64),
}

impl Top {
    fn value(self) -> f64 {
        match self {
            Top::Within(value) | Top::AtEnd(value) => value,
        }
    }
}

/// Top of the parabola through three equally spaced values, or the larger end where it has none in between.
fn parabola_top([a, m, b]: [f64; 3]) -> Top {
    let (c_1, c_2) = (4.0 * m - 3.0 * a - b, 2.0 * (a - 2.0 * m + b));
    let s = -c_1 / (2.0 * c_2);
    if c_2 < 0.0 && s > 0.0 && s < 1.0 {
        Top::Within(a.max(m).max(b).max(a + s * (c_1 + s * c_2)))
    } else {
        Top::AtEnd(a.max(b))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parabola_through_0_3_4_over_4_peaks_at_1() {
        // 4 s (2 − s)/4 at s = 0, 1/2, 1 is 0, 3/4, 1: the top is the end; 1 − (2 s − 1)² peaks at 1 in the middle.
        assert_eq!(parabola_top([0.0, 0.75, 1.0]), Top::AtEnd(1.0));
        assert_eq!(parabola_top([0.0, 1.0, 0.0]), Top::Within(1.0));
        // 1 − (s − 0.75)²: 0.4375, 0.9375, 0.9375, top 1.
        let Top::Within(top) = parabola_top([0.4375, 0.9375, 0.9375]) else {
            panic!("between the ends");
        };
        assert!((top - 1.0).abs() < 1e-15);
    }
}
