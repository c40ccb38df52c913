//! The flight of one pass of the coupling.

use super::inputs::DesignInput;
use crate::flight::mission::{Body, Model};
use crate::flight::{Flight, Request, allen_eggers, summary, three_dof};
use crate::outcome::Outcome;

/// A flight of one pass.
pub(super) struct Flown {
    pub(super) flight: Flight,
    pub(super) outcome: Outcome,
    pub(super) reason: Option<String>,
    pub(super) terminal_speed_m_s: f64,
    /// Speed at impact, or the terminal speed where the flight does not come down.
    pub(super) impact_speed_m_s: f64,
}

impl Flown {
    /// The flight of a body by one model.
    pub(super) fn fly(input: &DesignInput, body: &Body, model: Model) -> Flown {
        let mission = &input.mission;
        let (flight, outcome, reason) = match model {
            Model::AllenEggers => (
                allen_eggers::fly(mission, body, Request::Nothing),
                Outcome::Landed,
                None,
            ),
            Model::ThreeDof | Model::SixDof => {
                let record = three_dof::integrate(mission, body);
                let flight =
                    summary::summarize(three_dof::motion(mission, body), &record, Request::Nothing);
                (flight, record.outcome, record.reason)
            }
        };
        let ground_m = mission.stop.altitude_m.unwrap_or(0.0);
        let terminal_speed_m_s = allen_eggers::terminal_speed_m_s(mission, body, ground_m);
        let came_down = matches!(outcome, Outcome::Landed | Outcome::Stopped);
        let impact_speed_m_s = if came_down {
            flight.final_speed_m_s
        } else {
            terminal_speed_m_s
        };
        Flown {
            flight,
            outcome,
            reason,
            terminal_speed_m_s,
            impact_speed_m_s,
        }
    }
}
