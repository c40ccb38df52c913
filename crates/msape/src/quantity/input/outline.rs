//! Inputs of an outline that is flown, or exported, as it is.

use super::{Alternatives, CONVENTION, Choices, Group, Input, Kind, Range, column};
use crate::quantity::Task;
use crate::quantity::choice::{AftOfCone, Choice, LengthUnit};
use crate::units::Dimension;

/// Ways to give an outline.
pub static OUTLINE: Alternatives = Alternatives {
    asked_as: None,
    ways: &[
        &[&PRESET],
        &[&POINTS],
        &[
            &CONE_HALF_ANGLE_DEG,
            &NOSE_RADIUS_M,
            &SHOULDER_RADIUS_M,
            &AFT,
        ],
    ],
};

inputs! {
    &[Task::PointMass, Task::RigidBody];
    PRESET: "outline.preset" = Input::new("Outline", Group::Vehicle, Kind::Choice(Choices::Outlines))
        .one_way_of(&OUTLINE)
        .help("Outline of a known vehicle by name; outline.diameter_m beside it scales it.", CONVENTION);
    DIAMETER_M: "outline.diameter_m" = Input::number("Outline Diameter", Group::Vehicle, Dimension::Length, Range::above(0.0, 300.0))
        .unit("m")
        .help("Largest diameter of a sphere-cone, or of the preset scaled to it.", CONVENTION);
    CONE_HALF_ANGLE_DEG: "outline.cone_half_angle_deg" = Input::number("Outline Cone Half-Angle", Group::Vehicle, Dimension::Angle, Range::closed(1.0, 89.0))
        .unit("deg")
        .usual(20.0, 70.0)
        .one_way_of(&OUTLINE)
        .help("Angle between the axis and the cone of a sphere-cone.", CONVENTION);
    NOSE_RADIUS_M: "outline.nose_radius_m" = Input::number("Outline Nose Radius", Group::Vehicle, Dimension::Length, Range::closed(0.0, 1e3))
        .unit("m")
        .one_way_of(&OUTLINE)
        .help("Radius of the nose of a sphere-cone; zero is a sharp cone.", CONVENTION);
    SHOULDER_RADIUS_M: "outline.shoulder_radius_m" = Input::number("Outline Shoulder Radius", Group::Vehicle, Dimension::Length, Range::closed(0.0, 150.0))
        .unit("m")
        .one_way_of(&OUTLINE)
        .help("Radius of the shoulder of a sphere-cone; zero is a sharp edge.", CONVENTION);
    AFT: "outline.aft" = Input::new("Outline Aftbody", Group::Vehicle, Kind::Choice(AftOfCone::CHOICES))
        .one_way_of(&OUTLINE)
        .help("Shape behind the half-torus shoulder of a sphere-cone; flat when absent.", CONVENTION);
    POINTS: "outline.points" = Input::new("Outline Points", Group::Vehicle, Kind::Rows(&[column::X_M, column::R_M, column::BULGE.optional()]))
        .one_way_of(&OUTLINE)
        .help("Points of an outline from the axis at the nose to the axis at the aft end; a bulge, the tangent of a quarter of its angle, makes the piece to the next point an arc.", CONVENTION);
    FILE: "outline.file" = Input::new("Outline File", Group::Vehicle, Kind::Text)
        .file_of(&[&POINTS])
        .help("Name of a CSV file with the points of the outline, or of a DXF drawing of it about the x axis.", CONVENTION);
    FILE_UNIT: "outline.file_unit" = Input::new("Outline File Unit", Group::Vehicle, Kind::Choice(LengthUnit::CHOICES))
        .help("Unit of the lengths of the outline file; it stands above the unit that the file names.", CONVENTION);
}
