//! The parametric vehicle: geometry, mass, impact and structure of an entry vehicle, closed by the rules of section 3.1 of the report.
//!
//! ```text
//! build: foam from stroke → close at the diameter asked for → else the smallest diameter that closes → dimensions, findings
//! ```
//!
//! Lengths in m, masses in kg, x along the axis from the virtual apex, aft positive; every change of an input is an
//! [`Adjustment`]. A vehicle that closes at no diameter is an outcome, [`NotClosed`], not a fault.
//!
//! # Valid
//! Diameters 0.5-2 m, payloads 5-30 kg, nose ratios 0.25-0.9, shoulder ratios 0.02-0.1: outside, an answer is given as well.
//!
//! # References
//! - \[samareh-2014\] section 3.1.

pub mod after_landing;
pub mod body;
pub mod close;
pub mod crossing;
pub mod draft;
pub mod forebody;
pub mod grow;
pub mod impact;
pub mod input;
mod kinds;
pub mod layout;
pub mod mass;
pub mod mass_tree;
pub mod material;
pub mod msr;
pub mod non_msr;
pub mod outline;
pub mod profile;
pub mod remarks;
pub mod rules;
pub mod segment;
pub mod structure;
pub mod winding;
pub mod wing;

pub use grow::NotClosed;
pub use input::{ImpactInput, LayerStack, Loads, PayloadSize, VehicleInput};
pub use kinds::{
    ComponentDensities, ComponentKind, Concept, CrushingMass, EARTH_G_M_S2, Foam, FoamGrade,
    FoamStrength, WallPlace,
};
pub use mass::{Component, MassProperties};
pub use material::{DensityBasis, Material, Materials};
pub use rules::{Rules, VehicleData};

use crate::finding::{Adjustment, Finding};
use crate::vehicle::close::Closed;
use crate::vehicle::grow::smallest_that_closes;
use crate::vehicle::impact::Impact;
use crate::vehicle::impact::foam_rule::FoamRule;
use crate::vehicle::impact::striker::Striker;
use crate::vehicle::layout::Layout;
use crate::vehicle::profile::Profile;
use crate::vehicle::structure::Structure;
use numerics::math::PI;
use serde::{Deserialize, Serialize};

/// A vehicle that closes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Vehicle {
    /// Concept.
    pub concept: Concept,
    /// Outer mould line, closed.
    pub outline: Profile,
    /// Where everything stands.
    pub layout: Layout,
    /// Components with profiles and masses.
    pub components: Vec<Component>,
    /// Mass, centre of gravity, inertia.
    pub mass: MassProperties,
    /// The same after landing, the payload moved forward by the required stroke.
    pub crushed: MassProperties,
    /// Key dimensions.
    pub dimensions: Dimensions,
    /// Landing.
    pub impact: Impact,
    /// Walls.
    pub structure: Structure,
    /// Changes made to the inputs.
    pub adjustments: Vec<Adjustment>,
    /// Remarks.
    pub findings: Vec<Finding>,
    /// Turns of the closing loop at the final diameter.
    pub iterations: u32,
}

/// Dimensions that the report lists among its outputs, and those that a drawing needs.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Dimensions {
    /// Diameter, m.
    pub diameter_m: f64,
    /// Area that coefficients refer to, m².
    pub reference_area_m2: f64,
    /// Nose radius, m.
    pub nose_radius_m: f64,
    /// Shoulder radius, m.
    pub shoulder_radius_m: f64,
    /// Shoulder radius asked for at this diameter, m.
    pub input_shoulder_radius_m: f64,
    /// Distance of the virtual apex ahead of the nose tip, m.
    pub virtual_apex_ahead_m: f64,
    /// Nose tip to top of the lid, m.
    pub vehicle_height_m: f64,
    /// Lid radius, m.
    pub lid_radius_m: f64,
    /// Top of the lid above the attached structure, m.
    pub lid_height_m: f64,
    /// Nose tip to attached structure, m.
    pub attached_structure_depth_m: f64,
    /// Slope of the wing's aft side, rad.
    pub wing_slope_rad: f64,
    /// Payload diameter, m.
    pub payload_diameter_m: f64,
    /// Payload density, kg/m³.
    pub payload_density_kg_m3: f64,
    /// Nose tip to payload centre, m.
    pub payload_height_m: f64,
    /// Impact foam, m.
    pub foam_thickness_m: f64,
    /// Diameter of the impact sphere with its shell, m; zero in the non-MSR concept.
    pub impact_sphere_diameter_m: f64,
    /// Body foam above the impact sphere, m.
    pub body_foam_thickness_m: f64,
    /// Lid insulation on the axis, m.
    pub lid_insulation_thickness_m: f64,
    /// Inner radius of the primary structure, m.
    pub primary_structure_radius_m: f64,
    /// Centre of gravity behind the nose tip, m.
    pub cg_from_nose_m: f64,
    /// Centre of gravity behind the virtual apex, m.
    pub cg_from_apex_m: f64,
    /// The same over the diameter.
    pub cg_over_diameter: f64,
    /// Area of nose, cone and shoulder up to the largest diameter, m².
    pub forebody_area_m2: f64,
    /// Area of the whole outer mould line, m².
    pub wetted_area_m2: f64,
}

