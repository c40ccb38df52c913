//! Outputs of a design.

use super::Output;
use crate::answer::Answer;
use crate::design::Design;
use crate::quantity::Module;
use crate::units::Dimension;
use crate::vehicle::ComponentKind;
use crate::vehicle::impact::RigidBodyLoad;
use numerics::math::RADIANS_PER_DEGREE;

fn design(answer: &Answer, get: impl Fn(&Design) -> f64) -> Option<f64> {
    answer.design.as_ref().map(get)
}

fn penetration(answer: &Answer, get: impl Fn(&RigidBodyLoad) -> f64) -> Option<f64> {
    let load = answer.design.as_ref()?.vehicle.impact.ground_penetration;
    load.as_ref().map(get)
}

pub(super) static OUTPUTS: &[Output] = &[
    Output::new("number_of_iterations", "Number of Iterations", Module::Coupling, |a| design(a, |d| f64::from(d.passes)))
        .help("Passes through the modules.", "NASA/TM-2014-218507, section 2.2")
        .report(),
    Output::new("mass_residual_kg", "Mass Left to Settle", Module::Coupling, |a| a.design.as_ref().and_then(|d| d.mass_residual_kg))
        .unit(Dimension::Mass, "kg")
        .help("Estimated distance of the entry mass from where further passes would lead it.", "NASA/TM-2014-218507, section 2.2"),
    Output::new("diameter_m", "Vehicle Diameter", Module::Geometry, |a| design(a, |d| d.vehicle.dimensions.diameter_m))
        .unit(Dimension::Length, "m")
        .help("Largest diameter after the closing rules.", "NASA/TM-2014-218507, Appendix D"),
    Output::new("nose_radius_m", "Nose Radius", Module::Geometry, |a| design(a, |d| d.vehicle.dimensions.nose_radius_m))
        .unit(Dimension::Length, "m")
        .help("Radius of the nose.", "NASA/TM-2014-218507, Appendix D")
        .report(),
    Output::new("input_shoulder_radius_m", "Input Shoulder Radius", Module::Geometry, |a| design(a, |d| d.vehicle.dimensions.input_shoulder_radius_m))
        .unit(Dimension::Length, "m")
        .help("Shoulder radius asked for, at the final diameter.", "NASA/TM-2014-218507, Appendix D")
        .report(),
    Output::new("shoulder_radius_m", "Shoulder Radius", Module::Geometry, |a| design(a, |d| d.vehicle.dimensions.shoulder_radius_m))
        .unit(Dimension::Length, "m")
        .help("Shoulder radius after the closing rules.", "NASA/TM-2014-218507, Appendix D"),
    Output::new("forebody_cone_angle_deg", "Forebody Cone Angle", Module::Geometry, |a| design(a, |d| d.cone_half_angle_rad / RADIANS_PER_DEGREE))
        .unit(Dimension::Angle, "deg")
        .help("Half-angle of the forebody cone.", "NASA/TM-2014-218507, Appendix D")
        .report(),
    Output::new("wing_slope_deg", "Wing Slope", Module::Geometry, |a| design(a, |d| d.vehicle.dimensions.wing_slope_rad / RADIANS_PER_DEGREE))
        .unit(Dimension::Angle, "deg")
        .help("Slope of the aft side of the wing against the plane normal to the axis.", "NASA/TM-2014-218507, section 3.1.2"),
    Output::new("vehicle_height_m", "Vehicle Height", Module::Geometry, |a| design(a, |d| d.vehicle.dimensions.vehicle_height_m))
        .unit(Dimension::Length, "m")
        .help("From the nose to the top of the lid.", "NASA/TM-2014-218507, Appendix D")
        .report(),
    Output::new("lid_radius_m", "Lid Radius", Module::Geometry, |a| design(a, |d| d.vehicle.dimensions.lid_radius_m))
        .unit(Dimension::Length, "m")
        .help("Outer radius of the lid.", "NASA/TM-2014-218507, Appendix D")
        .report(),
    Output::new("lid_height_m", "Lid Height", Module::Geometry, |a| design(a, |d| d.vehicle.dimensions.lid_height_m))
        .unit(Dimension::Length, "m")
        .help("Top of the lid above the attached structure.", "NASA/TM-2014-218507, Appendix D")
        .report(),
    Output::new("attached_structure_depth_m", "Attached Structure Depth", Module::Geometry, |a| design(a, |d| d.vehicle.dimensions.attached_structure_depth_m))
        .unit(Dimension::Length, "m")
        .help("From the nose to the attached structure.", "NASA/TM-2014-218507, Appendix D")
        .report(),
    Output::new("payload_diameter_m", "Payload Diameter", Module::Geometry, |a| design(a, |d| d.vehicle.dimensions.payload_diameter_m))
        .unit(Dimension::Length, "m")
        .help("Diameter of the payload, a sphere.", "NASA/TM-2014-218507, Appendix D")
        .report(),
    Output::new("payload_height_m", "Payload Height", Module::Geometry, |a| design(a, |d| d.vehicle.dimensions.payload_height_m))
        .unit(Dimension::Length, "m")
        .help("From the nose to the center of the payload.", "NASA/TM-2014-218507, Appendix D")
        .report(),
    Output::new("reference_area_m2", "Reference Area", Module::Geometry, |a| design(a, |d| d.vehicle.dimensions.reference_area_m2))
        .unit(Dimension::Area, "m^2")
        .help("Area of the circle of the vehicle diameter.", "NASA/TM-2014-218507, Appendix D"),
    Output::new("forebody_area_m2", "Forebody Wetted Area", Module::Geometry, |a| design(a, |d| d.vehicle.dimensions.forebody_area_m2))
        .unit(Dimension::Area, "m^2")
        .help("Area of nose, cone and shoulder up to the largest diameter.", "NASA/TM-2014-218507, Appendix D"),
    Output::new("wetted_area_m2", "Wetted Area", Module::Geometry, |a| design(a, |d| d.vehicle.dimensions.wetted_area_m2))
        .unit(Dimension::Area, "m^2")
        .help("Area of the whole outer surface.", "NASA/TM-2014-218507, Appendix D"),
    Output::new("total_entry_mass_kg", "Total Entry Mass", Module::Mass, |a| design(a, |d| d.vehicle.mass.mass_kg))
        .unit(Dimension::Mass, "kg")
        .help("Mass at entry, with the margin on everything but the payload.", "NASA/TM-2014-218507, section 3.1.4")
        .report(),
    Output::new("mass_without_margin_kg", "Entry Mass without Margin", Module::Mass, |a| design(a, |d| d.vehicle.mass.mass_without_margin_kg))
        .unit(Dimension::Mass, "kg")
        .help("Mass at entry without any margin.", "NASA/TM-2014-218507, section 3.1.4"),
    Output::new("payload_mass_kg", "Payload Mass", Module::Mass, |a| design(a, |d| d.payload_mass_kg))
        .unit(Dimension::Mass, "kg")
        .help("Mass of the payload.", "NASA/TM-2014-218507, section 3.1.1"),
    Output::new("vehicle_cg_location_from_nose_m", "Vehicle CG Location from Nose", Module::Mass, |a| design(a, |d| d.vehicle.dimensions.cg_from_nose_m))
        .unit(Dimension::Length, "m")
        .help("Center of gravity behind the nose.", "NASA/TM-2014-218507, Appendix D")
        .report(),
    Output::new("vertical_cg_location_m", "Vertical C.G. Location", Module::Mass, |a| design(a, |d| d.vehicle.dimensions.cg_from_apex_m))
        .unit(Dimension::Length, "m")
        .help("Center of gravity behind the virtual apex.", "NASA/TM-2014-218507, Appendix D")
        .report(),
    Output::new("vertical_cg_location_ratio", "Vertical C.G. Location (X/D)", Module::Mass, |a| design(a, |d| d.vehicle.dimensions.cg_over_diameter))
        .help("Center of gravity behind the virtual apex over the diameter.", "NASA/TM-2014-218507, Appendix D")
        .report(),
    Output::new("ixx_kg_m2", "Ixx", Module::Mass, |a| design(a, |d| d.vehicle.mass.ixx_kg_m2))
        .unit(Dimension::Inertia, "kg-m2")
        .help("Moment of inertia about the axis, through the center of gravity.", "NASA/TM-2014-218507, Appendix D")
        .report(),
    Output::new("iyy_kg_m2", "Iyy", Module::Mass, |a| design(a, |d| d.vehicle.mass.iyy_kg_m2))
        .unit(Dimension::Inertia, "kg-m2")
        .help("Moment of inertia about a transverse axis, through the center of gravity.", "NASA/TM-2014-218507, Appendix D")
        .report(),
    Output::new("izz_kg_m2", "Izz", Module::Mass, |a| design(a, |d| d.vehicle.mass.izz_kg_m2))
        .unit(Dimension::Inertia, "kg-m2")
        .help("Moment of inertia about a transverse axis, through the center of gravity.", "NASA/TM-2014-218507, Appendix D")
        .report(),
    Output::new("forebody_tps_mass_kg", "Forebody TPS Mass", Module::Mass, |a| design(a, |d| d.vehicle.component_mass_kg(ComponentKind::ForebodyTps)))
        .unit(Dimension::Mass, "kg")
        .help("Mass of the forebody heat shield, without margin.", "NASA/TM-2014-218507, Appendix D")
        .report(),
    Output::new("bond_mass_kg", "Forebody Bond Mass", Module::Mass, |a| design(a, |d| d.vehicle.component_mass_kg(ComponentKind::Bond)))
        .unit(Dimension::Mass, "kg")
        .help("Mass of the bond under the forebody heat shield, without margin.", "NASA/TM-2014-218507, Table B1"),
    Output::new("aftbody_tps_mass_kg", "Aftbody TPS Mass", Module::Mass, |a| design(a, |d| d.vehicle.component_mass_kg(ComponentKind::AftbodyTps)))
        .unit(Dimension::Mass, "kg")
        .help("Mass of the aftbody heat shield, without margin.", "NASA/TM-2014-218507, Appendix D")
        .report(),
    Output::new("forebody_carrier_structure_mass_kg", "Forebody Carrier Structure Mass", Module::Mass, |a| design(a, |d| d.vehicle.component_mass_kg(ComponentKind::ForebodyCarrier)))
        .unit(Dimension::Mass, "kg")
        .help("Mass of the carrier structure under the forebody heat shield, without margin.", "NASA/TM-2014-218507, Appendix D")
        .report(),
    Output::new("aftbody_carrier_structure_mass_kg", "Aftbody Carrier Structure Mass", Module::Mass, |a| design(a, |d| d.vehicle.component_mass_kg(ComponentKind::AftbodyCarrier)))
        .unit(Dimension::Mass, "kg")
        .help("Mass of the carrier structure under the aftbody heat shield, without margin.", "NASA/TM-2014-218507, Appendix D")
        .report(),
    Output::new("primary_structure_mass_kg", "Primary Structure Mass", Module::Mass, |a| design(a, |d| d.vehicle.component_mass_kg(ComponentKind::PrimaryStructure)))
        .unit(Dimension::Mass, "kg")
        .help("Mass of the cylinder wall from forebody carrier to attached structure, without margin.", "NASA/TM-2014-218507, Appendix D")
        .report(),
    Output::new("impact_foam_mass_kg", "Impact Foam Mass", Module::Mass, |a| design(a, |d| d.vehicle.component_mass_kg(ComponentKind::ImpactFoam)))
        .unit(Dimension::Mass, "kg")
        .help("Mass of the foam around or under the payload, without margin.", "NASA/TM-2014-218507, section 3.1.4"),
    Output::new("impact_shell_mass_kg", "Impact Shell Mass", Module::Mass, |a| design(a, |d| d.vehicle.component_mass_kg(ComponentKind::ImpactShell)))
        .unit(Dimension::Mass, "kg")
        .help("Mass of the shell of the impact sphere, without margin.", "NASA/TM-2014-218507, section 3.1.4"),
    Output::new("body_foam_mass_kg", "Body Foam Mass", Module::Mass, |a| design(a, |d| d.vehicle.component_mass_kg(ComponentKind::BodyFoam)))
        .unit(Dimension::Mass, "kg")
        .help("Mass of the foam around the impact sphere, without margin.", "NASA/TM-2014-218507, section 3.1.4"),
    Output::new("lid_insulation_mass_kg", "Lid Insulation Mass", Module::Mass, |a| design(a, |d| d.vehicle.component_mass_kg(ComponentKind::LidInsulation)))
        .unit(Dimension::Mass, "kg")
        .help("Mass of the filling of the lid, without margin.", "NASA/TM-2014-218507, Appendix D")
        .report(),
    Output::new("wing_insulation_mass_kg", "Wing Insulation Mass", Module::Mass, |a| design(a, |d| d.vehicle.component_mass_kg(ComponentKind::WingInsulation)))
        .unit(Dimension::Mass, "kg")
        .help("Mass of the filling of the wing, without margin.", "NASA/TM-2014-218507, Appendix D")
        .report(),
    Output::new("foam_density_kg_m3", "Foam Density", Module::Mass, |a| a.design.as_ref().and_then(|d| d.vehicle.component(ComponentKind::ImpactFoam).map(|c| c.density_kg_m3)))
        .unit(Dimension::Density, "kg/m^3")
        .help("Density in use; absent where the concept has no such part.", "NASA/TM-2014-218507, Table 1")
        .report(),
    Output::new("body_foam_density_kg_m3", "Body Foam Density", Module::Mass, |a| a.design.as_ref().and_then(|d| d.vehicle.component(ComponentKind::BodyFoam).map(|c| c.density_kg_m3)))
        .unit(Dimension::Density, "kg/m^3")
        .help("Density in use; absent where the concept has no such part.", "NASA/TM-2014-218507, Table 1")
        .report(),
    Output::new("impact_shell_density_kg_m3", "Impact Shell Density", Module::Mass, |a| a.design.as_ref().and_then(|d| d.vehicle.component(ComponentKind::ImpactShell).map(|c| c.density_kg_m3)))
        .unit(Dimension::Density, "kg/m^3")
        .help("Density in use; absent where the concept has no such part.", "NASA/TM-2014-218507, Table 1")
        .report(),
    Output::new("lid_density_kg_m3", "Lid Density", Module::Mass, |a| a.design.as_ref().and_then(|d| d.vehicle.component(ComponentKind::LidInsulation).map(|c| c.density_kg_m3)))
        .unit(Dimension::Density, "kg/m^3")
        .help("Density in use; absent where the concept has no such part.", "NASA/TM-2014-218507, Table 1")
        .report(),
    Output::new("wing_insulation_density_kg_m3", "Wing Insulation Density", Module::Mass, |a| a.design.as_ref().and_then(|d| d.vehicle.component(ComponentKind::WingInsulation).map(|c| c.density_kg_m3)))
        .unit(Dimension::Density, "kg/m^3")
        .help("Density in use; absent where the concept has no such part.", "NASA/TM-2014-218507, Table 1")
        .report(),
    Output::new("forebody_carrier_structure_density_kg_m3", "Forebody Carrier Structure Density", Module::Mass, |a| a.design.as_ref().and_then(|d| d.vehicle.component(ComponentKind::ForebodyCarrier).map(|c| c.density_kg_m3)))
        .unit(Dimension::Density, "kg/m^3")
        .help("Density in use; absent where the concept has no such part.", "NASA/TM-2014-218507, Table 1")
        .report(),
    Output::new("aftbody_carrier_structure_density_kg_m3", "Aftbody Carrier Structure Density", Module::Mass, |a| a.design.as_ref().and_then(|d| d.vehicle.component(ComponentKind::AftbodyCarrier).map(|c| c.density_kg_m3)))
        .unit(Dimension::Density, "kg/m^3")
        .help("Density in use; absent where the concept has no such part.", "NASA/TM-2014-218507, Table 1"),
    Output::new("primary_structure_density_kg_m3", "Primary Structure Density", Module::Mass, |a| a.design.as_ref().and_then(|d| d.vehicle.component(ComponentKind::PrimaryStructure).map(|c| c.density_kg_m3)))
        .unit(Dimension::Density, "kg/m^3")
        .help("Density in use; absent where the concept has no such part.", "NASA/TM-2014-218507, Table 1"),
    Output::new("payload_density_kg_m3", "Payload Density", Module::Mass, |a| a.design.as_ref().and_then(|d| d.vehicle.component(ComponentKind::Payload).map(|c| c.density_kg_m3)))
        .unit(Dimension::Density, "kg/m^3")
        .help("Density in use; absent where the concept has no such part.", "NASA/TM-2014-218507, Table 1")
        .report(),
    Output::new("forebody_tps_density_kg_m3", "Forebody TPS Density", Module::Mass, |a| design(a, |d| d.forebody_tps_density_kg_m3))
        .unit(Dimension::Density, "kg/m^3")
        .help("Density of the forebody heat shield.", "NASA/TM-2014-218507, Table 1")
        .report(),
    Output::new("aftbody_tps_density_kg_m3", "Aftbody TPS Density", Module::Mass, |a| design(a, |d| d.aftbody_tps_density_kg_m3))
        .unit(Dimension::Density, "kg/m^3")
        .help("Density of the aftbody heat shield.", "NASA/TM-2014-218507, Table 1")
        .report(),
    Output::new("estimated_impact_load_earth_g", "Estimated Impact Load", Module::Impact, |a| penetration(a, |p| p.load_earth_g))
        .unit(Dimension::Load, "g's")
        .help("Peak deceleration of a rigid vehicle that penetrates the chosen ground: equation 1 with the nose diameter twice the nose radius, or Young's equation; absent on rigid ground.", "NASA/TM-2014-218507, equation 1")
        .report(),
    Output::new("estimated_impact_load_min_earth_g", "Estimated Impact Load, Least", Module::Impact, |a| penetration(a, |p| p.least_earth_g))
        .unit(Dimension::Load, "g's")
        .help("The same at the soft end of the ground's range.", "NASA/TM-2014-218507, equation 1"),
    Output::new("estimated_impact_load_max_earth_g", "Estimated Impact Load, Largest", Module::Impact, |a| penetration(a, |p| p.largest_earth_g))
        .unit(Dimension::Load, "g's")
        .help("The same at the hard end of the ground's range.", "NASA/TM-2014-218507, equation 1"),
    Output::new("crush_load_limit_earth_g", "Crush Load Limit", Module::Impact, |a| design(a, |d| d.vehicle.impact.crush_load_limit_earth_g))
        .unit(Dimension::Load, "g's")
        .help("Design load of the payload on a rigid surface.", "NASA/TM-2014-218507, equation 4")
        .report(),
    Output::new("required_stroke_m", "Required Stroke", Module::Impact, |a| design(a, |d| d.vehicle.impact.required_stroke_m))
        .unit(Dimension::Length, "cm")
        .help("Stroke of the payload on a rigid surface; doubled for the triangular pulse of the MSR concept.", "NASA/TM-2014-218507, equation 4")
        .report(),
    Output::new("foam_thickness_m", "Foam Thickness", Module::Impact, |a| design(a, |d| d.vehicle.dimensions.foam_thickness_m))
        .unit(Dimension::Length, "cm")
        .help("Thickness of the impact foam: stroke over stroke efficiency, or more where the wing asks for it.", "NASA/TM-2014-218507, section 3.1.5")
        .report(),
    Output::new("foam_strength_pa", "Foam Crush Strength", Module::Impact, |a| design(a, |d| d.vehicle.impact.foam_strength_pa))
        .unit(Dimension::Pressure, "MPa")
        .help("Compressive strength asked for: by the crush law, or by equation 6 where the case says so.", "NASA/TM-2014-218507, section 3.1.5 and equation 6"),
    Output::new("impact_energy_j", "Impact Energy (J)", Module::Impact, |a| design(a, |d| d.vehicle.impact.impact_energy_j))
        .help("Kinetic energy of the vehicle at impact, in J.", "NASA/TM-2014-218507, section 3.1.5"),
    Output::new("impact_sphere_diameter_m", "Impact Sphere Diameter", Module::Impact, |a| design(a, |d| d.vehicle.dimensions.impact_sphere_diameter_m))
        .unit(Dimension::Length, "m")
        .help("Outer diameter of the impact sphere with its shell; zero without one.", "NASA/TM-2014-218507, section 3.1.4"),
    Output::new("forebody_carrier_structure_thickness_m", "Forebody Carrier Structure Thickness", Module::Structure, |a| design(a, |d| d.vehicle.structure.forebody.thickness_m))
        .unit(Dimension::Length, "cm")
        .help("Thickness of the wall; the largest of minimum gauge, strength and buckling.", "NASA/TM-2014-218507, section 3.1.6")
        .report(),
    Output::new("forebody_carrier_structure_strength_thickness_m", "Forebody Carrier Structure Thickness for Strength", Module::Structure, |a| design(a, |d| d.vehicle.structure.forebody.strength_thickness_m))
        .unit(Dimension::Length, "cm")
        .help("Thickness that strength alone asks for.", "NASA/TM-2014-218507, section 3.1.6"),
    Output::new("forebody_carrier_structure_buckling_thickness_m", "Forebody Carrier Structure Thickness for Buckling", Module::Structure, |a| design(a, |d| d.vehicle.structure.forebody.buckling_thickness_m.max(d.vehicle.structure.forebody.cap_buckling_thickness_m)))
        .unit(Dimension::Length, "cm")
        .help("Thickness that buckling alone asks for.", "NASA/TM-2014-218507, section 3.1.6"),
    Output::new("aftbody_carrier_structure_thickness_m", "Aftbody Carrier Structure Thickness", Module::Structure, |a| design(a, |d| d.vehicle.structure.aftbody.thickness_m))
        .unit(Dimension::Length, "cm")
        .help("Thickness of the wall; the largest of minimum gauge, strength and buckling.", "NASA/TM-2014-218507, section 3.1.6")
        .report(),
    Output::new("aftbody_carrier_structure_strength_thickness_m", "Aftbody Carrier Structure Thickness for Strength", Module::Structure, |a| design(a, |d| d.vehicle.structure.aftbody.strength_thickness_m))
        .unit(Dimension::Length, "cm")
        .help("Thickness that strength alone asks for.", "NASA/TM-2014-218507, section 3.1.6"),
    Output::new("aftbody_carrier_structure_buckling_thickness_m", "Aftbody Carrier Structure Thickness for Buckling", Module::Structure, |a| design(a, |d| d.vehicle.structure.aftbody.buckling_thickness_m.max(d.vehicle.structure.aftbody.cap_buckling_thickness_m)))
        .unit(Dimension::Length, "cm")
        .help("Thickness that buckling alone asks for.", "NASA/TM-2014-218507, section 3.1.6"),
    Output::new("primary_structure_thickness_m", "Primary Structure Thickness", Module::Structure, |a| design(a, |d| d.vehicle.structure.primary.thickness_m))
        .unit(Dimension::Length, "cm")
        .help("Thickness of the wall; the largest of minimum gauge, strength and buckling.", "NASA/TM-2014-218507, section 3.1.6")
        .report(),
    Output::new("primary_structure_strength_thickness_m", "Primary Structure Thickness for Strength", Module::Structure, |a| design(a, |d| d.vehicle.structure.primary.strength_thickness_m))
        .unit(Dimension::Length, "cm")
        .help("Thickness that strength alone asks for.", "NASA/TM-2014-218507, section 3.1.6"),
    Output::new("primary_structure_buckling_thickness_m", "Primary Structure Thickness for Buckling", Module::Structure, |a| design(a, |d| d.vehicle.structure.primary.buckling_thickness_m.max(d.vehicle.structure.primary.cap_buckling_thickness_m)))
        .unit(Dimension::Length, "cm")
        .help("Thickness that buckling alone asks for.", "NASA/TM-2014-218507, section 3.1.6"),
    Output::new("terminal_speed_m_s", "Terminal Velocity", Module::Flight, |a| design(a, |d| d.terminal_speed_m_s))
        .unit(Dimension::Speed, "m/s")
        .help("Speed at which drag carries the weight at the final altitude.", "NASA/TM-2014-218507, equation 2")
        .report(),
    Output::new("drag_coefficient_at_impact", "Drag Coefficient at Impact", Module::Aerodynamics, |a| design(a, |d| d.impact_drag_coefficient))
        .help("Drag coefficient at the speed of impact.", "NASA/TM-2014-218507, equation 2")
        .report(),
    Output::new("ballistic_coefficient_at_impact_kg_m2", "Ballistic Coefficient at Impact", Module::Aerodynamics, |a| design(a, |d| d.vehicle.ballistic_coefficient_kg_m2(d.impact_drag_coefficient)))
        .unit(Dimension::ArealDensity, "kg/m^2")
        .help("Mass over drag coefficient at impact and reference area.", "NASA/TM-2014-218507, equation 5")
        .report(),
    Output::new("aftbody_peak_heat_flux_w_m2", "Aftbody Max Heat Rate", Module::Heating, |a| design(a, |d| d.aftbody_heat_flux_w_m2))
        .unit(Dimension::HeatFlux, "W/cm^2")
        .help("Largest heat flux on the aftbody with margins: 5 % of the stagnation point.", "NASA/TM-2014-218507, section 3.5.2")
        .report(),
    Output::new("aftbody_heat_load_j_m2", "Aftbody Total Heat Load", Module::Heating, |a| design(a, |d| d.aftbody_heat_load_j_m2))
        .unit(Dimension::HeatLoad, "J/cm^2")
        .help("Heat load on the aftbody with margins: 5 % of the stagnation point.", "NASA/TM-2014-218507, Table 6")
        .report(),
    Output::new("aftbody_peak_pressure_pa", "Aftbody Max Pressure", Module::Heating, |a| design(a, |d| d.aftbody_pressure_pa))
        .unit(Dimension::Pressure, "Pa")
        .help("Largest pressure on the aftbody: 50 % of the stagnation point.", "NASA/TM-2014-218507, Table 6"),
    Output::new("shoulder_peak_heat_flux_w_m2", "Shoulder Max Heat Rate", Module::Heating, |a| design(a, |d| d.shoulder_heat_flux_w_m2))
        .unit(Dimension::HeatFlux, "W/cm^2")
        .help("Largest heat flux on the shoulder with margins; a substitute for the power law of Figure 42.", "NASA/TM-2014-218507, section 3.4.3"),
    Output::new("shoulder_heat_load_j_m2", "Shoulder Total Heat Load", Module::Heating, |a| design(a, |d| d.shoulder_heat_load_j_m2))
        .unit(Dimension::HeatLoad, "J/cm^2")
        .help("Heat load on the shoulder with margins, taken with the factor of the heat flux.", "NASA/TM-2014-218507, section 3.4.3"),
    Output::new("forebody_judged_heat_flux_w_m2", "Forebody TPS Judged Heat Rate", Module::Heating, |a| design(a, |d| d.forebody_judged.peak_heat_flux_w_m2))
        .unit(Dimension::HeatFlux, "W/cm^2")
        .help("Heat flux with margins that is held against the limits of the forebody's heat shield: that of the point chosen by the case, which a finding names.", "NASA/TM-2014-218507, sections 3.4.3 and 3.5"),
    Output::new("forebody_judged_heat_load_j_m2", "Forebody TPS Judged Heat Load", Module::Heating, |a| design(a, |d| d.forebody_judged.heat_load_j_m2))
        .unit(Dimension::HeatLoad, "J/cm^2")
        .help("Heat load with margins for which the forebody's heat shield is sized, at the same point.", "NASA/TM-2014-218507, sections 3.4.3 and 3.5"),
    Output::new("shoulder_to_stagnation_heat_flux_ratio", "Shoulder / Stagnation Heat Rate", Module::Heating, |a| design(a, |d| d.shoulder_heat_flux_ratio))
        .help("Shoulder heating over stagnation heating; a substitute for the power law of Figure 42.", "NASA/TM-2014-218507, section 3.4.3"),
    Output::new("forebody_tps_thickness_m", "Forebody TPS Thickness", Module::HeatShield, |a| design(a, |d| d.vehicle.layout.depths.forebody_tps_m))
        .unit(Dimension::Length, "cm")
        .help("Thickness of the heat shield as built.", "NASA/TM-2014-218507, Table 7")
        .report(),
    Output::new("forebody_tps_standard_deviation_m", "Forebody TPS Thickness, Standard Deviation", Module::HeatShield, |a| design(a, |d| d.forebody_tps.standard_deviation_m))
        .unit(Dimension::Length, "cm")
        .help("One standard deviation of the mass-estimating relation.", "NASA/TM-2014-218507, Table 7"),
    Output::new("forebody_tps_largest_thickness_m", "Forebody TPS Thickness, Largest Under-Prediction", Module::HeatShield, |a| design(a, |d| d.forebody_tps.largest_thickness_m))
        .unit(Dimension::Length, "cm")
        .help("Thickness where the relation under-predicts the most.", "NASA/TM-2014-218507, Table 7"),
    Output::new("forebody_tps_least_recession_m", "Forebody TPS Recession, Least", Module::HeatShield, |a| a.design.as_ref().and_then(|d| d.forebody_tps.least_recession_m))
        .unit(Dimension::Length, "cm")
        .help("Least recession among the trajectories to which the relation was fitted; part of its thickness.", "NASA/TM-2014-218507, Table 7"),
    Output::new("forebody_tps_largest_recession_m", "Forebody TPS Recession, Largest", Module::HeatShield, |a| a.design.as_ref().and_then(|d| d.forebody_tps.largest_recession_m))
        .unit(Dimension::Length, "cm")
        .help("Largest recession among them; a backshell has none.", "NASA/TM-2014-218507, Table 7"),
    Output::new("aftbody_tps_thickness_m", "Aftbody TPS Thickness", Module::HeatShield, |a| design(a, |d| d.vehicle.layout.depths.aftbody_tps_m))
        .unit(Dimension::Length, "cm")
        .help("Thickness of the heat shield as built.", "NASA/TM-2014-218507, Table 7")
        .report(),
    Output::new("aftbody_tps_standard_deviation_m", "Aftbody TPS Thickness, Standard Deviation", Module::HeatShield, |a| design(a, |d| d.aftbody_tps.standard_deviation_m))
        .unit(Dimension::Length, "cm")
        .help("One standard deviation of the mass-estimating relation.", "NASA/TM-2014-218507, Table 7"),
    Output::new("aftbody_tps_largest_thickness_m", "Aftbody TPS Thickness, Largest Under-Prediction", Module::HeatShield, |a| design(a, |d| d.aftbody_tps.largest_thickness_m))
        .unit(Dimension::Length, "cm")
        .help("Thickness where the relation under-predicts the most.", "NASA/TM-2014-218507, Table 7"),
    Output::new("heat_load_over_speed_squared", "Heat Load / Entry Velocity Squared (J/cm^2)/(km/s)^2", Module::HeatShield, |a| design(a, |d| d.forebody_tps.x))
        .help("Argument of the mass-estimating relations, at the point where the forebody's heat shield is judged.", "NASA/TM-2014-218507, equation 13"),
    Output::new("max_payload_temperature_k", "Max Payload Temperature", Module::ThermalSoak, |a| design(a, |d| d.payload_temperature_k))
        .unit(Dimension::Temperature, "C")
        .help("Peak temperature of the payload container hours after landing; the form of the correlation is deduced.", "NASA/TM-2014-218507, Tables 12 and 13")
        .report(),
];
