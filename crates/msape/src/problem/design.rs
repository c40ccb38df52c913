//! Checks a design.

use super::aerodynamics::fitted_in_air;
use super::flight::{Angle, mission};
use super::forms::choice as fixed;
use super::materials::materials;
use crate::case::Reader;
use crate::design::drag::DesignDrag;
use crate::design::inputs::{DesignInput, Given};
use crate::library::{Library, Named, named};
use crate::quantity::input::OWN_OUTLINE;
use crate::tps::JudgedAt;
use crate::tps::material::TpsMaterial;
use crate::vehicle::ComponentKind;
use crate::vehicle::CrushingMass;
use crate::vehicle::FoamStrength;
use crate::vehicle::ImpactInput;
use crate::vehicle::WallPlace;
use crate::vehicle::structure::{Carrier, Construction};
use crate::vehicle::{ComponentDensities, Concept, LayerStack, Loads, PayloadSize, VehicleInput};
use numerics::math::RADIANS_PER_DEGREE;

/// Loads and thicknesses with which the passes begin: those of the vehicle of Tables 9 and 15, rounded.
const FIRST_LOADS: Loads = Loads {
    entry_load_earth_g: 100.0,
    peak_stagnation_pressure_pa: 5e4,
    terminal_speed_m_s: 35.0,
};
const FIRST_FOREBODY_TPS_M: f64 = 0.03;
const FIRST_AFTBODY_TPS_M: f64 = 0.01;

/// What would cross what where a dimension is outside its range.
const CROSSINGS: [(&str, &str); 4] = [
    (
        "design.shoulder_radius_ratio",
        "without a shoulder the layers of forebody and aftbody would cross at a sharp edge; beyond half the radius the shoulder would cross the nose",
    ),
    (
        "design.nose_radius_ratio",
        "at a sharp tip the layers of the heat shield would cross on the axis; a wider nose sphere would cross the shoulder",
    ),
    (
        "design.payload_diameter_ratio",
        "a wider payload would cross the outline of the vehicle",
    ),
    (
        "design.cone_half_angle_deg",
        "a sharper or blunter cone would cross the wing, whose aft side slopes 5 to 30 deg",
    ),
];

/// Adds to faults of the geometry what would cross what.
fn explain_crossings(reader: &mut Reader) {
    for fault in &mut reader.faults {
        if let Some((_, why)) = CROSSINGS.iter().find(|(key, _)| *key == fault.key)
            && fault.message.contains("must be")
        {
            fault.message = format!("{}: {why}", fault.message);
        }
    }
}

