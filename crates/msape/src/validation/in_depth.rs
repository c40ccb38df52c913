//! Heat shields in depth: single values of their histories, and the largest difference from a table.
//!
//! ```text
//! difference = the one of largest size of ours(t) − table(t), or of 100 (ours/table − 1)
//! ```

use super::{Comparison, Histories, Row, Runner, Settings, label_of_row};
use crate::library::{DataError, data_file};
use crate::problem::in_depth::{Ask, InDepth, in_depth};
use crate::progress::{Progress, Unwatched};
use crate::table::in_depth::value_at;
use crate::units::number::rounded;
use std::ops::ControlFlow;

/// The rows of a file, and whether the observer has stopped the computation after one of them.
pub(super) fn rows(
    runner: &Runner,
    progress: &mut dyn Progress,
) -> Result<(Vec<Row>, ControlFlow<()>), DataError> {
    let file = runner.file;
    let count = file.rows.len() + file.histories.len();
    let mut rows = Vec::with_capacity(count);
    let mut solved: Option<(Settings, Result<InDepth, String>)> = None;
    let singles = file.rows.iter().map(|expected| (expected, None));
    let histories = file
        .histories
        .iter()
        .map(|history| (&history.expected, Some(history)));
    for (expected, history) in singles.chain(histories) {
        let answer = match solved.take() {
            Some((set, answer)) if set == expected.set => answer,
            _ => solve(runner, &expected.set),
        };
        let (ours, label) = match (history, &answer) {
            (Some(history), Ok(answer)) => largest(history, answer)?,
            (None, Ok(answer)) => {
                let value = expected
                    .time_s
                    .and_then(|time_s| value_at(answer, &expected.quantity, time_s));
                (value, label_of_row(expected))
            }
            (_, Err(_)) => (None, label_of_row(expected)),
        };
        let fault = answer.as_ref().err().cloned();
        rows.push(
            Comparison {
                expected,
                label,
                ours,
                fault,
            }
            .row(runner),
        );
        solved = Some((expected.set.clone(), answer));
        if progress
            .advance(rows.len() as f64 / count.max(1) as f64)
            .is_break()
        {
            return Ok((rows, ControlFlow::Break(())));
        }
    }
    Ok((rows, ControlFlow::Continue(())))
}

fn solve(runner: &Runner, set: &Settings) -> Result<InDepth, String> {
    let answer = in_depth(
        &runner.case_with(set),
        runner.library,
        Ask::Response,
        &mut Unwatched,
    );
    answer.map_err(|faults| super::joined(&faults))
}

/// The largest difference of a history from its table, and a label with its place.
fn largest(history: &Histories, answer: &InDepth) -> Result<(Option<f64>, String), DataError> {
    let path = format!("validation/{}", history.table);
    let fault = |message: String| DataError {
        file: path.clone(),
        message,
    };
    let text = data_file(&path).ok_or_else(|| fault("is not there".to_string()))?;
    let mut reader = csv::ReaderBuilder::new()
        .comment(Some(b'#'))
        .from_reader(text.as_bytes());
    let headers = reader
        .headers()
        .map_err(|error| fault(error.to_string()))?
        .clone();
    let place = |name: &str| {
        let found = headers.iter().position(|header| header == name);
        found.ok_or_else(|| fault(format!("no column is called \"{name}\"")))
    };
    let time = place("time_s")?;
    let columns: Vec<(&String, usize)> = { history.columns.iter() }
        .map(|(ours, theirs)| Ok((ours, place(theirs)?)))
        .collect::<Result<_, DataError>>()?;
    let mut worst: Option<(f64, &str, f64)> = None;
    for record in reader.records() {
        let record = record.map_err(|error| fault(error.to_string()))?;
        let cell = |i: usize| {
            let text = record.get(i).unwrap_or_default();
            text.parse::<f64>()
                .map_err(|_| fault(format!("\"{text}\" is not a number")))
        };
        let time_s = cell(time)?;
        if time_s <= history.from_s || time_s > history.to_s {
            continue;
        }
        for (ours, theirs) in &columns {
            let reference = cell(*theirs)?;
            let Some(value) = value_at(answer, ours, time_s) else {
                return Ok((None, history.expected.quantity.clone()));
            };
            // 0 K where the solid is gone.
            if reference == 0.0 || value == 0.0 {
                continue;
            }
            let difference = match history.relative {
                true => value / reference - 1.0,
                false => value - reference,
            };
            if worst.is_none_or(|(worst, ..)| difference.abs() > worst.abs()) {
                worst = Some((difference, ours, time_s));
            }
        }
    }
    let span = format!(
        "{} to {} s",
        rounded(history.from_s, 4),
        rounded(history.to_s, 4)
    );
    let label = |at: &str| {
        format!(
            "{}, {span}, largest difference{at}",
            history.expected.quantity
        )
    };
    Ok(match worst {
        Some((difference, column, time_s)) => {
            let percent = if history.relative { 100.0 } else { 1.0 };
            (
                Some(percent * difference),
                label(&format!(": {column} at {} s", rounded(time_s, 4))),
            )
        }
        None => (None, label("")),
    })
}
