//! Inputs of the attitude at the start.

use super::{Alternatives, CONVENTION, Group, Input, Kind, REPORT_FLIGHT, Range, column};
use crate::quantity::Task;
use crate::units::Dimension;

const fn angle(label: &'static str, most: f64) -> Input {
    Input::number(
        label,
        Group::Mission,
        Dimension::Angle,
        Range::closed(-most, most),
    )
    .unit("deg")
}

/// Ways to give the attitude at the start.
pub static ATTITUDE: Alternatives = Alternatives {
    asked_as: None,
    ways: &[
        &[&YAW_DEG, &PITCH_DEG, &ROLL_DEG],
        &[&ALPHA_DEG, &BETA_DEG, &BANK_DEG],
        &[&QUATERNION],
    ],
};

inputs! {
    &[Task::RigidBody, Task::DesignedBody];
    YAW_DEG: "attitude.yaw_deg" = angle("Yaw", 360.0)
        .one_way_of(&ATTITUDE)
        .help("First angle of the attitude at the start against local north, east and down: nose from north, clockwise.", CONVENTION);
    PITCH_DEG: "attitude.pitch_deg" = angle("Pitch", 90.0)
        .one_way_of(&ATTITUDE)
        .help("Second angle of the attitude at the start: nose above the horizon.", CONVENTION);
    ROLL_DEG: "attitude.roll_deg" = angle("Roll", 360.0)
        .one_way_of(&ATTITUDE)
        .help("Third angle of the attitude at the start: right side down.", CONVENTION);
    ALPHA_DEG: "attitude.alpha_deg" = angle("Angle of Attack", 360.0)
        .one_way_of(&ATTITUDE)
        .help("Angle of attack at the start, against the velocity relative to the air; in the place of yaw, pitch and roll.", CONVENTION);
    BETA_DEG: "attitude.beta_deg" = angle("Angle of Sideslip", 360.0)
        .one_way_of(&ATTITUDE)
        .help("Angle of sideslip at the start, velocity right of the nose positive.", CONVENTION);
    BANK_DEG: "attitude.bank_deg" = angle("Bank at the Start", 360.0)
        .one_way_of(&ATTITUDE)
        .help("Turn about the velocity at the start, right side down.", CONVENTION);
    QUATERNION: "attitude.quaternion" = Input::new("Attitude Quaternion", Group::Mission, Kind::Rows(&[column::W, column::X, column::Y, column::Z]))
        .one_way_of(&ATTITUDE)
        .one_row()
        .help("Attitude at the start, scalar part first, from axes of the body to local north, east and down; any length above 0.", CONVENTION);
    BODY_RATES_DEG_S: "attitude.body_rates_deg_s" = Input::new("Body Rates", Group::Mission, Kind::Rows(&[column::P_DEG_S, column::Q_DEG_S, column::R_DEG_S]))
        .aliases(&["vehicle.body_rates_deg_s", "entry.body_rates_deg_s"])
        .one_row()
        .help("Inertial rates at the start about the axes of the body: roll, pitch, yaw, deg/s; at rest when absent.", REPORT_FLIGHT);
}
