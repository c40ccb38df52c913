//! Answers in every format.

use crate::{M2, command, folder, msape, msape_with, path, root};
use serde_json::Value;
use std::fs;
use std::io::Read;
use std::process::Stdio;

fn object(text: &str) -> Value {
    serde_json::from_str(text).unwrap()
}

#[test]
fn a_flight_is_answered_as_one_object() {
    let finished = msape(&["fly", M2, "--json", "--trajectory-step", "60"]);
    assert_eq!((finished.code, finished.err.as_str()), (Some(0), ""));
    let answer = object(&finished.out);
    assert_eq!(answer["outcome"], "landed");
    // 29.84381 by an independent integration, within 0.1 %
    let peak = answer["results"]["peak_deceleration_earth_g"]
        .as_f64()
        .unwrap();
    assert!((peak / 29.84381 - 1.0).abs() < 1e-3, "{peak}");
    assert_eq!(
        answer["results"]["peak_radiative_heat_flux_w_m2"],
        Value::Null
    );
    let history = answer["trajectory"].as_object().unwrap();
    let times = history["time_s"].as_array().unwrap();
    assert_eq!(
        (times[0].as_f64(), times[1].as_f64()),
        (Some(0.0), Some(60.0))
    );
    assert_eq!(times.last(), Some(&answer["results"]["time_of_flight_s"]));
    for (key, values) in history {
        assert_eq!(values.as_array().unwrap().len(), times.len(), "{key}");
    }
}

#[test]
fn the_same_bits_come_from_toml_json_and_standard_input() {
    let text = fs::read_to_string(root().join(M2)).unwrap();
    let json = msape::Case::from_text(&text).unwrap().to_json();
    let from_file = msape(&["fly", M2, "--json"]).out;
    assert_eq!(
        msape_with(&["fly", "-", "--json"], text.as_bytes()).out,
        from_file
    );
    assert_eq!(
        msape_with(&["fly", "-", "--json"], json.as_bytes()).out,
        from_file
    );
    let set = msape(&["fly", M2, "--json", "--set", "entry.speed_m_s=12 km/s"]).out;
    assert_eq!(set, from_file);
}

#[test]
fn results_and_history_are_written_as_csv() {
    let report = msape(&["fly", M2, "--csv"]).out;
    let mut reader = csv::Reader::from_reader(report.as_bytes());
    let headers = reader.headers().unwrap().clone();
    let row = reader.records().next().unwrap().unwrap();
    let cell = |name: &str| row[headers.iter().position(|h| h == name).unwrap()].to_string();
    assert_eq!(cell("Entry Velocity (m/s)"), "12000");
    assert_eq!(cell("Outcome"), "landed");
    assert!(cell("Max Entry Load (Earth g)").starts_with("29.84"));
    let si = msape(&["fly", M2, "--csv-si", "--trajectory-step", "100"]).out;
    assert!(si.starts_with("time_s,altitude_m,latitude_deg,"));
    // 0, 100, ... 500 and the end
    assert_eq!(si.lines().count(), 1 + 6 + 1);
}

#[test]
fn a_track_is_written_as_kml() {
    let finished = msape(&["fly", M2, "--kml", "--epoch", "2030-05-01T00:00:00Z"]);
    assert_eq!(finished.code, Some(0));
    assert!(finished.out.starts_with("<?xml"));
    assert!(
        finished
            .out
            .contains("<when>2030-05-01T00:00:00.000Z</when>")
    );
    assert!(finished.out.contains("<name>Peak heating</name>"));
}

#[test]
fn a_file_is_replaced_as_a_whole_or_not_at_all() {
    let here = folder("replace");
    let out = here.join("answer.json");
    fs::write(&out, "before").unwrap();
    let bad = msape(&[
        "fly",
        M2,
        "--json",
        "-o",
        path(&out),
        "--set",
        "vehicle.mass_kg=-1",
    ]);
    assert_eq!(bad.code, Some(2));
    assert_eq!(fs::read_to_string(&out).unwrap(), "before");
    let good = msape(&["fly", M2, "--json", "-o", path(&out)]);
    assert_eq!((good.code, good.out.as_str()), (Some(0), ""));
    assert_eq!(
        fs::read_to_string(&out).unwrap(),
        msape(&["fly", M2, "--json"]).out
    );
    assert_eq!(fs::read_dir(&here).unwrap().count(), 1);
}

