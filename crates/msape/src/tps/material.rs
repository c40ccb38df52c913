//! A heat-shield material as its file describes it: relation, accuracy, limits, density and emissivity.

use super::Side;
use super::mer::Mer;
use crate::data::Data;
use crate::finding::range::Range;
use serde::{Deserialize, Serialize};

/// A material, in the units of its source.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TpsMaterial {
    /// Name for people.
    pub name: String,
    /// Key of the reference.
    pub source: String,
    /// Place in the source.
    pub place: String,
    /// Doubts about the numbers.
    pub note: String,
    /// Sides for which the relation was made.
    pub sides: Vec<Side>,
    /// Mass-estimating relation.
    pub mer: Mer,
    /// Accuracy of the relation.
    pub fit: Fit,
    /// Limits of the material.
    pub limits: Limits,
    /// The relation against an in-depth model.
    #[serde(default)]
    pub in_depth: Vec<InDepth>,
    /// Density.
    pub density: Density,
    /// Emissivity.
    pub emissivity: Emissivity,
}

/// Accuracy of a relation against the ablation code to which it was fitted.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Fit {
    /// Standard deviation, percent.
    pub standard_deviation_percent: f64,
    /// Largest under-prediction, percent of the ablation code's thickness.
    pub largest_underprediction_percent: f64,
    /// Least thickness among the fitted data, cm.
    pub minimum_thickness_cm: f64,
    /// Recession among the fitted data, cm.
    pub recession_cm: Option<Range>,
}

/// Limits of a material, from tests and flights.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Limits {
    /// Heat flux, W/cm².
    pub heat_flux_w_cm2: f64,
    /// Heat flux in a short pulse, W/cm².
    pub short_heat_flux_w_cm2: f64,
    /// Duration of a short pulse, s.
    pub short_duration_s: Option<f64>,
    /// Pressure, atm.
    pub pressure_atm: f64,
    /// Least thickness made, cm.
    pub minimum_thickness_cm: f64,
    /// Greatest thickness made, cm.
    pub maximum_thickness_cm: Option<f64>,
}

/// Thickness of the relation against that of an in-depth model, over a range of entry angles.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct InDepth {
    /// Entry angle below the horizon, deg.
    pub flight_path_angle_deg: Range,
    /// Difference, percent of the in-depth model's thickness; negative is too thin.
    pub difference_percent: Range,
    /// Method by which the difference was determined.
    pub provenance: String,
}

/// A density and its source.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Density {
    /// Density, kg/m³.
    pub density_kg_m3: f64,
    /// Densities of other lots and sources, kg/m³; open where none was found.
    #[serde(default)]
    pub range_kg_m3: Range,
    /// Key of the reference; `assumed` for a choice of this project.
    pub source: String,
    /// Place, spread, doubt.
    pub provenance: String,
}

/// An emissivity and its source.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Emissivity {
    /// Emissivity.
    pub emissivity: f64,
    /// Key of the reference; `assumed` for a choice of this project.
    pub source: String,
    /// Place, spread, doubt.
    pub provenance: String,
}

impl TpsMaterial {
    /// Reads a material from the text of its file.
    pub fn parse(data: Data) -> Result<Self, String> {
        let material: Self = data.read()?;
        let positive = [
            ("density.density_kg_m3", material.density.density_kg_m3),
            (
                "limits.minimum_thickness_cm",
                material.limits.minimum_thickness_cm,
            ),
            ("limits.heat_flux_w_cm2", material.limits.heat_flux_w_cm2),
            ("emissivity.emissivity", material.emissivity.emissivity),
        ];
        match positive
            .iter()
            .find(|(_, value)| !(value.is_finite() && *value > 0.0))
        {
            Some((key, value)) => Err(format!("{key}: got {value}, must be above 0")),
            None => Ok(material),
        }
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

    /// The built-in material files.
    pub(crate) const FILES: [&str; 6] = [
        include_str!("../../data/materials/pica.toml"),
        include_str!("../../data/materials/carbon-phenolic.toml"),
        include_str!("../../data/materials/sirca.toml"),
        include_str!("../../data/materials/acusil-ii.toml"),
        include_str!("../../data/materials/li-900.toml"),
        include_str!("../../data/materials/sla-561v.toml"),
    ];

    #[test]
    fn all_six_files_read_and_write_back_the_same() {
        for text in FILES {
            let material = TpsMaterial::parse(text.into()).unwrap();
            let again =
                TpsMaterial::parse(toml::to_string(&material).unwrap().as_str().into()).unwrap();
            assert_eq!(material, again);
        }
    }

    #[test]
    fn unknown_key_and_negative_density_are_refused_by_name() {
        let misspelt = FILES[0].replace("pressure_atm", "presure_atm");
        assert!(
            TpsMaterial::parse(misspelt.as_str().into())
                .unwrap_err()
                .contains("presure_atm")
        );
        let negative = FILES[0].replace("density_kg_m3 = 266.0", "density_kg_m3 = -266.0");
        assert!(
            TpsMaterial::parse(negative.as_str().into())
                .unwrap_err()
                .contains("density.density_kg_m3: got -266")
        );
    }
}
