//! A table of numbers as text: one row a line.

use crate::components::field::{Field, control_id, described_by};
use crate::state::State;
use leptos::prelude::*;
use msape::case::Value;
use msape::quantity::input::{Column, Input};

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
                    let value = parsed(&text);
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

/// Rows divided by line ends, cells by commas, semicolons, tabs or blanks; lines that open with # are left out.
fn parsed(text: &str) -> Option<Value> {
    if text.trim().is_empty() {
        return None;
    }
    let rows: Result<Vec<Vec<f64>>, _> = text
        .lines()
        .map(str::trim)
        .filter(|line| !line.is_empty() && !line.starts_with('#'))
        .map(|line| {
            line.split([',', ';', '\t', ' '])
                .filter(|cell| !cell.is_empty())
                .map(str::parse)
                .collect()
        })
        .collect();
    Some(rows.map_or_else(|_| Value::Text(text.to_string()), Value::Rows))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_read_as_written() {
        let rows = Value::Rows(vec![vec![0.0, 1.225], vec![1e3, 1.1]]);
        assert_eq!(parsed(&written(Some(&rows))), Some(rows));
        assert_eq!(parsed("0 x"), Some(Value::Text("0 x".to_string())));
    }
}
