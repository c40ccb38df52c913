//! Writes a case as TOML or JSON, keys in the order of the quantity list.

use super::{Case, SCHEMA, Value};
use crate::quantity::input::phase::{MOST, SECTION, is_repeated};
use crate::quantity::input::{find, inputs};
use std::fmt::Write;

impl Case {
    /// Keys that are given, known ones first in the order of the list, then the others.
    ///
    /// A name that shares its key with a section stands in the section: `vehicle.aerodynamics.name`.
    fn ordered(&self) -> Vec<(String, &Value)> {
        let known = inputs().filter_map(|input| self.values.get_key_value(input.key));
        let is_known = |key: &str| inputs().any(|input| input.key == key);
        let of_phase = |key: &str| find(key).is_some() && !is_known(key);
        let unknown = (self.values.iter()).filter(|(key, _)| !is_known(key) && !of_phase(key));
        let phases = (1..=MOST).flat_map(|number| {
            inputs()
                .filter(|input| is_repeated(input.key))
                .filter_map(move |input| {
                    let name = input.key.strip_prefix(SECTION)?;
                    self.values
                        .get_key_value(&format!("{SECTION}.{number}{name}"))
                })
        });
        known
            .chain(unknown)
            .chain(phases)
            .map(|(key, value)| (self.place(key), value))
            .collect()
    }

    fn place(&self, key: &str) -> String {
        let section = format!("{key}.");
        let after = self.values.range(section.clone()..).next();
        match after {
            Some((next, _)) if next.starts_with(&section) => format!("{section}name"),
            _ => key.to_string(),
        }
    }

    /// The case as a TOML file.
    pub fn to_toml(&self) -> String {
        let mut text = format!(
            "schema = {}\nversion = {}\nname = {}\n",
            quoted(SCHEMA),
            quoted(&self.version.to_string()),
            quoted(&self.name)
        );
        let ordered = self.ordered();
        let mut sections: Vec<&str> = Vec::new();
        for (key, _) in &ordered {
            let section = key.rsplit_once('.').map_or("", |(section, _)| section);
            if !sections.contains(&section) {
                sections.push(section);
            }
        }
        // Writing into a String cannot fail.
        let mut phases = 0;
        for section in sections {
            match phase_number(section) {
                Some(number) => {
                    // Phases that nothing is given for keep their place.
                    let before = number.saturating_sub(phases);
                    text.push_str(&format!("\n[[{SECTION}]]\n").repeat(before));
                    phases = number;
                }
                None => {
                    let _ = write!(text, "\n[{section}]\n");
                }
            }
            for (key, value) in &ordered {
                if key.rsplit_once('.').map_or("", |(section, _)| section) == section {
                    let name = key.rsplit_once('.').map_or(key.as_str(), |(_, name)| name);
                    let _ = writeln!(text, "{name} = {}", spelled(value));
                }
            }
        }
        text
    }

    /// The case as JSON.
    pub fn to_json(&self) -> String {
        let mut root = serde_json::Map::new();
        root.insert("schema".to_string(), SCHEMA.into());
        root.insert("version".to_string(), self.version.to_string().into());
        root.insert("name".to_string(), self.name.as_str().into());
        for (key, value) in self.ordered() {
            let value = match value {
                Value::Number(number) => (*number).into(),
                Value::Text(text) => text.as_str().into(),
                Value::Flag(flag) => (*flag).into(),
                Value::Rows(rows) => serde_json::json!(rows),
                Value::Other(_) => serde_json::Value::Null,
            };
            insert(&mut root, &key, value);
        }
        if let Some(serde_json::Value::Object(numbered)) = root.get_mut(SECTION)
            && (numbered.keys())
                .all(|number| phase_number(&format!("{SECTION}.{number}")).is_some())
        {
            let of = |number: usize| numbered.remove(&number.to_string());
            let mut phases: Vec<_> = (1..=MOST).map(of).collect();
            let last = phases.iter().rposition(Option::is_some);
            phases.truncate(last.map_or(0, |last| last + 1));
            let phases = phases
                .into_iter()
                .map(|phase| phase.unwrap_or_else(|| serde_json::json!({})));
            root.insert(SECTION.to_string(), phases.collect());
        }
        format!("{:#}\n", serde_json::Value::Object(root))
    }
}

