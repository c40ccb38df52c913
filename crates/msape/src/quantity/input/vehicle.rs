//! Inputs of a vehicle that is flown as it is.

pub(super) mod aerodynamics;
pub(super) mod freedom;

use super::{Alternatives, CONVENTION, Choices, Group, Input, Kind, Need, Range, column};
use crate::quantity::Task;
use crate::units::Dimension;

pub use aerodynamics::*;
pub use freedom::*;

/// Ways to give the reference area.
pub static AREA: Alternatives = Alternatives {
    asked_as: None,
    ways: &[&[&REFERENCE_AREA_M2], &[&DIAMETER_M]],
};

/// Ways to give the drag of a point mass; constants of force and moment are one.
pub static DRAG: Alternatives = Alternatives {
    asked_as: None,
    ways: &[
        &[&DRAG_COEFFICIENT],
        &[&DRAG_TABLE],
        &[&AERODYNAMICS],
        &[&AERODYNAMICS_TABLE],
        CONSTANTS,
    ],
};

/// Constants of force and moment; any of them makes force and moment constants.
pub static CONSTANTS: &[&Input] = &[
    &AERODYNAMICS_CA,
    &AERODYNAMICS_CN_ALPHA_PER_RAD,
    &AERODYNAMICS_CM_ALPHA_PER_RAD,
];

inputs! {
    &[Task::PointMass, Task::RigidBody];
    MASS_KG: "vehicle.mass_kg" = Input::number("Mass", Group::Vehicle, Dimension::Mass, Range::above(0.0, 1e6))
        .unit("kg")
        .need(Need::Fly)
        .help("Mass of the vehicle during the whole flight.", CONVENTION);
    REFERENCE_AREA_M2: "vehicle.reference_area_m2" = Input::number("Reference Area", Group::Vehicle, Dimension::Area, Range::above(0.0, 1e5))
        .unit("m^2")
        .one_way_of(&AREA)
        .help("Area to which the coefficients belong, or give the diameter.", CONVENTION);
    DIAMETER_M: "vehicle.diameter_m" = Input::number("Diameter", Group::Vehicle, Dimension::Length, Range::above(0.0, 300.0))
        .unit("m")
        .one_way_of(&AREA)
        .help("Diameter; the reference area is that of its circle.", CONVENTION);
    NOSE_RADIUS_M: "vehicle.nose_radius_m" = Input::number("Nose Radius", Group::Vehicle, Dimension::Length, Range::above(0.0, 1e3))
        .unit("m")
        .help("Radius of the nose, on which heating depends; that of the outline where there is one.", CONVENTION);
    DRAG_COEFFICIENT: "vehicle.drag_coefficient" = Input::number("Drag Coefficient", Group::Vehicle, Dimension::One, Range::closed(0.0, 100.0))
        .one_way_of(&DRAG)
        .help("Drag coefficient at every Mach number.", CONVENTION);
    DRAG_TABLE: "vehicle.drag_table" = Input::new("Drag Table", Group::Vehicle, Kind::Rows(&[column::MACH, column::DRAG_COEFFICIENT]))
        .one_way_of(&DRAG)
        .help("Rows of Mach number and drag coefficient, interpolated linearly, ends held.", CONVENTION);
    DRAG_FILE: "vehicle.drag_file" = Input::new("Drag File", Group::Vehicle, Kind::Text)
        .file_of(&[&DRAG_TABLE])
        .help("Name of a text file with Mach number and drag coefficient.", CONVENTION);
    AERODYNAMICS: "vehicle.aerodynamics" = Input::new("Aerodynamics", Group::Vehicle, Kind::Choice(Choices::Aerodynamics))
        .aliases(&["vehicle.aerodynamics.name"])
        .one_way_of(&DRAG)
        .tasks(Task::FLOWN)
        .help("Aerodynamic database by name.", CONVENTION);
}
