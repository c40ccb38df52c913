//! Layers of a case, by the names of their cards or by numbers; those of a designed vehicle where the case gives none.

use super::wall::Flown;
use crate::ablation::Cards;
use crate::case::Reader;
use crate::finding::Finding;
use crate::quantity::input::Input;
use crate::quantity::input::tps::layer;
use ::ablation::contact::Joint;
use ::ablation::solid::{Solid, State};
use ::ablation::stack::{Layer, Material};
use ::ablation::surface::Surface;

/// Numbers that make a material.
const NUMBERS: [&Input; 3] = [
    &layer::DENSITY_KG_M3,
    &layer::SPECIFIC_HEAT_J_KGK,
    &layer::CONDUCTIVITY_W_MK,
];

/// The layers; `None` where one is at fault.
pub(super) fn layers(
    reader: &mut Reader,
    cards: &Cards,
    flown: Option<&Flown>,
) -> Option<Vec<Layer>> {
    let count = reader.count(&layer::SECTION);
    if count == 0 {
        return of_design(reader, cards, flown);
    }
    let before = reader.faults.len();
    let found: Vec<Layer> = (1..=count)
        .filter_map(|number| of_number(reader, cards, number))
        .collect();
    (reader.faults.len() == before && found.len() == count).then_some(found)
}

/// The heat shield of the designed vehicle, bare.
fn of_design(reader: &mut Reader, cards: &Cards, flown: Option<&Flown>) -> Option<Vec<Layer>> {
    let Some((name, thickness_m)) = flown.and_then(|flown| flown.heat_shield.as_ref()) else {
        reader.fault(
            &layer::SECTION.name,
            "missing; a heat shield has at least one layer",
        );
        return None;
    };
    let material = material(reader, cards, &layer::SECTION.name, name)?;
    let message = format!(
        "The heat shield is that of the design, {name} of {} m, bare.",
        crate::units::number::rounded(*thickness_m, 4)
    );
    reader
        .findings
        .push(Finding::note("in-depth", &layer::SECTION.name, message));
    Some(vec![Layer {
        material,
        thickness_m: *thickness_m,
        joint: Joint::Perfect,
    }])
}

fn material(
    reader: &mut Reader,
    cards: &Cards,
    key: &dyn std::fmt::Display,
    name: &str,
) -> Option<Material> {
    match cards.card(name) {
        Ok(card) => {
            let assumed = card.note.contains("ssumed") || card.note.contains("rovisional");
            if assumed {
                reader.findings.push(Finding::note(
                    "in-depth",
                    key,
                    format!("{name}: {}", card.note),
                ));
            }
            Some(card.material)
        }
        Err(message) => {
            reader.fault(key, message);
            None
        }
    }
}

fn of_number(reader: &mut Reader, cards: &Cards, number: usize) -> Option<Layer> {
    let thickness = layer::THICKNESS_M.of_number(number);
    if !reader.given(thickness) {
        reader.fault(&thickness, "missing; every layer has a thickness");
    }
    let thickness_m = reader.number(thickness);
    let name = layer::MATERIAL.of_number(number);
    let by_numbers = NUMBERS.map(|input| reader.given(input.of_number(number)));
    let material = match reader.words(name) {
        Some(text) => {
            if by_numbers.contains(&true) {
                reader.fault(
                    &name,
                    "given together with numbers of a material; give one of them",
                );
            }
            material(reader, cards, &name, &text)
        }
        None if reader.given(name) => None,
        None => of_numbers(reader, cards, number),
    };
    let joint = joint(reader, number);
    Some(Layer {
        material: material?,
        thickness_m: thickness_m?,
        joint: joint?,
    })
}

fn of_numbers(reader: &mut Reader, cards: &Cards, number: usize) -> Option<Material> {
    for input in NUMBERS {
        let key = input.of_number(number);
        if !reader.given(key) {
            reader.fault(
                &key,
                "missing; a layer has a material, or density, specific heat and conductivity",
            );
        }
    }
    let [density, specific_heat, conductivity] =
        NUMBERS.map(|input| reader.number(input.of_number(number)));
    let emissivity = reader.number(layer::EMISSIVITY.of_number(number))?;
    let state = State {
        density_kg_m3: density?,
        formation_j_kg: 0.0,
        specific_heat: vec![[298.15, specific_heat?]],
        conductivity: vec![[298.15, conductivity?]],
        emissivity,
        absorptivity: emissivity,
    };
    let solid = Solid::inert(state);
    let surface = Surface::Inert(cards.air.to_vec());
    let made =
        solid.and_then(|solid| Material::try_new(format!("layer {number}"), solid, None, surface));
    match made {
        Ok(material) => Some(material),
        Err(fault) => {
            reader.fault(&layer::DENSITY_KG_M3.of_number(number), fault.to_string());
            None
        }
    }
}

fn joint(reader: &mut Reader, number: usize) -> Option<Joint> {
    let contact = layer::CONTACT_M2K_W.of_number(number);
    let emissivity = layer::GAP_EMISSIVITY.of_number(number);
    let conductance = layer::GAP_CONDUCTANCE_W_M2K.of_number(number);
    let gap = reader.given(emissivity) || reader.given(conductance);
    if gap && reader.given(contact) {
        reader.fault(&contact, "given together with a gap; give one of them");
        return None;
    }
    if gap {
        let value = |reader: &mut Reader, key| match reader.given(key) {
            true => reader.number(key),
            false => Some(0.0),
        };
        return Some(Joint::Gap {
            conductance_w_m2k: value(reader, conductance)?,
            emissivity: value(reader, emissivity)?,
        });
    }
    if !reader.given(contact) {
        return Some(Joint::Perfect);
    }
    let resistance_m2k_w = reader.number(contact)?;
    Some(match resistance_m2k_w {
        0.0 => Joint::Perfect,
        _ => Joint::Contact { resistance_m2k_w },
    })
}
