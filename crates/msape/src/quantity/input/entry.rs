//! Inputs of the entry: planet, atmosphere, state at the start.

use super::{
    Alternatives, CONVENTION, Choices, DEEPEST_M, Group, Input, Kind, Need, OWN_ATMOSPHERE, Preset,
    REPORT_FLIGHT, RUN_PAGE, Range,
};
use crate::quantity::Task;
use crate::quantity::choice::{Choice, Frame};
use crate::units::Dimension;

/// Ways to give the altitude at which the flight begins.
pub static START: Alternatives = Alternatives {
    asked_as: Some("Start"),
    ways: &[&[&ALTITUDE_M], &[&RADIUS_M]],
};

inputs! {
    Task::ALL;
    PLANET: "entry.planet" = Input::new("Planet", Group::Models, Kind::Choice(Choices::Planets))
        .preset(Preset::Name("earth-msape"))
        .default_gives_way_to("planet.")
        .help("Constants of shape, gravity and rotation.", REPORT_FLIGHT);
    ATMOSPHERE: "entry.atmosphere" = Input::new("Atmosphere", Group::Models, Kind::Choice(Choices::Atmospheres))
        .preset(Preset::Name(OWN_ATMOSPHERE))
        .default_gives_way_to("atmosphere.")
        .help("Density, temperature and pressure against altitude: the planet's own; another planet's is refused.", REPORT_FLIGHT);
    ALTITUDE_M: "entry.altitude_m" = Input::number("Entry Altitude", Group::Mission, Dimension::Length, Range::closed(DEEPEST_M, 1e9))
        .unit("km")
        .usual(80e3, 200e3)
        .preset(Preset::Number(125_000.0))
        .one_way_of(&START)
        .help("Geodetic altitude at which the flight starts; not below the lowest of the planet.", REPORT_FLIGHT);
    RADIUS_M: "entry.radius_m" = Input::number("Entry Radius", Group::Mission, Dimension::Length, Range::above(0.0, 1e10))
        .unit("km")
        .one_way_of(&START)
        .help("Distance from the center of the planet at the start, instead of the altitude.", CONVENTION);
    LATITUDE_DEG: "entry.latitude_deg" = Input::number("Entry Latitude", Group::Mission, Dimension::Angle, Range::closed(-90.0, 90.0))
        .unit("deg")
        .preset(Preset::Number(33.0))
        .need(Need::Always)
        .help("Geodetic latitude at the start, north positive.", REPORT_FLIGHT);
    LONGITUDE_DEG: "entry.longitude_deg" = Input::number("Entry Longitude", Group::Mission, Dimension::Angle, Range::closed(-360.0, 360.0))
        .unit("deg")
        .preset(Preset::Number(246.3833))
        .need(Need::Always)
        .help("Longitude at the start, east positive.", REPORT_FLIGHT);
    SPEED_M_S: "entry.speed_m_s" = Input::number("Entry Velocity", Group::Mission, Dimension::Speed, Range::closed(0.0, 1e5))
        .unit("m/s")
        .usual(10_000.0, 16_000.0)
        .preset(Preset::Number(12_000.0))
        .need(Need::Always)
        .basic()
        .help("Speed at the start, in the frame named by the frame of entry.", RUN_PAGE);
    FLIGHT_PATH_ANGLE_DEG: "entry.flight_path_angle_deg" = Input::number("Entry Flight Path Angle", Group::Mission, Dimension::Angle, Range::closed(-90.0, 90.0))
        .unit("deg")
        .usual(-90.0, -1.0)
        .preset(Preset::Number(-8.0))
        .need(Need::Always)
        .basic()
        .help("Angle of the velocity against the geodetic horizon at the start, negative downwards.", RUN_PAGE);
    AZIMUTH_DEG: "entry.azimuth_deg" = Input::number("Entry Azimuth", Group::Mission, Dimension::Angle, Range::closed(-360.0, 360.0))
        .unit("deg")
        .preset(Preset::Number(90.0))
        .need(Need::Always)
        .help("Direction of the horizontal velocity at the start, from north, clockwise; not printed in the report, 90 deg is assumed.", CONVENTION);
    FRAME: "entry.frame" = Input::new("Frame of Entry", Group::Mission, Kind::Choice(Frame::CHOICES))
        .preset(Preset::Name(Frame::Relative.name()))
        .help("Whether speed, angle and azimuth are relative to the rotating planet or inertial, both in the local geodetic horizon.", CONVENTION);
}
