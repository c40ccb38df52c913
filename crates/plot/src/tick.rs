//! Positions and labels of ticks: steps of 1, 2 or 5 times a power of ten, or decades.

use crate::figure::Scale;
use crate::number::{decade, fixed, power_of_ten, scaled, ten_to_the};

/// Tick of an axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Tick {
    /// Value.
    pub value: f64,
    /// Label; empty at a minor tick.
    pub label: String,
}

impl Tick {
    /// Whether the tick has a label.
    pub fn is_major(&self) -> bool {
        !self.label.is_empty()
    }
}

/// Step of 1, 2 or 5 times a power of ten.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Step {
    mantissa: f64,
    exponent: i32,
}

impl Step {
    /// The smallest step that is at least `least`.
    pub(crate) fn at_least(least: f64) -> Self {
        let exponent = decade(least);
        let mantissa = least / power_of_ten(exponent);
        // rounding alone must not make a step too small
        let slack = 1.0 + 1e-9;
        match mantissa {
            m if m <= slack => Self {
                mantissa: 1.0,
                exponent,
            },
            m if m <= 2.0 * slack => Self {
                mantissa: 2.0,
                exponent,
            },
            m if m <= 5.0 * slack => Self {
                mantissa: 5.0,
                exponent,
            },
            _ => Self {
                mantissa: 1.0,
                exponent: exponent + 1,
            },
        }
    }

    /// `n` steps.
    pub(crate) fn times(self, n: f64) -> f64 {
        scaled(n * self.mantissa, self.exponent)
    }

    fn value(self) -> f64 {
        self.times(1.0)
    }

    /// Step of the minor grid.
    fn minor(self) -> Self {
        match self.mantissa {
            2.0 => Self {
                mantissa: 5.0,
                exponent: self.exponent - 1,
            },
            5.0 => Self {
                mantissa: 1.0,
                exponent: self.exponent,
            },
            _ => Self {
                mantissa: 2.0,
                exponent: self.exponent - 1,
            },
        }
    }

    /// The range extended to whole steps.
    pub(crate) fn around(self, (low, high): (f64, f64)) -> (f64, f64) {
        let step = self.value();
        let down = (low / step + 1e-9).floor();
        let up = (high / step - 1e-9).ceil();
        (self.times(down), self.times(up))
    }

    fn whole_steps(self, (low, high): (f64, f64)) -> Vec<f64> {
        let step = self.value();
        let (first, last) = ((low / step - 1e-9).ceil(), (high / step + 1e-9).floor());
        let count = (last - first).clamp(0.0, 1000.0) as usize;
        if last < first {
            return Vec::new();
        }
        (0..=count).map(|i| first + i as f64).collect()
    }
}

/// Ticks of a linear axis in steps of `step`.
fn linear(range: (f64, f64), step: Step) -> Vec<Tick> {
    let majors = step.whole_steps(range);
    let largest = majors
        .iter()
        .fold(0.0_f64, |a, n| a.max(step.times(*n).abs()));
    // from 1e6 on, factor out a power of ten (a multiple of three) common to all labels
    let common = if largest >= 1e6 || (largest > 0.0 && step.exponent < -4) {
        decade(largest).div_euclid(3) * 3
    } else {
        0
    };
    let decimals = (common - step.exponent).max(0) as usize;
    let label = |n: f64| match (common, n == 0.0) {
        (_, true) => "0".to_owned(),
        (0, _) => fixed(step.times(n), decimals),
        _ => {
            let mantissa = fixed(scaled(n * step.mantissa, step.exponent - common), decimals);
            format!("{mantissa}×{}", ten_to_the(common))
        }
    };
    let major_ticks = majors.iter().map(|n| Tick {
        value: step.times(*n),
        label: label(*n),
    });
    let minor = step.minor();
    let per_major = (step.value() / minor.value()).round();
    let minor_ticks = minor
        .whole_steps(range)
        .into_iter()
        .filter(|n| n % per_major != 0.0)
        .map(|n| Tick {
            value: minor.times(n),
            label: String::new(),
        });
    major_ticks.chain(minor_ticks).collect()
}

/// Ticks of a logarithmic axis: labels at `mantissas` in every `stride`-th decade.
fn logarithmic((low, high): (f64, f64), stride: i32, mantissas: &[u8]) -> Vec<Tick> {
    let inside = |v: f64| v >= low * (1.0 - 1e-9) && v <= high * (1.0 + 1e-9);
    let (first, last) = (decade(low), decade(high));
    let plain = first >= -3 && last < 6;
    let mut ticks = Vec::new();
    for n in first..=last {
        for m in 1..=9_u8 {
            let value = scaled(f64::from(m), n);
            if !inside(value) {
                continue;
            }
            let labeled = mantissas.contains(&m) && n.rem_euclid(stride) == 0;
            if !labeled && stride > 1 && m > 1 {
                continue;
            }
            let label = match (labeled, plain, m) {
                (false, _, _) => String::new(),
                (true, true, _) => fixed(value, (-n).max(0) as usize),
                (true, false, 1) => ten_to_the(n),
                (true, false, _) => format!("{m}×{}", ten_to_the(n)),
            };
            ticks.push(Tick { value, label });
        }
    }
    ticks
}

