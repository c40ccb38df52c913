//! Records of the browser's database: their keys, their texts, and what is asked of them.

use crate::display::UnitSystem;
use crate::state::document::{Document, Rows, Why};
use msape::case::Version;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// A store of the database.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Shelf {
    /// Single things, by name.
    Things,
    /// Named runs, by identifier.
    Runs,
}

impl Shelf {
    /// Both.
    pub const ALL: [Shelf; 2] = [Shelf::Things, Shelf::Runs];

    /// Name in the database.
    pub fn name(self) -> &'static str {
        match self {
            Shelf::Things => "things",
            Shelf::Runs => "runs",
        }
    }
}

/// Where a record is.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Key {
    /// Its store.
    pub shelf: Shelf,
    /// Its key there.
    pub id: String,
}

/// What a key of the store of things begins with.
const OUTLINE: &str = "outline ";
const TABLE: &str = "table ";
const APART: &str = "apart ";
/// What its identifier ends with where it could not be read and was moved out of the way.
const ASIDE: &str = "-aside";
/// What an identifier is lengthened by where its record holds something that cannot be read.
const BESIDE: &str = "-2";
const CURRENT: &str = "current";

/// What a record is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Sort {
    /// The stored work.
    Current,
    /// Work apart from it, by identifier.
    Apart(String),
    /// An imported outline, by name.
    Outline(String),
    /// An imported table of coefficients, by name.
    Table(String),
    /// A named run, by identifier.
    Run(String),
    /// Nothing that this version knows.
    Unknown,
}

impl Key {
    fn thing(id: String) -> Key {
        let shelf = Shelf::Things;
        Key { shelf, id }
    }

    /// Key of the stored work.
    pub fn current() -> Key {
        Key::thing(CURRENT.to_string())
    }

    /// Key of work that is apart.
    pub fn apart(id: &str) -> Key {
        Key::thing(format!("{APART}{id}"))
    }

    /// Key of an outline.
    pub fn outline(name: &str) -> Key {
        Key::thing(format!("{OUTLINE}{name}"))
    }

    /// Key of a table.
    pub fn table(name: &str) -> Key {
        Key::thing(format!("{TABLE}{name}"))
    }

    /// Key of a run.
    pub fn run(id: &str) -> Key {
        let (shelf, id) = (Shelf::Runs, id.to_string());
        Key { shelf, id }
    }

    /// Where stored work that cannot be read is moved to, at a time in ms.
    pub fn aside(now_ms: f64) -> Key {
        Key::apart(&format!("{now_ms:.0}{ASIDE}"))
    }

    /// What the record is.
    pub fn sort(&self) -> Sort {
        let named = |prefix: &str| self.id.strip_prefix(prefix).map(str::to_string);
        match self.shelf {
            Shelf::Runs => Sort::Run(self.id.clone()),
            Shelf::Things if self.id == CURRENT => Sort::Current,
            Shelf::Things => named(OUTLINE)
                .map(Sort::Outline)
                .or_else(|| named(TABLE).map(Sort::Table))
                .or_else(|| named(APART).map(Sort::Apart))
                .unwrap_or(Sort::Unknown),
        }
    }

    /// What the record is, for the user.
    pub fn words(&self) -> String {
        match self.sort() {
            Sort::Current => "the stored work".to_string(),
            Sort::Apart(id) if id.ends_with(ASIDE) => "the work stored before".to_string(),
            Sort::Apart(_) => "work that was kept apart".to_string(),
            Sort::Outline(name) => format!("the outline {name}"),
            Sort::Table(name) => format!("the table {name}"),
            Sort::Run(_) => "a saved run".to_string(),
            Sort::Unknown => format!("the record {}", self.id),
        }
    }
}

/// What a record holds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Found {
    /// A text, as this program writes it.
    Text(String),
    /// Something else, spelled for the user.
    Other(String),
}

impl Found {
    /// What the user gets as a file.
    pub fn spelled(&self) -> &str {
        match self {
            Found::Text(text) | Found::Other(text) => text,
        }
    }
}

/// A change of one record, made only if the record is as the tab knows it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Change {
    /// The record.
    pub key: Key,
    /// Its text as this tab last read or wrote it; `None` where it knows of none.
    pub expected: Option<String>,
    /// Its new text; `None` removes it.
    pub text: Option<String>,
}

impl Change {
    /// What is tried next, when the record holds something else than was expected: the same over a text, which is older; beside what
    /// is no text.
    #[must_use]
    pub fn over(mut self, found: Option<Found>) -> Change {
        self.expected = match found {
            Some(Found::Text(text)) => Some(text),
            Some(Found::Other(_)) => {
                self.key.id.push_str(BESIDE);
                None
            }
            None => None,
        };
        self
    }
}

/// A record that is not as the tab knows it.
pub type Clash = (Key, Option<Found>);

/// What became of changes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Written {
    /// All are committed.
    All,
    /// Nothing was written, since these records are not as the tab knows them.
    Nothing(Vec<Clash>),
}

/// Case and units as they are kept.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Sheet {
    /// The case as TOML.
    pub case: String,
    /// System of units.
    pub units: UnitSystem,
    /// Unit symbols chosen for single inputs, by key.
    pub unit_of: BTreeMap<String, String>,
    /// Version that kept it; absent in what the first version kept.
    #[serde(default)]
    pub version: Option<Version>,
    /// When it was kept, ms since 1970; absent in what earlier versions kept.
    #[serde(default)]
    pub saved_ms: Option<f64>,
    /// Why it is apart from the stored work, if it is.
    #[serde(default)]
    pub why: Option<Why>,
    /// Text of the stored work that it goes on from, if its page was closed before it was written; empty where there was none.
    #[serde(default)]
    pub continues: Option<String>,
    /// Outlines, which earlier versions kept here.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub outlines: BTreeMap<String, Rows>,
    /// Tables, which earlier versions kept here.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub tables: BTreeMap<String, Rows>,
}

impl Sheet {
    /// Case and units of a document.
    pub fn of(document: &Document, now_ms: f64) -> Sheet {
        Sheet {
            case: document.case.to_toml(),
            units: document.units,
            unit_of: (*document.unit_of).clone(),
            version: Some(Version::CURRENT),
            saved_ms: Some(now_ms),
            why: None,
            continues: None,
            outlines: BTreeMap::new(),
            tables: BTreeMap::new(),
        }
    }

    /// Whether both say the same, whenever it was kept.
    pub fn says_as(&self, other: &Sheet) -> bool {
        let said = |sheet: &Sheet| Sheet {
            saved_ms: None,
            why: None,
            continues: None,
            ..sheet.clone()
        };
        said(self) == said(other)
    }
}

/// The value of a record.
///
/// # Errors
/// Why it cannot be read.
pub fn read<T: for<'de> Deserialize<'de>>(found: &Found) -> Result<T, String> {
    match found {
        Found::Text(text) => serde_json::from_str(text).map_err(|error| error.to_string()),
        Found::Other(_) => Err("it is not a text".to_string()),
    }
}

/// The text of a value.
pub fn written<T: Serialize>(value: &T) -> String {
    // Maps of strings and numbers can always be written.
    serde_json::to_string(value).unwrap_or_default()
}
