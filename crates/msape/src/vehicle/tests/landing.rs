//! The landing of whole vehicles.

use super::*;
use crate::finding::Severity;
use crate::vehicle::impact::crush::{Pulse, PulseEnd, Touchdown, pulse};
use crate::vehicle::impact::landing::{Landing, TouchdownVelocity};
use crate::vehicle::impact::remarks;
use crate::vehicle::impact::soil::Soil;
use numerics::math::FRAC_PI_2;

fn on(ground: &str, mut input: VehicleInput) -> (VehicleInput, Vehicle, Landing) {
    let text = crate::library::data_file(&format!("grounds/{ground}.toml")).unwrap();
    input.impact.ground = Ground::parse(text).unwrap();
    let vehicle = build(&input).unwrap();
    let speed = input.loads.terminal_speed_m_s;
    let landing = Landing::new(&input, &vehicle, TouchdownVelocity::new(speed, -FRAC_PI_2));
    (input, vehicle, landing)
}

fn balanced(pulse: &Pulse) {
    assert_eq!(pulse.end, PulseEnd::Stopped);
    assert!(pulse.energy_residual < 1e-9);
}

#[test]
fn on_a_rigid_surface_the_foam_takes_the_energy_of_the_payload() {
    for input in [msr(), msr_carbon(), galahad()] {
        let speed = input.loads.terminal_speed_m_s;
        let payload_kg = input.payload_mass_kg;
        let (_, vehicle, landing) = on("rigid", input);
        balanced(&landing.rigid_surface);
        assert_eq!(landing.ground, landing.rigid_surface);
        let energy_j = 0.5 * payload_kg * speed * speed;
        assert!((landing.rigid_surface.foam_energy_j / energy_j - 1.0).abs() < 1e-9);
        let rest_j = 0.5 * (vehicle.mass.mass_kg - payload_kg) * speed * speed;
        assert!((landing.rigid_surface.ground_energy_j / rest_j - 1.0).abs() < 1e-12);
        assert_eq!(vehicle.impact.ground_penetration, None);
        assert_eq!(landing.rigid_surface.penetration_m, 0.0);
    }
}

#[test]
fn non_msr_foam_on_its_plateau_has_the_design_load_of_equations_4_and_6() {
    let mut input = galahad();
    // a plateau of 0.50 of the thickness: half of it is used
    input.impact.stroke_efficiency = Some(0.45);
    let (_, vehicle, landing) = on("rigid", input);
    assert!((landing.rigid_surface.peak_load_earth_g / 1500.0 - 1.0).abs() < 1e-9);
    // equation 4, and half of the elastic crush: 1.5 % of the thickness
    let stroke_m = vehicle.impact.required_stroke_m + 0.0075 * landing.absorber.thickness_m;
    assert!((landing.rigid_surface.stroke_m - stroke_m).abs() < 1e-9);
    assert!(landing.densification_margin() > 0.0);
}

#[test]
fn soft_clay_gives_the_payload_the_load_of_equation_1() {
    for input in [msr(), msr_carbon(), galahad()] {
        let (_, vehicle, landing) = on("uttr-clay", input);
        balanced(&landing.ground);
        let equation_1 = vehicle.impact.ground_penetration.unwrap().load_earth_g;
        // the sphere is soft at its first touch: the payload rings on it, without damping
        let ratio = landing.ground.peak_load_earth_g / equation_1;
        assert!((1.0..1.2).contains(&ratio), "{ratio}");
        assert!(landing.ground.peak_load_earth_g < landing.rigid_surface.peak_load_earth_g);
    }
}

#[test]
fn harder_ground_crushes_more_foam() {
    let grounds = [
        "wendover-mud",
        "wet-clay",
        "topsoil",
        "stiff-clay",
        "gravel",
        "cemented-sand",
        "rigid",
    ];
    let strokes = grounds.map(|ground| {
        let (_, _, landing) = on(ground, msr());
        balanced(&landing.ground);
        landing.ground.stroke_m
    });
    assert!(
        strokes.windows(2).all(|pair| pair[0] < pair[1]),
        "{strokes:?}"
    );
}

