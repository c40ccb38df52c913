//! Any planet: its own atmosphere, figure and depth, or a clear message.

use msape::finding::Finding;
use msape::library::named;
use msape::table::kml::{Instant, kml};
use msape::{Answer, Case, Library, Request, fly};
use std::sync::LazyLock;

pub(crate) static LIBRARY: LazyLock<Library> = LazyLock::new(|| Library::builtin().unwrap());

const PLANETS: [&str; 8] = [
    "earth", "venus", "mars", "titan", "jupiter", "saturn", "uranus", "neptune",
];

/// A steep fall through the atmosphere of a planet, from an altitude and with a speed; `more` is appended to the case.
pub(crate) fn case(planet: &str, altitude_m: f64, speed_m_s: f64, more: &str) -> Case {
    Case::from_toml(&format!(
        "schema = 'msape/1'\nversion = '0.2'\nname = 't'\n{more}\n\
         [entry]\nplanet = '{planet}'\naltitude_m = {altitude_m:?}\nlatitude_deg = 20.0\nlongitude_deg = 0.0\n\
         speed_m_s = {speed_m_s:?}\nflight_path_angle_deg = -30.0\nazimuth_deg = 90.0\n\
         [heating]\nradiative = 'none'\nconvective_margin = 1.0\n\
         [vehicle]\nmass_kg = 500.0\ndiameter_m = 2.65\nnose_radius_m = 0.66\ndrag_coefficient = 1.6\n"
    ))
    .unwrap()
}

pub(crate) fn flown(case: &Case) -> Answer {
    fly(case, &LIBRARY, Request::Steps).unwrap()
}

pub(crate) fn refused(case: &Case) -> String {
    let faults = fly(case, &LIBRARY, Request::Nothing).unwrap_err();
    let lines: Vec<String> = faults.iter().map(ToString::to_string).collect();
    lines.join("\n")
}

/// First and last number of a column of the history.
pub(crate) fn ends(answer: &Answer, key: &str) -> [f64; 2] {
    let history = answer.flight.as_ref().unwrap().trajectory.as_ref().unwrap();
    let column = history.column(key).unwrap();
    [column[0], *column.last().unwrap()]
}

pub(crate) fn told<'a>(answer: &'a Answer, words: &str) -> Option<&'a Finding> {
    let mut findings = answer.findings.iter();
    findings.find(|finding| finding.message.contains(words))
}

/// Rows as the atmosphere of a case that ends after a second.
pub(crate) fn table<const K: usize>(rows: &[[f64; K]]) -> String {
    let rows: Vec<String> = rows.iter().map(|row| format!("{row:?}")).collect();
    format!(
        "stop.time_s = 1.0\n[atmosphere]\ntable = [{}]\n",
        rows.join(", ")
    )
}

#[test]
fn every_planet_flies_through_its_own_air_and_through_no_other() {
    for name in PLANETS {
        let planet = &named(&LIBRARY.planets, name).unwrap().planet;
        let (_, own) = named(&LIBRARY.atmospheres, &planet.atmosphere).unwrap();
        let altitude_m = planet.exponential_fit_m[0];
        for named_so in ["", "planet", &planet.atmosphere] {
            let mut case = case(name, altitude_m, 3000.0, "stop.time_s = 1.0");
            case.set("entry.atmosphere", named_so);
            let answer = flown(&case);
            let air = own.air(altitude_m);
            let [density, _] = ends(&answer, "density_kg_m3");
            assert!(
                (density / air.density_kg_m3 - 1.0).abs() < 1e-6,
                "{name}: {density}"
            );
            let [mach, _] = ends(&answer, "mach");
            assert!(
                (mach * air.speed_of_sound_m_s / 3000.0 - 1.0).abs() < 1e-6,
                "{name}: {mach}"
            );
        }
        for (other, _) in &LIBRARY.atmospheres {
            if *other != planet.atmosphere {
                let mut case = case(name, altitude_m, 3000.0, "");
                case.set("entry.atmosphere", other);
                let fault = refused(&case);
                let expected = format!("must be \"planet\" or \"{}\"", planet.atmosphere);
                assert!(
                    fault.contains("entry.atmosphere: got") && fault.contains(&expected),
                    "{fault}"
                );
            }
        }
    }
}