/// The densest ticks of an axis whose labels, measured by `fits`, are not too close. `most` is the largest number of
/// labels to try.
///
/// The range may run in either direction; on a logarithmic axis both ends are positive.
pub fn ticks(
    (from, to): (f64, f64),
    scale: Scale,
    most: usize,
    fits: impl Fn(&[Tick]) -> bool,
) -> Vec<Tick> {
    let range = (from.min(to), from.max(to));
    let span = range.1 - range.0;
    if !(span.is_finite() && span > 0.0) {
        return Vec::new();
    }
    let decades = match scale {
        Scale::Log if range.0 > 0.0 => decade(range.1) - decade(range.0),
        _ => 0,
    };
    let mut coarsest = Vec::new();
    if decades >= 1 {
        let labeled: [&[u8]; 3] = [&[1, 2, 5], &[1, 3], &[1]];
        let dense = if decades <= 3 {
            &labeled[..]
        } else {
            &labeled[2..]
        };
        for mantissas in dense {
            coarsest = logarithmic(range, 1, mantissas);
            if fits(&coarsest) {
                return coarsest;
            }
        }
        for stride in [2, 3, 5, 10, 20, 50] {
            coarsest = logarithmic(range, stride, &[1]);
            if fits(&coarsest) {
                return coarsest;
            }
        }
        return coarsest;
    }
    for count in (1..=most.max(2)).rev() {
        coarsest = linear(range, Step::at_least(span / count as f64));
        if fits(&coarsest) {
            return coarsest;
        }
    }
    coarsest
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(range: (f64, f64), scale: Scale, most: usize) -> Vec<String> {
        let found = ticks(range, scale, most, |_| true);
        found
            .into_iter()
            .filter(Tick::is_major)
            .map(|t| t.label)
            .collect()
    }

    #[test]
    fn steps_are_1_2_or_5() {
        for (least, step) in [
            (0.9, 1.0),
            (1.0, 1.0),
            (1.1, 2.0),
            (2.3, 5.0),
            (7.0, 10.0),
            (0.03, 0.05),
        ] {
            assert_eq!(Step::at_least(least).value(), step);
        }
    }

    #[test]
    fn tick_at_three_tenths_is_exactly_0_3() {
        let found = ticks((0.0, 0.5), Scale::Linear, 5, |_| true);
        assert_eq!(found[3].value, 0.3);
        assert_eq!(
            labels((0.0, 0.5), Scale::Linear, 5),
            ["0", "0.1", "0.2", "0.3", "0.4", "0.5"]
        );
    }

    #[test]
    fn minor_ticks_stand_between() {
        // major step 0.1, minor step 0.02: four minor ticks in each of five intervals
        let found = ticks((0.0, 0.5), Scale::Linear, 5, |_| true);
        assert_eq!(found.iter().filter(|t| !t.is_major()).count(), 20);
    }

    #[test]
    fn thousands_and_millions() {
        assert_eq!(
            labels((0.0, 125_000.0), Scale::Linear, 3),
            ["0", "50\u{202F}000", "100\u{202F}000"]
        );
        assert_eq!(
            labels((0.0, 1.4e7), Scale::Linear, 3),
            ["0", "5×10⁶", "10×10⁶"]
        );
        assert_eq!(
            labels((0.0, 3e-6), Scale::Linear, 3),
            ["0", "1×10⁻⁶", "2×10⁻⁶", "3×10⁻⁶"]
        );
    }

    #[test]
    fn reversed_and_negative_ranges() {
        assert_eq!(
            labels((-5.0, -25.0), Scale::Linear, 4),
            ["−25", "−20", "−15", "−10", "−5"]
        );
    }

    #[test]
    fn decades_of_a_logarithmic_axis() {
        assert_eq!(labels((1e-9, 1.0), Scale::Log, 5).len(), 10);
        assert_eq!(
            labels((0.1, 20.0), Scale::Log, 5),
            ["0.1", "0.2", "0.5", "1", "2", "5", "10", "20"]
        );
    }

    #[test]
    fn less_than_a_decade_has_linear_steps() {
        assert_eq!(labels((2.0, 6.0), Scale::Log, 4), ["2", "3", "4", "5", "6"]);
    }

    #[test]
    fn crowded_labels_are_thinned() {
        let sparse = ticks((1e-30, 1.0), Scale::Log, 5, |t| {
            t.iter().filter(|t| t.is_major()).count() <= 7
        });
        // 0, −5, ... −30
        assert_eq!(sparse.iter().filter(|t| t.is_major()).count(), 7);
    }

    #[test]
    fn no_ticks_for_an_empty_or_infinite_range() {
        assert!(ticks((1.0, 1.0), Scale::Linear, 5, |_| true).is_empty());
        assert!(ticks((0.0, f64::INFINITY), Scale::Linear, 5, |_| true).is_empty());
    }
}
