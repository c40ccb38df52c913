//! Command `outline`: properties of the outline of a case.

use crate::args::Outline;
use crate::failure::{Failure, printable};
use crate::read::Data;
use crate::show::columns::{Align, Columns};
use crate::{Done, output, read};
use msape::problem;
use msape::units::number::rounded;
use std::process::ExitCode;

/// Significant digits in tables; JSON has full precision.
const DIGITS: usize = 8;

/// Prints the properties of the outline of a case.
pub fn outline(arguments: &Outline, data: &Data) -> Done {
    let mut loaded = read::asked(&arguments.source, arguments.output.as_deref(), data)?;
    let found = problem::rigid_body(&loaded.case, &data.library);
    let Some(body) = loaded.unless_at_fault(found)? else {
        return Err(Failure::input(
            "outline: missing; give [outline] a preset, dimensions, points or a file".to_string(),
        ));
    };
    let of_file = loaded.findings().map(|finding| finding.message);
    let notes: Vec<String> = body.notes.iter().cloned().chain(of_file).collect();
    let object = serde_json::json!({ "name": body.name, "outline": body.facts(), "notes": notes });
    let text = if arguments.json {
        format!("{object:#}\n")
    } else {
        let mut table = Columns::new(&[Align::Left, Align::Right]);
        if let Some(facts) = object["outline"].as_object() {
            for (key, value) in facts.iter() {
                let shown = value
                    .as_f64()
                    .map_or("-".to_string(), |x| rounded(x, DIGITS));
                table.push(vec![key.clone(), shown]);
            }
        }
        let lines: String = table.lines().map(|line| format!("  {line}\n")).collect();
        // messages on the file go to standard error
        let notes: String = body
            .notes
            .iter()
            .map(|note| format!("{}\n", printable(note)))
            .collect();
        format!("{}\n{lines}{notes}", printable(&body.name))
    };
    loaded.tell();
    output::write(&text, arguments.output.as_deref())?;
    Ok(ExitCode::SUCCESS)
}
