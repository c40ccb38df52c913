//! Tables of a case that a flight looks up: where it leaves them, and the findings about it.
//!
//! ```text
//! x < first or x > last        with x the argument of a table
//! ```
//!
//! with x an altitude in m, a speed in m/s, a Mach or Knudsen number, a time in s or a total angle of attack in rad.
//!
//! # Valid
//! Tables given by a case, and the altitudes of any atmosphere. Other tables of the library are held beyond their ends
//! by their own sources.
//!
//! # References
//! - Own convention.

mod axes;
mod push;

use crate::aero::table::Extrapolation;
use crate::finding::range::short;
use crate::finding::{Finding, Severity};
use crate::quantity::input;
use numerics::math::RADIANS_PER_DEGREE;
use serde::{Deserialize, Serialize};

pub use axes::{axes, axes_of_closed_form, of_atmosphere, of_database};
pub use push::{Push, may_push};

/// Key of the axis of the atmosphere.
const ATMOSPHERE: &str = "atmosphere";
/// A flight that ends at the first row of the atmosphere may lie this far below it, m: assumed, a thousand times what a landing is within,
/// and nothing for the air.
const NEAR_M: f64 = 1.0;

/// Argument of a table look-up.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Argument {
    /// Geodetic altitude, m.
    Altitude,
    /// Speed relative to the air, m/s.
    AirSpeed,
    /// Mach number.
    Mach,
    /// Time after the start, s.
    Time,
    /// Total angle of attack, rad.
    TotalAlpha,
    /// Knudsen number of the table.
    Knudsen,
    /// Free-stream density, kg/m³.
    Density,
}

/// A number for each [`Argument`], in their order; not a number where a motion has none.
pub type Arguments<S> = [S; 7];

impl Argument {
    /// Name in a sentence.
    pub fn name(self) -> &'static str {
        match self {
            Argument::Altitude => "altitude",
            Argument::AirSpeed => "speed relative to the air",
            Argument::Mach => "Mach number",
            Argument::Time => "time",
            Argument::TotalAlpha => "total angle of attack",
            Argument::Knudsen => "Knudsen number",
            Argument::Density => "density",
        }
    }

    fn key(self) -> &'static str {
        match self {
            Argument::Altitude => "altitude_m",
            Argument::AirSpeed => "speed_m_s",
            Argument::Mach => "mach",
            Argument::Time => "time_s",
            Argument::TotalAlpha => "total_alpha_deg",
            Argument::Knudsen => "knudsen",
            Argument::Density => "density_kg_m3",
        }
    }

    /// A value as it is shown, and its unit.
    fn shown(self, value: f64) -> (f64, &'static str) {
        match self {
            Argument::Altitude => (value, " m"),
            Argument::AirSpeed => (value, " m/s"),
            Argument::Time => (value, " s"),
            Argument::TotalAlpha => (value / RADIANS_PER_DEGREE, " deg"),
            Argument::Density => (value, " kg/m³"),
            Argument::Mach | Argument::Knudsen => (value, ""),
        }
    }
}

/// One axis of a table of the case.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis {
    /// Key of the table in the case.
    pub key: &'static str,
    /// Argument of the look-up.
    pub argument: Argument,
    /// First and last row.
    pub ends: [f64; 2],
    /// Rule beyond the ends.
    pub rule: Extrapolation,
    /// Whether the table is level at each end: its last two rows are equal, so that every rule continues with them.
    pub level: [bool; 2],
    /// Distance beyond an end up to which there is no finding.
    pub slack: f64,
}

/// Part of the length of an axis by which rounding may leave it: assumed, far above rounding and below what a table resolves.
const SLACK: f64 = 1e-9;

impl Axis {
    fn held(key: &'static str, argument: Argument, ends: [f64; 2]) -> Axis {
        Axis {
            key,
            argument,
            ends,
            rule: Extrapolation::Hold,
            level: [false; 2],
            slack: SLACK * (ends[1] - ends[0]),
        }
    }

    /// Whether a flight ends where it leaves the table.
    pub fn refuses(&self) -> bool {
        self.rule == Extrapolation::Refuse && self.level != [true; 2]
    }

