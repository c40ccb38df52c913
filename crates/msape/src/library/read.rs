//! Reads data files, shipped ones and those of a user, and notes every fault.

use super::{DataError, Named, files};
use crate::data::Data;

/// Folders to which a user may add files, and the endings of the file names.
#[cfg(feature = "own-data")]
const FOLDERS: [(&str, &str); 10] = [
    ("planets", ".toml"),
    ("atmospheres", ".toml"),
    ("materials", ".toml"),
    ("concepts", ".toml"),
    ("soak", ".toml"),
    ("grounds", ".toml"),
    ("aerodynamics", ".csv"),
    ("outlines", ".toml"),
    ("ablators", ".toml"),
    ("ablators", ".csv"),
];
/// Relations for some planets each, of which a user may add files.
pub(super) const RELATIONS: [&str; 3] = [
    "heating/sutton-graves",
    "heating/hot-wall",
    "heating/tauber-sutton",
];

/// The files of a library, and their faults.
pub(super) struct Files<'f> {
    files: Vec<(&'f str, Data<'f>)>,
    pub faults: Vec<DataError>,
}

/// Data that apply to some planets, and the file that contains them.
pub(super) struct Relation<T> {
    pub file: String,
    pub planets: Vec<String>,
    pub thing: T,
}

impl<'f> Files<'f> {
    /// The shipped files.
    pub fn shipped() -> Self {
        let shipped = files::SHIPPED.iter();
        Self {
            files: shipped
                .map(|(path, data)| (*path, Data::Shipped(data)))
                .collect(),
            faults: Vec::new(),
        }
    }

    /// The shipped files, as those of a user are read.
    #[cfg(test)]
    pub fn as_own() -> Self {
        let library = files::LIBRARY.iter();
        Self {
            files: library
                .map(|(path, text)| (*path, Data::Own(text)))
                .collect(),
            faults: Vec::new(),
        }
    }

    /// These files and those of the user.
    #[cfg(feature = "own-data")]
    pub fn with(mut self, own: &'f [(String, String)]) -> Self {
        for (path, text) in own {
            if !is_addable(path) {
                let folders = FOLDERS.map(|(folder, ending)| format!("{folder}/NAME{ending}"));
                let relations = RELATIONS.map(|start| format!("{start}-NAME.toml"));
                let kinds = [folders.as_slice(), relations.as_slice()]
                    .concat()
                    .join(", ");
                self.fault(
                    path,
                    format!("is no file that can be added; must be one of {kinds}"),
                );
            } else if self.files.iter().any(|(known, _)| known == path) {
                let message = "name: there is a file of this name; give it another one";
                self.fault(path, message.to_string());
            } else {
                self.files.push((path, Data::Own(text)));
            }
        }
        self
    }

    /// Paths and texts of the user's files in a folder.
    pub fn own_texts(&self, folder: &str) -> Vec<(String, String)> {
        let prefix = format!("{folder}/");
        let inside = self
            .files
            .iter()
            .filter(|(path, _)| path.starts_with(&prefix));
        let text = |(path, data): &(&str, Data)| Some((path.to_string(), data.own()?.to_string()));
        inside.filter_map(text).collect()
    }

    /// Notes a fault.
    pub fn fault(&mut self, file: &str, message: String) {
        let file = file.to_string();
        self.faults.push(DataError { file, message });
    }

    /// Every file of a folder, by its name without the ending.
    pub fn folder<T>(
        &mut self,
        folder: &str,
        parse: impl Fn(Data) -> Result<T, String>,
    ) -> Named<T> {
        let prefix = format!("{folder}/");
        let inside = |path: &str| path.strip_prefix(&prefix).is_some_and(|f| !f.contains('/'));
        let mut found = Vec::new();
        for (path, data) in self.files.clone() {
            if inside(path)
                && let Some(thing) = self.parsed(path, data, &parse)
            {
                found.push((stem(path).to_string(), thing));
            }
        }
        found
    }

    /// A file that every library has.
    pub fn one<T>(&mut self, path: &str, parse: impl Fn(Data) -> Result<T, String>) -> Option<T> {
        let file = self.files.iter().find(|(known, _)| *known == path).copied();
        if file.is_none() {
            self.fault(path, "is not there".to_string());
        }
        self.parsed(path, file?.1, &parse)
    }

    /// Relations in the files whose paths begin with `start`, each with its planets.
    pub fn relations<T>(
        &mut self,
        start: &str,
        parse: impl Fn(Data) -> Result<Vec<(Vec<String>, T)>, String>,
    ) -> Vec<Relation<T>> {
        let mut found: Vec<Relation<T>> = Vec::new();
        for (path, data) in self.files.clone() {
            if !path.starts_with(start) {
                continue;
            }
            for (planets, thing) in self.parsed(path, data, &parse).into_iter().flatten() {
                let twice = |name: &&String| found.iter().any(|other| other.planets.contains(name));
                if let Some(name) = planets.iter().find(twice) {
                    let message =
                        format!("planets: got \"{name}\", which has such a relation already");
                    self.fault(path, message);
                }
                let file = path.to_string();
                found.push(Relation {
                    file,
                    planets,
                    thing,
                });
            }
        }
        found
    }

    fn parsed<T>(
        &mut self,
        path: &str,
        data: Data,
        parse: &impl Fn(Data) -> Result<T, String>,
    ) -> Option<T> {
        match parse(data) {
            Ok(thing) => Some(thing),
            Err(message) => {
                self.fault(path, message);
                None
            }
        }
    }
}

/// The name of a file without folder and ending.
pub(super) fn stem(path: &str) -> &str {
    let file = path.rsplit('/').next().unwrap_or(path);
    file.split('.').next().unwrap_or(file)
}

/// Whether a user may add a file of this path.
#[cfg(feature = "own-data")]
fn is_addable(path: &str) -> bool {
    let name_of = |start: &str, ending: &str| path.strip_prefix(start)?.strip_suffix(ending);
    let in_folder = FOLDERS.iter().filter_map(|(folder, ending)| {
        let file = path.strip_prefix(folder)?.strip_prefix('/')?;
        file.strip_suffix(ending)
    });
    let relations = RELATIONS.iter();
    let relation = relations.filter_map(|start| name_of(start, ".toml")?.strip_prefix('-'));
    in_folder
        .chain(relation)
        .any(|name| !name.is_empty() && !name.contains(['/', '.']))
}
