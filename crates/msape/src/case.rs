//! A case: keys and values as the user typed them, not yet checked.
//!
//! A [`Case`] keeps everything it was given, faults included, so that nothing is lost; [`crate::problem`] checks it and
//! reports all faults at once.

mod check;
mod fault;
mod node;
mod read;
pub mod schema;
pub mod version;
mod words;
mod write;

pub use check::Reader;
pub use fault::InputError;
pub use version::Version;

use crate::quantity::Task;
use crate::quantity::input::{self, Input, Kind, Preset};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Version of the case file that this program writes; it reads this and older ones.
pub const SCHEMA: &str = "msape/1";

/// A value as given.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Value {
    /// A number in the unit of its key.
    Number(f64),
    /// A name, or a number with its unit as typed.
    Text(String),
    /// Yes or no.
    Flag(bool),
    /// Rows of numbers.
    Rows(Vec<Vec<f64>>),
    /// A value that no input accepts, in TOML notation; null of JSON as `null`.
    Other(String),
}

/// A case: a name and the value given for each key.
///
/// ```
/// use msape::Case;
/// let mut case = Case::from_toml("schema = \"msape/1\"\nname = \"first\"\n[entry]\nspeed_m_s = 12000.0\n").unwrap();
/// case.set("entry.speed_m_s", "13 km/s");
/// assert_eq!(case.text("entry.speed_m_s"), Some("13 km/s".to_string()));
/// ```
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Case {
    /// Free text.
    pub name: String,
    /// Version of the program whose defaults it was written for.
    #[serde(default)]
    pub version: Version,
    /// Values given, by dotted key.
    pub values: BTreeMap<String, Value>,
}

impl Case {
    /// The case of the report's run page: every input at its default.
    pub fn run_page() -> Case {
        let mut case = Case {
            name: "Run page".to_string(),
            ..Case::default()
        };
        // the run page has no table to leave
        let of_run_page =
            |input: &&Input| input.is_of(Task::Design) && !input::BEYOND_TABLES.contains(input);
        for input in input::inputs().filter(of_run_page) {
            case.reset(input);
        }
        case.values.insert(
            input::design::PAYLOAD_DIAMETER_RATIO.to_string(),
            Value::Number(0.6),
        );
        case
    }

    /// Resets an input to its default, or removes it if it has none.
    pub fn reset(&mut self, input: &Input) {
        let value = match input.preset {
            Preset::Absent => {
                self.values.remove(input.key);
                return;
            }
            Preset::Number(value) => Value::Number(value),
            Preset::Name(name) => Value::Text(name.to_string()),
            Preset::Flag(flag) => Value::Flag(flag),
        };
        self.values.insert(input.key.to_string(), value);
    }

    /// Whether one of these inputs is given.
    pub fn gives_any(&self, inputs: &[&Input]) -> bool {
        inputs
            .iter()
            .any(|input| self.values.contains_key(input.key))
    }

    /// Sets a key from text as typed: `true`, `12 km/s`, `pica-al-5056`. Empty text takes the key away.
    ///
    /// A text that is a plain number is kept as a number, rows in brackets such as `[[0, 1], [2, 3]]` as rows where the
    /// input takes rows, anything else as text until it is checked.
    pub fn set(&mut self, key: &str, text: &str) {
        let key = input::canonical_key(key);
        let text = text.trim();
        let value = match (text, text.parse::<f64>()) {
            ("", _) => {
                self.values.remove(&key);
                return;
            }
            ("true", _) => Value::Flag(true),
            ("false", _) => Value::Flag(false),
            (_, Ok(number)) => Value::Number(number),
            _ => takes_rows(&key)
                .then(|| node::rows_of_text(text))
                .flatten()
                .unwrap_or_else(|| Value::Text(text.to_string())),
        };
        self.values.insert(key, value);
    }

    /// Value given for a key, as text; `None` for rows.
    pub fn text(&self, key: &str) -> Option<String> {
        match self.values.get(key)? {
            Value::Number(number) => Some(number.to_string()),
            Value::Text(text) => Some(text.clone()),
            Value::Flag(flag) => Some(flag.to_string()),
            Value::Rows(_) | Value::Other(_) => None,
        }
    }
}

fn takes_rows(key: &str) -> bool {
    input::find(key).is_some_and(|input| matches!(input.kind, Kind::Rows(_)))
}
