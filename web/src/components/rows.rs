//! A table of numbers as text, one row a line, or from a file.

use crate::components::field::{Field, control_id, described_by};
use crate::components::file_import::notes;
use crate::components::file_input::FileInput;
use crate::files;
use crate::state::State;
use cad::table::{Ground, Table, read};
use leptos::prelude::*;
use msape::Case;
use msape::case::Value;
use msape::quantity::input::{Column, Input};
use wasm_bindgen_futures::spawn_local;

/// Tables, and the key of a file that the same reader reads on the command line.
const FILES: [(&str, &str); 11] = [
    ("atmosphere.table", "atmosphere.file"),
    ("wind.table", "wind.file"),
    ("heating.table", "heating.file"),
    ("heating.radius_table", "heating.file"),
    ("heating.arc_table", "heating.file"),
    ("vehicle.drag_table", "vehicle.drag_file"),
    ("vehicle.lift_table", "vehicle.lift_file"),
    ("vehicle.bank_table_deg", "vehicle.bank_file"),
    ("vehicle.bank_speed_table_deg", "vehicle.bank_file"),
    ("vehicle.aerodynamics.table", "vehicle.aerodynamics.file"),
    (
        "vehicle.aerodynamics.damping_table",
        "vehicle.aerodynamics.damping_file",
    ),
];
/// Faults of a file that are shown.
const MOST_FAULTS: usize = 10;

/// A field for rows of numbers.
#[component]
pub fn RowsField(input: &'static Input, columns: &'static [Column]) -> impl IntoView {
    let state = State::expect();
    let value = Memo::new(move |_| state.case.with(|case| case.values.get(input.key).cloned()));
    let draft = RwSignal::new(None::<(u32, String)>);
    let typing = move || {
        draft
            .get()
            .filter(|(turn, _)| *turn == state.turns.get())
            .map(|(_, text)| text)
    };
    let text = move || typing().unwrap_or_else(|| written(value.get().as_ref()));
    let check = state.check(input.key);
    let names: Vec<&str> = columns.iter().map(|column| column.name).collect();
    let names = names.join(", ");
    let tag = format!("rows {}", input.key);
    let count = move || match value.get() {
        Some(Value::Rows(rows)) => Some(format!("{} rows", rows.len())),
        _ => None,
    };
    view! {
        <Field input caption=Signal::derive(move || input.label.to_string()) echo=Signal::derive(count)>
            <textarea
                rows="4"
                spellcheck="false"
                id=control_id(input.key)
                aria-describedby=described_by(input.key)
                aria-invalid=move || check.with(|check| (!check.faults.is_empty()).to_string())
                placeholder=names.clone()
                prop:value=text
                on:input:target=move |event| {
                    let text = event.target().value();
                    let value = parsed(&text, file_key(input.key), || ground(state));
                    draft.set(Some((state.turns.get_untracked(), text)));
                    state.edit(input.label, Some(&tag), |document| {
                        document.with_case(|case| {
                            match value {
                                Some(value) => case.values.insert(input.key.to_string(), value),
                                None => case.values.remove(input.key),
                            };
                        })
                    });
                }
                on:blur=move |_| {
                    draft.set(None);
                    state.close_step();
                }
            ></textarea>
            <p class="field-hint">"One row a line: " {names}</p>
            {file_key(input.key).map(|key| view! { <FromFile input key /> })}
        </Field>
    }
}

fn written(value: Option<&Value>) -> String {
    match value {
        Some(Value::Rows(rows)) => rows
            .iter()
            .map(|row| {
                let cells: Vec<String> = row.iter().map(f64::to_string).collect();
                cells.join(", ")
            })
            .collect::<Vec<_>>()
            .join("\n"),
        Some(Value::Text(text) | Value::Other(text)) => text.clone(),
        _ => String::new(),
    }
}

