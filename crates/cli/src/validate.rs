//! Command `validate`: the shipped comparison cases beside their references, and predictions of flown capsules.

use crate::args::Validate;
use crate::failure::Failure;
use crate::show::columns::{Align, Columns};
use crate::terminal::{Paint, counted, progress};
use crate::{Done, output, signal};
use msape::Library;
use msape::units::number::rounded;
use msape::validation::prediction::{self, Capsule, Prediction};
use msape::validation::{self, File, Row, Verdict};
use serde_json::json;
use std::process::ExitCode;

/// Compares and prints; exit code 1 if a judged value is out of tolerance. A missed prediction does not affect the
/// code.
pub fn validate(arguments: &Validate, library: &Library) -> Done {
    let (files, capsules) = chosen(
        validation::files()?,
        prediction::capsules(library)?,
        &arguments.names,
    )?;
    let name = |number: usize| {
        files
            .get(number)
            .map_or_else(String::new, |(name, _)| name.clone())
    };
    let compared = signal::stoppable(|whole| {
        let mut progress = counted(whole, files.len(), name);
        validation::run(library, &files, &mut progress)
    });
    progress("");
    let compared = compared?;
    let rows = || compared.iter().flatten();
    let judged = rows().filter(|row| row.verdict != Verdict::Shown).count();
    let misses = rows().filter(|row| row.verdict.is_miss()).count();
    let text = if arguments.json {
        let object = json!({
            "judged": judged,
            "misses": misses,
            "stopped": signal::is_stopped(),
            "rows": rows().collect::<Vec<_>>(),
            "predictions": capsules,
        });
        format!("{object:#}\n")
    } else {
        let paint = if arguments.output.is_some() {
            Paint::Plain
        } else {
            Paint::of_standard_output()
        };
        let sections = files.iter().zip(&compared);
        let mut text: String = sections
            .map(|((name, file), rows)| section(name, file, rows, paint))
            .collect();
        text.extend(capsules.iter().map(|capsule| predicted(capsule, paint)));
        text.push_str(&tally(&capsules));
        text.push_str(&format!(
            "{} of {judged} judged values within their tolerances\n",
            judged - misses
        ));
        if signal::is_stopped() {
            let all: usize = files.iter().map(|(_, file)| file.count()).sum();
            text.push_str(&format!(
                "stopped after {} of {all} values: the others were not compared\n",
                rows().count()
            ));
        }
        text
    };
    output::write(&text, arguments.output.as_deref())?;
    Ok(signal::code(ExitCode::from(u8::from(misses > 0))))
}

/// Comparisons by name, and capsules.
type Chosen = (Vec<(String, File)>, Vec<Capsule>);

/// The comparisons and capsules named; all if none is named.
fn chosen(
    mut files: Vec<(String, File)>,
    mut capsules: Vec<Capsule>,
    names: &[String],
) -> Result<Chosen, Failure> {
    let mut known: Vec<&str> = files.iter().map(|(name, _)| name.as_str()).collect();
    for capsule in &capsules {
        if !known.contains(&capsule.name.as_str()) {
            known.push(&capsule.name);
        }
    }
    let unknown: Vec<String> = names
        .iter()
        .filter(|name| !known.contains(&name.as_str()))
        .map(|name| {
            format!(
                "there is no comparison \"{name}\"; there are {}",
                known.join(", ")
            )
        })
        .collect();
    if !unknown.is_empty() {
        return Err(Failure::Input(unknown));
    }
    let wanted = |name: &String| names.is_empty() || names.contains(name);
    files.retain(|(name, _)| wanted(name));
    capsules.retain(|capsule| wanted(&capsule.name));
    Ok((files, capsules))
}

