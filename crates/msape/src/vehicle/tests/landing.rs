//! The landing of whole vehicles.

use super::*;
use crate::finding::Severity;
use crate::vehicle::impact::crush::{Pulse, PulseEnd, Touchdown, pulse};
use crate::vehicle::impact::landing::{Landing, TouchdownVelocity, rigid_surface_load_earth_g};
use crate::vehicle::impact::remarks;
use crate::vehicle::impact::soil::Soil;
use numerics::math::FRAC_PI_2;

fn on(ground: &str, mut input: VehicleInput) -> (VehicleInput, Vehicle, Landing) {
    let text = crate::library::data_file(&format!("grounds/{ground}.toml")).unwrap();
    input.impact.ground = Ground::parse(text.into()).unwrap();
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

/// The MSR vehicle with the foam of equation 6 as printed: four times the payload's cross-section of footprint.
fn carbon_of_equation_6() -> VehicleInput {
    let mut input = msr_carbon();
    input.payload_size = PayloadSize::DiameterM(0.12);
    input.impact.foam_strength = FoamStrength::Equation6;
    input.rules.diameter_max_m = 3.0;
    input
}

#[test]
fn foam_of_equation_6_over_a_small_payload_is_a_finding() {
    let (input, vehicle, landing) = on("rigid", carbon_of_equation_6());
    let load = landing.rigid_surface.peak_load_earth_g;
    assert!(load > 1.5 * 3500.0, "{load}");
    let findings = remarks::findings(&vehicle, &landing, &input.impact.ground);
    let one = &findings[0];
    assert_eq!(one.key, "rigid_surface_peak_load_earth_g");
    assert_eq!(one.severity, Severity::Exceeded);
    assert_eq!((one.value, one.valid), (Some(load), (None, Some(3500.0))));
    assert_eq!(one.field.as_deref(), Some("design.foam_strength"));
    // from 1 % over the limit
    for (limit, expected) in [(load / 1.009, false), (load / 1.011, true)] {
        let mut vehicle = vehicle.clone();
        vehicle.impact.crush_load_limit_earth_g = limit;
        let findings = remarks::findings(&vehicle, &landing, &input.impact.ground);
        let found = findings.iter().any(|finding| finding.key == one.key);
        assert_eq!(found, expected);
    }
}

#[test]
fn foam_by_the_crush_law_keeps_the_limit_on_its_plateau() {
    for mut input in [msr(), msr_carbon(), galahad(), run_page(Concept::Msr)] {
        for limit in [1500.0, 2500.0, 3500.0] {
            for asked in [None, Some(0.3), Some(0.9)] {
                input.rules.diameter_max_m = 5.0;
                input.impact.crush_load_limit_earth_g = limit;
                input.impact.stroke_efficiency = asked;
                let (_, vehicle, landing) = on("rigid", input.clone());
                let ratio = landing.rigid_surface.peak_load_earth_g / limit;
                assert!(ratio < 1.0 + 1e-6, "{ratio} {asked:?} {:?}", vehicle.impact);
                assert!(landing.densification_margin() > -1e-6);
                // the closed form is the landing in time
                let mass_kg = input.payload_mass_kg;
                let speed = input.loads.terminal_speed_m_s;
                let closed = rigid_surface_load_earth_g(&landing.absorber, mass_kg, speed) / limit;
                assert!((closed / ratio - 1.0).abs() < 1e-6, "{closed} {ratio}");
                // a slab has the load of its limit where its thickness is that of the stroke
                let foam = &vehicle.dimensions.foam_thickness_m;
                if asked != Some(0.3)
                    && *foam < vehicle.impact.required_foam_thickness_m * (1.0 + 1e-9)
                {
                    let least = match input.concept {
                        Concept::Msr => 0.9,
                        Concept::NonMsr => 1.0 - 1e-6,
                    };
                    assert!(ratio > least, "{ratio} {:?}", vehicle.impact);
                }
                let told = vehicle
                    .adjustments
                    .iter()
                    .find(|a| a.key == "design.stroke_efficiency");
                let used = vehicle.impact.stroke_efficiency;
                match asked {
                    Some(0.9) => assert_eq!(told.map(|a| (a.from, a.to)), Some((0.9, used))),
                    _ => assert_eq!(told, None),
                }
                assert!(used <= landing.absorber.law.plateau_strain() + 1e-9);
            }
        }
    }
}

#[test]
fn strength_by_the_crush_law_is_that_of_the_energy_over_the_crushed_volume() {
    let (input, vehicle, landing) = on("rigid", msr());
    let (t, r_p) = (
        vehicle.dimensions.foam_thickness_m,
        vehicle.dimensions.payload_diameter_m / 2.0,
    );
    let s = landing.absorber.law.plateau_strain() * t;
    let volume = PI * s * s * (r_p + t - s / 3.0);
    let energy = 0.5 * 12.5 * 39.8 * 39.8;
    // but for the elastic part
    let ratio = vehicle.impact.foam_strength_pa * volume / energy;
    assert!((ratio - 1.0).abs() < 1e-3, "{ratio}");
    // equation 6 caps it where the foam is thicker than its plateau needs
    let mut input = input;
    input.impact.stroke_efficiency = Some(0.25);
    let (_, vehicle, _) = on("rigid", input);
    let impact = &vehicle.impact;
    assert!(impact.foam_strength_pa <= impact.equation_6_strength_pa);
}

#[test]
fn foam_or_strength_that_is_said_to_be_needed_is_just_enough() {
    let mut input = run_page(Concept::Msr);
    input.impact.foam_strength = FoamStrength::Equation6;
    let (input, vehicle, landing) = on("rigid", input);
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
        assert!((pulse.stroke_m / absorber.plateau_crush_m() - 1.0).abs() < 1e-6);
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
    // which is given with the load of the payload alone in every case
    let load = sphere.rigid_surface.peak_load_earth_g;
    assert!(load > payload.rigid_surface.peak_load_earth_g);
    for landing in [payload, sphere] {
        let beside = landing.sphere_peak_load_earth_g.unwrap();
        assert!((beside / load - 1.0).abs() < 1e-6, "{beside} {load}");
    }
    assert_eq!(on("rigid", galahad()).2.sphere_peak_load_earth_g, None);
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
    let mut input = run_page(Concept::Msr);
    input.impact.foam_strength = FoamStrength::Equation6;
    let (input, vehicle, landing) = on("rigid", input);
    let findings = remarks::findings(&vehicle, &landing, &input.impact.ground);
    // π s (2 R − s) over π R_p²
    let (s, r) = (
        landing.absorber.plateau_crush_m(),
        vehicle.dimensions.payload_diameter_m / 2.0,
    );
    let share = s * (2.0 * (r + landing.absorber.thickness_m) - s) / (r * r);
    let expected = format!(
        "The flattened sphere has up to {:.0} % of the payload's cross-section, all of which equation 6 counts.",
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

/// Beyond the grades two foams take the energy of a small, heavy payload; which one is chosen must not hang on rounding.
#[test]
fn foam_beyond_the_grades_changes_evenly_with_the_speed() {
    let mut input = galahad();
    input.payload_mass_kg = 13.646901621197122;
    input.payload_size = PayloadSize::DensityKgM3(6417.353383284123);
    input.impact.crush_load_limit_earth_g = 4052.141833839635;
    input.impact.stroke_efficiency = None;
    let densities: Vec<f64> = (0..=60)
        .map(|i| {
            input.loads.terminal_speed_m_s = 51.3 + f64::from(i) / 200.0;
            let rule = FoamRule::new(&input);
            rule.at(rule.least_thickness_m).density_kg_m3
        })
        .collect();
    let strongest = densities.iter().copied().fold(0.0, f64::max);
    assert!(strongest > 400.0, "{strongest}");
    for pair in densities.windows(2) {
        assert!((pair[1] / pair[0] - 1.0).abs() < 1e-3, "{pair:?}");
    }
}
