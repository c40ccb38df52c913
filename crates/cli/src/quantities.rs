//! Commands `quantities` and `schema`: content of cases and answers.

use crate::args::{List, Plain, Quantities};
use crate::show::columns::{Align, Columns};
use crate::{Done, output};
use msape::Library;
use msape::answer::outputs;
use msape::case::schema as json_schema;
use msape::flight::columns;
use msape::quantity::input::{Input, Kind, Preset};
use msape::quantity::{Job, inputs};
use msape::units::canonical;
use msape::units::number::shortest;
use std::process::ExitCode;

/// Prints the JSON Schema of case files.
pub fn schema(arguments: &Plain, library: &Library) -> Done {
    let text = format!("{:#}\n", json_schema::schema(library));
    output::write(&text, arguments.output.as_deref())?;
    Ok(ExitCode::SUCCESS)
}

/// Prints a list of quantities.
pub fn quantities(arguments: &Quantities, library: &Library) -> Done {
    let table = match arguments.list {
        List::Inputs => list_of_inputs(library),
        List::Outputs => list_of_outputs(),
        List::Trajectory => list_of_columns(),
    };
    let text: String = table.lines().map(|line| format!("{line}\n")).collect();
    output::write(&text, arguments.output.as_deref())?;
    Ok(ExitCode::SUCCESS)
}

fn row<const N: usize>(cells: [&str; N]) -> Vec<String> {
    cells.map(String::from).to_vec()
}

fn list_of_inputs(library: &Library) -> Columns {
    let mut table = Columns::new(&[Align::Left; 5]);
    table.push(row(["Key", "Unit", "Default", "Allowed", "Meaning"]));
    for input in inputs() {
        let unit = canonical(input.dimension()).symbol;
        let default = match input.preset {
            Preset::Absent => String::new(),
            Preset::Number(number) => shortest(number),
            Preset::Name(name) => name.to_string(),
            Preset::Flag(flag) => flag.to_string(),
        };
        let meaning = format!("{}: {}", input.label, input.help);
        table.push(row([
            input.key,
            unit,
            &default,
            &allowed(input, library),
            &meaning,
        ]));
    }
    table
}

fn allowed(input: &Input, library: &Library) -> String {
    match input.kind {
        Kind::Number { allowed, .. } => {
            let above = if allowed.min_included { "" } else { "above " };
            format!(
                "{above}{} to {}",
                shortest(allowed.min),
                shortest(allowed.max)
            )
        }
        Kind::Choice(choices) => {
            let names = library.choices(choices).into_iter().map(|(name, _)| name);
            names.collect::<Vec<_>>().join(", ")
        }
        Kind::Flag => "true, false".to_string(),
        Kind::Text => "text".to_string(),
        Kind::Rows(columns) => {
            let names: Vec<&str> = columns.iter().map(|column| column.name).collect();
            format!("rows of {}", names.join(", "))
        }
    }
}

fn list_of_outputs() -> Columns {
    let mut table = Columns::new(&[Align::Left; 4]);
    table.push(row(["Key", "Module", "Column of --csv", "Meaning"]));
    for output in outputs(Job::Design) {
        let meaning = format!("{} [{}]", output.help, output.source);
        table.push(row([
            output.key,
            output.module.label(),
            &output.header(),
            &meaning,
        ]));
    }
    table
}

fn list_of_columns() -> Columns {
    let mut table = Columns::new(&[Align::Left; 4]);
    table.push(row(["Key", "Name", "Unit of --csv", "Meaning"]));
    for column in columns::columns() {
        table.push(row([column.key, column.label, column.unit, column.help]));
    }
    table
}
