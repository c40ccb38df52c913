//! Six degrees of freedom: a rigid body from the entry state to the end of the flight.
//!
//! ```text
//! y' = f(t, y),   y = (r, v, Q, q, ω)
//! ```
//!
//! with r, v position (m) and velocity (m/s) in planet-fixed axes, Q the heat loads (J/m²), q the attitude and ω the
//! inertial rates (rad/s): the equations of [`motion`], integrated by [`super::integration`] over the same planet, air and
//! wind as a point mass.
//!
//! - [`rigid`], [`inertia`], [`aerodynamics`]: the body.
//! - [`quaternion`], [`attitude`]: its attitude.
//! - [`events`], [`remarks`]: events of the attitude, and findings about it.
//! - [`reorientation`], [`turning`]: backward entries, over places of the center of gravity, and from a set of attitudes and rates.
//!
//! # Valid
//! Rigid bodies of constant mass.
//!
//! # References
//! - \[samareh-2014\] section 3.2; \[stevens-lewis-2016\] section 1.7.

pub mod aerodynamics;
pub mod attitude;
pub mod events;
pub mod inertia;
pub mod motion;
pub mod quaternion;
pub mod remarks;
pub mod reorientation;
pub mod rigid;
pub mod turning;

use super::equations::Equations;
use super::integration::{self, Record};
use super::mission::{Body, Mission, Model};
use super::{Flight, Request, summary, three_dof};
use crate::outcome::Outcome;
use crate::progress::{Progress, Unwatched};
use events::Marks;
use motion::{ATTITUDE, RATES, RIGID_STATES, RigidMotion};
use rigid::Rigid;

/// State at the start.
pub fn start(mission: &Mission, rigid: &Rigid) -> [f64; RIGID_STATES] {
    let point = three_dof::start(&mission.start);
    let attitude = quaternion::parts(&rigid.attitude);
    core::array::from_fn(|i| match i {
        0..ATTITUDE => point[i],
        ATTITUDE..RATES => attitude[i - ATTITUDE],
        _ => rigid.rates_rad_s[i - RATES],
    })
}

/// The motion of a rigid body.
pub fn motion<'a>(mission: &'a Mission, body: &'a Body, rigid: &'a Rigid) -> RigidMotion<'a> {
    RigidMotion {
        point: Equations::new(mission, body),
        rigid,
    }
}

/// Integrates a flight; `progress` is called at each step and may stop it there.
pub fn integrate(
    mission: &Mission,
    body: &Body,
    rigid: &Rigid,
    progress: &mut dyn Progress,
) -> Record<RIGID_STATES> {
    let start = start(mission, rigid);
    integration::integrate_watched(motion(mission, body, rigid), start, progress)
}

/// Flies a rigid body: the flight, how it ended, and why.
pub fn fly(
    mission: &Mission,
    body: &Body,
    rigid: &Rigid,
    request: Request,
) -> (Flight, Outcome, Option<String>) {
    fly_watched(mission, body, rigid, request, &mut Unwatched)
}

/// Flies a rigid body as [`fly`] does; `progress` is called at each step and may stop the flight there.
pub fn fly_watched(
    mission: &Mission,
    body: &Body,
    rigid: &Rigid,
    request: Request,
    progress: &mut dyn Progress,
) -> (Flight, Outcome, Option<String>) {
    let record = integrate(mission, body, rigid, progress);
    let motion = motion(mission, body, rigid);
    let mut flight = summary::summarize(motion, &record, request);
    flight.model = Model::SixDof;
    let marks = Marks {
        peak_heating_time_s: flight.peak_total_heat_flux_w_m2.time_s,
        peak_deceleration_time_s: flight.peak_deceleration_earth_g.time_s,
    };
    flight.attitude = Some(events::events(motion, &record, marks));
    (flight, record.outcome, record.reason)
}

#[cfg(test)]
mod tests;
