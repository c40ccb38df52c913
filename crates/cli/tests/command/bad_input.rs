//! Each fault is reported with key, value, range and unit; nothing is written; the exit code is 2.

use crate::{Finished, M2, folder, msape, msape_with, path, root};
use std::fs;

#[track_caller]
fn refused(finished: &Finished, said: &str) {
    assert_eq!(finished.code, Some(2), "{}{}", finished.out, finished.err);
    assert!(finished.err.contains(said), "{}", finished.err);
    assert_eq!(finished.out, "");
}

#[test]
fn faulty_values_are_named_with_range_and_unit() {
    let faults = [
        (
            "vehicle.mass_kg=-46",
            "vehicle.mass_kg: got -46 kg, must be above 0 kg",
        ),
        (
            "vehicle.mass_kg=nan",
            "vehicle.mass_kg: got NaN kg, must be above 0 kg",
        ),
        (
            "vehicle.mass_kg=46 m",
            "vehicle.mass_kg: unit \"m\" does not fit here: use one of kg, g, lb, slug",
        ),
        (
            "vehicle.mass_kg=",
            "vehicle.mass_kg: missing; Mass must be above 0 kg",
        ),
        (
            "entry.speed_km_s=12",
            "entry.speed_km_s: unknown key; the nearest known key is entry.speed_m_s, in m/s",
        ),
        ("entry.planet=erth", "did you mean \"earth\"?"),
        (
            "entry.latitude_deg=91",
            "entry.latitude_deg: got 91 deg, must be -90 to 90 deg",
        ),
        ("speed", "--set speed: must be KEY=VALUE"),
    ];
    for (setting, said) in faults {
        refused(&msape(&["fly", M2, "--json", "--set", setting]), said);
    }
}

#[test]
fn all_faults_are_told_at_once() {
    let finished = msape(&[
        "fly",
        M2,
        "--set",
        "vehicle.mass_kg=-1",
        "--set",
        "entry.latitude_deg=100",
        "--set",
        "x=1",
    ]);
    refused(&finished, "vehicle.mass_kg");
    refused(&finished, "entry.latitude_deg");
    refused(&finished, "x: unknown key");
}

#[test]
fn a_design_does_not_start_upwards() {
    let finished = msape(&[
        "design",
        "cases/run-page.toml",
        "--set",
        "entry.flight_path_angle_deg=5",
    ]);
    refused(&finished, "entry.flight_path_angle_deg: got 5 deg");
}

#[test]
fn atmosphere_tables_are_checked() {
    let table = |rows: &str| {
        let case = fs::read_to_string(crate::root().join(M2)).unwrap();
        let case = case.replace("atmosphere = \"us-1976\"\n", "");
        msape_with(
            &["fly", "-"],
            format!("{case}\n[atmosphere]\ntable = {rows}\n").as_bytes(),
        )
    };
    refused(
        &table("[[0.0, 1.2], [2e4, 0.1], [1e4, 0.4]]"),
        "atmosphere.table: row 3",
    );
    refused(
        &table("[[0.0, 1.2], [1e4, -0.4]]"),
        "atmosphere.table: row 2",
    );
    assert_eq!(table("[[0.0, 1.225], [1e5, 5e-7]]").code, Some(0));
}

#[test]
fn files_that_are_no_cases_say_so() {
    let here = folder("no-cases");
    let file = |name: &str, bytes: &[u8]| {
        fs::write(here.join(name), bytes).unwrap();
        msape(&["fly", path(&here.join(name)), "-o", path(&here.join("out"))])
    };
    refused(
        &file("empty.toml", b""),
        "the file is empty; a case starts with schema = \"msape/1\"",
    );
    refused(
        &file("newer.toml", b"schema = \"msape/2\"\n"),
        "the case was written for a newer program",
    );
    refused(
        &file("words.toml", &b"garbage ".repeat(1_250_000)),
        "this is not TOML that can be read",
    );
    refused(
        &file("random.bin", &[0x80; 10_000_000]),
        "is not text: byte 1 is not UTF-8",
    );
    refused(
        &file("open.toml", &b"[".repeat(10_000_000)),
        "this is not TOML that can be read",
    );
    refused(
        &file("deep.json", &b"{\"a\":".repeat(10_000)),
        "this is not JSON that can be read",
    );
    refused(
        &file("deeper.json", &b"{\"a\":".repeat(100_000)),
        "the file holds more than 10000 keys and sections",
    );
    refused(&msape(&["fly", path(&here)]), "is a folder");
    refused(
        &msape(&["fly", "nowhere.toml"]),
        "nowhere.toml: cannot be read",
    );
    refused(&msape_with(&["fly", "-"], b""), "standard input");
    assert!(!here.join("out").exists());
}

