//! Layers of the core: each module uses only those below it.

use crate::{assert_none, files};

/// Modules of `crates/msape/src` from the bottom up; each may use only those before it.
const LAYERS: [&str; 22] = [
    "data",
    "progress",
    "units",
    "finding",
    "outcome",
    "quantity",
    "planet",
    "vehicle",
    "aero",
    "heating",
    "shell",
    "tps",
    "soak",
    "library",
    "ablation",
    "flight",
    "design",
    "case",
    "answer",
    "problem",
    "table",
    "validation",
];

/// Modules named after `crate::` in a line of code.
fn named(line: &str) -> Vec<&str> {
    let after = line.split("crate::").skip(1);
    after
        .map(|rest| {
            let end = rest.find(|c: char| !c.is_ascii_alphanumeric() && c != '_');
            &rest[..end.unwrap_or(rest.len())]
        })
        .collect()
}

/// The code of a file without its tests and documentation.
fn code(text: &str) -> impl Iterator<Item = &str> {
    let code = text.split("#[cfg(test)]\nmod tests {").next();
    let lines = code.unwrap_or_default().lines();
    lines.filter(|line| !line.trim_start().starts_with("//"))
}

/// Upward uses, as `file: module`; a module that is not in the list counts as one.
fn upward(path: &str, text: &str) -> Vec<String> {
    let from = path.split(['/', '.']).next().unwrap_or_default();
    let place = LAYERS.iter().position(|layer| *layer == from);
    let allowed = |name: &str| {
        name == from
            || LAYERS
                .iter()
                .position(|layer| *layer == name)
                .zip(place)
                .is_some_and(|(to, from)| to < from)
    };
    let uses = code(text).flat_map(named);
    uses.filter(|name| !allowed(name))
        .map(|name| format!("{path}: crate::{name}"))
        .collect()
}

#[test]
fn no_layer_of_the_core_looks_up() {
    let mut faults = Vec::new();
    for file in files("crates/msape/src") {
        let path = file.path.trim_start_matches("crates/msape/src/");
        let of_tests = path.contains("/tests") || path.ends_with("/sample.rs");
        if path != "lib.rs" && !of_tests {
            faults.extend(upward(path, &file.text));
        }
    }
    assert_none(&faults);
}

#[test]
fn a_layer_that_looks_up_is_found() {
    let up = "use crate::flight::Flight;\nfn f() -> crate::units::Unit {}\n";
    assert_eq!(
        upward("heating/wall.rs", up),
        ["heating/wall.rs: crate::flight"]
    );
    let grouped = "use crate::{Case, vehicle};";
    assert_eq!(upward("flight.rs", grouped), ["flight.rs: crate::"]);
    let in_tests = "#[cfg(test)]\nmod tests {\n    use crate::problem::aero;\n}\n";
    assert!(upward("aero.rs", in_tests).is_empty());
}
