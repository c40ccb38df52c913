//! Library data shown by the page. The worker reads the data files and sends the catalog once, when it starts: the page
//! has no reader for them.

use msape::Library;
use msape::quantity::input::{Choices, Input, Kind, inputs};
use msape::vehicle::body::OutlineData;
use msape::vehicle::impact::Ground;
use msape::vehicle::structure::Construction;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Allowed values of an input: names as in a case, each with a title.
pub type Names = Vec<(String, String)>;

/// Library data shown by the page.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Catalog {
    /// Allowed names of inputs, by key of the input.
    names: BTreeMap<String, Names>,
    /// Outlines of rigid bodies by name.
    pub outlines: Vec<(String, OutlineData)>,
    /// Grounds by name.
    pub grounds: Vec<(String, Ground)>,
    /// Structural materials.
    pub walls: Vec<WallMaterial>,
    /// Crush law of the impact foam and its source.
    pub foam_law: String,
}

/// Material for carriers and primary structure.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct WallMaterial {
    /// Name.
    pub name: String,
    /// Young's modulus, Pa.
    pub elastic_modulus_pa: f64,
    /// Allowable stress, Pa.
    pub strength_pa: f64,
    /// Shear strength of the core of a sandwich, Pa.
    pub core_shear_strength_pa: Option<f64>,
    /// Note on assumptions.
    pub note: String,
}

impl Catalog {
    /// Catalog of a library.
    pub fn of(library: &Library) -> Catalog {
        let named = |input: &Input| match input.kind {
            Kind::Choice(Choices::Fixed(_)) => None,
            Kind::Choice(choices) => Some((input.key.to_string(), library.choices(choices))),
            Kind::Number { .. } | Kind::Flag | Kind::Rows(_) | Kind::Text => None,
        };
        let foam = &library.impact_foam;
        Catalog {
            names: inputs().filter_map(named).collect(),
            outlines: library.outlines.clone(),
            grounds: library.grounds.clone(),
            walls: library
                .vehicle
                .carrier
                .values()
                .map(WallMaterial::of)
                .collect(),
            foam_law: format!("{} ({}; {})", foam.note, foam.place, foam.source),
        }
    }
}

impl WallMaterial {
    fn of(carrier: &msape::vehicle::rules::CarrierMaterial) -> WallMaterial {
        WallMaterial {
            name: carrier.name.clone(),
            elastic_modulus_pa: carrier.elastic_modulus_pa,
            strength_pa: carrier.strength_pa,
            core_shear_strength_pa: match carrier.construction {
                Construction::Solid { .. } => None,
                Construction::Sandwich {
                    core_shear_strength_pa,
                    ..
                } => Some(core_shear_strength_pa),
            },
            note: carrier.note.clone(),
        }
    }
}

/// Allowed values of an input; empty where they come from the library and `catalog` has not arrived yet.
pub fn names(catalog: Option<&Catalog>, input: &Input) -> Names {
    match input.kind {
        Kind::Choice(Choices::Fixed(fixed)) => fixed
            .iter()
            .map(|(name, title)| (name.to_string(), title.to_string()))
            .collect(),
        _ => catalog
            .and_then(|catalog| catalog.names.get(input.key))
            .cloned()
            .unwrap_or_default(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use msape::quantity::input::find;

    #[test]
    fn each_choice_has_names_on_the_other_side_and_fixed_ones_before() {
        let catalog = Catalog::of(&Library::builtin().unwrap());
        let catalog: Catalog =
            postcard::from_bytes(&postcard::to_allocvec(&catalog).unwrap()).unwrap();
        for input in inputs() {
            let Kind::Choice(choices) = input.kind else {
                continue;
            };
            let is_fixed = matches!(choices, Choices::Fixed(_));
            assert_eq!(names(None, input).is_empty(), !is_fixed, "{}", input.key);
            let found = names(Some(&catalog), input);
            assert!(!found.is_empty(), "{}", input.key);
            assert_eq!(found, Library::builtin().unwrap().choices(choices));
        }
        let planet = find("entry.planet").unwrap();
        assert!(
            names(Some(&catalog), planet)
                .iter()
                .any(|(name, _)| name == "mars")
        );
        for (name, outline) in &catalog.outlines {
            assert!(outline.body().is_ok(), "{name}");
        }
        let cores = catalog
            .walls
            .iter()
            .filter_map(|wall| wall.core_shear_strength_pa);
        assert!(cores.count() > 0 && catalog.foam_law.contains('('));
    }
}