#[test]
fn an_atmosphere_file_is_found_beside_the_case() {
    let here = folder("atmosphere");
    let case = fs::read_to_string(root().join(M2)).unwrap();
    let case = case.replace("atmosphere = \"us-1976\"\n", "");
    fs::write(
        here.join("case.toml"),
        format!("{case}\n[atmosphere]\nfile = \"air.csv\"\n"),
    )
    .unwrap();
    fs::write(
        here.join("air.csv"),
        "# two heights\naltitude (km), density (kg/m3)\n0, 1.225\n100, 5e-7\n",
    )
    .unwrap();
    let inline = format!("{case}\n[atmosphere]\ntable = [[0.0, 1.225], [1e5, 5e-7]]\n");
    let of_file = msape(&["fly", path(&here.join("case.toml")), "--json"]);
    assert_eq!((of_file.code, of_file.err.as_str()), (Some(0), ""));
    assert_eq!(
        of_file.out,
        msape_with(&["fly", "-", "--json"], inline.as_bytes()).out
    );
    fs::write(
        here.join("air.csv"),
        "altitude (km), density (kg/m3)\n0, dense\n",
    )
    .unwrap();
    let refused = msape(&["fly", path(&here.join("case.toml")), "--json"]);
    assert_eq!(refused.code, Some(2));
    assert!(refused.err.contains("air.csv: line 2"), "{}", refused.err);
    fs::remove_file(here.join("air.csv")).unwrap();
    let refused = msape(&[
        "fly",
        path(&here.join("case.toml")),
        "--set",
        "vehicle.mass_kg=-1",
    ]);
    assert!(
        refused.err.contains("air.csv: cannot be read") && refused.err.contains("vehicle.mass_kg"),
        "{}",
        refused.err
    );
}

#[test]
fn tables_to_read_name_outcome_and_modules() {
    let finished = msape(&["fly", "cases/stardust.toml"]);
    assert!(
        finished.out.starts_with("Stardust: landed\n"),
        "{}",
        finished.out
    );
    assert!(
        finished.out.contains("\nFlight mechanics\n") && finished.out.contains("\nAerothermal\n")
    );
    assert!(!finished.out.contains('\u{1b}'));
}

