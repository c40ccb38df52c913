//! Constants of a family of vehicles, read from a file of `data/vehicles`: each with its source, assumed ones marked.

use crate::data::Data;
use crate::vehicle::kinds::{ComponentDensities, FoamGrade, WallPlace};
use crate::vehicle::material::{DensityBasis, Material};
use crate::vehicle::structure::{Carrier, Construction, LaunchLoad, StructureLoads};
use numerics::math::RADIANS_PER_DEGREE;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Constants of the geometry.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Rules {
    /// Width of the annulus around the lid, m.
    pub annulus_width_m: f64,
    /// Distance between payload and lid structure in the non-MSR concept, m.
    pub payload_lid_gap_m: f64,
    /// Least slope of the wing's aft side, rad.
    pub wing_slope_min_rad: f64,
    /// Largest slope of the wing's aft side, rad.
    pub wing_slope_max_rad: f64,
    /// Largest diameter to which a vehicle is grown, m.
    pub diameter_max_m: f64,
    /// Width of the last interval in the search for the smallest diameter, m.
    pub diameter_resolution_m: f64,
    /// Largest move of center of gravity, attached structure and walls at convergence, m.
    pub convergence_m: f64,
    /// Thickness of the impact shell, m.
    pub impact_shell_thickness_m: f64,
    /// Body foam above the impact sphere where there is room, m.
    pub body_foam_gap_m: f64,
    /// Lid insulation above the body foam where there is room, m.
    pub lid_insulation_gap_m: f64,
    /// Least body foam and lid insulation together, m.
    pub lid_gap_min_m: f64,
    /// Least distance between payload and primary structure, m.
    pub payload_wall_gap_min_m: f64,
    /// Least impact foam, m.
    pub foam_thickness_min_m: f64,
}

/// A number and its source; the source `assumed` is a choice of this project.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Datum {
    /// The number, in the unit of its key.
    pub value: f64,
    /// Key in the list of references, or `assumed`.
    pub source: String,
    /// Place in the source, or the reason for the choice.
    pub place: String,
    /// Name of the material with this density, if it is a single one.
    pub material: Option<String>,
}

/// Least thickness of a material in each place, m.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MinimumGauges {
    /// Under the forebody's heat shield, m.
    #[serde(rename = "forebody")]
    pub forebody_m: f64,
    /// Under the aftbody's heat shield, m.
    #[serde(rename = "aftbody")]
    pub aftbody_m: f64,
    /// Primary structure, m.
    #[serde(rename = "primary")]
    pub primary_m: f64,
}

/// A material for carriers and primary structure.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CarrierMaterial {
    /// Name.
    pub name: String,
    /// Key in the list of references.
    pub source: String,
    /// Place in the source.
    pub place: String,
    /// Assumptions.
    pub note: String,
    /// Key in the list of references for the densities, or `assumed`.
    pub density_source: String,
    /// Build and densities.
    pub construction: Construction,
    /// Young's modulus, Pa.
    pub elastic_modulus_pa: f64,
    /// Poisson's ratio.
    pub poisson_ratio: f64,
    /// Allowable stress, Pa.
    pub strength_pa: f64,
    /// Least thickness by place, m.
    pub minimum_gauge_m: MinimumGauges,
}

impl CarrierMaterial {
    /// Name of the material and source of its density.
    pub fn material(&self) -> Material {
        let basis = DensityBasis::of_source(&self.density_source);
        Material::new(self.name.clone(), basis)
    }

    /// The material with the least thickness of a place.
    pub fn carrier(&self, place: WallPlace) -> Carrier {
        let minimum_gauge_m = match place {
            WallPlace::Forebody => self.minimum_gauge_m.forebody_m,
            WallPlace::Aftbody => self.minimum_gauge_m.aftbody_m,
            WallPlace::Primary => self.minimum_gauge_m.primary_m,
        };
        Carrier {
            construction: self.construction,
            elastic_modulus_pa: self.elastic_modulus_pa,
            poisson_ratio: self.poisson_ratio,
            strength_pa: self.strength_pa,
            minimum_gauge_m,
        }
    }
}

/// A corner of the load factors at launch.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LaunchCorner {
    /// Across the axis, Earth g.
    pub lateral_earth_g: f64,
    /// Along the axis, Earth g.
    pub axial_earth_g: f64,
    /// Key in the list of references.
    pub source: String,
    /// Place in the source.
    pub place: String,
}

/// A file of `data/vehicles`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct VehicleData {
    /// Key in the list of references.
    pub source: String,
    /// Place in the source.
    pub place: String,
    /// Note for the reader.
    pub note: String,
    /// Constants of the geometry, by name.
    pub rules: BTreeMap<String, Datum>,
    /// Densities, by name.
    pub density: BTreeMap<String, Datum>,
    /// Structural materials, by name.
    pub carrier: BTreeMap<String, CarrierMaterial>,
    /// Factors of the structural rules, by name.
    pub loads: BTreeMap<String, Datum>,
    /// Corners of the load factors at launch.
    pub launch: [LaunchCorner; 4],
    /// Foam grades by rising density.
    pub foam: Vec<FoamGrade>,
}