#[test]
fn many_faults_are_counted_not_printed() {
    let mut case = String::from("schema = \"msape/1\"\n");
    for i in 0..5_000 {
        case.push_str(&format!("k{i} = 1\n"));
    }
    let finished = msape_with(&["fly", "-"], case.as_bytes());
    refused(&finished, "k0: unknown key");
    refused(&finished, "and 4950 more unknown keys\n");
    assert!(finished.err.lines().count() < 110);
}

#[test]
fn a_terminal_is_not_steered_by_a_case() {
    let finished = msape_with(
        &["fly", "-"],
        b"schema = \"msape/1\"\n[entry]\nplanet = \"\\u001b[2J\"\n",
    );
    refused(&finished, "entry.planet");
    assert!(!finished.err.contains('\u{1b}'));
}

#[test]
fn arguments_are_checked() {
    refused(
        &msape(&["fly", M2, "--trajectory-step", "0"]),
        "must be 0.001 to 100000 s",
    );
    refused(&msape(&["fly", M2, "--trajectory-step", "soon"]), "soon");
    refused(
        &msape(&["fly", M2, "--kml", "--epoch", "tomorrow"]),
        "2006-01-15T09:57:00Z",
    );
    refused(
        &msape(&["fly", M2, "--json", "--csv"]),
        "cannot be used with",
    );
    refused(
        &msape(&["validate", "stardst"]),
        "there is no comparison \"stardst\"",
    );
    refused(
        &msape(&["fly", M2, "-o", "/nowhere/at/all.json"]),
        "cannot write /nowhere/at/all.json",
    );
}

/// In a file and typed: overflow, not a number, a formula, grouped by a sign that may be the decimal sign.
#[test]
fn numbers_without_end_are_refused_and_typed_ones_read() {
    let case = fs::read_to_string(root().join(M2)).unwrap();
    let speed = case
        .lines()
        .find(|line| line.starts_with("speed_m_s"))
        .unwrap();
    for (number, said) in [
        ("1e400", "number overflowed (line"),
        (
            "99999999999999999999",
            "invalid type: integer `99999999999999999999`",
        ),
        ("nan", "entry.speed_m_s: got NaN m/s, must be 0 to"),
        ("inf", "entry.speed_m_s: got inf m/s, must be 0 to"),
        ("1\nspeed_m_s = 2", "duplicate key (line"),
    ] {
        let text = case.replace(speed, &format!("speed_m_s = {number}"));
        refused(&msape_with(&["fly", "-"], text.as_bytes()), said);
    }
    for typed in ["125,000 m", "inf", "nan", "1e400", "=1/0"] {
        let setting = format!("entry.altitude_m={typed}");
        refused(&msape(&["fly", M2, "--set", &setting]), "entry.altitude_m");
    }
    for (key, typed, plain) in [
        ("entry.speed_m_s", "12,9 km/s", "12900"),
        ("entry.flight_path_angle_deg", "-8.2°", "-8.2"),
        ("entry.flight_path_angle_deg", "−8.2", "-8.2"),
    ] {
        let answer = |value: &str| {
            let done = msape(&["fly", M2, "--json", "--set", &format!("{key}={value}")]);
            assert_eq!(done.code, Some(0), "{value}: {}", done.err);
            done.out
        };
        assert_eq!(answer(typed), answer(plain), "{typed}");
    }
}