    /// Excess of a value beyond an end that is not level, in its unit; zero or less within the table.
    pub fn refused_excess(&self, value: f64) -> f64 {
        let ([first, last], [level_first, level_last]) = (self.ends, self.level);
        let beyond = |level: bool, excess: f64| if level { f64::NEG_INFINITY } else { excess };
        beyond(level_first, first - value).max(beyond(level_last, value - last))
            - SLACK * (last - first)
    }

    /// The sentence of a flight that ends where it leaves the table.
    pub fn refusal(&self) -> String {
        let ([first, last], unit) = self.shown_ends();
        format!(
            "the {} left {}, which goes from {first} to {last}{unit}; beyond, the case refuses to go on",
            self.argument.name(),
            self.key
        )
    }

    fn shown_ends(&self) -> ([String; 2], &'static str) {
        let unit = self.argument.shown(0.0).1;
        (self.ends.map(|end| short(self.argument.shown(end).0)), unit)
    }
}

/// Range of an axis used in a flight: the least and the greatest value, each with its time, s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span {
    least: [f64; 2],
    greatest: [f64; 2],
}

impl Span {
    /// Nothing yet.
    pub const EMPTY: Span = Span {
        least: [f64::INFINITY, 0.0],
        greatest: [f64::NEG_INFINITY, 0.0],
    };

    /// Range of a single value at the start.
    pub fn at(value: f64) -> Span {
        Span {
            least: [value, 0.0],
            greatest: [value, 0.0],
        }
    }

    /// The least and the greatest value.
    pub fn ends(&self) -> [f64; 2] {
        [self.least[0], self.greatest[0]]
    }

    /// Extends the range by a value at a time, s.
    pub fn take(&mut self, value: f64, time_s: f64) {
        if value < self.least[0] {
            self.least = [value, time_s];
        }
        if value > self.greatest[0] {
            self.greatest = [value, time_s];
        }
    }
}

/// An end of a table that a flight passed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Passed {
    /// Key of the table in the case.
    pub key: String,
    /// Argument of the look-up.
    pub argument: Argument,
    /// First and last row.
    pub ends: [f64; 2],
    /// The farthest value beyond, and its time, s.
    pub farthest: [f64; 2],
    /// Rule beyond the ends.
    pub rule: Extrapolation,
}

/// The ends that were passed; `refused` is the axis at whose end the flight was ended, with an excess of zero.
pub fn passed(axes: &[Axis], spans: &[Span], refused: Option<usize>) -> Vec<Passed> {
    let both = axes
        .iter()
        .zip(spans)
        .enumerate()
        .flat_map(|(index, (axis, span))| {
            let [first, last] = axis.ends;
            let slack = axis.slack;
            let beyond = [
                (span.least, first - span.least[0]),
                (span.greatest, span.greatest[0] - last),
            ];
            let most = if refused == Some(index) {
                beyond[0].1.max(beyond[1].1)
            } else {
                f64::INFINITY
            };
            let beyond = beyond.into_iter().zip(axis.level);
            let beyond =
                beyond.filter(move |((_, by), _)| (*by > slack || *by >= most) && by.is_finite());
            beyond.map(|((farthest, _), level)| Passed {
                key: axis.key.to_string(),
                argument: axis.argument,
                ends: axis.ends,
                farthest,
                rule: if level {
                    Extrapolation::Hold
                } else {
                    axis.rule
                },
            })
        });
    both.collect()
}

impl Passed {
    /// The remark.
    pub fn finding(&self) -> Finding {
        if self.key == ATMOSPHERE {
            return self.of_atmosphere();
        }
        let shown = |value: f64| self.argument.shown(value);
        let [first, last] = self.ends.map(|end| shown(end).0);
        let (value, unit) = shown(self.farthest[0]);
        let time_s = short(self.farthest[1]);
        let then = match self.rule {
            Extrapolation::Hold => "beyond, the end is held",
            Extrapolation::Extend => "beyond, the last slope goes on",
            Extrapolation::Refuse => "there the flight was ended",
        };
        let name = self.argument.name();
        Finding {
            severity: Severity::Extrapolated,
            model: self.key.clone(),
            key: self.argument.key().to_string(),
            value: Some(value),
            valid: (Some(first), Some(last)),
            message: format!(
                "The {name} reaches {}{unit} at {time_s} s, the table goes from {} to {}{unit}; {then}.",
                short(value),
                short(first),
                short(last),
            ),
            source: "the rows given".to_string(),
            field: Some(self.key.clone()),
        }
    }

