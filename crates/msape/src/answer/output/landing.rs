//! Outputs of the landing.

use super::Output;
use crate::answer::Answer;
use crate::quantity::Module;
use crate::units::Dimension;
use crate::vehicle::impact::estimates::Fall;
use crate::vehicle::impact::landing::Landing;
use numerics::math::RADIANS_PER_DEGREE;

const SECTION: &str = "NASA/TM-2014-218507, section 3.1.5";
const DYNAMICS: &str = "crush dynamics in one dimension, after NASA/TM-2014-218507, section 3.1.5";
/// Relative deviation of the terminal speed from that of equation 2 up to which gravity is that of the Earth, where it is within
/// 0.5 % of the standard value.
const EARTH_TOLERANCE: f64 = 0.01;
const FOAM: &str = "Gibson and Ashby, Cellular Solids; data sheets of Rohacell";

fn landing(answer: &Answer, get: impl Fn(&Landing) -> f64) -> Option<f64> {
    answer.design.as_ref().map(|design| get(&design.landing))
}

/// The vehicle at terminal speed; absent where the weight of equation 2 is not that on Earth.
fn fall(answer: &Answer) -> Option<Fall> {
    let (design, flight) = (answer.design.as_ref()?, answer.flight.as_ref()?);
    let vehicle = &design.vehicle;
    let fall = Fall {
        mass_kg: vehicle.mass.mass_kg,
        diameter_m: vehicle.dimensions.diameter_m,
        drag_coefficient: design.impact_drag_coefficient,
        density_kg_m3: flight.final_density_kg_m3,
    };
    let speed = design.terminal_speed_m_s / fall.terminal_speed_m_s();
    ((speed - 1.0).abs() < EARTH_TOLERANCE).then_some(fall)
}

