//! Opening of cases: shipped ones, files, dropped files, pasted text.

use crate::presets::starts;
use crate::state::State;
use crate::state::document::Document;
use leptos::prelude::*;
use msape::Case;
use msape::case::Reader;
use msape_kit::file_input::FileInput;
use msape_kit::files;
use std::sync::Arc;
use wasm_bindgen_futures::spawn_local;

/// Replaces the current case.
pub fn replace_case(state: State, label: &str, case: Case) {
    let case = Arc::new(case);
    state.edit(label, None, |document| Document {
        case: case.clone(),
        ..document.clone()
    });
}

/// Opens a text; faults are listed, and the replaced case can be restored by undo.
pub fn open_text(state: State, source: &str, text: &str) {
    match Case::from_text(text) {
        Ok(case) => {
            let faults = Reader::new(&case).faults;
            let name = if case.name.is_empty() {
                source.to_string()
            } else {
                case.name.clone()
            };
            replace_case(state, &format!("Open {name}"), case);
            state
                .notice
                .set(format!("{name} is open; undo brings the case before back."));
            state
                .file_faults
                .set(faults.iter().map(ToString::to_string).collect());
        }
        Err(faults) => {
            state
                .notice
                .set(format!("{source} was not opened; nothing has changed."));
            state
                .file_faults
                .set(faults.iter().map(ToString::to_string).collect());
        }
    }
}

/// Opens a chosen or dropped file.
pub fn open_file(state: State, file: web_sys::File) {
    let name = file.name();
    spawn_local(async move {
        match files::read(file).await {
            Ok(text) => open_text(state, &name, &text),
            Err(message) => state.file_faults.set(vec![message]),
        }
    });
}

/// Choice of a case to start from.
#[component]
pub fn StartFrom() -> impl IntoView {
    let state = State::expect();
    let starts = StoredValue::new(starts());
    let now = Memo::new(move |_| {
        state.case.with(|case| {
            starts.with_value(|starts| {
                starts
                    .iter()
                    .find(|start| start.case == **case)
                    .map(|start| start.id.clone())
            })
        })
    });
    view! {
        <label class="start">
            <span>"Start from"</span>
            <select on:change:target=move |event| {
                let id = event.target().value();
                let chosen = starts.with_value(|starts| starts.iter().find(|start| start.id == id).cloned());
                if let Some(start) = chosen {
                    replace_case(state, &format!("Start from {}", start.case.name), start.case);
                }
            }>
                <option value="" prop:selected=move || now.get().is_none() disabled=true>"Own case"</option>
                {starts.get_value().into_iter().map(|start| {
                    let id = start.id.clone();
                    view! { <option value=start.id prop:selected=move || now.get().as_ref() == Some(&id)>{start.case.name}</option> }
                }).collect_view()}
            </select>
        </label>
    }
}

/// Opening of a file, or pasting of a case.
#[component]
pub fn Open() -> impl IntoView {
    let state = State::expect();
    let pasted = RwSignal::new(String::new());
    view! {
        <div class="open">
            <FileInput label="Open a case (TOML or JSON)" accept=".toml,.json,application/json,application/toml,text/plain" open=move |file| open_file(state, file) />
            <p class="quiet">"Or drop a file anywhere on the page."</p>
            <label for="paste-case">"Or paste a case"</label>
            <textarea id="paste-case" rows="3" spellcheck="false" placeholder="schema = \"msape/1\"" prop:value=pasted
                on:input:target=move |event| pasted.set(event.target().value())></textarea>
            <button type="button" class="small" disabled=move || pasted.with(|text| text.trim().is_empty())
                on:click=move |_| {
                    open_text(state, "The pasted case", &pasted.get_untracked());
                    pasted.set(String::new());
                }>"Open pasted case"</button>
            <FileFaults />
        </div>
    }
}

/// Faults of the last file, and changes since the version that made the case.
#[component]
fn FileFaults() -> impl IntoView {
    let state = State::expect();
    view! {
        <div role="alert">
            {move || state.file_faults.with(|faults| (!faults.is_empty()).then(|| view! {
                <h3 class="note-outside">{format!("The file has {} fault{}", faults.len(), if faults.len() == 1 { "" } else { "s" })}</h3>
                <ul class="notes">{faults.iter().map(|fault| view! { <li>{fault.clone()}</li> }).collect_view()}</ul>
                <button type="button" class="small" on:click=move |_| state.file_faults.set(Vec::new())>"Dismiss"</button>
            }))}
            {move || state.version_remarks.with(|remarks| (!remarks.is_empty()).then(|| view! {
                <h3 class="note-outside">"Made with an earlier version"</h3>
                <ul class="notes">{remarks.iter().map(|remark| view! { <li>{remark.clone()}</li> }).collect_view()}</ul>
                <button type="button" class="small" on:click=move |_| state.version_remarks.set(Vec::new())>"Dismiss"</button>
            }))}
        </div>
    }
}
