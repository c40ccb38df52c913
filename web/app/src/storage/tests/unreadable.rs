//! Unreadable records, and records of earlier versions.

use super::*;

/// Invalid stored work, as another program or an error may leave it.
fn bad_works() -> Vec<(&'static str, Found)> {
    let sheet = |case: &str, units: &str| {
        let case = serde_json::Value::String(case.to_string());
        Found::Text(format!(
            "{{\"case\":{case},\"units\":{units},\"unit_of\":{{}}}}"
        ))
    };
    let units = written(&msape_kit::display::UnitSystem::Report);
    vec![
        ("broken JSON", Found::Text("{\"case\": \"sch".to_string())),
        ("a number", Found::Other("42".to_string())),
        ("an object", Found::Other("{\"case\":1}".to_string())),
        ("an empty text", Found::Text(String::new())),
        (
            "a newer schema",
            sheet("schema = 'msape/2'\nname = 'mine'\n", &units),
        ),
        (
            "an unknown unit system",
            sheet(&Case::run_page().to_toml(), "\"Furlongs\""),
        ),
        (
            "TOML that is none",
            sheet("schema = 'msape/1'\n[design\n", &units),
        ),
    ]
}

#[test]
fn every_record_that_cannot_be_read_is_listed_with_its_reason_and_never_written_over() {
    for (what, found) in bad_works() {
        for key in [
            Key::apart("1-aside"),
            Key::run("7-0"),
            Key::outline("cone"),
            Key::table("t"),
        ] {
            let (mut browser, _) = with_work();
            browser.records.insert(key.clone(), found.clone());
            let stock = browser.stock();
            let [unreadable] = &stock.unreadable[..] else {
                panic!("{what} at {key:?}: {:?}", stock.unreadable);
            };
            assert_eq!(
                (&unreadable.key, &unreadable.found),
                (&key, &found),
                "{what}"
            );
            assert!(
                !unreadable.why.is_empty() && !unreadable.what.is_empty(),
                "{what}"
            );
            assert!(stock.work.is_some(), "{what} does not hide the rest");
            let mut tab = Tab::open(&browser);
            tab.set_speed("13000");
            tab.import("cone", 9.0);
            tab.save(&mut browser).unwrap();
            assert_eq!(browser.records.get(&key), Some(&found), "{what} at {key:?}");
        }
        // the stored work itself: if it were not moved aside, it could not be overwritten
        let mut browser = Browser::default();
        browser.records.insert(Key::current(), found.clone());
        assert!(
            browser.stock().work.is_none() && browser.stock().unreadable.len() == 1,
            "{what}"
        );
        let mut tab = Tab::open(&browser);
        tab.set_speed("13000");
        tab.save(&mut browser).unwrap();
        assert_eq!(browser.records.get(&Key::current()), Some(&found), "{what}");
    }
}

#[test]
fn a_run_whose_case_cannot_be_read_is_listed_by_its_name() {
    let mut browser = Browser::default();
    let run = "{\"name\":\"mine\",\"saved_ms\":1,\"case\":\"schema = 'msape/2'\",\"headline\":[]}";
    browser.put(Key::run("1-0"), run);
    let stock = browser.stock();
    assert!(stock.runs.is_empty());
    assert_eq!(stock.unreadable[0].what, "the saved run mine");
    assert!(stock.unreadable[0].why.contains("msape/2"));
}

#[test]
fn outlines_that_earlier_versions_kept_with_the_case_become_records_of_their_own() {
    let mut browser = Browser::default();
    let case = serde_json::Value::String(Case::run_page().to_toml());
    let units = written(&msape_kit::display::UnitSystem::Report);
    let text = format!(
        "{{\"case\":{case},\"units\":{units},\"unit_of\":{{}},\"version\":{{\"major\":0,\"minor\":2}},\"outlines\":{{\"cone\":[[0,0],[1,1]]}},\"tables\":{{}}}}"
    );
    browser.put(Key::current(), &text);
    let mut tab = Tab::open(&browser);
    assert_eq!(tab.document.outlines.len(), 1);
    tab.save(&mut browser).unwrap();
    assert!(browser.records.contains_key(&Key::outline("cone")));
    tab.remove("cone");
    tab.save(&mut browser).unwrap();
    assert!(Tab::open(&browser).document.outlines.is_empty());
}

#[test]
fn keys_of_every_kind_are_read_again_as_they_were_kept() {
    let texts = [
        "description = 'my study'",
        "'my key' = 1",
        "'a.b c' = 1",
        "'' = 1",
        "'\"' = 1",
        "[\"x y\"]\nz = [[1,2]]",
    ];
    for text in texts {
        let mut browser = Browser::default();
        let mut tab = Tab::open(&browser);
        let case = Case::from_text(&format!("schema = 'msape/1'\n{text}\n")).unwrap();
        tab.document = Document::new(case);
        tab.set_speed("12345");
        tab.save(&mut browser).unwrap();
        let stock = browser.stock();
        assert_eq!(stock.unreadable, [], "{text}");
        assert_eq!(
            stock.work.unwrap().document.case,
            tab.document.case,
            "{text}"
        );
    }
}
