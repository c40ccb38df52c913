//! User data files, in the folder of `--data`.

use crate::files::{DROP, with};
use crate::{folder, msape, path};
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};

/// A data folder with the planet `heavy`: the Earth as a sphere with twice its gravity.
fn data(name: &str) -> PathBuf {
    let here = folder(name).join("data");
    fs::create_dir_all(here.join("planets")).unwrap();
    let earth = msape::library::data_file("planets/earth.toml").unwrap();
    let heavy = earth
        .replace("name = \"earth\"", "name = \"heavy\"")
        .replace("\natmosphere", "\nheating_as = \"earth\"\natmosphere")
        .replace("3.986004418e14", "7.972008836e14");
    fs::write(here.join("planets/heavy.toml"), heavy).unwrap();
    here
}

/// Answer of a fall from 5 km on a planet.
fn flown(data: &Path, planet: &str) -> Result<Value, String> {
    let case = data.join("../case.toml");
    let text = with(DROP, "").replace("planet = \"earth\"", &format!("planet = \"{planet}\""));
    fs::write(&case, text).unwrap();
    let done = msape(&[
        "fly",
        path(&case),
        "--data",
        path(data),
        "--json",
        "--trajectory",
    ]);
    match done.code {
        Some(0) => Ok(serde_json::from_str(&done.out).unwrap()),
        code => {
            assert_eq!((code, done.out.as_str()), (Some(2), ""), "{}", done.err);
            Err(done.err)
        }
    }
}

#[test]
fn a_planet_of_one_s_own_is_flown_and_listed() {
    let data = data("own-planet");
    let fall = |planet: &str| {
        let answer = flown(&data, planet).unwrap();
        let speeds = answer["trajectory"]["downward_speed_m_s"]
            .as_array()
            .unwrap();
        speeds.last().unwrap().as_f64().unwrap()
    };
    // after 1 s, without drag 2.003 because of the centrifugal acceleration; drag takes 1 % of the one and 2.5 % of the
    // other
    let ratio = fall("heavy") / fall("earth");
    assert!((1.96..2.0).contains(&ratio), "{ratio}");
    let list = msape(&["quantities", "inputs", "--data", path(&data)]);
    assert!(list.out.contains("heavy"), "{}", list.err);
    let schema = msape(&["--data", path(&data), "schema"]);
    assert!(schema.out.contains("\"heavy\""), "{}", schema.err);
    assert!(!msape(&["schema"]).out.contains("\"heavy\""));
}

#[test]
fn what_a_file_names_and_nothing_has_is_told_and_nothing_is_flown() {
    let data = data("dangling");
    let file = data.join("planets/heavy.toml");
    let text = fs::read_to_string(&file).unwrap();
    fs::write(&file, text.replace("\"us-1976\"", "\"us-1977\"")).unwrap();
    let said = flown(&data, "heavy").unwrap_err();
    let want = "planets/heavy.toml: atmosphere: got \"us-1977\", must be one of jupiter, mars";
    assert!(said.contains(want), "{said}");
    fs::rename(&file, data.join("planets/earth.toml")).unwrap();
    let said = flown(&data, "earth").unwrap_err();
    assert!(
        said.contains("planets/earth.toml: name: there is a file of this name"),
        "{said}"
    );
}

#[test]
fn a_folder_that_is_none_and_a_file_of_no_kind_are_told() {
    let data = data("no-kind");
    fs::write(data.join(".hidden"), "x").unwrap();
    assert!(flown(&data, "heavy").is_ok());
    fs::write(data.join("notes.md"), "x").unwrap();
    let said = flown(&data, "heavy").unwrap_err();
    assert!(
        said.contains("notes.md: is no file that can be added; must be one of planets/NAME.toml"),
        "{said}"
    );
    let nowhere = data.join("nowhere");
    let done = msape(&["schema", "--data", path(&nowhere)]);
    assert_eq!((done.code, done.out.as_str()), (Some(2), ""));
    assert!(
        done.err.contains("nowhere") && done.err.contains("cannot be read"),
        "{}",
        done.err
    );
}

#[test]
fn output_does_not_replace_data_and_faults_of_folders_are_named() {
    let data = data("own-output");
    let planet = data.join("planets/heavy.toml");
    let before = fs::read_to_string(&planet).unwrap();
    let case = data.join("../case.toml");
    fs::write(&case, with(DROP, "")).unwrap();
    let fly = |folder: &Path, more: &[&str]| {
        let mut words = vec!["fly", path(&case), "--data", path(folder)];
        words.extend(more);
        msape(&words)
    };
    let done = fly(&data, &["-o", path(&planet)]);
    assert_eq!(done.code, Some(2));
    assert!(done.err.contains("or one of --data"), "{}", done.err);
    assert_eq!(fs::read_to_string(&planet).unwrap(), before);
    let nowhere = fly(&data.join("nowhere"), &[]);
    assert!(
        nowhere.err.contains("nowhere: cannot be read"),
        "{}",
        nowhere.err
    );
    fs::create_dir_all(data.join("planets/old")).unwrap();
    let nested = fly(&data, &[]);
    let said = "planets/old: is a folder in a folder";
    assert!(nested.err.contains(said), "{}", nested.err);
}
