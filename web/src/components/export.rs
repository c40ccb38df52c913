//! Files of the case and its answer.

use crate::components::chart_panel::save;
use crate::files::{self, file_name};
use crate::state::State;
use leptos::prelude::*;
use msape::Case;

/// A kind of file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
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

const KINDS: &[Kind] = &[
    Kind { button: "Inputs (TOML)", help: "the case, for people and for the command line", suffix: "", extension: "toml", mime: "application/toml", text: |state| of_case(state, Case::to_toml) },
    Kind { button: "Inputs (JSON)", help: "the same for other programs", suffix: "", extension: "json", mime: "application/json", text: |state| of_case(state, Case::to_json) },
];

/// The buttons.
#[component]
pub fn Export() -> impl IntoView {
    let state = State::expect();
    let hand_over = move |kind: &Kind| match (kind.text)(state) {
        Some(text) => {
            let name = state.case.with_untracked(|case| case.name.clone());
            save(state, files::download(&file_name(&format!("{name}{}", kind.suffix), kind.extension), kind.mime, &text));
        }
        None => state.notice.set("There is no result to export yet.".to_string()),
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
