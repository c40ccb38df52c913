//! Conditions that hold for every answer.

use crate::designs::LIBRARY;
use msape::answer::{self, outputs};
use msape::library::named;
use msape::planet::geodetic::Geodetic;
use msape::planet::{Gravity, Planet};
use msape::quantity::Job;
use msape::{Answer, Case, InputError, Outcome, Request};
use proptest::prelude::*;

/// Largest rise of the energy relative to the planet by rounding and integration, relative to its largest part.
const ENERGY: f64 = 1e-6;

/// The answer, which must be the same to the bit when repeated.
pub(crate) fn repeated(
    case: &Case,
    job: Job,
    request: Request,
) -> Result<Result<Answer, Vec<InputError>>, TestCaseError> {
    let solve = || match job {
        Job::Fly => msape::fly(case, &LIBRARY, request),
        Job::Design => msape::design(case, &LIBRARY, request),
    };
    let bits = |found: &Result<Answer, _>| {
        found
            .as_ref()
            .map(|a| serde_json::to_string(a).unwrap())
            .ok()
    };
    let (one, other) = (solve(), solve());
    prop_assert_eq!(bits(&one), bits(&other), "twice the same case");
    Ok(one)
}

/// An answer with a result has finite numbers; one without says why.
pub(crate) fn finite(answer: &Answer, job: Job) -> Result<(), TestCaseError> {
    let text = answer::text(answer, job);
    prop_assert!(
        serde_json::from_str::<serde_json::Value>(&text).is_ok(),
        "JSON"
    );
    if matches!(answer.outcome, Outcome::GaveUp | Outcome::NotClosed) {
        prop_assert!(answer.reason.is_some(), "no reason");
        return Ok(());
    }
    for output in outputs(job) {
        let value = (output.get)(answer);
        prop_assert!(
            value.is_none_or(f64::is_finite),
            "{}: {:?}",
            output.key,
            value
        );
    }
    let history = answer.flight.as_ref().and_then(|f| f.trajectory.as_ref());
    let Some(history) = history else {
        return Ok(());
    };
    let density = history.column("density_kg_m3").unwrap();
    for (column, values) in history.columns() {
        let named = values.iter().all(|x| history.name(column, *x).is_some());
        // in a near vacuum the mean free path exceeds the range of numbers
        let empty = |i: usize| column.key == "knudsen" && density[i] < 1e-290;
        let found = values
            .iter()
            .zip(0..)
            .all(|(x, i)| x.is_finite() || empty(i));
        prop_assert!(named || found, "{}", column.key);
    }
    let time_s = history.column("time_s").unwrap();
    prop_assert!(time_s.windows(2).all(|pair| pair[1] > pair[0]), "time");
    Ok(())
}

/// A landing is at the final altitude, and no flight ends below it.
pub(crate) fn at_its_end(answer: &Answer, stop_altitude_m: f64) -> Result<(), TestCaseError> {
    let history = answer.flight.as_ref().and_then(|f| f.trajectory.as_ref());
    let last_m = history.and_then(|h| h.column("altitude_m")?.last().copied());
    if let Some(last_m) = last_m.filter(|_| answer.outcome != Outcome::GaveUp) {
        let apart = last_m - stop_altitude_m;
        let landed = answer.outcome != Outcome::Landed || apart.abs() <= 1e-3;
        prop_assert!(
            landed && apart > -1e-3,
            "ends {} m beside its final altitude",
            apart
        );
    }
    Ok(())
}

/// Potential of gravity and rotation at a position, J/kg.
fn potential_j_kg(planet: &Planet, r: [f64; 3]) -> Option<f64> {
    let Gravity::Zonal {
        mu_m3_s2: mu,
        j2,
        j3,
        j4,
        reference_radius_m,
    } = planet.gravity
    else {
        return None;
    };
    let [x, y, z] = r;
    let distance = (x * x + y * y + z * z).sqrt();
    let (q, s) = (reference_radius_m / distance, z / distance);
    let p2 = 1.5 * s * s - 0.5;
    let p3 = s * (2.5 * s * s - 1.5);
    let p4 = (s * s * (35.0 * s * s - 30.0) + 3.0) / 8.0;
    let zonal = q * q * (j2 * p2 + q * (j3 * p3 + q * j4 * p4));
    let spin = planet.rotation_rate_rad_s;
    Some(-mu / distance * (1.0 - zonal) - 0.5 * spin * spin * (x * x + y * y))
}

/// An atmosphere that rotates with the planet can only reduce the energy relative to the planet.
pub(crate) fn no_energy_from_air(answer: &Answer, planet: &str) -> Result<bool, TestCaseError> {
    let history = answer.flight.as_ref().and_then(|f| f.trajectory.as_ref());
    let (Some(history), Some(planet)) = (
        history,
        named(&LIBRARY.planets, planet).map(|world| &world.planet),
    ) else {
        return Ok(false);
    };
    let keys = ["altitude_m", "latitude_deg", "longitude_deg", "speed_m_s"];
    let [h, lat, lon, v] = keys.map(|key| history.column(key).unwrap());
    let mut lowest = f64::INFINITY;
    let mut largest = 0.0_f64;
    for i in 0..h.len() {
        let place = planet.cartesian_m(&Geodetic {
            altitude_m: h[i],
            latitude_rad: lat[i].to_radians(),
            longitude_rad: lon[i].to_radians(),
        });
        let Some(potential) = potential_j_kg(planet, place) else {
            return Ok(false);
        };
        let motion = 0.5 * v[i] * v[i];
        largest = largest.max(motion).max(potential.abs());
        let energy = motion + potential;
        let rise = energy - lowest;
        prop_assert!(
            rise <= ENERGY * largest,
            "row {}: {} J/kg from air",
            i,
            rise
        );
        lowest = lowest.min(energy);
    }
    Ok(true)
}

/// Mass, volume and margin of a design add up.
pub(crate) fn mass_adds_up(case: &Case, answer: &Answer) -> Result<bool, TestCaseError> {
    let Some(design) = &answer.design else {
        return Ok(false);
    };
    crate::designs::adds_up(case, answer)?;
    prop_assert!(
        design
            .vehicle
            .components
            .iter()
            .all(|part| part.mass_kg.is_finite())
    );
    Ok(true)
}
