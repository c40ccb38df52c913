//! Inputs of heating that another program or a test gives.

use crate::quantity::Task;
use crate::quantity::choice::Extrapolation;
use crate::quantity::input::{
    Alternatives, CONVENTION, Column, Group, Input, Kind, Preset, column,
};

const CONVECTIVE: [Column; 3] = [
    column::SPEED_M_S,
    column::DENSITY_KG_M3,
    column::CONVECTIVE_W_M2,
];

const fn along_body(label: &'static str, columns: &'static [Column]) -> Input {
    Input::new(label, Group::Models, Kind::Rows(columns))
}

/// Tables of heating.
pub static TABLES: Alternatives = Alternatives {
    asked_as: None,
    ways: &[&[&TABLE], &[&RADIUS_TABLE], &[&ARC_TABLE]],
};

inputs! {
    Task::ALL;
    TABLE: "heating.table" = Input::new(
        "Heating Table",
        Group::Models,
        Kind::Rows(&[
            CONVECTIVE[0],
            CONVECTIVE[1],
            CONVECTIVE[2],
            column::RADIATIVE_W_M2.optional(),
        ]),
    )
        .one_way_of(&TABLES)
        .help("Cold-wall heat fluxes of the stagnation point from outside, over speed relative to the air and density, in place of the relations: each speed with each density, in any order, and two of each or more. The margins apply, the model factor does not. Logarithms are interpolated where all are above 0. Without radiative fluxes the radiative relation stays; a total heat flux stands as convective beside radiative fluxes of 0.", CONVENTION);
    RADIUS_TABLE: "heating.radius_table" = along_body("Heating Table over Radius", &[
        column::RADIUS_FRACTION,
        CONVECTIVE[0],
        CONVECTIVE[1],
        CONVECTIVE[2],
        column::RADIATIVE_W_M2,
    ])
        .one_way_of(&TABLES)
        .help("The same at points of the forebody, by their distance from the axis over the largest radius; 0 is the stagnation point. Every point has the speeds and densities of the stagnation point. Each is integrated along the flight, and a heat shield is judged by the largest heat flux and heat load.", CONVENTION);
    ARC_TABLE: "heating.arc_table" = along_body("Heating Table over Arc Length", &[
        column::ARC_FRACTION,
        CONVECTIVE[0],
        CONVECTIVE[1],
        CONVECTIVE[2],
        column::RADIATIVE_W_M2,
    ])
        .one_way_of(&TABLES)
        .help("The same at points of the forebody, by their length along the outline from the nose over that to the largest radius; 0 is the stagnation point.", CONVENTION);
    FILE: "heating.file" = Input::new("Heating File", Group::Models, Kind::Text)
        .file_of(&[&TABLE, &RADIUS_TABLE, &ARC_TABLE])
        .help("Name of a text file with speed, density and convective, radiative or total heat flux to a cold wall, and r or s as a fraction where it is along the body.", CONVENTION);
    EXTRAPOLATION: "heating.extrapolation" = Input::new("Beyond the Heating Table", Group::Models, Kind::Choice(Extrapolation::OF_HEATING))
        .preset(Preset::Name(Extrapolation::Extend.name()))
        .help("Rule beyond the speeds and densities of a table of heating. The last slope, of the logarithms where these are interpolated, never makes more heat of less speed or density; a held end heats in a vacuum, too; refuse ends the flight there.", CONVENTION);
}