pub(super) static OUTPUTS: &[Output] = &[
    Output::new("impact_speed_m_s", "Impact Velocity", Module::Impact, |a| landing(a, |l| l.velocity.speed_m_s))
        .unit(Dimension::Speed, "m/s")
        .help("Speed at touchdown relative to the ground; the terminal velocity where the flight does not come down.", SECTION),
    Output::new("impact_horizontal_speed_m_s", "Impact Velocity, Horizontal", Module::Impact, |a| landing(a, |l| l.velocity.horizontal_m_s))
        .unit(Dimension::Speed, "m/s")
        .help("Horizontal part of the velocity at touchdown, such as the wind's.", SECTION),
    Output::new("impact_off_axis_angle_deg", "Impact Velocity off the Vertical", Module::Impact, |a| landing(a, |l| l.velocity.off_axis_rad() / RADIANS_PER_DEGREE))
        .unit(Dimension::Angle, "deg")
        .help("Angle between the velocity at touchdown and the vertical; the models of the landing are vertical.", SECTION),
    Output::new("peak_impact_deceleration_earth_g", "Max Impact Deceleration", Module::Impact, |a| landing(a, |l| l.ground.peak_load_earth_g))
        .unit(Dimension::Load, "g's")
        .help("Largest deceleration of the payload on the chosen ground, with crush of the foam and penetration together.", DYNAMICS),
    Output::new("rigid_surface_peak_load_earth_g", "Max Impact Deceleration on a Rigid Surface", Module::Impact, |a| landing(a, |l| l.rigid_surface.peak_load_earth_g))
        .unit(Dimension::Load, "g's")
        .help("Largest deceleration of the payload on a rigid surface, where the foam takes all.", DYNAMICS),
    Output::new("rigid_surface_sphere_peak_load_earth_g", "Max Impact Deceleration on a Rigid Surface with the Impact Sphere", Module::Impact, |a| a.design.as_ref().and_then(|d| d.landing.sphere_peak_load_earth_g))
        .unit(Dimension::Load, "g's")
        .help("The same where the whole impact sphere crushes the foam and not the payload alone; absent without one.", DYNAMICS),
    Output::new("equation_3_impact_load_earth_g", "Impact Load of Equation 3", Module::Impact, |a| {
        let impact = &a.design.as_ref()?.vehicle.impact;
        Some(fall(a)?.penetration_load_earth_g(impact.penetration_alpha?, impact.nose_diameter_m))
    })
        .unit(Dimension::Load, "g's")
        .help("Equation 1 at the terminal velocity of equation 2: peak deceleration of a rigid vehicle without its mass and speed; absent on other grounds and away from Earth.", "NASA/TM-2014-218507, equation 3"),
    Output::new("equation_5_stroke_m", "Required Stroke of Equation 5", Module::Impact, |a| {
        let vehicle = &a.design.as_ref()?.vehicle;
        Some(fall(a)?.required_stroke_m(vehicle.concept, vehicle.impact.crush_load_limit_earth_g))
    })
        .unit(Dimension::Length, "cm")
        .help("Equation 4 at the terminal velocity of equation 2: in proportion to the ballistic coefficient; doubled for the MSR concept as equation 4 is, absent away from Earth.", "NASA/TM-2014-218507, equation 5"),
    Output::new("stroke_efficiency", "Stroke Efficiency in Use", Module::Impact, |a| a.design.as_ref().map(|d| d.vehicle.impact.stroke_efficiency))
        .help("Stroke over the foam thickness that it asks for: that of the case or, where the plateau of the foam ends before, the end of it.", FOAM),
    Output::new("equation_6_foam_strength_pa", "Foam Crush Strength of Equation 6", Module::Impact, |a| a.design.as_ref().map(|d| d.vehicle.impact.equation_6_strength_pa))
        .unit(Dimension::Pressure, "MPa")
        .help("Strength that equation 6 asks for over the payload's cross-section; that in use is the Foam Crush Strength.", "NASA/TM-2014-218507, equation 6"),
    Output::new("dynamic_stroke_m", "Dynamic Stroke", Module::Impact, |a| landing(a, |l| l.ground.stroke_m))
        .unit(Dimension::Length, "cm")
        .help("Crush of the impact foam on the chosen ground.", DYNAMICS),
    Output::new("rigid_surface_stroke_m", "Dynamic Stroke on a Rigid Surface", Module::Impact, |a| landing(a, |l| l.rigid_surface.stroke_m))
        .unit(Dimension::Length, "cm")
        .help("Crush of the impact foam on a rigid surface.", DYNAMICS),
    Output::new("impact_pulse_duration_s", "Impact Duration", Module::Impact, |a| landing(a, |l| l.ground.duration_s))
        .unit(Dimension::Time, "ms")
        .help("Time from first contact to the payload's stop on the chosen ground.", DYNAMICS),
    Output::new("rigid_surface_pulse_duration_s", "Impact Duration on a Rigid Surface", Module::Impact, |a| landing(a, |l| l.rigid_surface.duration_s))
        .unit(Dimension::Time, "ms")
        .help("Time from first contact to the payload's stop on a rigid surface.", DYNAMICS),
    Output::new("penetration_depth_m", "Penetration Depth", Module::Impact, |a| landing(a, |l| l.ground.penetration_m))
        .unit(Dimension::Length, "cm")
        .help("Depth of the vehicle in the chosen ground when the payload stands still.", DYNAMICS),
    Output::new("estimated_penetration_depth_m", "Estimated Penetration Depth", Module::Impact, |a| landing(a, |l| l.rigid_body_depth_m))
        .unit(Dimension::Length, "cm")
        .help("Depth of a rigid vehicle of the same mass in the chosen ground; with equation 1, of a resistance in proportion to the depth that has its peak.", SECTION),
    Output::new("impact_foam_energy_j", "Energy in the Impact Foam (J)", Module::Impact, |a| landing(a, |l| l.ground.foam_energy_j))
        .help("Energy that the impact foam takes on the chosen ground, in J.", DYNAMICS),
    Output::new("rigid_surface_foam_energy_j", "Energy in the Impact Foam on a Rigid Surface (J)", Module::Impact, |a| landing(a, |l| l.rigid_surface.foam_energy_j))
        .help("Energy that the impact foam takes on a rigid surface, in J: the kinetic energy of what crushes it.", DYNAMICS),
    Output::new("impact_energy_residual", "Energy Residual of the Landing", Module::Impact, |a| landing(a, |l| l.ground.energy_residual.max(l.rigid_surface.energy_residual)))
        .help("Energy missing in the balance of the landing over that at impact; an error of the integration.", DYNAMICS),
    Output::new("crushing_mass_kg", "Crushing Mass", Module::Impact, |a| landing(a, |l| l.payload_side_kg))
        .unit(Dimension::Mass, "kg")
        .help("Mass that crushes the impact foam: the payload, or the impact sphere with it.", SECTION),
    Output::new("foam_plateau_stress_pa", "Foam Plateau Stress", Module::Impact, |a| landing(a, |l| l.absorber.law.plateau_pa))
        .unit(Dimension::Pressure, "MPa")
        .help("Stress at which the impact foam crushes: that of its grade.", FOAM),
    Output::new("foam_plateau_strain", "Foam Strain at the End of the Plateau", Module::Impact, |a| landing(a, |l| l.absorber.law.plateau_strain()))
        .help("Crush over thickness from which the impact foam stiffens.", FOAM),
    Output::new("foam_densification_margin", "Foam Densification Margin", Module::Impact, |a| landing(a, Landing::densification_margin))
        .help("Part of the plateau's crush that a rigid surface leaves; negative where the foam densifies.", FOAM),
    Output::new("foam_thickness_needed_m", "Foam Thickness Needed", Module::Impact, |a| a.design.as_ref().and_then(|d| d.landing.foam_needed_m))
        .unit(Dimension::Length, "cm")
        .help("Thickness of foam of this strength that stays on its plateau on a rigid surface.", DYNAMICS),
    Output::new("foam_strength_needed_pa", "Foam Crush Strength Needed", Module::Impact, |a| landing(a, |l| l.strength_needed_pa))
        .unit(Dimension::Pressure, "MPa")
        .help("Crush strength with which foam of this thickness stays on its plateau on a rigid surface.", DYNAMICS),
];
