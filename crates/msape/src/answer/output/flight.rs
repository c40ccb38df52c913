//! Outputs of a flight.

use super::Output;
use crate::answer::Answer;
use crate::flight::Flight;
use crate::quantity::Module;
use crate::units::Dimension;
use numerics::math::RADIANS_PER_DEGREE;

fn flight(answer: &Answer, get: impl Fn(&Flight) -> f64) -> Option<f64> {
    answer.flight.as_ref().map(get)
}

pub(super) static OUTPUTS: &[Output] = &[
    Output::new("peak_deceleration_earth_g", "Max Entry Load", Module::Flight, |a| flight(a, |f| f.peak_deceleration_earth_g.value))
        .unit(Dimension::Load, "Earth g")
        .help("Largest aerodynamic force over mass over 9.80665 m/s^2.", "NASA/TM-2014-218507, section 3.2")
        .report(),
    Output::new("peak_deceleration_time_s", "Max Entry Load at Time", Module::Flight, |a| flight(a, |f| f.peak_deceleration_earth_g.time_s))
        .unit(Dimension::Time, "s")
        .help("Time of it after the start.", "NASA/TM-2014-218507, section 3.2"),
    Output::new("peak_deceleration_altitude_m", "Max Entry Load at Geodetic Altitude", Module::Flight, |a| flight(a, |f| f.peak_deceleration_earth_g.altitude_m))
        .unit(Dimension::Length, "m")
        .help("Geodetic altitude at which it occurs.", "NASA/TM-2014-218507, section 3.2"),
    Output::new("peak_deceleration_speed_m_s", "Max Entry Load at Relative Velocity", Module::Flight, |a| flight(a, |f| f.peak_deceleration_earth_g.speed_m_s))
        .unit(Dimension::Speed, "m/s")
        .help("Speed relative to the planet at which it occurs.", "NASA/TM-2014-218507, section 3.2"),
    Output::new("peak_deceleration_density_kg_m3", "Max Entry Load at Density", Module::Flight, |a| flight(a, |f| f.peak_deceleration_earth_g.density_kg_m3))
        .unit(Dimension::Density, "kg/m^3")
        .help("Density of the air at which it occurs.", "NASA/TM-2014-218507, section 3.2"),
    Output::new("peak_dynamic_pressure_pa", "Max Dynamic Pressure", Module::Flight, |a| flight(a, |f| f.peak_dynamic_pressure_pa.value))
        .unit(Dimension::Pressure, "Pa")
        .help("Largest half density times square of the speed relative to the air.", "NASA/TM-2014-218507, section 3.2")
        .report(),
    Output::new("peak_dynamic_pressure_time_s", "Max Dynamic Pressure at Time", Module::Flight, |a| flight(a, |f| f.peak_dynamic_pressure_pa.time_s))
        .unit(Dimension::Time, "s")
        .help("Time of it after the start.", "NASA/TM-2014-218507, section 3.2"),
    Output::new("peak_dynamic_pressure_altitude_m", "Max Dynamic Pressure at Geodetic Altitude", Module::Flight, |a| flight(a, |f| f.peak_dynamic_pressure_pa.altitude_m))
        .unit(Dimension::Length, "m")
        .help("Geodetic altitude at which it occurs.", "NASA/TM-2014-218507, section 3.2"),
    Output::new("peak_dynamic_pressure_speed_m_s", "Max Dynamic Pressure at Relative Velocity", Module::Flight, |a| flight(a, |f| f.peak_dynamic_pressure_pa.speed_m_s))
        .unit(Dimension::Speed, "m/s")
        .help("Speed relative to the planet at which it occurs.", "NASA/TM-2014-218507, section 3.2"),
    Output::new("peak_dynamic_pressure_density_kg_m3", "Max Dynamic Pressure at Density", Module::Flight, |a| flight(a, |f| f.peak_dynamic_pressure_pa.density_kg_m3))
        .unit(Dimension::Density, "kg/m^3")
        .help("Density of the air at which it occurs.", "NASA/TM-2014-218507, section 3.2"),
    Output::new("time_of_flight_s", "Time of Flight", Module::Flight, |a| flight(a, |f| f.time_of_flight_s))
        .unit(Dimension::Time, "s")
        .help("Time from the start to the end of the flight.", "NASA/TM-2014-218507, section 3.2")
        .report(),
    Output::new("downrange_m", "Downrange", Module::Flight, |a| flight(a, |f| f.downrange_m))
        .unit(Dimension::Length, "km")
        .help("Distance from start to end over the figure of the planet: on Earth the great circle on a sphere of 6371 km, elsewhere the shortest line on the ellipsoid.", "NASA/TM-2014-218507, section 3.2")
        .report(),
    Output::new("final_altitude_m", "Final Altitude", Module::Flight, |a| flight(a, |f| f.final_altitude_m))
        .unit(Dimension::Length, "m")
        .help("Geodetic altitude at the end.", "NASA/TM-2014-218507, section 3.2"),
    Output::new("final_speed_m_s", "Final Velocity", Module::Flight, |a| flight(a, |f| f.final_speed_m_s))
        .unit(Dimension::Speed, "m/s")
        .help("Speed relative to the planet at the end.", "NASA/TM-2014-218507, section 3.2"),
    Output::new("final_latitude_deg", "Final Latitude", Module::Flight, |a| flight(a, |f| f.final_latitude_rad / RADIANS_PER_DEGREE))
        .unit(Dimension::Angle, "deg")
        .help("Geodetic latitude at the end, north positive.", "NASA/TM-2014-218507, section 3.2"),
    Output::new("final_longitude_deg", "Final Longitude", Module::Flight, |a| flight(a, |f| f.final_longitude_rad / RADIANS_PER_DEGREE))
        .unit(Dimension::Angle, "deg")
        .help("Longitude at the end, east positive, -180 to 180 deg.", "NASA/TM-2014-218507, section 3.2"),
    Output::new("final_density_kg_m3", "Final Density", Module::Flight, |a| flight(a, |f| f.final_density_kg_m3))
        .unit(Dimension::Density, "kg/m^3")
        .help("Density of the air at the end.", "NASA/TM-2014-218507, section 3.2"),
    Output::new("mach_5_time_s", "Mach 5 at Time", Module::Flight, |a| a.flight.as_ref().and_then(|f| f.mach_times_s[0]))
        .unit(Dimension::Time, "s")
        .help("Time of the downward crossing of Mach 5 after peak deceleration.", "NASA/TM-2014-218507, section 3.2"),
    Output::new("mach_2_time_s", "Mach 2 at Time", Module::Flight, |a| a.flight.as_ref().and_then(|f| f.mach_times_s[1]))
        .unit(Dimension::Time, "s")
        .help("Time of the downward crossing of Mach 2 after peak deceleration.", "NASA/TM-2014-218507, section 3.2"),
    Output::new("mach_1p4_time_s", "Mach 1.4 at Time", Module::Flight, |a| a.flight.as_ref().and_then(|f| f.mach_times_s[2]))
        .unit(Dimension::Time, "s")
        .help("Time of the downward crossing of Mach 1.4 after peak deceleration.", "NASA/TM-2014-218507, section 3.2"),
    Output::new("mach_0p8_time_s", "Mach 0.8 at Time", Module::Flight, |a| a.flight.as_ref().and_then(|f| f.mach_times_s[3]))
        .unit(Dimension::Time, "s")
        .help("Time of the downward crossing of Mach 0.8 after peak deceleration.", "NASA/TM-2014-218507, section 3.2"),
    Output::new("entry_relative_speed_m_s", "Entry Relative Velocity", Module::Flight, |a| flight(a, |f| f.entry_relative.speed_m_s))
        .unit(Dimension::Speed, "m/s")
        .help("Speed at the start, relative to the rotating planet.", "NASA/TM-2014-218507, section 3.2"),
    Output::new("entry_relative_flight_path_angle_deg", "Entry Relative Flight Path Angle", Module::Flight, |a| flight(a, |f| f.entry_relative.flight_path_angle_rad / RADIANS_PER_DEGREE))
        .unit(Dimension::Angle, "deg")
        .help("Angle of that velocity against the geodetic horizon, negative down.", "NASA/TM-2014-218507, section 3.2"),
    Output::new("entry_relative_azimuth_deg", "Entry Relative Azimuth", Module::Flight, |a| flight(a, |f| f.entry_relative.azimuth_rad / RADIANS_PER_DEGREE))
        .unit(Dimension::Angle, "deg")
        .help("Direction of its horizontal part from north, clockwise.", "NASA/TM-2014-218507, section 3.2"),
    Output::new("entry_inertial_speed_m_s", "Entry Inertial Velocity", Module::Flight, |a| flight(a, |f| f.entry_inertial.speed_m_s))
        .unit(Dimension::Speed, "m/s")
        .help("Speed at the start in the frame that does not rotate.", "NASA/TM-2014-218507, section 3.2"),
    Output::new("entry_inertial_flight_path_angle_deg", "Entry Inertial Flight Path Angle", Module::Flight, |a| flight(a, |f| f.entry_inertial.flight_path_angle_rad / RADIANS_PER_DEGREE))
        .unit(Dimension::Angle, "deg")
        .help("Angle of that velocity against the geodetic horizon, negative down.", "NASA/TM-2014-218507, section 3.2"),
    Output::new("entry_inertial_azimuth_deg", "Entry Inertial Azimuth", Module::Flight, |a| flight(a, |f| f.entry_inertial.azimuth_rad / RADIANS_PER_DEGREE))
        .unit(Dimension::Angle, "deg")
        .help("Direction of its horizontal part from north, clockwise.", "NASA/TM-2014-218507, section 3.2"),
    Output::new("ballistic_coefficient_kg_m2", "Ballistic Coefficient at Max Entry Load", Module::Aerodynamics, |a| flight(a, |f| f.ballistic_coefficient_kg_m2).filter(|beta| *beta < f64::INFINITY))
        .unit(Dimension::ArealDensity, "kg/m^2")
        .help("Mass over drag coefficient and reference area at peak deceleration; absent without drag.", "NASA/TM-2014-218507, equation 5"),
    Output::new("peak_convective_heat_flux_w_m2", "Forebody Max Convective Heat Rate", Module::Heating, |a| flight(a, |f| f.peak_convective_heat_flux_w_m2.value))
        .unit(Dimension::HeatFlux, "W/cm^2")
        .help("Largest convective heat flux at the stagnation point, without margin.", "NASA/TM-2014-218507, equation 8"),
    Output::new("peak_convective_heat_flux_time_s", "Forebody Max Convective Heat Rate at Time", Module::Heating, |a| flight(a, |f| f.peak_convective_heat_flux_w_m2.time_s))
        .unit(Dimension::Time, "s")
        .help("Time of it after the start.", "NASA/TM-2014-218507, equation 8"),
    Output::new("peak_convective_heat_flux_altitude_m", "Forebody Max Convective Heat Rate at Geodetic Altitude", Module::Heating, |a| flight(a, |f| f.peak_convective_heat_flux_w_m2.altitude_m))
        .unit(Dimension::Length, "m")
        .help("Geodetic altitude at which it occurs.", "NASA/TM-2014-218507, equation 8"),
    Output::new("peak_convective_heat_flux_speed_m_s", "Forebody Max Convective Heat Rate at Relative Velocity", Module::Heating, |a| flight(a, |f| f.peak_convective_heat_flux_w_m2.speed_m_s))
        .unit(Dimension::Speed, "m/s")
        .help("Speed relative to the planet at which it occurs.", "NASA/TM-2014-218507, equation 8"),
    Output::new("peak_convective_heat_flux_density_kg_m3", "Forebody Max Convective Heat Rate at Density", Module::Heating, |a| flight(a, |f| f.peak_convective_heat_flux_w_m2.density_kg_m3))
        .unit(Dimension::Density, "kg/m^3")
        .help("Density of the air at which it occurs.", "NASA/TM-2014-218507, equation 8"),
    Output::new("peak_radiative_heat_flux_w_m2", "Forebody Max Radiative Heat Rate", Module::Heating, |a| a.flight.as_ref().and_then(|f| f.peak_radiative_heat_flux_w_m2.map(|p| p.value)))
        .unit(Dimension::HeatFlux, "W/cm^2")
        .help("Largest radiative heat flux at the stagnation point, without margin.", "Tauber and Sutton 1991"),
    Output::new("peak_radiative_heat_flux_time_s", "Forebody Max Radiative Heat Rate at Time", Module::Heating, |a| a.flight.as_ref().and_then(|f| f.peak_radiative_heat_flux_w_m2.map(|p| p.time_s)))
        .unit(Dimension::Time, "s")
        .help("Time of it after the start.", "Tauber and Sutton 1991"),
    Output::new("peak_radiative_heat_flux_altitude_m", "Forebody Max Radiative Heat Rate at Geodetic Altitude", Module::Heating, |a| a.flight.as_ref().and_then(|f| f.peak_radiative_heat_flux_w_m2.map(|p| p.altitude_m)))
        .unit(Dimension::Length, "m")
        .help("Geodetic altitude at which it occurs.", "Tauber and Sutton 1991"),
    Output::new("peak_radiative_heat_flux_speed_m_s", "Forebody Max Radiative Heat Rate at Relative Velocity", Module::Heating, |a| a.flight.as_ref().and_then(|f| f.peak_radiative_heat_flux_w_m2.map(|p| p.speed_m_s)))
        .unit(Dimension::Speed, "m/s")
        .help("Speed relative to the planet at which it occurs.", "Tauber and Sutton 1991"),
    Output::new("peak_radiative_heat_flux_density_kg_m3", "Forebody Max Radiative Heat Rate at Density", Module::Heating, |a| a.flight.as_ref().and_then(|f| f.peak_radiative_heat_flux_w_m2.map(|p| p.density_kg_m3)))
        .unit(Dimension::Density, "kg/m^3")
        .help("Density of the air at which it occurs.", "Tauber and Sutton 1991"),
    Output::new("peak_total_heat_flux_w_m2", "Forebody Max Total Heat Rate", Module::Heating, |a| flight(a, |f| f.peak_total_heat_flux_w_m2.value))
        .unit(Dimension::HeatFlux, "W/cm^2")
        .help("Largest sum of convective and radiative heat flux, without margins.", "NASA/TM-2014-218507, section 3.4"),
    Output::new("peak_total_heat_flux_time_s", "Forebody Max Total Heat Rate at Time", Module::Heating, |a| flight(a, |f| f.peak_total_heat_flux_w_m2.time_s))
        .unit(Dimension::Time, "s")
        .help("Time of it after the start.", "NASA/TM-2014-218507, section 3.4"),
    Output::new("peak_total_heat_flux_altitude_m", "Forebody Max Total Heat Rate at Geodetic Altitude", Module::Heating, |a| flight(a, |f| f.peak_total_heat_flux_w_m2.altitude_m))
        .unit(Dimension::Length, "m")
        .help("Geodetic altitude at which it occurs.", "NASA/TM-2014-218507, section 3.4"),
    Output::new("peak_total_heat_flux_speed_m_s", "Forebody Max Total Heat Rate at Relative Velocity", Module::Heating, |a| flight(a, |f| f.peak_total_heat_flux_w_m2.speed_m_s))
        .unit(Dimension::Speed, "m/s")
        .help("Speed relative to the planet at which it occurs.", "NASA/TM-2014-218507, section 3.4"),
    Output::new("peak_total_heat_flux_density_kg_m3", "Forebody Max Total Heat Rate at Density", Module::Heating, |a| flight(a, |f| f.peak_total_heat_flux_w_m2.density_kg_m3))
        .unit(Dimension::Density, "kg/m^3")
        .help("Density of the air at which it occurs.", "NASA/TM-2014-218507, section 3.4"),
    Output::new("peak_convective_margined_heat_flux_w_m2", "Forebody Max Convective Heat Rate (Margined)", Module::Heating, |a| flight(a, |f| f.peak_convective_heat_flux_w_m2.value * f.convective_margin))
        .unit(Dimension::HeatFlux, "W/cm^2")
        .help("Largest convective heat flux at the stagnation point with its margin.", "NASA/TM-2014-218507, section 3.4")
        .report(),
    Output::new("peak_convective_margined_heat_flux_density_kg_m3", "Forebody Max Convective Heat Rate (Margined) at Density", Module::Heating, |a| flight(a, |f| f.peak_convective_heat_flux_w_m2.density_kg_m3))
        .unit(Dimension::Density, "kg/m^3")
        .help("Density of the air at which it occurs.", "NASA/TM-2014-218507, section 3.4")
        .report(),
    Output::new("peak_convective_margined_heat_flux_altitude_m", "Forebody Max Convective Heat Rate (Margined) at Geodetic Altitude", Module::Heating, |a| flight(a, |f| f.peak_convective_heat_flux_w_m2.altitude_m))
        .unit(Dimension::Length, "m")
        .help("Geodetic altitude at which it occurs.", "NASA/TM-2014-218507, section 3.4")
        .report(),
    Output::new("peak_convective_margined_heat_flux_speed_m_s", "Forebody Max Convective Heat Rate (Margined) at Relative Velocity", Module::Heating, |a| flight(a, |f| f.peak_convective_heat_flux_w_m2.speed_m_s))
        .unit(Dimension::Speed, "m/s")
        .help("Speed relative to the planet at which it occurs.", "NASA/TM-2014-218507, section 3.4")
        .report(),
    Output::new("peak_radiative_margined_heat_flux_w_m2", "Forebody Max Radiative Heat Rate (Margined)", Module::Heating, |a| a.flight.as_ref().and_then(|f| f.peak_radiative_heat_flux_w_m2.map(|p| p.value * f.radiative_margin)))
        .unit(Dimension::HeatFlux, "W/cm^2")
        .help("Largest radiative heat flux at the stagnation point with its margin.", "NASA/TM-2014-218507, section 3.4"),
    Output::new("peak_total_margined_heat_flux_w_m2", "Forebody Max Total Heat Rate (Margined)", Module::Heating, |a| flight(a, |f| f.peak_total_margined_heat_flux_w_m2.value))
        .unit(Dimension::HeatFlux, "W/cm^2")
        .help("Largest sum of convective and radiative heat flux, each with its margin.", "NASA/TM-2014-218507, section 3.4")
        .report(),
    Output::new("peak_total_margined_heat_flux_time_s", "Forebody Max Total Heat Rate (Margined) at Time", Module::Heating, |a| flight(a, |f| f.peak_total_margined_heat_flux_w_m2.time_s))
        .unit(Dimension::Time, "s")
        .help("Time of it after the start.", "NASA/TM-2014-218507, section 3.4"),
    Output::new("peak_total_margined_heat_flux_altitude_m", "Forebody Max Total Heat Rate (Margined) at Geodetic Altitude", Module::Heating, |a| flight(a, |f| f.peak_total_margined_heat_flux_w_m2.altitude_m))
        .unit(Dimension::Length, "m")
        .help("Geodetic altitude at which it occurs.", "NASA/TM-2014-218507, section 3.4"),
    Output::new("peak_total_margined_heat_flux_speed_m_s", "Forebody Max Total Heat Rate (Margined) at Relative Velocity", Module::Heating, |a| flight(a, |f| f.peak_total_margined_heat_flux_w_m2.speed_m_s))
        .unit(Dimension::Speed, "m/s")
        .help("Speed relative to the planet at which it occurs.", "NASA/TM-2014-218507, section 3.4"),
    Output::new("peak_total_margined_heat_flux_density_kg_m3", "Forebody Max Total Heat Rate (Margined) at Density", Module::Heating, |a| flight(a, |f| f.peak_total_margined_heat_flux_w_m2.density_kg_m3))
        .unit(Dimension::Density, "kg/m^3")
        .help("Density of the air at which it occurs.", "NASA/TM-2014-218507, section 3.4"),
    Output::new("convective_heat_load_j_m2", "Forebody Convective Heat Load", Module::Heating, |a| flight(a, |f| f.convective_heat_load_j_m2))
        .unit(Dimension::HeatLoad, "J/cm^2")
        .help("Convective heat flux at the stagnation point integrated over the flight, without margin.", "NASA/TM-2014-218507, section 3.4"),
    Output::new("radiative_heat_load_j_m2", "Forebody Radiative Heat Load", Module::Heating, |a| flight(a, |f| f.radiative_heat_load_j_m2))
        .unit(Dimension::HeatLoad, "J/cm^2")
        .help("Radiative heat flux at the stagnation point integrated over the flight, without margin.", "NASA/TM-2014-218507, section 3.4"),
    Output::new("total_heat_load_j_m2", "Forebody Total Heat Load", Module::Heating, |a| flight(a, |f| f.convective_heat_load_j_m2 + f.radiative_heat_load_j_m2))
        .unit(Dimension::HeatLoad, "J/cm^2")
        .help("Sum of both heat loads, without margins.", "NASA/TM-2014-218507, section 3.4"),
    Output::new("convective_margined_heat_load_j_m2", "Forebody Convective Heat Load (Margined)", Module::Heating, |a| flight(a, |f| f.convective_heat_load_j_m2 * f.convective_margin))
        .unit(Dimension::HeatLoad, "J/cm^2")
        .help("Convective heat load with its margin.", "NASA/TM-2014-218507, section 3.4")
        .report(),
    Output::new("radiative_margined_heat_load_j_m2", "Forebody Radiative Heat Load (Margined)", Module::Heating, |a| flight(a, |f| f.radiative_heat_load_j_m2 * f.radiative_margin))
        .unit(Dimension::HeatLoad, "J/cm^2")
        .help("Radiative heat load with its margin.", "NASA/TM-2014-218507, section 3.4"),
    Output::new("total_margined_heat_load_j_m2", "Forebody Total Heat Load (Margined)", Module::Heating, |a| flight(a, Flight::total_margined_heat_load_j_m2))
        .unit(Dimension::HeatLoad, "J/cm^2")
        .help("Sum of both heat loads, each with its margin.", "NASA/TM-2014-218507, section 3.4")
        .report(),
    Output::new("peak_stagnation_pressure_pa", "Max Stagnation Pressure", Module::Heating, |a| flight(a, |f| f.peak_stagnation_pressure_pa.value))
        .unit(Dimension::Pressure, "Pa")
        .help("Pressure at the stagnation point about the largest dynamic pressure, by the model that the case chooses.", "NASA/TM-2014-218507, equations 9 to 12"),
    Output::new("peak_stagnation_pressure_time_s", "Max Stagnation Pressure at Time", Module::Heating, |a| flight(a, |f| f.peak_stagnation_pressure_pa.time_s))
        .unit(Dimension::Time, "s")
        .help("Time of it after the start.", "NASA/TM-2014-218507, equations 10 to 12"),
    Output::new("peak_stagnation_pressure_altitude_m", "Max Stagnation Pressure at Geodetic Altitude", Module::Heating, |a| flight(a, |f| f.peak_stagnation_pressure_pa.altitude_m))
        .unit(Dimension::Length, "m")
        .help("Geodetic altitude at which it occurs.", "NASA/TM-2014-218507, equations 10 to 12"),
    Output::new("peak_stagnation_pressure_speed_m_s", "Max Stagnation Pressure at Relative Velocity", Module::Heating, |a| flight(a, |f| f.peak_stagnation_pressure_pa.speed_m_s))
        .unit(Dimension::Speed, "m/s")
        .help("Speed relative to the planet at which it occurs.", "NASA/TM-2014-218507, equations 10 to 12"),
    Output::new("peak_stagnation_pressure_density_kg_m3", "Max Stagnation Pressure at Density", Module::Heating, |a| flight(a, |f| f.peak_stagnation_pressure_pa.density_kg_m3))
        .unit(Dimension::Density, "kg/m^3")
        .help("Density of the air at which it occurs.", "NASA/TM-2014-218507, equations 10 to 12"),
    Output::new("peak_wall_temperature_k", "Max Wall Temperature", Module::Heating, |a| flight(a, |f| f.peak_wall_temperature_k))
        .unit(Dimension::Temperature, "K")
        .help("Largest temperature at which the stagnation point radiates away the heat flux with margins.", "NASA/TM-2014-218507, section 3.4.2"),
];
