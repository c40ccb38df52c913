//! Inputs of six degrees of freedom, and of lift in three.

use super::{Choices, Column, Group, HELD, Input, Kind, Preset, Range};
use crate::units::Dimension;

const CONVENTION: &str = "convention of this program";
const REPORT_FLIGHT: &str = "NASA/TM-2014-218507, section 3.2";
const REPORT_DAMPING: &str = "NASA/TM-2014-218507, section 3.3.7";

/// Inputs whose table is a single row, which may be written without the outer brackets.
pub(super) const ONE_ROW: [&str; 4] = [
    "phase.attachment_m",
    "vehicle.cg_m",
    "attitude.quaternion",
    "attitude.body_rates_deg_s",
];

const fn part(name: &'static str) -> Column {
    Column {
        name,
        required: true,
    }
}

const fn rows(key: &'static str, label: &'static str, columns: &'static [Column]) -> Input {
    Input::new(key, label, Group::Vehicle, Kind::Rows(columns))
}

const fn coefficient(key: &'static str, label: &'static str) -> Input {
    Input::number(
        key,
        label,
        Group::Vehicle,
        Dimension::One,
        Range::closed(-1e3, 1e3),
    )
}

const fn angle(key: &'static str, label: &'static str, most: f64) -> Input {
    Input::number(
        key,
        label,
        Group::Mission,
        Dimension::Angle,
        Range::closed(-most, most),
    )
    .unit("deg")
}

