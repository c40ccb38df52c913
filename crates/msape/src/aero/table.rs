//! A user's table of coefficients, over Mach number, total angle of attack and, if wanted, Knudsen number.
//!
//! ```text
//! linear in M and in log₁₀ Kn;  cubic in α with slopes kept monotone between rows
//! fᵢ' = 0 where the two differences beside have different signs, else their harmonic mean
//! ```
//!
//! with α in rad. Beyond the table the ends are held, or extended with their last slope, or the place is refused.
//!
//! # Valid
//! Axial force even in α, normal force and moment odd: the table is given for α ≥ 0, or for both sides alike.
//!
//! # References
//! - \[fritsch-butland-1984\] (monotone slopes).

use super::integral::Loads;
use numerics::math::{PI, RADIANS_PER_DEGREE, log10};
use serde::{Deserialize, Serialize};

mod check;
mod push;
mod row;

pub use crate::quantity::choice::Extrapolation;
pub use push::in_radians;
pub use row::Row;

/// Coefficients given by a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Content {
    /// Forces, with or without a moment and damping.
    Static {
        /// Whether there is a moment.
        moment: Given,
        /// Whether there is damping.
        damping: Given,
    },
    /// Damping alone.
    DampingOnly,
}

/// Whether something is in a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Given {
    /// In the table.
    Yes,
    /// Not in the table; counts as zero.
    No,
}

/// A checked table.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Grid {
    /// Coefficients that it gives.
    pub content: Content,
    /// Rule beyond its ends.
    pub extrapolation: Extrapolation,
    mach: Vec<f64>,
    log_knudsen: Vec<f64>,
    alpha_rad: Vec<f64>,
    /// C_A, C_N, C_m, C_mq and their slopes by α; α runs fastest, Mach slowest.
    values: Vec<[[f64; 4]; 2]>,
}

/// A place on an axis: the node below and the fraction of the interval to the next, outside 0…1 beyond the ends.
#[derive(Clone, Copy)]
struct Place {
    index: usize,
    part: f64,
    step: f64,
}

impl Place {
    fn new(axis: &[f64], x: f64, extrapolation: Extrapolation) -> Place {
        let single = Place {
            index: 0,
            part: 0.0,
            step: 0.0,
        };
        if axis.len() < 2 {
            return single;
        }
        let index = axis
            .partition_point(|node| *node <= x)
            .clamp(1, axis.len() - 1)
            - 1;
        let (Some(from), Some(to)) = (axis.get(index), axis.get(index + 1)) else {
            return single;
        };
        let part = (x - from) / (to - from);
        Place {
            index,
            part: match extrapolation {
                Extrapolation::Extend => part,
                Extrapolation::Hold | Extrapolation::Refuse => part.clamp(0.0, 1.0),
            },
            step: to - from,
        }
    }
}

impl Grid {
    /// Coefficients C_A, C_N, C_m, C_mq at a total angle of attack of 0…π rad.
    pub fn at(&self, mach: f64, knudsen: f64, alpha_rad: f64) -> [f64; 4] {
        let rule = self.extrapolation;
        let m = Place::new(&self.mach, mach, rule);
        let k = if self.log_knudsen.len() < 2 {
            Place::new(&self.log_knudsen, 0.0, rule)
        } else {
            Place::new(&self.log_knudsen, log10(knudsen.max(1e-30)), rule)
        };
        let a = Place::new(&self.alpha_rad, alpha_rad, rule);
        let mut sum = [0.0; 4];
        for (dm, wm) in [(0, 1.0 - m.part), (1, m.part)] {
            for (dk, wk) in [(0, 1.0 - k.part), (1, k.part)] {
                if wm * wk != 0.0 {
                    let line = self.line(m.index + dm, k.index + dk, &a);
                    for (sum, value) in sum.iter_mut().zip(line) {
                        *sum += wm * wk * value;
                    }
                }
            }
        }
        sum
    }

    fn line(&self, mach: usize, knudsen: usize, place: &Place) -> [f64; 4] {
        let start = (mach * self.log_knudsen.len() + knudsen) * self.alpha_rad.len() + place.index;
        let zero = [[0.0; 4]; 2];
        let [f0, g0] = self.values.get(start).copied().unwrap_or(zero);
        if place.step == 0.0 {
            return f0;
        }
        let [f1, g1] = self.values.get(start + 1).copied().unwrap_or(zero);
        let (u, h) = (place.part, place.step);
        core::array::from_fn(|n| {
            if u < 0.0 {
                return f0[n] + g0[n] * u * h;
            }
            if u > 1.0 {
                return f1[n] + g1[n] * (u - 1.0) * h;
            }
            let v = 1.0 - u;
            f0[n] * v * v * (1.0 + 2.0 * u)
                + g0[n] * h * u * v * v
                + f1[n] * u * u * (1.0 + 2.0 * v)
                - g1[n] * h * u * u * v
        })
    }

