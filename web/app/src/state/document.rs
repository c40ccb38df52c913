//! Document, the unit of undo: case, display units, stored runs and imports.

use crate::storage::record::Sort;
use msape::case::Version;
use msape::case::version::BroughtUp;
use msape::{Case, InputError};
use msape_kit::display::UnitSystem;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Immutable document; changed by replacement only.
#[derive(Clone, Debug, PartialEq)]
pub struct Document {
    /// The case.
    pub case: Arc<Case>,
    /// System of displayed units.
    pub units: UnitSystem,
    /// Unit symbols chosen for single inputs, by key.
    pub unit_of: Arc<BTreeMap<String, String>>,
    /// Named runs, by identifier.
    pub runs: Arc<BTreeMap<String, Run>>,
    /// Imported outlines, by name.
    pub outlines: Arc<BTreeMap<String, Rows>>,
    /// Imported coefficient tables, by name.
    pub tables: Arc<BTreeMap<String, Rows>>,
    /// Record in which case and units are stored.
    pub place: Place,
}

/// Place where case and units of a document are stored. Undo restores the place, too.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Place {
    /// The main record, which the app opens with: the stored work.
    #[default]
    Stored,
    /// A separate record.
    Apart(Arc<Apart>),
}

/// Separate record beside the stored work.
#[derive(Clone, Debug, PartialEq)]
pub struct Apart {
    /// Identifier of the record.
    pub id: String,
    /// Reason for the separation.
    pub why: Why,
    /// Case as opened; while it is unchanged nothing is written.
    pub opened: Option<Arc<Case>>,
}

/// Reason why a document is stored separately.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Why {
    /// Opened from a link.
    Link,
    /// Another tab has changed the stored work.
    OtherTab,
    /// Changed before the stored work had been read.
    Early,
    /// The page was closed before it was written.
    Closed,
    /// The document could not be read earlier.
    Unread,
}

impl Apart {
    /// A separate place, unique among all tabs.
    pub fn place(why: Why, opened: Option<Arc<Case>>) -> Place {
        let id = format!("{:.0}-{:08x}", now_ms(), chance());
        Place::Apart(Arc::new(Apart { id, why, opened }))
    }
}

/// Current time, ms since 1970.
fn now_ms() -> f64 {
    js_sys::Date::now()
}

/// Random 32 bits, which distinguish tabs.
fn chance() -> u32 {
    (js_sys::Math::random() * f64::from(u32::MAX)) as u32
}

/// Rows of `outline.points` or of `vehicle.aerodynamics.table`.
pub type Rows = Vec<Vec<f64>>;

/// Named run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Run {
    /// Name given by the user.
    pub name: String,
    /// Time of saving, ms since 1970.
    pub saved_ms: f64,
    /// The case as TOML.
    pub case: String,
    /// Headline results at the time of saving: output key and value in its SI unit.
    pub headline: Vec<(String, f64)>,
    /// Version that saved it; `None` for the first version.
    #[serde(default)]
    pub version: Option<Version>,
}

/// Case of a record, from TOML, with the defaults of the version that wrote it.
///
/// # Errors
/// The errors of [`Case::from_text`].
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
    /// A document with only a case.
    pub fn new(case: Case) -> Document {
        Document {
            case: Arc::new(case),
            units: UnitSystem::Report,
            unit_of: Arc::default(),
            runs: Arc::default(),
            outlines: Arc::default(),
            tables: Arc::default(),
            place: Place::Stored,
        }
    }

    /// Whether it shows separately opened work without changes.
    pub fn is_view(&self) -> bool {
        match &self.place {
            Place::Apart(apart) => apart.opened.as_ref() == Some(&self.case),
            Place::Stored => false,
        }
    }

    /// The document with the case changed.
    #[must_use]
    pub fn with_case(&self, change: impl FnOnce(&mut Case)) -> Document {
        let mut case = (*self.case).clone();
        change(&mut case);
        Document {
            case: Arc::new(case),
            ..self.clone()
        }
    }

    /// The document with the runs changed.
    #[must_use]
    pub fn with_runs(&self, change: impl FnOnce(&mut BTreeMap<String, Run>)) -> Document {
        let mut runs = (*self.runs).clone();
        change(&mut runs);
        Document {
            runs: Arc::new(runs),
            ..self.clone()
        }
    }

    /// The document with the imported outlines changed.
    #[must_use]
    pub fn with_outlines(&self, change: impl FnOnce(&mut BTreeMap<String, Rows>)) -> Document {
        let mut outlines = (*self.outlines).clone();
        change(&mut outlines);
        Document {
            outlines: Arc::new(outlines),
            ..self.clone()
        }
    }

    /// The document with the imported tables changed.
    #[must_use]
    pub fn with_tables(&self, change: impl FnOnce(&mut BTreeMap<String, Rows>)) -> Document {
        let mut tables = (*self.tables).clone();
        change(&mut tables);
        Document {
            tables: Arc::new(tables),
            ..self.clone()
        }
    }

    /// The document with the runs, outlines and tables of another added; its own take precedence.
    #[must_use]
    pub fn with_items_of(&self, other: &Document) -> Document {
        fn both<T: Clone>(
            ours: &Arc<BTreeMap<String, T>>,
            theirs: &Arc<BTreeMap<String, T>>,
        ) -> Arc<BTreeMap<String, T>> {
            let mut both = (**theirs).clone();
            both.extend(ours.iter().map(|(name, item)| (name.clone(), item.clone())));
            Arc::new(both)
        }
        Document {
            runs: both(&self.runs, &other.runs),
            outlines: both(&self.outlines, &other.outlines),
            tables: both(&self.tables, &other.tables),
            ..self.clone()
        }
    }

    /// The document with an item renamed, if the item equals that of `other`.
    pub fn renamed(&self, other: &Document, from: &str, to: &str, sort: &Sort) -> Option<Document> {
        fn moved<T: Clone + PartialEq>(
            ours: &Arc<BTreeMap<String, T>>,
            other: &BTreeMap<String, T>,
            from: &str,
            to: &str,
        ) -> Option<Arc<BTreeMap<String, T>>> {
            let mut items = (**ours).clone();
            let item = items.remove(from)?;
            (other.get(from) == Some(&item)).then(|| {
                items.insert(to.to_string(), item);
                Arc::new(items)
            })
        }
        let mut document = self.clone();
        match sort {
            Sort::Run(_) => document.runs = moved(&self.runs, &other.runs, from, to)?,
            Sort::Outline(_) => {
                document.outlines = moved(&self.outlines, &other.outlines, from, to)?;
            }
            Sort::Table(_) => document.tables = moved(&self.tables, &other.tables, from, to)?,
            _ => return None,
        }
        Some(document)
    }

    /// The document with one input displayed in another unit.
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
        let text = include_str!("../../../../tests/data/e134449/run.json");
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