/// The number of the phase that a section is of.
fn phase_number(section: &str) -> Option<usize> {
    let number = section.strip_prefix(SECTION)?.strip_prefix('.')?;
    let index: usize = number.parse().ok()?;
    ((1..=MOST).contains(&index) && number == index.to_string()).then_some(index)
}

/// Puts a value under a dotted key.
fn insert(
    map: &mut serde_json::Map<String, serde_json::Value>,
    key: &str,
    value: serde_json::Value,
) {
    match key.split_once('.') {
        None => {
            map.insert(key.to_string(), value);
        }
        Some((section, rest)) => {
            let child = map
                .entry(section.to_string())
                .or_insert_with(|| serde_json::Value::Object(serde_json::Map::new()));
            if let serde_json::Value::Object(child) = child {
                insert(child, rest, value);
            }
        }
    }
}

fn spelled(value: &Value) -> String {
    match value {
        Value::Number(number) => spelled_number(*number),
        Value::Text(text) => quoted(text),
        Value::Flag(flag) => flag.to_string(),
        Value::Rows(rows) => {
            let rows: Vec<String> = rows
                .iter()
                .map(|row| {
                    format!(
                        "    [{}],\n",
                        row.iter()
                            .map(|x| spelled_number(*x))
                            .collect::<Vec<_>>()
                            .join(", ")
                    )
                })
                .collect();
            format!("[\n{}]", rows.concat())
        }
        Value::Other(what) => quoted(what),
    }
}

/// The shortest spelling that reads back to the same bits, always with a point so that it stays a TOML float.
fn spelled_number(number: f64) -> String {
    if number.is_nan() {
        return "nan".to_string();
    }
    if number.is_infinite() {
        return if number > 0.0 { "inf" } else { "-inf" }.to_string();
    }
    if number != 0.0 && !(1e-5..1e16).contains(&number.abs()) {
        let text = format!("{number:e}");
        return match text.split_once('e') {
            Some((mantissa, exponent)) if !mantissa.contains('.') => {
                format!("{mantissa}.0e{exponent}")
            }
            _ => text,
        };
    }
    format!("{number:?}")
}

fn quoted(text: &str) -> String {
    toml::Value::String(text.to_string()).to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_reads_back_the_same() {
        let mut case = Case::run_page();
        case.name = "quoted \"name\"\nsecond line".to_string();
        case.set("entry.speed_m_s", "11.56 km/s");
        case.set("entry.azimuth_deg", "1e-7");
        case.set("planet.mu_m3_s2", "3.986e14");
        case.values.insert(
            "atmosphere.table".to_string(),
            Value::Rows(vec![vec![0.0, 1.225], vec![1e3, 1.1]]),
        );
        assert_eq!(Case::from_toml(&case.to_toml()).unwrap(), case);
        assert_eq!(Case::from_json(&case.to_json()).unwrap(), case);
    }

    #[test]
    fn phases_are_written_as_a_list_and_keep_their_places() {
        let mut case = Case::run_page();
        case.set("phase.name", "drogue");
        case.set("phase.altitude_m", "31 km");
        case.set("phase.12.name", "main");
        case.set("phase.12.attachment_m", "[0.5, 0, 0]");
        let toml = case.to_toml();
        assert!(
            toml.contains("\n[[phase]]\nname = \"drogue\"\naltitude_m = \"31 km\"\n\n[[phase]]\n")
        );
        assert_eq!(toml.matches("[[phase]]").count(), 12);
        assert_eq!(Case::from_toml(&toml).unwrap(), case);
        assert_eq!(Case::from_json(&case.to_json()).unwrap(), case);
    }
}
