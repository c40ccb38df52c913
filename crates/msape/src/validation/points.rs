//! Measured points: the mean ratio of the computed to the measured value at the start of a flight set up for each point.
//!
//! ```text
//! ratio = (1/n) Σ ours_i / measured_i
//! ```

use super::{Comparison, Points, Row, Runner, label_of, value};
use crate::library::{DataError, data_file};
use std::collections::BTreeMap;

pub(super) fn row(runner: &Runner, points: &Points) -> Result<Row, DataError> {
    let path = format!("validation/{}", points.table);
    let table = data_file(&path)
        .ok_or_else(|| "is not there".to_string())
        .and_then(|text| rows(text, points))
        .map_err(|message| DataError {
            file: path.clone(),
            message,
        })?;
    let mut sum = 0.0;
    let mut fault = None;
    for point in &table {
        match runner.solve(&point.set) {
            // The start of the flight is the point; the quantity there requires no flight.
            Ok(answer) => match value(&answer, &points.expected.quantity, Some(0.0)) {
                Some(ours) => sum += ours / point.measured,
                None => fault = fault.or_else(|| Some("the quantity did not occur".to_string())),
            },
            Err(message) => fault = fault.or(Some(message)),
        }
    }
    let count = table.len();
    let ours = (fault.is_none() && count > 0).then(|| sum / count as f64);
    let label = format!(
        "{}, mean ratio to {count} measured points",
        label_of(&points.expected.quantity)
    );
    let comparison = Comparison {
        expected: &points.expected,
        label,
        ours,
        fault,
    };
    Ok(comparison.row(runner))
}

/// A line of the table.
struct Point {
    /// Keys of the case to set.
    set: BTreeMap<String, String>,
    /// The measured value.
    measured: f64,
}

/// The lines of the table that have all their values.
fn rows(text: &str, points: &Points) -> Result<Vec<Point>, String> {
    let mut reader = csv::ReaderBuilder::new()
        .comment(Some(b'#'))
        .from_reader(text.as_bytes());
    let headers = reader.headers().map_err(|e| e.to_string())?.clone();
    let column = |name: &str| {
        headers
            .iter()
            .position(|header| header == name)
            .ok_or_else(|| format!("no column is called \"{name}\""))
    };
    let measured_in = column(&points.measured)?;
    let keys: Vec<(&String, usize)> = points
        .set
        .iter()
        .map(|(key, name)| Ok((key, column(name)?)))
        .collect::<Result<_, String>>()?;
    let mut rows = Vec::new();
    for record in reader.records() {
        let record = record.map_err(|e| e.to_string())?;
        let cell = |i: usize| record.get(i).unwrap_or_default();
        if cell(measured_in).is_empty() || keys.iter().any(|(_, i)| cell(*i).is_empty()) {
            continue;
        }
        let measured: f64 = cell(measured_in)
            .parse()
            .map_err(|_| format!("\"{}\" is not a number", cell(measured_in)))?;
        let set = keys
            .iter()
            .map(|(key, i)| ((*key).clone(), cell(*i).to_string()))
            .collect();
        rows.push(Point { set, measured });
    }
    Ok(rows)
}
