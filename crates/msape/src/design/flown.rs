//! The flight of one pass of the coupling.

use super::inputs::DesignInput;
use super::{Pass, Solution};
use crate::finding::{Finding, Severity};
use crate::flight::mission::{Body, Model};
use crate::flight::{self, Flight, Request, allen_eggers, summary, three_dof};
use crate::outcome::Outcome;
use numerics::math::RADIANS_PER_DEGREE;

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
        let (outcome, reason) = flight.ending(outcome, reason);
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

    /// Gives up the flight for a number, by its name, that is not finite.
    pub(super) fn give_up(&mut self, name: &str) {
        // a flight that was given up has the first of the reasons
        if self.outcome != Outcome::GaveUp {
            self.outcome = Outcome::GaveUp;
            self.reason = Some(format!("the {name} is not a finite number"));
        }
    }

    /// A flight that leaves the atmosphere or is given up: nothing can be sized for it.
    pub(super) fn departed(
        self,
        input: &DesignInput,
        request: Request,
        body: &Body,
        passes: Vec<Pass>,
    ) -> Solution {
        let flight = with_history(input, request, body, self.flight);
        let mut findings = flight::findings(&input.mission, body, &flight);
        findings.push(Finding {
            severity: Severity::Exceeded,
            model: "coupling".to_owned(),
            key: "entry.flight_path_angle_deg".to_owned(),
            value: Some(flight.entry_relative.flight_path_angle_rad / RADIANS_PER_DEGREE),
            valid: (None, None),
            message: format!(
                "A vehicle of {:.2} kg {} on this flight: loads, heat and touchdown of a whole entry are not known, so that nothing is sized and no mass is given.",
                body.mass_kg,
                match self.outcome {
                    Outcome::GaveUp => "was given up",
                    _ => "leaves the atmosphere again",
                }
            ),
            source: "convention of this program".to_owned(),
            field: Some("entry.flight_path_angle_deg".to_owned()),
        });
        Solution {
            outcome: self.outcome,
            reason: self.reason,
            flight: Some(flight),
            design: None,
            adjustments: Vec::new(),
            findings,
            passes,
        }
    }
}

/// The last flight; only it keeps its history.
pub(super) fn with_history(
    input: &DesignInput,
    request: Request,
    body: &Body,
    flight: Flight,
) -> Flight {
    if request == Request::Nothing {
        return flight;
    }
    let mut mission = input.mission.clone();
    mission.solver.model = flight.model;
    flight::fly(&mission, body, request).0
}
