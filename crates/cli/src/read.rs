//! Reads a case from a file or standard input, with the settings of the command line and the files that the case names.
//!
//! A case may be untrusted: files that it names are read from below its own folder, or below `--root`, and nowhere
//! else. A file named on the command line with `--set` is trusted and may lie anywhere.

mod data;
mod place;

use crate::failure::{Failure, cut, say};
use crate::output;
use crate::source::Source;
use cad::outline::{self, LengthUnit};
use cad::table::{self, Ground, Table};
pub use data::Data;
use msape::case::Value;
use msape::finding::Finding;
use msape::quantity::choice::Choice;
use msape::quantity::input::{self, Input};
use msape::{Case, InputError, Library};
use place::Place;
use std::collections::BTreeSet;
use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

/// Largest file size, bytes.
const SIZE_MAX: u64 = 64 * 1024 * 1024;
const OUTLINE: &Input = &input::outline::FILE;

/// Case with file names replaced by the rows of the files.
pub struct Loaded {
    /// The case.
    pub case: Case,
    /// Faults that do not prevent the check of the case.
    pub faults: Vec<String>,
    /// Messages of the file readers.
    pub remarks: Vec<Remark>,
    /// Files that were read, including the case.
    pub files: Vec<PathBuf>,
}

/// Message of a file reader on a decision or an omission.
pub struct Remark {
    /// Key that names the file.
    key: &'static Input,
    /// Name of the file, and a sentence without its full stop.
    message: String,
}

impl Loaded {
    /// The messages as findings.
    pub fn findings(&self) -> impl Iterator<Item = Finding> + '_ {
        let remarks = self.remarks.iter();
        remarks.map(|Remark { key, message }| Finding::note("file", key, format!("{message}.")))
    }

    /// The value, or the faults of reading and checking the case together.
    pub fn unless_at_fault<T>(&mut self, found: Result<T, Vec<InputError>>) -> Result<T, Failure> {
        let mut faults = std::mem::take(&mut self.faults);
        match found {
            Ok(found) if faults.is_empty() => return Ok(found),
            Ok(_) => {}
            Err(more) => faults.extend(more.iter().map(ToString::to_string)),
        }
        Err(Failure::Input(faults))
    }

    /// Prints the messages on standard error, for output formats that cannot hold them.
    pub fn tell(&self) {
        for Remark { key, message } in &self.remarks {
            say(&format!("note: {key}: {message}"));
        }
    }
}

/// The case of a command; its output must not replace the files of the case or the user's data files.
pub fn asked(source: &Source, output: Option<&Path>, data: &Data) -> Result<Loaded, Failure> {
    let loaded = case(source, &data.library)?;
    output::check(output, &loaded.files)?;
    output::check(output, &data.files)?;
    Ok(loaded)
}

/// The case with the settings of the command line; files that it names may also lie below the root.
fn case(source: &Source, library: &Library) -> Result<Loaded, Failure> {
    let (path, root) = (source.case.as_path(), source.root.as_deref());
    let unreadable = |faults: Vec<InputError>| {
        let named = faults
            .iter()
            .map(|fault| format!("{}: {fault}", display(path)));
        Failure::Input(named.collect())
    };
    let mut case = Case::from_text(&text(path)?).map_err(unreadable)?;
    let mut faults = Vec::new();
    let mut set_here = BTreeSet::new();
    for setting in &source.set {
        match setting.split_once('=') {
            Some(("name", name)) => case.name = name.to_string(),
            Some((key, value)) if !key.trim().is_empty() => {
                case.set(key.trim(), value);
                set_here.insert(key.trim());
            }
            _ => faults.push(format!("--set {}: must be KEY=VALUE", cut(setting))),
        }
    }
    if case.name.is_empty() {
        case.name = title(path);
    }
    let mut loaded = Loaded {
        case,
        faults,
        remarks: Vec::new(),
        files: Vec::new(),
    };
    if !is_standard_input(path) {
        loaded.files.push(path.to_path_buf());
    }
    let place = |input: &Input| {
        if set_here.contains(input.key) {
            Place::Anywhere
        } else {
            Place::Below {
                folder: folder(path),
                root,
            }
        }
    };
    let ground = Ground::of(&loaded.case, library);
    for file in table::files() {
        resolve_table(&mut loaded, file, &place(file), &ground);
    }
    resolve_outline(&mut loaded, &place(OUTLINE));
    Ok(loaded)
}

fn folder(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if !is_standard_input(path) && folder != Path::new("") => folder,
        _ => Path::new("."),
    }
}

fn title(path: &Path) -> String {
    if is_standard_input(path) {
        return String::new();
    }
    path.file_stem()
        .unwrap_or_default()
        .to_string_lossy()
        .into_owned()
}

fn is_standard_input(path: &Path) -> bool {
    path == Path::new("-")
}

fn display(path: &Path) -> String {
    if is_standard_input(path) {
        "standard input".to_string()
    } else {
        path.display().to_string()
    }
}

