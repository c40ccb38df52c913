//! Reads a case from TOML or JSON: one data model, two notations.

use super::node::{Node, describe, rows, spelled};
use super::{Case, InputError, SCHEMA, Value, Version};
use crate::quantity::input::repeated::Section;
use crate::quantity::input::{self, Kind};
use crate::units::cut;
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

/// Largest length of a parser message in a fault.
const MESSAGE_MAX: usize = 300;

/// Keys of a file, at most: ten times as many as a case with the largest number of phases has.
const MOST_KEYS: usize = 10_000;

/// Whether a text opens with a brace, as JSON does.
fn is_json(text: &str) -> bool {
    let blank = ['\u{feff}', ' ', '\t', '\r', '\n'];
    text.trim_start_matches(blank).starts_with('{')
}

/// A fault of a text with more keys than any case has, before it is taken apart: signs that follow a key, and headings of sections, are
/// counted, those in texts too.
fn short_enough(text: &str) -> Result<(), Vec<InputError>> {
    let is_json = is_json(text);
    let sign = if is_json { b':' } else { b'=' };
    let signs = text
        .bytes()
        .filter(|byte| *byte == sign)
        .take(MOST_KEYS + 1)
        .count();
    let heads = |line: &&str| {
        let name = line.trim_start().trim_start_matches('[');
        !is_json
            && name.len() < line.trim_start().len()
            && name.starts_with(|c: char| c.is_alphabetic() || c == '_' || c == '"' || c == '\'')
            && !name.contains(',')
    };
    let sections = text.lines().filter(heads).take(MOST_KEYS + 1).count();
    if signs + sections > MOST_KEYS {
        let message =
            format!("the file holds more than {MOST_KEYS} keys and sections, as no case does");
        return Err(vec![InputError {
            key: String::new(),
            message,
        }]);
    }
    Ok(())
}

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
    /// Faults that make the file unreadable: syntax, a missing or newer schema. Faults of single keys are found by the check.
    pub fn from_text(text: &str) -> Result<Case, Vec<InputError>> {
        short_enough(text)?;
        if is_json(text) {
            Case::from_json(text)
        } else {
            Case::from_toml(text)
        }
    }

    /// Reads a case from TOML.
    ///
    /// # Errors
    /// The errors of [`Case::from_text`].
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
    /// The errors of [`Case::from_text`].
    pub fn from_json(text: &str) -> Result<Case, Vec<InputError>> {
        let text = text.trim_start_matches('\u{feff}');
        let node: Node =
            serde_json::from_str(text).map_err(|e| syntax_error("JSON", &e.to_string()))?;
        Case::from_node(node)
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
        let mut taken = Taken::default();
        for (key, node) in map {
            if ["schema", "name", "version"].contains(&key.as_str()) {
                taken.take(&key, &key);
            }
            match (key.as_str(), node) {
                ("schema", Node::Text(text)) => schema = Some(text),
                ("schema", other) => return Err(schema_error(&describe(&other))),
                ("name", Node::Text(text)) => case.name = text,
                ("name", other) => {
                    return Err(vec![InputError {
                        key,
                        message: format!("got {}, must be text", describe(&other)),
                    }]);
                }
                ("version", node) => case.version = version(&node)?,
                (_, node) => case.flatten(key, node, &mut taken),
            }
        }
        match schema.as_deref() {
            Some(SCHEMA) if taken.twice.is_empty() => Ok(case),
            Some(SCHEMA) => Err(taken.twice),
            Some(other) => Err(schema_error(&format!("\"{}\"", cut(other)))),
            None => Err(schema_error("nothing")),
        }
    }

    fn flatten(&mut self, key: String, node: Node, taken: &mut Taken) {
        let node = match node {
            Node::List(list) if Section::named(&key).is_some() && list.iter().all(Node::is_map) => {
                for (i, one) in list.into_iter().enumerate() {
                    if let Node::Map(map) = one {
                        for (part, child) in map {
                            self.flatten(format!("{key}.{}.{part}", i + 1), child, taken);
                        }
                    }
                }
                return;
            }
            Node::Map(map) if !map.is_empty() => {
                for (part, child) in map {
                    self.flatten(format!("{key}.{part}"), child, taken);
                }
                return;
            }
            other => other,
        };
        let known = input::find(&key);
        // A table given where a database is named is a drag table.
        let (known, place) = match (&node, known) {
            (Node::List(_), Some(named)) if *named == input::vehicle::AERODYNAMICS => {
                let table = &input::vehicle::DRAG_TABLE;
                (Some(table), table.to_string())
            }
            _ => (known, input::canonical_key(&key)),
        };
        let rows_expected = known.is_some_and(|input| matches!(input.kind, Kind::Rows(_)));
        let value = match node {
            Node::Number(number) => Value::Number(number),
            Node::Text(text) => Value::Text(text),
            Node::Flag(flag) => Value::Flag(flag),
            other => match rows_expected.then(|| rows(&other)) {
                Some(Ok(rows)) => Value::Rows(rows),
                _ => Value::Other(spelled(&other)),
            },
        };
        match known {
            Some(_) => {
                taken.take(&place, &key);
                self.values.insert(place, value);
            }
            // an unknown key has one spelling
            None => match self.values.entry(key) {
                Entry::Vacant(place) => {
                    place.insert(value);
                }
                Entry::Occupied(place) => taken.fault(place.key(), STANDS_TWICE.to_string()),
            },
        }
    }
}

const STANDS_TWICE: &str = "stands twice; give it once";
/// Largest number of reported keys that are given twice.
const TWICE_MAX: usize = 100;

