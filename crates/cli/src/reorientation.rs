//! Command `reorientation`: entries of one vehicle from a set of attitudes and rates.

use crate::args::Reorientation;
use crate::failure::printable;
use crate::read::Data;
use crate::terminal::{self, Paint};
use crate::{Done, output, read, show, signal};
use msape::answer::turning;
use msape::flight::six_dof::turning::{ENTRIES, Turning, turning as fly};
use msape::problem::{FlightProblem, add_turning, design_watched, leaves_vehicle_to_design};
use msape::progress::Progress;
use msape::quantity::input;
use msape::{Answer, Case, InputError, Library, Request, table};
use serde_json::json;
use std::process::ExitCode;

/// Result: outcome and reason of the design, if there is one, and the entries.
struct Flown {
    outcome: Option<&'static str>,
    reason: Option<String>,
    turning: Option<Turning>,
}

/// Flies the entries and writes them.
pub fn reorientation(arguments: &Reorientation, data: &Data) -> Done {
    let mut loaded = read::asked(&arguments.source, arguments.output.as_deref(), data)?;
    let flown = signal::stoppable(|progress| flown(&loaded.case, &data.library, progress));
    let flown = loaded.unless_at_fault(flown)?;
    loaded.tell();
    let text = text(arguments, &loaded.case, &flown);
    output::write(text, arguments.output.as_deref())?;
    Ok(signal::code(ExitCode::SUCCESS))
}

fn flown(
    case: &Case,
    library: &Library,
    progress: &mut dyn Progress,
) -> Result<Flown, Vec<InputError>> {
    if leaves_vehicle_to_design(case) {
        let mut answer = design_watched(case, library, Request::Nothing, progress)?;
        add_entries(case, library, &mut answer, progress)?;
        return Ok(Flown {
            outcome: Some(answer.outcome.name()),
            reason: answer.reason,
            turning: answer.design.and_then(|design| design.turning),
        });
    }
    let FlightProblem { mission, body, .. } = FlightProblem::check(case, library)?;
    let turning = fly(&mission, &body, &mut watcher(progress));
    terminal::progress("");
    match turning {
        None => Err(vec![InputError {
            key: input::vehicle::DOF.to_string(),
            message: "must be 6: a point mass has no attitude".to_string(),
        }]),
        turning => Ok(Flown {
            outcome: None,
            reason: None,
            turning,
        }),
    }
}

/// Adds entries from a set of attitudes and rates to the answer of a design.
pub fn add_entries(
    case: &Case,
    library: &Library,
    designed: &mut Answer,
    progress: &mut dyn Progress,
) -> Result<(), Vec<InputError>> {
    let added = add_turning(case, library, designed, &mut watcher(progress));
    terminal::progress("");
    added
}

/// Display of the entry under way.
fn watcher(whole: &mut dyn Progress) -> impl Progress {
    terminal::counted(whole, ENTRIES, |_| "entry".to_string())
}

fn text(arguments: &Reorientation, case: &Case, flown: &Flown) -> String {
    let none = Turning::default();
    let entries = flown.turning.as_ref().unwrap_or(&none);
    if arguments.json {
        let object = json!({
            "name": case.name,
            "outcome": flown.outcome,
            "reason": flown.reason,
            "stopped": signal::is_stopped(),
            "reorientation": flown.turning.as_ref().map(turning::json),
        });
        return format!("{object:#}\n");
    }
    if arguments.csv {
        return table::turning(entries).to_csv();
    }
    let paint = match arguments.output {
        Some(_) => Paint::Plain,
        None => Paint::of_standard_output(),
    };
    let outcome = flown.outcome.map_or_else(String::new, |o| format!(": {o}"));
    let reason = flown
        .reason
        .as_ref()
        .map_or_else(String::new, |r| format!("\n{r}"));
    let stopped = match signal::is_stopped() {
        true => format!(
            "\nstopped after {} of {ENTRIES} entries\n",
            entries.entries.len()
        ),
        false => String::new(),
    };
    let table = match &flown.turning {
        Some(turning) => show::entries(turning, paint),
        None => String::new(),
    };
    format!(
        "{}{outcome}{reason}\n{table}{stopped}",
        paint.heading(&printable(&case.name))
    )
}
