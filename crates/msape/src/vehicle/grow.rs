//! The smallest diameter at which a vehicle closes, and the widest payload where none does.
//!
//! ```text
//! D → D − room / L   while room < 0;   then the root of room(D) in the last step
//! ```
//!
//! with D the diameter in m, from the requested one up; `room` the distance in m of the annulus inside the shallowest wing and the
//! shoulder, negative when the vehicle is too small; L a bound of its growth with D. Steps that long cannot pass a
//! diameter that closes; where the room is nearly enough, and where something else does not fit, they are small parts of D.
//!
//! # Valid
//! Up to the largest diameter of the rules. L is that of a rigid filling in a growing forebody, with a reserve for
//! the motion of center of gravity and walls; tests scan the diameters below those found.
//!
//! # References
//! - \[samareh-2014\] section 3.1.2: the diameter is increased until the smallest vehicle is found.

use crate::vehicle::close::{Closed, Search};
use crate::vehicle::impact::foam_rule::FoamRule;
use crate::vehicle::input::{PayloadSize, VehicleInput};
use crate::vehicle::layout::Misfit;
use numerics::math::sin_cos;
use numerics::root;
use serde::{Deserialize, Serialize};

/// A vehicle that closes at no diameter up to the largest allowed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct NotClosed {
    /// Message in one sentence: the parts that do not fit, the place, and the attempts made.
    pub reason: String,
    /// Why it did not fit at the requested diameter.
    pub at_input: Option<Misfit>,
    /// Why it did not fit at the largest diameter tried.
    pub at_largest: Option<Misfit>,
}

/// Bound of the growth of the room with the diameter: 1/2 at the shoulder's center, that times cot θ along the axis; and as much
/// again for the motion of the filling.
pub fn largest_growth(input: &VehicleInput) -> f64 {
    let (s, c) = sin_cos(input.cone_half_angle_rad);
    (c / s).max(1.0)
}

/// Smallest relative step of the diameter.
const LEAST_STEP: f64 = 0.002;

/// Relative step of the diameter where no measure of room gives the distance to a fit.
const BLIND_STEP: f64 = 0.01;

/// The vehicle at the requested diameter or, when it does not close there, at the smallest larger one that does.
pub fn smallest_that_closes(
    input: &VehicleInput,
    foam: &FoamRule,
) -> Result<(f64, Closed), NotClosed> {
    let mut search = Search::new(input, foam);
    let at_input = match search.close(input.diameter_m) {
        Ok(closed) => return Ok((input.diameter_m, closed)),
        Err(misfit) => misfit,
    };
    let largest = input.rules.diameter_max_m;
    // positive when it closes
    let room_m = |search: &mut Search, diameter_m: f64| match search.attempt(diameter_m) {
        Ok(tried) => match tried.misfit() {
            None => Ok(tried.room_m().max(f64::MIN_POSITIVE)),
            Some(misfit) => Err((misfit, tried.room_m())),
        },
        Err(misfit @ Misfit::PayloadWiderThanVehicle { .. }) => {
            Err((misfit, diameter_m / 2.0 - input.payload_diameter_m() / 2.0))
        }
        Err(misfit) => Err((misfit, 0.0)),
    };
    let growth = largest_growth(input);
    let mut low = input.diameter_m;
    let mut at_largest = at_input;
    let mut tried = room_m(&mut search, low);
    while let Err((misfit, room)) = tried {
        at_largest = misfit;
        if low >= largest {
            break;
        }
        let step = if room < 0.0 {
            (-room / growth).max(LEAST_STEP * low)
        } else {
            BLIND_STEP * low
        };
        let high = (low + step).min(largest);
        tried = room_m(&mut search, high);
        if tried.is_ok() {
            let signed = |diameter_m| match room_m(&mut search, diameter_m) {
                Ok(room) => room,
                Err((_, room)) => room.min(-f64::MIN_POSITIVE),
            };
            let resolution = input.rules.diameter_resolution_m;
            let found = root::bracket(signed, low, high, resolution);
            let smallest = found.map_or(high, |[one, other]| one.max(other));
            for diameter_m in [smallest, high] {
                if let Ok(closed) = search.close(diameter_m) {
                    return Ok((diameter_m, closed));
                }
            }
        }
        low = high;
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
    if let Some(diameter_m) = largest_payload_m(input, largest.max(input.diameter_m)) {
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

/// Halvings in the search for the widest payload: to a few micrometers.
const PAYLOAD_HALVINGS: usize = 18;

/// Diameter of the widest payload of the same mass that fits at a diameter of the vehicle, m; `None` when none does.
fn largest_payload_m(input: &VehicleInput, diameter_m: f64) -> Option<f64> {
    let closes = |payload_m: f64| {
        let mut input = input.clone();
        input.payload_size = PayloadSize::DiameterM(payload_m);
        // a wider payload crushes more foam at once, and requires another
        Search::new(&input, &FoamRule::new(&input))
            .attempt(diameter_m)
            .is_ok_and(|tried| tried.misfit().is_none())
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
    // rounded down to the millimeter, so that a payload of the printed size fits
    let said = (low * 1000.0).floor() / 1000.0;
    (said > 0.0 && closes(said)).then_some(said)
}
