//! The parametric vehicle: geometry, mass, impact and structure of an entry vehicle, closed by the rules of section 3.1 of the report.
//!
//! ```text
//! build: foam from stroke → close at the requested diameter → else the smallest diameter that closes → dimensions, findings
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
pub mod derivatives;
pub mod draft;
pub mod figures;
pub mod forebody;
pub mod grow;
pub mod impact;
pub mod input;
mod kinds;
pub mod layout;
pub mod lid;
pub mod lift;
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
pub mod shapes;
pub mod structure;
pub mod winding;
pub mod wing;

pub use figures::{Dimensions, Figures};
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
    /// Outer mold line, closed.
    pub outline: Profile,
    /// Layout of all components.
    pub layout: Layout,
    /// Components with profiles and masses.
    pub components: Vec<Component>,
    /// Mass, center of gravity, inertia.
    pub mass: MassProperties,
    /// Mass, center of gravity and inertia after landing, the payload moved forward by the required stroke.
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
    /// Iterations of the closing loop at the final diameter.
    pub iterations: u32,
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
    let rule = FoamRule::new(input);
    let (diameter_m, closed) = smallest_that_closes(input, &rule)?;
    let Closed {
        layout,
        components,
        structure,
        iterations,
    } = closed;
    let parts = components.iter().map(Component::part);
    let figures = Figures::new(input, &rule, diameter_m, (layout, structure), parts);
    Ok(Vehicle {
        concept: input.concept,
        outline: layout.outline.profile(),
        adjustments: remarks::adjustments(input, diameter_m, &rule, &layout),
        findings: remarks::findings(input, &figures),
        layout,
        components,
        mass: figures.mass,
        crushed: figures.crushed,
        dimensions: figures.dimensions,
        impact: figures.impact,
        structure,
        iterations,
    })
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
