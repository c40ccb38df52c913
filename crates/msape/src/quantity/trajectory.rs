//! Columns of a time history.

use crate::units::Dimension;

/// One column.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Column {
    /// Key with its SI unit, such as `altitude_m`.
    pub key: &'static str,
    /// Name for axes and headers, without the unit.
    pub label: &'static str,
    /// What it measures.
    pub dimension: Dimension,
    /// Symbol of the unit shown by default.
    pub unit: &'static str,
    /// One sentence: what it is.
    pub help: &'static str,
}

pub(crate) const fn column(
    key: &'static str,
    label: &'static str,
    dimension: Dimension,
    unit: &'static str,
    help: &'static str,
) -> Column {
    Column {
        key,
        label,
        dimension,
        unit,
        help,
    }
}

/// All columns, in the order of files.
pub fn columns() -> &'static [Column] {
    COLUMNS
}

/// The column with this key.
pub fn find(key: &str) -> Option<&'static Column> {
    COLUMNS.iter().find(|column| column.key == key)
}

/// Key of the column whose numbers stand for the names of phases.
pub const PHASE: &str = "phase";

static COLUMNS: &[Column] = &[
    column(
        "time_s",
        "Time",
        Dimension::Time,
        "s",
        "Time after the start.",
    ),
    column(
        "altitude_m",
        "Geodetic Altitude",
        Dimension::Length,
        "km",
        "Height above the reference ellipsoid.",
    ),
    column(
        "latitude_deg",
        "Latitude",
        Dimension::Angle,
        "deg",
        "Geodetic latitude, north positive.",
    ),
    column(
        "longitude_deg",
        "Longitude",
        Dimension::Angle,
        "deg",
        "Longitude, east positive, -180 to 180 deg.",
    ),
    column(
        "speed_m_s",
        "Relative Velocity",
        Dimension::Speed,
        "m/s",
        "Speed relative to the rotating planet.",
    ),
    column(
        "flight_path_angle_deg",
        "Flight Path Angle",
        Dimension::Angle,
        "deg",
        "Angle of the relative velocity against the geodetic horizon, negative down.",
    ),
    column(
        "azimuth_deg",
        "Azimuth",
        Dimension::Angle,
        "deg",
        "Direction of the horizontal relative velocity from north, clockwise.",
    ),
    column(
        "inertial_speed_m_s",
        "Inertial Velocity",
        Dimension::Speed,
        "m/s",
        "Speed in the frame that does not rotate with the planet.",
    ),
    column(
        "eastward_speed_m_s",
        "Eastward Velocity",
        Dimension::Speed,
        "m/s",
        "Relative velocity towards the east.",
    ),
    column(
        "northward_speed_m_s",
        "Northward Velocity",
        Dimension::Speed,
        "m/s",
        "Relative velocity towards the north.",
    ),
    column(
        "downward_speed_m_s",
        "Downward Velocity",
        Dimension::Speed,
        "m/s",
        "Relative velocity downwards along the geodetic vertical.",
    ),
    column(
        "downrange_m",
        "Downrange",
        Dimension::Length,
        "km",
        "Great circle from the start on a sphere of 6371 km.",
    ),
    column(
        "mach",
        "Mach Number",
        Dimension::One,
        "",
        "Speed relative to the air over the speed of sound.",
    ),
    column(
        "density_kg_m3",
        "Density",
        Dimension::Density,
        "kg/m^3",
        "Density of the air.",
    ),
    column(
        "temperature_k",
        "Air Temperature",
        Dimension::Temperature,
        "K",
        "Temperature of the air.",
    ),
    column(
        "pressure_pa",
        "Air Pressure",
        Dimension::Pressure,
        "Pa",
        "Static pressure of the air.",
    ),
    column(
        "drag_coefficient",
        "Drag Coefficient",
        Dimension::One,
        "",
        "Drag coefficient in use.",
    ),
    column(
        "dynamic_pressure_pa",
        "Dynamic Pressure",
        Dimension::Pressure,
        "kPa",
        "Half the density times the square of the speed relative to the air.",
    ),
    column(
        "stagnation_pressure_pa",
        "Stagnation Pressure",
        Dimension::Pressure,
        "kPa",
        "Pressure at the stagnation point, by the model of heating.stagnation_pressure.",
    ),
    column(
        "deceleration_earth_g",
        "Deceleration",
        Dimension::Load,
        "Earth g",
        "Aerodynamic force over mass over 9.80665 m/s^2.",
    ),
    column(
        "convective_heat_flux_w_m2",
        "Convective Heat Rate",
        Dimension::HeatFlux,
        "W/cm^2",
        "Convective heat flux at the stagnation point without margin.",
    ),
    column(
        "radiative_heat_flux_w_m2",
        "Radiative Heat Rate",
        Dimension::HeatFlux,
        "W/cm^2",
        "Radiative heat flux at the stagnation point without margin.",
    ),
    column(
        "total_heat_flux_w_m2",
        "Total Heat Rate",
        Dimension::HeatFlux,
        "W/cm^2",
        "Convective and radiative heat flux without margins.",
    ),
    column(
        "total_margined_heat_flux_w_m2",
        "Total Heat Rate (Margined)",
        Dimension::HeatFlux,
        "W/cm^2",
        "Convective and radiative heat flux, each with its margin.",
    ),
    column(
        "convective_heat_load_j_m2",
        "Convective Heat Load",
        Dimension::HeatLoad,
        "J/cm^2",
        "Convective heat flux without margin, integrated over time.",
    ),
    column(
        "radiative_heat_load_j_m2",
        "Radiative Heat Load",
        Dimension::HeatLoad,
        "J/cm^2",
        "Radiative heat flux without margin, integrated over time.",
    ),
    column(
        "wall_temperature_k",
        "Wall Temperature",
        Dimension::Temperature,
        "K",
        "Temperature at which the stagnation point radiates away the heat flux with margins.",
    ),
    column(
        "knudsen",
        "Knudsen Number",
        Dimension::One,
        "",
        "Mean free path of the air over the reference length.",
    ),
    column(
        "total_alpha_deg",
        "Total Angle of Attack",
        Dimension::Angle,
        "deg",
        "Angle between the axis of the vehicle and its velocity relative to the air; six degrees of freedom only.",
    ),
    column(
        "yaw_deg",
        "Yaw",
        Dimension::Angle,
        "deg",
        "Nose from north, clockwise; six degrees of freedom only.",
    ),
    column(
        "pitch_deg",
        "Pitch",
        Dimension::Angle,
        "deg",
        "Nose above the local horizon; six degrees of freedom only.",
    ),
    column(
        "roll_deg",
        "Roll",
        Dimension::Angle,
        "deg",
        "Right side down, after yaw and pitch; six degrees of freedom only.",
    ),
    column(
        "p_deg_s",
        "Roll Rate",
        Dimension::BodyRate,
        "deg/s",
        "Inertial rate about the axis forward; six degrees of freedom only.",
    ),
    column(
        "q_deg_s",
        "Pitch Rate",
        Dimension::BodyRate,
        "deg/s",
        "Inertial rate about the axis to the right; six degrees of freedom only.",
    ),
    column(
        "r_deg_s",
        "Yaw Rate",
        Dimension::BodyRate,
        "deg/s",
        "Inertial rate about the axis down; six degrees of freedom only.",
    ),
    column(
        PHASE,
        "Phase",
        Dimension::One,
        "",
        "Name of the phase, entry before the first; where a case has phases.",
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
