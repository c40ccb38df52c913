//! Import of outlines.

use super::facts::length_units;
use crate::components::file_import::{FileImport, Verdict, Wording, notes, stem};
use crate::state::State;
use leptos::prelude::*;
use msape_kit::files;
use msape_worker::questions::{FileKind, Read, ReadRows};
use wasm_bindgen_futures::spawn_local;

const WORDING: Wording = Wording {
    file: "Import an outline (CSV or DXF)",
    accept: ".csv,.txt,.dxf,text/csv,image/vnd.dxf",
    id: "paste-outline",
    paste: "Or paste points (CSV)",
    placeholder: "x (m), r (m)",
    button: "Import pasted points",
    pasted: "Pasted outline.csv",
};

/// Choose, drop or paste; `take` gets the identifier of the imported outline.
#[component]
pub fn Import(take: impl Fn(String) + Copy + Send + Sync + 'static) -> impl IntoView {
    let state = State::expect();
    let unit = RwSignal::new(String::new());
    let import = move |name: String, bytes: Vec<u8>, verdict: Verdict| {
        let symbol = unit.get_untracked();
        let kind = FileKind::Outline(name.clone(), Some(symbol).filter(|s| !s.is_empty()));
        spawn_local(async move {
            match state.ask_once(Read(kind, bytes.clone())).await {
                Ok(ReadRows { rows, remarks, .. }) => {
                    let stem = stem(&name);
                    state.edit(&format!("Import {stem}"), None, |document| {
                        document.with_outlines(|outlines| {
                            outlines.insert(stem.clone(), rows);
                        })
                    });
                    verdict.taken(format!(
                        "{stem} is imported; undo takes it out again.{}",
                        notes(&remarks)
                    ));
                    take(format!("own:{stem}"));
                }
                Err(faults) => verdict.refused(name, &files::text_of(&bytes), faults),
            }
        });
    };
    view! {
        <FileImport wording=WORDING import>
            <label class="inline">
                <span>"Its unit"</span>
                <select on:change:target=move |event| unit.set(event.target().value())>
                    <option value="">"as the file says"</option>
                    {length_units().map(|symbol| view! { <option value=symbol>{symbol}</option> })}
                </select>
            </label>
            <p class="quiet">"Or drop a file here. A CSV has points x, r from the nose on the axis to the aft end on the axis and names its unit in the header, such as "<code>"x (mm), r (mm)"</code>". Of a DXF, text or binary, what is drawn counts: lines, arcs, circles, polylines, ellipses, splines and blocks of them, one half of the section or both, the axis at y = 0. A unit chosen here stands above the one in the file."</p>
        </FileImport>
    }
}
