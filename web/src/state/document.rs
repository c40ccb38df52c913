//! What undo steps through: the case, how it is shown, and the runs that are kept.

use crate::display::UnitSystem;
use msape::case::Version;
use msape::case::version::BroughtUp;
use msape::{Case, InputError};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::sync::Arc;

/// A document; never changed, only replaced.
#[derive(Clone, Debug, PartialEq)]
pub struct Document {
    /// The case.
    pub case: Arc<Case>,
    /// System of units on screen.
    pub units: UnitSystem,
    /// Unit symbols chosen for single inputs, by key.
    pub unit_of: Arc<BTreeMap<String, String>>,
    /// Named runs, by identifier.
    pub runs: Arc<BTreeMap<String, Run>>,
    /// Outlines that were imported, by name.
    pub outlines: Arc<BTreeMap<String, Rows>>,
    /// Tables of coefficients that were imported, by name.
    pub tables: Arc<BTreeMap<String, Rows>>,
}

/// Rows of `outline.points` or of `vehicle.aerodynamics.table`.
pub type Rows = Vec<Vec<f64>>;

/// A run kept by name.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Run {
    /// Name given by the user.
    pub name: String,
    /// When it was saved, ms since 1970.
    pub saved_ms: f64,
    /// The case as TOML.
    pub case: String,
    /// Headline results when saved: output key and value in its SI unit.
    pub headline: Vec<(String, f64)>,
    /// Version that saved it; absent in what the first version saved.
    #[serde(default)]
    pub version: Option<Version>,
}

/// The case of a record, TOML, with the defaults of the version that wrote it.
///
/// # Errors
/// As [`Case::from_text`].
pub fn recorded(text: &str, version: Option<Version>) -> Result<BroughtUp, Vec<InputError>> {
    let case = Case::from_text(text)?;
    let version = version.unwrap_or(Version::FIRST);
    if version < Version::CURRENT {
        return Ok(case.brought_up_from(version));
    }
    let remarks = Vec::new();
    Ok(BroughtUp { case, remarks })
}

impl Document {
    /// A document of a case alone.
    pub fn new(case: Case) -> Document {
        Document {
            case: Arc::new(case),
            units: UnitSystem::Report,
            unit_of: Arc::default(),
            runs: Arc::default(),
            outlines: Arc::default(),
            tables: Arc::default(),
        }
    }

    /// The same with the case changed.
    #[must_use]
    pub fn with_case(&self, change: impl FnOnce(&mut Case)) -> Document {
        let mut case = (*self.case).clone();
        change(&mut case);
        Document {
            case: Arc::new(case),
            ..self.clone()
        }
    }

    /// The same with the kept runs changed.
    #[must_use]
    pub fn with_runs(&self, change: impl FnOnce(&mut BTreeMap<String, Run>)) -> Document {
        let mut runs = (*self.runs).clone();
        change(&mut runs);
        Document {
            runs: Arc::new(runs),
            ..self.clone()
        }
    }

    /// The same with the imported outlines changed.
    #[must_use]
    pub fn with_outlines(&self, change: impl FnOnce(&mut BTreeMap<String, Rows>)) -> Document {
        let mut outlines = (*self.outlines).clone();
        change(&mut outlines);
        Document {
            outlines: Arc::new(outlines),
            ..self.clone()
        }
    }

    /// The same with the imported tables changed.
    #[must_use]
    pub fn with_tables(&self, change: impl FnOnce(&mut BTreeMap<String, Rows>)) -> Document {
        let mut tables = (*self.tables).clone();
        change(&mut tables);
        Document {
            tables: Arc::new(tables),
            ..self.clone()
        }
    }

    /// The same with one input shown in another unit.
    #[must_use]
    pub fn with_unit_of(&self, key: &str, symbol: &str) -> Document {
        let mut unit_of = (*self.unit_of).clone();
        unit_of.insert(key.to_string(), symbol.to_string());
        Document {
            unit_of: Arc::new(unit_of),
            ..self.clone()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_the_first_version_kept_is_read_with_its_defaults() {
        let text = include_str!("../../../tests/data/e134449/run.json");
        let run: Run = serde_json::from_str(text).unwrap();
        assert_eq!((run.version, run.headline.len()), (None, 4));
        let BroughtUp { case, remarks } = recorded(&run.case, run.version).unwrap();
        assert_eq!(case.version, Version::CURRENT);
        assert!(!remarks.is_empty() && case.version_note().is_none());
        let now = recorded(&case.to_toml(), Some(Version::CURRENT)).unwrap();
        assert_eq!((now.case, now.remarks.len()), (case, 0));
    }

    #[test]
    fn what_a_user_opened_as_a_file_of_an_earlier_version_stays_one() {
        let text = "schema = 'msape/1'\n[design]\nmsr_mode = true\n";
        let file = Case::from_text(text).unwrap();
        let kept = recorded(&file.to_toml(), Some(Version::CURRENT)).unwrap();
        assert_eq!((kept.case, kept.remarks.len()), (file, 0));
    }
}
