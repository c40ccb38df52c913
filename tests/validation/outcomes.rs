//! Start and end of flights.

use msape::{Answer, Case, Library, Outcome, Request};
use msape_tests::entry::{Entry, flown, flown_with, output, set};

fn library() -> Library {
    Library::builtin().unwrap()
}

fn entry(speed_m_s: f64, flight_path_angle_deg: f64) -> Case {
    let entry = Entry {
        speed_m_s,
        flight_path_angle_deg,
        ..Entry::RUN_PAGE
    };
    entry.case()
}

fn column(answer: &Answer, key: &str) -> Vec<f64> {
    let flight = answer.flight.as_ref().unwrap();
    let trajectory = flight.trajectory.as_ref().unwrap();
    trajectory.column(key).unwrap().to_vec()
}

/// Escape speed at 125 km is 11.07 km/s; −2 deg passes above 80 km and loses little speed.
#[test]
fn a_fast_shallow_entry_skips_out() {
    let library = library();
    let answer = flown(&entry(13_000.0, -2.0), &library);
    assert_eq!(answer.outcome, Outcome::SkippedOut);
    assert!(answer.reason.as_ref().unwrap().contains("escape"));
    let altitude_m = output(&answer, "final_altitude_m");
    assert!((altitude_m - 125_000.0).abs() < 1.0, "{altitude_m}");
    assert!(output(&answer, "final_speed_m_s") > 12_000.0);
    assert!(output(&answer, "peak_deceleration_altitude_m") > 60_000.0);
}

/// Between skipping out and landing, entries leave the atmosphere below escape speed.
#[test]
fn between_skipping_out_and_landing_lies_capture() {
    let library = library();
    let outcomes: Vec<Outcome> = (0..=40)
        .map(|i| flown(&entry(12_000.0, -4.0 - 0.05 * f64::from(i)), &library).outcome)
        .collect();
    let mut order = outcomes.clone();
    order.dedup();
    assert_eq!(
        order,
        [Outcome::SkippedOut, Outcome::Captured, Outcome::Landed],
        "{outcomes:?}"
    );
}

/// From rest a body first falls as in vacuum: after 10 s, g t = 9.5 m/s² at 100 km (9.81 (6371/6471)²) times 10.
#[test]
fn a_start_at_rest_falls() {
    let library = library();
    for (altitude_m, gravity_m_s2) in [(100_000.0, 9.5), (300_000.0, 8.94), (1_000_000.0, 7.32)] {
        let mut case = entry(0.0, 0.0);
        set(&mut case, "entry.altitude_m", altitude_m);
        set(&mut case, "stop.time_s", 10.0);
        let answer = flown(&case, &library);
        assert_eq!(answer.outcome, Outcome::Stopped);
        let speed_m_s = output(&answer, "final_speed_m_s");
        // less on a rotating planet, by the centrifugal acceleration of at most 0.034 m/s² at 1000 km higher
        assert!(
            (speed_m_s / 10.0 - gravity_m_s2).abs() < 0.06,
            "{altitude_m}: {speed_m_s}"
        );
    }
}

#[test]
fn a_start_at_rest_in_thick_air_reaches_the_ground_at_terminal_speed() {
    let library = library();
    for altitude_m in [1_000.0, 20_000.0, 60_000.0] {
        let mut case = entry(0.0, 0.0);
        set(&mut case, "entry.altitude_m", altitude_m);
        let answer = flown(&case, &library);
        assert_eq!(answer.outcome, Outcome::Landed);
        // sqrt(2 · 60 · 9.796 / 1.225) = 30.98 m/s, faster as the air grows denser on the way
        let speed_m_s = output(&answer, "final_speed_m_s");
        assert!((speed_m_s - 31.0).abs() < 0.1, "{altitude_m}: {speed_m_s}");
    }
}

#[test]
fn a_start_at_rest_on_the_ground_has_landed() {
    let mut case = entry(0.0, 0.0);
    set(&mut case, "entry.altitude_m", 0.0);
    let answer = flown_with(&case, &library(), Request::Steps);
    assert_eq!(answer.outcome, Outcome::Landed);
    assert!(output(&answer, "time_of_flight_s") < 1e-3);
    assert!(column(&answer, "altitude_m").iter().all(|h| h.abs() < 1e-2));
}

/// Upward at 1000 m/s from the ground, nearly in vacuum: 1000²/(2 · 9.8) = 51 km minus the effect of drag, and down
/// again.
#[test]
fn a_climbing_start_comes_down_again() {
    let mut case = entry(1_000.0, 80.0);
    set(&mut case, "entry.altitude_m", 0.0);
    set(&mut case, "vehicle.mass_kg", 50_000.0);
    let answer = flown_with(&case, &library(), Request::Uniform(1.0));
    assert_eq!(answer.outcome, Outcome::Landed);
    let altitudes_m = column(&answer, "altitude_m");
    let top_m = altitudes_m.iter().copied().fold(0.0, f64::max);
    assert!((35_000.0..50_000.0).contains(&top_m), "{top_m}");
    assert!(output(&answer, "final_altitude_m").abs() < 1e-2);
}

#[test]
fn a_start_faster_than_escape_upwards_never_returns() {
    let mut case = entry(12_000.0, 45.0);
    set(&mut case, "entry.altitude_m", 100_000.0);
    assert_eq!(flown(&case, &library()).outcome, Outcome::SkippedOut);
}

#[test]
fn a_time_ends_a_flight_and_the_history_ends_with_it() {
    let mut case = entry(12_000.0, -8.0);
    set(&mut case, "stop.time_s", 30.0);
    let answer = flown_with(&case, &library(), Request::Uniform(0.7));
    assert_eq!(answer.outcome, Outcome::Stopped);
    assert_eq!(output(&answer, "time_of_flight_s"), 30.0);
    let times_s = column(&answer, "time_s");
    // 0, 0.7 ... 29.4, and the end
    assert_eq!(times_s.len(), 44);
    assert_eq!((times_s[0], times_s[43]), (0.0, 30.0));
}

#[test]
fn a_height_ends_a_fall_and_the_first_of_two_ends_counts() {
    let library = library();
    let mut case = entry(12_000.0, -8.0);
    set(&mut case, "stop.altitude_m", 10_000.0);
    let answer = flown(&case, &library);
    assert_eq!(answer.outcome, Outcome::Stopped);
    assert!((output(&answer, "final_altitude_m") - 10_000.0).abs() < 2e-3);
    let to_height_s = output(&answer, "time_of_flight_s");
    set(&mut case, "stop.time_s", to_height_s + 1.0);
    // the altitude is met within a millimeter, which at 200 m/s takes 5e-6 s
    let again_s = output(&flown(&case, &library), "time_of_flight_s");
    assert!((again_s - to_height_s).abs() < 1e-5);
    set(&mut case, "stop.time_s", to_height_s - 1.0);
    let answer = flown(&case, &library);
    assert_eq!(output(&answer, "time_of_flight_s"), to_height_s - 1.0);
    assert!(output(&answer, "final_altitude_m") > 10_000.0);
}
