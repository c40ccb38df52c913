//! Flights that leave tables, assumed air, and phases of a rigid body.

use crate::{Answer, Case, Library, Outcome, Request, fly};

/// The answer of a shipped case with some keys changed, and with more text.
fn flown(case: &str, more: &str, changes: &[(&str, &str)]) -> Answer {
    let text = crate::library::data_file(case).unwrap();
    let mut case = Case::from_text(&format!("{text}{more}")).unwrap();
    for (key, value) in changes {
        case.set(key, value);
    }
    fly(&case, &Library::builtin().unwrap(), Request::Nothing).unwrap()
}

const STARDUST: &str = "cases/stardust.toml";
const WIND: &str = "[[20000.0, 10.0, 0.0], [200000.0, 0.0, 0.0]]";
const AIR: &str = "[[20000.0, 0.0889, 216.65], [80000.0, 1.85e-5, 198.6], [140000.0, 4e-9, 560.0]]";
const BANK: &str = "[[0.0, 0.0], [50.0, 60.0]]";
const SPEEDS: &str = "[[2000.0, 0.0], [20000.0, 60.0]]";

fn says(answer: &Answer, part: &str) -> bool {
    let mut findings = answer.findings.iter();
    findings.any(|finding| finding.message.contains(part))
}

#[test]
fn every_table_ends_a_flight_where_the_case_refuses_to_go_on() {
    let lift = ("vehicle.lift_to_drag", "0.2");
    for (table, rows, rule, with) in [
        ("wind.table", WIND, "wind.extrapolation", None),
        ("atmosphere.table", AIR, "atmosphere.extrapolation", None),
        (
            "vehicle.bank_table_deg",
            BANK,
            "vehicle.bank_extrapolation",
            Some(lift),
        ),
        (
            "vehicle.bank_speed_table_deg",
            SPEEDS,
            "vehicle.bank_extrapolation",
            Some(lift),
        ),
    ] {
        let mut changes: Vec<(&str, &str)> = with.into_iter().collect();
        changes.push((table, rows));
        let on = flown(STARDUST, "", &changes);
        assert_eq!(on.outcome, Outcome::Landed, "{table}");
        changes.push((rule, "refuse"));
        let ended = flown(STARDUST, "", &changes);
        assert_eq!(ended.outcome, Outcome::Stopped, "{table}");
        let reason = ended.reason.as_ref().unwrap();
        let section = table.split('.').next().unwrap();
        assert!(reason.contains(section), "{table}: {reason}");
        assert!(says(&ended, "there the flight was ended"), "{table}");
        let flight = ended.flight.unwrap();
        match table {
            "vehicle.bank_table_deg" => assert!((flight.time_of_flight_s - 50.0).abs() < 1e-6),
            "vehicle.bank_speed_table_deg" => assert!(flight.final_speed_m_s < 2010.0),
            _ => assert!((flight.final_altitude_m - 20e3).abs() < 1e-3, "{table}"),
        }
    }
}

#[test]
fn the_closed_form_goes_on_beyond_tables_and_says_so() {
    let closed = ("solver.flight_model", "allen-eggers");
    let heat =
        "[[8000.0, 1e-5, 1e5], [8000.0, 1e-3, 1e6], [9000.0, 1e-5, 2e5], [9000.0, 1e-3, 2e6]]";
    for (table, rows, rule, then) in [
        (
            "atmosphere.table",
            AIR,
            "atmosphere.extrapolation",
            "beyond, density goes on with its last slope",
        ),
        (
            "heating.table",
            heat,
            "heating.extrapolation",
            "m/s; beyond, the end is held",
        ),
    ] {
        let answer = flown(STARDUST, "", &[closed, (table, rows), (rule, "refuse")]);
        assert_eq!(answer.outcome, Outcome::Landed, "{table}");
        assert!(says(&answer, then), "{table}: {:?}", answer.findings);
        assert!(!says(&answer, "the flight was ended"), "{table}");
        assert!(says(
            &answer,
            "The closed form does not end where it leaves a table"
        ));
    }
}

#[test]
fn the_assumed_air_of_saturn_is_told_where_a_flight_is_in_it() {
    let at = |altitude_m: &str| {
        let changes = [
            ("entry.planet", "saturn"),
            ("entry.atmosphere", "planet"),
            ("entry.radius_m", ""),
            ("entry.altitude_m", altitude_m),
            ("entry.speed_m_s", "27000"),
            ("entry.frame", "relative"),
            ("heating.radiative", "none"),
        ];
        says(
            &flown(STARDUST, "", &changes),
            "Above 377.5 km the air is assumed",
        )
    };
    assert!(at("450000"));
    assert!(!at("370000"));
}

#[test]
fn the_reference_area_of_a_rigid_body_scales_its_forces_in_a_phase() {
    let peak = |area_m2: f64| {
        let phase =
            format!("[[phase]]\nname = 'other'\nmach = 3.0\nreference_area_m2 = {area_m2}\n");
        let answer = flown(
            "cases/stardust-spinning.toml",
            &phase,
            &[("stop.time_s", "150")],
        );
        assert!(says(
            &answer,
            "Forces and moments of the vehicle are scaled"
        ));
        let flight = answer.flight.unwrap();
        let [other] = &flight.phases[..] else {
            panic!("one phase begins: {:?}", flight.phases)
        };
        (other.time_s, other.peak_deceleration_earth_g)
    };
    // the area of the outline, 0.827 m across, and twice as much: the deceleration falls from there on
    let [one, two] = [peak(0.51887), peak(2.0 * 0.51887)];
    assert_eq!(one.0, two.0);
    assert!((two.1 / one.1 - 2.0).abs() < 1e-9, "{one:?} {two:?}");
}