#[test]
fn foam_or_strength_that_is_said_to_be_needed_is_just_enough() {
    let (input, vehicle, landing) = on("rigid", msr());
    assert!(landing.densification_margin() < 0.0);
    let mut thicker = landing.absorber;
    thicker.thickness_m = landing.foam_needed_m.unwrap();
    let mut stronger = landing.absorber;
    stronger.law.plateau_pa = landing.strength_needed_pa;
    stronger.law.modulus_pa *= landing.strength_needed_pa / landing.absorber.law.plateau_pa;
    for absorber in [thicker, stronger] {
        let pulse = pulse(&Touchdown {
            payload_side_kg: landing.payload_side_kg,
            vehicle_side_kg: 30.0,
            speed_m_s: input.loads.terminal_speed_m_s,
            absorber,
            soil: Soil::Rigid,
        });
        // but for the elastic part of the foam
        assert!((pulse.stroke_m / absorber.plateau_crush_m() - 1.0).abs() < 1e-3);
    }
    let findings = remarks::findings(&vehicle, &landing, &input.impact.ground);
    let keys: Vec<&str> = findings.iter().map(|f| f.key.as_str()).collect();
    assert_eq!(
        keys,
        [
            "foam_densification_margin",
            "rigid_surface_peak_load_earth_g"
        ]
    );
    assert_eq!(findings[1].severity, Severity::Exceeded);
    let needed = format!("{:.0} mm of it", landing.foam_needed_m.unwrap() * 1e3);
    assert!(
        findings[0].message.contains(&needed),
        "{}",
        findings[0].message
    );
}

#[test]
fn the_whole_impact_sphere_crushes_further_than_the_payload() {
    let (_, _, payload) = on("rigid", msr());
    let mut input = msr();
    input.impact.crushing_mass = CrushingMass::ImpactSphere;
    let (_, vehicle, sphere) = on("rigid", input);
    assert!((payload.payload_side_kg - 12.5).abs() < 1e-12);
    let foam = vehicle.component(ComponentKind::ImpactFoam).unwrap();
    let shell = vehicle.component(ComponentKind::ImpactShell).unwrap();
    let mass_kg = 12.5 + foam.mass_with_margin_kg + shell.mass_with_margin_kg;
    assert!((sphere.payload_side_kg - mass_kg).abs() < 1e-12);
    assert!(sphere.rigid_surface.stroke_m > payload.rigid_surface.stroke_m);
}

#[test]
fn wind_at_touchdown_and_ranges_of_the_grounds_are_findings() {
    let (input, vehicle, _) = on("uttr-clay", msr());
    let found = |angle_deg: f64, input: &VehicleInput| {
        let velocity = TouchdownVelocity::new(40.0, -angle_deg * RADIANS_PER_DEGREE);
        let landing = Landing::new(input, &vehicle, velocity);
        remarks::findings(&vehicle, &landing, &input.impact.ground)
    };
    let off_axis = |findings: &[Finding]| {
        let one = findings
            .iter()
            .find(|f| f.key == "impact_off_axis_angle_deg");
        one.map(|f| f.message.clone())
    };
    assert_eq!(off_axis(&found(89.0, &input)), None);
    let message = off_axis(&found(70.0, &input)).unwrap();
    // 40 cos 70° = 13.7 m/s, sin² 20° = 11.7 %
    assert!(
        message.contains("20.0 deg off the vertical, with 13.7 m/s sideways"),
        "{message}"
    );
    assert!(message.contains("11.7 % of its energy"), "{message}");
    let depth = |findings: &[Finding]| {
        let one = findings
            .iter()
            .find(|f| f.key == "estimated_penetration_depth_m");
        one.map(|f| f.message.clone()).unwrap()
    };
    assert!(depth(&found(90.0, &input)).starts_with("Equation 1"));
    let (mud, ..) = on("wendover-mud", msr());
    assert!(depth(&found(90.0, &mud)).starts_with("Young"));
}

#[test]
fn a_wide_payload_in_thin_foam_is_told_that_its_footprint_is_small() {
    let (input, vehicle, landing) = on("rigid", run_page(Concept::Msr));
    let findings = remarks::findings(&vehicle, &landing, &input.impact.ground);
    // π s (2 R − s) over π R_p²
    let (s, r) = (
        landing.absorber.plateau_crush_m(),
        vehicle.dimensions.payload_diameter_m / 2.0,
    );
    let share = s * (2.0 * (r + landing.absorber.thickness_m) - s) / (r * r);
    let expected = format!(
        "the flattened sphere has up to {:.0} % of it.",
        share * 100.0
    );
    assert!(
        share < 0.6 && findings[0].message.ends_with(&expected),
        "{}",
        findings[0].message
    );
}

#[test]
fn a_density_that_is_given_decides_the_plateau() {
    let mut input = galahad();
    input.densities.impact_foam_kg_m3 = Some(110.0);
    let (_, _, landing) = on("rigid", input);
    // Rohacell 110: 3.0 MPa
    assert_eq!(landing.absorber.law.plateau_pa, 3.0e6);
    let area_m2 = landing.absorber.area_m2(0.01);
    let plateau_g = 3.0e6 * area_m2 / (9.0 * EARTH_G_M_S2);
    assert!(landing.rigid_surface.peak_load_earth_g >= plateau_g * (1.0 - 1e-12));
}
