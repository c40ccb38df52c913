//! Answer as human-readable tables.

pub mod columns;

use crate::failure::printable;
use crate::terminal::Paint;
use columns::{Align, Columns};
use msape::Outcome;
use msape::answer::turning::{self, Cell};
use msape::answer::{Answer, Output, outputs};
use msape::finding::Severity;
use msape::flight::Trajectory;
use msape::flight::columns::find;
use msape::flight::phase::Begun;
use msape::flight::six_dof::turning::Turning;
use msape::quantity::{Column, Job, input};
use msape::units::number::rounded;
use msape::units::{Unit, canonical};

/// Significant digits in tables; files have full precision.
const DIGITS: usize = 6;
/// Significant digits of the table of entries, which is wide.
const ENTRY_DIGITS: usize = 4;

/// Columns of a time history that fit on a screen.
const HISTORY: [&str; 8] = [
    "time_s",
    "altitude_m",
    "speed_m_s",
    "flight_path_angle_deg",
    "mach",
    "dynamic_pressure_pa",
    "deceleration_earth_g",
    "total_heat_flux_w_m2",
];

/// The answer as text, without color for a file.
pub fn answer(answer: &Answer, job: Job, to_file: bool) -> String {
    let paint = if to_file {
        Paint::Plain
    } else {
        Paint::of_standard_output()
    };
    let mut text = head(answer, paint);
    text.push_str(&results(answer, job, paint));
    text.push_str(&phases(answer, paint));
    text.push_str(&adjustments(answer, paint));
    text.push_str(&findings(answer, paint));
    let turning = answer.design.as_ref().and_then(|d| d.turning.as_ref());
    text.push_str(&turning.map_or_else(String::new, |turning| entries(turning, paint)));
    if let Some(history) = answer.flight.as_ref().and_then(|f| f.trajectory.as_ref()) {
        text.push_str(&time_history(history, paint));
    }
    text
}

fn head(answer: &Answer, paint: Paint) -> String {
    let outcome = answer.outcome.name();
    let outcome = match answer.outcome {
        Outcome::Converged | Outcome::Landed | Outcome::Stopped => paint.good(outcome),
        _ => paint.bad(outcome),
    };
    let name = printable(&answer.name);
    let reason = answer
        .reason
        .as_ref()
        .map_or_else(String::new, |reason| format!("\n{reason}"));
    format!("{}: {outcome}{reason}\n", paint.heading(&name))
}

fn results(answer: &Answer, job: Job, paint: Paint) -> String {
    let mut text = String::new();
    let mut module = None;
    let mut lines = Columns::new(&[Align::Left, Align::Right, Align::Left]);
    let wanted: Vec<&Output> = outputs(job)
        .filter(|output| answer.flight.is_some() || (output.get)(answer).is_some())
        .collect();
    for output in &wanted {
        let value = (output.get)(answer).map_or_else(
            || "-".to_string(),
            |x| {
                let shown = rounded(output.shown_unit().from_canonical(x), DIGITS);
                if shown.is_empty() {
                    "-".to_string()
                } else {
                    shown
                }
            },
        );
        lines.push(
            [output.label, &value, output.unit]
                .map(String::from)
                .to_vec(),
        );
    }
    for (output, line) in wanted.iter().zip(lines.lines()) {
        if module != Some(output.module) {
            module = Some(output.module);
            text.push_str(&format!("\n{}\n", paint.heading(output.module.label())));
        }
        text.push_str(&format!("  {line}\n"));
    }
    text
}

