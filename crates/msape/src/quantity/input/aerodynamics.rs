//! Inputs of coefficients over angle of attack: a table of one's own, damping, rarefied flow.

use super::{Choices, Column, Group, Input, Kind, Preset, Range};
use crate::units::Dimension;

const CONVENTION: &str = "convention of this program";
const REPORT_DAMPING: &str = "NASA/TM-2014-218507, section 3.3.7";
const REPORT_STATIC: &str = "NASA/TM-2014-218507, section 3.3.1";

const fn part(name: &'static str, required: bool) -> Column {
    Column { name, required }
}

pub(super) const INPUTS: &[Input] = &[
    Input::new(
        "vehicle.aerodynamics.table",
        "Aerodynamic Table",
        Group::Vehicle,
        Kind::Rows(&[
            part("mach", true),
            part("alpha_deg", true),
            part("ca", true),
            part("cn", true),
            part("cm", false),
            part("cmq", false),
            part("knudsen", false),
            part("altitude_m", false),
        ]),
    )
    .help("Rows of Mach number, total angle of attack and coefficients of axial and normal force, moment about the virtual apex and pitch damping; a last column instead of the Knudsen number is the altitude.", REPORT_STATIC),
    Input::new("vehicle.aerodynamics.file", "Aerodynamic File", Group::Vehicle, Kind::Text)
        .help("Name of a text file with Mach number, angle of attack, if wanted Knudsen number or altitude, and CA, CN, Cm or CD, CL; with Mach number and CD alone it is a drag table.", CONVENTION),
    Input::new(
        "vehicle.aerodynamics.extrapolation",
        "Beyond the Aerodynamic Table",
        Group::Vehicle,
        Kind::Choice(Choices::Fixed(&[
            ("hold", "Hold the end"),
            ("extend", "Extend with the last slope"),
            ("refuse", "Refuse"),
        ])),
    )
    .preset(Preset::Name("hold"))
    .help("Rule beyond the ends of a table of coefficients, of drag or of lift; refuse ends the flight there.", CONVENTION),
    Input::new(
        "vehicle.aerodynamics.damping",
        "Pitch Damping",
        Group::Vehicle,
        Kind::Choice(Choices::Fixed(&[
            ("report", "Equation 7 corrected, placeholder for Viking (assumed)"),
            ("report-printed", "Equation 7 with the radius of gyration as printed, placeholder for Viking (assumed)"),
            ("none", "None"),
        ])),
    )
    .preset(Preset::Name("report"))
    .help("Model of pitch damping; the Viking data above Mach 0.5 are a placeholder, which a damping table replaces.", REPORT_DAMPING),
    Input::new(
        "vehicle.aerodynamics.damping_table",
        "Damping Table",
        Group::Vehicle,
        Kind::Rows(&[
            part("mach", true),
            part("alpha_deg", true),
            part("cmq", true),
            part("knudsen", false),
        ]),
    )
    .help("Rows of Mach number, total angle of attack and pitch damping per unit of pitch rate times diameter over twice the speed, in the place of the model.", REPORT_DAMPING),
    Input::new("vehicle.aerodynamics.damping_file", "Damping File", Group::Vehicle, Kind::Text)
        .help("Name of a text file with the rows of the damping table.", CONVENTION),
    Input::new(
        "vehicle.aerodynamics.bridging",
        "Bridging",
        Group::Vehicle,
        Kind::Choice(Choices::Fixed(&[
            ("sine-squared", "Sine squared, Knudsen number 0.001 to 10"),
            ("error-function", "Error function about Knudsen number 0.1"),
        ])),
    )
    .preset(Preset::Name("sine-squared"))
    .help("Weight of free-molecular against continuum coefficients in Knudsen number.", "Wilmoth, Mitcheltree and Moss 1999"),
    Input::number("vehicle.aerodynamics.wall_temperature_ratio", "Wall to Air Temperature", Group::Vehicle, Dimension::One, Range::closed(0.0, 1000.0))
        .preset(Preset::Number(1.0))
        .help("Temperature of the wall over that of the air in free-molecular flow; assumed.", CONVENTION),
    Input::number("vehicle.aerodynamics.accommodation", "Accommodation", Group::Vehicle, Dimension::One, Range::closed(0.0, 1.0))
        .preset(Preset::Number(1.0))
        .help("Accommodation of normal and tangential momentum in free-molecular flow.", REPORT_STATIC),
];