    /// Finding for the atmosphere, with the input that leads beyond the table.
    fn of_atmosphere(&self) -> Finding {
        let ([bottom_m, top_m], value) = (self.ends, self.farthest[0]);
        let key = match value > top_m {
            true => input::entry::ALTITUDE_M.key,
            false => input::stop::ALTITUDE_M.key,
        };
        let rule = match self.rule {
            Extrapolation::Hold => {
                "beyond, density is held, for it grows with height in the last rows"
            }
            Extrapolation::Extend => "beyond, density goes on with its last slope",
            Extrapolation::Refuse => "there the flight was ended",
        };
        Finding {
            severity: Severity::Extrapolated,
            model: ATMOSPHERE.to_string(),
            key: key.to_string(),
            value: Some(value),
            valid: (Some(bottom_m), Some(top_m)),
            message: format!(
                "The flight reaches {value:.0} m, the atmosphere is given from {bottom_m:.0} to {top_m:.0} m; {rule}."
            ),
            source: "convention of this program".to_string(),
            field: Some(key.to_string()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MACH: Axis = Axis {
        key: "vehicle.drag_table",
        argument: Argument::Mach,
        ends: [0.5, 25.0],
        rule: Extrapolation::Hold,
        level: [false; 2],
        slack: 0.0,
    };

    #[test]
    fn a_table_that_is_level_at_its_end_is_not_refused_there() {
        let axis = Axis {
            rule: Extrapolation::Refuse,
            level: [false, true],
            ..MACH
        };
        assert!(axis.refuses() && axis.refused_excess(40.0) < 0.0);
        assert!((axis.refused_excess(0.4) - 0.1).abs() < 1e-6);
        let mut span = Span::EMPTY;
        span.take(40.0, 1.0);
        let [passed] = &passed(&[axis], &[span], None)[..] else {
            unreachable!("one end is passed")
        };
        assert!(passed.finding().message.ends_with("the end is held."));
    }

    #[test]
    fn both_ends_may_be_passed_and_each_is_said_with_the_farthest_value() {
        let mut span = Span::EMPTY;
        for (value, time_s) in [(30.0, 0.0), (41.0, 20.0), (0.5, 200.0), (0.1, 300.0)] {
            span.take(value, time_s);
        }
        let said: Vec<String> = passed(&[MACH], &[span], None)
            .iter()
            .map(|passed| passed.finding().message)
            .collect();
        assert_eq!(
            said,
            [
                "The Mach number reaches 0.1 at 300 s, the table goes from 0.5 to 25; beyond, the end is held.",
                "The Mach number reaches 41 at 20 s, the table goes from 0.5 to 25; beyond, the end is held."
            ]
        );
    }

    #[test]
    fn nothing_is_said_within_and_where_nothing_was_looked_up() {
        let mut span = Span::EMPTY;
        assert!(passed(&[MACH], &[span], None).is_empty());
        span.take(0.5, 0.0);
        span.take(f64::NAN, 1.0);
        span.take(25.0, 2.0);
        assert!(passed(&[MACH], &[span], None).is_empty());
        // A flight that was ended at the end of the table gets a finding of that.
        let mut ended = Span::EMPTY;
        ended.take(24.0, 0.0);
        ended.take(25.0, 9.0);
        let [passed] = &passed(&[MACH], &[ended], Some(0))[..] else {
            unreachable!("the upper end is passed")
        };
        assert_eq!(passed.farthest, [25.0, 9.0]);
    }

    #[test]
    fn a_refusal_names_table_and_range() {
        let axis = Axis {
            argument: Argument::TotalAlpha,
            ends: [0.0, 30.0 * RADIANS_PER_DEGREE],
            ..MACH
        };
        assert_eq!(
            axis.refusal(),
            "the total angle of attack left vehicle.drag_table, which goes from 0 to 30 deg; beyond, the case refuses to go on"
        );
    }
}
