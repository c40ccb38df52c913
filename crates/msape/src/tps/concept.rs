//! A forebody concept: heat shield, bond and carrier structure together.
//!
//! ```text
//! sandwich as one layer:  t = 2 t_f + t_c,  ρ = (2 t_f ρ_f + t_c ρ_c + m_a)/t,  E = E_f 2 t_f/t,  σ = σ_f 2 t_f/t
//! ```
//!
//! with thickness t in m, density ρ in kg/m³, adhesive m_a in kg/m², in-plane modulus E and strength σ in Pa, of face f
//! and core c.
//!
//! # Valid
//! Mass and in-plane stiffness are exact; bending is stiffer than the smeared layer says (conservative).
//!
//! # References
//! - \[samareh-2014\] section 3.1.1 and Table B1.

use serde::{Deserialize, Serialize};

/// A forebody concept.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Concept {
    /// Name for people.
    pub name: String,
    /// Key of the reference.
    pub source: String,
    /// Place in it.
    pub place: String,
    /// What is assumed.
    pub note: String,
    /// File name of the material in `data/materials`.
    pub tps: String,
    /// File name of the soak correlation in `data/soak`.
    pub soak: String,
    /// Bond between heat shield and carrier.
    pub bond: Bond,
    /// Carrier structure as built.
    pub carrier: Construction,
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
    /// Where the numbers come from.
    pub provenance: String,
}

/// How a carrier is built.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "construction", rename_all = "kebab-case", deny_unknown_fields)]
pub enum Construction {
    /// One material throughout.
    Monolithic {
        /// Name for people.
        name: String,
        /// Least thickness, cm.
        minimum_thickness_cm: f64,
        /// Density, kg/m³.
        density_kg_m3: f64,
        /// Young's modulus, GPa.
        young_modulus_gpa: f64,
        /// Strength, MPa.
        strength_mpa: f64,
        /// Poisson's ratio.
        poisson_ratio: f64,
        /// Where the numbers come from.
        provenance: String,
    },
    /// Two faces on a core.
    Sandwich {
        /// Name for people.
        name: String,
        /// One of the two faces.
        face: Face,
        /// Core.
        core: Core,
        /// Adhesive of both faces, kg/m².
        adhesive_kg_m2: f64,
        /// Where the numbers come from.
        provenance: String,
    },
}

/// A face of a sandwich.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Face {
    /// Name for people.
    pub name: String,
    /// Thickness, cm.
    pub thickness_cm: f64,
    /// Density, kg/m³.
    pub density_kg_m3: f64,
    /// Young's modulus, GPa.
    pub young_modulus_gpa: f64,
    /// Strength, MPa.
    pub strength_mpa: f64,
    /// Poisson's ratio.
    pub poisson_ratio: f64,
}

/// The core of a sandwich.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Core {
    /// Name for people.
    pub name: String,
    /// Thickness, cm.
    pub thickness_cm: f64,
    /// Density, kg/m³.
    pub density_kg_m3: f64,
}

/// A carrier as one layer, for mass and structure.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Carrier {
    /// Name for people.
    pub name: String,
    /// Density, kg/m³.
    pub density_kg_m3: f64,
    /// Least thickness, m.
    pub minimum_thickness_m: f64,
    /// In-plane Young's modulus, Pa.
    pub young_modulus_pa: f64,
    /// In-plane strength, Pa.
    pub strength_pa: f64,
    /// Poisson's ratio.
    pub poisson_ratio: f64,
    /// Where the numbers come from.
    pub provenance: String,
}

impl Concept {
    /// Reads a concept from the text of its file.
    pub fn parse(text: &str) -> Result<Self, String> {
        toml::from_str(text).map_err(|error| error.to_string())
    }

    /// Thickness of the bond, m.
    pub fn bond_thickness_m(&self) -> f64 {
        self.bond.thickness_cm / 100.0
    }

    /// The carrier as one layer.
    pub fn carrier(&self) -> Carrier {
        match &self.carrier {
            Construction::Monolithic {
                name,
                minimum_thickness_cm,
                density_kg_m3,
                young_modulus_gpa,
                strength_mpa,
                poisson_ratio,
                provenance,
            } => Carrier {
                name: name.clone(),
                density_kg_m3: *density_kg_m3,
                minimum_thickness_m: minimum_thickness_cm / 100.0,
                young_modulus_pa: young_modulus_gpa * 1e9,
                strength_pa: strength_mpa * 1e6,
                poisson_ratio: *poisson_ratio,
                provenance: provenance.clone(),
            },
            Construction::Sandwich {
                name,
                face,
                core,
                adhesive_kg_m2,
                provenance,
            } => {
                let (faces, core_m) = (2.0 * face.thickness_cm / 100.0, core.thickness_cm / 100.0);
                let thickness = faces + core_m;
                let areal =
                    faces * face.density_kg_m3 + core_m * core.density_kg_m3 + adhesive_kg_m2;
                Carrier {
                    name: name.clone(),
                    density_kg_m3: areal / thickness,
                    minimum_thickness_m: thickness,
                    young_modulus_pa: face.young_modulus_gpa * 1e9 * faces / thickness,
                    strength_pa: face.strength_mpa * 1e6 * faces / thickness,
                    poisson_ratio: face.poisson_ratio,
                    provenance: provenance.clone(),
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn acc_6_under_carbon_phenolic_is_2_5_mm_thick() {
        let concept = Concept::parse(include_str!("../../data/concepts/cp-acc6.toml")).unwrap();
        assert_eq!(concept.tps, "carbon-phenolic");
        assert_eq!(concept.carrier().minimum_thickness_m, 0.0025);
        // 0.0381 cm × 1732 kg/m³ = 0.66 kg/m²
        assert!((concept.bond_thickness_m() * concept.bond.density_kg_m3 - 0.66).abs() < 1e-3);
    }

    #[test]
    fn sandwich_weighs_the_sum_of_its_parts() {
        // 2 × 0.508 mm × 2780 + 12.7 mm × 72 + 0.6 = 2.82448 + 0.9144 + 0.6 = 4.33888 kg/m² over 13.716 mm
        let concept =
            Concept::parse(include_str!("../../data/concepts/pica-al-5056.toml")).unwrap();
        let carrier = concept.carrier();
        assert!((carrier.minimum_thickness_m - 0.013_716).abs() < 1e-15);
        assert!((carrier.density_kg_m3 * carrier.minimum_thickness_m - 4.338_88).abs() < 1e-12);
        // 72.4 GPa × 1.016/13.716
        assert!((carrier.young_modulus_pa - 72.4e9 * 1.016 / 13.716).abs() < 1.0);
    }
}
