//! `fly` and `design`.

use crate::args::{Form, Run};
use crate::failure::Failure;
use crate::{Done, output, read, reorientation, show};
use msape::problem::add_turning;
use msape::quantity::Job;
use msape::table::{self, Manner, Solved, kml};
use msape::{Answer, Case, InputError, Library, Request, answer};
use std::process::ExitCode;

/// Which entries a design flies.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Entries {
    /// Its own.
    Nominal,
    /// Also those from a set of attitudes and rates.
    AnyAttitude,
}

/// Solves a case and writes the answer.
pub fn run(arguments: &Run, job: Job, entries: Entries) -> Done {
    let (case, mut faults) = read::case(&arguments.case, &arguments.set)?;
    let library = Library::builtin()?;
    let request = request(arguments);
    let answer = match solve(&case, &library, request, (job, entries)) {
        Ok(answer) if faults.is_empty() => answer,
        Ok(_) => return Err(Failure::Input(faults)),
        Err(found) => {
            faults.extend(found.iter().map(ToString::to_string));
            return Err(Failure::Input(faults));
        }
    };
    let text = text(arguments, job, &case, &answer)?;
    output::write(&text, arguments.output.as_deref())?;
    Ok(ExitCode::SUCCESS)
}

fn solve(
    case: &Case,
    library: &Library,
    request: Request,
    (job, entries): (Job, Entries),
) -> Result<Answer, Vec<InputError>> {
    let mut answer = match job {
        Job::Fly => return msape::fly(case, library, request),
        Job::Design => msape::design(case, library, request)?,
    };
    if entries == Entries::AnyAttitude {
        add_turning(case, library, &mut answer, &mut reorientation::watcher())?;
        reorientation::watched();
    }
    Ok(answer)
}

fn request(arguments: &Run) -> Request {
    match arguments.trajectory_step {
        Some(step_s) => Request::Uniform(step_s),
        None if arguments.trajectory || arguments.form.kml => Request::Steps,
        None => Request::Nothing,
    }
}

fn text(arguments: &Run, job: Job, case: &Case, answer: &Answer) -> Result<String, Failure> {
    let solved = Solved { case, answer };
    match arguments.form {
        Form { json: true, .. } => Ok(answer::text(answer, job)),
        Form { csv: true, .. } => Ok(csv(arguments, job, solved, Manner::Report)),
        Form { csv_si: true, .. } => Ok(csv(arguments, job, solved, Manner::Si)),
        Form { kml: true, .. } => kml::kml(answer, arguments.epoch).ok_or_else(|| {
            Failure::input(format!(
                "--kml: there is no trajectory; the case is {}",
                answer.outcome.name()
            ))
        }),
        Form {
            mass_tree: true, ..
        } => match &answer.design {
            Some(design) => Ok(table::mass_tree(&design.vehicle).to_csv()),
            None => Err(Failure::input(format!(
                "--mass-tree: there is no designed vehicle; the case is {}",
                answer.outcome.name()
            ))),
        },
        _ => Ok(show::answer(answer, job, arguments.output.is_some())),
    }
}

/// The time history where one is asked for, else the results.
fn csv(arguments: &Run, job: Job, solved: Solved, manner: Manner) -> String {
    let history_wanted = arguments.trajectory || arguments.trajectory_step.is_some();
    let table = if history_wanted {
        let trajectory = solved
            .answer
            .flight
            .as_ref()
            .and_then(|f| f.trajectory.clone());
        table::history(&trajectory.unwrap_or_default(), manner)
    } else {
        table::results(&[solved], job, manner)
    };
    table.to_csv()
}
