//! A checked case: the same as the case, impossible to misuse.
//!
//! Checking reports every fault at once; after it, physics cannot fail.

mod aerodynamics;
mod attitude;
mod attitude_of_design;
mod center;
mod design;
mod flight;
mod freedom;
mod heating;
mod materials;
mod outline;
mod planet;

use crate::answer::Answer;
use crate::case::{Case, InputError, Reader};
use crate::design::coupling;
use crate::design::inputs::DesignInput;
use crate::design::structural::Structural;
use crate::finding::Finding;
use crate::flight::Request;
use crate::flight::freedom::Freedom;
use crate::flight::mission::{Body, Mission};
use crate::library::Library;
use crate::vehicle::body::RigidBody;

pub use aerodynamics::aero;
pub use attitude_of_design::attitude_of_design;
pub use outline::rigid_body;

/// A flight that was checked.
#[derive(Clone, Debug)]
pub struct FlightProblem {
    /// Everything but the vehicle.
    pub mission: Mission,
    /// The vehicle.
    pub body: Body,
    /// Its outline, where the case has one.
    pub outline: Option<RigidBody>,
    /// What the check remarked.
    pub findings: Vec<Finding>,
}

/// A design that was checked.
#[derive(Clone, Debug)]
pub struct DesignProblem {
    /// Everything that determines the design.
    pub input: DesignInput,
    /// What the check remarked.
    pub findings: Vec<Finding>,
}

impl FlightProblem {
    /// Checks a case for `fly`.
    ///
    /// # Errors
    /// Every fault of the case at once.
    pub fn check(case: &Case, library: &Library) -> Result<FlightProblem, Vec<InputError>> {
        let mut reader = Reader::new(case);
        let mission = flight::mission(&mut reader, library, flight::Angle::Any);
        let outline = outline::outline(&mut reader, library);
        let body = flight::body(&mut reader, library, mission.as_ref(), &outline);
        match mission.zip(body) {
            Some((mut mission, body)) if reader.faults.is_empty() => {
                if let Freedom::Rigid(rigid) = &body.freedom {
                    freedom::solver(&reader, rigid, &mut mission.solver);
                }
                Ok(FlightProblem {
                    mission,
                    body,
                    outline: outline.body(),
                    findings: reader.findings,
                })
            }
            _ => Err(reader.faults),
        }
    }

    /// Flies it.
    pub fn solve(&self, name: &str, request: Request) -> Answer {
        let FlightProblem {
            mission,
            body,
            findings,
            ..
        } = self;
        let (flight, outcome, reason) = crate::flight::fly(mission, body, request);
        let mut findings = findings.clone();
        findings.extend(crate::flight::findings(mission, body, &flight));
        Answer {
            name: name.to_string(),
            outcome,
            reason,
            flight: Some(flight),
            design: None,
            adjustments: Vec::new(),
            findings,
            passes: Vec::new(),
        }
    }
}

impl DesignProblem {
    /// Checks a case for `design`.
    ///
    /// # Errors
    /// Every fault of the case at once.
    pub fn check(case: &Case, library: &Library) -> Result<DesignProblem, Vec<InputError>> {
        let mut reader = Reader::new(case);
        match design::design(&mut reader, library) {
            Some(input) if reader.faults.is_empty() => Ok(DesignProblem {
                input,
                findings: reader.findings,
            }),
            _ => Err(reader.faults),
        }
    }

    /// Solves it.
    pub fn solve(&self, name: &str, request: Request) -> Answer {
        let mut answer = coupling::solve(&self.input, name, request);
        if let (Some(design), Some(flight)) = (&mut answer.design, &answer.flight) {
            let structural = Structural::new(&self.input, design, flight);
            let findings = structural.findings(&design.vehicle.structure, flight);
            answer.findings.extend(findings);
            design.structural = Some(structural);
        }
        answer.findings.extend(self.findings.iter().cloned());
        answer
    }
}

/// Checks the step of a time history.
pub(crate) fn check_request(request: Request) -> Result<(), Vec<InputError>> {
    match request {
        Request::Uniform(step_s) if !(step_s > 0.0 && step_s.is_finite()) => {
            Err(vec![InputError {
                key: "trajectory step".to_string(),
                message: format!("got {step_s} s, must be above 0 s"),
            }])
        }
        _ => Ok(()),
    }
}