pub(super) const INPUTS: &[Input] = &[
    Input::number("vehicle.dof", "Degrees of Freedom", Group::Vehicle, Dimension::One, Range::closed(3.0, 6.0))
        .whole()
        .help("3 for a point mass, 6 for a rigid body with attitude; 3 when absent.", REPORT_FLIGHT),
    Input::number("vehicle.reference_length_m", "Reference Length", Group::Vehicle, Dimension::Length, Range::above(0.0, 300.0))
        .unit("m")
        .help("Length of pitching moment, pitch damping and Knudsen number; the diameter when absent.", REPORT_FLIGHT),
    Input::number("vehicle.reference_span_m", "Reference Span", Group::Vehicle, Dimension::Length, Range::above(0.0, 300.0))
        .unit("m")
        .help("Length of roll and yaw damping; the reference length when absent.", CONVENTION),
    rows("vehicle.inertia_kg_m2", "Inertia", &[part("x"), part("y"), part("z")])
        .help("Three rows of the inertia tensor about the centre of gravity, kg-m^2; off-diagonal elements are minus the products of inertia.", CONVENTION),
    rows("vehicle.cg_m", "Centre of Gravity", &[part("x_m"), part("y_m"), part("z_m")])
        .help("Centre of gravity, m: x aft of the virtual apex, y to the right, z down.", "NASA/TM-2014-218507, section 3.3.1"),
    coefficient("vehicle.aerodynamics.ca", "Axial Force Coefficient")
        .help("Axial force coefficient at every Mach number and angle of attack.", CONVENTION),
    coefficient("vehicle.aerodynamics.cn_alpha_per_rad", "Normal Force Slope")
        .help("Normal force coefficient over the total angle of attack in rad.", CONVENTION),
    coefficient("vehicle.aerodynamics.cm_alpha_per_rad", "Pitching Moment Slope")
        .help("Pitching moment coefficient about the centre of gravity over the total angle of attack in rad; negative is stable.", CONVENTION),
    coefficient("vehicle.aerodynamics.clp", "Roll Damping")
        .help("Rolling moment coefficient over roll rate times span over twice the speed.", REPORT_DAMPING),
    coefficient("vehicle.aerodynamics.cmq", "Pitch Damping")
        .help("Pitching moment coefficient over pitch rate times length over twice the speed.", REPORT_DAMPING),
    coefficient("vehicle.aerodynamics.cnr", "Yaw Damping")
        .help("Yawing moment coefficient over yaw rate times span over twice the speed.", REPORT_DAMPING),
    Input::number("vehicle.lift_to_drag", "Lift to Drag", Group::Vehicle, Dimension::One, Range::closed(-10.0, 10.0))
        .help("Lift over drag of a point mass.", CONVENTION),
    Input::number("vehicle.lift_coefficient", "Lift Coefficient", Group::Vehicle, Dimension::One, Range::closed(-100.0, 100.0))
        .help("Lift coefficient of a point mass at every Mach number.", CONVENTION),
    rows("vehicle.lift_table", "Lift Table", &[part("mach"), part("lift_coefficient")])
        .help("Rows of Mach number and lift coefficient of a point mass, interpolated linearly, ends held.", CONVENTION),
    Input::new("vehicle.lift_file", "Lift File", Group::Vehicle, Kind::Text)
        .help("Name of a text file with Mach number and lift coefficient.", CONVENTION),
    Input::new("vehicle.trim", "Fly at Trim", Group::Vehicle, Kind::Flag)
        .help("Whether a point mass flies at the angle of attack where the moment about its centre of gravity is nothing, with drag and lift of its outline.", "NASA/TM-2014-218507, section 3.3.1"),
    angle("vehicle.bank_deg", "Bank Angle", 360.0)
        .help("Angle by which lift leans to the right of the vertical plane; 0 deg when absent.", CONVENTION),
    rows("vehicle.bank_table_deg", "Bank against Time", &[part("time_s"), part("bank_deg")])
        .help("Rows of time after the start and angle of bank, interpolated linearly, ends held.", CONVENTION),
    rows("vehicle.bank_speed_table_deg", "Bank against Velocity", &[part("speed_m_s"), part("bank_deg")])
        .help("Rows of speed relative to the air and angle of bank, interpolated linearly, ends held.", CONVENTION),
    Input::new("vehicle.bank_extrapolation", "Beyond the Bank Table", Group::Vehicle, Kind::Choice(Choices::Fixed(HELD)))
        .preset(Preset::Name("hold"))
        .help("Rule beyond the first and the last row of a table of bank; refuse ends the flight there.", CONVENTION),
    Input::new("vehicle.bank_file", "Bank File", Group::Vehicle, Kind::Text)
        .help("Name of a text file with time or speed and angle of bank.", CONVENTION),
    angle("attitude.yaw_deg", "Yaw", 360.0)
        .help("First angle of the attitude at the start against local north, east and down: nose from north, clockwise.", CONVENTION),
    angle("attitude.pitch_deg", "Pitch", 90.0)
        .help("Second angle of the attitude at the start: nose above the horizon.", CONVENTION),
    angle("attitude.roll_deg", "Roll", 360.0)
        .help("Third angle of the attitude at the start: right side down.", CONVENTION),
    angle("attitude.alpha_deg", "Angle of Attack", 360.0)
        .help("Angle of attack at the start, against the velocity relative to the air; in the place of yaw, pitch and roll.", CONVENTION),
    angle("attitude.beta_deg", "Angle of Sideslip", 360.0)
        .help("Angle of sideslip at the start, velocity right of the nose positive.", CONVENTION),
    angle("attitude.bank_deg", "Bank at the Start", 360.0)
        .help("Turn about the velocity at the start, right side down.", CONVENTION),
    Input::new(
        "attitude.quaternion",
        "Attitude Quaternion",
        Group::Mission,
        Kind::Rows(&[part("w"), part("x"), part("y"), part("z")]),
    )
    .help("Attitude at the start, scalar part first, from axes of the body to local north, east and down; any length above 0.", CONVENTION),
    Input::new(
        "attitude.body_rates_deg_s",
        "Body Rates",
        Group::Mission,
        Kind::Rows(&[part("p_deg_s"), part("q_deg_s"), part("r_deg_s")]),
    )
    .aliases(&["vehicle.body_rates_deg_s", "entry.body_rates_deg_s"])
    .help("Inertial rates at the start about the axes of the body: roll, pitch, yaw, deg/s; at rest when absent.", REPORT_FLIGHT),
];
