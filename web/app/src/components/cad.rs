//! Export menu: the same files as the command line, written by the same functions.

use crate::components::export::save;
use crate::state::State;
use cad::export::{Format, Model};
use leptos::ev::PointerEvent;
use leptos::html::Details;
use leptos::prelude::*;
use msape_kit::files::{self, file_name};
use msape_worker::questions::Write;
use wasm_bindgen::JsCast;
use wasm_bindgen_futures::spawn_local;

/// A button that opens the list of formats.
#[component]
pub fn CadMenu(#[prop(into)] model: Signal<Option<Model>>) -> impl IntoView {
    let state = State::expect();
    let write = move |format: Format| match model.get_untracked() {
        Some(model) => spawn_local(async move {
            let name = file_name(&model.name, format.name());
            match state.ask_once(Write(format, Box::new(model))).await {
                Ok(bytes) => save(
                    state,
                    files::download_bytes(&name, format.media_type(), &bytes),
                ),
                Err(message) => state
                    .notice
                    .set(format!("{name} was not written: {message}.")),
            }
        }),
        None => state
            .notice
            .set("There is no vehicle to export yet.".to_string()),
    };
    let menu = NodeRef::<Details>::new();
    // a press elsewhere closes the menu
    let presses = window_event_listener(leptos::ev::pointerdown, move |event: PointerEvent| {
        let Some(menu) = menu.get_untracked().filter(|menu| menu.open()) else {
            return;
        };
        let target = event
            .target()
            .and_then(|target| target.dyn_into::<web_sys::Node>().ok());
        if !menu.contains(target.as_ref()) {
            menu.set_open(false);
        }
    });
    on_cleanup(move || presses.remove());
    view! {
        <details class="menu" node_ref=menu on:keydown=|event| close_on_escape(&event)>
            <summary>"Export"</summary>
            <ul class="exports">
                {Format::ALL.into_iter().map(|format| view! {
                    <li>
                        <button type="button" class="small" on:click=move |_| write(format)>{format.name().to_uppercase()}</button>
                        <span class="unit">{format.help()}</span>
                    </li>
                }).collect_view()}
            </ul>
        </details>
    }
}

fn close_on_escape(event: &leptos::ev::KeyboardEvent) {
    if event.key() != "Escape" {
        return;
    }
    let menu = event
        .current_target()
        .and_then(|menu| menu.dyn_into::<web_sys::Element>().ok());
    if let Some(menu) = menu {
        // close an open menu and return the focus to its button
        let _ = menu.remove_attribute("open");
        let summary = menu.first_element_child();
        if let Some(summary) = summary.and_then(|s| s.dyn_into::<web_sys::HtmlElement>().ok()) {
            let _ = summary.focus();
        }
    }
}
