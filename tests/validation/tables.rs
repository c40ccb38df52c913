//! Tables of a case, and flights that leave their range.

use msape::{Answer, Outcome, Request};
use msape_tests::entry::output;
use msape_tests::text::{PLAIN, answer, case, ended, said};

fn flown(text: &str, edits: &[(&str, &str)]) -> Answer {
    answer(&case(text, edits), Request::Steps).unwrap()
}

fn column(answer: &Answer, key: &str) -> Vec<f64> {
    let history = answer.flight.as_ref().unwrap().trajectory.as_ref().unwrap();
    history.column(key).unwrap().to_vec()
}

/// Rows of a body with C_A = 1.4 (1 + cos 2α)/2 and C_N = ½ sin α up to an angle, at two Mach numbers.
fn own_table(to_deg: u32, factor: f64) -> String {
    let rows = [0.5, 20.0].iter().flat_map(|mach| {
        (0..=to_deg / 10).map(move |i| {
            let alpha_deg = f64::from(10 * i);
            let alpha = alpha_deg.to_radians();
            let (ca, cn) = (1.4 * alpha.cos(), 0.5 * alpha.sin());
            let cm = -0.4 * cn;
            format!("[{mach}, {}, {ca}, {cn}, {cm}]", alpha_deg * factor)
        })
    });
    format!("[{}]", rows.collect::<Vec<_>>().join(", "))
}

/// A rigid body that tumbles near the ground.
const TUMBLING: &str = "
schema = 'msape/1'
version = '0.2'
[entry]
planet = 'earth'
altitude_m = 125000.0
latitude_deg = 0.0
longitude_deg = 0.0
speed_m_s = 7800.0
flight_path_angle_deg = -8.0
azimuth_deg = 90.0
[heating]
radiative = 'none'
[vehicle]
dof = 6
mass_kg = 46.0
diameter_m = 0.8128
nose_radius_m = 0.22
inertia_kg_m2 = [[2.374, 0, 0], [0, 1.899, 0], [0, 0, 1.899]]
cg_m = [0.3, 0, 0]
[attitude]
alpha_deg = 5.0
";

#[test]
fn a_held_table_says_how_far_it_was_left_and_that_the_air_pushed() {
    let table = own_table(30, 1.0);
    let answer = flown(TUMBLING, &[("vehicle.aerodynamics.table", &table)]);
    let told = said(&answer, "vehicle.aerodynamics.table").join("\n");
    assert!(told.contains("total angle of attack reaches 17"), "{told}");
    assert!(told.contains("the table goes from 0 to 30 deg; beyond, the end is held"));
    assert!(told.contains("Mach number reaches 28.57"), "{told}");
    assert_eq!(told.lines().count(), 3, "{told}");
    // C_A cos α + C_N sin α of 1.212 and 0.25 held
    let pushed = said(&answer, "aerodynamic coefficients").concat();
    assert!(pushed.contains("the air pushes the vehicle"), "{pushed}");
}

#[test]
fn a_refused_table_ends_the_flight_where_it_is_left() {
    let table = own_table(30, 1.0);
    let edits = [
        ("vehicle.aerodynamics.table", table.as_str()),
        ("vehicle.aerodynamics.extrapolation", "refuse"),
    ];
    let answer = flown(TUMBLING, &edits);
    let (outcome, reason) = ended(&answer);
    assert_eq!(outcome, Outcome::Stopped);
    assert!(reason.contains("total angle of attack left"), "{reason}");
    let largest = column(&answer, "total_alpha_deg")
        .into_iter()
        .fold(0.0, f64::max);
    assert!((largest - 30.0).abs() < 1e-3, "{largest}");
    // according to the rates at which the vehicle oscillates with the whole table of 180 deg: first beyond 30 deg
    // between 204 and 206 s
    let end_s = output(&answer, "time_of_flight_s");
    assert!((204.0..206.0).contains(&end_s), "{end_s}");
    assert!(said(&answer, "aerodynamic coefficients").is_empty());
    let told = said(&answer, "vehicle.aerodynamics.table").join("\n");
    assert!(told.contains("there the flight was ended"), "{told}");
}

#[test]
fn a_whole_table_is_not_left_and_nothing_pushes() {
    let answer = flown(
        TUMBLING,
        &[("vehicle.aerodynamics.table", &own_table(180, 1.0))],
    );
    let told = said(&answer, "vehicle.aerodynamics.table").join("\n");
    assert!(!told.contains("angle of attack"), "{told}");
    assert!(said(&answer, "aerodynamic coefficients").is_empty());
}

