//! A checked case: the same as the case, impossible to misuse.
//!
//! Checking reports every fault at once; after it, physics cannot fail.

mod design;
mod flight;
mod heating;
mod planet;

use crate::answer::Answer;
use crate::case::{Case, InputError, Reader};
use crate::design::coupling;
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

pub(crate) fn fly(
    case: &Case,
    library: &Library,
    request: Request,
) -> Result<Answer, Vec<InputError>> {
    let mut reader = Reader::new(case);
    check_step(&mut reader, request);
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

pub(crate) fn design(
    case: &Case,
    library: &Library,
    request: Request,
) -> Result<Answer, Vec<InputError>> {
    let mut reader = Reader::new(case);
    check_step(&mut reader, request);
    let input = design::design(&mut reader, library);
    let checked = settled(reader, input)?;
    let mut answer = coupling::solve(&checked.problem, &case.name, request);
    answer.findings.extend(checked.findings);
    Ok(answer)
}

fn check_step(reader: &mut Reader, request: Request) {
    if let Request::Uniform(step_s) = request
        && !(step_s > 0.0 && step_s.is_finite())
    {
        reader.fault(
            "trajectory step",
            format!("got {step_s} s, must be above 0 s"),
        );
    }
}
