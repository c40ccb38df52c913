//! Three degrees of freedom: a point mass from the entry state to the end of the flight.
//!
//! ```text
//! y' = f(t, y),   y = (r, v, Q)
//! ```
//!
//! with r, v position (m) and velocity (m/s) in planet-fixed axes and Q the heat loads (J/m²): the equations of
//! [`super::equations`], integrated by [`super::integration`].
//!
//! # Valid
//! Ballistic flight, and flight with lift at a given angle of bank or at trim.
//!
//! # References
//! - \[samareh-2014\] section 3.2.

use super::equations::{Equations, STATES};
use super::integration::{self, Keep, Record};
use super::mission::{Body, Mission, Start};
use super::motion::PointMass;
use super::numbers::Numbers;
use super::summary::{self, Extremes};
use super::{Flight, Request};
use crate::outcome::Outcome;
use numerics::scalar::{Scalar, Single};

/// State at the start.
pub fn start<S: Scalar>(start: &Start<S>) -> [S; STATES] {
    let [x, y, z] = start.position_m;
    let [vx, vy, vz] = start.velocity_m_s;
    let none = S::constant(0.0);
    [x, y, z, vx, vy, vz, none, none]
}

/// The motion of a point mass.
pub fn motion<'a>(mission: &'a Mission, body: &'a Body) -> PointMass<'a> {
    PointMass {
        point: Equations::new(mission, body),
    }
}

/// Integrates a flight.
pub fn integrate(mission: &Mission, body: &Body) -> Record<STATES> {
    integration::integrate(motion(mission, body), start(&mission.start), Keep::All)
}

/// Flies with numbers of their own, derivatives included: the flight, how it ended, and why.
pub fn fly_with<S: Single>(
    mission: &Mission,
    body: &Body,
    numbers: Numbers<S>,
    request: Request,
) -> (Flight<S>, Outcome, Option<String>) {
    let motion = PointMass {
        point: Equations::with_numbers(mission, body, numbers),
    };
    let record = integration::integrate(motion, start(&numbers.start), Keep::All);
    let flight = summary::summarize(motion, &record, request);
    (flight, record.outcome, record.reason)
}

/// The few results that sizing a vehicle needs, at a fraction of the cost of a whole flight; outcome and its reason.
pub fn extremes<S: Single>(
    mission: &Mission,
    body: &Body,
    numbers: Numbers<S>,
) -> (Extremes<S>, Outcome, Option<String>) {
    let motion = PointMass {
        point: Equations::with_numbers(mission, body, numbers),
    };
    let record = integration::integrate(motion, start(&numbers.start), Keep::Busy);
    let extremes = summary::extremes(motion, &record);
    (extremes, record.outcome, record.reason)
}
