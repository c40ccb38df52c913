//! Plausible entries at all planets: each ends with finite numbers, where it should, without energy from the
//! atmosphere, and reproducibly.

use super::truths::{at_its_end, finite, no_energy_from_air, repeated};
use super::{Tally, hold};
use crate::designs::LIBRARY;
use msape::library::named;
use msape::planet::Gravity;
use msape::quantity::Job;
use msape::quantity::input::{Choices, Kind, find};
use msape::{Case, Request};
use proptest::prelude::*;
use proptest::sample::select;

/// Speed of a circular orbit at the surface, m/s.
fn circular_m_s(planet: &str) -> f64 {
    let planet = &named(&LIBRARY.planets, planet).unwrap().planet;
    match planet.gravity {
        Gravity::Zonal { mu_m3_s2, .. } => (mu_m3_s2 / planet.equatorial_radius_m).sqrt(),
        Gravity::Uniform { acceleration_m_s2 } => {
            (acceleration_m_s2 * planet.equatorial_radius_m).sqrt()
        }
    }
}

/// Keys and their typed values.
type Typed = Vec<(&'static str, String)>;

fn number(key: &'static str, range: std::ops::Range<f64>) -> BoxedStrategy<Typed> {
    range
        .prop_map(move |x| vec![(key, format!("{x:?}"))])
        .boxed()
}

fn one_of(key: &'static str, words: &[&'static str]) -> BoxedStrategy<Typed> {
    let Some(Kind::Choice(Choices::Fixed(known))) = find(key).map(|input| input.kind) else {
        panic!("{key} is no choice of fixed names");
    };
    for word in words {
        assert!(known.iter().any(|(name, _)| name == word), "{key}: {word}");
    }
    select(words.to_vec())
        .prop_map(move |word| vec![(key, word.to_string())])
        .boxed()
}

/// Nothing, or the drawn value; nothing is five times as likely.
fn perhaps(drawn: BoxedStrategy<Typed>) -> BoxedStrategy<Typed> {
    prop_oneof![5 => Just(Vec::new()), 1 => drawn].boxed()
}

fn state() -> impl Strategy<Value = Typed> {
    let planets: Vec<String> = LIBRARY
        .planets
        .iter()
        .map(|(name, _)| name.clone())
        .collect();
    let numbers = (
        0.05..1.9_f64,
        prop_oneof![4 => -90.0..-1.0_f64, 1 => -1.0..20.0],
        0.3..1.5_f64,
        -90.0..=90.0_f64,
        -360.0..=360.0_f64,
        0.0..360.0_f64,
    );
    (select(planets), numbers).prop_map(
        |(planet, (speed, angle, height, latitude, longitude, azimuth))| {
            let interface_m = named(&LIBRARY.planets, &planet)
                .unwrap()
                .planet
                .entry_interface_m;
            let typed = |x: f64| format!("{x:?}");
            vec![
                ("entry.speed_m_s", typed(speed * circular_m_s(&planet))),
                ("entry.flight_path_angle_deg", typed(angle)),
                ("entry.altitude_m", typed(height * interface_m)),
                ("entry.latitude_deg", typed(latitude)),
                ("entry.longitude_deg", typed(longitude)),
                ("entry.azimuth_deg", typed(azimuth)),
                ("entry.planet", planet),
            ]
        },
    )
}

/// Choices of models, end conditions and methods.
fn options() -> impl Strategy<Value = Typed> {
    let wind = (
        number("wind.eastward_m_s", -80.0..80.0),
        number("wind.northward_m_s", -40.0..40.0),
    )
        .prop_map(|(a, b)| [a, b].concat())
        .boxed();
    let table = Just(vec![(
        "wind.table",
        "[[0.0, 5.0, 0.0], [20e3, 40.0, 5.0], [60e3, 10.0, -5.0]]".to_string(),
    )])
    .boxed();
    [
        perhaps(one_of("entry.frame", &["relative", "inertial"])),
        perhaps(one_of(
            "heating.convective",
            &["sutton-graves", "brandis-johnston"],
        )),
        one_of(
            "heating.radiative",
            &["none", "none", "tauber-sutton", "brandis-johnston"],
        ),
        perhaps(one_of("heating.wall", &["cold", "radiative-equilibrium"])),
        perhaps(one_of(
            "solver.method",
            &["dormand-prince-54", "dormand-prince-853", "rk4"],
        )),
        perhaps(number("solver.tolerance", 1e-12..1e-5)),
        perhaps(number("stop.altitude_m", -2e3..40e3)),
        perhaps(number("stop.time_s", 1.0..3e3)),
        perhaps(prop_oneof![wind, table].boxed()),
    ]
    .prop_map(|parts| parts.concat())
}