fn phases(answer: &Answer, paint: Paint) -> String {
    let begun = answer.flight.iter().flat_map(|flight| &flight.phases);
    let line = |phase: &Begun| {
        let shown = |value: f64| rounded(value, DIGITS);
        let name: String = phase.name.chars().filter(|c| !c.is_control()).collect();
        format!(
            "  {} at {} s, {} m, Mach {}, {} m/s, {} Pa; at most {} Earth g until the next\n",
            paint.doubtful(&name),
            shown(phase.time_s),
            shown(phase.altitude_m),
            shown(phase.mach),
            shown(phase.speed_m_s),
            shown(phase.dynamic_pressure_pa),
            shown(phase.peak_deceleration_earth_g),
        )
    };
    section("Phases", &begun.map(line).collect::<String>(), paint)
}

fn adjustments(answer: &Answer, paint: Paint) -> String {
    let mut text = String::new();
    for adjustment in &answer.adjustments {
        let unit = input::find(&adjustment.key).map_or("", |i| canonical(i.dimension()).symbol);
        text.push_str(&format!(
            "  {} {} -> {} {unit}: {} {}\n",
            paint.doubtful(&adjustment.key),
            rounded(adjustment.from, DIGITS),
            rounded(adjustment.to, DIGITS),
            adjustment.reason,
            paint.faint(&format!("[{}]", adjustment.source)),
        ));
    }
    section("Adjustments", &text, paint)
}

fn findings(answer: &Answer, paint: Paint) -> String {
    let mut sorted: Vec<_> = answer.findings.iter().collect();
    sorted.sort_by_key(|finding| std::cmp::Reverse(finding.severity));
    let mut text = String::new();
    for finding in sorted {
        let severity = match finding.severity {
            Severity::Exceeded => paint.bad("exceeded"),
            Severity::Extrapolated => paint.doubtful("extrapolated"),
            Severity::Note => paint.faint("note"),
        };
        let field = finding
            .field
            .as_ref()
            .map_or_else(String::new, |field| format!(" See {field}."));
        text.push_str(&format!(
            "  {severity} {}: {}{field} {}\n",
            finding.model,
            finding.message,
            paint.faint(&format!("[{}]", finding.source)),
        ));
    }
    section("Findings", &text, paint)
}

fn time_history(history: &Trajectory, paint: Paint) -> String {
    let shown: Vec<_> = HISTORY.iter().filter_map(|key| find(key)).collect();
    let mut table = Columns::new(&[Align::Right; HISTORY.len()]);
    table.push(
        shown
            .iter()
            .map(|column| column.label.to_string())
            .collect(),
    );
    table.push(shown.iter().map(|column| column.unit.to_string()).collect());
    for row in 0..history.rows() {
        let cell = |column: &&Column| {
            let value = history
                .column(column.key)
                .and_then(|values| values.get(row));
            let unit = Unit::find(column.unit);
            value.map_or_else(String::new, |x| {
                rounded(unit.map_or(*x, |unit| unit.from_canonical(*x)), DIGITS)
            })
        };
        table.push(shown.iter().map(cell).collect());
    }
    let lines: String = table.lines().map(|line| format!("  {line}\n")).collect();
    section("Time history", &lines, paint)
}

/// Table of the entries from a set of attitudes and rates.
pub fn entries(turning: &Turning, paint: Paint) -> String {
    let mut table = Columns::new(&[Align::Right; turning::COLUMNS.len()]);
    table.push(turning::COLUMNS.map(|c| c.label.to_string()).to_vec());
    for entry in &turning.entries {
        let cells = turning::COLUMNS.map(|c| match (c.cell)(entry) {
            Cell::Number(x) => x.map_or_else(|| "-".to_string(), |x| rounded(x, ENTRY_DIGITS)),
            Cell::Word(word) => word.to_string(),
        });
        table.push(cells.to_vec());
    }
    let lines: String = table.lines().map(|line| format!("  {line}\n")).collect();
    let sentence = turning::sentence(turning);
    section("Reorientation", &format!("  {sentence}\n{lines}"), paint)
}

fn section(heading: &str, lines: &str, paint: Paint) -> String {
    if lines.is_empty() {
        return String::new();
    }
    format!("\n{}\n{lines}", paint.heading(heading))
}
