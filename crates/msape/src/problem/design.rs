//! Checks a design.

use super::fitted_in_air::fitted_in_air;
use super::flight::{Angle, mission};
use super::forms::together;
use super::materials::materials;
use crate::case::Reader;
use crate::design::drag::DesignDrag;
use crate::design::inputs::{DesignInput, Given};
use crate::library::{Library, named, names};
use crate::quantity::input::{self, Input, OWN_OUTLINE};
use crate::tps::material::TpsMaterial;
use crate::vehicle::ComponentKind;
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

/// Explanations, by input, of the surfaces that would intersect if a dimension were outside its range.
const CROSSINGS: [(&Input, &str); 4] = [
    (
        &input::design::SHOULDER_RADIUS_RATIO,
        "without a shoulder the layers of forebody and aftbody would cross at a sharp edge; beyond half the radius the shoulder would cross the nose",
    ),
    (
        &input::design::NOSE_RADIUS_RATIO,
        "at a sharp tip the layers of the heat shield would cross on the axis; a wider nose sphere would cross the shoulder",
    ),
    (
        &input::design::PAYLOAD_DIAMETER_RATIO,
        "a wider payload would cross the outline of the vehicle",
    ),
    (
        &input::design::CONE_HALF_ANGLE_DEG,
        "a sharper or blunter cone would cross the wing, whose aft side slopes 5 to 30 deg",
    ),
];

/// Adds to faults of the geometry the surfaces that would intersect.
fn explain_crossings(reader: &mut Reader) {
    for fault in &mut reader.faults {
        if let Some((_, why)) = CROSSINGS.iter().find(|(input, _)| input.key == fault.key)
            && fault.message.contains("must be")
        {
            fault.message = format!("{}: {why}", fault.message);
        }
    }
}

/// Everything that determines a design.
pub(super) fn design(reader: &mut Reader, library: &Library) -> Option<DesignInput> {
    let mission = mission(reader, library, Angle::Descending);
    let msr = reader.flag(&input::design::MSR_MODE);
    let sizes = [
        &input::design::DIAMETER_M,
        &input::design::NOSE_RADIUS_RATIO,
        &input::design::SHOULDER_RADIUS_RATIO,
        &input::design::PAYLOAD_MASS_KG,
    ]
    .map(|input| reader.required_number(input));
    let payload_size = payload_size(reader);
    let concept_name = reader.name(&input::design::FOREBODY_TPS, &names(&library.concepts));
    let aft_name = aftbody_material(reader, library);
    let ground_name = reader.name(&input::design::GROUND, &names(&library.grounds));
    let foam_strength = reader.choice(&input::design::FOAM_STRENGTH);
    let efficiency = reader.number(&input::design::STROKE_EFFICIENCY);
    let crushing_mass = reader.choice(&input::design::CRUSHING_MASS);
    let aero_name = aerodynamics(reader, library);
    let judged_at = reader.choice(&input::heating::JUDGED_AT);
    let numbers = [
        &input::design::CONE_HALF_ANGLE_DEG,
        &input::design::MASS_MARGIN,
        &input::design::CRUSH_LOAD_LIMIT_EARTH_G,
        &input::design::TERMINAL_DRAG_COEFFICIENT,
        &input::design::MASS_CRITERION_KG,
        &input::design::MAX_ITERATIONS,
        &input::design::RELAXATION,
    ]
    .map(|input| reader.number(input));
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
        forebody_tps_m: reader.number(&input::design::FOREBODY_TPS_THICKNESS_M),
        aftbody_tps_m: reader.number(&input::design::AFTBODY_TPS_THICKNESS_M),
        payload_temperature_k: reader.number(&input::design::PAYLOAD_TEMPERATURE_K),
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
            foam_strength: foam_strength?,
            ground: named(&library.grounds, ground_name?)?.clone(),
            foam: library.impact_foam.clone(),
            crushing_mass: crushing_mass?,
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
                let finding = force.other_cone(name, cone, input::design::AERODYNAMICS.key);
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
    let tables = names(&library.aerodynamics);
    let names: Vec<&str> = std::iter::once(OWN_OUTLINE).chain(tables).collect();
    reader.name(&input::design::AERODYNAMICS, &names)
}

fn aftbody_material<'l>(reader: &mut Reader, library: &'l Library) -> Option<&'l str> {
    let names: Vec<&str> = library
        .aftbody_materials()
        .map(|(name, _): &(String, TpsMaterial)| name.as_str())
        .collect();
    reader.name(&input::design::AFTBODY_TPS, &names)
}

/// Size of the payload: one of three inputs.
fn payload_size(reader: &mut Reader) -> Option<PayloadSize> {
    let [density, diameter, ratio] = [
        &input::design::PAYLOAD_DENSITY_KG_M3,
        &input::design::PAYLOAD_DIAMETER_M,
        &input::design::PAYLOAD_DIAMETER_RATIO,
    ];
    match reader.ways(&input::design::PAYLOAD_SIZE).as_slice() {
        [] => {
            let message = format!("missing; give it, in kg/m^3, or {diameter}, in m, or {ratio}");
            reader.fault(density, message);
            None
        }
        [way] => {
            let value = reader.number(*way)?;
            Some(if *way == density {
                PayloadSize::DensityKgM3(value)
            } else if *way == diameter {
                PayloadSize::DiameterM(value)
            } else {
                PayloadSize::DiameterRatio(value)
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
        let mut of = |input| reader.number(input);
        Densities {
            forebody_tps: of(&input::design::DENSITY_KG_M3_FOREBODY_TPS),
            forebody_carrier: of(&input::design::DENSITY_KG_M3_FOREBODY_CARRIER_STRUCTURE),
            aftbody_tps: of(&input::design::DENSITY_KG_M3_AFTBODY_TPS),
            aftbody_carrier: of(&input::design::DENSITY_KG_M3_AFTBODY_CARRIER_STRUCTURE),
            primary: of(&input::design::DENSITY_KG_M3_PRIMARY_STRUCTURE),
            impact_foam: of(&input::design::DENSITY_KG_M3_IMPACT_FOAM),
            impact_panels: of(&input::design::DENSITY_KG_M3_IMPACT_PANELS),
            impact_shell: of(&input::design::DENSITY_KG_M3_IMPACT_SHELL),
            body_foam: of(&input::design::DENSITY_KG_M3_BODY_FOAM),
            lid_insulation: of(&input::design::DENSITY_KG_M3_LID_INSULATION),
            wing_insulation: of(&input::design::DENSITY_KG_M3_WING_INSULATION),
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
        let Some(mass) = kind.mass_input().filter(|mass| reader.given(*mass)) else {
            continue;
        };
        if let Some(density) = mass.rivals().find(|density| reader.given(*density)) {
            together(reader, mass, density);
        }
        masses.extend(reader.number(mass).map(|mass_kg| (kind, mass_kg)));
    }
    masses
}

/// A wall with another density: that of the laminate, or in a sandwich those of faces and core in proportion.
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
