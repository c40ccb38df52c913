//! Link that restores the case.

use crate::link;
use crate::presets::starts;
use crate::state::State;
use leptos::prelude::*;
use msape_kit::files;
use wasm_bindgen_futures::spawn_local;

/// Address of the app with the case after `#`.
pub fn address(state: State) -> String {
    let fragment = state
        .case
        .with_untracked(|case| link::fragment(case, &starts()));
    let page = window().location().href().unwrap_or_default();
    let page = page.split('#').next().unwrap_or_default();
    format!("{page}#{fragment}")
}

/// The button.
#[component]
pub fn Share() -> impl IntoView {
    let state = State::expect();
    let share = move |_| {
        let address = address(state);
        spawn_local(async move {
            let length = address.len();
            let copied = files::copy(address.clone()).await.is_ok();
            state.notice.set(match (copied, length > link::LENGTH_MAX) {
                (true, false) => "The link to this case is copied.".to_string(),
                (true, true) => format!("The link is copied. It has {length} characters, which some programs cut: exporting the inputs as a file is safer."),
                (false, _) => format!("The browser refused to copy. The link: {address}"),
            });
        });
    };
    view! { <button type="button" on:click=share title="Copy a link that restores this case">"Share link"</button> }
}