/// Known keys that have been given, each with its spelling, and faults of keys given twice.
#[derive(Default)]
struct Taken {
    spellings: BTreeMap<String, String>,
    twice: Vec<InputError>,
}

impl Taken {
    fn take(&mut self, key: &str, spelling: &str) {
        let Some(first) = self.spellings.insert(key.to_string(), spelling.to_string()) else {
            return;
        };
        let message = if first == spelling {
            STANDS_TWICE.to_string()
        } else {
            format!(
                "stands twice, as {} and as {}; give one of them",
                cut(&first),
                cut(spelling)
            )
        };
        self.fault(key, message);
    }

    fn fault(&mut self, key: &str, message: String) {
        if self.twice.len() < TWICE_MAX {
            self.twice.push(InputError {
                key: cut(key),
                message,
            });
        }
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
    use super::super::node::described;
    use super::*;

    #[test]
    fn toml_and_json_are_one_model() {
        let toml = Case::from_text("schema = \"msape/1\"\nname=\"a\"\n[entry]\nspeed_m_s = 12000\n[design]\nmsr_mode = true\n[atmosphere]\ntable=[[0,1.2],[1000.0,1.1]]").unwrap();
        let json = Case::from_text(r#" {"schema":"msape/1","name":"a","entry":{"speed_m_s":12000.0},"design":{"msr_mode":true},"atmosphere":{"table":[[0,1.2],[1000,1.1]]}}"#).unwrap();
        assert_eq!(toml, json);
        assert_eq!(toml.values["entry.speed_m_s"], Value::Number(12000.0));
    }

    #[test]
    fn a_file_of_very_many_keys_is_refused_before_it_is_taken_apart() {
        let toml: String = (0..20_000).map(|i| format!("k{i} = 1\n")).collect();
        let sections: String = (0..20_000).map(|i| format!("[s{i}]\n")).collect();
        let keys: Vec<String> = (0..20_000).map(|i| format!("\"k{i}\": 1")).collect();
        for text in [toml, sections, format!("{{{}}}", keys.join(","))] {
            let faults = Case::from_text(&text).unwrap_err();
            assert!(
                faults[0].message.contains("more than 10000 keys"),
                "{faults:?}"
            );
        }
        // rows are no keys
        let rows: String = (0..20_000).map(|i| format!("[{i}.0, 1.0],\n")).collect();
        let text = format!("schema = \"msape/1\"\n[wind]\ntable = [\n{rows}]\n");
        assert!(Case::from_text(&text).is_ok());
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
    fn a_key_stands_once_whatever_its_spelling() {
        let twice = |text: &str| {
            let faults = Case::from_text(text).unwrap_err();
            faults[0].to_string()
        };
        let told = "entry.speed_m_s: stands twice; give it once";
        for entries in [
            r#""entry":{"speed_m_s":1,"speed_m_s":2}"#,
            r#""entry":{"speed_m_s":1},"entry.speed_m_s":2"#,
            r#""entry":{"speed_m_s":1},"entry":{"speed_m_s":2}"#,
            r#""entry.speed_m_s":1,"entry.speed_m_s":2"#,
        ] {
            assert_eq!(
                twice(&format!("{{\"schema\":\"msape/1\",{entries}}}")),
                told
            );
        }
        assert_eq!(
            twice("schema='msape/1'\n\"entry.speed_m_s\"=1\n[entry]\nspeed_m_s=2\n"),
            told
        );
        let spellings = twice(
            "schema='msape/1'\n[planet]\nradius_m=1.0\nequatorial_radius_m=2.0\nr_equatorial_m=3.0\n",
        );
        assert!(
            spellings.starts_with("planet.equatorial_radius_m: stands twice, as planet."),
            "{spellings}"
        );
        let drag = twice(
            "schema='msape/1'\n[vehicle]\naerodynamics=[[0.0,1.0]]\ndrag_table=[[0.0,1.0]]\n",
        );
        assert_eq!(
            drag,
            "vehicle.drag_table: stands twice, as vehicle.aerodynamics and as vehicle.drag_table; give one of them"
        );
        assert!(
            twice(r#"{"schema":"msape/1","schema":"msape/1"}"#).starts_with("schema: stands twice")
        );
        assert!(
            twice(r#"{"schema":"msape/1","a":{"b":1},"a.b":2}"#).starts_with("a.b: stands twice")
        );
        assert!(
            twice(r#"{"schema":"msape/1","name":"a","name":"b"}"#)
                .starts_with("name: stands twice")
        );
        assert!(twice("schema='msape/1'\n[entry]\nspeed_m_s=1\nspeed_m_s=2\n").contains("TOML"));
        assert!(twice("schema='msape/1'\nname=3\n").contains("must be text"));
    }

    #[test]
    fn what_no_input_takes_is_kept_as_it_was_spelled() {
        let case = Case::from_toml("schema='msape/1'\nwhen=1979-05-27\nlist=[1,'a',[],{b=2}]\n[atmosphere]\ntable=[[0,1.2],[1,'x']]\n").unwrap();
        assert_eq!(case.values["when"], Value::Other("1979-05-27".to_string()));
        assert_eq!(described("1979-05-27", false), "a date");
        let Value::Other(table) = &case.values["atmosphere.table"] else {
            unreachable!()
        };
        assert_eq!(described(table, true), "row 2 with \"x\"");
        assert_eq!(Case::from_toml(&case.to_toml()).unwrap(), case);
        assert_eq!(
            Case::from_json(&case.to_json()).unwrap().values["list"],
            case.values["list"]
        );
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
