//! Import of coefficient tables, and the list of imported ones.

use super::AeroView;
use crate::components::file_import::{FileImport, Verdict, Wording, notes, stem};
use crate::state::State;
use leptos::prelude::*;
use msape_kit::files;
use msape_worker::questions::{FileKind, Read, ReadRows};
use wasm_bindgen_futures::spawn_local;

const WORDING: Wording = Wording {
    file: "Import a table (CSV)",
    accept: ".csv,.txt,.tsv,.dat,text/csv,text/plain",
    id: "paste-table",
    paste: "Or paste a table (CSV)",
    placeholder: "mach, alpha_deg, ca, cn, cm",
    button: "Import pasted table",
    pasted: "Pasted table.csv",
};

/// Choose, drop or paste a table; the list of imported tables.
#[component]
pub fn TableImport() -> impl IntoView {
    let state = State::expect();
    let view = AeroView::expect();
    let import = move |name: String, bytes: Vec<u8>, verdict: Verdict| {
        let text = files::text_of(&bytes);
        spawn_local(async move {
            match state.ask_once(Read(FileKind::Coefficients, bytes)).await {
                Ok(ReadRows { rows, remarks, .. }) => {
                    let (stem, count) = (stem(&name), rows.len());
                    state.edit(&format!("Import {stem}"), None, |document| {
                        document.with_tables(|tables| {
                            tables.insert(stem.clone(), rows);
                        })
                    });
                    verdict.taken(format!(
                        "{stem} is imported with {count} rows and in use; undo takes it out again.{}",
                        notes(&remarks)
                    ));
                    view.table.set(Some(stem));
                }
                Err(faults) => verdict.refused(name, &text, faults),
            }
        });
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
        <FileImport wording=WORDING import>
            <p class="quiet">"Or drop a file here. One row for each Mach number, Knudsen number or altitude (if wanted) and angle of attack, in any order, without holes: "<code>"mach, alpha_deg, ca, cn, cm"</code>" or "<code>"cd, cl"</code>" in the place of ca, cn; "<code>"knudsen"</code>" or "<code>"altitude_m"</code>", "<code>"cmq"</code>". Moments about the virtual apex."</p>
        </FileImport>
    }
}
