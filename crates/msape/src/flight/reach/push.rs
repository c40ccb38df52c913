//! Negative drag coefficients, at which the air would push a vehicle forward, as air cannot.
//!
//! ```text
//! C_D < 0
//! ```
//!
//! # Valid
//! Bodies without engines.
//!
//! # References
//! - First law of thermodynamics.

use crate::aero::Drag;
use crate::aero::DragTable;
use crate::aero::table::Extrapolation;
use crate::finding::range::short;
use crate::finding::{Finding, Severity};
use crate::flight::freedom::Freedom;
use crate::flight::lift::Source;
use crate::flight::mission::Body;
use crate::flight::six_dof::aerodynamics::Aerodynamics;
use crate::quantity::input;
use numerics::math::RADIANS_PER_DEGREE;
use serde::{Deserialize, Serialize};

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
            field: Some(input::vehicle::AERODYNAMICS.to_string()),
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
