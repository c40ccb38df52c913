//! Starts at singular directions and places, compared with an independent integration.

use msape::{Outcome, Request};
use msape_tests::entry::output;
use msape_tests::text::{PLAIN, answer, case};

/// Name, keys with their values, and compared results.
type Start = (
    &'static str,
    &'static [(&'static str, &'static str)],
    [f64; 5],
);

/// Starts, and results of an independent integration of the same equations in rotating Cartesian axes (DOP853): time of
/// flight in s, final speed in m/s, final latitude and longitude in deg, peak deceleration in g (taken at samples,
/// 1e-3). Printed to the digits that are compared.
const SINGULAR: [Start; 8] = [
    (
        "straight down",
        &[
            ("entry.latitude_deg", "45"),
            ("entry.longitude_deg", "10"),
            ("entry.speed_m_s", "11000"),
            ("entry.flight_path_angle_deg", "-90"),
            ("entry.azimuth_deg", "37"),
            ("entry.frame", "inertial"),
        ],
        [262.844, 40.244, 45.00001, 9.95892, 320.336],
    ),
    (
        "over the pole",
        &[
            ("entry.latitude_deg", "80"),
            ("entry.longitude_deg", "40"),
            ("entry.flight_path_angle_deg", "-2"),
            ("entry.azimuth_deg", "0"),
            ("vehicle.mass_kg", "200"),
        ],
        [543.866, 57.326, 81.22464, -142.46717, 9.203],
    ),
    (
        "over the date line",
        &[
            ("entry.latitude_deg", "-10"),
            ("entry.longitude_deg", "179"),
            ("entry.flight_path_angle_deg", "-3"),
            ("entry.azimuth_deg", "80"),
            ("vehicle.mass_kg", "200"),
        ],
        [549.097, 57.180, -6.25347, -162.64501, 7.472],
    ),
    (
        "from longitude 360",
        &[
            ("entry.latitude_deg", "-10"),
            ("entry.longitude_deg", "360"),
            ("entry.flight_path_angle_deg", "-3"),
            ("entry.azimuth_deg", "80"),
            ("vehicle.mass_kg", "200"),
        ],
        [549.097, 57.180, -6.25347, 18.35499, 7.472],
    ),
    (
        "a million kg/m²",
        &[
            ("entry.latitude_deg", "20"),
            ("entry.speed_m_s", "7000"),
            ("entry.flight_path_angle_deg", "-20"),
            ("entry.azimuth_deg", "45"),
            ("vehicle.mass_kg", "1e6"),
        ],
        [51.112, 7079.402, 22.12717, 2.30910, 3.130],
    ),
    (
        "dropped at rest",
        &[
            ("entry.altitude_m", "30000"),
            ("entry.latitude_deg", "20"),
            ("entry.speed_m_s", "0"),
            ("entry.flight_path_angle_deg", "0"),
            ("entry.azimuth_deg", "0"),
            ("vehicle.mass_kg", "200"),
        ],
        [234.166, 57.196, 20.0, 0.00058, 1.355],
    ),
    (
        "rising at the start",
        &[
            ("entry.speed_m_s", "6000"),
            ("entry.flight_path_angle_deg", "5"),
        ],
        [819.045, 40.190, 0.0, 24.61987, 14.307],
    ),
    (
        "below sea level",
        &[
            ("entry.altitude_m", "-100"),
            ("entry.latitude_deg", "20"),
            ("entry.speed_m_s", "100"),
            ("entry.flight_path_angle_deg", "-10"),
            ("entry.azimuth_deg", "0"),
            ("stop.altitude_m", "-400"),
            ("vehicle.mass_kg", "200"),
        ],
        [8.639, 51.627, 20.00350, 0.0, 3.167],
    ),
];

#[test]
fn singular_starts_fly_as_an_independent_code_has_it() {
    for (name, edits, [time_s, speed_m_s, latitude_deg, longitude_deg, peak_g]) in SINGULAR {
        let answer = answer(&case(PLAIN, edits), Request::Nothing).unwrap();
        assert_eq!(answer.outcome, Outcome::Landed, "{name}");
        for (key, expected, within) in [
            ("time_of_flight_s", time_s, 1e-3),
            ("final_speed_m_s", speed_m_s, 1e-3),
            ("final_latitude_deg", latitude_deg, 1e-5),
            ("final_longitude_deg", longitude_deg, 1e-5),
            ("peak_deceleration_earth_g", peak_g, 1e-3 * peak_g),
        ] {
            let found = output(&answer, key);
            assert!(
                (found - expected).abs() <= within,
                "{name}: {key}: {found}, not {expected}"
            );
        }
    }
}
