//! Data files: sources that exist, units in names.

use crate::{File, assert_none, files};
use toml::Value;

const BIBLIOGRAPHY: &str = "crates/msape/data/references.bib";

/// Keys of the bibliography, in order.
pub(crate) fn bibliography() -> Vec<String> {
    let file = files("crates/msape/data")
        .into_iter()
        .find(|file| file.path == BIBLIOGRAPHY)
        .unwrap();
    file.text
        .lines()
        .filter_map(|line| line.strip_prefix('@')?.split_once('{'))
        .map(|(_, key)| key.trim_end_matches(',').trim().to_string())
        .collect()
}

#[test]
fn keys_of_the_bibliography_stand_once() {
    let mut keys = bibliography();
    assert!(keys.len() > 30);
    keys.sort();
    let twice: Vec<String> = keys
        .windows(2)
        .filter(|pair| pair[0] == pair[1])
        .map(|pair| pair[0].clone())
        .collect();
    assert_none(&twice);
}

#[test]
fn every_data_file_has_a_source_that_exists() {
    let known = bibliography();
    let mut faults = Vec::new();
    for file in files("crates/msape/data")
        .iter()
        .chain(&files("tests/data"))
    {
        let sources = match file.path.rsplit_once('.') {
            Some((_, "toml")) => toml_sources(file),
            Some((_, "csv")) => csv_sources(file),
            _ => continue,
        };
        if sources.is_empty() {
            faults.push(format!("{}: no source", file.path));
        }
        for source in sources {
            if !known.contains(&source) {
                faults.push(format!(
                    "{}: \"{source}\" is not in references.bib",
                    file.path
                ));
            }
        }
    }
    assert_none(&faults);
}

/// Every `source`, and every key like `gravity_source`; empty if the file itself has none.
fn toml_sources(file: &File) -> Vec<String> {
    let table: toml::Table = toml::from_str(&file.text).unwrap();
    let own = table.contains_key("source") && table.contains_key("place");
    let mut sources = Vec::new();
    for_each("", &Value::Table(table), &mut |path, value| {
        let named = path.rsplit('.').next().unwrap_or(path);
        if let (true, Value::String(text)) = (named.ends_with("source"), value) {
            sources.extend(text.split(';').map(|key| key.trim().to_string()));
        }
    });
    if own { sources } else { Vec::new() }
}

fn csv_sources(file: &File) -> Vec<String> {
    file.text
        .lines()
        .filter_map(|line| line.strip_prefix("# source:"))
        .flat_map(|keys| keys.split(';'))
        .map(|key| key.trim().to_string())
        .collect()
}

/// Visits every leaf with its dotted path.
fn for_each(path: &str, value: &Value, visit: &mut impl FnMut(&str, &Value)) {
    match value {
        Value::Table(table) => {
            for (key, child) in table {
                for_each(&format!("{path}.{key}"), child, visit);
            }
        }
        Value::Array(list) => list.iter().for_each(|child| for_each(path, child, visit)),
        leaf => visit(path, leaf),
    }
}

/// Suffixes of names that state a unit.
const UNITS: [&str; 41] = [
    "_m",
    "_m2",
    "_m3",
    "_km",
    "_cm",
    "_mm",
    "_kg",
    "_s",
    "_m_s",
    "_m_s2",
    "_m3_s2",
    "_m2_s",
    "_km_s",
    "_rad_s",
    "_deg",
    "_k",
    "_k_km",
    "_pa",
    "_atm",
    "_kg_m3",
    "_kg_m2",
    "_w_cm2",
    "_w_m2",
    "_j_cm2",
    "_j_m2",
    "_j_k",
    "_j_kg",
    "_w_m_k",
    "_pa_s",
    "_kg_mol",
    "_per_s",
    "_j_kg_k",
    "_j_kmol_k",
    "_kg_kmol",
    "_per_m3",
    "_per_km3",
    "_per_km",
    "_per_kmol",
    "_per_m2_s",
    "_per_m_s",
    "_g",
];

/// Suffixes of names of numbers without unit.
const PURE: [&str; 16] = [
    "ratio",
    "fraction",
    "exponent",
    "margin",
    "factor",
    "efficiency",
    "emissivity",
    "percent",
    "relative",
    "cap",
    "mach",
    "coefficient",
    "sutton_graves",
    "thermal_diffusion",
    "amplitude",
    "trajectories",
];

/// Printed coefficients, named as in the source; the equation beside them states the units.
const PRINTED: [&str; 27] = [
    "a",
    "b",
    "c",
    "d",
    "e",
    "f",
    "g",
    "k",
    "m",
    "n",
    "p0",
    "p1",
    "p2",
    "j2",
    "j3",
    "j4",
    "alpha",
    "alpha_min",
    "alpha_max",
    "s_number",
    "s_number_min",
    "s_number_max",
    "offset",
    "diffusion_b",
    "largest_x",
    "points",
    "table",
];

/// Numbers with their unit in an adjacent key, such as `unit` of a row.
const BESIDE: [&str; 2] = ["value", "absolute"];

#[test]
fn every_number_states_its_unit() {
    let stated = |name: &str| {
        UNITS.iter().any(|unit| name.ends_with(unit))
            || PURE.iter().any(|end| name.ends_with(end))
            || PRINTED.contains(&name)
    };
    let mut faults = Vec::new();
    for file in files("crates/msape/data") {
        if file.path.ends_with(".toml") {
            let table: toml::Table = toml::from_str(&file.text).unwrap();
            let judged = file.path.contains("/validation/");
            for_each("", &Value::Table(table), &mut |path, value| {
                let number = matches!(value, Value::Float(_) | Value::Integer(_));
                let known = path.split('.').any(stated)
                    || judged
                        && path
                            .rsplit('.')
                            .next()
                            .is_some_and(|name| BESIDE.contains(&name));
                let fault = format!("{}: {path} states no unit", file.path);
                if number && !known && !faults.contains(&fault) {
                    faults.push(fault);
                }
            });
        }
        if file.path.ends_with(".csv") {
            let header = file
                .text
                .lines()
                .find(|line| !line.starts_with('#'))
                .unwrap();
            for name in header.split(',') {
                if !stated(name) && name != "provenance" {
                    faults.push(format!("{}: column {name} states no unit", file.path));
                }
            }
        }
    }
    assert_none(&faults);
}
