//! End of a flight by the closed form.
//!
//! ```text
//! h ≤ h_end   or   t ≥ t_end
//! ```
//!
//! with h the altitude in m and t the time after the start in s.
//!
//! # Valid
//! Range of [`super`].
//!
//! # References
//! - Own convention.

use crate::flight::mission::Mission;
use crate::flight::{Flight, LANDED_WITHIN_M};
use crate::outcome::Outcome;

/// Outcome of a flight by the closed form, and its reason.
pub fn ending(mission: &Mission, flight: &Flight) -> (Outcome, Option<String>) {
    let start_m = mission.planet.local(mission.start.position_m).altitude_m;
    let ground_m = mission.stop.altitude_m.unwrap_or(0.0);
    if start_m < ground_m - LANDED_WITHIN_M {
        let below_m = ground_m - start_m;
        let reason = format!(
            "the flight is {below_m:.1} m below the final altitude of {ground_m} m and falls: it does not come up to it"
        );
        return (Outcome::Stopped, Some(reason));
    }
    let on_time =
        (mission.stop.time_s).is_some_and(|_| flight.final_altitude_m > ground_m + LANDED_WITHIN_M);
    match on_time || ground_m > 0.0 {
        true => (Outcome::Stopped, None),
        false => (Outcome::Landed, None),
    }
}