fn body() -> impl Strategy<Value = Typed> {
    let fixed = (0.0..4.0_f64, -1.0..1.0_f64, 0.1..1.0_f64).prop_map(|(mass, diameter, nose)| {
        let diameter_m = 10.0_f64.powf(diameter);
        let typed = |x: f64| format!("{x:?}");
        vec![
            ("vehicle.mass_kg", typed(10.0_f64.powf(mass))),
            ("vehicle.diameter_m", typed(diameter_m)),
            ("vehicle.nose_radius_m", typed(nose * diameter_m)),
        ]
    });
    let drag = prop_oneof![
        4 => number("vehicle.drag_coefficient", 0.2..2.0),
        1 => Just(vec![("vehicle.drag_table", "[[0.0, 0.8], [1.0, 1.3], [5.0, 1.5], [20.0, 1.4]]".to_string())]),
    ];
    let lift = prop_oneof![
        number("vehicle.lift_to_drag", -1.0..1.0),
        number("vehicle.lift_coefficient", -0.5..0.5),
    ];
    let bank = prop_oneof![
        number("vehicle.bank_deg", -180.0..180.0),
        Just(vec![(
            "vehicle.bank_table_deg",
            "[[0.0, 0.0], [100.0, 60.0], [200.0, -60.0]]".to_string()
        )]),
    ];
    let lifting = (lift, bank)
        .prop_map(|(lift, bank)| [lift, bank].concat())
        .boxed();
    (fixed, drag, perhaps(lifting)).prop_map(|(a, b, c)| [a, b, c].concat())
}

fn rigid() -> impl Strategy<Value = Typed> {
    let outlines: Vec<String> = LIBRARY
        .outlines
        .iter()
        .map(|(name, _)| name.clone())
        .collect();
    let inertia = (1.0..3.5_f64, 0.2..0.35_f64, 0.6..1.8_f64);
    let attitude = (-180.0..180.0_f64, -90.0..90.0_f64, 0.15..0.35_f64);
    let rates = [-30.0..30.0_f64, -5.0..5.0, -5.0..5.0];
    (
        select(outlines),
        inertia,
        attitude,
        perhaps(
            rates
                .prop_map(|[p, q, r]| {
                    vec![(
                        "attitude.body_rates_deg_s",
                        format!("[{p:?}, {q:?}, {r:?}]"),
                    )]
                })
                .boxed(),
        ),
    )
        .prop_map(
            |(outline, (mass, gyration, roll), (alpha, beta, cg), rates)| {
                let mut case = Case::default();
                case.set("outline.preset", &outline);
                let diameter_m = msape::problem::rigid_body(&case, &LIBRARY)
                    .unwrap()
                    .unwrap()
                    .diameter_m;
                let mass_kg = 10.0_f64.powf(mass);
                let across = mass_kg * (gyration * diameter_m) * (gyration * diameter_m);
                let along = roll * across;
                let typed = |x: f64| format!("{x:?}");
                let mut keys = vec![
                    ("vehicle.dof", "6".to_string()),
                    ("vehicle.mass_kg", typed(mass_kg)),
                    (
                        "vehicle.inertia_kg_m2",
                        format!("[[{along:?}, 0, 0], [0, {across:?}, 0], [0, 0, {across:?}]]"),
                    ),
                    ("vehicle.cg_m", format!("[{:?}, 0, 0]", cg * diameter_m)),
                    ("outline.preset", outline),
                    ("attitude.alpha_deg", typed(alpha)),
                    ("attitude.beta_deg", typed(beta)),
                ];
                keys.extend(rates);
                keys
            },
        )
}

fn case_of(parts: &[&Typed]) -> Case {
    let mut case = Case::default();
    for (key, text) in parts.iter().copied().flatten() {
        case.set(key, text);
    }
    case
}

fn check(case: &Case, again: bool, tally: &Tally) -> Result<(), TestCaseError> {
    let found = if again {
        repeated(case, Job::Fly, Request::Steps)?
    } else {
        msape::fly(case, &LIBRARY, Request::Steps)
    };
    let answer = match found {
        Ok(answer) => answer,
        Err(faults) => {
            prop_assert!(!faults.is_empty());
            tally.one("refused");
            return Ok(());
        }
    };
    tally.one("answers");
    tally.add("twice the same", usize::from(again));
    tally.one(answer.outcome.name());
    finite(&answer, Job::Fly)?;
    let given = |key: &str| case.text(key).and_then(|text| text.parse::<f64>().ok());
    let planet = case.text("entry.planet").unwrap_or_default();
    // the default end is the ground, and with a final time alone the planet's lowest altitude
    let lowest_m = named(&LIBRARY.planets, &planet).map(|world| world.planet.lowest_altitude_m);
    let ground_m = match given("stop.time_s") {
        Some(_) => lowest_m.unwrap_or_default(),
        None => 0.0,
    };
    at_its_end(&answer, given("stop.altitude_m").unwrap_or(ground_m))?;
    let windy = ["wind.eastward_m_s", "wind.table"]
        .iter()
        .any(|key| case.text(key).is_some());
    if !windy && no_energy_from_air(&answer, &planet)? {
        tally.one("energies");
    }
    Ok(())
}

#[test]
fn entries_of_a_point_mass() {
    let drawn = (state(), options(), body(), any::<bool>());
    hold(
        "entries, 3 degrees of freedom",
        100,
        &drawn,
        |(state, options, body, again), tally| {
            check(&case_of(&[state, options, body]), *again, tally)
        },
    );
}

#[test]
fn entries_of_a_rigid_body() {
    let drawn = (state(), options(), rigid(), any::<bool>());
    hold(
        "entries, 6 degrees of freedom",
        6,
        &drawn,
        |(state, options, rigid, again), tally| {
            check(&case_of(&[state, options, rigid]), *again, tally)
        },
    );
}
