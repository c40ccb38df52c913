//! Phases of a flight: their start, and the changes that they make.
//!
//! ```text
//! D = ½ ρ |u| u (C_D A + (C_D S)(t)),   (C_D S)(t) = C_D S min(1, (t − t₀)/t_i)
//! ```
//!
//! with D in N, ρ in kg/m³, u the velocity relative to the air in m/s, C_D A of the vehicle and C_D S of the parachute in m²,
//! t₀ the start of the phase and t_i the time of inflation in s.
//!
//! # Valid
//! Phases begin in the order in which they are given; a phase whose value was passed before it was next in order begins
//! with the one before. A parachute is a drag along the velocity of its attachment point; it has no mass of its own,
//! and its drag area grows evenly while it inflates.
//!
//! # References
//! - \[knacke-1991\] chapter 5 (drag area while inflating); the even growth is \[assumed\].

use super::mission::Mission;
use super::within::Within;
use crate::finding::range::short;
use crate::finding::{Finding, Severity};
pub use crate::quantity::choice::Direction;
use crate::quantity::input;
use numerics::scalar::Scalar;
use serde::{Deserialize, Serialize};

/// A phase.
#[derive(Clone, Debug, PartialEq)]
pub struct Phase {
    /// Name of the phase.
    pub name: String,
    /// Condition that begins it.
    pub begin: Begin,
    /// Changes that it makes.
    pub change: Change,
}

/// Start of a phase: a quantity passes a value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Begin {
    /// Quantity to compare.
    pub mark: Mark,
    /// Value of the quantity, SI; Earth g for the deceleration.
    pub value: f64,
    /// Direction in which it passes.
    pub direction: Direction,
}

/// Quantity that begins a phase.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// Time after the start, s.
    Time,
    /// Geodetic altitude, m.
    Altitude,
    /// Mach number.
    Mach,
    /// Dynamic pressure, Pa.
    DynamicPressure,
    /// Aerodynamic force over mass, Earth g.
    Deceleration,
}

impl Mark {
    /// Name and unit in a sentence.
    pub fn name(self) -> (&'static str, &'static str) {
        match self {
            Mark::Time => ("time", " s"),
            Mark::Altitude => ("altitude", " m"),
            Mark::Mach => ("Mach number", ""),
            Mark::DynamicPressure => ("dynamic pressure", " Pa"),
            Mark::Deceleration => ("deceleration", " Earth g"),
        }
    }
}

/// Changes made by a phase; absent values stay as they are.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Change {
    /// Mass from then on, kg.
    pub mass_kg: Option<f64>,
    /// Reference area of the drag coefficient, m².
    pub reference_area_m2: Option<f64>,
    /// Drag coefficient of the vehicle, the same at every Mach number.
    pub drag_coefficient: Option<f64>,
    /// Parachute, in the place of the one before.
    pub canopy: Option<Canopy>,
}

/// A parachute.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Canopy {
    /// Drag coefficient times area, m².
    pub drag_area_m2: f64,
    /// Time in which it grows to that, s.
    pub inflation_s: f64,
    /// Attachment point: x aft of the virtual apex, y to the right, z down, m; for a rigid body only.
    pub attachment_m: [f64; 3],
}

/// Changes made by the phases so far in the equations of a point mass, one per lane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Changed<S> {
    /// 1 where the drag coefficient is the same at every Mach number by a phase, else 0.
    pub constant_drag: S,
    /// Full drag area of the parachute, m².
    pub canopy_m2: S,
    /// Start of the inflation, s after the start.
    pub canopy_since_s: S,
    /// Time in which it inflates, s; above zero.
    pub inflation_s: S,
    /// Attachment point, as [`Canopy::attachment_m`].
    pub attachment_m: [S; 3],
}

impl<S: Scalar> Changed<S> {
    /// Nothing.
    pub fn nothing() -> Self {
        let zero = S::constant(0.0);
        Changed {
            constant_drag: zero,
            canopy_m2: zero,
            canopy_since_s: zero,
            inflation_s: S::constant(1.0),
            attachment_m: [zero; 3],
        }
    }

    /// Drag area of the parachute at a time, s, in m².
    #[inline]
    pub fn canopy_m2(&self, t: S) -> S {
        let part = (t - self.canopy_since_s) / self.inflation_s;
        self.canopy_m2 * part.clamp(S::constant(0.0), S::constant(1.0))
    }

    /// Replaces one lane.
    pub fn set_lane(&mut self, lane: usize, of: &Changed<S::Lane>) {
        self.constant_drag.set_lane(lane, of.constant_drag);
        self.canopy_m2.set_lane(lane, of.canopy_m2);
        self.canopy_since_s.set_lane(lane, of.canopy_since_s);
        self.inflation_s.set_lane(lane, of.inflation_s);
        for (all, one) in self.attachment_m.iter_mut().zip(of.attachment_m) {
            all.set_lane(lane, one);
        }
    }
}

/// Stage of a flight: its place among the rows of tables, the phases so far, and the start of the inflation of the
/// parachute.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stage<S = f64> {
    /// A place within the rows of tables that hold.
    pub within: Within,
    /// Number of phases that have begun.
    pub phases: usize,
    /// Start of the inflation of the parachute, s after the start.
    pub canopy_since_s: S,
}

impl<S: Scalar> Stage<S> {
    /// The stage about a place, before any phase.
    pub fn about(within: Within) -> Self {
        Stage {
            within,
            phases: 0,
            canopy_since_s: S::constant(0.0),
        }
    }
}

