//! User data files: a folder laid out as `crates/msape/data`.

use super::{bytes, cut, utf8};
use crate::failure::Failure;
use msape::Library;
use std::fs::{self, File};
use std::path::{Path, PathBuf};

/// Largest number of files read from a folder. Assumed: ten times what ships.
const MOST_FILES: usize = 1000;

/// Data available to a command.
pub struct Data {
    /// Built-in library, with the files of the user's folder where one is given.
    pub library: Library,
    /// Files of that folder.
    pub files: Vec<PathBuf>,
}

impl Data {
    /// Reads the files of a folder, if one is given.
    pub fn of(folder: Option<&Path>) -> Result<Data, Failure> {
        let Some(folder) = folder else {
            return Ok(Data {
                library: Library::builtin()?,
                files: Vec::new(),
            });
        };
        let named =
            |fault: String| format!("--data {}: {fault}", cut(&folder.display().to_string()));
        let mut texts = Vec::new();
        collect(folder, "", &mut texts).map_err(|fault| Failure::input(named(fault)))?;
        // the order of directory entries depends on the file system
        texts.sort();
        let library = Library::with_files(&texts).map_err(|faults| {
            let named = faults.iter().map(|fault| named(fault.to_string()));
            Failure::Input(named.collect())
        })?;
        let files = texts.iter().map(|(path, _)| folder.join(path)).collect();
        Ok(Data { library, files })
    }
}

/// Paths relative to the folder, with slashes, and texts; hidden files are left out.
fn collect(folder: &Path, prefix: &str, files: &mut Vec<(String, String)>) -> Result<(), String> {
    let unreadable = |error| match prefix {
        "" => format!("cannot be read: {error}"),
        _ => format!("{prefix} cannot be read: {error}"),
    };
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
        } else if kind.is_dir() {
            return Err(format!("{path}: is a folder in a folder"));
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
    bytes(file).and_then(utf8)
}
