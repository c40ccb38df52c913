//! Whole vehicles: conservation of volume, closing over the trade space, the report's cases.

mod closing;
mod derivatives;
mod landing;
mod trade_space;

use super::*;
use crate::vehicle::close::Search;
use crate::vehicle::impact::Ground;
use crate::vehicle::impact::foam::FoamKind;
use crate::vehicle::input::ImpactInput;
use crate::vehicle::kinds::CrushingMass;
use crate::vehicle::kinds::WallPlace;
use numerics::math::RADIANS_PER_DEGREE;

fn data() -> VehicleData {
    VehicleData::parse(include_str!("../../data/vehicles/mmeev.toml").into()).unwrap()
}

/// Materials by the names of the data file, and by plain words.
fn materials(data: &VehicleData) -> Materials {
    let of = |name: &str| Material::new(name, DensityBasis::Assumed);
    let carrier = data.carrier.get("al-honeycomb").unwrap().material();
    let filling = |key: &str| data.filling(key).unwrap();
    Materials {
        forebody_tps: of("PICA"),
        bond: of("HT-424"),
        forebody_carrier: carrier.clone(),
        aftbody_tps: of("SIRCA"),
        aftbody_carrier: carrier.clone(),
        primary_structure: carrier,
        wing_insulation: filling("wing_insulation_kg_m3"),
        impact_foam: None,
        impact_shell: filling("impact_shell_kg_m3"),
        body_foam: filling("body_foam_kg_m3"),
        lid_insulation: filling("lid_insulation_kg_m3"),
        payload: of("ball"),
    }
}

/// The MSR vehicle of Table 15 with PICA on honeycomb.
pub(super) fn msr() -> VehicleInput {
    let data = data();
    let honeycomb = data.carrier.get("al-honeycomb").unwrap();
    VehicleInput {
        concept: Concept::Msr,
        diameter_m: 0.9,
        nose_radius_ratio: 0.25,
        shoulder_radius_ratio: 0.07,
        cone_half_angle_rad: 60.0 * RADIANS_PER_DEGREE,
        payload_mass_kg: 12.5,
        payload_size: PayloadSize::DensityKgM3(4000.0),
        mass_margin: 0.3,
        forebody: LayerStack {
            tps_thickness_m: 0.038,
            tps_density_kg_m3: 274.0,
            bond_thickness_m: 0.000_381,
            bond_density_kg_m3: 1732.0,
            carrier_thickness_m: None,
            carrier: honeycomb.carrier(WallPlace::Forebody),
        },
        aftbody_tps_thickness_m: 0.01,
        aftbody_tps_density_kg_m3: 192.0,
        aftbody_carrier: honeycomb.carrier(WallPlace::Aftbody),
        primary_carrier: honeycomb.carrier(WallPlace::Primary),
        densities: data.densities().unwrap(),
        given_masses: Vec::new(),
        materials: materials(&data),
        loads: Loads {
            entry_load_earth_g: 134.0,
            peak_stagnation_pressure_pa: 130_000.0,
            terminal_speed_m_s: 39.8,
        },
        structure_loads: data.structure_loads().unwrap(),
        impact: ImpactInput {
            crush_load_limit_earth_g: 3500.0,
            stroke_efficiency: None,
            foam_strength: FoamStrength::CrushLaw,
            ground: Ground::parse(include_str!("../../data/grounds/uttr-clay.toml").into())
                .unwrap(),
            foam: FoamKind::parse(include_str!("../../data/foams/pmi.toml").into()).unwrap(),
            crushing_mass: CrushingMass::Payload,
        },
        foam_grades: data.foam.clone(),
        rules: data.rules().unwrap(),
    }
}

fn msr_carbon() -> VehicleInput {
    let data = data();
    let acc = data.carrier.get("acc-6").unwrap();
    let mut input = msr();
    input.forebody.tps_thickness_m = 0.0266;
    input.forebody.tps_density_kg_m3 = 1450.0;
    input.forebody.carrier = acc.carrier(WallPlace::Forebody);
    input.aftbody_carrier = acc.carrier(WallPlace::Aftbody);
    input.primary_carrier = acc.carrier(WallPlace::Primary);
    input
}