    /// Static coefficients at a total angle of attack of 0…π rad.
    pub fn loads(&self, mach: f64, knudsen: f64, alpha_rad: f64) -> Loads {
        let [ca, cn, cm, _] = self.at(mach, knudsen, alpha_rad);
        Loads { ca, cn, cm }
    }

    /// Damping coefficient at a total angle of attack of 0…π rad.
    pub fn damping(&self, mach: f64, knudsen: f64, alpha_rad: f64) -> f64 {
        let [.., cmq] = self.at(mach, knudsen, alpha_rad);
        cmq
    }

    /// Sentences about a place beyond the table, one for each argument.
    pub fn beyond(&self, mach: f64, knudsen: f64, alpha_rad: f64) -> Vec<String> {
        let mut found = Vec::new();
        let mut look =
            |what: &str, axis: &[f64], x: f64, shown: &dyn Fn(f64) -> f64, unit: &str| {
                let (Some(low), Some(high)) = (axis.first(), axis.last()) else {
                    return;
                };
                let slack = 1e-9 * (high - low).abs();
                if axis.len() > 1 && !(low - slack..=high + slack).contains(&x) {
                    found.push(format!(
                        "{what} {}{unit}, the table runs from {} to {}{unit}",
                        shown(x),
                        shown(*low),
                        shown(*high)
                    ));
                }
            };
        let power = |x: f64| numerics::math::pow(10.0, x);
        let degrees = |x: f64| (x / RADIANS_PER_DEGREE * 1e9).round() / 1e9;
        look("Mach number", &self.mach, mach, &|x| x, "");
        look(
            "angle of attack",
            &self.alpha_rad,
            alpha_rad,
            &degrees,
            " deg",
        );
        let log = log10(knudsen.max(1e-30));
        look("Knudsen number", &self.log_knudsen, log, &power, "");
        found
    }

    /// Mach numbers of the table.
    pub fn mach(&self) -> &[f64] {
        &self.mach
    }

    /// Ends of the Mach numbers, of the angles, rad, and of the Knudsen numbers, where there is more than one of them.
    pub fn ends(&self) -> [Option<[f64; 2]>; 3] {
        let ends = |axis: &[f64]| match axis {
            [first, .., last] => Some([*first, *last]),
            _ => None,
        };
        let knudsen = ends(&self.log_knudsen);
        [
            ends(&self.mach),
            ends(&self.alpha_rad),
            knudsen.map(|ends| ends.map(|log| numerics::math::pow(10.0, log))),
        ]
    }

    /// Whether, at the ends of the same axes, the last two nodes have the same coefficients at every place of the others.
    pub fn level(&self) -> [[bool; 2]; 3] {
        let counts = [
            self.mach.len(),
            self.log_knudsen.len(),
            self.alpha_rad.len(),
        ];
        let value = |[mach, knudsen, alpha]: [usize; 3]| {
            let [_, of_knudsen, of_alpha] = counts;
            self.values
                .get((mach * of_knudsen + knudsen) * of_alpha + alpha)
        };
        let alike = |axis: usize, pair: [usize; 2]| {
            let mut others = counts;
            others[axis] = 1;
            let [machs, knudsens, alphas] = others;
            (0..machs * knudsens * alphas).all(|n| {
                let mut place = [n / (knudsens * alphas), n / alphas % knudsens, n % alphas];
                let [a, b] = pair.map(|node| {
                    place[axis] = node;
                    value(place).map(|[coefficients, _]| coefficients)
                });
                a == b
            })
        };
        [0, 2, 1].map(|axis| match counts[axis] {
            0 | 1 => [false; 2],
            count => [alike(axis, [0, 1]), alike(axis, [count - 2, count - 1])],
        })
    }

    /// Largest angle of the table, rad.
    pub fn alpha_max_rad(&self) -> f64 {
        self.alpha_rad.last().copied().unwrap_or(PI)
    }

    /// Rows of Mach number and axial force at zero angle of attack, in the first Knudsen number of the table.
    pub fn axial_force_rows(&self) -> Vec<(f64, f64)> {
        let knudsen = self.log_knudsen.first().copied().unwrap_or_default();
        let knudsen = numerics::math::pow(10.0, knudsen);
        let at = |mach: &f64| (*mach, self.loads(*mach, knudsen, 0.0).ca);
        self.mach.iter().map(at).collect()
    }
}
