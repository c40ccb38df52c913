//! Cases of commit e134449, the first version: they give the same results, or the answer names what changed.

use msape::answer::Answer;
use msape::case::version::{BroughtUp, shipped};
use msape::case::{Value, Version};
use msape::library::{data_file, data_folder};
use msape::quantity::Task;
use msape::quantity::input::{Preset, inputs};
use msape::{Case, Library, Request};
use serde_json::Value as Json;
use std::collections::BTreeMap;

/// Every input of that commit with its default.
fn defaults() -> BTreeMap<String, Json> {
    serde_json::from_str(include_str!("../data/e134449/defaults.json")).unwrap()
}

/// Changes of behavior since that version.
fn changes() -> toml::Table {
    data_file("versions/0.1.toml").unwrap().parse().unwrap()
}

/// Keys with changed defaults, and their former values.
fn changed() -> BTreeMap<String, String> {
    let list = changes()["default"].as_array().unwrap().clone();
    let pair = |old: &toml::Value| {
        let text = |key: &str| old[key].as_str().unwrap().to_string();
        (text("key"), text("was"))
    };
    list.iter().map(pair).collect()
}

fn json(value: Option<&Value>) -> Json {
    match value {
        Some(Value::Number(number)) => (*number).into(),
        Some(Value::Text(text)) => text.as_str().into(),
        Some(Value::Flag(flag)) => (*flag).into(),
        _ => Json::Null,
    }
}

fn preset(preset: Preset) -> Json {
    match preset {
        Preset::Absent => Json::Null,
        Preset::Number(number) => number.into(),
        Preset::Name(name) => name.into(),
        Preset::Flag(flag) => flag.into(),
    }
}

fn same(a: &Json, b: &Json) -> bool {
    a == b || a.as_f64().is_some_and(|a| b.as_f64() == Some(a))
}

#[test]
fn every_default_that_changed_is_listed() {
    let (old, changed) = (defaults(), changed());
    let like_before: Vec<String> = changes()["same"]
        .as_array()
        .unwrap()
        .iter()
        .map(|key| key.as_str().unwrap().to_string())
        .collect();
    for input in inputs() {
        let now = preset(input.preset);
        let listed = changed.contains_key(input.key);
        match old.get(input.key) {
            Some(then) => assert_eq!(
                listed,
                !same(then, &now),
                "{}: {then} then, {now} now, in data/versions/0.1.toml: {listed}",
                input.key
            ),
            // a new input acts on old cases by its default, if it has one and its task is not new
            None => assert!(
                now.is_null()
                    || listed
                    || input.tasks == [Task::InDepth]
                    || like_before.iter().any(|key| key == input.key),
                "{}: new, and {now} by default",
                input.key
            ),
        }
    }
    for key in old.keys() {
        assert!(inputs().any(|input| input.key == key), "{key} is gone");
    }
}

#[test]
fn records_of_the_first_version_have_its_values_in_every_input() {
    let (old, changed) = (defaults(), changed());
    for (path, text) in data_folder("cases/0.1") {
        let before = Case::from_text(text).unwrap();
        let BroughtUp { case, remarks } = before.clone().brought_up_from(Version::FIRST);
        for input in inputs() {
            let of = |case: &Case, default: Json| match case.values.get(input.key) {
                None => default,
                value => json(value),
            };
            let mut was = Case::default();
            was.set(input.key, changed.get(input.key).map_or("", |was| was));
            let default = match old.get(input.key) {
                Some(default) => default.clone(),
                None if changed.contains_key(input.key) => json(was.values.get(input.key)),
                None => preset(input.preset),
            };
            let (then, now) = (of(&before, default), of(&case, preset(input.preset)));
            assert!(same(&then, &now), "{path}, {}: {then}, {now}", input.key);
        }
        let added = case.values.len() - before.values.len();
        let kept = remarks.iter().filter(|r| r.ends_with("is kept.")).count();
        assert_eq!(kept, added, "{path}: {remarks:?}");
    }
}

#[test]
fn a_file_of_the_first_version_is_told_what_changed_and_one_of_this_is_not() {
    let library = Library::builtin().unwrap();
    let notes = |case: &Case| {
        let answer: Answer = msape::design(case, &library, Request::Nothing).unwrap();
        let findings = answer.findings.into_iter();
        let those = findings.filter(|finding| finding.key == "version");
        those.map(|finding| finding.message).collect::<Vec<_>>()
    };
    for id in ["msr-eev-pica", "galahad"] {
        let mut case = shipped(Version::FIRST, id).unwrap();
        let open: Vec<_> = changed()
            .into_keys()
            .filter(|key| !case.values.contains_key(key))
            .collect();
        let told = notes(&case);
        assert_eq!(told.len(), usize::from(!open.is_empty()), "{told:?}");
        for key in open {
            assert!(told[0].contains(&key), "{key}: {told:?}");
        }
        case.version = Version::CURRENT;
        assert_eq!(notes(&case), Vec::<String>::new());
    }
    let shipped_now = shipped(Version::CURRENT, "msr-eev-pica").unwrap();
    assert_eq!(shipped_now.version, Version::CURRENT);
}
