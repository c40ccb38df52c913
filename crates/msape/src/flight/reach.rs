//! Tables of a case that a flight looks up: where it leaves them, and what is said of it.
//!
//! ```text
//! x < first or x > last        with x what a table is looked up with
//! ```
//!
//! with x an altitude in m, a speed in m/s, a Mach or Knudsen number, a time in s or a total angle of attack in rad.
//!
//! # Valid
//! Tables that a case brings. Those of the library are held beyond their ends by their own sources.
//!
//! # References
//! - Own convention.

use super::freedom::Freedom;
use super::lift::{Bank, Source};
use super::mission::{Body, Mission};
use super::six_dof::aerodynamics::Aerodynamics;
use crate::aero::damping::Damping;
use crate::aero::database::Database;
use crate::aero::table::{Extrapolation, Grid};
use crate::aero::{Drag, DragTable};
use crate::finding::range::short;
use crate::finding::{Finding, Severity};
use crate::planet::wind::Wind;
use numerics::math::RADIANS_PER_DEGREE;
use serde::{Deserialize, Serialize};

/// With what a table is looked up.
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
}

/// A number for each [`Argument`], in their order; not a number where a motion has none.
pub type Arguments<S> = [S; 6];

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
        }
    }

    /// A value as it is shown, and its unit.
    fn shown(self, value: f64) -> (f64, &'static str) {
        match self {
            Argument::Altitude => (value, " m"),
            Argument::AirSpeed => (value, " m/s"),
            Argument::Time => (value, " s"),
            Argument::TotalAlpha => (value / RADIANS_PER_DEGREE, " deg"),
            Argument::Mach | Argument::Knudsen => (value, ""),
        }
    }
}

/// One axis of a table of the case.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis {
    /// Key of the table in the case.
    pub key: &'static str,
    /// With what it is looked up.
    pub argument: Argument,
    /// First and last row.
    pub ends: [f64; 2],
    /// What holds beyond.
    pub rule: Extrapolation,
    /// Whether the table is level at each end: its last two rows are alike, so that every rule goes on with them.
    pub level: [bool; 2],
}

/// Part of the length of an axis by which rounding may leave it.
const SLACK: f64 = 1e-9;

impl Axis {
    fn held(key: &'static str, argument: Argument, ends: [f64; 2]) -> Axis {
        Axis {
            key,
            argument,
            ends,
            rule: Extrapolation::Hold,
            level: [false; 2],
        }
    }

    /// Whether a flight ends where it leaves the table.
    pub fn refuses(&self) -> bool {
        self.rule == Extrapolation::Refuse && self.level != [true; 2]
    }

    /// How far a value is beyond an end that is not level, in its unit; zero or less where it is not.
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

/// The tables of the case that a flight of this vehicle looks up, one entry an axis.
pub fn axes(mission: &Mission, body: &Body) -> Vec<Axis> {
    let mut axes = Vec::new();
    if let Wind::Table(table) = &mission.wind {
        axes.push(Axis::held("wind.table", Argument::Altitude, table.ends_m()));
    }
    match &body.freedom {
        Freedom::Ballistic => of_drag(&body.drag, &mut axes),
        Freedom::Lifting(lift) => {
            match &lift.source {
                Source::OfDrag(_) | Source::Coefficient(_) => of_drag(&body.drag, &mut axes),
                Source::Table(table, rule) => {
                    of_drag(&body.drag, &mut axes);
                    axes.push(Axis {
                        rule: *rule,
                        ..Axis::held("vehicle.lift_table", Argument::Mach, table.ends())
                    });
                }
                Source::Trim(trim) => axes.extend(&trim.axes),
            }
            match &lift.bank {
                Bank::Constant(_) => {}
                Bank::OfTime(table) => {
                    let key = "vehicle.bank_table_deg";
                    axes.push(Axis::held(key, Argument::Time, table.ends()));
                }
                Bank::OfSpeed(table) => {
                    let key = "vehicle.bank_speed_table_deg";
                    axes.push(Axis::held(key, Argument::AirSpeed, table.ends()));
                }
            }
        }
        Freedom::Rigid(rigid) => match &rigid.aerodynamics {
            Aerodynamics::Drag => of_drag(&body.drag, &mut axes),
            Aerodynamics::Constants(_) => {}
            Aerodynamics::Database(of) => {
                axes.extend(of_database(&of.database));
                if of.database.table().is_none() {
                    of_drag_table(of.axial_force.as_ref(), &mut axes);
                }
            }
        },
    }
    axes
}

fn of_drag(drag: &Drag, axes: &mut Vec<Axis>) {
    if let Drag::Table(table) = drag {
        of_drag_table(Some(table), axes);
    }
}

fn of_drag_table(table: Option<&DragTable>, axes: &mut Vec<Axis>) {
    let own = table.and_then(|table| Some((table.own()?, table)));
    axes.extend(own.map(|(own, table)| Axis {
        rule: own.extrapolation,
        level: table.level(),
        ..Axis::held(own.key, Argument::Mach, table.ends())
    }));
}

/// Axes of the tables in a database.
pub fn of_database(database: &Database) -> Vec<Axis> {
    let grid = |key: &'static str, grid: &Grid| {
        let rule = grid.extrapolation;
        let arguments = [Argument::Mach, Argument::TotalAlpha, Argument::Knudsen];
        let level = grid.level();
        let ends = arguments.into_iter().zip(grid.ends()).zip(level);
        let axis = move |((argument, ends), level): ((Argument, Option<[f64; 2]>), [bool; 2])| {
            let held = Axis::held(key, argument, ends?);
            Some(Axis {
                rule,
                level,
                ..held
            })
        };
        ends.filter_map(axis).collect::<Vec<Axis>>()
    };
    let mut axes = Vec::new();
    if let Some(table) = database.table() {
        axes.extend(grid("vehicle.aerodynamics.table", table));
    }
    match database.damping() {
        Damping::Table(table) if Some(table) != database.table() => {
            axes.extend(grid("vehicle.aerodynamics.damping_table", table));
        }
        _ => {}
    }
    axes
}