/// Everything that determines a design.
pub(super) fn design(reader: &mut Reader, library: &Library) -> Option<DesignInput> {
    let mission = mission(reader, library, Angle::Descending);
    let msr = reader.flag("design.msr_mode");
    let sizes = [
        "diameter_m",
        "nose_radius_ratio",
        "shoulder_radius_ratio",
        "payload_mass_kg",
    ]
    .map(|name| reader.required_number(&format!("design.{name}")));
    let payload_size = payload_size(reader);
    let concept_name = choice(reader, "design.forebody_tps", &library.concepts);
    let aft_name = aftbody_material(reader, library);
    let ground_name = choice(reader, "design.ground", &library.grounds);
    let foam_strength = reader.choice("design.foam_strength", &["crush-law", "equation-6"]);
    let efficiency = reader.number("design.stroke_efficiency");
    let crushing_mass = reader.choice("design.crushing_mass", &["payload", "impact-sphere"]);
    let aero_name = aerodynamics(reader, library);
    let judged_at = fixed(reader, "heating.judged_at").and_then(JudgedAt::named);
    let numbers = [
        "cone_half_angle_deg",
        "mass_margin",
        "crush_load_limit_earth_g",
        "terminal_drag_coefficient",
        "mass_criterion_kg",
        "max_iterations",
        "relaxation",
    ]
    .map(|name| reader.number(&format!("design.{name}")));
    let [
        cone_deg,
        margin,
        crush_limit,
        terminal_drag,
        criterion,
        iterations,
        relaxation,
    ] = numbers;
    explain_crossings(reader);
    let mut densities = Densities::read(reader);
    let given = Given {
        forebody_tps_m: reader.number("design.forebody_tps_thickness_m"),
        aftbody_tps_m: reader.number("design.aftbody_tps_thickness_m"),
        payload_temperature_k: reader.number("design.payload_temperature_k"),
    };
    let given_masses = given_masses(reader);
    let [
        diameter_m,
        nose_radius_ratio,
        shoulder_radius_ratio,
        payload_mass_kg,
    ] = sizes;

    let stack = named(&library.concepts, concept_name?)?;
    let concept = &stack.concept;
    let forebody_material = stack.tps.clone();
    let aftbody_material = named(&library.materials, aft_name?)?.clone();
    let carrier = &stack.carrier;
    let wall = |place, density: Option<f64>| with_density(carrier.carrier(place), density);
    let vehicle = VehicleInput {
        concept: if msr? { Concept::Msr } else { Concept::NonMsr },
        diameter_m: diameter_m?,
        nose_radius_ratio: nose_radius_ratio?,
        shoulder_radius_ratio: shoulder_radius_ratio?,
        cone_half_angle_rad: cone_deg? * RADIANS_PER_DEGREE,
        payload_mass_kg: payload_mass_kg?,
        payload_size: payload_size?,
        mass_margin: margin?,
        forebody: LayerStack {
            tps_thickness_m: given.forebody_tps_m.unwrap_or(FIRST_FOREBODY_TPS_M),
            tps_density_kg_m3: densities
                .forebody_tps
                .unwrap_or(forebody_material.density.density_kg_m3),
            bond_thickness_m: concept.bond_thickness_m(),
            bond_density_kg_m3: concept.bond.density_kg_m3,
            carrier_thickness_m: None,
            carrier: wall(WallPlace::Forebody, densities.forebody_carrier),
        },
        aftbody_tps_thickness_m: given.aftbody_tps_m.unwrap_or(FIRST_AFTBODY_TPS_M),
        aftbody_tps_density_kg_m3: densities
            .aftbody_tps
            .unwrap_or(aftbody_material.density.density_kg_m3),
        aftbody_carrier: wall(WallPlace::Aftbody, densities.aftbody_carrier),
        primary_carrier: wall(WallPlace::Primary, densities.primary),
        materials: materials(&densities, &library.vehicle, stack, &aftbody_material)?,
        densities: densities.fillings(library.vehicle.densities().ok()?),
        given_masses,
        loads: FIRST_LOADS,
        structure_loads: library.vehicle.structure_loads().ok()?,
        impact: ImpactInput {
            crush_load_limit_earth_g: crush_limit?,
            stroke_efficiency: efficiency,
            foam_strength: match foam_strength? {
                "equation-6" => FoamStrength::Equation6,
                _ => FoamStrength::CrushLaw,
            },
            ground: named(&library.grounds, ground_name?)?.clone(),
            foam: library.impact_foam.clone(),
            crushing_mass: match crushing_mass? {
                "impact-sphere" => CrushingMass::ImpactSphere,
                _ => CrushingMass::Payload,
            },
        },
        foam_grades: library.vehicle.foam.clone(),
        rules: library.vehicle.rules().ok()?,
    };
    let heat_capacity_ratio = mission
        .as_ref()
        .map(|mission| mission.heat_capacity_ratio());
    Some(DesignInput {
        mission: mission?,
        vehicle,
        given,
        soak: stack.soak.clone(),
        forebody_material,
        aftbody_material,
        fit_space: library.fit_space.clone(),
        afterbody: library.heating.afterbody.clone(),
        shoulder: library.heating.shoulder.clone(),
        judged_at: judged_at?,
        drag: match aero_name? {
            OWN_OUTLINE => {
                fitted_in_air(reader, heat_capacity_ratio?, None);
                DesignDrag::Outline {
                    forces: library.axial_forces().in_gas(heat_capacity_ratio?),
                    subsonic: terminal_drag?,
                }
            }
            name => {
                let force = named(&library.aerodynamics, name)?;
                let cone = cone_deg.map(|deg| deg * RADIANS_PER_DEGREE);
                let finding = force.other_cone(name, cone, "design.aerodynamics");
                reader.findings.extend(finding);
                fitted_in_air(reader, heat_capacity_ratio?, Some(name));
                DesignDrag::Table(force.table.with_subsonic(terminal_drag?))
            }
        },
        mass_criterion_kg: criterion?,
        max_iterations: iterations? as u32,
        relaxation: relaxation?,
    })
}

fn aerodynamics<'l>(reader: &mut Reader, library: &'l Library) -> Option<&'l str> {
    let tables = library.aerodynamics.iter().map(|(name, _)| name.as_str());
    let names: Vec<&str> = std::iter::once(OWN_OUTLINE).chain(tables).collect();
    reader.choice("design.aerodynamics", &names)
}

fn choice<'l, T>(reader: &mut Reader, key: &str, list: &'l Named<T>) -> Option<&'l str> {
    let names: Vec<&str> = list.iter().map(|(name, _)| name.as_str()).collect();
    reader.choice(key, &names)
}

