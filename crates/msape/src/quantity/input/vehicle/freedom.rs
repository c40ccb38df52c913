//! Inputs of six degrees of freedom, and of lift in three.

use super::DRAG;
use crate::quantity::Task;
use crate::quantity::choice::Extrapolation;
use crate::quantity::input::{
    Alternatives, CONVENTION, Column, Group, Input, Kind, Preset, REPORT_DAMPING, REPORT_FLIGHT,
    Range, column,
};
use crate::units::Dimension;

const fn rows(label: &'static str, columns: &'static [Column]) -> Input {
    Input::new(label, Group::Vehicle, Kind::Rows(columns))
}

const fn coefficient(label: &'static str) -> Input {
    Input::number(
        label,
        Group::Vehicle,
        Dimension::One,
        Range::closed(-1e3, 1e3),
    )
}

/// Ways to give the lift.
pub static LIFT: Alternatives = Alternatives {
    asked_as: None,
    ways: &[&[&LIFT_TO_DRAG], &[&LIFT_COEFFICIENT], &[&LIFT_TABLE]],
};

/// Ways to give the angle of bank.
pub static BANK: Alternatives = Alternatives {
    asked_as: None,
    ways: &[&[&BANK_DEG], &[&BANK_TABLE_DEG], &[&BANK_SPEED_TABLE_DEG]],
};

