//! Designs as rigid bodies: `fly` with six degrees of freedom, `reorientation`, `design --reorientation`.

use crate::msape;
use serde_json::Value;

const DESIGN: &str = "cases/msr-eev-cp.toml";

#[test]
fn a_design_flies_as_a_rigid_body_with_its_trajectory() {
    let set = ["--set", "vehicle.dof=6", "--set", "attitude.alpha_deg=145"];
    let mut arguments = vec!["fly", DESIGN, "--json", "--trajectory-step", "5"];
    arguments.extend(set);
    let finished = msape(&arguments);
    assert_eq!((finished.code, finished.err.as_str()), (Some(0), ""));
    let answer: Value = serde_json::from_str(&finished.out).unwrap();
    assert_eq!(answer["outcome"], "landed");
    let initial = answer["results"]["initial_total_alpha_deg"]
        .as_f64()
        .unwrap();
    assert!((initial - 145.0).abs() < 1e-6);
    let alpha = answer["trajectory"]["total_alpha_deg"].as_array().unwrap();
    assert!(alpha.len() > 20);
    let refused = msape(&["fly", DESIGN]);
    assert_eq!(refused.code, Some(2));
    assert!(refused.err.contains("vehicle.dof = 6"), "{}", refused.err);
}

#[test]
fn entries_are_a_table_json_and_csv_with_the_same_numbers() {
    let csv = msape(&["reorientation", DESIGN, "--csv"]);
    assert_eq!((csv.code, csv.err.as_str()), (Some(0), ""));
    let mut lines = csv.out.lines();
    let header = lines.next().unwrap();
    assert!(
        header.starts_with("alpha_deg,pitch_rate_deg_s,facing,"),
        "{header}"
    );
    let rows: Vec<&str> = lines.collect();
    assert_eq!(rows.len(), 9);
    assert!(rows[0].starts_with("175,-2,"), "{}", rows[0]);
    let of_design = msape(&["design", DESIGN, "--reorientation", "--json"]);
    let answer: Value = serde_json::from_str(&of_design.out).unwrap();
    let entries = answer["reorientation"]["entries"].as_array().unwrap();
    let backward = entries.iter().filter(|e| e["facing"] == "backward").count();
    let in_csv = rows.iter().filter(|row| row.contains(",backward,")).count();
    assert_eq!((entries.len(), backward), (9, in_csv));
    let share = answer["results"]["nose_first_share"].as_f64().unwrap();
    assert!((share - (9 - backward) as f64 / 9.0).abs() < 1e-12);
    let trims = answer["stability"]["hypersonic"]["trims"]
        .as_array()
        .unwrap();
    assert_eq!(trims.len(), 4);
}

#[test]
fn a_point_mass_has_no_attitude() {
    let refused = msape(&["reorientation", "cases/stardust.toml"]);
    assert_eq!(refused.code, Some(2));
    assert!(
        refused.err.contains("vehicle.dof: must be 6"),
        "{}",
        refused.err
    );
}
