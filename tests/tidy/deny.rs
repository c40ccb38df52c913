//! Licenses, bans and sources of the crates in `Cargo.lock`, by `deny.toml`, which cargo-deny reads as well.
//!
//! Strict: an entry that is not checked here fails.

use crate::{assert_none, root};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::process::Command;
use std::sync::LazyLock;
use toml::Table;

/// Registry of third-party crates.
const REGISTRY: &str = "registry+https://github.com/rust-lang/crates.io-index";

static RULES: LazyLock<Table> = LazyLock::new(|| {
    let text = std::fs::read_to_string(root().join("deny.toml")).unwrap();
    text.parse().unwrap()
});

fn section(name: &str) -> &'static Table {
    RULES[name].as_table().unwrap()
}

fn words(list: &toml::Value) -> Vec<&str> {
    let list = list.as_array().unwrap();
    list.iter().map(|word| word.as_str().unwrap()).collect()
}

/// Package that is compiled for one of the targets.
struct Package {
    name: String,
    version: String,
    license: Option<String>,
    source: Option<String>,
    /// Names of registry dependencies that accept any version.
    wildcards: Vec<String>,
}

fn text(value: &Value) -> Option<String> {
    value.as_str().map(str::to_string)
}

fn package(value: &Value) -> Package {
    let dependencies = value["dependencies"].as_array().unwrap();
    let wild = dependencies
        .iter()
        .filter(|needed| needed["req"] == "*" && needed["path"].is_null());
    Package {
        name: text(&value["name"]).unwrap(),
        version: text(&value["version"]).unwrap(),
        license: text(&value["license"]),
        source: text(&value["source"]),
        wildcards: wild.filter_map(|needed| text(&needed["name"])).collect(),
    }
}

/// All packages compiled for the targets of `deny.toml`, with all features, by package ID.
static PACKAGES: LazyLock<BTreeMap<String, Package>> = LazyLock::new(|| {
    let mut packages = BTreeMap::new();
    for target in words(&section("graph")["targets"]) {
        let arguments = [
            "metadata",
            "--locked",
            "--all-features",
            "--format-version",
            "1",
        ];
        let output = Command::new(env!("CARGO"))
            .args(arguments)
            .args(["--filter-platform", target])
            .current_dir(root())
            .output()
            .unwrap();
        assert!(
            output.status.success(),
            "{}",
            String::from_utf8_lossy(&output.stderr)
        );
        let metadata: Value = serde_json::from_slice(&output.stdout).unwrap();
        let nodes = metadata["resolve"]["nodes"].as_array().unwrap();
        let used: BTreeSet<Option<&str>> = nodes.iter().map(|node| node["id"].as_str()).collect();
        for value in metadata["packages"].as_array().unwrap() {
            if used.contains(&value["id"].as_str()) {
                packages.insert(text(&value["id"]).unwrap(), package(value));
            }
        }
    }
    packages
});

/// Fault of the license of a package.
fn license_fault(license: Option<&str>, allowed: &[&str]) -> Option<String> {
    let Some(stated) = license else {
        return Some("states no license".to_string());
    };
    // a slash is an old notation for OR
    let mode = spdx::ParseMode {
        allow_slash_as_or_operator: true,
        ..spdx::ParseMode::STRICT
    };
    match spdx::Expression::parse_mode(stated, mode) {
        Ok(expression) => {
            let fits = expression.evaluate(|wanted| allowed.contains(&wanted.to_string().as_str()));
            (!fits).then(|| format!("is under {stated}"))
        }
        Err(error) => Some(format!("states \"{stated}\": {}", error.reason)),
    }
}

#[test]
fn deny_toml_holds_nothing_that_is_not_checked() {
    let checked = [
        ("graph", &["targets", "all-features"][..]),
        ("licenses", &["allow"]),
        (
            "bans",
            &[
                "multiple-versions",
                "wildcards",
                "allow-wildcard-paths",
                "deny",
            ],
        ),
        ("sources", &["unknown-registry", "unknown-git"]),
    ];
    let mut faults = Vec::new();
    for (name, table) in RULES.iter() {
        let known = checked.iter().find(|(section, _)| section == name);
        let known = known.map_or(&[][..], |(_, keys)| keys);
        let unknown = table
            .as_table()
            .unwrap()
            .keys()
            .filter(|key| !known.contains(&key.as_str()));
        faults.extend(unknown.map(|key| format!("deny.toml: {name}.{key} is not checked")));
    }
    for (section_name, key, value) in [
        ("graph", "all-features", toml::Value::Boolean(true)),
        ("bans", "multiple-versions", "warn".into()),
        ("bans", "wildcards", "deny".into()),
        ("bans", "allow-wildcard-paths", toml::Value::Boolean(true)),
        ("sources", "unknown-registry", "deny".into()),
        ("sources", "unknown-git", "deny".into()),
    ] {
        if section(section_name).get(key) != Some(&value) {
            faults.push(format!("deny.toml: {section_name}.{key} must be {value}"));
        }
    }
    assert_none(&faults);
}

#[test]
fn deny_licenses_that_are_not_allowed() {
    let allowed = words(&section("licenses")["allow"]);
    let faults = PACKAGES.values().filter_map(|package| {
        let fault = license_fault(package.license.as_deref(), &allowed)?;
        Some(format!("{} {} {fault}", package.name, package.version))
    });
    assert_none(&faults.collect::<Vec<_>>());
    assert!(PACKAGES.len() > 200, "{} packages", PACKAGES.len());
}

#[test]
fn deny_licenses_of_other_kinds() {
    let allowed = ["MIT", "Apache-2.0"];
    for (stated, fits) in [
        (Some("MIT OR GPL-3.0-only"), true),
        (Some("MIT/Apache-2.0"), true),
        (Some("MIT AND GPL-3.0-only"), false),
        (Some("Apache-2.0 WITH LLVM-exception"), false),
        (Some("LGPL-2.1-or-later"), false),
        (Some("ours"), false),
        (None, false),
    ] {
        assert_eq!(
            license_fault(stated, &allowed).is_none(),
            fits,
            "{stated:?}"
        );
    }
}

#[test]
fn deny_banned_crates_and_any_version() {
    let bans = section("bans")["deny"].as_array().unwrap();
    let mut faults = Vec::new();
    for package in PACKAGES.values() {
        let ban = bans
            .iter()
            .find(|ban| ban["crate"].as_str() == Some(&package.name));
        faults.extend(ban.map(|ban| format!("{} is banned: {}", package.name, ban["reason"])));
        if package.source.is_none() {
            let any = package.wildcards.iter();
            faults.extend(
                any.map(|needed| format!("{} takes any version of {needed}", package.name)),
            );
        }
    }
    assert_none(&faults);
    let mut versions: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
    for package in PACKAGES.values() {
        versions
            .entry(&package.name)
            .or_default()
            .insert(&package.version);
    }
    versions.retain(|_, versions| versions.len() > 1);
    println!("in several versions: {versions:?}");
}

#[test]
fn deny_other_sources() {
    let elsewhere = PACKAGES.values().filter_map(|package| {
        let source = package
            .source
            .as_deref()
            .filter(|source| *source != REGISTRY)?;
        Some(format!("{} comes from {source}", package.name))
    });
    assert_none(&elsewhere.collect::<Vec<_>>());
}
