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

/// Deterministic numbers in 0..1: a multiplicative congruence.
struct Sequence(u64);

impl Sequence {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }
}

fn sampled(sequence: &mut Sequence) -> VehicleInput {
    let mut input = if sequence.next() < 0.5 { msr() } else { msr_carbon() };
    let non_msr = sequence.next() < 0.5;
    if non_msr {
        input.concept = Concept::NonMsr;
        input.impact.crush_load_limit_earth_g = sequence.between(500.0, 2500.0);
    } else {
        input.impact.crush_load_limit_earth_g = sequence.between(1500.0, 4000.0);
    }
    input.diameter_m = sequence.between(0.5, 2.0);
    input.nose_radius_ratio = sequence.between(0.25, 0.9);
    input.shoulder_radius_ratio = sequence.between(0.02, 0.1);
    input.payload_mass_kg = sequence.between(5.0, 30.0);
    input.payload_size = if sequence.next() < 0.5 {
        PayloadSize::DensityKgM3(sequence.between(500.0, 8000.0))
    } else {
        PayloadSize::DiameterRatio(sequence.between(0.2, 0.6))
    };
    input.cone_half_angle_rad = sequence.between(45.0, 70.0) * RADIANS_PER_DEGREE;
    input.forebody.tps_thickness_m = sequence.between(0.01, 0.06);
    input.loads.terminal_speed_m_s = sequence.between(15.0, 50.0);
    input
}

/// Whether a point is inside a closed profile: crossings of the ray towards +x.
fn inside(profile: &Profile, x: f64, r: f64) -> bool {
    use crate::vehicle::segment::Segment;
    let mut crossings = 0;
    for segment in &profile.segments {
        match *segment {
            Segment::Line { start, end } => {
                if (start.r_m > r) != (end.r_m > r) {
                    let at = start.x_m + (r - start.r_m) / (end.r_m - start.r_m) * (end.x_m - start.x_m);
                    crossings += i32::from(at > x);
                }
            }
            Segment::Arc { center, radius_m, start_angle_rad, sweep_rad, .. } => {
                let height = r - center.r_m;
                if height.abs() >= radius_m {
                    continue;
                }
                let half = (radius_m * radius_m - height * height).sqrt();
                for side in [-half, half] {
                    let angle = numerics::math::atan2(height, side);
                    let run = (angle - start_angle_rad) * sweep_rad.signum();
                    let run = run - (run / (2.0 * PI)).floor() * 2.0 * PI;
                    crossings += i32::from(run <= sweep_rad.abs() && center.x_m + side > x);
                }
            }
        }
    }
    crossings % 2 == 1
}

#[test]
fn two_thousand_vehicles_close_or_say_why_and_fill_their_outline() {
    let mut sequence = Sequence(2014);
    let (mut closed, mut grown, mut foam, mut shoulder, mut doubtful, mut points) = (0, 0, 0, 0, 0, 0);
    let mut reasons = std::collections::BTreeMap::new();
    for _ in 0..2000 {
        let input = sampled(&mut sequence);
        let vehicle = match build(&input) {
            Ok(vehicle) => vehicle,
            Err(why) => {
                assert!(why.at_largest.is_some() && !why.reason.is_empty(), "{input:?}");
                *reasons.entry(format!("{:?}", why.at_largest).chars().take(24).collect::<String>()).or_insert(0) += 1;
                continue;
            }
        };
        closed += 1;
        for a in &vehicle.adjustments {
            match a.key.as_str() {
                "design.diameter_m" => grown += 1,
                "foam_thickness_m" => foam += 1,
                _ => shoulder += 1,
            }
        }
        let whole = vehicle.outline.solid().volume_m3;
        let parts = vehicle.mass.volume_m3;
        assert!((parts / whole - 1.0).abs() < 1e-9, "{parts} m³ of parts in {whole} m³: {input:?}");
        for c in &vehicle.components {
            assert!(c.volume_m3 > 0.0, "{:?} has {} m³: {input:?}", c.kind, c.volume_m3);
            for p in &c.profiles {
                for pair in p.segments.windows(2) {
                    let gap = numerics::math::hypot(
                        pair[0].end().x_m - pair[1].start().x_m,
                        pair[0].end().r_m - pair[1].start().r_m,
                    );
                    assert!(gap < 1e-12, "{:?} is open by {gap} m", c.kind);
                }
                assert!(p.segments.iter().all(|s| s.end().r_m >= 0.0));
            }
        }
        // a point inside the outline is in exactly one component, one outside in none
        for _ in 0..20 {
            let d = &vehicle.dimensions;
            let x = d.virtual_apex_ahead_m + sequence.between(-0.05, 1.05) * d.vehicle_height_m;
            let r = sequence.between(0.0, 0.52) * d.diameter_m;
            let count = vehicle.components.iter().flat_map(|c| &c.profiles).filter(|p| inside(p, x, r)).count();
            points += 1;
            if count != usize::from(inside(&vehicle.outline, x, r)) {
                doubtful += 1;
                eprintln!("({x}, {r}) is in {count} components: {:?}", vehicle.layout);
            }
        }
        let slope = vehicle.dimensions.wing_slope_rad / RADIANS_PER_DEGREE;
        assert!((5.0 - 1e-9..=30.0 + 1e-9).contains(&slope), "wing of {slope} deg");
    }
    eprintln!("{closed} closed, {grown} grown, {shoulder} with another shoulder, {foam} with more foam, not closed: {reasons:?}; {points} points, {doubtful} doubtful");
    assert_eq!(doubtful, 0);
    assert!(closed > 1500);
}
