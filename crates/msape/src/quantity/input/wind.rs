//! Inputs of the wind.

use super::{Alternatives, CONVENTION, Group, Input, Kind, Preset, Range, column};
use crate::quantity::Task;
use crate::quantity::choice::Extrapolation;
use crate::units::Dimension;

/// Ways to give the wind.
pub static WIND: Alternatives = Alternatives {
    asked_as: None,
    ways: &[&[&TABLE], &[&EASTWARD_M_S, &NORTHWARD_M_S]],
};

inputs! {
    Task::ALL;
    TABLE: "wind.table" = Input::new("Wind Table", Group::Models, Kind::Rows(&[column::ALTITUDE_M, column::EASTWARD_M_S, column::NORTHWARD_M_S]))
        .one_way_of(&WIND)
        .help("Rows of altitude and the velocity of the air towards east and north.", CONVENTION);
    FILE: "wind.file" = Input::new("Wind File", Group::Models, Kind::Text)
        .file_of(&[&TABLE])
        .help("Name of a text file with the wind: altitude, eastward and northward, or speed and the direction from which it blows.", CONVENTION);
    EXTRAPOLATION: "wind.extrapolation" = Input::new("Beyond the Wind Table", Group::Models, Kind::Choice(Extrapolation::HELD))
        .preset(Preset::Name(Extrapolation::Hold.name()))
        .help("Rule beyond the first and the last altitude of the table of wind; refuse ends the flight there.", CONVENTION);
    EASTWARD_M_S: "wind.eastward_m_s" = Input::number("Wind towards East", Group::Models, Dimension::Speed, Range::closed(-500.0, 500.0))
        .unit("m/s")
        .one_way_of(&WIND)
        .help("Velocity of the air towards the east at every altitude.", CONVENTION);
    NORTHWARD_M_S: "wind.northward_m_s" = Input::number("Wind towards North", Group::Models, Dimension::Speed, Range::closed(-500.0, 500.0))
        .unit("m/s")
        .one_way_of(&WIND)
        .help("Velocity of the air towards the north at every altitude.", CONVENTION);
}
