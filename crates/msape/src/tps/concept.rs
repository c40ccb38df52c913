//! A forebody concept: heat shield, bond and carrier structure together.
//!
//! ```text
//! heat shield | bond | carrier structure
//! ```
//!
//! with thicknesses in m and densities in kg/m³; the heat shield is sized by its mass-estimating relation, the carrier by
//! the structural rules.
//!
//! # Valid
//! Same as for heat shield and carrier.
//!
//! # References
//! - \[samareh-2014\] section 3.1.1 and Table B1.

use crate::data::Data;
use serde::{Deserialize, Serialize};

/// A forebody concept.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Concept {
    /// Name for people.
    pub name: String,
    /// Key of the reference.
    pub source: String,
    /// Place in the source.
    pub place: String,
    /// Assumptions.
    pub note: String,
    /// File name of the material in `data/materials`.
    pub tps: String,
    /// File name of the soak correlation in `data/soak`.
    pub soak: String,
    /// Bond between heat shield and carrier.
    pub bond: Bond,
    /// Name of the carrier structure among the carriers of the vehicle's data file.
    pub carrier: String,
}

/// A bond.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Bond {
    /// Name for people.
    pub name: String,
    /// Thickness, cm.
    pub thickness_cm: f64,
    /// Density, kg/m³.
    pub density_kg_m3: f64,
    /// Source of the numbers.
    pub provenance: String,
}

impl Concept {
    /// Reads a concept from the text of its file.
    pub fn parse(data: Data) -> Result<Self, String> {
        data.read()
    }

    /// Thickness of the bond, m.
    pub fn bond_thickness_m(&self) -> f64 {
        self.bond.thickness_cm / 100.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn carbon_phenolic_is_bonded_to_acc_6_with_0_66_kg_per_m2() {
        let concept =
            Concept::parse(include_str!("../../data/concepts/cp-acc6.toml").into()).unwrap();
        assert_eq!(concept.tps, "carbon-phenolic");
        assert_eq!(concept.carrier, "acc-6");
        // 0.0381 cm × 1732 kg/m³ = 0.66 kg/m²
        assert!((concept.bond_thickness_m() * concept.bond.density_kg_m3 - 0.66).abs() < 1e-3);
    }
}
