//! Export of the case and its answer.

use crate::state::State;
use leptos::prelude::*;
use msape::quantity::Job;
use msape::table::kml::{Instant, kml};
use msape::table::{self, Manner};
use msape::{Answer, Case};
use msape_kit::files::{self, file_name};

/// Export file type.
#[derive(Clone, Copy)]
struct Kind {
    button: &'static str,
    help: &'static str,
    suffix: &'static str,
    extension: &'static str,
    mime: &'static str,
    text: fn(State) -> Option<String>,
}

fn of_case(state: State, write: fn(&Case) -> String) -> Option<String> {
    Some(state.case.with_untracked(|case| write(case)))
}

/// Output of `write` for the newest answer and its case.
fn of_answer(state: State, write: impl FnOnce(&Case, &Answer) -> Option<String>) -> Option<String> {
    let latest = state.latest.get_untracked()?;
    write(&latest.case, &latest.answer)
}

fn results(state: State, manner: Manner) -> Option<String> {
    of_answer(state, |case, answer| {
        let solved = table::Solved { case, answer };
        Some(table::results(&[solved], Job::Design, manner).to_csv())
    })
}

fn trajectory(state: State, manner: Manner) -> Option<String> {
    of_answer(state, |_, answer| {
        let history = answer.flight.as_ref()?.trajectory.as_ref()?;
        Some(table::history(history, manner).to_csv())
    })
}

/// Start time of KML tracks, the same as the command line's: a flight has no date.
const EPOCH: &str = "2000-01-01T12:00:00Z";

fn track(state: State) -> Option<String> {
    of_answer(state, |_, answer| kml(answer, Instant::parse(EPOCH)?))
}

const KINDS: &[Kind] = &[
    Kind {
        button: "Inputs (TOML)",
        help: "the case, for people and for the command line",
        suffix: "",
        extension: "toml",
        mime: "application/toml",
        text: |state| of_case(state, Case::to_toml),
    },
    Kind {
        button: "Inputs (JSON)",
        help: "the same for other programs",
        suffix: "",
        extension: "json",
        mime: "application/json",
        text: |state| of_case(state, Case::to_json),
    },
    Kind {
        button: "Export Results to CSV",
        help: "the report's columns and units",
        suffix: "-results",
        extension: "csv",
        mime: "text/csv",
        text: |state| results(state, Manner::Report),
    },
    Kind {
        button: "Results (CSV, SI)",
        help: "keys and SI units",
        suffix: "-results-si",
        extension: "csv",
        mime: "text/csv",
        text: |state| results(state, Manner::Si),
    },
    Kind {
        button: "Trajectory (CSV)",
        help: "time history, keys and SI units",
        suffix: "-trajectory",
        extension: "csv",
        mime: "text/csv",
        text: |state| trajectory(state, Manner::Si),
    },
    Kind {
        button: "Trajectory (KML)",
        help: "for viewers of the globe",
        suffix: "-trajectory",
        extension: "kml",
        mime: "application/vnd.google-earth.kml+xml",
        text: track,
    },
];

/// The buttons.
#[component]
pub fn Export() -> impl IntoView {
    let state = State::expect();
    let hand_over = move |kind: &Kind| match (kind.text)(state) {
        Some(text) => {
            let name = state.case.with_untracked(|case| case.name.clone());
            save(
                state,
                files::download(
                    &file_name(&format!("{name}{}", kind.suffix), kind.extension),
                    kind.mime,
                    &text,
                ),
            );
        }
        None => state
            .notice
            .set("There is no result to export yet.".to_string()),
    };
    view! {
        <ul class="exports">
            {KINDS.iter().map(|kind| view! {
                <li>
                    <button type="button" class="small" on:click=move |_| hand_over(kind)>{kind.button}</button>
                    <span class="unit">{kind.help}</span>
                </li>
            }).collect_view()}
        </ul>
    }
}

/// Shows the result of an export.
pub fn save(state: State, result: Result<(), wasm_bindgen::JsValue>) {
    state.notice.set(match result {
        Ok(()) => "Exported.".to_string(),
        Err(error) => format!("The browser refused the export: {error:?}"),
    });
}
