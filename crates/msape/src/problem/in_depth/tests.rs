use super::*;
use crate::library::data_file;
use crate::progress::Unwatched;

const SLAB: &str = "schema = 'msape/1'
[tps]
environment_table = [[0.0, 101325.0, 0.0, 0.0], [0.1, 101325.0, 0.3, 1.5e6], [10.0, 101325.0, 0.3, 1.5e6]]
until_s = 12.0
depths_m = [0.001, 0.05]
[[tps.layer]]
material = 'tacot'
thickness_m = 0.05
[[tps.layer]]
density_kg_m3 = 2700.0
specific_heat_j_kgk = 960.0
conductivity_w_mk = 150.0
thickness_m = 0.0016
";

fn faults(text: &str) -> String {
    let library = Library::builtin().unwrap();
    let faults =
        Case::from_text(text).map(|case| InDepthProblem::check(&case, &library).unwrap_err());
    let lines: Vec<String> = faults
        .unwrap_or_else(|faults| faults)
        .iter()
        .map(ToString::to_string)
        .collect();
    lines.join("\n")
}

fn answer(text: &str, ask: Ask) -> InDepth {
    let library = Library::builtin().unwrap();
    in_depth(
        &Case::from_text(text).unwrap(),
        &library,
        ask,
        &mut Unwatched,
    )
    .unwrap()
}

#[test]
fn case_is_answered_with_balances_closed() {
    let answer = answer(SLAB, Ask::Response);
    let account = answer.response.account;
    assert!(
        account.energy_imbalance().abs() < 1e-8 && account.mass_imbalance().abs() < 1e-8,
        "{account:?}"
    );
    assert_eq!(answer.response.history.rows.len(), 13);
    assert_eq!(answer.response.end_s, 12.0);
}

#[test]
fn sized_thickness_keeps_the_limit_at_its_joint() {
    let text = SLAB.replace("until_s = 12.0\n", "bond_limit_k = 450.0\n");
    let answer = answer(&text, Ask::Thickness);
    let thickness = answer.sized.unwrap().thickness_m.unwrap();
    let peak = answer.response.history.behind[0].temperature_k;
    // The search goes without the steps that end at outputs: within the error of a step.
    assert!((peak - 450.0).abs() < 0.1, "{peak}");
    assert!((0.005..0.05).contains(&thickness), "{thickness}");
}

#[test]
fn faults_name_key_value_and_range() {
    for (from, to, said) in [
        (
            "material = 'tacot'",
            "material = 'tacos'",
            "tps.layer.1.material: got \"tacos\", must be one of acc",
        ),
        (
            "material = 'tacot'\n",
            "",
            "tps.layer.1.density_kg_m3: missing; a layer has a material",
        ),
        (
            "thickness_m = 0.0016\n",
            "",
            "tps.layer.2.thickness_m: missing",
        ),
        (
            "[0.1, 101325.0, 0.3",
            "[0.0, 101325.0, 0.3",
            "tps.environment_table: environment: t_s: row 2 is not above",
        ),
        (
            "[0.1, 101325.0, 0.3",
            "[0.1, 101325.0, -0.3",
            "tps.environment_table: row 2, CH_kg_m2s: got -0.3",
        ),
        (
            "[0.1, 101325.0, 0.3",
            "[0.1, 101325.0, nan",
            "row 2, CH_kg_m2s: got NaN, must be a finite number",
        ),
        (
            "until_s = 12.0",
            "bond_layer = 3",
            "tps.bond_layer: got 3, must be 1 to 2",
        ),
        (
            "depths_m = [0.001, 0.05]",
            "depths_m = [0.1]",
            "tps.depths_m: got 0.1 m, must be 0 to 0.0516 m",
        ),
        ("until_s = 12.0", "unit_s = 12.0", "tps.unit_s: unknown key"),
        (
            "until_s = 12.0",
            "geometry = 'spherical'",
            "tps.radius_m: missing",
        ),
    ] {
        assert!(SLAB.contains(from));
        let told = faults(&SLAB.replacen(from, to, 1));
        assert!(told.contains(said), "{told}");
    }
}

#[test]
fn every_fault_is_told_at_once_also_without_an_environment() {
    let text = "schema = 'msape/1'
[tps]
blowing = 5.0
cells = 1
tolerance_k = -1.0
bond_limit_k = -1.0
recession_margin = -1.0
back = 'radiating'
back_emissivity = 2.0
back_film_w_m2k = -1.0
[[tps.layer]]
material = 'tacot'
thickness_m = -1.0
";
    let said = faults(text);
    for key in [
        "blowing",
        "cells",
        "tolerance_k",
        "bond_limit_k",
        "recession_margin",
        "back_emissivity",
        "back_film_w_m2k",
        "layer.1.thickness_m",
        "environment",
    ] {
        assert!(said.contains(&format!("tps.{key}: ")), "{key} in {said}");
    }
}

#[test]
fn the_back_face_has_its_temperature_from_the_start() {
    let text = SLAB.replace("[0.001, 0.05]", "[0.001, 0.05, 0.0516]");
    let rows = answer(&text, Ask::Response).response.history.rows;
    assert_eq!(rows[0].depths_k, [300.0; 3]);
}

#[test]
fn case_of_layers_reads_back_as_written() {
    let case = Case::from_text(SLAB).unwrap();
    assert_eq!(Case::from_toml(&case.to_toml()).unwrap(), case);
    assert_eq!(Case::from_json(&case.to_json()).unwrap(), case);
    assert!(case.to_toml().contains("\n[[tps.layer]]\n"));
}

#[test]
fn burn_through_is_an_outcome_with_its_time() {
    let text = SLAB
        .replacen("thickness_m = 0.05", "thickness_m = 0.001", 1)
        .replace("[0.001, 0.05]", "[0.0005]");
    let answer = answer(&text, Ask::Response);
    assert_eq!(
        answer.response.outcome,
        ::ablation::settings::Outcome::BurntThrough
    );
    // 12 mm a minute: a millimeter is gone after some 5 s.
    assert!(
        (4.0..8.0).contains(&answer.response.end_s),
        "{}",
        answer.response.end_s
    );
}

#[test]
fn flight_without_environment_is_its_own() {
    let text = data_file("cases/stardust.toml").unwrap();
    let layers =
        "\n[tps]\noutput_step_s = 10.0\n[[tps.layer]]\nmaterial = 'pica'\nthickness_m = 0.0582\n";
    let answer = answer(&format!("{text}{layers}"), Ask::Response);
    let history = &answer.response.history;
    assert!(
        (3000.0..3800.0).contains(&history.wall.temperature_k),
        "{:?}",
        history.wall
    );
    assert_eq!(
        answer.response.outcome,
        ::ablation::settings::Outcome::Cooled
    );
    assert!(
        answer
            .findings
            .iter()
            .any(|finding| finding.message.contains("Assumed: kinetics"))
    );
}
