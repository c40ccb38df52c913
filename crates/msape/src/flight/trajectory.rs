//! Time history of a flight: one column per quantity, columns as in [`super::columns`].

use super::columns::{PHASE, SAMPLED, columns};
use super::sample::Sample;
use crate::finding::range::short;
use crate::finding::{Finding, Severity};
use crate::quantity::Column;
use serde::{Deserialize, Serialize};

/// Requested time history.
///
/// ```
/// use msape::{Case, Library, Request, fly};
///
/// let library = Library::builtin().unwrap();
/// let text = msape::library::data_file("cases/nesc-06.toml").unwrap();
/// let case = Case::from_text(text).unwrap();
/// let answer = fly(&case, &library, Request::Uniform(10.0)).unwrap();
/// let history = answer.flight.unwrap().trajectory.unwrap();
/// // The case ends after 30 s.
/// assert_eq!(history.column("time_s"), Some([0.0, 10.0, 20.0, 30.0].as_slice()));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub enum Request {
    /// No time history.
    #[default]
    Nothing,
    /// Rows at the steps of the integrator.
    Steps,
    /// Rows at a uniform step, s, both ends included.
    Uniform(f64),
}

/// A time history: for each column of [`columns`] its values, all of one length; none for a column that the flight does
/// not have, such as attitude in three degrees of freedom.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Trajectory {
    /// Values by column.
    pub values: Vec<Vec<f64>>,
    /// Requested uniform step and the longer one used, s, where there would have been too many rows.
    pub coarsened_s: Option<[f64; 2]>,
    /// Names of the phases, by the numbers of their column: entry, then those of the case.
    pub phases: Vec<String>,
}

impl Trajectory {
    /// A history without rows.
    pub fn new() -> Trajectory {
        Trajectory {
            values: vec![Vec::new(); SAMPLED.len()],
            coarsened_s: None,
            phases: Vec::new(),
        }
    }

    /// Appends the row of one instant.
    pub(super) fn push(&mut self, sample: &Sample) {
        for (sampled, values) in SAMPLED.iter().zip(&mut self.values) {
            values.extend((sampled.get)(sample));
        }
    }

    /// Finding of a history whose step was lengthened.
    pub fn finding(&self) -> Option<Finding> {
        let [asked_s, taken_s] = self.coarsened_s?;
        Some(Finding {
            severity: Severity::Note,
            model: "time history".to_string(),
            key: "time_s".to_string(),
            value: Some(taken_s),
            valid: (None, None),
            message: format!(
                "At a step of {} s the history would have more than a million rows; its step is {} s.",
                short(asked_s),
                short(taken_s)
            ),
            source: "convention of this program".to_string(),
            field: None,
        })
    }

    /// The name that a number of a column represents, where it represents one.
    pub fn name(&self, column: &Column, value: f64) -> Option<&str> {
        let of_phase = column.key == PHASE;
        let name = of_phase.then(|| self.phases.get(value as usize)).flatten();
        name.map(String::as_str)
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.values.first().map_or(0, Vec::len)
    }

    /// Values of the column with this key, where the flight has it.
    pub fn column(&self, key: &str) -> Option<&[f64]> {
        let mut present = self.columns();
        present.find_map(|(column, values)| (column.key == key).then_some(values))
    }

    /// The columns that the flight has, with their values.
    pub fn columns(&self) -> impl Iterator<Item = (&'static Column, &[f64])> {
        let rows = self.rows();
        let all = columns().zip(&self.values);
        all.filter(move |(_, values)| values.len() == rows)
            .map(|(column, values)| (column, values.as_slice()))
    }
}