pub(super) fn galahad() -> VehicleInput {
    let mut input = msr();
    input.concept = Concept::NonMsr;
    input.diameter_m = 1.1;
    input.nose_radius_ratio = 0.75;
    input.payload_mass_kg = 9.0;
    input.payload_size = PayloadSize::DiameterM(0.2);
    input.forebody.tps_thickness_m = 0.0221;
    input.loads = Loads {
        entry_load_earth_g: 34.7,
        peak_stagnation_pressure_pa: 20_000.0,
        terminal_speed_m_s: 26.7,
    };
    input.impact.crush_load_limit_earth_g = 1500.0;
    input
}

/// The default run page: 15 kg, the payload 0.6 of the diameter.
fn run_page(concept: Concept) -> VehicleInput {
    let mut input = msr();
    input.concept = concept;
    input.diameter_m = 1.0;
    input.nose_radius_ratio = 0.75;
    input.shoulder_radius_ratio = 0.05;
    input.payload_mass_kg = 15.0;
    input.payload_size = PayloadSize::DiameterRatio(0.6);
    input
}

fn adjusted<'a>(vehicle: &'a Vehicle, key: &str) -> Option<&'a Adjustment> {
    vehicle.adjustments.iter().find(|a| a.key == key)
}

#[test]
fn msr_of_0p9_m_closes_as_asked_at_the_limit_of_the_wing() {
    for mut input in [msr(), msr_carbon()] {
        // an impact sphere of 0.36 m
        input.impact.crush_load_limit_earth_g = 4500.0;
        let vehicle = build(&input).unwrap();
        assert_eq!(vehicle.adjustments, Vec::new());
        assert!((vehicle.dimensions.wing_slope_rad / RADIANS_PER_DEGREE - 30.0).abs() < 1e-6);
        // 12.5 kg at 4000 kg/m³: (6 · 12.5 / 4000 π)^⅓ = 0.18139 m
        assert!((vehicle.dimensions.payload_diameter_m - 0.181_39).abs() < 1e-5);
        // lid, payload and attached structure at one height
        assert_eq!(
            vehicle.dimensions.attached_structure_depth_m,
            vehicle.dimensions.payload_height_m
        );
        assert!((vehicle.dimensions.lid_height_m - vehicle.dimensions.lid_radius_m).abs() < 1e-15);
    }
}

#[test]
fn galahad_closes_as_asked_with_its_lid_at_the_center_of_gravity() {
    let vehicle = build(&galahad()).unwrap();
    assert_eq!(vehicle.adjustments, Vec::new());
    let outline = &vehicle.layout.outline;
    // converged to 1e-7 m
    assert!((outline.lid_center_x_m - vehicle.mass.cg_x_m).abs() < 1e-6);
    assert!(outline.attached_structure_x_m >= outline.lid_center_x_m);
    let inner_top = outline.lid_top_x_m() - vehicle.layout.depths.aft_m();
    let gap = inner_top - (vehicle.layout.payload_x_m + vehicle.layout.payload_radius_m);
    assert!((gap - 0.05).abs() < 1e-6);
    // 28 · 0.825 · 26.7² / M
    let load = 28.0 * 0.825 * 26.7 * 26.7 / vehicle.mass.mass_kg;
    let penetration = vehicle.impact.ground_penetration.unwrap();
    assert!((penetration.load_earth_g - load).abs() < 1e-9);
}

