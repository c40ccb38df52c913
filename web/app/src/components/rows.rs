//! Table of numbers as text, one row per line, or from a file.

use crate::components::field::{Field, control_id, described_by};
use crate::components::file_import::notes;
use crate::state::State;
use crate::state::asker::Asker;
use leptos::prelude::*;
use msape::case::Value;
use msape::quantity::input::{Column, Input};
use msape_kit::file_input::FileInput;
use msape_kit::files;
use msape_worker::questions::{FileKind, Read, ReadRows};
use wasm_bindgen_futures::spawn_local;

/// Largest number of faults of a file that are shown.
const MOST_FAULTS: usize = 10;

/// Field for rows of numbers.
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
    let tag = StoredValue::new(format!("rows {}", input.key));
    let asker = Asker::default();
    // faults of the text or file read last
    let faults = RwSignal::new(Vec::<String>::new());
    let put = move |value: Option<Value>| {
        state.edit(input.label, Some(&tag.get_value()), |document| {
            document.with_case(|case| {
                match value {
                    Some(value) => case.values.insert(input.key.to_string(), value),
                    None => case.values.remove(input.key),
                };
            })
        });
    };
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
                    let value = parsed(&text);
                    draft.set(Some((state.turns.get_untracked(), text)));
                    put(value.clone());
                    match (value, input.file()) {
                        (Some(Value::Text(text)), Some(_)) => read_as_file(state, input, asker, text, faults, put),
                        _ => {
                            asker.wants_nothing();
                            faults.set(Vec::new());
                        }
                    }
                }
                on:blur=move |_| {
                    draft.set(None);
                    state.close_step();
                }
            ></textarea>
            <p class="field-hint">"One row a line: " {names}</p>
            {input.file().map(|_| view! { <FromFile input faults /> })}
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

/// Replaces the rows by those of a file.
#[component]
fn FromFile(input: &'static Input, faults: RwSignal<Vec<String>>) -> impl IntoView {
    let state = State::expect();
    let open = move |file: web_sys::File| {
        let name = file.name();
        spawn_local(async move {
            let read = match files::bytes(file).await {
                Ok(bytes) => state.ask_once(Read(kind(state, input), bytes)).await,
                Err(message) => Err(vec![message]),
            };
            match read {
                Ok(ReadRows { key, rows, remarks }) => {
                    let notice = format!(
                        "{name}: {} rows; undo takes them out again.{}",
                        rows.len(),
                        notes(&remarks)
                    );
                    faults.set(Vec::new());
                    state.edit(&format!("Open {name}"), None, |document| {
                        document.with_case(|case| {
                            case.values.insert(key, Value::Rows(rows));
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

/// File kind of a table for the current case.
fn kind(state: State, input: &Input) -> FileKind {
    let case = state.case.get_untracked();
    FileKind::Table {
        table: input.key.to_string(),
        case: Box::new((*case).clone()),
    }
}

/// Reads text in another dialect as a file, and replaces the text by the rows if it has not changed meanwhile.
fn read_as_file(
    state: State,
    input: &'static Input,
    asker: Asker,
    text: String,
    faults: RwSignal<Vec<String>>,
    put: impl Fn(Option<Value>) + 'static,
) {
    spawn_local(async move {
        let kind = kind(state, input);
        let Some(read) = state
            .ask(asker, Read(kind, text.clone().into_bytes()))
            .await
        else {
            return;
        };
        let typed = Value::Text(text);
        let stands = state
            .case
            .with_untracked(|case| case.values.get(input.key) == Some(&typed));
        match read {
            Ok(ReadRows { rows, .. }) if stands => {
                faults.set(Vec::new());
                put(Some(Value::Rows(rows)));
            }
            Err(found) if stands => faults.set(found.into_iter().take(MOST_FAULTS).collect()),
            _ => {}
        }
    });
}

/// Rows separated by line ends, cells by commas, semicolons, tabs or blanks; lines that start with # are left out.
/// `None` for another dialect.
fn parsed(text: &str) -> Option<Value> {
    if text.trim().is_empty() {
        return None;
    }
    let lines = text
        .lines()
        .map(str::trim)
        .filter(|line| !line.is_empty() && !line.starts_with('#'));
    // a comma beside other separators may be a decimal sign
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
    Some(match rows {
        Ok(rows) if !lines.clone().any(doubtful) => Value::Rows(rows),
        _ => Value::Text(text.to_string()),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_read_as_written_and_what_is_doubtful_stays_text() {
        let rows = Value::Rows(vec![vec![0.0, 1.225], vec![1e3, 1.1]]);
        assert_eq!(parsed(&written(Some(&rows))), Some(rows));
        // copied from a German spreadsheet, with a heading, and text that is not a table
        for text in [
            "0\t1,2250\n1000\t1,1\n",
            "z (km);rho (kg/m3)\n0;1,225\n",
            "0 x",
        ] {
            assert_eq!(parsed(text), Some(Value::Text(text.to_string())));
        }
    }
}
