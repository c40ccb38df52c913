//! What the page shows of the library. The worker reads the data files and sends this once, when it starts: the page has no
//! reader of them.

use msape::Library;
use msape::quantity::input::{Choices, Input, Kind, inputs};
use msape::vehicle::body::OutlineData;
use msape::vehicle::impact::Ground;
use msape::vehicle::structure::Construction;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// What an input may be: its names in a case, each with a title.
pub type Names = Vec<(String, String)>;

/// What the page shows of the library.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Catalog {
    /// Names of the library that an input may have, by its key.
    names: BTreeMap<String, Names>,
    /// Outlines of rigid bodies by name.
    pub outlines: Vec<(String, OutlineData)>,
    /// Grounds by name.
    pub grounds: Vec<(String, Ground)>,
    /// Structural materials.
    pub walls: Vec<WallMaterial>,
    /// How the impact foam crushes, and where its numbers come from.
    pub foam_law: String,
}

/// A material for carriers and primary structure.
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
    /// What is assumed.
    pub note: String,
}

impl Catalog {
    /// That of a library.
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

/// What an input may be; none where that is for the library to say and `catalog` has not come yet.
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
    use crate::protocol::{decode, encode};
    use msape::quantity::input::find;

    #[test]
    fn each_choice_has_names_on_the_other_side_and_fixed_ones_before() {
        let catalog = Catalog::of(&Library::builtin().unwrap());
        let catalog: Catalog = decode(&encode(&catalog).unwrap()).unwrap();
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
