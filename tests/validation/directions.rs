//! Singular directions: lift in vertical flight, poles, attitudes at 90 deg of pitch.

use msape::{Answer, Outcome, Request};
use msape_tests::entry::output;
use msape_tests::text::{PLAIN, answer, case, said};

fn flown(edits: &[(&str, &str)]) -> Answer {
    answer(&case(PLAIN, edits), Request::Steps).unwrap()
}

fn column(answer: &Answer, key: &str) -> Vec<f64> {
    let history = answer.flight.as_ref().unwrap().trajectory.as_ref().unwrap();
    history.column(key).unwrap().to_vec()
}

/// Independent: LSODA with the lift along u/√(u² + ε²), u the component of the vertical across the velocity; ε = 1e-3
/// and 1e-4 agree to 1e-3 s.
#[test]
fn lift_down_flies_into_the_vertical_and_stays() {
    let answer = flown(&[("vehicle.lift_to_drag", "1"), ("vehicle.bank_deg", "180")]);
    assert_eq!(answer.outcome, Outcome::Landed);
    assert!((output(&answer, "time_of_flight_s") - 359.69).abs() < 0.05);
    assert!((output(&answer, "final_speed_m_s") - 40.19).abs() < 0.01);
    let steps = column(&answer, "time_s").len();
    assert!(steps < 1_000, "{steps}");
}

/// Sideways and downward lift end in an ever tighter helix, which must not stop the flight.
#[test]
fn lift_at_any_bank_lands_in_few_steps() {
    for bank in ["60", "90", "91", "120", "150", "179.9", "-179.9", "270"] {
        let answer = flown(&[("vehicle.lift_to_drag", "1"), ("vehicle.bank_deg", bank)]);
        assert_eq!(answer.outcome, Outcome::Landed, "{bank}");
        let steps = column(&answer, "time_s").len();
        assert!(steps < 3_000, "{bank}: {steps}");
    }
}

/// Negative lift points down when upright, and in a climb upward lift leads into the vertical.
#[test]
fn lift_below_zero_and_in_a_climb_needs_few_steps() {
    let down = flown(&[("vehicle.lift_to_drag", "-1")]);
    assert!((output(&down, "time_of_flight_s") - 359.69).abs() < 0.05);
    let up = flown(&[
        ("vehicle.lift_to_drag", "2"),
        ("entry.altitude_m", "100"),
        ("entry.speed_m_s", "900"),
        ("entry.flight_path_angle_deg", "60"),
    ]);
    assert_eq!(up.outcome, Outcome::Landed);
    for answer in [down, up] {
        let steps = column(&answer, "time_s").len();
        assert!(steps < 3_000, "{steps}");
    }
}

/// In vertical flight lift has the direction of the limit beside it, given by the azimuth of the start.
#[test]
fn a_vertical_start_lifts_as_one_beside_it() {
    let at = |angle: &str| {
        flown(&[
            ("vehicle.lift_to_drag", "0.3"),
            ("entry.flight_path_angle_deg", angle),
            ("entry.azimuth_deg", "40"),
            // a rotating planet bends the fall before there is air
            ("planet.rotation_rate_rad_s", "0"),
        ])
    };
    let (exact, beside) = (at("-90"), at("-89.99999"));
    for key in ["final_longitude_deg", "final_latitude_deg"] {
        let (a, b) = (output(&exact, key), output(&beside, key));
        assert!((a - b).abs() < 1e-6 && a.abs() > 1e-3, "{key}: {a} and {b}");
    }
}

#[test]
fn bank_goes_the_shorter_way_and_says_so() {
    let key = "vehicle.bank_table_deg";
    let with = |rows: &str| flown(&[("vehicle.lift_to_drag", "0.3"), (key, rows)]);
    let through = with("[[0, 170], [60, 170], [61, -170], [500, -170]]");
    let written = with("[[0, 170], [60, 170], [61, 190], [500, 190]]");
    assert_eq!(said(&through, "bank").len(), 1);
    assert_eq!(said(&written, "bank").len(), 0);
    let end = |answer: &Answer| output(answer, "final_latitude_deg");
    assert!((end(&through) - end(&written)).abs() < 1e-9);
    // a reversal of 140 deg goes through upright, as prescribed
    assert!(said(&with("[[0, 70], [60, 70], [65, -70], [500, -70]]"), "bank").is_empty());
}

