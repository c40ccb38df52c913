//! Tables of answers and of time histories: strings in, strings out, so that page and command write the same bytes.
//!
//! - [`results`]: one row for each design, inputs then outputs.
//! - [`history`]: one row for each time of a trajectory.
//! - [`mass_tree`]: one row for each component of a vehicle.
//! - [`turning`]: one row for each entry from a set of attitudes and rates.
//! - `in_depth`: one row for each output time of a heat shield in depth; with the feature `ablation`.
//! - [`kml`]: a trajectory for viewers of the globe.

mod csv;
#[cfg(feature = "ablation")]
pub mod in_depth;
mod input;
pub mod kml;
mod mass_tree;
mod turning;

use crate::answer::Answer;
use crate::answer::{Output, outputs};
use crate::case::Case;
use crate::flight::Trajectory;
use crate::quantity::{self, Input, Job, inputs};
use crate::units::Unit;
use crate::units::number::shortest;
use std::fmt;

pub use mass_tree::mass_tree;
pub use turning::turning;

/// Names and units of the columns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Manner {
    /// The report's column names and units: `Entry Velocity (m/s)`, `Yes`, `SuttonGraves`.
    Report,
    /// Keys as in case and answer, SI units, angles in degrees: `entry.speed_m_s`, `true`, `sutton-graves`.
    Si,
}

/// A case and its answer.
#[derive(Clone, Copy, Debug)]
pub struct Solved<'a> {
    /// Case.
    pub case: &'a Case,
    /// Answer to the case.
    pub answer: &'a Answer,
}

/// Headers and rows of text, all of one length.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    /// Names of the columns.
    pub headers: Vec<String>,
    /// Cells by row; a cell without a value is empty.
    pub rows: Vec<Vec<String>>,
}

/// A column of a table of results.
#[derive(Clone, Copy)]
enum Column {
    Name,
    Input(&'static Input),
    Outcome,
    Output(&'static Output),
}

/// Table with one row for each answer: name, inputs that are given or have a default, outcome, outputs.
///
/// An input and an output with the same name in the report share one column: the value used.
pub fn results(solved: &[Solved], job: Job, manner: Manner) -> Table {
    let columns = result_columns(solved, job, manner);
    Table {
        headers: columns.iter().map(|c| c.header(manner)).collect(),
        rows: solved
            .iter()
            .map(|row| columns.iter().map(|c| c.cell(row, manner)).collect())
            .collect(),
    }
}

/// Header and value of each column of [`results`] for one answer.
pub fn pairs(solved: Solved, job: Job, manner: Manner) -> Vec<(String, String)> {
    let columns = result_columns(&[solved], job, manner);
    columns
        .iter()
        .map(|c| (c.header(manner), c.cell(&solved, manner)))
        .collect()
}

/// Rows of a trajectory, one for each time.
pub fn history(trajectory: &Trajectory, manner: Manner) -> Table {
    Table {
        headers: history_headers(trajectory, manner),
        rows: (0..trajectory.rows())
            .map(|row| history_row(trajectory, manner, row))
            .collect(),
    }
}

/// Writes the rows of [`history`] as CSV, one by one.
///
/// # Errors
/// The error of the writer.
pub fn write_history(
    trajectory: &Trajectory,
    manner: Manner,
    out: &mut dyn fmt::Write,
) -> fmt::Result {
    let mut line = String::new();
    let mut write = |cells: &[String]| {
        line.clear();
        csv::push_row(&mut line, cells.iter().map(String::as_str));
        out.write_str(&line)
    };
    write(&history_headers(trajectory, manner))?;
    (0..trajectory.rows()).try_for_each(|row| write(&history_row(trajectory, manner, row)))
}

fn history_headers(trajectory: &Trajectory, manner: Manner) -> Vec<String> {
    let header = |(column, _): (&quantity::Column, &[f64])| match manner {
        Manner::Report if column.unit.is_empty() => column.label.to_string(),
        Manner::Report => format!("{} ({})", column.label, column.unit),
        Manner::Si => column.key.to_string(),
    };
    trajectory.columns().map(header).collect()
}

fn history_row(trajectory: &Trajectory, manner: Manner, row: usize) -> Vec<String> {
    let cell = |(column, values): (&quantity::Column, &[f64])| {
        let unit = match manner {
            Manner::Report => Unit::find(column.unit),
            Manner::Si => None,
        };
        values
            .get(row)
            .map_or_else(String::new, |x| match trajectory.name(column, *x) {
                Some(name) => name.to_string(),
                None => shortest(unit.map_or(*x, |unit| unit.from_canonical(*x))),
            })
    };
    trajectory.columns().map(cell).collect()
}

fn result_columns(solved: &[Solved], job: Job, manner: Manner) -> Vec<Column> {
    let is_output = |input: &Input| {
        manner == Manner::Report && outputs(job).any(|output| output.header() == input.header())
    };
    let mut columns = vec![Column::Name];
    columns.extend(
        inputs()
            .filter(|input| input::belongs(input, job) && !is_output(input))
            .filter(|input| {
                solved
                    .iter()
                    .any(|row| input::cell(row.case, input, manner).is_some())
            })
            .map(Column::Input),
    );
    columns.push(Column::Outcome);
    columns.extend(outputs(job).map(Column::Output));
    columns
}

impl Column {
    fn header(self, manner: Manner) -> String {
        match (self, manner) {
            (Column::Name, Manner::Report) => "Run Name".to_string(),
            (Column::Name, Manner::Si) => "name".to_string(),
            (Column::Input(input), Manner::Report) => input.header(),
            (Column::Input(input), Manner::Si) => input.key.to_string(),
            (Column::Outcome, Manner::Report) => "Outcome".to_string(),
            (Column::Outcome, Manner::Si) => "outcome".to_string(),
            (Column::Output(output), Manner::Report) => output.header(),
            (Column::Output(output), Manner::Si) => output.key.to_string(),
        }
    }

    fn cell(self, solved: &Solved, manner: Manner) -> String {
        match self {
            Column::Name => solved.answer.name.clone(),
            Column::Input(input) => input::cell(solved.case, input, manner).unwrap_or_default(),
            Column::Outcome => solved.answer.outcome.name().to_string(),
            Column::Output(output) => match ((output.get)(solved.answer), manner) {
                (Some(x), Manner::Report) => shortest(output.shown_unit().from_canonical(x)),
                (Some(x), Manner::Si) => shortest(x),
                (None, _) => String::new(),
            },
        }
    }
}

#[cfg(test)]
mod tests;
