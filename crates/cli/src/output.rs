//! Writes to standard output, or to a file that is replaced only as a whole.

use crate::failure::Failure;
use std::fs::{self, File, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Writes text or bytes to the file, or to standard output when there is none.
pub fn write(content: impl AsRef<[u8]>, path: Option<&Path>) -> Result<(), Failure> {
    let content = content.as_ref();
    match path {
        None => {
            let mut out = io::stdout().lock();
            out.write_all(content)
                .and_then(|()| out.flush())
                .map_err(|error| Failure::writing(&error))
        }
        Some(path) => replace(path, content)
            .map_err(|error| Failure::input(format!("cannot write {}: {error}", path.display()))),
    }
}

fn replace(path: &Path, content: &[u8]) -> io::Result<()> {
    let there = fs::metadata(path).ok();
    if there
        .as_ref()
        .is_some_and(|there| !there.is_file() && !there.is_dir())
    {
        // A device or a pipe is written to, not replaced.
        return OpenOptions::new()
            .write(true)
            .open(path)?
            .write_all(content);
    }
    if there.as_ref().is_some_and(fs::Metadata::is_dir) {
        return Err(io::Error::other("it is a folder"));
    }
    // A link stays: what it points to is replaced.
    let path = fs::canonicalize(path).unwrap_or_else(|_| path.to_path_buf());
    let beside = beside(&path)?;
    let written = File::create_new(&beside).and_then(|mut file| {
        if let Some(there) = there {
            file.set_permissions(there.permissions())?;
        }
        file.write_all(content)?;
        file.sync_all()
    });
    let done = written.and_then(|()| fs::rename(&beside, &path));
    if done.is_err() {
        let _ = fs::remove_file(&beside);
    }
    done
}

/// A name in the same folder that nobody else takes.
fn beside(path: &Path) -> io::Result<PathBuf> {
    let name = path
        .file_name()
        .ok_or_else(|| io::Error::other("it is not the name of a file"))?;
    let mut hidden = std::ffi::OsString::from(".");
    hidden.push(name);
    hidden.push(format!(".{}.tmp", std::process::id()));
    Ok(path.with_file_name(hidden))
}