/// The vehicle for these inputs.
pub fn build(input: &VehicleInput) -> Result<Vehicle, NotClosed> {
    if let Some(reason) = input.fault() {
        return Err(NotClosed {
            reason,
            at_input: None,
            at_largest: None,
        });
    }
    let v = input.loads.terminal_speed_m_s;
    let rule = FoamRule::new(input);
    let (diameter_m, closed) = smallest_that_closes(input, &rule)?;
    let mass_kg = closed.mass.mass_kg;
    let striker = Striker::new(&closed.layout.outline.forebody, mass_kg, v);
    let foam = rule.at(closed.layout.foam_thickness_m);
    let impact = Impact {
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
        impact_energy_j: 0.5 * mass_kg * v * v,
    };
    let dimensions = dimensions(input, diameter_m, &closed);
    let adjustments = remarks::adjustments(input, diameter_m, &rule, &closed.layout);
    let findings = remarks::findings(input, &impact, &closed);
    let Closed {
        layout,
        components,
        mass,
        structure,
        iterations,
    } = closed;
    let crushed = after_landing::crushed(input.concept, &layout, &components, rule.stroke_m);
    Ok(Vehicle {
        crushed,
        concept: input.concept,
        outline: layout.outline.profile(),
        layout,
        components,
        mass,
        dimensions,
        impact,
        structure,
        adjustments,
        findings,
        iterations,
    })
}

fn dimensions(input: &VehicleInput, diameter_m: f64, closed: &Closed) -> Dimensions {
    let layout = &closed.layout;
    let outline = &layout.outline;
    let forebody = &outline.forebody;
    let tip_x_m = forebody.nose_tip_x_m();
    let payload_diameter_m = input.payload_diameter_m();
    let cg = closed.mass.cg_x_m;
    Dimensions {
        diameter_m,
        reference_area_m2: PI * diameter_m * diameter_m / 4.0,
        nose_radius_m: forebody.nose_radius_m,
        shoulder_radius_m: forebody.shoulder_radius_m,
        input_shoulder_radius_m: input.shoulder_radius_ratio * diameter_m / 2.0,
        virtual_apex_ahead_m: tip_x_m,
        vehicle_height_m: outline.lid_top_x_m() - tip_x_m,
        lid_radius_m: outline.lid_radius_m,
        lid_height_m: outline.lid_top_x_m() - outline.attached_structure_x_m,
        attached_structure_depth_m: outline.attached_structure_x_m - tip_x_m,
        wing_slope_rad: outline.wing_slope_rad,
        payload_diameter_m,
        payload_density_kg_m3: input.payload_mass_kg
            / (PI / 6.0 * payload_diameter_m * payload_diameter_m * payload_diameter_m),
        payload_height_m: layout.payload_x_m - tip_x_m,
        foam_thickness_m: layout.foam_thickness_m,
        impact_sphere_diameter_m: match input.concept {
            Concept::Msr => 2.0 * layout.impact_sphere_radius_m(),
            Concept::NonMsr => 0.0,
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

impl Vehicle {
    /// The component of a kind, when the concept has it.
    pub fn component(&self, kind: ComponentKind) -> Option<&Component> {
        self.components.iter().find(|c| c.kind == kind)
    }

    /// Mass of a component without margin, kg; zero when the concept does not have it.
    pub fn component_mass_kg(&self, kind: ComponentKind) -> f64 {
        self.component(kind).map_or(0.0, |c| c.mass_kg)
    }

    /// Force of the impact foam by equation 6: its strength over the payload's cross-section, N.
    pub fn foam_force_n(&self) -> f64 {
        let d = self.dimensions.payload_diameter_m;
        self.impact.equation_6_strength_pa * PI * d * d / 4.0
    }

    /// Ballistic coefficient for a drag coefficient, kg/m².
    pub fn ballistic_coefficient_kg_m2(&self, drag_coefficient: f64) -> f64 {
        self.mass.mass_kg / (drag_coefficient * self.dimensions.reference_area_m2)
    }

    /// Weight on Earth, N.
    pub fn earth_weight_n(&self) -> f64 {
        self.mass.mass_kg * EARTH_G_M_S2
    }
}

#[cfg(test)]
mod tests;
