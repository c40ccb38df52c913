//! Inputs of an outline that is flown, or exported, as it is.

use super::{Choices, Column, Group, Input, Kind, Range};
use crate::units::Dimension;

const CONVENTION: &str = "convention of this program";

pub(super) const INPUTS: &[Input] = &[
    Input::new("outline.preset", "Outline", Group::Vehicle, Kind::Choice(Choices::Outlines))
        .help("Outline of a known vehicle by name; outline.diameter_m beside it scales it.", CONVENTION),
    Input::number("outline.diameter_m", "Outline Diameter", Group::Vehicle, Dimension::Length, Range::above(0.0, 300.0))
        .unit("m")
        .help("Largest diameter of a sphere-cone, or of the preset scaled to it.", CONVENTION),
    Input::number("outline.cone_half_angle_deg", "Outline Cone Half-Angle", Group::Vehicle, Dimension::Angle, Range::closed(1.0, 89.0))
        .unit("deg")
        .usual(20.0, 70.0)
        .help("Angle between the axis and the cone of a sphere-cone.", CONVENTION),
    Input::number("outline.nose_radius_m", "Outline Nose Radius", Group::Vehicle, Dimension::Length, Range::closed(0.0, 1e3))
        .unit("m")
        .help("Radius of the nose of a sphere-cone; zero is a sharp cone.", CONVENTION),
    Input::number("outline.shoulder_radius_m", "Outline Shoulder Radius", Group::Vehicle, Dimension::Length, Range::closed(0.0, 150.0))
        .unit("m")
        .help("Radius of the shoulder of a sphere-cone; zero is a sharp edge.", CONVENTION),
    Input::new(
        "outline.aft",
        "Outline Aftbody",
        Group::Vehicle,
        Kind::Choice(Choices::Fixed(&[("flat", "Flat disc"), ("mmeev", "Face of 15 deg and spherical lid")])),
    )
    .help("Shape behind the half-torus shoulder of a sphere-cone; flat when absent.", CONVENTION),
    Input::new(
        "outline.points",
        "Outline Points",
        Group::Vehicle,
        Kind::Rows(&[
            Column { name: "x_m", required: true },
            Column { name: "r_m", required: true },
            Column { name: "bulge", required: false },
        ]),
    )
    .help("Points of an outline from the axis at the nose to the axis at the aft end; a bulge, the tangent of a quarter of its angle, makes the piece to the next point an arc.", CONVENTION),
    Input::new("outline.file", "Outline File", Group::Vehicle, Kind::Text)
        .help("Name of a CSV file with the points of the outline, or of a DXF drawing of it about the x axis.", CONVENTION),
    Input::new(
        "outline.file_unit",
        "Outline File Unit",
        Group::Vehicle,
        Kind::Choice(Choices::Fixed(&[("m", "m"), ("cm", "cm"), ("mm", "mm"), ("in", "in"), ("ft", "ft")])),
    )
    .help("Unit of the lengths of the outline file; it stands above the unit that the file names.", CONVENTION),
];
