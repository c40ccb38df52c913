//! The error of a fixed step, from the same flight at twice the step.
//!
//! ```text
//! e ≈ |x_h − x_2h| / |x_h|
//! ```
//!
//! with x_h a result at the step h: sixteen times the error of x_h, of order four, less the error itself; where the steps are too
//! long for that the difference is large, too.
//!
//! # Valid
//! The classical method.
//!
//! # References
//! - \[hairer-norsett-wanner-1993\] section II.4, step doubling.

use super::freedom::Freedom;
use super::mission::{Body, Mission, Model};
use super::{Flight, Request, six_dof, summary, three_dof};
use crate::finding::range::short;
use crate::finding::{Finding, Severity};
use crate::outcome::Outcome;
use numerics::ode::Method;

/// Difference at which the step is called too long: at order four the error itself is a fifteenth, 0.07 %.
const COARSE: f64 = 0.01;

/// What is said of a flight at a fixed step.
pub fn finding(mission: &Mission, body: &Body, flight: &Flight) -> Option<Finding> {
    let Method::Rk4 { step } = mission.solver.method else {
        return None;
    };
    if flight.model == Model::AllenEggers {
        return None;
    }
    let mut doubled = mission.clone();
    doubled.solver.method = Method::Rk4 { step: 2.0 * step };
    let (other, outcome, _) = match &body.freedom {
        Freedom::Rigid(rigid) => six_dof::fly(&doubled, body, rigid, Request::Nothing),
        _ => {
            let record = three_dof::integrate(&doubled, body);
            let motion = three_dof::motion(&doubled, body);
            let flight = summary::summarize(motion, &record, Request::Nothing);
            (flight, record.outcome, record.reason)
        }
    };
    let numbers = |flight: &Flight| {
        [
            flight.peak_deceleration_earth_g.value,
            flight.total_margined_heat_load_j_m2(),
            flight.time_of_flight_s,
            flight.final_speed_m_s,
        ]
    };
    let names = ["peak deceleration", "heat load", "time of flight", "final speed"];
    let mut largest = (0.0, names[0]);
    let pairs = numbers(flight).into_iter().zip(numbers(&other));
    for ((here, there), name) in pairs.zip(names) {
        let size = here.abs().max(f64::MIN_POSITIVE);
        let difference = (here - there).abs() / size;
        if difference.is_nan() || difference > largest.0 {
            largest = (difference, name);
        }
    }
    let (difference, name) = largest;
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
    Some(Finding {
        severity: match coarse {
            true => Severity::Extrapolated,
            false => Severity::Note,
        },
        model: "rk4".to_string(),
        key: "solver.step_s".to_string(),
        value: Some(step),
        valid: (None, None),
        message: format!("At {} s, twice the step, {said}. {then}", short(2.0 * step)),
        source: "Hairer, Norsett and Wanner, section II.4".to_string(),
        field: Some("solver.step_s".to_string()),
    })
}