/// Independent: DOP853 in rotating axes, 29.5368 deg; from the pole the flight follows the meridian of the given
/// longitude.
#[test]
fn a_start_at_a_pole_goes_down_its_meridian() {
    for (latitude, azimuth) in [("90", "180"), ("-90", "0")] {
        let answer = flown(&[
            ("entry.latitude_deg", latitude),
            ("entry.longitude_deg", "30"),
            ("entry.azimuth_deg", azimuth),
        ]);
        let longitude_deg = output(&answer, "final_longitude_deg");
        assert!((longitude_deg - 29.5368).abs() < 1e-3, "{longitude_deg}");
        let first = column(&answer, "longitude_deg")[..3].to_vec();
        assert!(first.iter().all(|l| (l - 30.0).abs() < 0.01), "{first:?}");
        let azimuth_deg: f64 = azimuth.parse().unwrap();
        let first = column(&answer, "azimuth_deg")[0];
        let off = (first - azimuth_deg + 180.0).rem_euclid(360.0) - 180.0;
        assert!(off.abs() < 1e-9, "{first}");
    }
    // inertial and relative velocity are equal at the pole
    let inertial = flown(&[
        ("entry.latitude_deg", "90"),
        ("entry.longitude_deg", "30"),
        ("entry.azimuth_deg", "180"),
        ("entry.frame", "inertial"),
    ]);
    assert!((output(&inertial, "final_longitude_deg") - 29.5368).abs() < 1e-3);
    assert!((output(&inertial, "entry_relative_azimuth_deg") - 180.0).abs() < 1e-9);
}

#[test]
fn straight_up_and_down_yaw_is_told_and_roll_is_nought() {
    for (yaw, pitch, roll, expected) in [
        ("10", "90", "0", 10.0),
        ("10", "90", "25", -15.0),
        ("10", "-90", "25", 35.0),
    ] {
        let answer = flown(&[
            ("vehicle.dof", "6"),
            (
                "vehicle.inertia_kg_m2",
                "[[2.4, 0, 0], [0, 1.9, 0], [0, 0, 1.9]]",
            ),
            ("attitude.yaw_deg", yaw),
            ("attitude.pitch_deg", pitch),
            ("attitude.roll_deg", roll),
            ("stop.time_s", "0.1"),
            ("entry.latitude_deg", "45"),
            ("entry.longitude_deg", "100"),
        ]);
        let [y, p, r] = ["yaw_deg", "pitch_deg", "roll_deg"].map(|key| column(&answer, key)[0]);
        assert!((y - expected).abs() < 1e-9, "{y}");
        let pitch: f64 = pitch.parse().unwrap();
        assert!((p - pitch).abs() < 1e-9 && r == 0.0, "{p} {r}");
    }
}

/// The angle of attack of a vertical start refers to the azimuth of the case.
#[test]
fn the_angle_of_attack_of_a_vertical_start_is_against_its_azimuth() {
    let answer = flown(&[
        ("vehicle.dof", "6"),
        (
            "vehicle.inertia_kg_m2",
            "[[2.4, 0, 0], [0, 1.9, 0], [0, 0, 1.9]]",
        ),
        ("entry.flight_path_angle_deg", "-90"),
        ("entry.azimuth_deg", "70"),
        ("attitude.alpha_deg", "30"),
        ("stop.time_s", "0.1"),
    ]);
    // downward along azimuth 70 deg with the nose raised by 30 deg: pitch −60 deg, yaw 70 deg
    let [y, p, r] = ["yaw_deg", "pitch_deg", "roll_deg"].map(|key| column(&answer, key)[0]);
    assert!(
        (y - 70.0).abs() < 1e-6 && (p + 60.0).abs() < 1e-6 && r.abs() < 1e-6,
        "{y} {p} {r}"
    );
}

const INERTIA: (&str, &str) = (
    "vehicle.inertia_kg_m2",
    "[[2.4, 0, 0], [0, 1.9, 0], [0, 0, 1.9]]",
);

#[test]
fn an_attitude_comes_back_as_it_was_given() {
    for (latitude, longitude) in [("-89", "0"), ("0", "-120"), ("45", "100"), ("90", "359")] {
        let answer = flown(&[
            ("vehicle.dof", "6"),
            INERTIA,
            ("attitude.yaw_deg", "200"),
            ("attitude.pitch_deg", "-60"),
            ("attitude.roll_deg", "170"),
            ("stop.time_s", "0.1"),
            ("entry.latitude_deg", latitude),
            ("entry.longitude_deg", longitude),
        ]);
        let [y, p, r] = ["yaw_deg", "pitch_deg", "roll_deg"].map(|key| column(&answer, key)[0]);
        assert!(
            (y + 160.0).abs() < 1e-6 && (p + 60.0).abs() < 1e-6 && (r - 170.0).abs() < 1e-6,
            "{latitude} {longitude}: {y} {p} {r}"
        );
    }
}

/// cos of the total angle = cos of the angle of attack times cos of the sideslip angle.
#[test]
fn attack_and_sideslip_make_the_total_angle() {
    let of = |alpha: &str, beta: &str| {
        let answer = flown(&[
            ("vehicle.dof", "6"),
            INERTIA,
            ("attitude.alpha_deg", alpha),
            ("attitude.beta_deg", beta),
            ("stop.time_s", "0.1"),
        ]);
        column(&answer, "total_alpha_deg").to_vec()
    };
    let total = of("30", "40")[0];
    assert!((total - 48.43924).abs() < 1e-4, "{total}");
    let (one, other) = (of("180", "0"), of("-180", "0"));
    for (one, other) in one.iter().zip(&other) {
        assert!((one - other).abs() < 1e-9, "{one} {other}");
    }
}