/// What a flight looked up in one axis: the least and the greatest value, each with its time, s.
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

    /// Takes in a value at a time, s.
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
    /// With what it is looked up.
    pub argument: Argument,
    /// First and last row.
    pub ends: [f64; 2],
    /// The farthest value beyond, and its time, s.
    pub farthest: [f64; 2],
    /// What holds there.
    pub rule: Extrapolation,
}

/// The ends that were passed; `refused` is the axis at whose end the flight was ended, which it passed by nothing.
pub fn passed(axes: &[Axis], spans: &[Span], refused: Option<usize>) -> Vec<Passed> {
    let both = axes
        .iter()
        .zip(spans)
        .enumerate()
        .flat_map(|(index, (axis, span))| {
            let [first, last] = axis.ends;
            let slack = SLACK * (last - first);
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
}

/// The least drag coefficient of a flight, where the air would push.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Push {
    /// Drag coefficient, below zero.
    pub drag_coefficient: f64,
    /// Total angle of attack there, rad.
    pub total_alpha_rad: f64,
    /// Mach number there.
    pub mach: f64,
    /// Time after the start, s.
    pub time_s: f64,
}

impl Push {
    /// The remark.
    pub fn finding(&self) -> Finding {
        let alpha_deg = self.total_alpha_rad / RADIANS_PER_DEGREE;
        let at = match alpha_deg.is_finite() {
            true => format!(" at a total angle of attack of {} deg", short(alpha_deg)),
            false => String::new(),
        };
        Finding {
            severity: Severity::Exceeded,
            model: "aerodynamic coefficients".to_string(),
            key: "drag_coefficient".to_string(),
            value: Some(self.drag_coefficient),
            valid: (Some(0.0), None),
            message: format!(
                "The drag coefficient is {}{at} and Mach {}, at {} s: there the air pushes the vehicle, which no air does; the flight is not to be used.",
                short(self.drag_coefficient),
                short(self.mach),
                short(self.time_s)
            ),
            source: "first law of thermodynamics".to_string(),
            field: Some("vehicle.aerodynamics".to_string()),
        }
    }
}

/// Whether the coefficients of a vehicle may come to a drag below zero: where they are a case's own.
pub fn may_push(body: &Body) -> bool {
    let extended = |table: &DragTable| {
        let own = table.own();
        own.is_some_and(|own| own.extrapolation == Extrapolation::Extend)
    };
    let by_drag = matches!(&body.drag, Drag::Table(table) if extended(table));
    match &body.freedom {
        Freedom::Ballistic => by_drag,
        Freedom::Lifting(lift) => match &lift.source {
            Source::Trim(trim) => !trim.axes.is_empty(),
            _ => by_drag,
        },
        Freedom::Rigid(rigid) => match &rigid.aerodynamics {
            Aerodynamics::Drag => by_drag,
            Aerodynamics::Constants(_) => true,
            Aerodynamics::Database(of) => of.database.table().is_some(),
        },
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
        // Where the flight was ended at the end of the table, that is said.
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
