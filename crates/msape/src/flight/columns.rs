//! Columns of a time history: their descriptions, and how they are taken from a sample.

use super::sample::Sample;
use crate::quantity::Column;
use crate::units::Dimension;
use numerics::math::RADIANS_PER_DEGREE;

/// A column and the value of it at one instant.
pub(super) struct Sampled {
    /// Key, unit and meaning.
    pub(super) column: Column,
    /// Takes it out of a sample; `None` where the flight does not have it.
    pub(super) get: fn(&Sample) -> Option<f64>,
}

const fn sampled(
    key: &'static str,
    label: &'static str,
    (dimension, unit): (Dimension, &'static str),
    help: &'static str,
    get: fn(&Sample) -> Option<f64>,
) -> Sampled {
    Sampled {
        column: Column {
            key,
            label,
            dimension,
            unit,
            help,
        },
        get,
    }
}

/// All columns, in the order of files.
pub fn columns() -> impl Iterator<Item = &'static Column> {
    SAMPLED.iter().map(|sampled| &sampled.column)
}

/// The column with this key.
pub fn find(key: &str) -> Option<&'static Column> {
    columns().find(|column| column.key == key)
}

/// Key of the column whose numbers represent the names of phases.
pub(super) const PHASE: &str = "phase";

pub(super) static SAMPLED: &[Sampled] = &[
    sampled(
        "time_s",
        "Time",
        (Dimension::Time, "s"),
        "Time after the start.",
        |s| Some(s.time_s),
    ),
    sampled(
        "altitude_m",
        "Geodetic Altitude",
        (Dimension::Length, "km"),
        "Height above the reference ellipsoid.",
        |s| Some(s.altitude_m),
    ),
    sampled(
        "latitude_deg",
        "Latitude",
        (Dimension::Angle, "deg"),
        "Geodetic latitude, north positive.",
        |s| Some(s.latitude_rad / RADIANS_PER_DEGREE),
    ),
    sampled(
        "longitude_deg",
        "Longitude",
        (Dimension::Angle, "deg"),
        "Longitude, east positive, -180 to 180 deg.",
        |s| Some(s.longitude_rad / RADIANS_PER_DEGREE),
    ),
    sampled(
        "speed_m_s",
        "Relative Velocity",
        (Dimension::Speed, "m/s"),
        "Speed relative to the rotating planet.",
        |s| Some(s.speed_m_s),
    ),
    sampled(
        "flight_path_angle_deg",
        "Flight Path Angle",
        (Dimension::Angle, "deg"),
        "Angle of the relative velocity against the geodetic horizon, negative down.",
        |s| Some(s.flight_path_angle_rad / RADIANS_PER_DEGREE),
    ),
    sampled(
        "azimuth_deg",
        "Azimuth",
        (Dimension::Angle, "deg"),
        "Direction of the horizontal relative velocity from north, clockwise.",
        |s| Some(s.azimuth_rad / RADIANS_PER_DEGREE),
    ),
    sampled(
        "inertial_speed_m_s",
        "Inertial Velocity",
        (Dimension::Speed, "m/s"),
        "Speed in the frame that does not rotate with the planet.",
        |s| Some(s.inertial_speed_m_s),
    ),
    sampled(
        "eastward_speed_m_s",
        "Eastward Velocity",
        (Dimension::Speed, "m/s"),
        "Relative velocity towards the east.",
        |s| Some(s.velocity_m_s[1]),
    ),
    sampled(
        "northward_speed_m_s",
        "Northward Velocity",
        (Dimension::Speed, "m/s"),
        "Relative velocity towards the north.",
        |s| Some(s.velocity_m_s[0]),
    ),
    sampled(
        "downward_speed_m_s",
        "Downward Velocity",
        (Dimension::Speed, "m/s"),
        "Relative velocity downwards along the geodetic vertical.",
        |s| Some(-s.velocity_m_s[2]),
    ),
    sampled(
        "downrange_m",
        "Downrange",
        (Dimension::Length, "km"),
        "Distance from the start over the figure of the planet: on Earth the great circle on a sphere of 6371 km, elsewhere the shortest line on the ellipsoid.",
        |s| Some(s.downrange_m),
    ),
    sampled(
        "mach",
        "Mach Number",
        (Dimension::One, ""),
        "Speed relative to the air over the speed of sound.",
        |s| Some(s.mach),
    ),
    sampled(
        "density_kg_m3",
        "Density",
        (Dimension::Density, "kg/m^3"),
        "Density of the air.",
        |s| Some(s.density_kg_m3),
    ),
    sampled(
        "temperature_k",
        "Air Temperature",
        (Dimension::Temperature, "K"),
        "Temperature of the air.",
        |s| Some(s.temperature_k),
    ),
    sampled(
        "pressure_pa",
        "Air Pressure",
        (Dimension::Pressure, "Pa"),
        "Static pressure of the air.",
        |s| Some(s.pressure_pa),
    ),
    sampled(
        "drag_coefficient",
        "Drag Coefficient",
        (Dimension::One, ""),
        "Drag coefficient in use.",
        |s| Some(s.drag_coefficient),
    ),
    sampled(
        "dynamic_pressure_pa",
        "Dynamic Pressure",
        (Dimension::Pressure, "kPa"),
        "Half the density times the square of the speed relative to the air.",
        |s| Some(s.dynamic_pressure_pa),
    ),
    sampled(
        "stagnation_pressure_pa",
        "Stagnation Pressure",
        (Dimension::Pressure, "kPa"),
        "Pressure at the stagnation point, by the model that the case chooses.",
        |s| Some(s.stagnation_pressure_pa),
    ),
    sampled(
        "deceleration_earth_g",
        "Deceleration",
        (Dimension::Load, "Earth g"),
        "Aerodynamic force over mass over 9.80665 m/s^2.",
        |s| Some(s.deceleration_earth_g),
    ),
    sampled(
        "convective_heat_flux_w_m2",
        "Convective Heat Rate",
        (Dimension::HeatFlux, "W/cm^2"),
        "Convective heat flux at the stagnation point without margin.",
        |s| Some(s.convective_heat_flux_w_m2),
    ),
    sampled(
        "radiative_heat_flux_w_m2",
        "Radiative Heat Rate",
        (Dimension::HeatFlux, "W/cm^2"),
        "Radiative heat flux at the stagnation point without margin.",
        |s| Some(s.radiative_heat_flux_w_m2),
    ),
    sampled(
        "total_heat_flux_w_m2",
        "Total Heat Rate",
        (Dimension::HeatFlux, "W/cm^2"),
        "Convective and radiative heat flux without margins.",
        |s| Some(s.total_heat_flux_w_m2),
    ),
    sampled(
        "total_margined_heat_flux_w_m2",
        "Total Heat Rate (Margined)",
        (Dimension::HeatFlux, "W/cm^2"),
        "Convective and radiative heat flux, each with its margin.",
        |s| Some(s.total_margined_heat_flux_w_m2),
    ),
    sampled(
        "convective_heat_load_j_m2",
        "Convective Heat Load",
        (Dimension::HeatLoad, "J/cm^2"),
        "Convective heat flux without margin, integrated over time.",
        |s| Some(s.convective_heat_load_j_m2),
    ),
    sampled(
        "radiative_heat_load_j_m2",
        "Radiative Heat Load",
        (Dimension::HeatLoad, "J/cm^2"),
        "Radiative heat flux without margin, integrated over time.",
        |s| Some(s.radiative_heat_load_j_m2),
    ),
    sampled(
        "wall_temperature_k",
        "Wall Temperature",
        (Dimension::Temperature, "K"),
        "Temperature at which the stagnation point radiates away the heat flux with margins.",
        |s| Some(s.wall_temperature_k),
    ),
    sampled(
        "knudsen",
        "Knudsen Number",
        (Dimension::One, ""),
        "Mean free path of the air over the reference length.",
        |s| Some(s.knudsen),
    ),
    sampled(
        "total_alpha_deg",
        "Total Angle of Attack",
        (Dimension::Angle, "deg"),
        "Angle between the axis of the vehicle and its velocity relative to the air; six degrees of freedom only.",
        |s| s.angle(|a| a.total_alpha_rad),
    ),
    sampled(
        "yaw_deg",
        "Yaw",
        (Dimension::Angle, "deg"),
        "Nose from north, clockwise; six degrees of freedom only.",
        |s| s.angle(|a| a.yaw_pitch_roll_rad[0]),
    ),
    sampled(
        "pitch_deg",
        "Pitch",
        (Dimension::Angle, "deg"),
        "Nose above the local horizon; six degrees of freedom only.",
        |s| s.angle(|a| a.yaw_pitch_roll_rad[1]),
    ),
    sampled(
        "roll_deg",
        "Roll",
        (Dimension::Angle, "deg"),
        "Right side down, after yaw and pitch; six degrees of freedom only.",
        |s| s.angle(|a| a.yaw_pitch_roll_rad[2]),
    ),
    sampled(
        "p_deg_s",
        "Roll Rate",
        (Dimension::BodyRate, "deg/s"),
        "Inertial rate about the axis forward; six degrees of freedom only.",
        |s| s.angle(|a| a.rates_rad_s[0]),
    ),
    sampled(
        "q_deg_s",
        "Pitch Rate",
        (Dimension::BodyRate, "deg/s"),
        "Inertial rate about the axis to the right; six degrees of freedom only.",
        |s| s.angle(|a| a.rates_rad_s[1]),
    ),
    sampled(
        "r_deg_s",
        "Yaw Rate",
        (Dimension::BodyRate, "deg/s"),
        "Inertial rate about the axis down; six degrees of freedom only.",
        |s| s.angle(|a| a.rates_rad_s[2]),
    ),
    sampled(
        PHASE,
        "Phase",
        (Dimension::One, ""),
        "Name of the phase, entry before the first; where a case has phases.",
        |s| s.phase,
    ),
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::Unit;

    #[test]
    fn units_fit_their_columns() {
        for column in columns() {
            assert!(
                Unit::find(column.unit).is_some_and(|u| u.dimension == column.dimension),
                "{}",
                column.key
            );
        }
    }
}
