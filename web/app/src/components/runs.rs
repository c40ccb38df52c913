//! Named runs, stored in the browser.

use crate::components::headline::HEADLINE;
use crate::state::State;
use crate::state::document::{Place, Run, recorded};
use crate::state::keeping::SaveState;
use crate::storage;
use leptos::prelude::*;
use msape::answer::output;
use msape::case::Version;
use msape::case::version::BroughtUp;
use msape_kit::display::{date, number, symbol};
use wasm_bindgen_futures::spawn_local;

/// Number of headline results stored with a run.
const KEPT: usize = 4;

/// List of runs, and a form to store one more.
#[component]
pub fn Runs() -> impl IntoView {
    let state = State::expect();
    let runs = Memo::new(move |_| state.document.with(|document| document.runs.clone()));
    let name = RwSignal::new(None::<String>);
    let shown_name = move || {
        name.get()
            .unwrap_or_else(|| state.case.with(|case| case.name.clone()))
    };
    let keep = move |_| {
        keep_run(state, shown_name());
        name.set(None);
    };
    let newest_first = move || {
        let mut list: Vec<(String, Run)> = runs
            .get()
            .iter()
            .map(|(id, run)| (id.clone(), run.clone()))
            .collect();
        list.sort_by(|a, b| b.1.saved_ms.total_cmp(&a.1.saved_ms));
        list
    };
    view! {
        <section class="card" aria-labelledby="runs-title" id="runs">
            <h2 id="runs-title">"Runs"</h2>
            <form class="row" on:submit=move |event| { event.prevent_default(); keep(()); }>
                <label for="run-name">"Run Name"</label>
                <input id="run-name" type="text" autocomplete="off" prop:value=shown_name
                    on:input:target=move |event| name.set(Some(event.target().value())) />
                <button type="submit" class="primary">"Save run"</button>
            </form>
            {move || runs.with(|runs| runs.is_empty()).then(|| view! {
                <p class="quiet">"No run is saved yet. Saved runs stay in this browser and are found here again; the design you work on is kept without saving."</p>
            })}
            <ul class="runs">
                <For each=newest_first key=|(id, run)| format!("{id} {} {}", run.name, run.saved_ms) let((id, run))>
                    <RunItem id run />
                </For>
            </ul>
        </section>
    }
}

fn keep_run(state: State, name: String) {
    let name = if name.trim().is_empty() {
        "Unnamed".to_string()
    } else {
        name.trim().to_string()
    };
    let saved_ms = js_sys::Date::now();
    let headline = state.latest.with_untracked(|latest| {
        let answer = latest.as_ref().map(|solved| &solved.answer);
        HEADLINE
            .iter()
            .take(KEPT)
            .filter_map(|(key, _)| Some((key.to_string(), (output::find(key)?.get)(answer?)?)))
            .collect()
    });
    state.edit(&format!("Save run {name}"), None, |document| {
        let named = document.with_case(|case| case.name.clone_from(&name));
        let run = Run {
            name: name.clone(),
            saved_ms,
            case: named.case.to_toml(),
            headline,
            version: Some(Version::CURRENT),
        };
        // distinguishes two runs saved in the same millisecond
        let id = format!("{saved_ms:.0}-{}", named.runs.len());
        named.with_runs(|runs| drop(runs.insert(id, run)))
    });
    // announced once it is stored, or when the browser refuses
    state.keeping.announced.set_value(Some(name));
    let protected = state.keeping.protected;
    if protected.get_untracked().is_none() {
        spawn_local(async move { protected.set(Some(storage::protect().await)) });
    }
}

#[component]
fn RunItem(id: String, run: Run) -> impl IntoView {
    let state = State::expect();
    let renaming = RwSignal::new(false);
    let name = run.name.clone();
    let open = {
        let run = run.clone();
        move |_| match recorded(&run.case, run.version) {
            Ok(BroughtUp { case, remarks }) => {
                let case = std::sync::Arc::new(case);
                state.version_remarks.set(remarks);
                state.edit(&format!("Open run {}", run.name), None, |document| {
                    crate::state::document::Document {
                        case: case.clone(),
                        ..document.clone()
                    }
                });
                state.notice.set(format!("Run {} is open.", run.name));
            }
            Err(faults) => state
                .file_faults
                .set(faults.iter().map(ToString::to_string).collect()),
        }
    };
    let delete = {
        let (id, name) = (id.clone(), name.clone());
        move |_| {
            state.edit(&format!("Delete run {name}"), None, |document| {
                document.with_runs(|runs| drop(runs.remove(&id)))
            });
            state
                .notice
                .set(format!("Run {name} is deleted; undo brings it back."));
        }
    };
    let rename = {
        let (id, name) = (id.clone(), name.clone());
        move |new: String| {
            renaming.set(false);
            if new.trim().is_empty() {
                return;
            }
            state.edit(&format!("Rename run {name}"), None, |document| {
                document.with_runs(|runs| {
                    if let Some(run) = runs.get_mut(&id) {
                        run.name = new.trim().to_string()
                    }
                })
            });
        }
    };
    let headline = move || {
        let units = state.document.with(|document| document.units);
        run.headline
            .iter()
            .filter_map(|(key, value)| {
                let output = output::find(key)?;
                let short = HEADLINE.iter().find(|(headline, _)| headline == key)?.1;
                let unit = units.of_output(output);
                Some(format!(
                    "{short} {} {}",
                    number(unit.from_canonical(*value), 4),
                    symbol(unit)
                ))
            })
            .collect::<Vec<_>>()
            .join(" · ")
    };
    let date = date(run.saved_ms);
    let (open_label, rename_label, delete_label) = (
        format!("Open {name}"),
        format!("Rename {name}"),
        format!("Delete {name}"),
    );
    let shown = name.clone();
    view! {
        <li>
            <div class="run-head">
                {move || if renaming.get() {
                    let rename = rename.clone();
                    view! {
                        <input type="text" aria-label="New name" prop:value=shown.clone() autofocus=true
                            on:change:target=move |event| rename(event.target().value()) />
                    }.into_any()
                } else {
                    view! { <strong>{shown.clone()}</strong> }.into_any()
                }}
                <span class="unit">{date}</span>
            </div>
            <p class="run-numbers">{headline}</p>
            <div class="tools">
                <button type="button" class="small" aria-label=open_label on:click=open>"Open"</button>
                <button type="button" class="small" aria-label=rename_label aria-pressed=move || renaming.get().to_string()
                    on:click=move |_| renaming.update(|now| *now = !*now)>"Rename"</button>
                <button type="button" class="small" aria-label=delete_label on:click=delete>"Delete"</button>
            </div>
        </li>
    }
}

/// State of storage, in a few words.
#[component]
pub fn Saved() -> impl IntoView {
    let state = State::expect();
    let keeping = state.keeping;
    let text = move || match keeping.save_state.get() {
        SaveState::Saving => "saving".to_string(),
        SaveState::Saved => state.document.with(|document| match &document.place {
            Place::Stored => "saved in this browser".to_string(),
            Place::Apart(_) if document.is_view() => "a link, nothing changed yet".to_string(),
            Place::Apart(_) => "saved in this browser, apart".to_string(),
        }),
        SaveState::Refused(reason) => format!("not saved: {reason}; tried again"),
    };
    view! {
        <span class="saved" class:bad=move || matches!(keeping.save_state.get(), SaveState::Refused(_))>{text}</span>
        {move || (keeping.protected.get() == Some(false)).then(|| view! {
            <span class="chip" title="The browser may clear what is saved when space runs out. Export important cases as files.">"not protected"</span>
        })}
    }
}
