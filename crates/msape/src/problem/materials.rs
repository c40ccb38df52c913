//! Names the materials of a design's components.

use super::design::Densities;
use crate::library::Stack;
use crate::tps::material::TpsMaterial;
use crate::vehicle::{DensityBasis, Material, Materials, VehicleData};

/// Materials of a concept; a density that the case gives is marked as given.
pub(super) fn materials(
    given: &Densities,
    vehicle: &VehicleData,
    stack: &Stack,
    aft: &TpsMaterial,
) -> Option<Materials> {
    let (concept, fore) = (&stack.concept, &stack.tps);
    let carrier = stack.carrier.material();
    let shield = |material: &TpsMaterial| {
        let basis = DensityBasis::of_source(&material.density.source);
        Material::new(material.name.clone(), basis)
    };
    let filling = |key: &str, density| Some(vehicle.filling(key).ok()?.with_given(density));
    let foam = |density| Material::new("Impact foam", DensityBasis::Given).with_given(density);
    let bond_basis = match concept.bond.provenance.starts_with("assumed") {
        true => DensityBasis::Assumed,
        false => DensityBasis::Published,
    };
    Some(Materials {
        forebody_tps: shield(fore).with_given(given.forebody_tps),
        bond: Material::new(concept.bond.name.clone(), bond_basis),
        forebody_carrier: carrier.clone().with_given(given.forebody_carrier),
        aftbody_tps: shield(aft).with_given(given.aftbody_tps),
        aftbody_carrier: carrier.clone().with_given(given.aftbody_carrier),
        primary_structure: carrier.with_given(given.primary),
        wing_insulation: filling("wing_insulation_kg_m3", given.wing_insulation)?,
        impact_foam: given.impact_foam.map(|density| foam(Some(density))),
        impact_shell: filling("impact_shell_kg_m3", given.impact_shell)?,
        body_foam: filling("body_foam_kg_m3", given.body_foam)?,
        lid_insulation: filling("lid_insulation_kg_m3", given.lid_insulation)?,
        payload: Material::new("Payload, a homogeneous ball", DensityBasis::Given),
    })
}
