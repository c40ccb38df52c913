//! Whole vehicles: conservation of volume, closing over the trade space, the report's cases.

use super::*;
use crate::vehicle::impact::{Ground, ImpactInput};
use crate::vehicle::rules::WallPlace;
use numerics::math::RADIANS_PER_DEGREE;

fn data() -> VehicleData {
    VehicleData::parse(include_str!("../../data/vehicles/mmeev.toml")).unwrap()
}

/// The MSR vehicle of Table 15 with PICA on honeycomb.
fn msr() -> VehicleInput {
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
        loads: Loads { entry_load_earth_g: 134.0, peak_stagnation_pressure_pa: 130_000.0, terminal_speed_m_s: 39.8 },
        structure_loads: data.structure_loads().unwrap(),
        impact: ImpactInput {
            crush_load_limit_earth_g: 3500.0,
            stroke_efficiency: 0.55,
            ground: Ground::parse(include_str!("../../data/grounds/uttr-clay.toml")).unwrap(),
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

fn galahad() -> VehicleInput {
    let mut input = msr();
    input.concept = Concept::NonMsr;
    input.diameter_m = 1.1;
    input.nose_radius_ratio = 0.75;
    input.payload_mass_kg = 9.0;
    input.payload_size = PayloadSize::DiameterM(0.2);
    input.forebody.tps_thickness_m = 0.0221;
    input.loads =
        Loads { entry_load_earth_g: 34.7, peak_stagnation_pressure_pa: 20_000.0, terminal_speed_m_s: 26.7 };
    input.impact.crush_load_limit_earth_g = 1500.0;
    input
}

fn show(name: &str, vehicle: &Vehicle) {
    let d = &vehicle.dimensions;
    eprintln!(
        "{name}: D {:.4} mass {:.2} kg (before margin {:.2}), cg/D {:.4}, turns {}, wing {:.1} deg, Rs {:.4} (asked {:.4}), lid {:.3}, foam {:.4}, lid ins {:.3}, height {:.3}",
        d.diameter_m,
        vehicle.mass.mass_kg,
        vehicle.mass.mass_without_margin_kg,
        d.cg_over_diameter,
        vehicle.iterations,
        d.wing_slope_rad / RADIANS_PER_DEGREE,
        d.shoulder_radius_m,
        d.input_shoulder_radius_m,
        d.lid_radius_m,
        d.foam_thickness_m,
        d.lid_insulation_thickness_m,
        d.vehicle_height_m
    );
    for c in &vehicle.components {
        eprintln!(
            "   {:28} {:9.6} m3 {:8.1} kg/m3 {:7.3} kg {:7.3} kg",
            c.kind.label(),
            c.volume_m3,
            c.density_kg_m3,
            c.mass_kg,
            c.mass_with_margin_kg
        );
    }
    eprintln!("   {:?}", vehicle.structure);
    for a in &vehicle.adjustments {
        eprintln!("   {} {} -> {}", a.key, a.from, a.to);
    }
}

#[test]
fn print_cases() {
    show("MSR PICA", &build(&msr()).unwrap());
    show("MSR CP", &build(&msr_carbon()).unwrap());
    show("Galahad", &build(&galahad()).unwrap());
    let mut page = msr();
    page.diameter_m = 1.0;
    page.nose_radius_ratio = 0.75;
    page.shoulder_radius_ratio = 0.05;
    page.payload_mass_kg = 15.0;
    page.payload_size = PayloadSize::DiameterRatio(0.6);
    show("page MSR", &build(&page).unwrap());
    page.concept = Concept::NonMsr;
    show("page non-MSR", &build(&page).unwrap());
}
