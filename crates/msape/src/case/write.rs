//! Writes a case as TOML or JSON, keys in the order of the quantity list.

use super::{Case, SCHEMA, Value};
use crate::quantity::input::repeated::{SECTIONS, Section};
use crate::quantity::input::{find, inputs};
use std::fmt::Write;

impl Case {
    /// Keys that are given with the place where each is written, known ones first in the order of the list, then the others.
    ///
    /// A name that shares its key with a section is written in the section: `vehicle.aerodynamics.name`.
    fn ordered(&self) -> Vec<(Place, &Value)> {
        let known = inputs().filter_map(|input| self.values.get_key_value(input.key));
        let is_known = |key: &str| inputs().any(|input| input.key == key);
        let of_one = |key: &str| find(key).is_some() && !is_known(key);
        let unknown = (self.values.iter()).filter(|(key, _)| !is_known(key) && !of_one(key));
        let of_section = |section: &'static Section, number: usize| {
            inputs()
                .filter(|input| section.after(input.key).is_some())
                .filter_map(move |input| {
                    self.values.get_key_value(&*input.of_number(number).text())
                })
        };
        let repeated = SECTIONS.iter().flat_map(|section| {
            (1..=section.most).flat_map(move |number| of_section(section, number))
        });
        known
            .chain(unknown)
            .chain(repeated)
            .map(|(key, value)| (self.place(key), value))
            .collect()
    }

    /// Whether a key below this one is given.
    fn holds_below(&self, key: &str) -> bool {
        let section = format!("{key}.");
        let after = self.values.range(section.clone()..).next();
        after.is_some_and(|(next, _)| next.starts_with(&section))
    }

    fn place(&self, key: &str) -> Place {
        let named = |key: &str| self.holds_below(key) && is_named_in_section(key);
        let mut above = key.match_indices('.').filter_map(|(end, _)| key.get(..end));
        // a key with a value cannot be a section as well
        let below_a_value = above.any(|above| self.values.contains_key(above) && !named(above));
        let key = if named(key) {
            format!("{key}.name")
        } else {
            key.to_string()
        };
        match key.rsplit_once('.') {
            Some((section, name))
                if !below_a_value && key.split('.').all(is_bare) && !is_odd(section) =>
            {
                Place {
                    section: section.to_string(),
                    name: name.to_string(),
                }
            }
            // quoted as a whole it is unambiguous: its parts may be empty, or contain characters not allowed in a bare key
            _ => Place {
                section: String::new(),
                name: key,
            },
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
        let mut sections: Vec<(&str, String)> = Vec::new();
        // Writing into a String cannot fail.
        for (Place { section, name }, value) in &ordered {
            let name = if is_bare(name) {
                name.clone()
            } else {
                quoted_key(name)
            };
            let line = format!("{name} = {}\n", spelled(value));
            if section.is_empty() {
                text.push_str(&line);
                continue;
            }
            match sections.iter_mut().find(|(other, _)| other == section) {
                Some((_, lines)) => lines.push_str(&line),
                None => sections.push((section, line)),
            }
        }
        // repeated ones in their order, also where one has a key that is not known
        sections
            .sort_by_key(|(section, _)| number_of(section).map(|(of, number)| (of.name, number)));
        let mut before = ("", 0);
        for (section, lines) in sections {
            match number_of(section) {
                Some((of, number)) => {
                    let written = if before.0 == of.name { before.1 } else { 0 };
                    // Those without inputs keep their place.
                    let heads = number.saturating_sub(written);
                    text.push_str(&format!("\n[[{}]]\n", of.name).repeat(heads));
                    text.push_str(&lines);
                    before = (of.name, number);
                }
                None => {
                    let _ = write!(text, "\n[{section}]\n{lines}");
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
        for (Place { section, name }, value) in self.ordered() {
            let value = match value {
                Value::Number(number) => (*number).into(),
                Value::Text(text) => text.as_str().into(),
                Value::Flag(flag) => (*flag).into(),
                Value::Rows(rows) => serde_json::json!(rows),
                Value::Other(spelling) => json_of(spelling),
            };
            insert(&mut root, &section, name, value);
        }
        for section in &SECTIONS {
            as_list(&mut root, section.name, section);
        }
        format!("{:#}\n", serde_json::Value::Object(root))
    }
}

/// Place at which a key is written: its section, empty for none, and its name there.
struct Place {
    section: String,
    name: String,
}

/// Whether a part of a key needs no quotes.
fn is_bare(part: &str) -> bool {
    let fits = |b: u8| b.is_ascii_alphanumeric() || b == b'_' || b == b'-';
    !part.is_empty() && part.bytes().all(fits)
}

/// A key in quotes, on one line: the escapes of JSON are those of TOML, which knows one control character more.
pub(super) fn quoted_key(key: &str) -> String {
    let quoted = serde_json::Value::String(key.to_string()).to_string();
    quoted.replace('\u{7f}', "\\u007f")
}

/// Whether an input may also be given as `name` in the section of its key.
fn is_named_in_section(key: &str) -> bool {
    find(&format!("{key}.name")).is_some_and(|input| input.key == key)
}

/// Whether a section begins like a repeated one but is none of them.
fn is_odd(section: &str) -> bool {
    let of = SECTIONS
        .iter()
        .any(|of| of.name == section || of.after(section).is_some());
    of && number_of(section).is_none()
}

/// The repeated section to which a section belongs, and its number.
fn number_of(section: &str) -> Option<(&'static Section, usize)> {
    let of = Section::of(section)?;
    Some((of, of.number(of.after(section)?)?))
}

/// Makes a list of the tables that a repeated section has by number.
fn as_list(map: &mut serde_json::Map<String, serde_json::Value>, name: &str, section: &Section) {
    if let Some((first, rest)) = name.split_once('.') {
        if let Some(serde_json::Value::Object(child)) = map.get_mut(first) {
            as_list(child, rest, section);
        }
        return;
    }
    if let Some(serde_json::Value::Object(numbered)) = map.get_mut(name)
        && numbered
            .keys()
            .all(|number| section.number(number).is_some())
    {
        let of = |number: usize| numbered.remove(&number.to_string());
        let mut all: Vec<_> = (1..=section.most).map(of).collect();
        let last = all.iter().rposition(Option::is_some);
        all.truncate(last.map_or(0, |last| last + 1));
        let all = all
            .into_iter()
            .map(|one| one.unwrap_or_else(|| serde_json::json!({})));
        map.insert(name.to_string(), all.collect());
    }
}

/// Puts a value into a section of dotted name.
fn insert(
    map: &mut serde_json::Map<String, serde_json::Value>,
    section: &str,
    name: String,
    value: serde_json::Value,
) {
    let (first, rest) = section.split_once('.').unwrap_or((section, ""));
    if first.is_empty() {
        map.insert(name, value);
        return;
    }
    let child = map
        .entry(first.to_string())
        .or_insert_with(|| serde_json::Value::Object(serde_json::Map::new()));
    if let serde_json::Value::Object(child) = child {
        insert(child, rest, name, value);
    }
}

/// A value of TOML as JSON; a date as its text.
fn json_of(spelling: &str) -> serde_json::Value {
    let table: Option<toml::Table> = toml::from_str(&format!("value = {spelling}")).ok();
    let value = table.and_then(|mut table| table.remove("value"));
    value.map_or(serde_json::Value::Null, |value| match value {
        toml::Value::Datetime(date) => date.to_string().into(),
        value => serde_json::to_value(value).unwrap_or(serde_json::Value::Null),
    })
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
        // TOML has no null
        Value::Other(spelling) if spelling == "null" => quoted(spelling),
        Value::Other(spelling) => spelling.clone(),
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
    fn odd_keys_are_written_so_that_they_read_back() {
        let odd = [
            "description",
            "my key",
            "a.b c",
            "",
            ".",
            "a.",
            ".a",
            "a..b",
            "entry",
            "a",
            "a.b",
            "a.b.c",
            "a\"b\\c",
            "ä.ö",
            "entry.sped_m_s",
            "design.density_kg_m3.foam.x",
            "vehicle.aerodynamics.nam",
            "x\n[y]\n",
            "atmosphere.table.x",
            "vehicle.aerodynamics.table.extra",
            "#",
            "3.14",
            "\u{7f}\u{1b}",
        ];
        let mut case = Case::run_page();
        case.set("vehicle.aerodynamics", "outline");
        case.set("vehicle.aerodynamics.table", "[[1, 0, 1, 0]]");
        case.set("atmosphere.table", "[[0, 1.2], [1, 1.1]]");
        for key in odd {
            case.values.insert(key.to_string(), Value::Number(1.0));
        }
        assert_eq!(Case::from_toml(&case.to_toml()).unwrap(), case);
        assert_eq!(Case::from_json(&case.to_json()).unwrap(), case);
        let mut plain = Case::default();
        plain
            .values
            .insert("entry.sped_m_s".to_string(), Value::Number(1.0));
        assert!(
            plain.to_toml().ends_with("\n[entry]\nsped_m_s = 1.0\n"),
            "{}",
            plain.to_toml()
        );
    }

    #[test]
    fn a_key_of_a_phase_that_is_not_known_stays_in_its_phase() {
        for number in 1..=3 {
            let mut case = Case::default();
            for phase in 1..=3 {
                case.set(&format!("phase.{phase}.time_s"), "10");
            }
            let odd = format!("phase.{number}.drag_area_m0");
            case.values.insert(odd, Value::Number(1.0));
            assert_eq!(Case::from_toml(&case.to_toml()).unwrap(), case);
            assert_eq!(Case::from_json(&case.to_json()).unwrap(), case);
        }
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