#[test]
fn a_reader_that_goes_away_is_no_fault() {
    let mut child = command(&["fly", M2, "--json", "--trajectory-step", "0.01"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut first = [0; 1];
    child.stdout.take().unwrap().read_exact(&mut first).unwrap();
    // the pipe is closed here, with megabytes still to be written
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(0));
    assert!(output.stderr.is_empty());
}

#[test]
fn help_and_lists_come_from_the_quantities() {
    assert!(msape(&["--help"]).out.contains("Examples:"));
    assert!(msape(&["--version"]).out.starts_with("msape "));
    let inputs = msape(&["quantities", "inputs"]).out;
    assert!(
        inputs
            .lines()
            .any(|l| l.starts_with("entry.speed_m_s") && l.contains("0 to 100000"))
    );
    assert!(
        msape(&["quantities", "outputs"])
            .out
            .contains("peak_deceleration_earth_g")
    );
    assert!(
        msape(&["quantities", "trajectory"])
            .out
            .contains("altitude_m")
    );
}

#[test]
fn validation_judges_and_tells_by_its_exit_code() {
    let finished = msape(&["validate", "msape-ref-m2", "stardust", "--json"]);
    assert_eq!(finished.code, Some(0), "{}", finished.out);
    let object = object(&finished.out);
    assert_eq!(object["misses"], 0);
    assert!(object["judged"].as_u64().unwrap() > 15);
    assert!(
        object["rows"]
            .as_array()
            .unwrap()
            .iter()
            .any(|row| row["verdict"] == "shown")
    );
    let table = msape(&["validate", "nesc-06"]).out;
    assert!(
        table.contains("within (1)") && table.contains("Six tools agree within 0.9 ft."),
        "{table}"
    );
}

#[test]
fn an_outline_file_is_found_beside_the_case_and_flies_like_its_points() {
    let here = folder("outline");
    let case = "schema = \"msape/1\"\n[entry]\naltitude_m = 125000.0\nlatitude_deg = 0.0\nlongitude_deg = 0.0\n\
                speed_m_s = 11000.0\nflight_path_angle_deg = -10.0\nazimuth_deg = 90.0\n\
                [vehicle]\nmass_kg = 50.0\ndrag_coefficient = 1.5\nnose_radius_m = 0.2\n";
    let with = |outline: &str| format!("{case}[outline]\n{outline}\n");
    let file = here.join("case.toml");
    fs::write(&file, with("file = \"cone.csv\"")).unwrap();
    fs::write(
        here.join("cone.csv"),
        "x (mm);r (mm)\n0;0\n400;500\n400;0\n",
    )
    .unwrap();
    let of_file = msape(&["fly", path(&file), "--json", "--set", "name=x"]);
    assert_eq!((of_file.code, of_file.err.as_str()), (Some(0), ""));
    let inline = with("points = [[0.0, 0.0], [0.4, 0.5], [0.4, 0.0]]");
    let of_points = msape_with(
        &["fly", "-", "--json", "--set", "name=x"],
        inline.as_bytes(),
    );
    assert_eq!(of_file.out, of_points.out);
    // 2 × 0.5 m across
    let plain = format!("{case}diameter_m = 1.0\n");
    let of_diameter = msape_with(&["fly", "-", "--json", "--set", "name=x"], plain.as_bytes());
    assert_eq!(of_file.out, of_diameter.out);
    for (bad, message) in [
        (
            "x (mm);r (mm)\n0;0\n400;500\n300;-10\n400;0\n",
            "point 3 (x = 0.3 m, r = -0.01 m) is on the other side",
        ),
        (
            "0;0\n400;500\n400;0\n",
            "cone.csv: the file does not say its unit",
        ),
    ] {
        fs::write(here.join("cone.csv"), bad).unwrap();
        let refused = msape(&["fly", path(&file), "--json"]);
        assert_eq!(refused.code, Some(2));
        assert!(refused.err.contains(message), "{}", refused.err);
    }
    let unit = msape(&[
        "fly",
        path(&file),
        "--json",
        "--set",
        "outline.file_unit=mm",
    ]);
    assert_eq!(unit.code, Some(0), "{}", unit.err);
}

#[test]
fn the_facts_of_an_outline_and_a_mass_tree_are_printed() {
    let case = b"schema = \"msape/1\"\n[outline]\ncone_half_angle_deg = 60.0\ndiameter_m = 1.0\nnose_radius_m = 0.375\nshoulder_radius_m = 0.025\n";
    let facts = msape_with(&["outline", "-", "--json"], case);
    assert_eq!((facts.code, facts.err.as_str()), (Some(0), ""));
    let facts: serde_json::Value = serde_json::from_str(&facts.out).unwrap();
    // printed to eight decimals, hence half a unit of the last digit
    let area = facts["outline"]["forebody_area_m2"].as_f64().unwrap();
    assert!((area - 0.934_500_31).abs() < 5.001e-9, "{area}");
    let none = msape(&["outline", M2]);
    assert_eq!(none.code, Some(2));
    assert!(none.err.contains("outline: missing"), "{}", none.err);
    let tree = msape(&["design", "cases/galahad.toml", "--mass-tree"]);
    assert_eq!((tree.code, tree.err.as_str()), (Some(0), ""));
    let mut reader = csv::Reader::from_reader(tree.out.as_bytes());
    let place = |headers: &csv::StringRecord, name| headers.iter().position(|h| h == name).unwrap();
    let mass = place(reader.headers().unwrap(), "mass_kg");
    let rows: Vec<_> = reader.records().map(Result::unwrap).collect();
    let of = |name: &str| {
        let row = rows.iter().find(|row| &row[0] == name).unwrap();
        row[mass].parse::<f64>().unwrap()
    };
    let parts = rows
        .iter()
        .take_while(|row| &row[0] != "Sum without margin");
    let sum: f64 = parts.map(|row| row[mass].parse::<f64>().unwrap()).sum();
    assert_eq!(sum, of("Sum without margin"));
    assert_eq!(sum + of("Margin"), of("Total at entry"));
}
