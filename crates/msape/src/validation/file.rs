//! A file of expectations.

use crate::units::Unit;
use crate::units::number::shortest;
use serde::Deserialize;
use std::collections::BTreeMap;

/// What solves the case.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Command {
    /// [`crate::fly`].
    Fly,
    /// [`crate::design()`].
    Design,
}

/// How far a value may be from its reference, and why.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Tolerance {
    /// Part of the reference value.
    pub relative: Option<f64>,
    /// In the unit of the row.
    pub absolute: Option<f64>,
    /// Why it is what it is.
    pub reason: String,
}

impl Tolerance {
    /// Largest difference from `reference`, in its unit.
    pub fn allowed(&self, reference: f64) -> f64 {
        let relative = self.relative.map_or(0.0, |part| part * reference.abs());
        relative.max(self.absolute.unwrap_or(0.0))
    }

    /// As it is written: `0.1 %`, `0.2 s`.
    pub fn text(&self, unit: &str) -> String {
        match (self.relative, self.absolute) {
            (Some(part), _) => format!("{} %", shortest((part * 1e8).round() / 1e6)),
            (None, Some(value)) => format!("{} {unit}", shortest(value)).trim_end().to_string(),
            (None, None) => String::new(),
        }
    }
}

/// One value to compare with.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Expectation {
    /// Key of an output; with `time_s`, of a column of the trajectory.
    pub quantity: String,
    /// Time in the trajectory, s.
    pub time_s: Option<f64>,
    /// Keys of the case that are set for this row, as text.
    #[serde(default)]
    pub set: BTreeMap<String, String>,
    /// The value, in `unit`.
    pub value: f64,
    /// Symbol of the unit in which the source gives it.
    #[serde(default)]
    pub unit: String,
    /// Name of a tolerance of the file; a row without one is shown and not judged.
    pub tolerance: Option<String>,
    /// Whether an assumption of the program was fitted to this value.
    #[serde(default)]
    pub calibrated: bool,
    /// What must be known of it; for a row that is only shown, why it is not judged.
    pub note: Option<String>,
    /// Key of the bibliography, where it is not that of the file.
    pub source: Option<String>,
    /// Place in it, where it is not that of the file.
    pub place: Option<String>,
}

/// Many measured points, compared by the mean of the ratio of ours to the measured value.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Points {
    /// CSV file of the folder `data/validation`.
    pub table: String,
    /// Keys of the case, each with the column that sets it.
    pub set: BTreeMap<String, String>,
    /// Column with the measured values, in the canonical unit.
    pub measured: String,
    /// The mean ratio, without unit.
    pub expected: Expectation,
}

/// A file of `data/validation`.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct File {
    /// What is compared, in one line.
    pub title: String,
    /// Name of a file of the folder `cases`.
    pub case: String,
    /// What solves it.
    pub command: Command,
    /// Key of the bibliography.
    pub source: String,
    /// Place in it.
    pub place: String,
    /// What must be known of the whole.
    pub note: Option<String>,
    /// Step of the trajectory, s, where rows name times.
    pub step_s: Option<f64>,
    /// Tolerances by name.
    #[serde(default)]
    pub tolerances: BTreeMap<String, Tolerance>,
    /// Values to compare with.
    #[serde(default)]
    pub rows: Vec<Expectation>,
    /// Tables of measured points.
    #[serde(default)]
    pub points: Vec<Points>,
}

impl File {
    /// Reads a file; a unit that is not known or a tolerance that is not in the file is an error.
    ///
    /// # Errors
    /// What is wrong, in one sentence.
    pub fn parse(text: &str) -> Result<File, String> {
        let file: File = toml::from_str(text).map_err(|error| error.to_string())?;
        let of_points = file.points.iter().map(|points| &points.expected);
        for row in file.rows.iter().chain(of_points) {
            let quantity = &row.quantity;
            if Unit::find(&row.unit).is_none() {
                return Err(format!("{quantity}: unit \"{}\" is not known", row.unit));
            }
            match &row.tolerance {
                Some(name) if !file.tolerances.contains_key(name) => {
                    return Err(format!("{quantity}: no tolerance is called \"{name}\""));
                }
                None if row.note.is_none() => {
                    return Err(format!(
                        "{quantity}: neither a tolerance nor a note why there is none"
                    ));
                }
                _ => {}
            }
        }
        Ok(file)
    }
}