/// A phase that has begun.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Begun<S = f64> {
    /// Name of the phase.
    pub name: String,
    /// Time after the start, s.
    pub time_s: S,
    /// Geodetic altitude, m.
    pub altitude_m: S,
    /// Speed relative to the planet, m/s.
    pub speed_m_s: S,
    /// Mach number.
    pub mach: S,
    /// Dynamic pressure, Pa.
    pub dynamic_pressure_pa: S,
    /// Largest deceleration until the next phase or the end, Earth g.
    pub peak_deceleration_earth_g: S,
}

/// Remarks on phases that began at once, their value being passed, and of those that never began.
pub fn findings(mission: &Mission, begun: &[Begun]) -> Vec<Finding> {
    let mut findings: Vec<Finding> = Vec::new();
    for (index, pair) in begun.windows(2).enumerate() {
        let (Some(phase), [before, now]) = (mission.phases.get(index + 1), pair) else {
            continue;
        };
        if now.time_s > before.time_s {
            continue;
        }
        let (quantity, unit) = phase.begin.mark.name();
        findings.push(Finding {
            severity: Severity::Note,
            model: "phases".to_string(),
            key: format!("phase.{}", index + 2),
            value: Some(now.time_s),
            valid: (None, None),
            message: format!(
                "Phase {} began at once with {}, at {} s: the {quantity} had gone through {}{unit} by then.",
                now.name,
                before.name,
                short(now.time_s),
                short(phase.begin.value)
            ),
            source: "the case".to_string(),
            field: Some(input::phase::NAME.of_number(index + 2).to_string()),
        });
    }
    let late = mission.phases.iter().enumerate().skip(begun.len());
    let said = late.map(|(index, phase)| {
        let Begin {
            mark,
            value,
            direction,
        } = phase.begin;
        let (quantity, unit) = mark.name();
        let before = match index.checked_sub(1).and_then(|i| mission.phases.get(i)) {
            Some(before) => format!(" after {} had begun", before.name),
            None => String::new(),
        };
        let way = match (mark, direction) {
            (Mark::Time, _) => "never reached",
            (_, Direction::Rising) => "never rose through",
            (_, Direction::Falling) => "never fell through",
        };
        Finding {
            severity: Severity::Exceeded,
            model: "phases".to_string(),
            key: format!("phase.{}", index + 1),
            value: Some(value),
            valid: (None, None),
            message: format!(
                "Phase {} did not begin: the {quantity} {way} {}{unit}{before}.",
                phase.name,
                short(value)
            ),
            source: "the case".to_string(),
            field: Some(format!("phase.{}.name", index + 1)),
        }
    });
    findings.extend(said);
    findings
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_parachute_grows_evenly_and_stays() {
        let changed = Changed {
            canopy_m2: 8.0,
            canopy_since_s: 100.0,
            inflation_s: 4.0,
            ..Changed::nothing()
        };
        let areas = [99.0, 100.0, 101.0, 104.0, 200.0].map(|t| changed.canopy_m2(t));
        assert_eq!(areas, [0.0, 0.0, 2.0, 8.0, 8.0]);
    }

    #[test]
    fn a_phase_whose_value_is_passed_by_a_jump_begins_at_once() {
        let text = crate::library::data_file("cases/stardust.toml").unwrap();
        let library = crate::Library::builtin().unwrap();
        // a tenth of the mass: ten times the deceleration, which jumps up through 5 Earth g and over what falls through 5 later
        let begun = |direction: &str| {
            let phases = format!(
                "[[phase]]\nname = 'light'\nmach = 1.4\nmass_kg = 4.6\n[[phase]]\nname = 'next'\ndeceleration_earth_g = 5.0\ndirection = '{direction}'\ndrag_area_m2 = 5.0\n"
            );
            let case = crate::Case::from_text(&format!("{text}{phases}")).unwrap();
            let answer = crate::fly(&case, &library, crate::Request::Nothing).unwrap();
            let flight = answer.flight.unwrap();
            let [light, next] = &flight.phases[..] else {
                panic!("two phases begin: {:?}", flight.phases)
            };
            next.time_s - light.time_s
        };
        assert_eq!(begun("rising"), 0.0);
        let waited_s = begun("falling");
        assert!(waited_s > 0.5, "{waited_s}");
    }

    #[test]
    fn a_phase_whose_value_was_passed_begins_at_once_and_is_told() {
        let text = crate::library::data_file("cases/stardust.toml").unwrap();
        let phases = "
[[phase]]
name = 'drogue'
mach = 1.4
drag_area_m2 = 0.5
[[phase]]
name = 'main'
altitude_m = 80e3
drag_area_m2 = 5.0
[[phase]]
name = 'late'
deceleration_earth_g = 500.0
direction = 'rising'
";
        let case = crate::Case::from_text(&format!("{text}{phases}")).unwrap();
        let library = crate::Library::builtin().unwrap();
        let answer = crate::fly(&case, &library, crate::Request::Nothing).unwrap();
        let flight = answer.flight.unwrap();
        let [drogue, main] = &flight.phases[..] else {
            panic!("two phases begin: {:?}", flight.phases)
        };
        assert_eq!((drogue.time_s, &*main.name), (main.time_s, "main"));
        assert!((drogue.mach - 1.4).abs() < 1e-6, "{drogue:?}");
        let said: Vec<&str> = answer.findings.iter().map(|f| f.message.as_str()).collect();
        let has = |part: &str| said.iter().any(|message| message.contains(part));
        assert!(has("Phase main began at once with drogue"), "{said:?}");
        assert!(has("Phase late did not begin"), "{said:?}");
    }
}
