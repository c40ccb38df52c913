//! Embeds the folder `data`, and the cases that ship with the program as its folder `cases`, as a sorted list of
//! (path, text).
#![allow(
    clippy::disallowed_methods,
    clippy::disallowed_macros,
    reason = "the script that builds the core is not the core: it reads files and speaks to cargo"
)]

use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::{env, fs, io};

fn main() -> io::Result<()> {
    let here = PathBuf::from(env::var("CARGO_MANIFEST_DIR").map_err(io::Error::other)?);
    let mut list = Vec::new();
    embed(&here.join("data"), "", &mut list)?;
    if env::var_os("CARGO_FEATURE_VALIDATION").is_none() {
        let of_validation = [
            "aero-models/mmeev-60-database.csv",
            "predictions/",
            "references.bib",
            "validation/",
        ];
        list.retain(|(name, _)| !of_validation.iter().any(|start| name.starts_with(start)));
    }
    embed(&here.join("../../cases"), "cases/", &mut list)?;
    list.sort();
    let mut text = String::from("&[\n");
    for (name, file) in list {
        writeln!(text, "    ({name:?}, include_str!({file:?})),").map_err(io::Error::other)?;
    }
    text.push_str("]\n");
    let out = PathBuf::from(env::var("OUT_DIR").map_err(io::Error::other)?).join("data_files.rs");
    fs::write(out, text)
}

/// Lists the files of a folder by the name under which the core finds them.
fn embed(root: &Path, prefix: &str, list: &mut Vec<(String, String)>) -> io::Result<()> {
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
