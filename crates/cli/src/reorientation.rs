//! Command `reorientation`: entries of one vehicle from a set of attitudes and rates.

use crate::args::Reorientation;
use crate::failure::printable;
use crate::read::Data;
use crate::terminal::{self, Paint};
use crate::{Done, output, read, show};
use msape::answer::turning;
use msape::flight::six_dof::turning::{ENTRIES, Turning, turning as fly};
use msape::problem::{FlightProblem, add_turning, leaves_vehicle_to_design};
use msape::progress::Progress;
use msape::quantity::input;
use msape::{Case, InputError, Library, Request, table};
use serde_json::json;
use std::ops::ControlFlow;
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
    let flown = flown(&loaded.case, &data.library);
    watched();
    let flown = loaded.unless_at_fault(flown)?;
    loaded.tell();
    let text = text(arguments, &loaded.case, &flown);
    output::write(text, arguments.output.as_deref())?;
    Ok(ExitCode::SUCCESS)
}

fn flown(case: &Case, library: &Library) -> Result<Flown, Vec<InputError>> {
    if leaves_vehicle_to_design(case) {
        let mut answer = msape::design(case, library, Request::Nothing)?;
        add_turning(case, library, &mut answer, &mut watcher())?;
        return Ok(Flown {
            outcome: Some(answer.outcome.name()),
            reason: answer.reason,
            turning: answer.design.and_then(|design| design.turning),
        });
    }
    let FlightProblem { mission, body, .. } = FlightProblem::check(case, library)?;
    match fly(&mission, &body, &mut watcher()) {
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

/// Progress display on a terminal.
pub fn watcher() -> impl Progress {
    let mut said = 0;
    move |done: f64| {
        let entry = (done * ENTRIES as f64) as usize + 1;
        if entry > said && entry <= ENTRIES {
            said = entry;
            terminal::progress(&format!("entry {entry} of {ENTRIES}"));
        }
        ControlFlow::Continue(())
    }
}

/// Clears the progress display.
pub fn watched() {
    terminal::progress("");
}

fn text(arguments: &Reorientation, case: &Case, flown: &Flown) -> String {
    let none = Turning::default();
    let entries = flown.turning.as_ref().unwrap_or(&none);
    if arguments.json {
        let object = json!({
            "name": case.name,
            "outcome": flown.outcome,
            "reason": flown.reason,
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
    let table = match &flown.turning {
        Some(turning) => show::entries(turning, paint),
        None => String::new(),
    };
    format!(
        "{}{outcome}{reason}\n{table}",
        paint.heading(&printable(&case.name))
    )
}
