//! Error of a fixed step or a coarse tolerance, estimated from the same flight with another one.
//!
//! ```text
//! e ≈ |x_h − x_2h| / |x_h|        e ≈ |x_τ − x_τ/100| / |x_τ|
//! ```
//!
//! with x_h a result at the step h: sixteen times the error of x_h, of order four, less the error itself; where the steps are too
//! long for that the difference is large, too. x_τ is a result at the tolerance τ.
//!
//! # Valid
//! Flights that are integrated; adaptive methods at tolerances above 1e-4, below which results are better than
//! requested.
//!
//! # References
//! - \[hairer-norsett-wanner-1993\] section II.4, step doubling.

use super::freedom::Freedom;
use super::mission::{Body, Mission, Model};
use super::{Flight, Request, six_dof, summary, three_dof};
use crate::finding::range::short;
use crate::finding::{Finding, Severity};
use crate::outcome::Outcome;
use crate::quantity::input;
use numerics::ode::Method;

/// Tolerance above which an adaptive method is checked: assumed. It is thirty times the default, which gives peaks to
/// 1e-5.
const COARSE_TOLERANCE: f64 = 1e-4;
/// Difference at which the step is called too long: assumed, a tenth of the 10 % within which the heating relations are known
/// (\[samareh-2014\] section 3.4.3 corrects by 33 %). At order four the error itself is a fifteenth, 0.07 %.
const COARSE: f64 = 0.01;

/// Finding of a flight computed with a fixed step or a coarse tolerance.
pub fn finding(mission: &Mission, body: &Body, flight: &Flight) -> Option<Finding> {
    if flight.model == Model::AllenEggers {
        return None;
    }
    let tolerance = mission.solver.tolerance;
    match mission.solver.method {
        Method::Rk4 { step } => Some(of_step(mission, body, flight, step)),
        _ if tolerance > COARSE_TOLERANCE => Some(of_tolerance(mission, body, flight)),
        _ => None,
    }
}

fn of_step(mission: &Mission, body: &Body, flight: &Flight, step: f64) -> Finding {
    let mut doubled = mission.clone();
    doubled.solver.method = Method::Rk4 { step: 2.0 * step };
    let (other, outcome) = flown(&doubled, body);
    let (difference, name) = largest_difference(flight, &other);
    let unstable = outcome == Outcome::GaveUp;
    let coarse = unstable || difference.is_nan() || difference > COARSE;
    let said = match unstable {
        true => "the flight cannot be integrated".to_string(),
        false => format!("the {name} moves by {} %", short(100.0 * difference)),
    };
    let then = match coarse {
        true => "The step is too long: give a shorter one, or an adaptive method.",
        false => "The error of the step itself is about a fifteenth of that.",
    };
    Finding {
        severity: severity(coarse),
        model: "rk4".to_string(),
        key: input::solver::STEP_S.to_string(),
        value: Some(step),
        valid: (None, None),
        message: format!("At {} s, twice the step, {said}. {then}", short(2.0 * step)),
        source: "Hairer, Norsett and Wanner, section II.4".to_string(),
        field: Some(input::solver::STEP_S.to_string()),
    }
}

fn of_tolerance(mission: &Mission, body: &Body, flight: &Flight) -> Finding {
    let tolerance = mission.solver.tolerance;
    let mut finer = mission.clone();
    finer.solver.tolerance = tolerance / 100.0;
    let (difference, name) = largest_difference(flight, &flown(&finer, body).0);
    Finding {
        severity: severity(difference.is_nan() || difference > COARSE),
        model: "tolerance".to_string(),
        key: input::solver::TOLERANCE.to_string(),
        value: Some(tolerance),
        valid: (None, Some(COARSE_TOLERANCE)),
        message: format!(
            "The tolerance of {} is coarse: at a hundredth of it the {name} moves by {} %.",
            short(tolerance),
            short(100.0 * difference)
        ),
        source: "Hairer, Norsett and Wanner, section II.4".to_string(),
        field: Some(input::solver::TOLERANCE.to_string()),
    }
}

fn severity(coarse: bool) -> Severity {
    match coarse {
        true => Severity::Extrapolated,
        false => Severity::Note,
    }
}

fn flown(mission: &Mission, body: &Body) -> (Flight, Outcome) {
    match &body.freedom {
        Freedom::Rigid(rigid) => {
            let (flight, outcome, _) = six_dof::fly(mission, body, rigid, Request::Nothing);
            (flight, outcome)
        }
        Freedom::Ballistic | Freedom::Lifting(_) => {
            let record = three_dof::integrate(mission, body);
            let motion = three_dof::motion(mission, body);
            let flight = summary::summarize(motion, &record, Request::Nothing);
            (flight, record.outcome)
        }
    }
}

/// The largest relative difference between two flights, of a result of the first, and the name of that result.
fn largest_difference(flight: &Flight, other: &Flight) -> (f64, &'static str) {
    let numbers = |flight: &Flight| {
        [
            flight.peak_deceleration_earth_g.value,
            flight.total_margined_heat_load_j_m2(),
            flight.time_of_flight_s,
            flight.final_speed_m_s,
        ]
    };
    let names = [
        "peak deceleration",
        "heat load",
        "time of flight",
        "final speed",
    ];
    let mut largest = (0.0, names[0]);
    let pairs = numbers(flight).into_iter().zip(numbers(other));
    for ((here, there), name) in pairs.zip(names) {
        let size = here.abs().max(f64::MIN_POSITIVE);
        let difference = (here - there).abs() / size;
        if difference.is_nan() || difference > largest.0 {
            largest = (difference, name);
        }
    }
    largest
}
