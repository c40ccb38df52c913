//! A vehicle that closes, as numbers without names: of plain numbers, or of numbers with derivatives.

use crate::vehicle::after_landing;
use crate::vehicle::impact::Impact;
use crate::vehicle::impact::foam_rule::FoamRule;
use crate::vehicle::impact::striker::Striker;
use crate::vehicle::input::VehicleInput;
use crate::vehicle::kinds::{ComponentKind, Concept};
use crate::vehicle::layout::Layout;
use crate::vehicle::mass::{MassProperties, Part, total};
use crate::vehicle::structure::Structure;
use numerics::math::PI;
use numerics::scalar::Single;
use serde::{Deserialize, Serialize};

/// The numbers of a vehicle that closes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Figures<S = f64> {
    /// Layout of all components.
    pub layout: Layout<S>,
    /// Walls.
    pub structure: Structure<S>,
    /// Mass, center of gravity, inertia.
    pub mass: MassProperties<S>,
    /// Mass, center of gravity and inertia after landing, the payload moved forward by the required stroke.
    pub crushed: MassProperties<S>,
    /// Key dimensions.
    pub dimensions: Dimensions<S>,
    /// Landing.
    pub impact: Impact<S>,
}

/// Dimensions that the report lists among its outputs, and those that a drawing needs.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Dimensions<S = f64> {
    /// Diameter, m.
    pub diameter_m: S,
    /// Area that coefficients refer to, m².
    pub reference_area_m2: S,
    /// Nose radius, m.
    pub nose_radius_m: S,
    /// Shoulder radius, m.
    pub shoulder_radius_m: S,
    /// Requested shoulder radius at this diameter, m.
    pub input_shoulder_radius_m: S,
    /// Distance of the virtual apex ahead of the nose tip, m.
    pub virtual_apex_ahead_m: S,
    /// Nose tip to top of the lid, m.
    pub vehicle_height_m: S,
    /// Lid radius, m.
    pub lid_radius_m: S,
    /// Top of the lid above the attached structure, m.
    pub lid_height_m: S,
    /// Nose tip to attached structure, m.
    pub attached_structure_depth_m: S,
    /// Slope of the wing's aft side, rad.
    pub wing_slope_rad: S,
    /// Payload diameter, m.
    pub payload_diameter_m: S,
    /// Payload density, kg/m³.
    pub payload_density_kg_m3: S,
    /// Nose tip to payload center, m.
    pub payload_height_m: S,
    /// Impact foam, m.
    pub foam_thickness_m: S,
    /// Diameter of the impact sphere with its shell, m; zero in the non-MSR concept.
    pub impact_sphere_diameter_m: S,
    /// Body foam above the impact sphere, m.
    pub body_foam_thickness_m: S,
    /// Lid insulation on the axis, m.
    pub lid_insulation_thickness_m: S,
    /// Inner radius of the primary structure, m.
    pub primary_structure_radius_m: S,
    /// Center of gravity behind the nose tip, m.
    pub cg_from_nose_m: S,
    /// Center of gravity behind the virtual apex, m.
    pub cg_from_apex_m: S,
    /// Center of gravity behind the virtual apex over the diameter.
    pub cg_over_diameter: S,
    /// Area of nose, cone and shoulder up to the largest diameter, m².
    pub forebody_area_m2: S,
    /// Area of the whole outer mold line, m².
    pub wetted_area_m2: S,
}

impl<S: Single> Figures<S> {
    /// Numbers of a vehicle whose diameter, layout, walls and parts are found.
    pub fn new(
        input: &VehicleInput<S>,
        rule: &FoamRule<S>,
        diameter_m: S,
        (layout, structure): (Layout<S>, Structure<S>),
        parts: impl Iterator<Item = (ComponentKind, Part<S>)> + Clone,
    ) -> Self {
        let mass = total(parts.clone());
        Self {
            layout,
            structure,
            mass,
            crushed: after_landing::crushed(input.concept, &layout, parts, rule.stroke_m),
            dimensions: dimensions(input, diameter_m, &layout, &mass),
            impact: impact(input, rule, &layout, mass.mass_kg),
        }
    }
}

fn impact<S: Single>(
    input: &VehicleInput<S>,
    rule: &FoamRule<S>,
    layout: &Layout<S>,
    mass_kg: S,
) -> Impact<S> {
    let v = input.loads.terminal_speed_m_s;
    let striker = Striker::new(&layout.outline.forebody, mass_kg, v);
    let foam = rule.at(layout.foam_thickness_m);
    Impact {
        ground_penetration: input.impact.ground.rigid_body_load(&striker),
        penetration_alpha: input.impact.ground.penetration.map(|p| p.alpha),
        crush_load_limit_earth_g: input.impact.crush_load_limit_earth_g,
        nose_diameter_m: striker.nose_diameter_m,
        required_stroke_m: rule.stroke_m,
        required_foam_thickness_m: rule.required_thickness_m,
        stroke_efficiency: rule.stroke_efficiency,
        foam_strength_by: input.impact.foam_strength,
        foam_strength_pa: foam.strength_pa,
        equation_6_strength_pa: rule.equation_6_pa,
        foam_density_kg_m3: foam.density_kg_m3,
        impact_energy_j: mass_kg * 0.5 * v * v,
    }
}

fn dimensions<S: Single>(
    input: &VehicleInput<S>,
    diameter_m: S,
    layout: &Layout<S>,
    mass: &MassProperties<S>,
) -> Dimensions<S> {
    let outline = &layout.outline;
    let forebody = &outline.forebody;
    let tip_x_m = forebody.nose_tip_x_m();
    let cg = mass.cg_x_m;
    Dimensions {
        diameter_m,
        reference_area_m2: diameter_m * PI * diameter_m / 4.0,
        nose_radius_m: forebody.nose_radius_m,
        shoulder_radius_m: forebody.shoulder_radius_m,
        input_shoulder_radius_m: input.shoulder_radius_ratio * diameter_m / 2.0,
        virtual_apex_ahead_m: tip_x_m,
        vehicle_height_m: outline.lid_top_x_m() - tip_x_m,
        lid_radius_m: outline.lid_radius_m,
        lid_height_m: outline.lid_top_x_m() - outline.attached_structure_x_m,
        attached_structure_depth_m: outline.attached_structure_x_m - tip_x_m,
        wing_slope_rad: outline.wing_slope_rad,
        payload_diameter_m: input.payload_diameter_m(),
        payload_density_kg_m3: input.payload_density_kg_m3(),
        payload_height_m: layout.payload_x_m - tip_x_m,
        foam_thickness_m: layout.foam_thickness_m,
        impact_sphere_diameter_m: match input.concept {
            Concept::Msr => layout.impact_sphere_radius_m() * 2.0,
            Concept::NonMsr => S::constant(0.0),
        },
        body_foam_thickness_m: layout.body_foam_thickness_m,
        lid_insulation_thickness_m: layout.lid_insulation_thickness_m,
        primary_structure_radius_m: layout.primary_inner_r_m(),
        cg_from_nose_m: cg - tip_x_m,
        cg_from_apex_m: cg,
        cg_over_diameter: cg / diameter_m,
        forebody_area_m2: forebody.profile().wetted_area_m2(),
        wetted_area_m2: outline.profile().wetted_area_m2(),
    }
}