/// Predictions for a capsule as a table.
fn predicted(capsule: &Capsule, paint: Paint) -> String {
    let mut table = Columns::new(&[
        Align::Left,
        Align::Right,
        Align::Right,
        Align::Right,
        Align::Left,
        Align::Left,
    ]);
    let header = ["Quantity", "Predicted", "Band", "Flown", "Unit", "Verdict"];
    table.push(header.map(String::from).to_vec());
    for row in &capsule.rows {
        let range = |least: f64, greatest: f64| {
            if least == greatest {
                rounded(least, 4)
            } else {
                format!("{} to {}", rounded(least, 4), rounded(greatest, 4))
            }
        };
        let flown = row.flown_least.zip(row.flown_greatest);
        let verdict = match row.verdict {
            prediction::Verdict::NotKnown => row.verdict.name().to_string(),
            _ => format!("{} [{}]", row.verdict.name(), row.source),
        };
        table.push(vec![
            row.label.clone(),
            rounded(row.predicted, 4),
            range(row.least, row.greatest),
            flown.map_or_else(|| "-".to_string(), |(least, most)| range(least, most)),
            row.unit.clone(),
            verdict,
        ]);
    }
    let mut text = format!(
        "{}  {}, predicted\n",
        paint.heading(&capsule.name),
        capsule.title
    );
    for (i, line) in table.lines().enumerate() {
        let line = if i == 0 { paint.heading(&line) } else { line };
        text.push_str(&format!("  {line}\n"));
    }
    for remark in [format!("Given: {}.", capsule.given), capsule.note.clone()] {
        text.push_str(&paint.faint(&format!("  {remark}")));
        text.push('\n');
    }
    text.push('\n');
    text
}

/// Number of predictions that hit; empty if there are none.
fn tally(capsules: &[Capsule]) -> String {
    let rows = || capsules.iter().flat_map(|capsule| &capsule.rows);
    let count = |verdict| {
        rows()
            .filter(|row: &&Prediction| row.verdict == verdict)
            .count()
    };
    let (hits, misses) = (
        count(prediction::Verdict::Hit),
        count(prediction::Verdict::Miss),
    );
    if capsules.is_empty() {
        return String::new();
    }
    format!(
        "{hits} of {} predictions of flown capsules hit, which is no condition\n",
        hits + misses
    )
}

fn section(name: &str, file: &File, rows: &[Row], paint: Paint) -> String {
    let mut table = Columns::new(&[
        Align::Left,
        Align::Right,
        Align::Right,
        Align::Right,
        Align::Left,
        Align::Right,
        Align::Left,
    ]);
    let header = [
        "Quantity",
        "Reference",
        "Ours",
        "Difference",
        "Unit",
        "Tolerance",
        "Verdict",
    ];
    table.push(header.map(String::from).to_vec());
    let mut notes: Vec<String> = Vec::new();
    let source = format!("{}, {}", file.source, file.place);
    for row in rows {
        table.push(cells(row, &source, &mut notes));
    }
    let mut text = format!(
        "{}  {} {}\n",
        paint.heading(name),
        file.title,
        paint.faint(&format!("[{source}]"))
    );
    for (i, line) in table.lines().enumerate() {
        let line = match i
            .checked_sub(1)
            .and_then(|i| rows.get(i))
            .map(|row| row.verdict)
        {
            Some(Verdict::Within) => line,
            Some(Verdict::Shown) => paint.faint(&line),
            Some(Verdict::Beyond | Verdict::Absent) => paint.bad(&line),
            None => paint.heading(&line),
        };
        text.push_str(&format!("  {line}\n"));
    }
    for (i, note) in notes.iter().enumerate() {
        text.push_str(&paint.faint(&format!("  ({}) {note}", i + 1)));
        text.push('\n');
    }
    if let Some(note) = &file.note {
        text.push_str(&paint.faint(&format!("  {note}")));
        text.push('\n');
    }
    text.push('\n');
    text
}

/// Cells of a row; the reason, and a source other than the file's, go to a note that rows share.
fn cells(row: &Row, source: &str, notes: &mut Vec<String>) -> Vec<String> {
    let mut note = row.reason.clone();
    if row.source != source {
        note.push_str(&format!(" [{}]", row.source));
    }
    if let Some(fault) = &row.fault {
        note.push_str(&format!(" Refused: {fault}."));
    }
    let number = match notes.iter().position(|other| *other == note) {
        Some(i) => i + 1,
        None => {
            notes.push(note);
            notes.len()
        }
    };
    let shown =
        |value: Option<f64>, digits| value.map_or_else(|| "-".to_string(), |x| rounded(x, digits));
    let verdict = match (row.verdict, row.calibrated) {
        (verdict, true) => format!("{}, calibrated ({number})", verdict.name()),
        (verdict, false) => format!("{} ({number})", verdict.name()),
    };
    vec![
        row.label.clone(),
        rounded(row.reference, 9),
        shown(row.ours, 9),
        shown(row.difference, 3),
        row.unit.clone(),
        row.tolerance_text.clone(),
        verdict,
    ]
}
