//! Reads a case from TOML or JSON: one model, two spellings.

use super::{Case, InputError, SCHEMA, Value, Version};
use crate::quantity::input::phase::SECTION;
use crate::quantity::input::{self, Kind};

/// A value of TOML or JSON.
enum Node {
    Number(f64),
    Text(String),
    Flag(bool),
    List(Vec<Node>),
    Map(Vec<(String, Node)>),
    Other(&'static str),
}

impl Node {
    fn is_map(&self) -> bool {
        matches!(self, Node::Map(_))
    }
}

impl From<toml::Value> for Node {
    fn from(value: toml::Value) -> Node {
        match value {
            toml::Value::Float(number) => Node::Number(number),
            toml::Value::Integer(number) => Node::Number(number as f64),
            toml::Value::String(text) => Node::Text(text),
            toml::Value::Boolean(flag) => Node::Flag(flag),
            toml::Value::Array(list) => Node::List(list.into_iter().map(Node::from).collect()),
            toml::Value::Table(map) => {
                Node::Map(map.into_iter().map(|(k, v)| (k, v.into())).collect())
            }
            toml::Value::Datetime(_) => Node::Other("a date"),
        }
    }
}

impl From<serde_json::Value> for Node {
    fn from(value: serde_json::Value) -> Node {
        match value {
            serde_json::Value::Number(number) => number
                .as_f64()
                .map_or(Node::Other("a number too large"), Node::Number),
            serde_json::Value::String(text) => Node::Text(text),
            serde_json::Value::Bool(flag) => Node::Flag(flag),
            serde_json::Value::Array(list) => {
                Node::List(list.into_iter().map(Node::from).collect())
            }
            serde_json::Value::Object(map) => {
                Node::Map(map.into_iter().map(|(k, v)| (k, v.into())).collect())
            }
            serde_json::Value::Null => Node::Other("null"),
        }
    }
}

/// Longest piece of a foreign message that is passed on.
const MESSAGE_MAX: usize = 300;

fn syntax_error(language: &str, message: &str) -> Vec<InputError> {
    let short: String = message.trim_end().chars().take(MESSAGE_MAX).collect();
    vec![InputError {
        key: String::new(),
        message: format!("this is not {language} that can be read: {short}"),
    }]
}

impl Case {
    /// Reads a case file, TOML or (when it opens with a brace) JSON.
    ///
    /// # Errors
    /// What makes the file unreadable: syntax, a missing or newer schema. Faults of single keys are found by checking.
    pub fn from_text(text: &str) -> Result<Case, Vec<InputError>> {
        if text
            .trim_start_matches(['\u{feff}', ' ', '\t', '\r', '\n'])
            .starts_with('{')
        {
            Case::from_json(text)
        } else {
            Case::from_toml(text)
        }
    }

    /// Reads a case from TOML.
    ///
    /// # Errors
    /// As [`Case::from_text`].
    pub fn from_toml(text: &str) -> Result<Case, Vec<InputError>> {
        let text = text.trim_start_matches('\u{feff}');
        let value: toml::Table = toml::from_str(text).map_err(|e| {
            let place = e
                .span()
                .map(|span| place_of(text, span.start))
                .unwrap_or_default();
            syntax_error("TOML", &format!("{}{place}", e.message()))
        })?;
        Case::from_node(toml::Value::Table(value).into())
    }

    /// Reads a case from JSON.
    ///
    /// # Errors
    /// As [`Case::from_text`].
    pub fn from_json(text: &str) -> Result<Case, Vec<InputError>> {
        let text = text.trim_start_matches('\u{feff}');
        let value: serde_json::Value =
            serde_json::from_str(text).map_err(|e| syntax_error("JSON", &e.to_string()))?;
        Case::from_node(value.into())
    }

    fn from_node(node: Node) -> Result<Case, Vec<InputError>> {
        let Node::Map(map) = node else {
            return Err(syntax_error("a case", "keys and values are expected"));
        };
        if map.is_empty() {
            return Err(vec![InputError {
                key: "schema".to_string(),
                message: format!("the file is empty; a case starts with schema = \"{SCHEMA}\""),
            }]);
        }
        // a case that does not say its version is of the first, which wrote none
        let mut case = Case {
            version: Version::FIRST,
            ..Case::default()
        };
        let mut schema = None;
        for (key, node) in map {
            match (key.as_str(), node) {
                ("schema", Node::Text(text)) => schema = Some(text),
                ("schema", other) => return Err(schema_error(&describe(&other))),
                ("name", Node::Text(text)) => case.name = text,
                ("version", node) => case.version = version(&node)?,
                (_, node) => case.flatten(key, node),
            }
        }
        match schema.as_deref() {
            Some(SCHEMA) => Ok(case),
            Some(other) => Err(schema_error(&format!("\"{other}\""))),
            None => Err(schema_error("nothing")),
        }
    }

