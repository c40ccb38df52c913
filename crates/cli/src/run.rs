//! Commands `fly` and `design`.

use crate::args::{Form, Run};
use crate::failure::Failure;
use crate::read::Data;
use crate::{Done, output, read, reorientation, show, signal};
use msape::flight::Trajectory;
use msape::problem::design_watched;
use msape::quantity::Job;
use msape::table::{self, Manner, Solved, kml};
use msape::{Answer, Case, InputError, Library, Request, answer};
use std::process::ExitCode;

/// Entries flown for a design.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Entries {
    /// The entry of the case.
    Nominal,
    /// Also entries from a set of attitudes and rates.
    AnyAttitude,
}

/// Solves a case and writes the answer.
pub fn run(arguments: &Run, data: &Data, job: Job, entries: Entries) -> Done {
    let mut loaded = read::asked(&arguments.source, arguments.output.as_deref(), data)?;
    let request = request(arguments);
    let solved = solve(&loaded.case, &data.library, request, (job, entries));
    let mut answer = loaded.unless_at_fault(solved)?;
    answer.findings.extend(loaded.findings());
    write(arguments, job, &loaded.case, &answer)?;
    Ok(signal::code(ExitCode::SUCCESS))
}

fn solve(
    case: &Case,
    library: &Library,
    request: Request,
    (job, entries): (Job, Entries),
) -> Result<Answer, Vec<InputError>> {
    match job {
        Job::Fly => msape::fly(case, library, request),
        Job::Design => signal::stoppable(|progress| {
            let mut answer = design_watched(case, library, request, progress)?;
            if entries == Entries::AnyAttitude {
                reorientation::add_entries(case, library, &mut answer, progress)?;
            }
            Ok(answer)
        }),
    }
}

fn request(arguments: &Run) -> Request {
    match arguments.trajectory_step {
        Some(step_s) => Request::Uniform(step_s),
        None if arguments.trajectory || arguments.form.kml => Request::Steps,
        None => Request::Nothing,
    }
}

fn write(arguments: &Run, job: Job, case: &Case, answer: &Answer) -> Result<(), Failure> {
    let path = arguments.output.as_deref();
    let solved = Solved { case, answer };
    match arguments.form {
        Form { json: true, .. } => output::write_text(path, |out| answer::write(answer, job, out)),
        Form { csv: true, .. } => csv(arguments, job, solved, Manner::Report),
        Form { csv_si: true, .. } => csv(arguments, job, solved, Manner::Si),
        Form { kml: true, .. } => {
            let has_track = answer
                .flight
                .as_ref()
                .is_some_and(|f| f.trajectory.is_some());
            let nothing = || {
                Failure::input(format!(
                    "--kml: there is no trajectory; the case is {}",
                    answer.outcome.name()
                ))
            };
            if !has_track {
                return Err(nothing());
            }
            output::write_text(path, |out| {
                kml::write(answer, arguments.epoch, out).unwrap_or(Ok(()))
            })
        }
        Form {
            mass_tree: true, ..
        } => match &answer.design {
            Some(design) => output::write(table::mass_tree(&design.vehicle).to_csv(), path),
            None => Err(Failure::input(format!(
                "--mass-tree: there is no designed vehicle; the case is {}",
                answer.outcome.name()
            ))),
        },
        _ => output::write(show::answer(answer, job, path.is_some()), path),
    }
}

/// Writes the time history if requested, else the results.
fn csv(arguments: &Run, job: Job, solved: Solved, manner: Manner) -> Result<(), Failure> {
    let path = arguments.output.as_deref();
    if arguments.trajectory || arguments.trajectory_step.is_some() {
        let none = Trajectory::default();
        let flight = solved.answer.flight.as_ref();
        let trajectory = flight.and_then(|f| f.trajectory.as_ref()).unwrap_or(&none);
        return output::write_text(path, |out| table::write_history(trajectory, manner, out));
    }
    output::write(table::results(&[solved], job, manner).to_csv(), path)
}
