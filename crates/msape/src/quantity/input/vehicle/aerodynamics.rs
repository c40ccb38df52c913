//! Inputs of coefficients over angle of attack: a table of the user, damping, rarefied flow.

use super::DRAG;
use crate::quantity::Task;
use crate::quantity::choice::{Bridging, Choice, DampingModel, Extrapolation};
use crate::quantity::input::{
    CONVENTION, Group, Input, Kind, Preset, REPORT_DAMPING, REPORT_STATIC, Range, column,
};
use crate::units::Dimension;

inputs! {
    Task::FLOWN;
    AERODYNAMICS_TABLE: "vehicle.aerodynamics.table" = Input::new(
        "Aerodynamic Table",
        Group::Vehicle,
        Kind::Rows(&[column::MACH, column::ALPHA_DEG, column::CA, column::CN, column::CM.optional(), column::CMQ.optional(), column::KNUDSEN.optional(), column::ALTITUDE_M.optional()]),
    )
        .one_way_of(&DRAG)
        .help("Rows of Mach number, total angle of attack and coefficients of axial and normal force, moment about the virtual apex and pitch damping; a last column instead of the Knudsen number is the altitude.", REPORT_STATIC);
    AERODYNAMICS_FILE: "vehicle.aerodynamics.file" = Input::new("Aerodynamic File", Group::Vehicle, Kind::Text)
        .file_of(&[&AERODYNAMICS_TABLE])
        .help("Name of a text file with Mach number, angle of attack, if wanted Knudsen number or altitude, and CA, CN, Cm or CD, CL; with Mach number and CD alone it is a drag table.", CONVENTION);
    AERODYNAMICS_EXTRAPOLATION: "vehicle.aerodynamics.extrapolation" = Input::new("Beyond the Aerodynamic Table", Group::Vehicle, Kind::Choice(Extrapolation::CHOICES))
        .preset(Preset::Name(Extrapolation::Hold.name()))
        .help("Rule beyond the ends of a table of coefficients, of drag or of lift; refuse ends the flight there.", CONVENTION);
    AERODYNAMICS_DAMPING: "vehicle.aerodynamics.damping" = Input::new("Pitch Damping", Group::Vehicle, Kind::Choice(DampingModel::CHOICES))
        .preset(Preset::Name(DampingModel::Report.name()))
        .help("Model of pitch damping; the Viking data above Mach 0.5 are a placeholder, which a damping table replaces.", REPORT_DAMPING);
    AERODYNAMICS_DAMPING_TABLE: "vehicle.aerodynamics.damping_table" = Input::new("Damping Table", Group::Vehicle, Kind::Rows(&[column::MACH, column::ALPHA_DEG, column::CMQ, column::KNUDSEN.optional()]))
        .help("Rows of Mach number, total angle of attack and pitch damping per unit of pitch rate times diameter over twice the speed, in the place of the model.", REPORT_DAMPING);
    AERODYNAMICS_DAMPING_FILE: "vehicle.aerodynamics.damping_file" = Input::new("Damping File", Group::Vehicle, Kind::Text)
        .file_of(&[&AERODYNAMICS_DAMPING_TABLE])
        .help("Name of a text file with the rows of the damping table.", CONVENTION);
    AERODYNAMICS_BRIDGING: "vehicle.aerodynamics.bridging" = Input::new("Bridging", Group::Vehicle, Kind::Choice(Bridging::CHOICES))
        .preset(Preset::Name(Bridging::SineSquared.name()))
        .help("Weight of free-molecular against continuum coefficients in Knudsen number.", "Wilmoth, Mitcheltree and Moss 1999");
    AERODYNAMICS_WALL_TEMPERATURE_RATIO: "vehicle.aerodynamics.wall_temperature_ratio" = Input::number("Wall to Air Temperature", Group::Vehicle, Dimension::One, Range::closed(0.0, 1000.0))
        .preset(Preset::Number(1.0))
        .help("Temperature of the wall over that of the air in free-molecular flow; assumed.", CONVENTION);
    AERODYNAMICS_ACCOMMODATION: "vehicle.aerodynamics.accommodation" = Input::number("Accommodation", Group::Vehicle, Dimension::One, Range::closed(0.0, 1.0))
        .preset(Preset::Number(1.0))
        .help("Accommodation of normal and tangential momentum in free-molecular flow.", REPORT_STATIC);
}