#[test]
fn the_ground_of_mars_has_its_own_pressure() {
    let answer = flown(&case("mars", 125e3, 5600.0, ""));
    let [_, pressure] = ends(&answer, "pressure_pa");
    assert!((pressure - 600.3).abs() < 0.1, "{pressure}");
}

#[test]
fn downrange_is_on_the_planet_s_own_figure() {
    let geodesic = |name: &str| {
        let answer = flown(&case(name, 125e3, 7000.0, "stop.time_s = 60.0"));
        let flight = answer.flight.unwrap();
        let east_rad = flight.final_longitude_rad;
        // nearly along the parallel of 20 deg over so short a distance: N cos φ Δλ, N = a/√(1 − e² sin² φ)
        let planet = &named(&LIBRARY.planets, name).unwrap().planet;
        let (a, b) = (planet.equatorial_radius_m, planet.polar_radius_m);
        let sine = 20.0_f64.to_radians().sin();
        let normal_m = a / (1.0 - (1.0 - b * b / (a * a)) * sine * sine).sqrt();
        let along_m = normal_m * 20.0_f64.to_radians().cos() * east_rad.abs();
        (flight.downrange_m, along_m)
    };
    for name in PLANETS.into_iter().filter(|name| *name != "earth") {
        let (got, expected) = geodesic(name);
        // the planet rotates under the flight, which leaves the parallel
        assert!(
            (got / expected - 1.0).abs() < 0.01,
            "{name}: {got} against {expected}"
        );
    }
    // on both Earths the sphere of 6371 km, 6 m less than the parallel of the ellipsoid in 1000 m
    let (got, expected) = geodesic("earth");
    assert!(
        (got / expected - 0.9985).abs() < 2e-3,
        "{got} against {expected}"
    );
}

#[test]
fn a_flight_may_end_as_deep_as_the_planet_allows_and_no_deeper() {
    for name in PLANETS {
        let planet = &named(&LIBRARY.planets, name).unwrap().planet;
        let lowest_m = planet.lowest_altitude_m;
        let at = |altitude_m: f64| {
            case(
                name,
                1e4,
                300.0,
                &format!("stop.altitude_m = {altitude_m:?}"),
            )
        };
        let answer = flown(&at(lowest_m));
        let [_, altitude_m] = ends(&answer, "altitude_m");
        assert!((altitude_m - lowest_m).abs() < 1.0, "{name}: {altitude_m}");
        let fault = refused(&at(lowest_m - 1.0));
        let expected = format!(
            "must be at least {lowest_m} m, the lowest of {}",
            planet.title
        );
        assert!(fault.contains(&expected), "{fault}");
    }
    // Hellas: below the first row of the atmosphere, which gives a finding
    let answer = flown(&case("mars", 125e3, 6000.0, "stop.altitude_m = -7100.0"));
    assert!(
        told(
            &answer,
            "reaches -7100 m, the atmosphere is given from 0 to 200000 m"
        )
        .is_some()
    );
    let [_, density] = ends(&answer, "density_kg_m3");
    // 0.01466 kg/m³ and the slope of the first kilometer, 0.01327: × (0.01466/0.01327)^7.1
    assert!((density - 0.02971).abs() < 2e-4, "{density}");
    // a table of the case may reach deeper
    let deep = table(&[[-3e5, 1.0], [3e5, 1e-6]])
        .replace("stop.time_s = 1.0", "stop.altitude_m = -250000.0");
    let answer = flown(&case("uranus", 1e4, 1000.0, &deep));
    assert_eq!(ends(&answer, "altitude_m")[1].round(), -250_000.0);
}

