//! Backward entries: one entry with the center of gravity at several places.
//!
//! ```text
//! α(Kn) for each x_cg,   turned: α < 90 deg at peak heating and ever after
//! ```
//!
//! with α the total angle of attack in rad, Kn the mean free path over the diameter, x_cg the place of the center of gravity
//! aft of the virtual apex in m.
//!
//! # Valid
//! Bodies with a database. Inertia is that of the case at every place of the center of gravity.
//!
//! # References
//! - \[samareh-2014\] section 3.3.2 and Figure 27.

use super::events::AttitudeEvents;
use crate::flight::freedom::Freedom;
use crate::flight::mission::{Body, Mission};
use crate::flight::{Request, fly};
use numerics::math::{FRAC_PI_2, RADIANS_PER_DEGREE};
use serde::{Deserialize, Serialize};

/// Orientation of a vehicle from peak heating on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Facing {
    /// Nose first from peak heating on.
    Forward,
    /// Nose first at peak heating, beyond 90 deg at some time after it.
    Unsteady,
    /// Aft end first at peak heating.
    Backward,
}

/// One entry of the study.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Reorientation {
    /// Center of gravity aft of the virtual apex, m.
    pub cg_x_m: f64,
    /// Knudsen number at each step of the flight up to peak heating.
    pub knudsen: Vec<f64>,
    /// Total angle of attack at the same steps, rad.
    pub total_alpha_rad: Vec<f64>,
    /// Orientation from peak heating on.
    pub facing: Facing,
    /// Events of the attitude.
    pub attitude: AttitudeEvents,
}

/// Flies a body with the center of gravity at several places aft of the virtual apex, m; empty where the body has no
/// attitude.
pub fn study(mission: &Mission, body: &Body, cg_x_m: &[f64]) -> Vec<Reorientation> {
    let entries = cg_x_m.iter().map(|x| entry(mission, body, *x));
    entries.flatten().collect()
}

fn entry(mission: &Mission, body: &Body, cg_x_m: f64) -> Option<Reorientation> {
    let mut body = body.clone();
    let Freedom::Rigid(rigid) = &mut body.freedom else {
        return None;
    };
    rigid.cg_m[0] = cg_x_m;
    let (flight, ..) = fly(mission, &body, Request::Steps);
    let heated_s = flight.peak_total_heat_flux_w_m2.time_s;
    let history = flight.trajectory?;
    let column = |key: &str| history.column(key).unwrap_or_default();
    let rows = column("time_s").partition_point(|t| *t <= heated_s);
    let attitude = flight.attitude?;
    let until = |key: &str, factor: f64| -> Vec<f64> {
        column(key).iter().take(rows).map(|x| x * factor).collect()
    };
    Some(Reorientation {
        cg_x_m,
        knudsen: until("knudsen", 1.0),
        total_alpha_rad: until("total_alpha_deg", RADIANS_PER_DEGREE),
        facing: facing(&attitude),
        attitude,
    })
}

/// Orientation of an entry from peak heating on.
pub(super) fn facing(attitude: &AttitudeEvents) -> Facing {
    if attitude.total_alpha_at_peak_heating_rad >= FRAC_PI_2 {
        Facing::Backward
    } else if attitude.maximum_total_alpha_after_peak_heating.angle_rad >= FRAC_PI_2 {
        Facing::Unsteady
    } else {
        Facing::Forward
    }
}