fn aftbody_material<'l>(reader: &mut Reader, library: &'l Library) -> Option<&'l str> {
    let names: Vec<&str> = library
        .aftbody_materials()
        .map(|(name, _): &(String, TpsMaterial)| name.as_str())
        .collect();
    reader.choice("design.aftbody_tps", &names)
}

/// Size of the payload: one of three inputs.
fn payload_size(reader: &mut Reader) -> Option<PayloadSize> {
    let keys = [
        "design.payload_density_kg_m3",
        "design.payload_diameter_m",
        "design.payload_diameter_ratio",
    ];
    let given: Vec<&str> = keys.into_iter().filter(|key| reader.given(key)).collect();
    match given.as_slice() {
        [] => {
            let message = "missing; give it, in kg/m^3, or design.payload_diameter_m, in m, or design.payload_diameter_ratio";
            reader.fault(keys[0], message);
            None
        }
        [key] => {
            let value = reader.number(key)?;
            Some(match *key {
                "design.payload_density_kg_m3" => PayloadSize::DensityKgM3(value),
                "design.payload_diameter_m" => PayloadSize::DiameterM(value),
                _ => PayloadSize::DiameterRatio(value),
            })
        }
        [_, second, ..] => {
            reader.fault(second, "the size of the payload is given in more than one way; give one of density, diameter, diameter ratio");
            None
        }
    }
}

/// Densities of the case, kg/m³, where it gives them.
pub(super) struct Densities {
    pub(super) forebody_tps: Option<f64>,
    pub(super) forebody_carrier: Option<f64>,
    pub(super) aftbody_tps: Option<f64>,
    pub(super) aftbody_carrier: Option<f64>,
    pub(super) primary: Option<f64>,
    pub(super) impact_foam: Option<f64>,
    pub(super) impact_panels: Option<f64>,
    pub(super) impact_shell: Option<f64>,
    pub(super) body_foam: Option<f64>,
    pub(super) lid_insulation: Option<f64>,
    pub(super) wing_insulation: Option<f64>,
}

impl Densities {
    fn read(reader: &mut Reader) -> Densities {
        let mut of = |name: &str| reader.number(&format!("design.density_kg_m3.{name}"));
        Densities {
            forebody_tps: of("forebody_tps"),
            forebody_carrier: of("forebody_carrier_structure"),
            aftbody_tps: of("aftbody_tps"),
            aftbody_carrier: of("aftbody_carrier_structure"),
            primary: of("primary_structure"),
            impact_foam: of("impact_foam"),
            impact_panels: of("impact_panels"),
            impact_shell: of("impact_shell"),
            body_foam: of("body_foam"),
            lid_insulation: of("lid_insulation"),
            wing_insulation: of("wing_insulation"),
        }
    }

    fn fillings(&mut self, of_data: ComponentDensities) -> ComponentDensities {
        ComponentDensities {
            impact_foam_kg_m3: self.impact_foam.or(of_data.impact_foam_kg_m3),
            impact_panels_kg_m3: self.impact_panels.unwrap_or(of_data.impact_panels_kg_m3),
            impact_shell_kg_m3: self.impact_shell.unwrap_or(of_data.impact_shell_kg_m3),
            body_foam_kg_m3: self.body_foam.unwrap_or(of_data.body_foam_kg_m3),
            lid_insulation_kg_m3: self.lid_insulation.unwrap_or(of_data.lid_insulation_kg_m3),
            wing_insulation_kg_m3: self
                .wing_insulation
                .unwrap_or(of_data.wing_insulation_kg_m3),
        }
    }
}

/// Masses of components in the case, in the place of their densities.
fn given_masses(reader: &mut Reader) -> Vec<(ComponentKind, f64)> {
    let mut masses = Vec::new();
    for kind in ComponentKind::MADE {
        let name = kind.key();
        let key = format!("design.component_mass_kg.{name}");
        let density = format!("design.density_kg_m3.{name}");
        if !reader.given(&key) {
            continue;
        }
        if reader.given(&density) {
            let message = format!("given together with {density}; give one of them");
            reader.fault(&key, message);
        }
        masses.extend(reader.number(&key).map(|mass_kg| (kind, mass_kg)));
    }
    masses
}

/// A wall of another density: of a laminate its own, of a sandwich that of its faces and core in proportion.
fn with_density(mut carrier: Carrier, density: Option<f64>) -> Carrier {
    if let Some(density) = density {
        let factor = density / carrier.at_minimum_gauge().density_kg_m3;
        match &mut carrier.construction {
            Construction::Solid { density_kg_m3 } => *density_kg_m3 = density,
            Construction::Sandwich {
                face_density_kg_m3,
                core_density_kg_m3,
                ..
            } => {
                *face_density_kg_m3 *= factor;
                *core_density_kg_m3 *= factor;
            }
        }
    }
    carrier
}