/// Opens a file in the place of the rows.
#[component]
fn FromFile(input: &'static Input, key: &'static str) -> impl IntoView {
    let state = State::expect();
    let faults = RwSignal::new(Vec::<String>::new());
    let open = move |file: web_sys::File| {
        let name = file.name();
        spawn_local(async move {
            let read = match files::bytes(file).await {
                Ok(bytes) => table(key, &bytes, &ground(state)),
                Err(message) => Err(vec![message]),
            };
            match read {
                Ok(Table { key, rows, remarks }) => {
                    let notice = format!(
                        "{name}: {} rows; undo takes them out again.{}",
                        rows.len(),
                        notes(&remarks)
                    );
                    faults.set(Vec::new());
                    state.edit(&format!("Open {name}"), None, |document| {
                        document.with_case(|case| {
                            case.values.insert(key.to_string(), Value::Rows(rows));
                        })
                    });
                    state.notice.set(notice);
                }
                Err(found) => {
                    state
                        .notice
                        .set(format!("{name} was not read; nothing has changed."));
                    faults.set(found.into_iter().take(MOST_FAULTS).collect());
                }
            }
        });
    };
    view! {
        <FileInput label=format!("Open {} from a file", input.label) accept=".csv,.txt,.tsv,.dat,text/csv,text/plain" open=open />
        <div role="alert">
            <ul class="notes">
                {move || faults.get().into_iter().map(|fault| view! { <li class="note-outside">{fault}</li> }).collect_view()}
            </ul>
        </div>
    }
}

fn file_key(table: &str) -> Option<&'static str> {
    FILES
        .iter()
        .find(|(key, _)| *key == table)
        .map(|(_, file)| *file)
}

/// Facts of the planet of the present case.
fn ground(state: State) -> Option<Ground> {
    state.library.with_value(|library| {
        let library = library.as_ref()?;
        Some(
            state
                .case
                .with_untracked(|case: &std::sync::Arc<Case>| Ground::of(case, library)),
        )
    })
}

fn table(key: &str, bytes: &[u8], ground: &Option<Ground>) -> Result<Table, Vec<String>> {
    let Some(ground) = ground else {
        return Err(vec!["The library cannot be read.".to_string()]);
    };
    read(key, bytes, ground).map_err(|faults| faults.iter().map(ToString::to_string).collect())
}

/// Rows divided by line ends, cells by commas, semicolons, tabs or blanks; lines that open with # are left out. Text in another
/// dialect is read as a file of its kind.
fn parsed(text: &str, key: Option<&str>, ground: impl Fn() -> Option<Ground>) -> Option<Value> {
    if text.trim().is_empty() {
        return None;
    }
    let lines = text
        .lines()
        .map(str::trim)
        .filter(|line| !line.is_empty() && !line.starts_with('#'));
    // a comma among other separators may be a decimal sign
    let doubtful = |line: &str| {
        line.split(',').count() > 1
            && line
                .split(',')
                .any(|cell| cell.trim().contains([';', '\t', ' ']))
    };
    let rows: Result<Vec<Vec<f64>>, _> = lines
        .clone()
        .map(|line| {
            line.split([',', ';', '\t', ' '])
                .filter(|cell| !cell.is_empty())
                .map(str::parse)
                .collect()
        })
        .collect();
    let as_typed = || Value::Text(text.to_string());
    Some(match (rows, key) {
        (Ok(rows), _) if !lines.clone().any(doubtful) => Value::Rows(rows),
        (_, Some(key)) => table(key, text.as_bytes(), &ground())
            .map_or_else(|_| as_typed(), |table| Value::Rows(table.rows)),
        _ => as_typed(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use msape::Library;

    #[test]
    fn rows_are_read_as_written() {
        let rows = Value::Rows(vec![vec![0.0, 1.225], vec![1e3, 1.1]]);
        let earth = || {
            Library::builtin()
                .ok()
                .map(|library| Ground::earth(&library))
        };
        let read = |text: &str| parsed(text, Some("atmosphere.file"), earth);
        assert_eq!(read(&written(Some(&rows))), Some(rows.clone()));
        assert_eq!(read("0 x"), Some(Value::Text("0 x".to_string())));
        // as a spreadsheet in Germany copies it
        assert_eq!(
            read("0\t1,2250\n1000\t1,1\n"),
            Some(Value::Rows(vec![vec![0.0, 1.225], vec![1e3, 1.1]]))
        );
        assert_eq!(
            read("0 1,225\n1000 1,100\n"),
            Some(Value::Text("0 1,225\n1000 1,100\n".to_string()))
        );
        assert_eq!(read("z (km);rho (kg/m3)\n0;1,225\n1;1,1\n"), Some(rows));
    }
}
