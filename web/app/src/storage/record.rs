//! Records of the browser's database: keys, texts, and changes.

use crate::state::document::{Document, Rows, Why};
use msape::case::Version;
use msape_kit::display::UnitSystem;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Object store of the database.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Shelf {
    /// Single items, by name.
    Things,
    /// Named runs, by identifier.
    Runs,
}

impl Shelf {
    /// Both stores.
    pub const ALL: [Shelf; 2] = [Shelf::Things, Shelf::Runs];

    /// Name in the database.
    pub fn name(self) -> &'static str {
        match self {
            Shelf::Things => "things",
            Shelf::Runs => "runs",
        }
    }
}

/// Key of a record.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Key {
    /// Object store.
    pub shelf: Shelf,
    /// Key in the store.
    pub id: String,
}

/// Prefixes of keys in the store of items.
const OUTLINE: &str = "outline ";
const TABLE: &str = "table ";
const APART: &str = "apart ";
/// Suffix of the identifier of an unreadable record that was moved aside.
const ASIDE: &str = "-aside";
/// Suffix added to an identifier whose record cannot be read.
const BESIDE: &str = "-2";
const CURRENT: &str = "current";

/// Kind of a record.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Sort {
    /// The stored work.
    Current,
    /// Separate work, by identifier.
    Apart(String),
    /// Imported outline, by name.
    Outline(String),
    /// Imported table of coefficients, by name.
    Table(String),
    /// Named run, by identifier.
    Run(String),
    /// Not known to this version.
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

    /// Key of separate work.
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

    /// Key to which unreadable stored work is moved at a time in ms.
    pub fn aside(now_ms: f64) -> Key {
        Key::apart(&format!("{now_ms:.0}{ASIDE}"))
    }

    /// Kind of the record.
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

    /// Description of the record for the user.
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

/// Content of a record.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Found {
    /// Text, as written by this program.
    Text(String),
    /// Anything else, formatted for the user.
    Other(String),
}

impl Found {
    /// Content that the user can download.
    pub fn spelled(&self) -> &str {
        match self {
            Found::Text(text) | Found::Other(text) => text,
        }
    }
}

/// Change of one record, made only if the record is as this tab knows it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Change {
    /// Key.
    pub key: Key,
    /// Text as last read or written by this tab; `None` if no record is known.
    pub expected: Option<String>,
    /// New text; `None` removes the record.
    pub text: Option<String>,
}

impl Change {
    /// Next attempt after a clash: overwrites a text, which is older; uses another key beside a record that is not a
    /// text.
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

/// Record that is not as the tab knows it, with its content.
pub type Clash = (Key, Option<Found>);

/// Result of a set of changes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Written {
    /// All are committed.
    All,
    /// Nothing was written, because of these records.
    Nothing(Vec<Clash>),
}

/// Case and units as stored.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Sheet {
    /// The case as TOML.
    pub case: String,
    /// System of displayed units.
    pub units: UnitSystem,
    /// Unit symbols chosen for single inputs, by key.
    pub unit_of: BTreeMap<String, String>,
    /// Version that stored it; `None` for the first version.
    #[serde(default)]
    pub version: Option<Version>,
    /// Time of storing, ms since 1970; `None` for earlier versions.
    #[serde(default)]
    pub saved_ms: Option<f64>,
    /// Reason for separate storage, if it is separate.
    #[serde(default)]
    pub why: Option<Why>,
    /// Text of the stored work that it continues, if its page was closed before writing; empty if there was none.
    #[serde(default)]
    pub continues: Option<String>,
    /// Outlines; stored here by earlier versions only.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub outlines: BTreeMap<String, Rows>,
    /// Tables; stored here by earlier versions only.
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

    /// Whether both have the same content, regardless of their times.
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

/// Parses a record.
///
/// # Errors
/// Reason why it cannot be read.
pub fn read<T: for<'de> Deserialize<'de>>(found: &Found) -> Result<T, String> {
    match found {
        Found::Text(text) => serde_json::from_str(text).map_err(|error| error.to_string()),
        Found::Other(_) => Err("it is not a text".to_string()),
    }
}

/// Serializes a value.
pub fn written<T: Serialize>(value: &T) -> String {
    // maps of strings and numbers can always be serialized
    serde_json::to_string(value).unwrap_or_default()
}
