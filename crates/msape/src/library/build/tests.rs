//! Files of the user: the names that they may use, and the faults of those that use an unknown name.

use super::super::read::Files;
use super::super::{Library, data_file};
use crate::{Case, Outcome, Request, design, fly};

type Own = (&'static str, String);

fn shipped(path: &str) -> String {
    data_file(path).unwrap().to_string()
}

fn built(own: &[Own]) -> Result<Library, Vec<String>> {
    let own: Vec<_> = own
        .iter()
        .map(|(path, text)| (path.to_string(), text.clone()))
        .collect();
    Library::with_files(&own).map_err(|faults| faults.iter().map(ToString::to_string).collect())
}

fn only_fault(own: &[Own]) -> String {
    let faults = built(own).unwrap_err();
    assert_eq!(faults.len(), 1, "{faults:?}");
    faults[0].clone()
}

/// Mars by another name, with the relations of Mars.
fn dusty() -> String {
    shipped("planets/mars.toml")
        .replace("name = \"mars\"", "name = \"dusty\"")
        .replace("\natmosphere = ", "\nheating_as = \"mars\"\natmosphere = ")
}

#[test]
fn the_shipped_library_is_what_its_files_say_and_they_have_no_unknown_key() {
    let [shipped, own] = [Files::shipped(), Files::as_own()]
        .map(|files| format!("{:?}", super::library(files).unwrap()));
    assert!(shipped == own, "the build made something else of a file");
}

#[test]
fn a_dangling_name_is_said_with_file_key_value_and_what_there_is() {
    let concept = shipped("concepts/pica-al-5056.toml");
    let of = |was: &str, is: &str| only_fault(&[("concepts/own.toml", concept.replace(was, is))]);
    assert_eq!(
        of("tps = \"pica\"", "tps = \"picca\""),
        "concepts/own.toml: tps: got \"picca\", must be one of carbon-phenolic, pica"
    );
    // a heat shield of the aftbody has no limits of a forebody
    assert!(of("tps = \"pica\"", "tps = \"sirca\"").contains("tps: got \"sirca\""));
    assert!(
        of("soak = \"pica\"", "soak = \"\"")
            .contains("soak: got \"\", must be one of carbon-phenolic, pica")
    );
    assert!(
        of("al-honeycomb", "wood")
            .contains("carrier: got \"wood\", must be one of acc-6, al-honeycomb")
    );
    let planet =
        |was: &str, is: &str| only_fault(&[("planets/dusty.toml", dusty().replace(was, is))]);
    assert!(
        planet("atmosphere = \"mars\"", "atmosphere = \"mrs\"")
            .contains("atmosphere: got \"mrs\", must be one of jupiter, mars")
    );
    let without = built(&[(
        "planets/dusty.toml",
        dusty().replace("heating_as = \"mars\"\n", ""),
    )]);
    let without = without.unwrap_err();
    let said =
        "planets/dusty.toml: heating_as: missing, and no heating/hot-wall*.toml names \"dusty\"";
    assert!(
        without.len() == 2 && without[1].starts_with(said),
        "{without:?}"
    );
    assert!(
        planet("name = \"dusty\"", "name = \"d\"")
            .contains("name: got \"d\", must be that of the file")
    );
}

#[test]
fn relations_are_taken_of_a_planet_that_has_its_own() {
    let twin = dusty()
        .replace("\"dusty\"", "\"twin\"")
        .replace("heating_as = \"mars\"", "heating_as = \"dusty\"");
    let said = only_fault(&[("planets/dusty.toml", dusty()), ("planets/twin.toml", twin)]);
    assert_eq!(
        said,
        "planets/twin.toml: heating_as: got \"dusty\", which has no relations of its own but heating_as = \"mars\"; must be a planet with its own"
    );
    let own = dusty().replace("heating_as = \"mars\"", "heating_as = \"dusty\"");
    let said = only_fault(&[("planets/dusty.toml", own)]);
    assert!(
        said.contains("heating_as: got \"dusty\", which has no"),
        "{said}"
    );
}

#[test]
fn every_fault_of_every_file_is_said() {
    let graves = shipped("heating/sutton-graves.toml").replace("\"venus\"", "\"vulcan\"");
    let faults = built(&[
        (
            "planets/dusty.toml",
            dusty().replace("heating_as = \"mars\"", "heating_as = \"vulcan\""),
        ),
        ("materials/own.toml", "name = 1".to_string()),
        ("atmospheres/own.toml", shipped("atmospheres/mars.toml")),
        ("heating/sutton-graves-own.toml", graves),
        ("vehicles/own.toml", String::new()),
        ("planets/../own.toml", String::new()),
    ])
    .unwrap_err();
    for said in [
        "planets/dusty.toml: heating_as: got \"vulcan\", must be one of",
        "materials/own.toml: ",
        "atmospheres/own.toml: name: no planet",
        "heating/sutton-graves-own.toml: planets: got \"vulcan\", must be one of",
        "heating/sutton-graves-own.toml: planets: got \"earth\", which has such a relation already",
        "vehicles/own.toml: is no file that can be added; must be one of planets/NAME.toml",
        "planets/../own.toml: is no file",
    ] {
        assert!(
            faults.iter().any(|fault| fault.starts_with(said)),
            "{said} in {faults:#?}"
        );
    }
}

#[test]
fn a_name_that_is_there_is_not_taken_twice() {
    let said = "there is a file of this name";
    assert!(only_fault(&[("planets/mars.toml", shipped("planets/mars.toml"))]).contains(said));
    let twice = [
        ("planets/dusty.toml", dusty()),
        ("planets/dusty.toml", dusty()),
    ];
    assert!(only_fault(&twice).contains(said));
}

#[test]
fn a_planet_and_a_concept_of_one_s_own_are_flown_and_designed() {
    let pica = shipped("concepts/pica-al-5056.toml");
    let own = [
        ("planets/dusty.toml", dusty()),
        (
            "concepts/own.toml",
            pica.replace("thickness_cm = 0.0381", "thickness_cm = 0.05"),
        ),
    ];
    let library = built(&own).unwrap();
    let flown = |planet: &str| {
        let mut case = Case::from_toml(data_file("cases/stardust.toml").unwrap()).unwrap();
        for (key, value) in [
            ("entry.planet", planet),
            ("entry.speed_m_s", "6000"),
            ("entry.altitude_m", "120000"),
            ("entry.flight_path_angle_deg", "-20"),
            ("heating.radiative", "tauber-sutton"),
        ] {
            case.set(key, value);
        }
        case.values.retain(|key, _| {
            !key.starts_with("atmosphere") && key != "entry.atmosphere" && key != "entry.radius_m"
        });
        fly(&case, &library, Request::Nothing).unwrap()
    };
    let (own, shipped) = (flown("dusty"), flown("mars"));
    assert_eq!(own.outcome, Outcome::Landed);
    assert_eq!(own.flight, shipped.flight);
    let mut case = Case::from_toml(data_file("cases/msr-eev-pica.toml").unwrap()).unwrap();
    let mass = |case: &Case| {
        let answer = design(case, &library, Request::Nothing).unwrap();
        answer.design.unwrap().vehicle.mass.mass_kg
    };
    let before_kg = mass(&case);
    case.set("design.forebody_tps", "own");
    // more of the bond
    assert!(mass(&case) > before_kg);
}

#[test]
fn a_made_up_heating_model_is_a_fault_and_every_offered_one_is_there() {
    let library = Library::builtin().unwrap();
    let mut case = Case::run_page();
    case.set("heating.convective", "made-up");
    let faults = design(&case, &library, Request::Nothing).unwrap_err();
    assert_eq!(faults[0].key, "heating.convective");
    assert!(faults[0].message.contains("\"made-up\""), "{faults:?}");
    for key in ["heating.convective", "heating.radiative"] {
        let input = crate::quantity::input::find(key).unwrap();
        let crate::quantity::input::Kind::Choice(choices) = input.kind else {
            panic!("{key} is a choice");
        };
        for (name, _) in library.choices(choices) {
            let mut case = Case::run_page();
            case.set(key, &name);
            let answer = design(&case, &library, Request::Nothing);
            assert!(answer.is_ok(), "{name}: {:?}", answer.err());
        }
    }
}
