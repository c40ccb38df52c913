//! Source files: headings, lengths, words.

use crate::data::bibliography;
use crate::{File, assert_none, files};

/// Largest number of lines of a source file without its tests.
const MOST_LINES: usize = 400;

fn rust_files() -> Vec<File> {
    ["crates", "web", "tests"]
        .iter()
        .flat_map(|folder| files(folder))
        .filter(|file| file.path.ends_with(".rs"))
        .collect()
}

#[test]
fn no_file_is_longer_than_400_lines_without_its_tests() {
    let lines = |file: &File| {
        let code = file.text.split("#[cfg(test)]\nmod tests {").next();
        code.unwrap_or_default().lines().count()
    };
    let long =
        |file: &File| (lines(file) > MOST_LINES).then(|| format!("{}: {}", file.path, lines(file)));
    assert_none(&rust_files().iter().filter_map(long).collect::<Vec<_>>());
}

/// Folders of the core whose files are physics.
const PHYSICS: [&str; 8] = [
    "ablation", "aero", "flight", "heating", "planet", "soak", "tps", "vehicle",
];

/// Files of these folders without equation: lists of parts, input, assembly.
const NO_EQUATION: [&str; 24] = [
    "ablation.rs",
    "ablation/table.rs",
    "flight.rs",
    "flight/columns.rs",
    "flight/freedom.rs",
    "flight/mission.rs",
    "flight/sample.rs",
    "flight/six_dof/rigid.rs",
    "flight/six_dof/tests.rs",
    "flight/six_dof/tests/flights.rs",
    "flight/summary.rs",
    "flight/trajectory.rs",
    "heating.rs",
    "planet/rows.rs",
    "tps.rs",
    "tps/fit_space.rs",
    "tps/material.rs",
    "vehicle/draft.rs",
    "vehicle/figures.rs",
    "vehicle/input.rs",
    "vehicle/kinds.rs",
    "vehicle/lift.rs",
    "vehicle/remarks.rs",
    "vehicle/rules.rs",
];

/// Crates of physics beside the core.
const BESIDE: [&str; 2] = ["crates/ablation/src", "crates/us1976/src"];

/// Files of these crates without equation.
const BESIDE_WITHOUT_EQUATION: [&str; 6] = [
    "/lib.rs",
    "/definition.rs",
    "/fault.rs",
    "/sample.rs",
    "/stack.rs",
    "/state.rs",
];

#[test]
fn every_physics_file_has_equation_validity_and_references() {
    let mut faults = Vec::new();
    let beside = BESIDE.iter().flat_map(|folder| files(folder));
    let beside = beside.filter(|file| {
        !BESIDE_WITHOUT_EQUATION
            .iter()
            .any(|name| file.path.ends_with(name))
    });
    for file in beside {
        faults.extend(missing_parts(&file));
    }
    for file in files("crates/msape/src") {
        let path = file.path.trim_start_matches("crates/msape/src/");
        let folder = path.split(['/', '.']).next().unwrap_or_default();
        let tests = path.starts_with("vehicle/tests") || path.ends_with("/tests.rs");
        if !PHYSICS.contains(&folder) || NO_EQUATION.contains(&path) || tests {
            continue;
        }
        faults.extend(missing_parts(&file));
    }
    assert_none(&faults);
}

/// Parts of the heading of a physics file that are missing.
fn missing_parts(file: &File) -> Vec<String> {
    let parts = ["//! ```text", "//! # Valid", "//! # References"];
    let missing = parts.iter().filter(|part| !file.text.contains(**part));
    missing
        .map(|part| format!("{}: no {part:?}", file.path))
        .collect()
}

#[test]
fn every_reference_of_a_heading_is_in_the_bibliography() {
    let known = bibliography();
    let mut faults = Vec::new();
    let mut cited = 0;
    for file in rust_files() {
        for line in file.text.lines().filter(|line| line.starts_with("//!")) {
            for rest in line.split("\\[").skip(1) {
                let key = rest.split("\\]").next().unwrap_or_default();
                cited += 1;
                if !known.iter().any(|known| known == key) {
                    faults.push(format!("{}: [{key}]", file.path));
                }
            }
        }
    }
    assert!(cited > 50, "{cited}");
    assert_none(&faults);
}

/// Forbidden words: local paths, promises, addresses of package registries. Split in two, so that this file passes.
const FORBIDDEN: [(&str, &str); 11] = [
    ("/ho", "me/"),
    ("/ro", "ot/"),
    ("/tm", "p/"),
    ("/wo", "rk/"),
    ("../sha", "red"),
    ("TO", "DO"),
    ("FIX", "ME"),
    ("HA", "CK"),
    ("index.crat", "es.io"),
    ("static.crat", "es.io"),
    ("registry.np", "mjs.org"),
];

#[test]
fn no_file_holds_a_forbidden_word() {
    let mut faults = Vec::new();
    for file in files("") {
        // written by cargo, with its registry; checksums may contain any word
        if file.path == "Cargo.lock" || file.path == "package-lock.json" {
            continue;
        }
        for (number, line) in file.text.lines().enumerate() {
            for (start, end) in FORBIDDEN {
                if line.contains(&format!("{start}{end}")) {
                    faults.push(format!("{}:{}: {start}{end}", file.path, number + 1));
                }
            }
        }
    }
    assert_none(&faults);
}
