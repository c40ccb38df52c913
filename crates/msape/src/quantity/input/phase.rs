//! Inputs of the phases of a flight: `[[phase]]` of a case.
//!
//! A key of the list, such as `phase.altitude_m`, stands for that of every phase: `phase.1.altitude_m`, `phase.2.altitude_m`.

use super::{Choices, Column, Group, Input, Kind, Range};
use crate::units::Dimension;

const CONVENTION: &str = "convention of this program";
const KNACKE: &str = "Knacke 1991, chapter 5";

/// Name of the section.
pub const SECTION: &str = "phase";
/// Most phases of a case.
pub const MOST: usize = 20;

const fn part(name: &'static str) -> Column {
    Column {
        name,
        required: true,
    }
}

pub(super) const INPUTS: &[Input] = &[
    Input::new("phase.name", "Phase", Group::Mission, Kind::Text)
        .help("Name of the phase, as it stands in time histories and events.", CONVENTION),
    Input::number("phase.time_s", "Begins at Time", Group::Mission, Dimension::Time, Range::closed(0.0, 1e7))
        .unit("s")
        .help("Time after the start at which the phase begins; one of time, altitude, Mach number, dynamic pressure and deceleration.", CONVENTION),
    Input::number("phase.altitude_m", "Begins at Altitude", Group::Mission, Dimension::Length, Range::closed(-1e6, 1e9))
        .unit("km")
        .help("Geodetic altitude at which the phase begins.", CONVENTION),
    Input::number("phase.mach", "Begins at Mach Number", Group::Mission, Dimension::One, Range::above(0.0, 1e3))
        .help("Mach number at which the phase begins.", CONVENTION),
    Input::number("phase.dynamic_pressure_pa", "Begins at Dynamic Pressure", Group::Mission, Dimension::Pressure, Range::above(0.0, 1e12))
        .unit("Pa")
        .help("Dynamic pressure at which the phase begins.", CONVENTION),
    Input::number("phase.deceleration_earth_g", "Begins at Deceleration", Group::Mission, Dimension::Load, Range::above(0.0, 1e6))
        .unit("Earth g")
        .help("Aerodynamic force over mass over 9.80665 m/s^2 at which the phase begins.", CONVENTION),
    Input::new(
        "phase.direction",
        "Direction",
        Group::Mission,
        Kind::Choice(Choices::Fixed(&[("falling", "Falling"), ("rising", "Rising")])),
    )
    .help("Whether the quantity falls or rises through its value when the phase begins; falling when absent. Where it did so before the turn of the phase, or jumps through it by what the phase before changes, and stands beyond it, the phase begins at once; where it has stood beyond it since the start, never, and that is told.", CONVENTION),
    Input::number("phase.mass_kg", "Mass from then on", Group::Mission, Dimension::Mass, Range::above(0.0, 1e6))
        .unit("kg")
        .help("Mass of the vehicle from the begin of the phase on, as after the heat shield is dropped; the one before when absent.", CONVENTION),
    Input::number("phase.reference_area_m2", "Reference Area from then on", Group::Mission, Dimension::Area, Range::above(0.0, 1e5))
        .unit("m^2")
        .help("Area to which the coefficients belong from then on, of a rigid body all of force and moment; the one before when absent.", CONVENTION),
    Input::number("phase.drag_coefficient", "Drag Coefficient from then on", Group::Mission, Dimension::One, Range::closed(0.0, 100.0))
        .help("Drag coefficient of a point mass, without parachute, at every Mach number from then on; as before when absent.", CONVENTION),
    Input::number("phase.drag_area_m2", "Parachute Drag Area", Group::Mission, Dimension::Area, Range::closed(0.0, 1e5))
        .unit("m^2")
        .help("Drag coefficient times area of the parachutes that are out from then on, in the place of those before; 0 releases them.", KNACKE),
    Input::number("phase.inflation_s", "Inflation Time", Group::Mission, Dimension::Time, Range::closed(0.0, 1e4))
        .unit("s")
        .help("Time in which the drag area of the parachutes grows evenly from nothing; at once when absent.", KNACKE),
    Input::new(
        "phase.attachment_m",
        "Parachute Attachment",
        Group::Mission,
        Kind::Rows(&[part("x_m"), part("y_m"), part("z_m")]),
    )
    .help("Point of a rigid body at which the parachutes pull, m: x aft of the virtual apex, y to the right, z down.", CONVENTION),
];

/// The number of the phase in a key, and the key that stands for it in the list; `None` where the key is of no phase.
pub(super) fn numbered(key: &str) -> Option<(usize, String)> {
    let (number, name) = key
        .strip_prefix(SECTION)?
        .strip_prefix('.')?
        .split_once('.')?;
    let index: usize = number.parse().ok()?;
    let plain = (1..=MOST).contains(&index) && number == index.to_string();
    plain.then(|| (index, format!("{SECTION}.{name}")))
}

/// Whether a key of the list stands for that of every phase.
pub fn is_repeated(key: &str) -> bool {
    key.strip_prefix(SECTION)
        .is_some_and(|rest| rest.starts_with('.'))
        && numbered(key).is_none()
}
