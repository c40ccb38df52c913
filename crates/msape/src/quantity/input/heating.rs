//! Inputs of heating that another program or a test gives.

use super::{Choices, Column, Group, Input, Kind, Preset};

const CONVENTION: &str = "convention of this program";

const fn column(name: &'static str) -> Column {
    Column {
        name,
        required: true,
    }
}

const CONVECTIVE: [Column; 3] = [
    column("speed_m_s"),
    column("density_kg_m3"),
    column("convective_w_m2"),
];

const fn along_body(key: &'static str, label: &'static str, columns: &'static [Column]) -> Input {
    Input::new(key, label, Group::Models, Kind::Rows(columns))
}

pub(super) const INPUTS: &[Input] = &[
    Input::new(
        "heating.table",
        "Heating Table",
        Group::Models,
        Kind::Rows(&[
            CONVECTIVE[0],
            CONVECTIVE[1],
            CONVECTIVE[2],
            Column { name: "radiative_w_m2", required: false },
        ]),
    )
    .help("Cold-wall heat fluxes of the stagnation point from outside, over speed relative to the air and density, in place of the relations: each speed with each density, in any order, and two of each or more. The margins apply, the model factor does not. Logarithms are interpolated where all are above 0. Without radiative fluxes the radiative relation stays; a total heat flux stands as convective beside radiative fluxes of 0.", CONVENTION),
    along_body("heating.radius_table", "Heating Table over Radius", &[
        column("radius_fraction"),
        CONVECTIVE[0],
        CONVECTIVE[1],
        CONVECTIVE[2],
        column("radiative_w_m2"),
    ])
    .help("The same at points of the forebody, by their distance from the axis over the largest radius; 0 is the stagnation point. Every point has the speeds and densities of the stagnation point. Each is integrated along the flight, and a heat shield is judged by the largest heat flux and heat load.", CONVENTION),
    along_body("heating.arc_table", "Heating Table over Arc Length", &[
        column("arc_fraction"),
        CONVECTIVE[0],
        CONVECTIVE[1],
        CONVECTIVE[2],
        column("radiative_w_m2"),
    ])
    .help("The same at points of the forebody, by their length along the outline from the nose over that to the largest radius; 0 is the stagnation point.", CONVENTION),
    Input::new("heating.file", "Heating File", Group::Models, Kind::Text)
        .help("Name of a text file with speed, density and convective, radiative or total heat flux to a cold wall, and r or s as a fraction where it is along the body.", CONVENTION),
    Input::new(
        "heating.extrapolation",
        "Beyond the Heating Table",
        Group::Models,
        Kind::Choice(Choices::Fixed(&[
            ("extend", "Extend with the last slope"),
            ("hold", "Hold the end"),
            ("refuse", "Refuse"),
        ])),
    )
    .preset(Preset::Name("extend"))
    .help("Rule beyond the speeds and densities of a table of heating. The last slope, of the logarithms where these are interpolated, never makes more heat of less speed or density; a held end heats in a vacuum, too; refuse ends the flight there.", CONVENTION),
];