/// Text of a case: UTF-8, or UTF-16 with byte order mark.
fn text(path: &Path) -> Result<String, Failure> {
    let name = display(path);
    let fault = |message: String| Failure::input(format!("{name}: {message}"));
    if !is_standard_input(path) && path.is_dir() {
        return Err(fault("is a folder; give the file of a case".to_string()));
    }
    // reading a pipe may block or never end
    if !is_standard_input(path) && path.metadata().is_ok_and(|there| !there.is_file()) {
        return Err(fault(
            "is a pipe or a device, not a file; give the case on standard input, as -".to_string(),
        ));
    }
    let bytes = if is_standard_input(path) {
        bytes(io::stdin().lock())
    } else {
        File::open(path)
            .map_err(|error| format!("cannot be read: {error}"))
            .and_then(bytes)
    };
    let bytes = bytes.map_err(fault)?;
    if let [0xff, 0xfe, ..] | [0xfe, 0xff, ..] = bytes.as_slice() {
        return match cad::text::decode(&bytes) {
            Ok(decoded) => Ok(decoded.text),
            Err(error) => Err(fault(error.to_string())),
        };
    }
    utf8(bytes).map_err(fault)
}

fn utf8(bytes: Vec<u8>) -> Result<String, String> {
    String::from_utf8(bytes).map_err(|error| {
        let byte = error.utf8_error().valid_up_to() + 1;
        format!("is not text: byte {byte} is not UTF-8")
    })
}

fn bytes(from: impl Read) -> Result<Vec<u8>, String> {
    let mut bytes = Vec::new();
    from.take(SIZE_MAX + 1)
        .read_to_end(&mut bytes)
        .map_err(|error| format!("cannot be read: {error}"))?;
    if bytes.len() as u64 > SIZE_MAX {
        return Err(format!("is larger than {} MiB", SIZE_MAX >> 20));
    }
    Ok(bytes)
}

impl Loaded {
    /// Removes a key that names a file from the case and reads the file.
    fn file(&mut self, input: &Input, place: &Place) -> Option<(String, Vec<u8>)> {
        let Some(Value::Text(name)) = self.case.values.get(input.key).cloned() else {
            return None;
        };
        self.case.values.remove(input.key);
        let read = place.find(&name).and_then(|path| {
            if path.metadata().is_ok_and(|there| !there.is_file()) {
                return Err("is not a regular file".to_string());
            }
            let file = File::open(&path).map_err(|error| format!("cannot be read: {error}"));
            let bytes = file.and_then(bytes)?;
            self.files.push(path);
            Ok(bytes)
        });
        match read {
            Ok(bytes) => Some((cut(&name), bytes)),
            Err(message) => {
                self.faults
                    .push(format!("{input}: {}: {message}", cut(&name)));
                None
            }
        }
    }

    fn take(&mut self, key: &'static Input, name: &str, table: Table) {
        if self.case.values.contains_key(table.key) {
            let (key, table) = (key, table.key);
            self.faults.push(format!(
                "{key}: there is a {table} as well; give one of them"
            ));
            return;
        }
        self.case
            .values
            .insert(table.key.to_string(), Value::Rows(table.rows));
        let remarks = table.remarks.into_iter().map(|remark| Remark {
            key,
            message: format!("{name}: {remark}"),
        });
        self.remarks.extend(remarks);
    }

    fn refuse<T: ToString>(&mut self, key: &Input, name: &str, found: &[T]) {
        let named = found
            .iter()
            .map(|fault| format!("{key}: {name}: {}", fault.to_string()));
        self.faults.extend(named);
    }
}

/// Replaces the file name of a table by the rows of the file.
fn resolve_table(loaded: &mut Loaded, key: &'static Input, place: &Place, ground: &Ground) {
    let Some((name, bytes)) = loaded.file(key, place) else {
        return;
    };
    match table::read(key, &bytes, ground) {
        Ok(table) => loaded.take(key, &name, table),
        Err(found) => loaded.refuse(key, &name, &found),
    }
}

/// Replaces the file name of an outline by the points of the file.
fn resolve_outline(loaded: &mut Loaded, place: &Place) {
    if !matches!(loaded.case.values.get(OUTLINE.key), Some(Value::Text(_))) {
        return;
    }
    let file_unit = &input::outline::FILE_UNIT;
    let unit = match loaded.case.values.remove(file_unit.key) {
        Some(Value::Text(symbol)) => match outline::unit_of(&symbol) {
            Some(unit) => Some(unit),
            None => {
                loaded.case.values.remove(OUTLINE.key);
                loaded.faults.push(format!(
                    "{file_unit}: got \"{}\", must be one of {}",
                    cut(&symbol),
                    LengthUnit::ALL
                        .iter()
                        .map(|(_, name, _)| *name)
                        .collect::<Vec<_>>()
                        .join(", ")
                ));
                return;
            }
        },
        _ => None,
    };
    let Some((name, bytes)) = loaded.file(OUTLINE, place) else {
        return;
    };
    match outline::read(&name, &bytes, unit) {
        Ok(points) => {
            let table = Table {
                key: input::outline::POINTS.key,
                rows: points.rows,
                remarks: points.remarks,
            };
            loaded.take(OUTLINE, &name, table);
        }
        Err(found) => loaded.refuse(OUTLINE, &name, &found),
    }
}
