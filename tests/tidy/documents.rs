//! Documents: their commands and links, and the keys named in answers.

use crate::{assert_none, files, root};
use msape::answer::output;
use msape::flight::columns;
use msape::quantity::input;
use msape::{Library, Request};
use msape_tests::shipped;
use std::fs;

fn text(path: &str) -> String {
    fs::read_to_string(root().join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

#[test]
fn the_documents_are_there() {
    for path in [
        "README.md",
        "ARCHITECTURE.md",
        "CHANGELOG.md",
        "LICENSE-MIT",
        "LICENSE-APACHE",
        "NOTICE.md",
    ] {
        assert!(!text(path).trim().is_empty(), "{path}");
    }
}

#[test]
fn commands_and_links_of_the_documents_exist() {
    let xtask = text("crates/xtask/src/main.rs");
    let arguments = text("crates/cli/src/args.rs").to_lowercase();
    let mut faults = Vec::new();
    for path in ["README.md", "ARCHITECTURE.md"] {
        let document = text(path);
        for command in after(&document, "cargo xtask ") {
            if !xtask.contains(&format!("[\"{command}\"")) && command != "help" {
                faults.push(format!("{path}: cargo xtask {command}"));
            }
        }
        for command in after(&document, "`msape ").chain(after(&document, "    msape ")) {
            let variant = command.replace('-', "");
            if !arguments.contains(&format!("\n    {variant}(")) && command != "help" {
                faults.push(format!("{path}: msape {command}"));
            }
        }
        for link in document.split("](").skip(1) {
            let link = link.split([')', '#']).next().unwrap_or_default();
            let local = !link.is_empty() && !link.contains("://");
            if local && !root().join(link).exists() {
                faults.push(format!("{path}: {link} is not there"));
            }
        }
        for name in after(&document, "cases/") {
            let folder = root().join("cases").join(name).is_dir();
            if !folder && !root().join("cases").join(format!("{name}.toml")).exists() {
                faults.push(format!("{path}: cases/{name}"));
            }
        }
    }
    assert_none(&faults);
}

/// The word after each occurrence of some text, of letters, digits and hyphens; empty ones omitted.
fn after<'a>(document: &'a str, start: &'a str) -> impl Iterator<Item = &'a str> {
    document
        .split(start)
        .skip(1)
        .map(|rest| {
            let end = rest.find(|c: char| !c.is_ascii_alphanumeric() && c != '-');
            end.map_or(rest, |end| &rest[..end])
        })
        .filter(|word| !word.is_empty())
}

/// Each name must occur in an example of the documentation, which `cargo test` compiles and runs.
#[test]
fn every_name_that_the_core_exports_stands_in_an_example() {
    let library = text("crates/msape/src/lib.rs");
    let exported = library
        .lines()
        .filter_map(|line| line.strip_prefix("pub use ")?.rsplit_once("::"))
        .flat_map(|(_, names)| names.trim_matches(['{', '}', ';']).split(','));
    let functions = library
        .lines()
        .filter_map(|line| Some(line.strip_prefix("pub fn ")?.split_once('(')?.0));
    let names: Vec<&str> = exported.chain(functions).map(str::trim).collect();
    assert!(names.len() >= 8, "{names:?}");
    let sources = files("crates/msape/src");
    let examples: Vec<&str> = sources
        .iter()
        .flat_map(|file| examples(&file.text))
        .collect();
    let stands = |name: &str| {
        let mut words = examples
            .iter()
            .flat_map(|line| line.split(|c: char| !c.is_alphanumeric() && c != '_'));
        words.any(|word| word == name)
    };
    let without = names.into_iter().filter(|name| !stands(name));
    assert_none(&without.map(str::to_string).collect::<Vec<_>>());
}

/// Lines of Rust in fenced code of documentation.
fn examples(source: &str) -> Vec<&str> {
    let mut inside = false;
    let mut lines = Vec::new();
    for line in source.lines().map(str::trim_start) {
        let Some(line) = line.strip_prefix("///").or(line.strip_prefix("//!")) else {
            inside = false;
            continue;
        };
        match line.trim() {
            fence if fence.starts_with("```") => inside = !inside && fence == "```",
            code if inside => lines.push(code),
            _ => {}
        }
    }
    lines
}

#[test]
fn findings_and_adjustments_speak_of_known_quantities() {
    let known = |key: &str| {
        input::find(key).is_some() || output::find(key).is_some() || columns::find(key).is_some()
    };
    let library = Library::builtin().unwrap();
    let mut faults = Vec::new();
    let mut seen = 0;
    for case in shipped::cases().unwrap() {
        let answer = case.solve(&library, Request::Nothing).unwrap();
        for finding in &answer.findings {
            seen += 1;
            if !finding.key.is_empty() && !known(&finding.key) {
                faults.push(format!(
                    "{}: finding of {}: key {}",
                    case.name, finding.model, finding.key
                ));
            }
            if let Some(field) = finding
                .field
                .as_ref()
                .filter(|key| input::find(key).is_none())
            {
                faults.push(format!(
                    "{}: finding of {}: field {field}",
                    case.name, finding.model
                ));
            }
            if finding.source.is_empty() || !finding.message.ends_with('.') {
                faults.push(format!(
                    "{}: finding without source or sentence: {}",
                    case.name, finding.message
                ));
            }
        }
        for adjustment in &answer.adjustments {
            seen += 1;
            if input::find(&adjustment.key).is_none() {
                faults.push(format!("{}: adjustment of {}", case.name, adjustment.key));
            }
        }
    }
    assert!(seen > 20, "{seen}");
    assert_none(&faults);
}

/// Function names in backquotes, in the last cell of each row of a table.
#[test]
fn every_test_that_the_table_of_faults_names_is_there() {
    let sources: Vec<_> = ["crates", "tests", "web"]
        .into_iter()
        .flat_map(files)
        .collect();
    let exists = |name: &str| {
        let function = format!("fn {name}(");
        sources.iter().any(|file| file.text.contains(&function))
    };
    let table = text("docs/faults.md");
    let names = table
        .lines()
        .filter_map(|line| line.strip_suffix(" |")?.rsplit_once("| "));
    let names: Vec<&str> = names
        .flat_map(|(_, cell)| cell.split('`').skip(1).step_by(2))
        .collect();
    assert!(names.len() > 40, "{} names", names.len());
    let missing = names.into_iter().filter(|name| !exists(name));
    assert_none(&missing.map(str::to_string).collect::<Vec<_>>());
}