#[test]
fn a_track_says_over_which_body_it_is() {
    let of = |name: &str| {
        let answer = flown(&case(name, 1e5, 3000.0, "stop.time_s = 5.0"));
        kml(&answer, Instant::parse("2030-01-01T00:00:00Z").unwrap()).unwrap()
    };
    let mars = of("mars");
    assert!(mars.contains(" hint=\"target=mars\">") && mars.contains("The body is Mars."));
    for (name, title) in [
        ("titan", "Titan"),
        ("jupiter", "Jupiter"),
        ("venus", "Venus"),
    ] {
        let text = of(name);
        assert!(
            text.contains(&format!("The body is {title}: a viewer")),
            "{name}"
        );
        assert!(!text.contains("hint="), "{name}");
    }
    assert!(!of("earth").contains("The body is"));
}

#[test]
fn pressure_of_a_perfect_gas_is_of_the_planet_s_ratio_of_heat_capacities() {
    // Cp,max at Mach ∞: 2/γ [(γ+1)²/4γ]^(γ/(γ−1)) 2γ/(γ+1)
    let limit = |g: f64| 4.0 / (g + 1.0) * ((g + 1.0) * (g + 1.0) / (4.0 * g)).powf(g / (g - 1.0));
    for name in ["venus", "mars", "neptune", "earth"] {
        let planet = &named(&LIBRARY.planets, name).unwrap().planet;
        let altitude_m = planet.exponential_fit_m[0];
        let mut case = case(name, altitude_m, 9000.0, "stop.time_s = 0.001");
        case.set("heating.stagnation_pressure", "perfect-gas");
        let answer = flown(&case);
        let (_, own) = named(&LIBRARY.atmospheres, &planet.atmosphere).unwrap();
        let gamma = own.air(altitude_m).heat_capacity_ratio;
        let [rise, _] = ends(&answer, "stagnation_pressure_pa");
        let [q, _] = ends(&answer, "dynamic_pressure_pa");
        assert!(
            (rise / q / limit(gamma) - 1.0).abs() < 0.01,
            "{name}: {} for {gamma}",
            rise / q
        );
    }
}

#[test]
fn a_planet_of_the_case_takes_the_air_of_the_one_that_is_named() {
    let mars = "[planet]\nradius_m = 3389500.0\nmu_m3_s2 = 4.2828e13\n";
    let named_so = case("mars", 125e3, 5600.0, mars);
    let answer = flown(&named_so);
    assert!((ends(&answer, "pressure_pa")[1] - 600.3).abs() < 0.1);
    assert_eq!(answer.planet.kml_target.as_deref(), Some("mars"));
    // an atmosphere alone identifies the gas, too; without either the Earth's is assumed
    let mut by_air = named_so.clone();
    by_air.set("entry.planet", "");
    by_air.set("entry.atmosphere", "mars");
    assert!((ends(&flown(&by_air), "pressure_pa")[1] - 600.3).abs() < 0.1);
    let mut unnamed = case(
        "mars",
        125e3,
        5600.0,
        &format!("{}{mars}", table(&[[0.0, 0.02, 200.0], [1e5, 1e-6, 150.0]])),
    );
    unnamed.set("entry.planet", "");
    assert!(
        told(
            &flown(&unnamed),
            "The gas is assumed: of U.S. Standard Atmosphere 1976"
        )
        .is_some()
    );
}

#[test]
fn a_wall_in_equilibrium_is_of_the_planet_s_gas() {
    // h_w/h₀ of hydrogen at a few thousand kelvin is a dozen times that of air
    let lowered = |planet: &str| {
        let of = |wall: &str| {
            let air = "stop.time_s = 0.001\n[atmosphere]\nexponential = { density_kg_m3 = 1e-4, scale_height_m = 30000.0 }\n";
            let mut case = case(planet, 0.0, 12e3, air);
            case.set("heating.wall", wall);
            flown(&case)
                .flight
                .unwrap()
                .peak_convective_heat_flux_w_m2
                .value
        };
        1.0 - of("radiative-equilibrium") / of("cold")
    };
    let (earth, saturn) = (lowered("earth"), lowered("saturn"));
    assert!(earth > 0.01 && saturn > 6.0 * earth, "{earth} {saturn}");
}
