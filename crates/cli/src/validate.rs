//! `validate`: the documented cases that ship with the program, beside their references.

use crate::args::Validate;
use crate::failure::Failure;
use crate::show::columns::{Align, Columns};
use crate::terminal::{Paint, progress};
use crate::{Done, output};
use msape::Library;
use msape::units::number::rounded;
use msape::validation::{self, File, Row, Verdict};
use serde_json::json;
use std::process::ExitCode;

/// Compares and prints; ends with 1 when a judged value is beyond its tolerance.
pub fn validate(arguments: &Validate) -> Done {
    let library = Library::builtin()?;
    let files = chosen(validation::files()?, &arguments.names)?;
    let mut compared = Vec::with_capacity(files.len());
    for (i, (name, file)) in files.iter().enumerate() {
        progress(&format!("{} of {}: {name}", i + 1, files.len()));
        compared.push((name, file, validation::run_file(&library, name, file)?));
    }
    progress("");
    let rows = || compared.iter().flat_map(|(_, _, rows)| rows);
    let judged = rows().filter(|row| row.verdict != Verdict::Shown).count();
    let misses = rows().filter(|row| row.verdict.is_miss()).count();
    let text = if arguments.json {
        let object =
            json!({ "judged": judged, "misses": misses, "rows": rows().collect::<Vec<_>>() });
        format!("{object:#}\n")
    } else {
        let paint = if arguments.output.is_some() {
            Paint::Plain
        } else {
            Paint::of_standard_output()
        };
        let mut text: String = compared
            .iter()
            .map(|(name, file, rows)| section(name, file, rows, paint))
            .collect();
        text.push_str(&format!(
            "{} of {judged} judged values within their tolerances\n",
            judged - misses
        ));
        text
    };
    output::write(&text, arguments.output.as_deref())?;
    Ok(ExitCode::from(u8::from(misses > 0)))
}

fn chosen(files: Vec<(String, File)>, names: &[String]) -> Result<Vec<(String, File)>, Failure> {
    let known: Vec<&str> = files.iter().map(|(name, _)| name.as_str()).collect();
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
    Ok(files
        .into_iter()
        .filter(|(name, _)| names.is_empty() || names.contains(name))
        .collect())
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

/// The cells of a row; reason, and a source that is not that of the file, go to a note that rows share.
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
