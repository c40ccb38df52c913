//! JSON Schema (draft 2020-12) of the case file, from the list of inputs, so that editors complete and check cases.
//!
//! The program itself is more lenient: it reads names as the report spells them, such as `SuttonGraves`.

use crate::case::{SCHEMA, Version};
use crate::library::Library;
use crate::quantity::input::repeated::SECTIONS;
use crate::quantity::input::{self, Input, Kind, Need, Preset, inputs};
use crate::units::{canonical, units_of};
use serde_json::{Map, Value, json};

/// The schema of case files whose names are those of `library`.
pub fn schema(library: &Library) -> Value {
    let mut root = object("A case: what to fly, or what to design.");
    property(
        &mut root,
        "schema",
        json!({ "const": SCHEMA, "description": "Version of the case file." }),
    );
    property(
        &mut root,
        "version",
        json!({
            "type": "string",
            "pattern": "^[0-9]+\\.[0-9]+(\\.[0-9]+)?$",
            "description": format!("Version of the program whose defaults the case was written for; this one is {}, absent means {}.", Version::CURRENT, Version::FIRST),
        }),
    );
    property(
        &mut root,
        "name",
        json!({ "type": "string", "description": "Free text." }),
    );
    let mut repeated = SECTIONS
        .each_ref()
        .map(|section| (section, object(section.help)));
    for input in inputs() {
        let described = input_schema(input, library);
        let mut of = repeated.iter_mut();
        if let Some((name, one)) =
            of.find_map(|(section, one)| Some((section.after(input.key)?, one)))
        {
            property(one, name, described.into());
            continue;
        }
        insert(&mut root, input.key, described.clone().into());
        for alias in input.aliases {
            let mut other_name = described.clone();
            other_name.insert("deprecated".to_string(), json!(true));
            insert(&mut root, alias, other_name.into());
        }
        if input.need != Need::Optional {
            require(&mut root, input.key);
        }
    }
    for (section, mut one) in repeated {
        if !section.required.is_empty() {
            one.insert("required".to_string(), json!(section.required));
        }
        let list = json!({
            "type": "array",
            "maxItems": section.most,
            "items": one,
            "description": section.list_help,
        });
        insert(&mut root, section.name, list);
    }
    // A table of numbers in the place of the name of a database is a drag table; a section holds constants.
    if let Some(Value::Object(mut by_name)) =
        find(&mut root, input::vehicle::AERODYNAMICS.key).map(Value::take)
        && let Some(table) = find(&mut root, input::vehicle::DRAG_TABLE.key).cloned()
        && let Some(place) = find(&mut root, input::vehicle::AERODYNAMICS.key)
    {
        let constants = by_name.remove("properties").unwrap_or(json!({}));
        *place = json!({
            "anyOf": [by_name, table, { "type": "object" }],
            "properties": constants,
            "additionalProperties": false,
        });
    }
    let mut schema = Map::new();
    schema.insert(
        "$schema".to_string(),
        json!("https://json-schema.org/draft/2020-12/schema"),
    );
    schema.insert("title".to_string(), json!(SCHEMA));
    schema.append(&mut root);
    schema.insert("required".to_string(), json!(["schema"]));
    schema.insert(
        "anyOf".to_string(),
        // An outline has the nose that a vehicle without one must be given.
        json!([
            { "required": ["tps"] },
            { "required": ["entry", "vehicle"], "properties": { "vehicle": { "required": ["nose_radius_m"] } } },
            { "required": ["entry", "vehicle", "outline"] },
            { "required": ["entry", "design"] },
        ]),
    );
    Value::Object(schema)
}

fn input_schema(input: &Input, library: &Library) -> Map<String, Value> {
    let mut map = Map::new();
    let mut put = |key: &str, value: Value| {
        map.insert(key.to_string(), value);
    };
    put("title", json!(input.label));
    put(
        "description",
        json!(format!("{} Source: {}.", input.help, input.source)),
    );
    match input.preset {
        Preset::Absent => {}
        Preset::Number(number) => put("default", json!(number)),
        Preset::Name(name) => put("default", json!(name)),
        Preset::Flag(flag) => put("default", json!(flag)),
    }
    match input.kind {
        Kind::Number {
            dimension,
            allowed,
            whole,
            ..
        } => {
            let lower = if allowed.min_included {
                "minimum"
            } else {
                "exclusiveMinimum"
            };
            let kind = if whole { "integer" } else { "number" };
            let units: Vec<&str> = units_of(dimension)
                .map(|unit| unit.symbol)
                .filter(|symbol| !symbol.is_empty())
                .collect();
            let with_unit = if units.is_empty() {
                "A number as text.".to_string()
            } else {
                format!("A number with its unit: {}.", units.join(", "))
            };
            let unit = canonical(dimension).symbol;
            let mut number = Map::new();
            number.insert("type".to_string(), json!(kind));
            number.insert(lower.to_string(), json!(allowed.min));
            number.insert("maximum".to_string(), json!(allowed.max));
            if !unit.is_empty() {
                number.insert("description".to_string(), json!(format!("In {unit}.")));
            }
            // A digit somewhere: the units themselves are checked by the program.
            let text = json!({ "type": "string", "pattern": "[0-9]", "description": with_unit });
            put("anyOf", json!([number, text]));
        }
        Kind::Choice(choices) => {
            put("type", json!("string"));
            let choices = library.choices(choices);
            if !choices.is_empty() {
                let names: Vec<&String> = choices.iter().map(|(name, _)| name).collect();
                put("enum", json!(names));
            }
        }
        Kind::Flag => put("type", json!("boolean")),
        Kind::Text => put("type", json!("string")),
        Kind::Rows(columns) => {
            let names: Vec<&str> = columns.iter().map(|column| column.name).collect();
            let fewest = columns.iter().filter(|column| column.required).count();
            let row = json!({
                "type": "array",
                "items": { "type": "number" },
                "minItems": fewest,
                "maxItems": columns.len(),
                "description": names.join(", "),
            });
            if input.one_row {
                let rows = json!({ "type": "array", "minItems": 1, "maxItems": 1, "items": row });
                put("anyOf", json!([row, rows]));
            } else {
                put("type", json!("array"));
                put("minItems", json!(1));
                put("items", row);
            }
        }
    }
    map
}

