//! Inputs of a planet that the case brings.

use super::{Alternatives, CONVENTION, Group, Input, REPORT_FLIGHT, Range};
use crate::quantity::Task;
use crate::units::Dimension;

/// Range of radii, from an asteroid to a flat surface, m: the resolution of altitudes remains two millimeters.
const RADIUS: Range = Range::closed(100.0, 1e13);

/// Ways to give the gravity of a planet.
pub static GRAVITY: Alternatives = Alternatives {
    asked_as: None,
    ways: &[&[&MU_M3_S2], &[&UNIFORM_GRAVITY_M_S2]],
};

inputs! {
    Task::ALL;
    MU_M3_S2: "planet.mu_m3_s2" = Input::number("Gravitational Parameter", Group::Models, Dimension::GravitationalParameter, Range::above(0.0, 1e28))
        .unit("m^3/s^2")
        .aliases(&["planet.mu_m3s2", "planet.gravitational_parameter_m3_s2"])
        .one_way_of(&GRAVITY)
        .help("Gravitational parameter of a planet given in the case itself.", CONVENTION);
    EQUATORIAL_RADIUS_M: "planet.equatorial_radius_m" = Input::number("Equatorial Radius", Group::Models, Dimension::Length, RADIUS)
        .unit("m")
        .aliases(&["planet.radius_m", "planet.r_equatorial_m"])
        .help("Equatorial radius of a planet given in the case itself; alone it makes a sphere.", CONVENTION);
    POLAR_RADIUS_M: "planet.polar_radius_m" = Input::number("Polar Radius", Group::Models, Dimension::Length, RADIUS)
        .unit("m")
        .aliases(&["planet.r_polar_m"])
        .help("Polar radius of a planet given in the case itself; the equatorial radius when absent.", CONVENTION);
    ROTATION_RATE_RAD_S: "planet.rotation_rate_rad_s" = Input::number("Rotation Rate", Group::Models, Dimension::AngularRate, Range::closed(-1.0, 1.0))
        .unit("rad/s")
        .aliases(&["planet.omega_rad_s", "planet.omega_rads"])
        .help("Rate of rotation, eastward positive; zero when absent.", CONVENTION);
    J2: "planet.j2" = Input::number("J2", Group::Models, Dimension::One, Range::closed(-1.0, 1.0))
        .help("Zonal coefficient of degree 2; zero when absent.", REPORT_FLIGHT);
    J3: "planet.j3" = Input::number("J3", Group::Models, Dimension::One, Range::closed(-1.0, 1.0))
        .help("Zonal coefficient of degree 3; zero when absent.", REPORT_FLIGHT);
    J4: "planet.j4" = Input::number("J4", Group::Models, Dimension::One, Range::closed(-1.0, 1.0))
        .help("Zonal coefficient of degree 4; zero when absent.", REPORT_FLIGHT);
    J_REFERENCE_RADIUS_M: "planet.j_reference_radius_m" = Input::number("Reference Radius of J2-J4", Group::Models, Dimension::Length, RADIUS)
        .unit("m")
        .aliases(&["planet.reference_radius_m", "planet.j_ref_radius_m"])
        .help("Radius to which the zonal coefficients belong; the equatorial radius when absent.", CONVENTION);
    UNIFORM_GRAVITY_M_S2: "planet.uniform_gravity_m_s2" = Input::number("Uniform Gravity", Group::Models, Dimension::Acceleration, Range::closed(0.0, 1e4))
        .unit("m/s^2")
        .aliases(&["planet.gravity_m_s2", "planet.g_m_s2"])
        .one_way_of(&GRAVITY)
        .help("Gravity of constant magnitude towards the center, instead of the gravitational parameter.", CONVENTION);
}