#[test]
fn angles_in_radians_are_refused_with_their_rows() {
    let radians = own_table(180, 1.0_f64.to_radians());
    let table = [("vehicle.aerodynamics.table", radians.as_str())];
    let faults = answer(&case(TUMBLING, &table), Request::Nothing).unwrap_err();
    assert!(faults.contains("are the angles in rad?"), "{faults}");
    assert!(faults.contains("the air would push the body"), "{faults}");
    // up to a right angle nothing pushes the body: this is reported
    let radians = own_table(90, 1.0_f64.to_radians());
    let answer = flown(
        TUMBLING,
        &[("vehicle.aerodynamics.table", radians.as_str())],
    );
    let told = said(&answer, "vehicle.aerodynamics.table").join("\n");
    assert!(told.contains("are its angles in rad?"), "{told}");
}

/// Each kind of table in three degrees of freedom.
#[test]
fn drag_lift_bank_and_wind_say_that_they_were_left() {
    for (key, rows, argument) in [
        (
            "vehicle.drag_table",
            "[[2.0, 1.0], [10.0, 1.2]]",
            "Mach number",
        ),
        (
            "vehicle.lift_table",
            "[[2.0, 0.1], [10.0, 0.2]]",
            "Mach number",
        ),
        (
            "vehicle.bank_table_deg",
            "[[10.0, 0.0], [50.0, 30.0]]",
            "time",
        ),
        (
            "vehicle.bank_speed_table_deg",
            "[[500, 0.0], [6000.0, 30.0]]",
            "speed",
        ),
        (
            "wind.table",
            "[[10e3, 5.0, 0.0], [50e3, 9.0, 0.0]]",
            "altitude",
        ),
    ] {
        let mut edits = vec![(key, rows)];
        if key == "vehicle.drag_table" {
            edits.push(("vehicle.drag_coefficient", ""));
        }
        if key.starts_with("vehicle.bank") {
            edits.push(("vehicle.lift_to_drag", "0.2"));
        }
        let told = said(&flown(PLAIN, &edits), key);
        assert_eq!(told.len(), 2, "{key}: {told:?}");
        assert!(told.iter().all(|line| line.contains(argument)), "{told:?}");
    }
    // rows of an atmosphere: above and below
    let edits = [
        ("atmosphere.exponential.density_kg_m3", ""),
        ("atmosphere.exponential.scale_height_m", ""),
        ("atmosphere.table", "[[5e3, 0.61], [80e3, 1.8e-5]]"),
    ];
    assert_eq!(said(&flown(PLAIN, &edits), "atmosphere").len(), 2);
}

/// At Mach 10, with the exponential atmosphere's speed of sound, the flight ends; held and extended, it continues
/// differently.
#[test]
fn a_drag_table_is_held_extended_or_refused() {
    let with = |rule: &str| {
        flown(
            PLAIN,
            &[
                ("vehicle.drag_coefficient", ""),
                ("vehicle.drag_table", "[[4.0, 1.0], [10.0, 1.6]]"),
                ("vehicle.aerodynamics.extrapolation", rule),
            ],
        )
    };
    let [hold, extend, refuse] = ["hold", "extend", "refuse"].map(with);
    let (outcome, reason) = ended(&refuse);
    assert_eq!(outcome, Outcome::Stopped);
    assert!(reason.contains("the Mach number left vehicle.drag_table, which goes from 4 to 10"));
    let drag = |answer: &Answer| column(answer, "drag_coefficient")[0];
    assert_eq!(drag(&hold), 1.6);
    // 0.1 per unit of Mach number
    let mach = column(&extend, "mach")[0];
    assert!((drag(&extend) - (0.6 + 0.1 * mach)).abs() < 1e-12);
    assert_eq!(hold.outcome, Outcome::Landed);
}

#[test]
fn rows_of_tables_have_ranges() {
    for (key, rows, said) in [
        (
            "attitude.body_rates_deg_s",
            "[9e7, 0, 0]",
            "row 1, p_deg_s: got 90000000, must be -36000 to 36000",
        ),
        (
            "wind.table",
            "[[0, 1e6, 0]]",
            "row 1, eastward_m_s: got 1000000, must be -2000 to 2000",
        ),
        (
            "vehicle.lift_table",
            "[[0, 1], [1, 1e30]]",
            "row 2, lift_coefficient: got 1e30, must be -100 to 100",
        ),
        ("planet.equatorial_radius_m", "8e29", "must be 100 to"),
    ] {
        let text = if key.starts_with("attitude") {
            TUMBLING
        } else {
            PLAIN
        };
        let faults = answer(&case(text, &[(key, rows)]), Request::Nothing).unwrap_err();
        assert!(faults.contains(said), "{faults}");
    }
}