fn object(description: &str) -> Map<String, Value> {
    let Value::Object(map) = json!({
        "description": description,
        "type": "object",
        "properties": {},
        "additionalProperties": false,
    }) else {
        return Map::new();
    };
    map
}

fn property(object: &mut Map<String, Value>, name: &str, schema: Value) {
    let properties = object
        .entry("properties".to_string())
        .or_insert_with(|| json!({}));
    if let Value::Object(properties) = properties {
        properties.insert(name.to_string(), schema);
    }
}

/// Puts a schema under a dotted key, with the objects on the way to it.
fn insert(root: &mut Map<String, Value>, key: &str, schema: Value) {
    let Some((section, rest)) = key.split_once('.') else {
        return property(root, key, schema);
    };
    if let Some(Value::Object(properties)) = root.get_mut("properties") {
        let child = properties
            .entry(section.to_string())
            .or_insert_with(|| object(&format!("Keys of {section}.")).into());
        if let Value::Object(child) = child {
            insert(child, rest, schema);
        }
    }
}

/// The schema under a dotted key.
fn find<'m>(root: &'m mut Map<String, Value>, key: &str) -> Option<&'m mut Value> {
    let (section, rest) = match key.split_once('.') {
        Some((section, rest)) => (section, Some(rest)),
        None => (key, None),
    };
    let child = root.get_mut("properties")?.get_mut(section)?;
    match rest {
        None => Some(child),
        Some(rest) => find(child.as_object_mut()?, rest),
    }
}

/// Makes a key required where its section is given.
fn require(root: &mut Map<String, Value>, key: &str) {
    let Some((section, name)) = key.rsplit_once('.') else {
        return;
    };
    if let Some(Value::Object(section)) = find(root, section) {
        let required = section
            .entry("required".to_string())
            .or_insert_with(|| json!([]));
        if let Value::Array(names) = required {
            names.push(json!(name));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quantity::input::repeated::Section;

    fn built() -> Value {
        schema(&Library::builtin().unwrap())
    }

    #[test]
    fn every_input_stands_where_its_key_says() {
        let schema = built();
        for input in inputs() {
            let place = match Section::of(input.key) {
                Some(section) => {
                    input
                        .key
                        .replacen(section.name, &format!("{}.items", section.name), 1)
                }
                None => input.key.to_string(),
            };
            let pointer = place
                .split('.')
                .map(|part| match part {
                    "items" => "/items".to_string(),
                    part => format!("/properties/{part}"),
                })
                .collect::<String>();
            assert!(schema.pointer(&pointer).is_some(), "{}", input.key);
        }
        assert_eq!(
            schema["properties"]["entry"]["additionalProperties"],
            json!(false)
        );
    }

    #[test]
    fn ranges_units_choices_and_needs_are_told() {
        let schema = built();
        let entry = &schema["properties"]["entry"];
        let nose = &schema["properties"]["vehicle"]["properties"]["nose_radius_m"];
        assert_eq!(nose["anyOf"][0]["exclusiveMinimum"], json!(0.0));
        assert_eq!(nose["anyOf"][0]["maximum"], json!(1000.0));
        assert_eq!(nose["anyOf"][0]["description"], json!("In m."));
        assert_eq!(
            entry["properties"]["frame"]["enum"],
            json!(["relative", "inertial"])
        );
        assert_eq!(entry["properties"]["frame"]["default"], json!("relative"));
        let required = entry["required"].as_array().unwrap();
        assert!(required.contains(&json!("speed_m_s")) && !required.contains(&json!("frame")));
        let iterations = &schema["properties"]["design"]["properties"]["max_iterations"];
        assert_eq!(iterations["anyOf"][0]["type"], json!("integer"));
        let wind = &schema["properties"]["wind"]["properties"]["table"]["items"];
        assert_eq!(
            (&wind["minItems"], &wind["maxItems"]),
            (&json!(3), &json!(3))
        );
    }
}
