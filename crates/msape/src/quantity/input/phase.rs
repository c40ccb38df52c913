//! Inputs of the phases of a flight: `[[phase]]` of a case.

use super::repeated::Section;
use super::{CONVENTION, Group, Input, Kind, Range, column};
use crate::quantity::Task;
use crate::quantity::choice::{Choice, Direction};
use crate::units::Dimension;

const KNACKE: &str = "Knacke 1991, chapter 5";

/// The section.
pub const SECTION: Section = Section {
    name: "phase",
    most: 20,
    help: "What begins on the way, and what it changes.",
    list_help: "Phases of a flight, in the order in which they begin.",
    required: &["name"],
};

inputs! {
    Task::FLOWN;
    NAME: "phase.name" = Input::new("Phase", Group::Mission, Kind::Text)
        .help("Name of the phase, as it stands in time histories and events.", CONVENTION);
    TIME_S: "phase.time_s" = Input::number("Begins at Time", Group::Mission, Dimension::Time, Range::closed(0.0, 1e7))
        .unit("s")
        .help("Time after the start at which the phase begins; one of time, altitude, Mach number, dynamic pressure and deceleration.", CONVENTION);
    ALTITUDE_M: "phase.altitude_m" = Input::number("Begins at Altitude", Group::Mission, Dimension::Length, Range::closed(-1e6, 1e9))
        .unit("km")
        .help("Geodetic altitude at which the phase begins.", CONVENTION);
    MACH: "phase.mach" = Input::number("Begins at Mach Number", Group::Mission, Dimension::One, Range::above(0.0, 1e3))
        .help("Mach number at which the phase begins.", CONVENTION);
    DYNAMIC_PRESSURE_PA: "phase.dynamic_pressure_pa" = Input::number("Begins at Dynamic Pressure", Group::Mission, Dimension::Pressure, Range::above(0.0, 1e12))
        .unit("Pa")
        .help("Dynamic pressure at which the phase begins.", CONVENTION);
    DECELERATION_EARTH_G: "phase.deceleration_earth_g" = Input::number("Begins at Deceleration", Group::Mission, Dimension::Load, Range::above(0.0, 1e6))
        .unit("Earth g")
        .help("Aerodynamic force over mass over 9.80665 m/s^2 at which the phase begins.", CONVENTION);
    DIRECTION: "phase.direction" = Input::new("Direction", Group::Mission, Kind::Choice(Direction::CHOICES))
        .help("Whether the quantity falls or rises through its value when the phase begins; falling when absent. Where it did so before the turn of the phase, or jumps through it by what the phase before changes, and stands beyond it, the phase begins at once; where it has stood beyond it since the start, never, and that is told.", CONVENTION);
    MASS_KG: "phase.mass_kg" = Input::number("Mass from then on", Group::Mission, Dimension::Mass, Range::above(0.0, 1e6))
        .unit("kg")
        .help("Mass of the vehicle from the begin of the phase on, as after the heat shield is dropped; the one before when absent.", CONVENTION);
    REFERENCE_AREA_M2: "phase.reference_area_m2" = Input::number("Reference Area from then on", Group::Mission, Dimension::Area, Range::above(0.0, 1e5))
        .unit("m^2")
        .help("Area to which the coefficients belong from then on, of a rigid body all of force and moment; the one before when absent.", CONVENTION);
    DRAG_COEFFICIENT: "phase.drag_coefficient" = Input::number("Drag Coefficient from then on", Group::Mission, Dimension::One, Range::closed(0.0, 100.0))
        .help("Drag coefficient of a point mass, without parachute, at every Mach number from then on; as before when absent.", CONVENTION);
    DRAG_AREA_M2: "phase.drag_area_m2" = Input::number("Parachute Drag Area", Group::Mission, Dimension::Area, Range::closed(0.0, 1e5))
        .unit("m^2")
        .help("Drag coefficient times area of the parachutes that are out from then on, in the place of those before; 0 releases them.", KNACKE);
    INFLATION_S: "phase.inflation_s" = Input::number("Inflation Time", Group::Mission, Dimension::Time, Range::closed(0.0, 1e4))
        .unit("s")
        .help("Time in which the drag area of the parachutes grows evenly from nothing; at once when absent.", KNACKE);
    ATTACHMENT_M: "phase.attachment_m" = Input::new("Parachute Attachment", Group::Mission, Kind::Rows(&[column::X_M, column::Y_M, column::Z_M]))
        .one_row()
        .help("Point of a rigid body at which the parachutes pull, m: x aft of the virtual apex, y to the right, z down.", CONVENTION);
}
