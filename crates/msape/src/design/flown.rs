//! The flight of one pass of the coupling.

use super::inputs::DesignInput;
use super::{Pass, Solution};
use crate::finding::range::short;
use crate::finding::{Finding, Severity};
use crate::flight::mission::{Body, Mission, Model};
use crate::flight::{self, Flight, LANDED_WITHIN_M, Request, allen_eggers, summary, three_dof};
use crate::outcome::Outcome;
use crate::quantity::input;
use numerics::math::RADIANS_PER_DEGREE;

/// A flight of one pass.
#[derive(Debug)]
pub(super) struct Flown {
    pub(super) flight: Flight,
    pub(super) outcome: Outcome,
    pub(super) reason: Option<String>,
    pub(super) terminal_speed_m_s: f64,
    /// Whether the flight ended where the case asks for.
    pub(super) came_down: bool,
    /// Speed at impact, or the terminal speed where the flight does not come down.
    pub(super) impact_speed_m_s: f64,
}

impl Flown {
    /// The flight of a body by one model.
    pub(super) fn fly(input: &DesignInput, body: &Body, model: Model) -> Flown {
        let mission = &input.mission;
        let (flight, outcome, reason, refused) = match model {
            Model::AllenEggers => {
                let flight = allen_eggers::fly(mission, body, Request::Nothing);
                (flight, Outcome::Landed, None, false)
            }
            Model::ThreeDof | Model::SixDof => {
                let record = three_dof::integrate(mission, body);
                let flight =
                    summary::summarize(three_dof::motion(mission, body), &record, Request::Nothing);
                let refused = record.refused.is_some();
                (flight, record.outcome, record.reason, refused)
            }
        };
        let (outcome, reason) = flight.ending(outcome, reason);
        let ground_m = mission.stop.altitude_m.unwrap_or(0.0);
        let terminal_speed_m_s = allen_eggers::terminal_speed_m_s(mission, body, ground_m);
        let came_down = matches!(outcome, Outcome::Landed | Outcome::Stopped) && !refused;
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
            came_down,
            impact_speed_m_s,
        }
    }

    /// Gives up the flight because the named number is not finite.
    pub(super) fn give_up(&mut self, name: &str) {
        // a flight that was given up has the first of the reasons
        if self.outcome != Outcome::GaveUp {
            self.outcome = Outcome::GaveUp;
            self.reason = Some(format!("the {name} is not a finite number"));
        }
    }

    /// Finding on a flight that the time limit ends above its final altitude: as requested, but without touchdown.
    pub(super) fn ended_in_time(&self, mission: &Mission) -> Option<Finding> {
        let end_m = mission.stop.altitude_m.unwrap_or(0.0);
        let height_m = self.flight.final_altitude_m;
        let in_time = mission.stop.time_s.is_some() && height_m > end_m + LANDED_WITHIN_M;
        in_time.then(|| Finding {
            severity: Severity::Exceeded,
            model: "coupling".to_owned(),
            key: "final_altitude_m".to_owned(),
            value: Some(height_m),
            valid: (None, Some(end_m)),
            message: format!(
                "The flight ends in time at {} m, above {} m: impact, foam and landing are made for the speed there, {} m/s.",
                short(height_m),
                short(end_m),
                short(self.flight.final_speed_m_s)
            ),
            source: "convention of this program".to_owned(),
            field: Some(input::stop::TIME_S.key.to_owned()),
        })
    }

    /// End of the passes for a flight that leaves the atmosphere, ends on the way or is given up: no vehicle can be sized for it.
    pub(super) fn departed(
        self,
        input: &DesignInput,
        request: Request,
        body: &Body,
        passes: Vec<Pass>,
    ) -> Solution {
        let flight = with_history(input, request, body, self.flight);
        let mut findings = flight::findings(&input.mission, body, &flight);
        let angle_deg = flight.entry_relative.flight_path_angle_rad / RADIANS_PER_DEGREE;
        let end_m = short(flight.final_altitude_m);
        let (key, value, did) = match self.outcome {
            Outcome::Stopped => (
                input::stop::ALTITUDE_M.key,
                flight.final_altitude_m,
                format!("stops at {end_m} m, where it leaves a table,"),
            ),
            Outcome::GaveUp => (
                input::entry::FLIGHT_PATH_ANGLE_DEG.key,
                angle_deg,
                "was given up".to_owned(),
            ),
            _ => (
                input::entry::FLIGHT_PATH_ANGLE_DEG.key,
                angle_deg,
                "leaves the atmosphere again".to_owned(),
            ),
        };
        findings.push(Finding {
            severity: Severity::Exceeded,
            model: "coupling".to_owned(),
            key: key.to_owned(),
            value: Some(value),
            valid: (None, None),
            message: format!(
                "A vehicle of {:.2} kg {did} on this flight: loads, heat and touchdown of a whole entry are not known, so that nothing is sized and no mass is given.",
                body.mass_kg,
            ),
            source: "convention of this program".to_owned(),
            field: Some(key.to_owned()),
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
