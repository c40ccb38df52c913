//! Embeds the folder `data`, and the cases that ship with the program as its folder `cases`, as sorted lists of
//! (path, text): one of the files that a library is made of, one of the cases, one of what only validation reads.
#![allow(
    clippy::disallowed_methods,
    clippy::disallowed_macros,
    reason = "the script that builds the core is not the core: it reads files and speaks to cargo"
)]

use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::{env, fs, io};

/// A path below `data`, and the file.
type Listed = (String, String);

/// The cases, and what versions of them did otherwise.
const CASES: [&str; 2] = ["cases/", "versions/"];
/// What only validation reads.
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
    let (mut validation, library): (Vec<Listed>, Vec<Listed>) = others
        .into_iter()
        .partition(|file| begins(file, &VALIDATION));
    if env::var_os("CARGO_FEATURE_VALIDATION").is_none() {
        validation.clear();
    }
    write("library_files.rs", &library)?;
    write("case_files.rs", &cases)?;
    write("validation_files.rs", &validation)
}

/// Writes a list as an expression of Rust.
fn write(name: &str, list: &[Listed]) -> io::Result<()> {
    let mut text = String::from("&[\n");
    for (name, file) in list {
        writeln!(text, "    ({name:?}, include_str!({file:?})),").map_err(io::Error::other)?;
    }
    text.push_str("]\n");
    let out = PathBuf::from(env::var("OUT_DIR").map_err(io::Error::other)?).join(name);
    fs::write(out, text)
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
