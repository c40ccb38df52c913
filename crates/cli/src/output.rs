//! Output to standard output, or to a file that is replaced only as a whole.

use crate::failure::Failure;
use crate::signal;
use std::fmt;
use std::fs::{self, File, OpenOptions};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

/// Writes text or bytes to the file, or to standard output if there is none.
pub fn write(content: impl AsRef<[u8]>, path: Option<&Path>) -> Result<(), Failure> {
    write_with(path, |out| out.write_all(content.as_ref()))
}

/// Writes text that is generated piece by piece.
pub fn write_text(
    path: Option<&Path>,
    spell: impl FnOnce(&mut dyn fmt::Write) -> fmt::Result,
) -> Result<(), Failure> {
    write_with(path, |out| {
        let mut text = Text { out, error: None };
        match (spell(&mut text), text.error) {
            (_, Some(error)) => Err(error),
            (Err(_), None) => Err(io::Error::other("cannot be spelled")),
            (Ok(()), None) => Ok(()),
        }
    })
}

/// Fails if the output would overwrite a file that was read.
pub fn check(path: Option<&Path>, files: &[PathBuf]) -> Result<(), Failure> {
    let Some(path) = path else {
        return Ok(());
    };
    match files.iter().find(|file| is_same(path, file)) {
        None => Ok(()),
        Some(_) => Err(Failure::input(format!(
            "cannot write {}: it is the case itself, a file that it names, or one of --data",
            path.display()
        ))),
    }
}

#[cfg(unix)]
fn is_same(one: &Path, other: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let identity = |path: &Path| fs::metadata(path).map(|there| (there.dev(), there.ino()));
    matches!((identity(one), identity(other)), (Ok(one), Ok(other)) if one == other)
}

/// Whether a path is a pipe other than standard output.
#[cfg(unix)]
fn is_foreign_pipe(path: &Path) -> bool {
    use std::os::unix::fs::FileTypeExt;
    let is_pipe = fs::metadata(path).is_ok_and(|there| there.file_type().is_fifo());
    is_pipe && !is_same(path, Path::new("/dev/stdout"))
}

#[cfg(not(unix))]
fn is_foreign_pipe(_: &Path) -> bool {
    false
}

#[cfg(not(unix))]
fn is_same(one: &Path, other: &Path) -> bool {
    matches!((fs::canonicalize(one), fs::canonicalize(other)), (Ok(one), Ok(other)) if one == other)
}

/// Adapter from text to a byte writer that keeps the writer's error.
struct Text<'w> {
    out: &'w mut dyn Write,
    error: Option<io::Error>,
}

impl fmt::Write for Text<'_> {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.out.write_all(text.as_bytes()).map_err(|error| {
            self.error = Some(error);
            fmt::Error
        })
    }
}

fn write_with(
    path: Option<&Path>,
    content: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> Result<(), Failure> {
    match path {
        None if msape_stdout::is_closed() => Err(Failure::NoOutput),
        None => {
            let mut out = BufWriter::new(io::stdout().lock());
            content(&mut out)
                .and_then(|()| out.flush())
                .map_err(|error| Failure::writing(&error))
        }
        Some(path) => replace(path, content)
            .map_err(|error| Failure::input(format!("cannot write {}: {error}", path.display()))),
    }
}

fn replace(path: &Path, content: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<()> {
    let there = fs::metadata(path).ok();
    if there.is_none() && fs::symlink_metadata(path).is_ok() {
        return Err(io::Error::other("it is a link to nothing"));
    }
    if there
        .as_ref()
        .is_some_and(|there| !there.is_file() && !there.is_dir())
    {
        if is_foreign_pipe(path) {
            return Err(io::Error::other(
                "it is a pipe, which may have no reader; write to standard output",
            ));
        }
        // a device is written to, not replaced
        let mut out = BufWriter::new(OpenOptions::new().write(true).open(path)?);
        return content(&mut out).and_then(|()| out.flush());
    }
    if there.as_ref().is_some_and(fs::Metadata::is_dir) {
        return Err(io::Error::other("it is a folder"));
    }
    if there
        .as_ref()
        .is_some_and(|there| there.permissions().readonly())
    {
        return Err(io::Error::other("it is read-only"));
    }
    // keep a symbolic link: its target is replaced
    let path = fs::canonicalize(path).unwrap_or_else(|_| path.to_path_buf());
    let beside = beside(&path)?;
    let unfinished = Unfinished::new(&beside);
    let written = File::create_new(&beside).and_then(|file| {
        if let Some(there) = there {
            file.set_permissions(there.permissions())?;
        }
        let mut out = BufWriter::new(file);
        content(&mut out)?;
        out.into_inner()?.sync_all()
    });
    let done = written.and_then(|()| fs::rename(&beside, &path));
    if done.is_err() {
        let _ = fs::remove_file(&beside);
    }
    drop(unfinished);
    done
}

/// Partly written file, which a terminating signal deletes.
struct Unfinished;

static UNFINISHED: Mutex<Option<PathBuf>> = Mutex::new(None);

impl Unfinished {
    fn new(path: &Path) -> Unfinished {
        Self::put(Some(path.to_path_buf()));
        signal::listen();
        Unfinished
    }

    fn put(path: Option<PathBuf>) {
        *UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner) = path;
    }
}

/// Removes the file that is being written.
pub fn leave_nothing_unfinished() {
    let path = UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(path) = path.as_deref() {
        let _ = fs::remove_file(path);
    }
}

impl Drop for Unfinished {
    fn drop(&mut self) {
        Self::put(None);
    }
}

/// An unused name in the same folder.
fn beside(path: &Path) -> io::Result<PathBuf> {
    let name = path
        .file_name()
        .ok_or_else(|| io::Error::other("it is not the name of a file"))?;
    let mut hidden = std::ffi::OsString::from(".");
    hidden.push(name);
    hidden.push(format!(".{}.tmp", std::process::id()));
    Ok(path.with_file_name(hidden))
}
