//! License texts of the crates linked into the app, as one file beside it.
//!
//! Crates: all dependencies of the browser packages when compiled for the browser, except those used only for building (build
//! scripts, procedural macros and their dependencies). Texts: the files in each crate's source with a usual license
//! name. Equal texts are printed once.

use std::{
    collections::{BTreeMap, BTreeSet},
    fs,
    path::Path,
};

use anyhow::{Context, Result, bail};
use serde_json::Value;

use crate::{
    build,
    project::{Project, announce, files_below},
    setup,
};

/// Name of the file in `dist/`.
const FILE: &str = "licences.txt";

/// Prefixes of the names of license and notice files, in lower case.
const NAMES: [&str; 5] = ["licen", "copying", "notice", "unlicense", "copyright"];

/// Writes the file of licenses.
pub fn write(project: &Project) -> Result<()> {
    announce("Collecting license texts");
    let metadata = metadata(project)?;
    let mut texts: BTreeMap<String, Vec<String>> = BTreeMap::new();
    let mut without = Vec::new();
    for package in linked(&metadata)? {
        let name = format!("{} {}", text(package, "name")?, text(package, "version")?);
        let license = package["license"].as_str().unwrap_or("see its source");
        let manifest = Path::new(text(package, "manifest_path")?);
        let folder = manifest.parent().context("a manifest in no folder")?;
        let found = texts_in(folder)?;
        if found.is_empty() {
            let source = package["repository"].as_str().unwrap_or("no address given");
            without.push(format!("{name} ({license}): {source}"));
        }
        for found in found {
            texts
                .entry(found)
                .or_default()
                .push(format!("{name} ({license})"));
        }
    }
    let own = ["LICENSE-MIT", "LICENSE-APACHE", "NOTICE.md"]
        .map(|name| fs::read_to_string(project.root.join(name)).context(name))
        .into_iter()
        .collect::<Result<Vec<_>>>()?;
    let mut file = format!(
        "M-SAPE is licensed under MIT or Apache-2.0, at your option:\n\n{}\n\nCrates in the app, each with the license it states and the texts in its source.\n",
        own.join("\n\n")
    );
    for (license, names) in &texts {
        let rule = "=".repeat(80);
        file += &format!("\n{rule}\n{}\n{rule}\n\n{license}\n", names.join("\n"));
    }
    if !without.is_empty() {
        file += &format!(
            "\nNo text in the source of these; their license and where they come from:\n{}\n",
            without.join("\n")
        );
    }
    fs::write(project.dist.join(FILE), file).context(FILE)
}

fn metadata(project: &Project) -> Result<Value> {
    let output = project
        .command("cargo")
        .args(["metadata", "--locked", "--format-version", "1"])
        .args(["--filter-platform", setup::WASM])
        .output()
        .context("cannot start cargo metadata")?;
    if !output.status.success() {
        bail!(
            "cargo metadata: {}",
            String::from_utf8_lossy(&output.stderr)
        );
    }
    serde_json::from_slice(&output.stdout).context("cargo metadata")
}

/// Third-party packages linked into the app, by name and version.
fn linked(metadata: &Value) -> Result<Vec<&Value>> {
    let packages: BTreeMap<&str, &Value> = list(metadata, "packages")?
        .iter()
        .map(|package| Ok((text(package, "id")?, package)))
        .collect::<Result<_>>()?;
    let nodes: BTreeMap<&str, &Value> = list(&metadata["resolve"], "nodes")?
        .iter()
        .map(|node| Ok((text(node, "id")?, node)))
        .collect::<Result<_>>()?;
    let mut waiting: Vec<&str> = packages
        .iter()
        .filter(|(_, package)| build::PACKAGES.iter().any(|name| package["name"] == *name))
        .map(|(id, _)| *id)
        .collect();
    let mut seen = BTreeSet::new();
    while let Some(id) = waiting.pop() {
        let package = packages.get(id).context("a package that is not listed")?;
        if only_builds(package)? || !seen.insert(id) {
            continue;
        }
        let node = nodes
            .get(id)
            .context("a package that is not in the graph")?;
        for dependency in list(node, "deps")? {
            let normal = list(dependency, "dep_kinds")?
                .iter()
                .any(|kind| kind["kind"].is_null());
            if normal {
                waiting.push(text(dependency, "pkg")?);
            }
        }
    }
    let mut linked: Vec<&Value> = seen
        .iter()
        .filter_map(|id| packages.get(id).copied())
        .filter(|package| !package["source"].is_null())
        .collect();
    linked.sort_by_key(|package| (package["name"].as_str(), package["version"].as_str()));
    Ok(linked)
}

/// Whether a package is a procedural macro, which runs in the compiler and is not part of the app.
fn only_builds(package: &Value) -> Result<bool> {
    Ok(list(package, "targets")?.iter().any(|target| {
        target["kind"]
            .as_array()
            .is_some_and(|kinds| kinds.iter().any(|kind| kind == "proc-macro"))
    }))
}

/// License texts in a folder and its subfolders, without trailing spaces.
fn texts_in(folder: &Path) -> Result<Vec<String>> {
    let mut texts = Vec::new();
    for file in files_below(folder)? {
        let name = file.file_name().and_then(|n| n.to_str()).unwrap_or("");
        let extension = file.extension().and_then(|e| e.to_str()).unwrap_or("");
        let beginning = NAMES
            .iter()
            .any(|known| name.to_lowercase().starts_with(known));
        if beginning && !matches!(extension, "rs" | "html" | "json" | "py" | "js") {
            let bytes =
                fs::read(&file).with_context(|| format!("cannot read {}", file.display()))?;
            let text = String::from_utf8_lossy(&bytes);
            let lines: Vec<&str> = text.lines().map(str::trim_end).collect();
            texts.push(lines.join("\n").trim().to_string());
        }
    }
    texts.sort();
    texts.dedup();
    Ok(texts)
}

fn list<'a>(value: &'a Value, key: &str) -> Result<&'a Vec<Value>> {
    value[key]
        .as_array()
        .with_context(|| format!("cargo metadata: no list {key:?}"))
}

fn text<'a>(value: &'a Value, key: &str) -> Result<&'a str> {
    value[key]
        .as_str()
        .with_context(|| format!("cargo metadata: no text {key:?}"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn what_only_builds_is_not_linked() {
        let package = |id: &str, kind: &str, source: Value| json!({"id": id, "name": id, "version": "1", "source": source, "targets": [{"kind": [kind]}]});
        let needs = |id: &str, deps: Value| json!({"id": id, "deps": deps});
        let on = |id: &str, kind: Value| json!({"pkg": id, "dep_kinds": [{"kind": kind}]});
        let metadata = json!({
            "packages": [
                package("msape-app", "bin", Value::Null),
                package("math", "lib", json!("registry")),
                package("derive", "proc-macro", json!("registry")),
                package("parser", "lib", json!("registry")),
                package("script", "lib", json!("registry")),
            ],
            "resolve": {"nodes": [
                needs("msape-app", json!([on("math", Value::Null), on("derive", Value::Null), on("script", json!("build"))])),
                needs("math", json!([])),
                needs("derive", json!([on("parser", Value::Null)])),
                needs("parser", json!([])),
                needs("script", json!([])),
            ]},
        });
        let names: Vec<_> = linked(&metadata)
            .unwrap()
            .iter()
            .map(|package| package["name"].as_str().unwrap())
            .collect();
        assert_eq!(names, ["math"]);
    }
}
