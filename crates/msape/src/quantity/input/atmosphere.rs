//! Inputs of an atmosphere that the case brings.

use super::{Alternatives, CONVENTION, Group, Input, Kind, Preset, Range, column};
use crate::quantity::Task;
use crate::quantity::choice::Extrapolation;
use crate::units::Dimension;

const POSITIVE: Range = Range::above(0.0, 1e30);

/// Ways to give an atmosphere.
pub static AIR: Alternatives = Alternatives {
    asked_as: None,
    ways: &[
        &[&TABLE],
        &[&FILE],
        &[&EXPONENTIAL_DENSITY_KG_M3, &EXPONENTIAL_SCALE_HEIGHT_M],
    ],
};

inputs! {
    Task::ALL;
    TABLE: "atmosphere.table" = Input::new("Atmosphere Table", Group::Models, Kind::Rows(&[column::ALTITUDE_M, column::DENSITY_KG_M3, column::TEMPERATURE_K.optional(), column::PRESSURE_PA.optional()]))
        .one_way_of(&AIR)
        .help("Rows of altitude, density and, if known, temperature and pressure; density is interpolated in its logarithm. Where two of the three are given, the third may be 0 in every row: it is that of the planet's gas.", CONVENTION);
    FILE: "atmosphere.file" = Input::new("Atmosphere File", Group::Models, Kind::Text)
        .one_way_of(&AIR)
        .file_of(&[&TABLE])
        .help("Name of a text file with the atmosphere: altitude (geometric, geopotential or of pressure), density or pressure and temperature, in columns with names and units.", CONVENTION);
    EXTRAPOLATION: "atmosphere.extrapolation" = Input::new("Beyond the Atmosphere", Group::Models, Kind::Choice(Extrapolation::OF_AIR))
        .preset(Preset::Name(Extrapolation::Extend.name()))
        .help("Rule beyond the first and the last altitude of the atmosphere, of the case or of the planet; density never grows with height there. Refuse ends the flight there.", CONVENTION);
    MOLAR_MASS_KG_KMOL: "atmosphere.molar_mass_kg_kmol" = Input::number("Molar Mass of the Gas", Group::Models, Dimension::MolarMass, Range::closed(1.0, 200.0))
        .unit("kg/kmol")
        .help("Molar mass of the gas of an atmosphere given in the case; that of the planet's gas when absent.", CONVENTION);
    HEAT_CAPACITY_RATIO: "atmosphere.heat_capacity_ratio" = Input::number("Ratio of Heat Capacities", Group::Models, Dimension::One, Range::above(1.0, 1.7))
        .help("Ratio of the heat capacities of the gas of an atmosphere given in the case; that of the planet's gas when absent.", CONVENTION);
    EXPONENTIAL_DENSITY_KG_M3: "atmosphere.exponential.density_kg_m3" = Input::number("Exponential Atmosphere Density", Group::Models, Dimension::Density, POSITIVE)
        .unit("kg/m^3")
        .one_way_of(&AIR)
        .help("Density at altitude zero of an exponential atmosphere.", CONVENTION);
    EXPONENTIAL_SCALE_HEIGHT_M: "atmosphere.exponential.scale_height_m" = Input::number("Exponential Atmosphere Scale Height", Group::Models, Dimension::Length, Range::above(0.0, 1e7))
        .unit("m")
        .one_way_of(&AIR)
        .help("Altitude over which the density falls to 1/e.", CONVENTION);
}
