//! Material of each component, and source of its density.
//!
//! ```text
//! ρ_foam = ρ_grade(strength asked for) + ρ_panels
//! ```
//!
//! with densities in kg/m³, the panels in the MSR concept only. A density found from an assumed one counts as assumed.
//!
//! # Valid
//! Homogeneous components.
//!
//! # References
//! - \[samareh-2014\] Table 1; the sources of the densities are in the data files.

use crate::vehicle::kinds::ComponentKind;
use serde::{Deserialize, Serialize};

/// Basis of the density of a component.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum DensityBasis {
    /// A source in the list of references.
    Published,
    /// A choice of this project where nothing is published.
    Assumed,
    /// Given in the case.
    Given,
    /// Found by the design from numbers of which at least one is assumed.
    DerivedFromAssumed,
}

impl DensityBasis {
    /// The basis of a number whose source is this key of a data file.
    pub fn of_source(source: &str) -> Self {
        match source {
            "assumed" => Self::Assumed,
            _ => Self::Published,
        }
    }

    /// Whether the density depends on a choice of this project.
    pub fn is_assumed(self) -> bool {
        matches!(self, Self::Assumed | Self::DerivedFromAssumed)
    }

    /// Name as in files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Published => "published",
            Self::Assumed => "assumed",
            Self::Given => "given",
            Self::DerivedFromAssumed => "derived-from-assumed",
        }
    }
}

/// Material of a component.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Material {
    /// Name.
    pub name: String,
    /// Basis of the density.
    pub density_basis: DensityBasis,
}

impl Material {
    /// A material by its name.
    pub fn new(name: impl Into<String>, density_basis: DensityBasis) -> Self {
        Self {
            name: name.into(),
            density_basis,
        }
    }

    /// This material with the density marked as given, if the case gives one.
    pub fn with_given(self, density_kg_m3: Option<f64>) -> Self {
        match density_kg_m3 {
            Some(_) => Self {
                density_basis: DensityBasis::Given,
                ..self
            },
            None => self,
        }
    }
}

/// The materials of all components; the aftbody's heat shield has no bond of its own.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Materials {
    /// Heat shield of the forebody.
    pub forebody_tps: Material,
    /// Bond under it.
    pub bond: Material,
    /// Carrier structure of the forebody.
    pub forebody_carrier: Material,
    /// Heat shield of the aftbody.
    pub aftbody_tps: Material,
    /// Carrier structure of the aftbody.
    pub aftbody_carrier: Material,
    /// Primary structure.
    pub primary_structure: Material,
    /// Filling of the wing.
    pub wing_insulation: Material,
    /// Impact foam; without a name that of the grade which has the requested strength.
    pub impact_foam: Option<Material>,
    /// Impact shell.
    pub impact_shell: Material,
    /// Body foam.
    pub body_foam: Material,
    /// Filling of the lid.
    pub lid_insulation: Material,
    /// Payload.
    pub payload: Material,
}

impl Materials {
    /// The material of a component; the impact foam's is `found_foam` unless it is named.
    pub fn of<'a>(&'a self, kind: ComponentKind, found_foam: &'a Material) -> &'a Material {
        match kind {
            ComponentKind::ForebodyTps => &self.forebody_tps,
            ComponentKind::Bond => &self.bond,
            ComponentKind::ForebodyCarrier => &self.forebody_carrier,
            ComponentKind::AftbodyTps => &self.aftbody_tps,
            ComponentKind::AftbodyCarrier => &self.aftbody_carrier,
            ComponentKind::PrimaryStructure => &self.primary_structure,
            ComponentKind::WingInsulation => &self.wing_insulation,
            ComponentKind::ImpactFoam => self.impact_foam.as_ref().unwrap_or(found_foam),
            ComponentKind::ImpactShell => &self.impact_shell,
            ComponentKind::BodyFoam => &self.body_foam,
            ComponentKind::LidInsulation => &self.lid_insulation,
            ComponentKind::Payload => &self.payload,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_given_density_is_no_longer_assumed() {
        let foam = Material::new("Rohacell 51", DensityBasis::of_source("assumed"));
        assert!(foam.density_basis.is_assumed());
        let given = foam.with_given(Some(60.0));
        assert_eq!(given.density_basis, DensityBasis::Given);
        assert!(!given.density_basis.is_assumed());
    }
}
