//! Flights.

use crate::config;
use msape::library::named;
use msape::planet::Gravity;
use msape::planet::geodetic::Geodetic;
use msape::{Case, Library, Request};
use msape_tests::entry::{Entry, flown, flown_with, output, set};
use proptest::prelude::*;
use std::sync::LazyLock;

static LIBRARY: LazyLock<Library> = LazyLock::new(|| Library::builtin().unwrap());

fn entry(angles_deg: std::ops::Range<f64>) -> impl Strategy<Value = Entry> {
    (10_000.0..16_000.0, angles_deg, 20.0..300.0, 0.1..1.0).prop_map(
        |(speed_m_s, flight_path_angle_deg, ballistic_coefficient_kg_m2, nose_radius_m)| Entry {
            speed_m_s,
            flight_path_angle_deg,
            ballistic_coefficient_kg_m2,
            nose_radius_m,
        },
    )
}

fn exact(mut case: Case) -> Case {
    case.set("solver.method", "dormand-prince-853");
    set(&mut case, "solver.tolerance", 1e-12);
    case
}

/// Specific energy in the inertial frame, J/kg, along a flight over the report's Earth.
fn energies_j_kg(case: &Case) -> Vec<f64> {
    let planet = &named(&LIBRARY.planets, "earth-msape").unwrap().planet;
    let Gravity::Zonal {
        mu_m3_s2: mu,
        j2,
        reference_radius_m,
        ..
    } = planet.gravity
    else {
        panic!("the report's Earth has zonal gravity");
    };
    let answer = flown_with(case, &LIBRARY, Request::Steps);
    let flight = answer.flight.unwrap();
    let history = flight.trajectory.unwrap();
    let column = |key: &str| history.column(key).unwrap().to_vec();
    let [h, lat, lon, v] = [
        "altitude_m",
        "latitude_deg",
        "longitude_deg",
        "inertial_speed_m_s",
    ]
    .map(column);
    (0..h.len())
        .map(|i| {
            let [x, y, z] = planet.cartesian_m(&Geodetic {
                altitude_m: h[i],
                latitude_rad: lat[i].to_radians(),
                longitude_rad: lon[i].to_radians(),
            });
            let r = (x * x + y * y + z * z).sqrt();
            let p2 = 1.5 * (z / r) * (z / r) - 0.5;
            let reach = reference_radius_m / r;
            0.5 * v[i] * v[i] - mu / r * (1.0 - j2 * reach * reach * p2)
        })
        .collect()
}

