//! Allowed places of the files that a case names.

use std::fs;
use std::path::{Component, Path, PathBuf};

/// Place where a file may lie.
pub enum Place<'p> {
    /// Named on the command line: anywhere, relative to the current folder.
    Anywhere,
    /// Named in a case: below its folder, or below the root that the command line allows.
    Below {
        /// Folder of the case.
        folder: &'p Path,
        /// Folder given with `--root`.
        root: Option<&'p Path>,
    },
}

impl Place<'_> {
    /// Path of the file with a name, or the reason why it is not read.
    pub fn find(&self, name: &str) -> Result<PathBuf, String> {
        let found = match self {
            Place::Anywhere => {
                fs::canonicalize(name).map_err(|error| format!("cannot be read: {error}"))?
            }
            Place::Below { folder, root } => below(name, folder, *root)?,
        };
        // reading a pipe may block, a device may have no end
        match fs::metadata(&found) {
            Ok(there) if there.is_file() => Ok(found),
            Ok(there) if there.is_dir() => Err("is a folder".to_string()),
            Ok(_) => Err("is no regular file".to_string()),
            Err(error) => Err(format!("cannot be read: {error}")),
        }
    }
}

fn below(name: &str, folder: &Path, root: Option<&Path>) -> Result<PathBuf, String> {
    let allowed: Vec<PathBuf> = [Some(folder), root]
        .into_iter()
        .flatten()
        .filter_map(|place| fs::canonicalize(place).ok())
        .collect();
    let outside = || {
        let place = root.map_or(
            "the folder of the case",
            |_| "the folder of the case and of --root",
        );
        Err(format!(
            "lies outside of {place}; --root DIR allows another folder"
        ))
    };
    let mut reason = None;
    for place in [Some(folder), root].into_iter().flatten() {
        match fs::canonicalize(place.join(name)) {
            // the canonical path has its links resolved
            Ok(real) if allowed.iter().any(|allowed| real.starts_with(allowed)) => return Ok(real),
            Ok(_) => return outside(),
            Err(error) => reason = reason.or(Some(error)),
        }
    }
    // do not reveal whether a file outside exists
    if root.is_none() && leaves(name) {
        return outside();
    }
    Err(reason.map_or_else(
        || "cannot be read".to_string(),
        |error| format!("cannot be read: {error}"),
    ))
}

/// Whether a name as written leads out of its folder.
fn leaves(name: &str) -> bool {
    let mut depth = 0_i32;
    for component in Path::new(name).components() {
        match component {
            Component::Normal(_) => depth += 1,
            Component::CurDir => {}
            Component::ParentDir => depth -= 1,
            Component::RootDir | Component::Prefix(_) => return true,
        }
        if depth < 0 {
            return true;
        }
    }
    false
}
