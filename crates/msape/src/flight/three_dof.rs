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
use super::integration::{self, Record};
use super::mission::{Body, Mission};
use super::motion::PointMass;

/// State at the start.
pub fn start(mission: &Mission) -> [f64; STATES] {
    let [x, y, z] = mission.start.position_m;
    let [vx, vy, vz] = mission.start.velocity_m_s;
    [x, y, z, vx, vy, vz, 0.0, 0.0]
}

/// The motion of a point mass.
pub fn motion<'a>(mission: &'a Mission, body: &'a Body) -> PointMass<'a> {
    PointMass {
        point: Equations::new(mission, body, 0),
    }
}

/// Integrates a flight.
pub fn integrate(mission: &Mission, body: &Body) -> Record<STATES> {
    integration::integrate(motion(mission, body), start(mission))
}