inputs! {
    &[Task::PointMass, Task::RigidBody];
    DOF: "vehicle.dof" = Input::number("Degrees of Freedom", Group::Vehicle, Dimension::One, Range::closed(3.0, 6.0))
        .whole()
        .tasks(Task::FLOWN)
        .help("3 for a point mass, 6 for a rigid body with attitude; 3 when absent.", REPORT_FLIGHT);
    REFERENCE_LENGTH_M: "vehicle.reference_length_m" = Input::number("Reference Length", Group::Vehicle, Dimension::Length, Range::above(0.0, 300.0))
        .unit("m")
        .help("Length of pitching moment, pitch damping and Knudsen number; the diameter when absent.", REPORT_FLIGHT);
    REFERENCE_SPAN_M: "vehicle.reference_span_m" = Input::number("Reference Span", Group::Vehicle, Dimension::Length, Range::above(0.0, 300.0))
        .unit("m")
        .tasks(&[Task::RigidBody])
        .help("Length of roll and yaw damping; the reference length when absent.", CONVENTION);
    INERTIA_KG_M2: "vehicle.inertia_kg_m2" = rows("Inertia", &[column::X, column::Y, column::Z])
        .tasks(&[Task::RigidBody])
        .help("Three rows of the inertia tensor about the center of gravity, kg-m^2; off-diagonal elements are minus the products of inertia.", CONVENTION);
    CG_M: "vehicle.cg_m" = rows("Center of Gravity", &[column::X_M, column::Y_M, column::Z_M])
        .one_row()
        .tasks(&[Task::RigidBody, Task::DesignedBody])
        .help("Center of gravity, m: x aft of the virtual apex, y to the right, z down.", "NASA/TM-2014-218507, section 3.3.1");
    AERODYNAMICS_CA: "vehicle.aerodynamics.ca" = coefficient("Axial Force Coefficient")
        .one_way_of(&DRAG)
        .help("Axial force coefficient at every Mach number and angle of attack.", CONVENTION);
    AERODYNAMICS_CN_ALPHA_PER_RAD: "vehicle.aerodynamics.cn_alpha_per_rad" = coefficient("Normal Force Slope")
        .one_way_of(&DRAG)
        .tasks(&[Task::RigidBody])
        .help("Normal force coefficient over the total angle of attack in rad.", CONVENTION);
    AERODYNAMICS_CM_ALPHA_PER_RAD: "vehicle.aerodynamics.cm_alpha_per_rad" = coefficient("Pitching Moment Slope")
        .one_way_of(&DRAG)
        .tasks(&[Task::RigidBody])
        .help("Pitching moment coefficient about the center of gravity over the total angle of attack in rad; negative is stable.", CONVENTION);
    AERODYNAMICS_CLP: "vehicle.aerodynamics.clp" = coefficient("Roll Damping")
        .tasks(&[Task::RigidBody, Task::DesignedBody])
        .help("Rolling moment coefficient over roll rate times span over twice the speed.", REPORT_DAMPING);
    AERODYNAMICS_CMQ: "vehicle.aerodynamics.cmq" = coefficient("Pitch Damping")
        .tasks(&[Task::RigidBody, Task::DesignedBody])
        .help("Pitching moment coefficient over pitch rate times length over twice the speed.", REPORT_DAMPING);
    AERODYNAMICS_CNR: "vehicle.aerodynamics.cnr" = coefficient("Yaw Damping")
        .tasks(&[Task::RigidBody, Task::DesignedBody])
        .help("Yawing moment coefficient over yaw rate times span over twice the speed.", REPORT_DAMPING);
    LIFT_TO_DRAG: "vehicle.lift_to_drag" = Input::number("Lift to Drag", Group::Vehicle, Dimension::One, Range::closed(-10.0, 10.0))
        .one_way_of(&LIFT)
        .tasks(&[Task::PointMass])
        .help("Lift over drag of a point mass.", CONVENTION);
    LIFT_COEFFICIENT: "vehicle.lift_coefficient" = Input::number("Lift Coefficient", Group::Vehicle, Dimension::One, Range::closed(-100.0, 100.0))
        .one_way_of(&LIFT)
        .tasks(&[Task::PointMass])
        .help("Lift coefficient of a point mass at every Mach number.", CONVENTION);
    LIFT_TABLE: "vehicle.lift_table" = rows("Lift Table", &[column::MACH, column::LIFT_COEFFICIENT])
        .one_way_of(&LIFT)
        .tasks(&[Task::PointMass])
        .help("Rows of Mach number and lift coefficient of a point mass, interpolated linearly, ends held.", CONVENTION);
    LIFT_FILE: "vehicle.lift_file" = Input::new("Lift File", Group::Vehicle, Kind::Text)
        .file_of(&[&LIFT_TABLE])
        .help("Name of a text file with Mach number and lift coefficient.", CONVENTION);
    TRIM: "vehicle.trim" = Input::new("Fly at Trim", Group::Vehicle, Kind::Flag)
        .tasks(&[Task::PointMass])
        .help("Whether a point mass flies at the angle of attack where the moment about its center of gravity is nothing, with drag and lift of its outline.", "NASA/TM-2014-218507, section 3.3.1");
    BANK_DEG: "vehicle.bank_deg" = Input::number("Bank Angle", Group::Mission, Dimension::Angle, Range::closed(-360.0, 360.0))
        .unit("deg")
        .one_way_of(&BANK)
        .tasks(&[Task::PointMass])
        .help("Angle by which lift leans to the right of the vertical plane; 0 deg when absent.", CONVENTION);
    BANK_TABLE_DEG: "vehicle.bank_table_deg" = rows("Bank against Time", &[column::TIME_S, column::BANK_DEG])
        .one_way_of(&BANK)
        .tasks(&[Task::PointMass])
        .help("Rows of time after the start and angle of bank, interpolated linearly, ends held.", CONVENTION);
    BANK_SPEED_TABLE_DEG: "vehicle.bank_speed_table_deg" = rows("Bank against Velocity", &[column::SPEED_M_S, column::BANK_DEG])
        .one_way_of(&BANK)
        .tasks(&[Task::PointMass])
        .help("Rows of speed relative to the air and angle of bank, interpolated linearly, ends held.", CONVENTION);
    BANK_EXTRAPOLATION: "vehicle.bank_extrapolation" = Input::new("Beyond the Bank Table", Group::Vehicle, Kind::Choice(Extrapolation::HELD))
        .preset(Preset::Name(Extrapolation::Hold.name()))
        .tasks(&[Task::PointMass])
        .help("Rule beyond the first and the last row of a table of bank; refuse ends the flight there.", CONVENTION);
    BANK_FILE: "vehicle.bank_file" = Input::new("Bank File", Group::Vehicle, Kind::Text)
        .file_of(&[&BANK_TABLE_DEG, &BANK_SPEED_TABLE_DEG])
        .help("Name of a text file with time or speed and angle of bank.", CONVENTION);
}
