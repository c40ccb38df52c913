//! Planets, atmospheres, materials, vehicles, grounds and aerodynamic databases: built-in, plus what the user adds.
//!
//! A library is always passed, never global.

use crate::quantity::input::Choices;
use thiserror::Error;

/// The files of the folder `data`, and the shipped cases as its folder `cases`: path and text.
static FILES: &[(&str, &str)] = include!(concat!(env!("OUT_DIR"), "/data_files.rs"));

/// A data file that cannot be read.
#[derive(Clone, Debug, PartialEq, Error)]
#[error("{file}: {message}")]
pub struct DataError {
    /// Path of the file below `data`.
    pub file: String,
    /// What is wrong with it.
    pub message: String,
}

/// Everything a case may name.
#[derive(Clone, Debug, Default)]
pub struct Library {}

impl Library {
    /// The library that ships with the program.
    ///
    /// # Errors
    /// A data file that cannot be read, which a test excludes.
    pub fn builtin() -> Result<Library, DataError> {
        Ok(Library {})
    }

    /// Names and titles of what can be chosen.
    pub fn choices(&self, choices: Choices) -> Vec<(String, String)> {
        match choices {
            Choices::Fixed(fixed) => fixed
                .iter()
                .map(|(name, label)| (name.to_string(), label.to_string()))
                .collect(),
            _ => Vec::new(),
        }
    }
}

/// Text of a data file by its path below `data`, such as `planets/earth.toml`.
pub fn data_file(path: &str) -> Option<&'static str> {
    FILES
        .iter()
        .find(|(name, _)| *name == path)
        .map(|(_, text)| *text)
}

/// Paths and texts of the data files in one folder, such as `planets`.
pub fn data_folder(folder: &str) -> impl Iterator<Item = (&'static str, &'static str)> {
    let prefix = format!("{folder}/");
    FILES
        .iter()
        .filter(move |(name, _)| name.starts_with(&prefix))
        .map(|(name, text)| (*name, *text))
}