    fn flatten(&mut self, key: String, node: Node) {
        let known = input::find(&key);
        let node = match node {
            Node::List(list) if key == SECTION && list.iter().all(Node::is_map) => {
                for (i, phase) in list.into_iter().enumerate() {
                    if let Node::Map(map) = phase {
                        for (part, child) in map {
                            self.flatten(format!("{key}.{}.{part}", i + 1), child);
                        }
                    }
                }
                return;
            }
            Node::Map(map) if !map.is_empty() => {
                for (part, child) in map {
                    self.flatten(format!("{key}.{part}"), child);
                }
                return;
            }
            other => other,
        };
        // A table given where a database is named is a drag table.
        let key = match (&node, known) {
            (Node::List(_), Some(input)) if input.key == "vehicle.aerodynamics" => {
                "vehicle.drag_table".to_string()
            }
            (_, Some(_)) => input::canonical_key(&key),
            _ => key,
        };
        let rows_expected =
            input::find(&key).is_some_and(|input| matches!(input.kind, Kind::Rows(_)));
        let value = match node {
            Node::Number(number) => Value::Number(number),
            Node::Text(text) => Value::Text(text),
            Node::Flag(flag) => Value::Flag(flag),
            Node::List(list) if rows_expected => rows(list),
            other => Value::Other(describe(&other)),
        };
        self.values.insert(key, value);
    }
}

/// Rows of numbers typed as text in brackets; `None` where the text is nothing of the kind.
pub(super) fn rows_of_text(text: &str) -> Option<Value> {
    let mut table: toml::Table = toml::from_str(&format!("rows = {text}")).ok()?;
    match Node::from(table.remove("rows")?) {
        Node::List(list) if table.is_empty() => Some(rows(list)),
        _ => None,
    }
}

fn rows(list: Vec<Node>) -> Value {
    // Numbers without brackets of their own are one row.
    let is_row = !list.is_empty() && list.iter().all(|node| matches!(node, Node::Number(_)));
    let list = if is_row { vec![Node::List(list)] } else { list };
    let mut rows = Vec::with_capacity(list.len());
    for (i, row) in list.into_iter().enumerate() {
        let Node::List(cells) = row else {
            return Value::Other(format!("row {} that is not a list of numbers", i + 1));
        };
        let mut numbers = Vec::with_capacity(cells.len());
        for cell in cells {
            let Node::Number(number) = cell else {
                return Value::Other(format!("row {} with {}", i + 1, describe(&cell)));
            };
            numbers.push(number);
        }
        rows.push(numbers);
    }
    Value::Rows(rows)
}

fn describe(node: &Node) -> String {
    match node {
        Node::Number(number) => number.to_string(),
        Node::Text(text) => format!("\"{text}\""),
        Node::Flag(flag) => flag.to_string(),
        Node::List(_) => "a list".to_string(),
        Node::Map(_) => "an empty table".to_string(),
        Node::Other(what) => (*what).to_string(),
    }
}

fn version(node: &Node) -> Result<Version, Vec<InputError>> {
    let read = match node {
        Node::Text(text) => Version::parse(text),
        _ => None,
    };
    read.filter(|version| *version <= Version::CURRENT)
        .ok_or_else(|| {
            let hint = if read.is_some() {
                "; the case was written for a newer program"
            } else {
                ""
            };
            vec![InputError {
                key: "version".to_string(),
                message: format!(
                    "got {}, must be \"{}\" to \"{}\"{hint}",
                    describe(node),
                    Version::FIRST,
                    Version::CURRENT
                ),
            }]
        })
}

fn schema_error(got: &str) -> Vec<InputError> {
    let newer = got
        .trim_matches('"')
        .strip_prefix("msape/")
        .and_then(|version| version.parse::<u32>().ok())
        .is_some_and(|version| version > 1);
    let hint = if newer {
        "; the case was written for a newer program"
    } else {
        ""
    };
    vec![InputError {
        key: "schema".to_string(),
        message: format!("got {got}, must be \"{SCHEMA}\"{hint}"),
    }]
}

fn place_of(text: &str, offset: usize) -> String {
    let before = text.get(..offset).unwrap_or_default();
    let line = before.matches('\n').count() + 1;
    let column = before
        .rsplit('\n')
        .next()
        .unwrap_or_default()
        .chars()
        .count()
        + 1;
    format!(" (line {line}, column {column})")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn toml_and_json_are_one_model() {
        let toml = Case::from_text("schema = \"msape/1\"\nname=\"a\"\n[entry]\nspeed_m_s = 12000\n[design]\nmsr_mode = true\n[atmosphere]\ntable=[[0,1.2],[1000.0,1.1]]").unwrap();
        let json = Case::from_text(r#" {"schema":"msape/1","name":"a","entry":{"speed_m_s":12000.0},"design":{"msr_mode":true},"atmosphere":{"table":[[0,1.2],[1000,1.1]]}}"#).unwrap();
        assert_eq!(toml, json);
        assert_eq!(toml.values["entry.speed_m_s"], Value::Number(12000.0));
    }

    #[test]
    fn unreadable_files_say_where() {
        let error = |text: &str| Case::from_text(text).unwrap_err()[0].to_string();
        assert!(error("").contains("schema"));
        assert!(error("schema = \"msape/2\"").contains("newer"));
        let newer = error("schema = \"msape/1\"\nversion = \"99.0\"");
        assert!(
            newer.starts_with("version: got \"99.0\", must be"),
            "{newer}"
        );
        assert!(error("schema = \"msape/1\"\nversion = 0.2").contains("must be \"0.1\" to"));
        assert!(error("schema = \"msape/1\"\nname = ").contains("line 2"));
        assert!(error("{\"schema\": ").contains("JSON"));
        assert!(error(&"\u{1}garbage ".repeat(100_000)).len() < 500);
    }

    #[test]
    fn inline_models_flatten_to_dotted_keys() {
        let case = Case::from_toml("schema='msape/1'\n[atmosphere]\nexponential = { density_kg_m3 = 1.215, scale_height_m = 8500.0 }\n[vehicle]\naerodynamics = [[0.0, 1.0], [2.0, 1.5]]").unwrap();
        assert_eq!(
            case.values["atmosphere.exponential.density_kg_m3"],
            Value::Number(1.215)
        );
        assert!(matches!(case.values["vehicle.drag_table"], Value::Rows(_)));
    }
}
