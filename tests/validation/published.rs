//! Published results.

use msape::progress::Unwatched;
use msape::validation::{self, Row};
use msape::{Case, Library};
use msape_tests::entry::{flown, output};

/// Every row of every comparison.
fn compared() -> Vec<Row> {
    let files = validation::files().unwrap();
    let library = Library::builtin().unwrap();
    let rows = validation::run(&library, &files, &mut Unwatched).unwrap();
    rows.into_iter().flatten().collect()
}

fn table(rows: &[&Row]) -> String {
    let line = |row: &&Row| {
        let number = |x: Option<f64>| x.map_or("-".to_string(), |x| format!("{x:.7}"));
        format!(
            "{:28} {:9} {:>16} {:>16.7} +- {:12} {:8} {}{}\n",
            row.case,
            row.verdict.name(),
            number(row.ours),
            row.reference,
            row.tolerance_text,
            row.unit,
            row.label,
            row.fault
                .as_ref()
                .map_or(String::new(), |f| format!(" ({f})")),
        )
    };
    rows.iter().map(line).collect()
}

/// Rows are judged with the tolerances of the data files, which also give the reasons; `msape validate` prints them
/// all.
#[test]
fn every_judged_row_is_within_its_tolerance() {
    let rows = compared();
    let misses: Vec<&Row> = rows.iter().filter(|row| row.verdict.is_miss()).collect();
    assert!(misses.is_empty(), "\n{}", table(&misses));
    let judged = rows.iter().filter(|row| row.tolerance.is_some()).count();
    assert!(
        judged >= 120,
        "only {judged} of {} rows are judged",
        rows.len()
    );
}

#[test]
fn a_row_is_not_judged_only_where_a_note_says_why() {
    let rows = compared();
    for row in rows.iter().filter(|row| row.tolerance.is_none()) {
        assert!(!row.reason.is_empty(), "{} {}", row.case, row.quantity);
        assert!(row.ours.is_some(), "{} {}", row.case, row.quantity);
    }
}

/// The paper prints, in percent, the difference between the closed form and its integration: peak deceleration, and
/// speed and altitude there. Two independent integrations differ from the paper by up to 0.9 points, so 1 point is
/// allowed.
#[test]
fn the_closed_form_is_as_far_from_the_integration_as_putnam_and_braun_print() {
    let library = Library::builtin().unwrap();
    for (file, published) in [
        ("cases/putnam-braun-sample-return.toml", [34.9, -2.1, -4.6]),
        ("cases/putnam-braun-strategic.toml", [-5.1, -1.8, 3.6]),
    ] {
        let case = Case::from_text(msape::library::data_file(file).unwrap()).unwrap();
        let mut closed = case.clone();
        closed.set("solver.flight_model", "allen-eggers");
        let (integrated, closed) = (flown(&case, &library), flown(&closed, &library));
        let keys = [
            "peak_deceleration_earth_g",
            "peak_deceleration_speed_m_s",
            "peak_deceleration_altitude_m",
        ];
        for (key, printed) in keys.iter().zip(published) {
            let percent = 100.0 * (output(&closed, key) / output(&integrated, key) - 1.0);
            assert!(
                (percent - printed).abs() < 1.0,
                "{file} {key}: {percent:.2} %, printed {printed} %"
            );
        }
    }
}
