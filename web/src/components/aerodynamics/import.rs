//! Tables of coefficients from files: chosen, dropped or pasted. What is faulty is told at its line, and replaces nothing.

use super::AeroView;
use crate::components::outline::import::lines_at_fault;
use crate::files;
use crate::state::State;
use leptos::ev::DragEvent;
use leptos::prelude::*;
use wasm_bindgen_futures::spawn_local;

/// What became of the last file.
#[derive(Clone, Debug, PartialEq)]
struct Refused {
    name: String,
    faults: Vec<String>,
    lines: Vec<(usize, String)>,
}

/// Choose, drop or paste a table; the list of those that were imported.
#[component]
pub fn TableImport() -> impl IntoView {
    let state = State::expect();
    let view = AeroView::expect();
    let pasted = RwSignal::new(String::new());
    let refused = RwSignal::new(None::<Refused>);
    let over = RwSignal::new(false);
    let import = move |name: String, text: String| {
        spawn_local(async move {
            // Checked in the worker: a table may have many rows.
            let read = state.read_table(text.clone()).await;
            let read = read.unwrap_or_else(|message| Err(vec![message]));
            match read {
                Ok(rows) => {
                    refused.set(None);
                    let stem = name
                        .rsplit_once('.')
                        .map_or(name.as_str(), |(stem, _)| stem);
                    let stem = stem.to_string();
                    let count = rows.len();
                    state.edit(&format!("Import {stem}"), None, |document| {
                        document.with_tables(|tables| {
                            tables.insert(stem.clone(), rows);
                        })
                    });
                    state.notice.set(format!(
                        "{stem} is imported with {count} rows and in use; undo takes it out again."
                    ));
                    view.table.set(Some(stem));
                }
                Err(faults) => {
                    state
                        .notice
                        .set(format!("{name} was not imported; nothing has changed."));
                    refused.set(Some(Refused {
                        lines: lines_at_fault(&text, &faults),
                        name,
                        faults,
                    }));
                }
            }
        });
    };
    let open = move |file: web_sys::File| {
        let name = file.name();
        spawn_local(async move {
            match files::read(file).await {
                Ok(text) => import(name, text),
                Err(message) => refused.set(Some(Refused {
                    name,
                    faults: vec![message],
                    lines: Vec::new(),
                })),
            }
        });
    };
    let on_drop = move |event: DragEvent| {
        event.prevent_default();
        // The page opens what is dropped elsewhere as a case.
        event.stop_propagation();
        over.set(false);
        let dropped = event.data_transfer().and_then(|data| data.files());
        if let Some(file) = dropped.and_then(|files| files.get(0)) {
            open(file);
        }
    };
    let names = move || {
        state.document.with(|document| {
            let tables = document.tables.iter();
            tables
                .map(|(name, rows)| (name.clone(), rows.len()))
                .collect::<Vec<_>>()
        })
    };
    view! {
        <h3>"Own tables"</h3>
        <ul class="outline-list" aria-label="Own tables">
            {move || names().into_iter().map(|(name, count)| {
                let (this, used, gone) = (name.clone(), name.clone(), name.clone());
                view! {
                    <li>
                        <button type="button" class="wide" aria-pressed=move || (view.table.get().as_ref() == Some(&this)).to_string()
                            on:click=move |_| view.table.update(|table| *table = (table.as_ref() != Some(&used)).then(|| used.clone()))>
                            {format!("{name} ({count} rows)")}
                        </button>
                        <button type="button" class="small" aria-label=format!("Remove {gone}") on:click=move |_| {
                            if view.table.get_untracked().as_ref() == Some(&gone) {
                                view.table.set(None);
                            }
                            state.edit(&format!("Remove {gone}"), None, |document| document.with_tables(|tables| {
                                tables.remove(&gone);
                            }));
                            state.notice.set(format!("{gone} is removed; undo brings it back."));
                        }>"Remove"</button>
                    </li>
                }
            }).collect_view()}
        </ul>
        <div class="open drop" class:over=over
            on:dragover=move |event: DragEvent| { event.prevent_default(); over.set(true); }
            on:dragleave=move |_| over.set(false)
            on:drop=on_drop>
            <label class="file">
                <span>"Import a table (CSV)"</span>
                <input type="file" accept=".csv,.txt,text/csv"
                    on:change:target=move |event| {
                        let element = event.target();
                        if let Some(file) = element.files().and_then(|files| files.get(0)) {
                            open(file);
                        }
                        // The same file can be chosen again.
                        element.set_value("");
                    } />
            </label>
            <p class="quiet">"Or drop a file here. One row for each Mach number, Knudsen number or altitude (if wanted) and angle of attack, ascending, without holes: "<code>"mach, alpha_deg, ca, cn, cm"</code>" or "<code>"cd, cl"</code>" in the place of ca, cn; "<code>"knudsen"</code>" or "<code>"altitude_m"</code>", "<code>"cmq"</code>". Moments about the virtual apex."</p>
            <label for="paste-table">"Or paste a table (CSV)"</label>
            <textarea id="paste-table" rows="4" spellcheck="false" placeholder="mach, alpha_deg, ca, cn, cm" prop:value=pasted
                on:input:target=move |event| pasted.set(event.target().value())></textarea>
            <button type="button" class="small" disabled=move || pasted.with(|text| text.trim().is_empty())
                on:click=move |_| import("Pasted table.csv".to_string(), pasted.get_untracked())>"Import pasted table"</button>
            <div role="alert">
                {move || refused.get().map(|Refused { name, faults, lines }| view! {
                    <h3 class="note-outside">{format!("{name} has {} fault{}", faults.len(), if faults.len() == 1 { "" } else { "s" })}</h3>
                    <ul class="notes">{faults.into_iter().map(|fault| view! { <li class="note-outside">{fault}</li> }).collect_view()}</ul>
                    {(!lines.is_empty()).then(|| view! {
                        <pre class="fault-lines">{lines.into_iter().map(|(number, line)| view! { <span><b>{number}</b> " " {line} "\n"</span> }).collect_view()}</pre>
                    })}
                    <button type="button" class="small" on:click=move |_| refused.set(None)>"Dismiss"</button>
                })}
            </div>
        </div>
    }
}
