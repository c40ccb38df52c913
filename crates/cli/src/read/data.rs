//! Data files of one's own: a folder laid out as `crates/msape/data`.

use super::{bytes, cut};
use crate::failure::Failure;
use msape::Library;
use std::fs::{self, File};
use std::path::Path;

/// Most files of a folder that are read.
const MOST_FILES: usize = 1000;

/// The library that ships with the program, with the files of a folder where one is given.
pub fn library(folder: Option<&Path>) -> Result<Library, Failure> {
    let Some(folder) = folder else {
        return Ok(Library::builtin()?);
    };
    let named = |fault: String| format!("--data {}: {fault}", cut(&folder.display().to_string()));
    let mut files = Vec::new();
    collect(folder, "", &mut files).map_err(|fault| Failure::input(named(fault)))?;
    // The order of a folder is the file system's.
    files.sort();
    Library::with_files(&files).map_err(|faults| {
        let named = faults.iter().map(|fault| named(fault.to_string()));
        Failure::Input(named.collect())
    })
}

/// Paths below the folder, with slashes, and texts; what is hidden is left out.
fn collect(folder: &Path, prefix: &str, files: &mut Vec<(String, String)>) -> Result<(), String> {
    let unreadable = |error| format!("{prefix}: cannot be read: {error}");
    for entry in fs::read_dir(folder).map_err(unreadable)? {
        let entry = entry.map_err(unreadable)?;
        let name = entry.file_name().to_string_lossy().into_owned();
        if name.starts_with('.') {
            continue;
        }
        let path = format!("{prefix}{name}");
        let kind =
            fs::metadata(entry.path()).map_err(|e| format!("{path}: cannot be read: {e}"))?;
        if kind.is_dir() && prefix.is_empty() {
            collect(&entry.path(), &format!("{path}/"), files)?;
        } else if !kind.is_file() {
            return Err(format!("{path}: is no regular file"));
        } else {
            if files.len() == MOST_FILES {
                return Err(format!("holds more than {MOST_FILES} files"));
            }
            files.push((
                path.clone(),
                text(&entry.path()).map_err(|e| format!("{path}: {e}"))?,
            ));
        }
    }
    Ok(())
}

fn text(path: &Path) -> Result<String, String> {
    let file = File::open(path).map_err(|error| format!("cannot be read: {error}"))?;
    let place = |error: std::string::FromUtf8Error| {
        let byte = error.utf8_error().valid_up_to() + 1;
        format!("is not text: byte {byte} is not UTF-8")
    };
    String::from_utf8(bytes(file)?).map_err(place)
}