proptest! {
    #![proptest_config(config(60))]

    /// To 1e-9 of the sum of both energies, which are 6e7 J/kg and more.
    #[test]
    fn without_drag_energy_is_kept(
        entry in entry(-90.0..90.0),
        latitude_deg in -90.0..90.0,
        azimuth_deg in 0.0..360.0,
    ) {
        let mut case = exact(entry.case());
        set(&mut case, "entry.latitude_deg", latitude_deg);
        set(&mut case, "entry.azimuth_deg", azimuth_deg);
        set(&mut case, "vehicle.drag_coefficient", 0.0);
        set(&mut case, "stop.time_s", 2_000.0);
        let energies = energies_j_kg(&case);
        // a level start above escape speed leaves at once
        prop_assert!(energies.len() > 2 || entry.flight_path_angle_deg >= 0.0);
        for energy in &energies {
            prop_assert!((energy - energies[0]).abs() < 1e-9 * 1.2e8, "{} {}", energy, energies[0]);
        }
    }

    /// Sutton and Graves: four times the nose radius, half the heating.
    #[test]
    fn convective_heating_goes_with_the_root_of_the_nose_radius(entry in entry(-90.0..-6.0)) {
        let flight = |nose_radius_m| {
            let mut case = exact(Entry { nose_radius_m, ..entry }.case());
            case.set("heating.radiative", "none");
            flown(&case, &LIBRARY)
        };
        let (small, large) = (flight(entry.nose_radius_m), flight(4.0 * entry.nose_radius_m));
        for key in ["peak_convective_heat_flux_w_m2", "convective_heat_load_j_m2"] {
            let ratio = output(&small, key) / output(&large, key);
            prop_assert!((ratio - 2.0).abs() < 1e-6, "{}: {}", key, ratio);
        }
        // heating does not affect the motion
        let key = "peak_deceleration_earth_g";
        prop_assert!((output(&small, key) / output(&large, key) - 1.0).abs() < 1e-8);
    }

    /// A heavier body decelerates lower: it reaches the density that decelerates it further down.
    #[test]
    fn a_heavier_body_decelerates_lower(entry in entry(-60.0..-12.0), factor in 1.1..3.0) {
        let heavier = Entry {
            ballistic_coefficient_kg_m2: factor * entry.ballistic_coefficient_kg_m2,
            ..entry
        };
        let [light, heavy] = [entry, heavier].map(|entry| flown(&entry.case(), &LIBRARY));
        for key in ["peak_deceleration_altitude_m", "peak_total_heat_flux_altitude_m"] {
            prop_assert!(output(&heavy, key) < output(&light, key), "{}", key);
        }
        for key in ["final_speed_m_s", "peak_convective_heat_flux_w_m2"] {
            prop_assert!(output(&heavy, key) > output(&light, key), "{}", key);
        }
    }

    /// Mass and area have no effect except through the ballistic coefficient.
    #[test]
    fn only_the_ballistic_coefficient_counts(entry in entry(-90.0..-6.0), factor in 0.01..100.0) {
        let case = exact(entry.case());
        let mut scaled = case.clone();
        set(&mut scaled, "vehicle.mass_kg", factor * entry.ballistic_coefficient_kg_m2);
        set(&mut scaled, "vehicle.reference_area_m2", factor);
        let [one, other] = [case, scaled].map(|case| flown(&case, &LIBRARY));
        for key in ["peak_deceleration_earth_g", "convective_heat_load_j_m2", "final_speed_m_s"] {
            let ratio = output(&one, key) / output(&other, key);
            prop_assert!((ratio - 1.0).abs() < 1e-7, "{}: {}", key, ratio);
        }
    }

    /// At terminal speed a body drifts with the wind.
    #[test]
    fn a_falling_body_drifts_with_the_wind(
        east_m_s in -100.0..100.0,
        north_m_s in -100.0..100.0,
        mass_kg in 10.0..100.0,
    ) {
        let start = Entry { speed_m_s: 0.0, flight_path_angle_deg: -90.0, ..Entry::RUN_PAGE };
        let mut calm = start.case();
        set(&mut calm, "vehicle.mass_kg", mass_kg);
        set(&mut calm, "entry.altitude_m", 12_000.0);
        let mut windy = calm.clone();
        set(&mut windy, "wind.eastward_m_s", east_m_s);
        set(&mut windy, "wind.northward_m_s", north_m_s);
        let [calm, windy] = [calm, windy].map(|case| {
            let answer = flown_with(&case, &LIBRARY, Request::Steps);
            let flight = answer.flight.unwrap();
            let history = flight.trajectory.unwrap();
            ["eastward_speed_m_s", "northward_speed_m_s", "time_s"]
                .map(|key| *history.column(key).unwrap().last().unwrap())
        });
        // the rotating planet deflects some of the wind: 2 ω v over the time in which drag acts, 1e-4 · 2 · 5 s
        let wind_m_s = east_m_s.hypot(north_m_s);
        prop_assert!((windy[0] - calm[0] - east_m_s).abs() < 0.003 * wind_m_s + 1e-6);
        prop_assert!((windy[1] - calm[1] - north_m_s).abs() < 0.003 * wind_m_s + 1e-6);
    }

    /// A history begins at the start and ends with the results; all of its columns have the same length.
    #[test]
    fn a_history_ends_where_the_flight_ends(entry in entry(-90.0..-2.0), step_s in 0.1..50.0) {
        for request in [Request::Steps, Request::Uniform(step_s)] {
            let answer = flown_with(&entry.case(), &LIBRARY, request);
            let history = answer.flight.as_ref().unwrap().trajectory.as_ref().unwrap();
            prop_assert!(history.columns().all(|(_, values)| values.len() == history.rows()));
            let times_s = history.column("time_s").unwrap();
            prop_assert_eq!(times_s[0], 0.0);
            prop_assert!(times_s.windows(2).all(|pair| pair[0] < pair[1]));
            let last = |key: &str| *history.column(key).unwrap().last().unwrap();
            prop_assert_eq!(last("time_s"), output(&answer, "time_of_flight_s"));
            // the history uses the fast formula for altitude, accurate to 1e-5 m
            let gap_m = last("altitude_m") - output(&answer, "final_altitude_m");
            prop_assert!(gap_m.abs() < 1e-5, "{}", gap_m);
        }
    }
}

/// Halving the step of the classical method divides its error by 2⁴.
#[test]
fn the_classical_method_is_of_order_four() {
    let mut case = Entry::RUN_PAGE.case();
    for (key, value) in [
        ("planet.radius_m", 6_378_000.0),
        ("planet.uniform_gravity_m_s2", 9.81),
        ("atmosphere.exponential.density_kg_m3", 1.215),
        ("atmosphere.exponential.scale_height_m", 8_500.0),
        ("stop.time_s", 64.0),
    ] {
        set(&mut case, key, value);
    }
    case.set("heating.radiative", "none");
    let keys = ["final_speed_m_s", "convective_heat_load_j_m2"];
    let reference = flown(&exact(case.clone()), &LIBRARY);
    case.set("solver.method", "rk4");
    let errors = [0.5, 0.25, 0.125].map(|step_s| {
        set(&mut case, "solver.step_s", step_s);
        let answer = flown(&case, &LIBRARY);
        keys.map(|key| (output(&answer, key) - output(&reference, key)).abs())
    });
    for (i, key) in keys.iter().enumerate() {
        for pair in errors.windows(2) {
            let order = (pair[0][i] / pair[1][i]).log2();
            assert!(
                (order - 4.0).abs() < 0.3,
                "{key}: order {order}, {errors:?}"
            );
        }
    }
}
