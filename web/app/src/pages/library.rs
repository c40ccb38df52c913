//! Vehicles page of the Library: outlines of known vehicles and imported ones.

pub mod aerodynamics;

use crate::components::cad::CadMenu;
use crate::components::library_tabs::LibraryTabs;
use crate::components::outline::drawing::{OutlineDrawing, describe};
use crate::components::outline::facts::Facts;
use crate::components::outline::flight::OutlineFlight;
use crate::components::outline::import::Import;
use crate::components::outline::{Entry, entries};
use crate::components::view3d::stage::{Paint, PaintedPart, Stage, Subject};
use crate::state::State;
use cad::export::Model;
use leptos::prelude::*;
use msape::vehicle::body::RigidBody;
use msape_kit::files::file_name;
use std::sync::Arc;

/// Address of the page.
pub const ADDRESS: &str = "#/library/vehicles";

/// Outline named by the address.
pub(crate) fn linked(page: &str) -> Option<String> {
    let hash = window().location().hash().ok()?;
    let id = hash.strip_prefix(page)?.strip_prefix("?o=")?;
    js_sys::decode_uri_component(id).ok()?.as_string()
}

/// Puts the outline into the address, without an entry in the browser's history.
pub(crate) fn link(page: &str, id: &str) {
    let address = format!(
        "{page}?o={}",
        String::from(js_sys::encode_uri_component(id))
    );
    if let Ok(history) = window().history() {
        // if the browser refuses, the old address stays; nothing depends on it
        let _ = history.replace_state_with_url(&wasm_bindgen::JsValue::NULL, "", Some(&address));
    }
}

/// Navigates to an outline.
pub fn go_to(id: &str) {
    let id = String::from(js_sys::encode_uri_component(id));
    // if the browser refuses, the page stays
    let _ = window().location().set_hash(&format!("{ADDRESS}?o={id}"));
}

/// The page.
#[component]
pub fn Library() -> impl IntoView {
    let state = State::expect();
    let list = Memo::new(move |_| entries(state));
    let chosen = RwSignal::new(linked(ADDRESS).unwrap_or_default());
    let entry = Memo::new(move |_| {
        let id = chosen.get();
        list.with(|list| {
            let named = list.iter().find(|entry| entry.id() == id);
            named.or_else(|| list.first()).cloned()
        })
    });
    let body = Memo::new(move |_| entry.with(|entry| entry.as_ref()?.body()));
    let model = Signal::derive(move || {
        body.with(|body| body.as_ref().map(|body| Model::of_body(&body.name, body)))
    });
    let title = move || entry.with(|entry| entry.as_ref().map(Entry::title));
    let choose = move |id: String| {
        link(ADDRESS, &id);
        chosen.set(id);
    };
    view! {
        <main id="main" class="library" tabindex="-1">
            <section class="card library-list" aria-labelledby="outlines-title">
                <LibraryTabs />
                <h2 id="outlines-title">"Vehicles"</h2>
                <ul class="outline-list">
                    {move || list.get().into_iter().map(|item| {
                        let id = item.id();
                        let this = id.clone();
                        let is_now = move || entry.with(|entry| entry.as_ref().is_some_and(|entry| entry.id() == this));
                        view! {
                            <li>
                                <button type="button" class="wide" aria-pressed=move || is_now().to_string()
                                    on:click=move |_| choose(id.clone())>{item.title()}</button>
                                {remove_button(state, &item)}
                            </li>
                        }
                    }).collect_view()}
                </ul>
                <Import take=choose />
            </section>
            <div class="library-main">
                <section class="card" aria-labelledby="outline-title">
                    <header>
                        <h2 id="outline-title">{title}</h2>
                        <CadMenu model=model />
                    </header>
                    <div class="outline-views">
                        <OutlineDrawing body />
                        <OutlineView body />
                    </div>
                    <Facts entry body />
                </section>
                <section class="card" aria-labelledby="fly-title">
                    <h2 id="fly-title">"Use in a flight"</h2>
                    <OutlineFlight entry />
                </section>
            </div>
        </main>
    }
}

fn remove_button(state: State, entry: &Entry) -> Option<impl IntoView + use<>> {
    let Entry::Own(name, _) = entry else {
        return None;
    };
    let name = name.clone();
    let label = format!("Remove {name}");
    Some(view! {
        <button type="button" class="small" aria-label=label.clone() on:click=move |_| {
            state.edit(&label, None, |document| document.with_outlines(|outlines| {
                outlines.remove(&name);
            }));
            state.notice.set(format!("{name} is removed; undo brings it back."));
        }>"Remove"</button>
    })
}

/// Outline in three dimensions.
#[component]
fn OutlineView(#[prop(into)] body: Signal<Option<RigidBody>>) -> impl IntoView {
    let state = State::expect();
    let subject = Signal::derive(move || {
        body.with(|body| {
            let body = body.as_ref()?;
            Some(Subject::Body(Arc::new(body.outline.clone())))
        })
    });
    let part = PaintedPart {
        paint: Paint::Variable("--part-aftbody-carrier"),
        shown: true,
        lit: false,
    };
    let summary = Signal::derive(move || {
        let units = state.document.with(|document| document.units);
        let words = body.with(|body| body.as_ref().map(|body| describe(body, units)));
        format!("Outline in three dimensions. {}", words.unwrap_or_default())
    });
    let name = Signal::derive(move || {
        let name = body.with(|body| body.as_ref().map(|body| body.name.clone()));
        file_name(&format!("{}-3d", name.unwrap_or_default()), "png")
    });
    view! {
        <Stage subject parts=Signal::stored(vec![part]) by_scale=Signal::stored(false) summary name />
    }
}