#[test]
fn table_9_adds_up_along_the_axis() {
    // payload 0.1684, foam 0.1767 on both sides together, shell 0.002; aft 0.0275 + 0.0583 + 0.0055 + 0.01
    let mut input = msr_carbon();
    input.diameter_m = 1.05;
    input.nose_radius_ratio = 0.35 / 0.525;
    input.shoulder_radius_ratio = 0.065; // not printed
    input.payload_size = PayloadSize::DiameterM(0.1684);
    input.forebody.tps_thickness_m = 0.0402;
    input.forebody.bond_thickness_m = 0.0;
    input.forebody.carrier_thickness_m = Some(0.0068);
    input.aftbody_carrier.minimum_gauge_m = 0.0055;
    input.primary_carrier.minimum_gauge_m = 0.0081;
    input.densities.impact_foam_kg_m3 = Some(110.0);
    let mut foam = FoamRule::new(&input);
    foam.least_thickness_m = 0.1767 / 2.0;
    let closed = Search::new(&input, &foam).close(1.05).unwrap();
    let layout = &closed.layout;
    assert!((2.0 * layout.impact_sphere_radius_m() - 0.3491).abs() < 1e-12);
    // 0.35 / sin 60 − (0.35 − 0.047) + 0.17455
    assert!((layout.payload_x_m - 0.275_695).abs() < 1e-6);
    assert!((layout.body_foam_thickness_m - 0.0275).abs() < 1e-12);
    assert!((layout.lid_insulation_thickness_m - 0.0583).abs() < 1e-12);
    assert!((layout.outline.lid_radius_m - 0.275_85).abs() < 1e-12);
    assert!(layout.outline.wing_slope_rad < 30.0 * RADIANS_PER_DEGREE);
}

#[test]
fn run_page_grows_to_the_smallest_diameter_that_closes() {
    for concept in [Concept::Msr, Concept::NonMsr] {
        let input = run_page(concept);
        let vehicle = build(&input).unwrap();
        let grown = adjusted(&vehicle, "design.diameter_m").unwrap();
        assert_eq!((grown.from, grown.to), (1.0, vehicle.dimensions.diameter_m));
        assert!(grown.to < 1.75);
        // the payload keeps the size that was asked for
        assert!((vehicle.dimensions.payload_diameter_m - 0.6).abs() < 1e-15);
        let rule = FoamRule::new(&input);
        assert!(Search::new(&input, &rule).close(grown.to - 2e-4).is_err());
    }
}

#[test]
fn shoulder_grows_for_thick_layers_and_shrinks_for_flat_vehicles() {
    let mut thick = msr();
    thick.impact.crush_load_limit_earth_g = 4500.0;
    thick.shoulder_radius_ratio = 0.02;
    let vehicle = build(&thick).unwrap();
    let a = adjusted(&vehicle, "design.shoulder_radius_ratio").unwrap();
    // at 30 deg both sides are parallel: the radius is half of all layers
    let half = (vehicle.layout.depths.fore_m() + vehicle.layout.depths.aft_m()) / 2.0;
    assert!(a.to > a.from && (vehicle.dimensions.shoulder_radius_m - half).abs() < 1e-9);
    let mut flat = msr();
    flat.impact.crush_load_limit_earth_g = 5500.0;
    flat.shoulder_radius_ratio = 0.1;
    let vehicle = build(&flat).unwrap();
    let a = adjusted(&vehicle, "design.shoulder_radius_ratio").unwrap();
    assert!(a.to < a.from);
    assert!(
        (vehicle.layout.body_foam_thickness_m + vehicle.layout.lid_insulation_thickness_m - 0.02)
            .abs()
            < 1e-9
    );
}

#[test]
fn the_margin_is_on_everything_but_the_payload() {
    let vehicle = build(&msr()).unwrap();
    let without = vehicle.mass.mass_without_margin_kg;
    assert!((vehicle.mass.mass_kg - (12.5 + 1.3 * (without - 12.5))).abs() < 1e-12);
    assert!((vehicle.component_mass_kg(ComponentKind::Payload) - 12.5).abs() < 1e-12);
    assert_eq!(vehicle.components.len(), 12);
    let moment: f64 = vehicle
        .components
        .iter()
        .map(|c| c.mass_with_margin_kg * (c.cg_x_m - vehicle.mass.cg_x_m))
        .sum();
    assert!(moment.abs() < 1e-12);
    // a body of revolution: I_xx ≤ 2 I_yy
    assert!(vehicle.mass.ixx_kg_m2 > 0.0 && vehicle.mass.ixx_kg_m2 <= 2.0 * vehicle.mass.iyy_kg_m2);
}

