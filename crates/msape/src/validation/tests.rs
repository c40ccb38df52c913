use super::*;
use crate::answer::sample;

const FILE: &str = r#"
title = "t"
case = "run-page.toml"
command = "fly"
source = "samareh-2014"
place = "Table 1"
[tolerances.peaks]
relative = 0.001
reason = "Because."
[[rows]]
quantity = "peak_deceleration_earth_g"
value = 29.83
unit = "Earth g"
tolerance = "peaks"
"#;

#[test]
fn shipped_files_and_their_cases_can_be_read() {
    let library = Library::builtin().unwrap();
    let files = files().unwrap();
    assert!(files.len() >= 10);
    for (name, file) in &files {
        Runner::new(&library, name, file).unwrap();
        let bibliography = data_file("references.bib").unwrap();
        let sources = file.rows.iter().filter_map(|row| row.source.as_ref());
        for source in sources.chain([&file.source]) {
            assert!(
                bibliography.contains(&format!("{{{source},")),
                "{name}: {source}"
            );
        }
    }
}

#[test]
fn the_shipped_run_page_is_the_one_of_the_core() {
    let shipped = data_file("cases/run-page.toml").unwrap();
    assert_eq!(shipped, Case::run_page().to_toml());
}

#[test]
fn a_value_within_its_tolerance_is_within() {
    // 29.84381 - 29.83 = 0.01381, below 0.1 % of 29.83 = 0.02983.
    let file = File::parse(FILE).unwrap();
    let library = Library::builtin().unwrap();
    let runner = Runner::new(&library, "t", &file).unwrap();
    let row = runner.row(&file.rows[0], &Ok(sample::flight()));
    assert_eq!(
        (row.verdict, row.tolerance_text.as_str()),
        (Verdict::Within, "0.1 %")
    );
    assert!((row.difference.unwrap() - 0.01381).abs() < 1e-12);
    let mut strict = file.clone();
    strict.tolerances.get_mut("peaks").unwrap().relative = Some(1e-4);
    let runner = Runner::new(&library, "t", &strict).unwrap();
    let row = runner.row(&strict.rows[0], &Ok(sample::flight()));
    assert_eq!(row.verdict, Verdict::Beyond);
}

#[test]
fn a_refused_case_and_a_quantity_that_did_not_occur_are_misses() {
    let file = File::parse(FILE).unwrap();
    let library = Library::builtin().unwrap();
    let runner = Runner::new(&library, "t", &file).unwrap();
    let row = runner.row(&file.rows[0], &Err("mass: got -1".to_string()));
    assert_eq!(
        (row.verdict, row.fault.as_deref()),
        (Verdict::Absent, Some("mass: got -1"))
    );
    assert!(
        runner
            .row(&file.rows[0], &Ok(sample::not_closed()))
            .verdict
            .is_miss()
    );
}

#[test]
fn a_row_is_judged_or_says_why_not() {
    let without = FILE.replace("tolerance = \"peaks\"", "");
    assert!(File::parse(&without).unwrap_err().contains("note why"));
    let shown = FILE.replace("tolerance = \"peaks\"", "note = \"A limit, not a peak.\"");
    let file = File::parse(&shown).unwrap();
    let library = Library::builtin().unwrap();
    let runner = Runner::new(&library, "t", &file).unwrap();
    let row = runner.row(&file.rows[0], &Ok(sample::flight()));
    assert_eq!(
        (row.verdict, row.reason.as_str()),
        (Verdict::Shown, "A limit, not a peak.")
    );
    assert!(File::parse(&FILE.replace("Earth g", "furlong")).is_err());
    assert!(File::parse(&FILE.replace("tolerance = \"peaks\"", "tolerance = \"loads\"")).is_err());
}

#[test]
fn a_row_of_the_trajectory_is_found_by_its_time() {
    let answer = sample::flight();
    assert_eq!(value(&answer, "altitude_m", Some(2.0)), Some(60_000.0));
    assert_eq!(value(&answer, "altitude_m", Some(3.0)), None);
    assert_eq!(value(&answer, "temperature_k", Some(2.0)), None);
}

#[test]
fn quantities_of_flights_are_in_the_lists() {
    for (name, file) in files().unwrap() {
        for row in file.rows.iter().filter(|_| file.command == Command::Fly) {
            let known = match row.time_s {
                None => output::find(&row.quantity).map(|output| output.dimension),
                Some(_) => columns::find(&row.quantity).map(|column| column.dimension),
            };
            let unit = Unit::find(&row.unit).map(|unit| unit.dimension);
            assert!(known.is_some() && known == unit, "{name}: {}", row.quantity);
        }
    }
}