impl VehicleData {
    /// Reads a file of `data/vehicles`; a missing constant is an error too.
    pub fn parse(data: Data) -> Result<Self, String> {
        let data: Self = data.read()?;
        data.rules()?;
        data.densities()?;
        data.structure_loads()?;
        for key in data.density.keys() {
            data.filling(key)?;
        }
        Ok(data)
    }

    /// Constants of the geometry.
    pub fn rules(&self) -> Result<Rules, String> {
        let get = |key| value(&self.rules, key);
        count(&self.rules, 13, "rules")?;
        Ok(Rules {
            annulus_width_m: get("annulus_width_m")?,
            payload_lid_gap_m: get("payload_lid_gap_m")?,
            wing_slope_min_rad: get("wing_slope_min_deg")? * RADIANS_PER_DEGREE,
            wing_slope_max_rad: get("wing_slope_max_deg")? * RADIANS_PER_DEGREE,
            diameter_max_m: get("diameter_max_m")?,
            diameter_resolution_m: get("diameter_resolution_m")?,
            convergence_m: get("convergence_m")?,
            impact_shell_thickness_m: get("impact_shell_thickness_m")?,
            body_foam_gap_m: get("body_foam_gap_m")?,
            lid_insulation_gap_m: get("lid_insulation_gap_m")?,
            lid_gap_min_m: get("lid_gap_min_m")?,
            payload_wall_gap_min_m: get("payload_wall_gap_min_m")?,
            foam_thickness_min_m: get("foam_thickness_min_m")?,
        })
    }

    /// Densities of the fillings; that of the impact foam may be left to its strength.
    pub fn densities(&self) -> Result<ComponentDensities, String> {
        let get = |key| value(&self.density, key);
        let foam = self
            .density
            .get("impact_foam_kg_m3")
            .map(|datum| datum.value);
        count(&self.density, 5 + usize::from(foam.is_some()), "density")?;
        Ok(ComponentDensities {
            impact_foam_kg_m3: foam,
            impact_panels_kg_m3: get("impact_panels_kg_m3")?,
            impact_shell_kg_m3: get("impact_shell_kg_m3")?,
            body_foam_kg_m3: get("body_foam_kg_m3")?,
            lid_insulation_kg_m3: get("lid_insulation_kg_m3")?,
            wing_insulation_kg_m3: get("wing_insulation_kg_m3")?,
        })
    }

    /// The material of a density of this file.
    pub fn filling(&self, key: &str) -> Result<Material, String> {
        let datum = self.density.get(key).ok_or(format!("{key} is missing"))?;
        let name = datum.material.as_deref();
        let name = name.ok_or(format!("{key} has no material"))?;
        Ok(Material::new(name, DensityBasis::of_source(&datum.source)))
    }

    /// Factors of the structural rules.
    pub fn structure_loads(&self) -> Result<StructureLoads, String> {
        let get = |key| value(&self.loads, key);
        count(&self.loads, 2, "loads")?;
        Ok(StructureLoads {
            safety_factor: get("safety_factor")?,
            launch: core::array::from_fn(|i| LaunchLoad {
                lateral_earth_g: self.launch[i].lateral_earth_g,
                axial_earth_g: self.launch[i].axial_earth_g,
            }),
            aftbody_pressure_fraction: get("aftbody_pressure_fraction")?,
        })
    }
}

fn value(table: &BTreeMap<String, Datum>, key: &str) -> Result<f64, String> {
    table
        .get(key)
        .map(|datum| datum.value)
        .ok_or_else(|| format!("{key} is missing"))
}

/// With every wanted key present, a longer table holds one that nothing reads.
fn count(table: &BTreeMap<String, Datum>, wanted: usize, name: &str) -> Result<(), String> {
    if table.len() > wanted {
        return Err(format!(
            "{name} holds a key that is not known, among: {:?}",
            table.keys()
        ));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    const MMEEV: &str = include_str!("../../data/vehicles/mmeev.toml");

    #[test]
    fn the_mmeev_has_60_mm_of_annulus_and_30_deg_of_wing() {
        let rules = VehicleData::parse(MMEEV.into()).unwrap().rules().unwrap();
        assert_eq!(rules.annulus_width_m, 0.06);
        assert!((rules.wing_slope_max_rad - numerics::math::PI / 6.0).abs() < 1e-15);
    }

    #[test]
    fn missing_and_unknown_constants_are_refused() {
        assert!(
            VehicleData::parse(
                MMEEV
                    .replace("rules.annulus_width_m", "rules.annulus_m")
                    .as_str()
                    .into()
            )
            .is_err()
        );
        let more =
            format!("{MMEEV}\n[loads.spin]\nvalue = 1.0\nsource = \"assumed\"\nplace = \"x\"\n");
        assert!(
            VehicleData::parse(more.as_str().into())
                .unwrap_err()
                .contains("spin")
        );
    }
}
