//! Inputs of a vehicle that is flown as it is.

use super::{Choices, Column, Group, Input, Kind, Need, Range};
use crate::units::Dimension;

const CONVENTION: &str = "convention of this program";

pub(super) const INPUTS: &[Input] = &[
    Input::number(
        "vehicle.mass_kg",
        "Mass",
        Group::Vehicle,
        Dimension::Mass,
        Range::above(0.0, 1e6),
    )
    .unit("kg")
    .need(Need::Fly)
    .help("Mass of the vehicle during the whole flight.", CONVENTION),
    Input::number(
        "vehicle.reference_area_m2",
        "Reference Area",
        Group::Vehicle,
        Dimension::Area,
        Range::above(0.0, 1e5),
    )
    .unit("m^2")
    .help(
        "Area to which the coefficients belong, or give the diameter.",
        CONVENTION,
    ),
    Input::number(
        "vehicle.diameter_m",
        "Diameter",
        Group::Vehicle,
        Dimension::Length,
        Range::above(0.0, 300.0),
    )
    .unit("m")
    .help(
        "Diameter; the reference area is that of its circle.",
        CONVENTION,
    ),
    Input::number(
        "vehicle.nose_radius_m",
        "Nose Radius",
        Group::Vehicle,
        Dimension::Length,
        Range::above(0.0, 1e3),
    )
    .unit("m")
    .help(
        "Radius of the nose, on which heating depends; that of the outline where there is one.",
        CONVENTION,
    ),
    Input::number(
        "vehicle.drag_coefficient",
        "Drag Coefficient",
        Group::Vehicle,
        Dimension::One,
        Range::closed(0.0, 100.0),
    )
    .help("Drag coefficient at every Mach number.", CONVENTION),
    Input::new(
        "vehicle.drag_table",
        "Drag Table",
        Group::Vehicle,
        Kind::Rows(&[
            Column {
                name: "mach",
                required: true,
            },
            Column {
                name: "drag_coefficient",
                required: true,
            },
        ]),
    )
    .help(
        "Rows of Mach number and drag coefficient, interpolated linearly, ends held.",
        CONVENTION,
    ),
    Input::new("vehicle.drag_file", "Drag File", Group::Vehicle, Kind::Text).help(
        "Name of a text file with Mach number and drag coefficient.",
        CONVENTION,
    ),
    Input::new(
        "vehicle.aerodynamics",
        "Aerodynamics",
        Group::Vehicle,
        Kind::Choice(Choices::Aerodynamics),
    )
    .aliases(&["vehicle.aerodynamics.name"])
    .help("Aerodynamic database by name.", CONVENTION),
];
