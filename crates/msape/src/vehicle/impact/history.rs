//! Time history of a landing at even steps.
//!
//! ```text
//! tᵢ = i T / n,  i = 0 … n,  n = 60
//! ```
//!
//! with T the duration in s; values from the dense output of the integration.
//!
//! # Valid
//! Peaks are taken from the integration itself, not from these samples.
//!
//! # References
//! - \[hairer-norsett-wanner-1993\] section II.6.

use crate::vehicle::impact::crush::{Motion, STATES};
use numerics::ode::Step;
use serde::{Deserialize, Serialize};

/// Intervals of a history.
const INTERVALS: u32 = 60;

/// Columns of one length.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct History {
    /// Time after first contact, s.
    pub time_s: Vec<f64>,
    /// Deceleration of the payload, Earth g.
    pub payload_deceleration_earth_g: Vec<f64>,
    /// Crush of the foam, m.
    pub crush_m: Vec<f64>,
    /// Force of the foam, N.
    pub force_n: Vec<f64>,
    /// Depth of the vehicle in the ground, m.
    pub penetration_m: Vec<f64>,
    /// Speed of the payload, m/s.
    pub payload_speed_m_s: Vec<f64>,
}

/// A step and the equations that it obeys.
pub(super) struct Recorded {
    pub motion: Motion,
    pub step: Step<STATES>,
}

impl History {
    /// Time history from the steps of a landing; empty if there are none.
    pub(super) fn of(recorded: &[Recorded]) -> History {
        let mut history = History::default();
        let Some(last) = recorded.last() else {
            return history;
        };
        for i in 0..=INTERVALS {
            let t = last.step.t1 * f64::from(i) / f64::from(INTERVALS);
            let at = recorded.partition_point(|r| r.step.t1 < t);
            let here = recorded.get(at).unwrap_or(last);
            let y = here.step.at(t);
            history.time_s.push(t);
            history
                .payload_deceleration_earth_g
                .push(here.motion.payload_load_earth_g(&y));
            history.crush_m.push(y[0] - y[2]);
            history.force_n.push(here.motion.foam_n(&y));
            history.penetration_m.push(y[2]);
            history.payload_speed_m_s.push(y[1]);
        }
        history
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_recorded_is_an_empty_history() {
        assert_eq!(History::of(&[]), History::default());
    }
}
