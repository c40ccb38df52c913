//! Designs over the ranges of the report's run page.

use crate::config;
use msape::Outcome;
use msape::answer::outputs;
use msape::quantity::Job;
use msape::{Answer, Case, Library, Request};
use msape_tests::entry::{output, set};
use proptest::prelude::*;
use proptest::sample::select;
use std::sync::LazyLock;

pub(crate) static LIBRARY: LazyLock<Library> = LazyLock::new(|| Library::builtin().unwrap());

/// A case of the run page.
pub(crate) fn run_page() -> impl Strategy<Value = Case> {
    let concepts = LIBRARY.concepts.iter().map(|(name, _)| name.clone());
    let aft = LIBRARY.aftbody_materials().map(|(name, _)| name.clone());
    let payload = prop_oneof![
        (500.0..8_000.0).prop_map(|x| ("design.payload_density_kg_m3", x)),
        (0.2..0.6).prop_map(|x| ("design.payload_diameter_ratio", x)),
    ];
    let numbers = (
        10_000.0..16_000.0,
        -30.0..-5.5,
        0.5..2.0,
        0.25..0.9,
        0.02..0.1,
        5.0..20.0,
        0.0..1.0,
        500.0..5_000.0,
    );
    (
        numbers,
        payload,
        any::<bool>(),
        select(concepts.collect::<Vec<_>>()),
        select(aft.collect::<Vec<_>>()),
    )
        .prop_map(|(numbers, payload, msr, concept, aft)| {
            let mut case = Case::run_page();
            case.set("design.payload_diameter_ratio", "");
            let (speed, angle, diameter, nose, shoulder, mass, margin, crush) = numbers;
            for (key, value) in [
                ("entry.speed_m_s", speed),
                ("entry.flight_path_angle_deg", angle),
                ("design.diameter_m", diameter),
                ("design.nose_radius_ratio", nose),
                ("design.shoulder_radius_ratio", shoulder),
                ("design.payload_mass_kg", mass),
                ("design.mass_margin", margin),
                ("design.crush_load_limit_earth_g", crush),
                payload,
            ] {
                set(&mut case, key, value);
            }
            case.set("design.msr_mode", &msr.to_string());
            case.set("design.forebody_tps", &concept);
            case.set("design.aftbody_tps", &aft);
            case
        })
}

pub(crate) fn given(case: &Case, key: &str) -> f64 {
    case.text(key).unwrap().parse().unwrap()
}

/// Mass, volume and margin add up.
pub(crate) fn adds_up(case: &Case, answer: &Answer) -> Result<(), TestCaseError> {
    let vehicle = &answer.design.as_ref().unwrap().vehicle;
    let payload_kg = given(case, "design.payload_mass_kg");
    let margin = given(case, "design.mass_margin");
    let parts_kg: f64 = vehicle.components.iter().map(|part| part.mass_kg).sum();
    let close = |a: f64, b: f64| (a - b).abs() <= 1e-9 * b.abs();
    prop_assert!(close(parts_kg, vehicle.mass.mass_without_margin_kg));
    let with_margin_kg = payload_kg + (parts_kg - payload_kg) * (1.0 + margin);
    prop_assert!(close(with_margin_kg, output(answer, "total_entry_mass_kg")));
    let whole_m3 = vehicle.outline.solid().volume_m3;
    let parts_m3: f64 = vehicle.components.iter().map(|part| part.volume_m3).sum();
    prop_assert!(close(parts_m3, whole_m3), "{} {}", parts_m3, whole_m3);
    for part in &vehicle.components {
        prop_assert!(part.mass_kg > 0.0, "{:?}", part.kind);
        prop_assert!(close(part.mass_kg, part.volume_m3 * part.density_kg_m3));
    }
    Ok(())
}

/// Each change is reported with the requested and the actual value.
fn changes_are_reported(case: &Case, answer: &Answer) -> Result<(), TestCaseError> {
    let radius_m = 0.5 * output(answer, "diameter_m");
    for (key, used) in [
        ("design.diameter_m", 2.0 * radius_m),
        (
            "design.shoulder_radius_ratio",
            output(answer, "shoulder_radius_m") / radius_m,
        ),
        (
            "design.nose_radius_ratio",
            output(answer, "nose_radius_m") / radius_m,
        ),
    ] {
        let asked = given(case, key);
        let told = answer.adjustments.iter().rfind(|a| a.key == key);
        match told {
            Some(told) => {
                prop_assert!(
                    (told.to - used).abs() < 1e-9,
                    "{} to {}: {}",
                    key,
                    told.to,
                    used
                );
                prop_assert!(!told.reason.is_empty() && !told.source.is_empty());
            }
            None => prop_assert!((asked - used).abs() < 1e-9, "{} {} {}", key, asked, used),
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(config(200))]

    #[test]
    fn a_design_ends_adds_up_and_tells_what_it_changed(case in run_page()) {
        let answer = msape::design(&case, &LIBRARY, Request::Nothing).unwrap();
        match answer.outcome {
            Outcome::NotClosed | Outcome::SkippedOut | Outcome::Captured => {
                prop_assert!(answer.design.is_none());
                prop_assert!(answer.reason.is_some_and(|reason| reason.len() > 20));
                return Ok(());
            }
            Outcome::Converged => {
                let last_kg = output(&answer, "mass_residual_kg");
                prop_assert!(last_kg.abs() < given(&case, "design.mass_criterion_kg"));
            }
            _ => prop_assert!(answer.reason.is_some(), "{:?} without a reason", answer.outcome),
        }
        adds_up(&case, &answer)?;
        changes_are_reported(&case, &answer)?;
        for output in outputs(Job::Design) {
            let value = (output.get)(&answer);
            prop_assert!(value.is_none_or(f64::is_finite), "{}: {:?}", output.key, value);
        }
        for (i, pass) in answer.passes.iter().enumerate() {
            prop_assert_eq!(pass.number as usize, i + 1);
        }
    }

    #[test]
    fn the_same_case_gives_the_same_bits_again(case in run_page()) {
        let text = |answer: &Answer| serde_json::to_string(answer).unwrap();
        let [one, other] = [(); 2].map(|()| msape::design(&case, &LIBRARY, Request::Nothing).unwrap());
        prop_assert_eq!(text(&one), text(&other));
    }
}
