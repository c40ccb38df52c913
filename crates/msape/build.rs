//! Embeds the folder `data`, and the cases that ship with the program as its folder `cases`, as sorted lists of
//! (path, text): one of the files that a library is made of, one of the cases, one of the materials in depth, one of what only validation reads. Those of
//! the library are embedded a second time, with the same keys and values, as JSON: the program reads it several times faster
//! than TOML, and needs no second reader for it, because cases come as JSON too.
#![allow(
    clippy::disallowed_methods,
    clippy::disallowed_macros,
    reason = "the script that builds the core is not the core: it reads files and speaks to cargo"
)]

use serde_json::{Map, Value};
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::{env, fs, io};
use us1976::definition::Definition;
use us1976::heterosphere::Heterosphere;
use us1976::temperature::Upper;

/// A path below `data`, and the file.
type Listed = (String, String);

/// Folders of the shipped cases, and of the defaults of earlier versions.
const CASES: [&str; 2] = ["cases/", "versions/"];
/// Materials in depth, and what only their validation reads.
const ABLATORS: [&str; 2] = ["ablators/", "validation/ablation-"];
/// Files and folders that only validation reads.
const VALIDATION: [&str; 4] = [
    "aero-models/mmeev-60-database.csv",
    "predictions/",
    "references.bib",
    "validation/",
];

fn main() -> io::Result<()> {
    let here = PathBuf::from(env::var("CARGO_MANIFEST_DIR").map_err(io::Error::other)?);
    let mut files = Vec::new();
    embed(&here.join("data"), "", &mut files)?;
    embed(&here.join("../../cases"), "cases/", &mut files)?;
    files.sort();
    let begins =
        |(name, _): &Listed, with: &[&str]| with.iter().any(|start| name.starts_with(start));
    let (cases, others): (Vec<Listed>, _) =
        files.into_iter().partition(|file| begins(file, &CASES));
    let (mut ablators, others): (Vec<Listed>, Vec<Listed>) =
        others.into_iter().partition(|file| begins(file, &ABLATORS));
    let (mut validation, library): (Vec<Listed>, Vec<Listed>) = others
        .into_iter()
        .partition(|file| begins(file, &VALIDATION));
    if env::var_os("CARGO_FEATURE_VALIDATION").is_none() {
        validation.clear();
    }
    if env::var_os("CARGO_FEATURE_PREPARED_AIR").is_some() {
        write_gases(&here.join("data/atmospheres/us-1976.toml"))?;
    }
    if env::var_os("CARGO_FEATURE_ABLATION").is_none() {
        ablators.clear();
    }
    let included = |file: &str| Ok(format!("include_str!({file:?})"));
    write("shipped_files.rs", &library, |file| {
        Ok(format!("{:?}", shipped(file)?.to_string()))
    })?;
    write("library_files.rs", &library, included)?;
    write("case_files.rs", &cases, included)?;
    write("ablator_files.rs", &ablators, included)?;
    write("validation_files.rs", &validation, included)
}

/// Content of a shipped data file as the program reads it: keys and values; of a CSV file headings, `# key: value`, and, as
/// `rows`, its lines by the names of their columns.
fn shipped(file: &str) -> io::Result<Value> {
    let text = fs::read_to_string(file)?;
    let fault = |message: String| io::Error::other(format!("{file}: {message}"));
    if file.ends_with(".toml") {
        return toml::from_str(&text).map_err(|error| fault(error.to_string()));
    }
    let value = |text: &str| match text.trim().parse::<f64>() {
        Ok(number) => Value::from(number),
        Err(_) => Value::from(text.trim()),
    };
    let (headings, lines): (Vec<&str>, Vec<&str>) =
        text.lines().partition(|line| line.starts_with('#'));
    let mut lines = lines.into_iter().map(|line| line.split(','));
    let names: Vec<&str> = lines.next().into_iter().flatten().collect();
    let rows = lines.map(|line| names.iter().map(ToString::to_string).zip(line.map(value)));
    let rows: Vec<Value> = rows.map(|row| Value::Object(row.collect())).collect();
    let mut keys = Map::new();
    for (key, text) in headings.iter().filter_map(|line| line[1..].split_once(':')) {
        keys.entry(key.trim()).or_insert_with(|| value(text));
    }
    keys.insert("rows".to_string(), rows.into());
    Ok(Value::Object(keys))
}

/// Integrates the gases of the U.S. Standard Atmosphere 1976 above 86 km: density, molar mass and their slopes at the knots of each
/// span, behind the definition as it is embedded.
fn write_gases(file: &Path) -> io::Result<()> {
    let fault = |message: String| io::Error::other(format!("{}: {message}", file.display()));
    let embedded = shipped(&file.display().to_string())?.to_string();
    let text = fs::read_to_string(file)?;
    let definition: Definition = toml::from_str(&text).map_err(|error| fault(error.to_string()))?;
    let definition = definition.checked().map_err(fault)?;
    let upper = Upper::new(&definition);
    let mut text = format!("({embedded:?}, &[\n");
    for span in Heterosphere::new(&definition, &upper).knots() {
        let knots = span.density.iter().zip(&span.molar_mass);
        let rows: Vec<[f64; 4]> = knots
            .map(|(rho, m)| [rho.value, rho.slope_per_m, m.value, m.slope_per_m])
            .collect();
        writeln!(text, "    &{rows:?},").map_err(io::Error::other)?;
    }
    text.push_str("])\n");
    write_out("us_1976.rs", &text)
}

fn write_out(name: &str, text: &str) -> io::Result<()> {
    let folder = env::var("OUT_DIR").map_err(io::Error::other)?;
    fs::write(PathBuf::from(folder).join(name), text)
}

/// Writes a list as an expression of Rust, with what `embedded` says of each file.
fn write(
    name: &str,
    list: &[Listed],
    embedded: impl Fn(&str) -> io::Result<String>,
) -> io::Result<()> {
    let mut text = String::from("&[\n");
    for (name, file) in list {
        let content = embedded(file)?;
        writeln!(text, "    ({name:?}, {content}),").map_err(io::Error::other)?;
    }
    text.push_str("]\n");
    write_out(name, &text)
}

/// Lists the files of a folder by the name under which the core finds them.
fn embed(root: &Path, prefix: &str, list: &mut Vec<Listed>) -> io::Result<()> {
    println!("cargo::rerun-if-changed={}", root.display());
    let mut files = Vec::new();
    collect(root, &mut files)?;
    for file in files {
        let relative = file.strip_prefix(root).map_err(io::Error::other)?;
        let name = relative.to_string_lossy().replace('\\', "/");
        list.push((format!("{prefix}{name}"), file.display().to_string()));
    }
    Ok(())
}

fn collect(folder: &Path, files: &mut Vec<PathBuf>) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            collect(&path, files)?;
        } else {
            files.push(path);
        }
    }
    Ok(())
}
