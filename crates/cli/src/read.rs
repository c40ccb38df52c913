//! Reads a case from a file or from standard input, with what the command line sets and the files it names.

use crate::failure::{Failure, printable};
use cad::outline::{self, Imported, LengthUnit};
use cad::table::atmosphere::{self, Kind};
use msape::case::Value;
use msape::{Case, InputError};
use std::fs::File;
use std::io::{self, Read, Write};
use std::path::Path;

/// Largest file that is read.
const SIZE_MAX: u64 = 64 * 1024 * 1024;

/// The case of `path` with `settings` applied, and faults found on the way that do not keep it from being checked.
pub fn case(path: &Path, settings: &[String]) -> Result<(Case, Vec<String>), Failure> {
    let unreadable = |faults: Vec<InputError>| {
        let named = faults
            .iter()
            .map(|fault| format!("{}: {fault}", display(path)));
        Failure::Input(named.collect())
    };
    let mut case = Case::from_text(&text(path)?).map_err(unreadable)?;
    let mut faults = Vec::new();
    let [mut air_here, mut outline_here] = [folder(path); 2];
    for setting in settings {
        match setting.split_once('=') {
            Some(("name", name)) => case.name = name.to_string(),
            Some((key, value)) if !key.trim().is_empty() => {
                case.set(key.trim(), value);
                // Named on the command line, a file is looked for from where the command is given.
                match key.trim() {
                    "atmosphere.file" => air_here = Path::new(""),
                    "outline.file" => outline_here = Path::new(""),
                    _ => {}
                }
            }
            _ => faults.push(format!("--set {setting}: must be KEY=VALUE")),
        }
    }
    if case.name.is_empty() {
        case.name = title(path);
    }
    resolve_atmosphere(&mut case, air_here, &mut faults);
    resolve_outline(&mut case, outline_here, &mut faults);
    resolve_aerodynamics(&mut case, folder(path), &mut faults);
    Ok((case, faults))
}

fn folder(path: &Path) -> &Path {
    if is_standard_input(path) {
        return Path::new("");
    }
    path.parent().unwrap_or(Path::new(""))
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

/// The text of a file, or of standard input for `-`.
fn text(path: &Path) -> Result<String, Failure> {
    String::from_utf8(bytes(path)?).map_err(|error| {
        Failure::input(format!(
            "{}: is not text: byte {} is not UTF-8",
            display(path),
            error.utf8_error().valid_up_to() + 1
        ))
    })
}

/// The bytes of a file, or of standard input for `-`.
fn bytes(path: &Path) -> Result<Vec<u8>, Failure> {
    let name = display(path);
    let fault = |message: String| Failure::input(format!("{name}: {message}"));
    let mut bytes = Vec::new();
    let read = if is_standard_input(path) {
        io::stdin()
            .lock()
            .take(SIZE_MAX + 1)
            .read_to_end(&mut bytes)
    } else if path.is_dir() {
        return Err(fault("is a folder; give the file of a case".to_string()));
    } else {
        File::open(path).and_then(|file| file.take(SIZE_MAX + 1).read_to_end(&mut bytes))
    };
    read.map_err(|error| fault(format!("cannot be read: {error}")))?;
    if bytes.len() as u64 > SIZE_MAX {
        return Err(fault(format!("is larger than {} MiB", SIZE_MAX >> 20)));
    }
    Ok(bytes)
}

/// Puts the rows of the file that `atmosphere.file` names in its place.
fn resolve_atmosphere(case: &mut Case, here: &Path, faults: &mut Vec<String>) {
    let Some(Value::Text(name)) = case.values.get("atmosphere.file").cloned() else {
        return;
    };
    case.values.remove("atmosphere.file");
    if case.values.contains_key("atmosphere.table") {
        faults.push(
            "atmosphere.file: there is an atmosphere.table as well; give one of them".to_string(),
        );
        return;
    }
    let path = here.join(&name);
    let rows = match text(&path) {
        Ok(text) => atmosphere::read(&text, Kind::Atmosphere),
        Err(Failure::Input(messages)) => {
            faults.extend(messages.iter().map(|m| format!("atmosphere.file: {m}")));
            return;
        }
        Err(_) => return,
    };
    match rows {
        Ok(rows) => {
            case.values
                .insert("atmosphere.table".to_string(), Value::Rows(rows));
        }
        Err(found) => faults.extend(
            found
                .iter()
                .map(|fault| format!("atmosphere.file: {}: {fault}", path.display())),
        ),
    }
}

/// Puts the points of the file that `outline.file` names in its place.
fn resolve_outline(case: &mut Case, here: &Path, faults: &mut Vec<String>) {
    let Some(Value::Text(name)) = case.values.get("outline.file").cloned() else {
        return;
    };
    case.values.remove("outline.file");
    let unit = match case.values.remove("outline.file_unit") {
        Some(Value::Text(symbol)) => match LengthUnit::of(&symbol) {
            Some(unit) => Some(unit),
            None => {
                faults.push(format!(
                    "outline.file_unit: got \"{symbol}\", must be one of m, cm, mm, in, ft"
                ));
                return;
            }
        },
        _ => None,
    };
    if case.values.contains_key("outline.points") {
        let message = "outline.file: there are outline.points as well; give one of them";
        faults.push(message.to_string());
        return;
    }
    let path = here.join(&name);
    let read = match bytes(&path) {
        Ok(bytes) => outline::read(&name, &bytes, unit),
        Err(Failure::Input(messages)) => {
            faults.extend(messages.iter().map(|m| format!("outline.file: {m}")));
            return;
        }
        Err(_) => return,
    };
    match read {
        Ok(Imported { rows, remarks }) => {
            for remark in remarks {
                // a standard error that is full is no reason to stop
                let named = printable(&format!("outline.file: {}: {remark}", path.display()));
                let _ = writeln!(io::stderr(), "msape: note: {named}");
            }
            case.values
                .insert("outline.points".to_string(), Value::Rows(rows));
        }
        Err(found) => faults.extend(
            found
                .iter()
                .map(|fault| format!("outline.file: {}: {fault}", path.display())),
        ),
    }
}

/// Puts the rows of the file that `vehicle.aerodynamics.file` names in its place.
fn resolve_aerodynamics(case: &mut Case, here: &Path, faults: &mut Vec<String>) {
    let key = "vehicle.aerodynamics.file";
    let table = "vehicle.aerodynamics.table";
    let Some(Value::Text(name)) = case.values.get(key).cloned() else {
        return;
    };
    case.values.remove(key);
    if case.values.contains_key(table) {
        faults.push(format!(
            "{key}: there is a {table} as well; give one of them"
        ));
        return;
    }
    let path = here.join(&name);
    let found = match text(&path) {
        Ok(text) => cad::table::aerodynamics::read(&text),
        Err(Failure::Input(messages)) => Err(messages),
        Err(_) => return,
    };
    match found {
        Ok(rows) => {
            case.values.insert(table.to_string(), Value::Rows(rows));
        }
        Err(found) => faults.extend(
            found
                .iter()
                .map(|fault| format!("{key}: {}: {fault}", path.display())),
        ),
    }
}
