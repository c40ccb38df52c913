use super::*;
use crate::answer::sample;

fn case() -> Case {
    let mut case = Case::run_page();
    case.set("entry.speed_m_s", "12.5 km/s");
    case
}

fn cell<'t>(pairs: &'t [(String, String)], header: &str) -> &'t str {
    let found: Vec<_> = pairs.iter().filter(|(h, _)| h == header).collect();
    assert_eq!(found.len(), 1, "{header}");
    &found[0].1
}

#[test]
fn the_report_finds_its_own_names_and_units() {
    let (case, answer) = (case(), sample::flight());
    let solved = Solved {
        case: &case,
        answer: &answer,
    };
    let pairs = pairs(solved, Job::Design, Manner::Report);
    let found = |header| cell(&pairs, header);
    assert_eq!(found("Run Name"), "sample \"one\", first");
    assert_eq!(found("Entry Velocity (m/s)"), "12500");
    assert_eq!(found("Entry Flight Path Angle (deg)"), "-8");
    assert_eq!(found("Nose Radius / Vehicle Radius"), "0.75");
    assert_eq!(found("MSR Mode"), "Yes");
    assert_eq!(found("Convective Heat Rate Model"), "SuttonGraves");
    assert_eq!(found("Forebody TPS Concept"), "PICA-AL-5056");
    assert_eq!(found("Outcome"), "landed");
    assert_eq!(found("Max Entry Load (Earth g)"), "29.84381");
    // 4.987819e6 W/m² times a margin of 1.3, over 1e4.
    let heat_flux = "Forebody Max Convective Heat Rate (Margined) (W/cm^2)";
    assert_eq!(found(heat_flux).parse(), Ok(4.987819e6 * 1.3 / 1e4));
    assert_eq!(found("Forebody Max Radiative Heat Rate (W/cm^2)"), "");
}

#[test]
fn si_columns_are_the_keys_of_case_and_answer() {
    let (case, answer) = (case(), sample::flight());
    let solved = Solved {
        case: &case,
        answer: &answer,
    };
    let pairs = pairs(solved, Job::Design, Manner::Si);
    let found = |header| cell(&pairs, header);
    assert_eq!(found("entry.speed_m_s"), "12500");
    assert_eq!(found("design.msr_mode"), "true");
    assert_eq!(found("heating.convective"), "sutton-graves");
    assert_eq!(found("peak_convective_heat_flux_w_m2"), "4987819");
    assert_eq!(found("ballistic_coefficient_kg_m2"), "");
    assert!(
        pairs
            .iter()
            .all(|(header, _)| !header.starts_with("vehicle."))
    );
}

#[test]
fn rows_of_different_cases_share_their_columns() {
    let (first, answer) = (case(), sample::flight());
    let mut second = first.clone();
    second.set("design.terminal_drag_coefficient", "");
    second.set("design.payload_density_kg_m3", "4 g/cm^3");
    let not_closed = sample::not_closed();
    let rows = [
        Solved {
            case: &first,
            answer: &answer,
        },
        Solved {
            case: &second,
            answer: &not_closed,
        },
    ];
    let table = results(&rows, Job::Design, Manner::Si);
    let density = table
        .headers
        .iter()
        .position(|h| h == "design.payload_density_kg_m3")
        .unwrap();
    assert_eq!(table.rows[0][density], "");
    assert_eq!(table.rows[1][density], "4000");
    assert!(
        table
            .rows
            .iter()
            .all(|row| row.len() == table.headers.len())
    );
    assert!(table.rows[1].contains(&"not-closed".to_string()));
}

#[test]
fn what_is_given_inline_replaces_the_default_by_name() {
    let mut case = Case::default();
    case.set("planet.equatorial_radius_m", "6378000");
    case.set("entry.radius_m", "6503140");
    let answer = sample::flight();
    let solved = Solved {
        case: &case,
        answer: &answer,
    };
    let headers: Vec<String> = pairs(solved, Job::Fly, Manner::Si)
        .into_iter()
        .map(|(header, _)| header)
        .collect();
    let has = |key: &str| headers.iter().any(|header| header == key);
    assert!(has("planet.equatorial_radius_m") && has("entry.radius_m") && has("entry.atmosphere"));
    assert!(!has("entry.planet") && !has("entry.altitude_m"));
}

#[test]
fn a_history_is_written_in_both_manners() {
    let answer = sample::flight();
    let trajectory = answer.flight.unwrap().trajectory.unwrap();
    let si = history(&trajectory, Manner::Si).to_csv();
    let mut lines = si.split("\r\n");
    assert!(
        lines
            .next()
            .unwrap()
            .starts_with("time_s,altitude_m,latitude_deg,")
    );
    assert!(lines.next().unwrap().starts_with("0,125000,33,179,"));
    assert!(lines.next().unwrap().starts_with("2,60000,32.5,-179,"));
    let report = history(&trajectory, Manner::Report).to_csv();
    let mut lines = report.split("\r\n");
    assert!(
        lines
            .next()
            .unwrap()
            .starts_with("Time (s),Geodetic Altitude (km),Latitude (deg),")
    );
    assert!(lines.next().unwrap().starts_with("0,125,33,179,"));
    // NaN is an empty cell, 1e-7 keeps its exponent.
    assert!(si.contains(",1e-7,"));
    assert_eq!(si.lines().count(), 4);
}
