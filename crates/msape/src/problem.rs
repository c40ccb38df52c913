//! A checked case: the same as the case, impossible to misuse.
//!
//! Checking reports every fault at once; after it, physics cannot fail.

mod flight;
mod heating;
mod planet;

use crate::answer::Answer;
use crate::case::{Case, InputError, Reader};
use crate::flight::Request;
use crate::library::Library;

/// A checked case together with what the check remarked.
struct Checked<T> {
    problem: T,
    findings: Vec<crate::finding::Finding>,
}

/// Ends a check: the problem when there is one and no fault, else every fault.
fn settled<T>(reader: Reader, problem: Option<T>) -> Result<Checked<T>, Vec<InputError>> {
    match problem {
        Some(problem) if reader.faults.is_empty() => Ok(Checked {
            problem,
            findings: reader.findings,
        }),
        _ => Err(reader.faults),
    }
}

pub(crate) fn fly(case: &Case, library: &Library, request: Request) -> Result<Answer, Vec<InputError>> {
    let mut reader = Reader::new(case);
    if let Request::Uniform(step_s) = request
        && !(step_s > 0.0 && step_s.is_finite())
    {
        reader.fault("trajectory step", format!("got {step_s} s, must be above 0 s"));
    }
    let mission = flight::mission(&mut reader, library, flight::Angle::Any);
    let body = flight::body(&mut reader, library);
    let checked = settled(reader, mission.zip(body))?;
    let (mission, body) = &checked.problem;
    let (flight, outcome, reason) = crate::flight::fly(mission, body, request);
    let mut findings = checked.findings;
    findings.extend(crate::flight::findings(mission, body, &flight));
    Ok(Answer {
        name: case.name.clone(),
        outcome,
        reason,
        flight: Some(flight),
        design: None,
        adjustments: Vec::new(),
        findings,
        passes: Vec::new(),
    })
}

pub(crate) fn design(case: &Case, library: &Library, _request: Request) -> Result<Answer, Vec<InputError>> {
    let mut reader = Reader::new(case);
    let mission = flight::mission(&mut reader, library, flight::Angle::Descending);
    settled(reader, mission)?;
    Err(Vec::new())
}