#[test]
fn layers_of_no_thickness_weigh_nothing() {
    let mut input = msr();
    input.forebody.bond_thickness_m = 0.0;
    input.aftbody_tps_thickness_m = 0.0;
    let vehicle = build(&input).unwrap();
    assert_eq!(vehicle.component_mass_kg(ComponentKind::Bond), 0.0);
    assert_eq!(vehicle.component_mass_kg(ComponentKind::AftbodyTps), 0.0);
    assert!((vehicle.mass.volume_m3 / vehicle.outline.solid().volume_m3 - 1.0).abs() < 1e-12);
}

#[test]
fn the_same_input_gives_the_same_bits_and_survives_json() {
    let vehicle = build(&galahad()).unwrap();
    assert_eq!(vehicle, build(&galahad()).unwrap());
    let text = serde_json::to_string(&vehicle).unwrap();
    assert_eq!(serde_json::from_str::<Vehicle>(&text).unwrap(), vehicle);
    let text = serde_json::to_string(&galahad()).unwrap();
    assert_eq!(
        serde_json::from_str::<VehicleInput>(&text).unwrap(),
        galahad()
    );
}

#[test]
fn what_cannot_be_is_not_closed_and_says_why() {
    let mut wide = run_page(Concept::Msr);
    wide.payload_size = PayloadSize::DiameterM(1.9);
    let why = build(&wide).unwrap_err();
    assert!(
        why.reason.contains("2.000 m") && why.at_largest.is_some(),
        "{}",
        why.reason
    );
    type Spoil = fn(&mut VehicleInput);
    let spoil: [(&str, Spoil); 5] = [
        ("diameter_m", |i| i.diameter_m = f64::NAN),
        ("payload_mass_kg", |i| i.payload_mass_kg = -1.0),
        ("shoulder_radius_ratio", |i| i.shoulder_radius_ratio = 0.0),
        ("cone_half_angle_deg", |i| i.cone_half_angle_rad = 0.0),
        ("terminal_speed_m_s", |i| {
            i.loads.terminal_speed_m_s = f64::INFINITY
        }),
    ];
    for (key, change) in spoil {
        let mut input = msr();
        change(&mut input);
        assert!(build(&input).unwrap_err().reason.starts_with(key), "{key}");
    }
}

#[test]
fn every_part_has_a_material_and_the_outside_is_shared_out() {
    for input in [msr(), msr_carbon(), galahad()] {
        let vehicle = build(&input).unwrap();
        assert!(vehicle.components.iter().all(|c| !c.material.is_empty()));
        let wetted: f64 = vehicle.components.iter().map(|c| c.wetted_area_m2).sum();
        let whole = vehicle.dimensions.wetted_area_m2;
        assert!((wetted / whole - 1.0).abs() < 1e-12, "{wetted} of {whole}");
        let payload = vehicle.component(ComponentKind::Payload).unwrap();
        let d = vehicle.dimensions.payload_diameter_m;
        assert!((payload.surface_area_m2 - PI * d * d).abs() < 1e-12);
        assert_eq!(payload.wetted_area_m2, 0.0);
    }
    let foam = |input: &VehicleInput| {
        let vehicle = build(input).unwrap();
        let foam = vehicle.component(ComponentKind::ImpactFoam).unwrap();
        (foam.material.clone(), foam.density_basis)
    };
    assert!(foam(&msr()).0.ends_with("with composite panels"));
    assert_eq!(foam(&msr()).1, DensityBasis::DerivedFromAssumed);
    assert_eq!(foam(&galahad()).1, DensityBasis::Published);
}
