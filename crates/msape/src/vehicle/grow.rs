//! The smallest diameter at which a vehicle closes, and the widest payload where none does.
//!
//! ```text
//! D, 1.03 D, 1.03² D ...   until it closes; then halving of the last step
//! ```
//!
//! with D the diameter asked for in m.
//!
//! # Valid
//! Up to the largest diameter of the rules. A vehicle that closes only within less than 3 % of diameter may be stepped over.
//!
//! # References
//! - \[samareh-2014\] section 3.1.2: the diameter is increased until the smallest vehicle is found.

use crate::vehicle::close::{Closed, close, close_from};
use crate::vehicle::impact::foam_rule::FoamRule;
use crate::vehicle::input::{PayloadSize, VehicleInput};
use crate::vehicle::layout::Misfit;
use serde::{Deserialize, Serialize};

/// A vehicle that closes at no diameter up to the largest allowed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct NotClosed {
    /// One sentence: what does not fit where, and what was tried.
    pub reason: String,
    /// Why it did not fit at the diameter asked for.
    pub at_input: Option<Misfit>,
    /// Why it did not fit at the largest diameter tried.
    pub at_largest: Option<Misfit>,
}

/// Growth of the diameter from one try to the next.
const GROWTH: f64 = 1.03;

/// The vehicle at the diameter asked for or, when it does not close there, at the smallest larger one that does.
pub fn smallest_that_closes(
    input: &VehicleInput,
    foam: &FoamRule,
) -> Result<(f64, Closed), NotClosed> {
    let at_input = match close(input, input.diameter_m, foam) {
        Ok(closed) => return Ok((input.diameter_m, closed)),
        Err(misfit) => misfit,
    };
    let largest = input.rules.diameter_max_m;
    let mut low = input.diameter_m;
    let mut at_largest = at_input;
    while low < largest {
        let mut high = (low * GROWTH).min(largest);
        match close(input, high, foam) {
            Ok(mut best) => {
                while high - low > input.rules.diameter_resolution_m {
                    let middle = 0.5 * (low + high);
                    match close_from(input, middle, foam, best.start()) {
                        Ok(closed) => (high, best) = (middle, closed),
                        Err(_) => low = middle,
                    }
                }
                // from the beginning, so that the vehicle does not depend on the search
                let settled = close(input, high, foam).unwrap_or(best);
                return Ok((high, settled));
            }
            Err(misfit) => (low, at_largest) = (high, misfit),
        }
    }
    let mut reason = format!(
        "No vehicle of {:.3} m to {:.3} m closes: at {:.3} m {}; at {:.3} m {}.",
        input.diameter_m,
        largest.max(input.diameter_m),
        input.diameter_m,
        at_input.reason(),
        largest.max(input.diameter_m),
        at_largest.reason()
    );
    if let Some(diameter_m) = largest_payload_m(input, foam, largest.max(input.diameter_m)) {
        reason.push_str(&format!(
            " The widest payload of this mass that fits into {:.3} m is {diameter_m:.3} m across, this one is {:.3} m.",
            largest.max(input.diameter_m),
            input.payload_diameter_m()
        ));
    }
    Err(NotClosed {
        reason,
        at_input: Some(at_input),
        at_largest: Some(at_largest),
    })
}

/// Halvings in the search for the widest payload: to a few micrometres.
const PAYLOAD_HALVINGS: usize = 18;

/// Diameter of the widest payload of the same mass that fits at a diameter of the vehicle, m; `None` when none does.
fn largest_payload_m(input: &VehicleInput, foam: &FoamRule, diameter_m: f64) -> Option<f64> {
    let closes = |payload_m: f64| {
        let mut input = input.clone();
        input.payload_size = PayloadSize::DiameterM(payload_m);
        close(&input, diameter_m, foam).is_ok()
    };
    let (mut low, mut high) = (0.0, input.payload_diameter_m());
    for _ in 0..PAYLOAD_HALVINGS {
        let middle = 0.5 * (low + high);
        if closes(middle) {
            low = middle
        } else {
            high = middle
        }
    }
    // rounded down to the millimetre, so that what is said does fit
    let said = (low * 1000.0).floor() / 1000.0;
    (said > 0.0 && closes(said)).then_some(said)
}
