//! The published schema checked against the shipped cases, with the part of JSON Schema that it uses.

use crate::{msape, root};
use serde_json::{Value, json};
use std::fs;

/// Violations of `schema` in `value`.
fn faults(schema: &Value, value: &Value, at: &str) -> Vec<String> {
    let mut found = Vec::new();
    let mut fault = |what: &str| found.push(format!("{at}: {what}"));
    let is_type = |name: &str| match name {
        "object" => value.is_object(),
        "array" => value.is_array(),
        "string" => value.is_string(),
        "boolean" => value.is_boolean(),
        "number" => value.is_number(),
        "integer" => value.as_f64().is_some_and(|x| x % 1.0 == 0.0),
        other => panic!("type {other}"),
    };
    if schema["type"].as_str().is_some_and(|name| !is_type(name)) {
        fault("type");
    }
    let number = value.as_f64();
    let bound = |key: &str| schema[key].as_f64().zip(number);
    if bound("minimum").is_some_and(|(min, x)| x < min)
        || bound("maximum").is_some_and(|(max, x)| x > max)
        || bound("exclusiveMinimum").is_some_and(|(min, x)| x <= min)
    {
        fault("range");
    }
    if schema["enum"]
        .as_array()
        .is_some_and(|names| !names.contains(value))
    {
        fault("enum");
    }
    if schema
        .get("const")
        .is_some_and(|constant| constant != value)
    {
        fault("const");
    }
    if let Some(map) = value.as_object() {
        for name in schema["required"].as_array().into_iter().flatten() {
            if !map.contains_key(name.as_str().unwrap()) {
                fault(&format!("without {name}"));
            }
        }
    }
    if let Some(choices) = schema["anyOf"].as_array()
        && choices
            .iter()
            .all(|choice| !faults(choice, value, at).is_empty())
    {
        fault("anyOf");
    }
    for (name, child) in value.as_object().into_iter().flatten() {
        match schema["properties"].get(name) {
            Some(schema) => found.extend(faults(schema, child, &format!("{at}.{name}"))),
            None if schema["additionalProperties"] == json!(false) => {
                found.push(format!("{at}.{name}: unknown"))
            }
            None => {}
        }
    }
    if let Some(items) = schema.get("items") {
        for item in value.as_array().into_iter().flatten() {
            found.extend(faults(items, item, at));
        }
    }
    found
}

fn schema() -> Value {
    serde_json::from_str(&msape(&["schema"]).out).unwrap()
}

#[test]
fn every_shipped_case_follows_the_schema() {
    let schema = schema();
    assert_eq!(
        schema["$schema"],
        "https://json-schema.org/draft/2020-12/schema"
    );
    let mut count = 0;
    for entry in fs::read_dir(root().join("cases")).unwrap() {
        let path = entry.unwrap().path();
        // a folder holds the cases of an earlier version
        if path.is_dir() {
            continue;
        }
        let case: Value = toml::from_str(&fs::read_to_string(&path).unwrap()).unwrap();
        assert_eq!(
            faults(&schema, &case, ""),
            Vec::<String>::new(),
            "{}",
            path.display()
        );
        count += 1;
    }
    assert!(count >= 15);
}

#[test]
fn what_the_program_refuses_the_schema_refuses() {
    let schema = schema();
    let good = json!({ "schema": "msape/1",
        "entry": { "latitude_deg": 33.0, "longitude_deg": 0, "speed_m_s": "12 km/s", "flight_path_angle_deg": -8.0, "azimuth_deg": 90.0 },
        "vehicle": { "mass_kg": 46.0, "nose_radius_m": 0.2286 } });
    assert_eq!(faults(&schema, &good, ""), Vec::<String>::new());
    let changed = |pointer: &str, value: Value| {
        let mut case = good.clone();
        *case.pointer_mut(pointer).unwrap() = value;
        faults(&schema, &case, "")
    };
    assert_eq!(
        changed("/vehicle/mass_kg", json!(-1.0)),
        [".vehicle.mass_kg: anyOf"]
    );
    assert_eq!(changed("/schema", json!("msape/2")), [".schema: const"]);
    assert_eq!(changed("/vehicle", json!({ "mass_kg": 1.0 })), [": anyOf"]);
    let mut outlined = good.clone();
    outlined["vehicle"] = json!({ "mass_kg": 1.0 });
    outlined["outline"] = json!({ "preset": "stardust" });
    assert_eq!(faults(&schema, &outlined, ""), Vec::<String>::new());
    assert_eq!(
        changed("/entry/speed_m_s", json!(true)),
        [".entry.speed_m_s: anyOf"]
    );
    let mut unknown = good.clone();
    unknown["entry"]["speed_km_s"] = json!(12.0);
    unknown["entry"]["planet"] = json!("vulcan");
    assert_eq!(
        faults(&schema, &unknown, ""),
        [".entry.speed_km_s: unknown", ".entry.planet: enum"]
    );
}
