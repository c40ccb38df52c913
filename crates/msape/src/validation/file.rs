//! A file of expectations.

use crate::units::Unit;
use crate::units::number::shortest;
use serde::Deserialize;
use std::collections::BTreeMap;

/// Function that solves the case.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Command {
    /// [`crate::fly`].
    Fly,
    /// [`crate::design()`].
    Design,
    /// The heat shield in depth, with the feature `ablation`.
    Tps,
}

/// Tolerance of a value about its reference, and its reason.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Tolerance {
    /// Relative tolerance, as a fraction of the reference value.
    pub relative: Option<f64>,
    /// Absolute tolerance, in the unit of the row.
    pub absolute: Option<f64>,
    /// Reason for the tolerance.
    pub reason: String,
}

impl Tolerance {
    /// Largest difference from `reference`, in its unit.
    pub fn allowed(&self, reference: f64) -> f64 {
        let relative = self.relative.map_or(0.0, |part| part * reference.abs());
        relative.max(self.absolute.unwrap_or(0.0))
    }

    /// Tolerance as text, such as `0.1 %` or `0.2 s`.
    pub fn text(&self, unit: &str) -> String {
        match (self.relative, self.absolute) {
            (Some(part), _) => format!("{} %", shortest((part * 1e8).round() / 1e6)),
            (None, Some(value)) => format!("{} {unit}", shortest(value)).trim_end().to_string(),
            (None, None) => String::new(),
        }
    }
}

/// A reference value.
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
    /// Name of a tolerance of the file; a row without one is shown without a verdict.
    pub tolerance: Option<String>,
    /// Whether an assumption of the program was fitted to this value.
    #[serde(default)]
    pub calibrated: bool,
    /// Note on the value; for a row without a verdict, the reason.
    pub note: Option<String>,
    /// Key of the bibliography, if different from that of the file.
    pub source: Option<String>,
    /// Place in the source, if different from that of the file.
    pub place: Option<String>,
}

/// Measured points, compared by the mean of the ratio of computed to measured value.
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

/// A history beside a table, compared by the largest difference of any of its columns.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Histories {
    /// CSV file of the folder `data/validation`, with a column `time_s`.
    pub table: String,
    /// Columns of the history, each with that of the table.
    pub columns: BTreeMap<String, String>,
    /// Time after which rows count, s.
    pub from_s: f64,
    /// Time up to which rows count, s.
    pub to_s: f64,
    /// Whether differences are relative, percent.
    #[serde(default)]
    pub relative: bool,
    /// The largest difference.
    pub expected: Expectation,
}

/// A file of `data/validation`.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct File {
    /// Title of the comparison, in one line.
    pub title: String,
    /// Name of a file of the folder `cases`.
    pub case: String,
    /// Function that solves the case.
    pub command: Command,
    /// Key of the bibliography.
    pub source: String,
    /// Place in the source.
    pub place: String,
    /// Note on the whole comparison.
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
    /// Histories beside tables.
    #[serde(default)]
    pub histories: Vec<Histories>,
}

impl File {
    /// Number of comparisons.
    pub fn count(&self) -> usize {
        self.rows.len() + self.points.len()
    }

    /// Reads a file; a unit that is not known or a tolerance that is not in the file is an error.
    ///
    /// # Errors
    /// A sentence that describes the fault.
    pub fn parse(text: &str) -> Result<File, String> {
        let file: File = toml::from_str(text).map_err(|error| error.to_string())?;
        let of_points = file.points.iter().map(|points| &points.expected);
        let of_histories = file.histories.iter().map(|histories| &histories.expected);
        for row in file.rows.iter().chain(of_points).chain(of_histories) {
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
