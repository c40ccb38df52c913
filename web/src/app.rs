//! The frame around the pages: what is kept, what links say, what keys do.

use crate::components::header::Header;
use crate::components::open::open_file;
use crate::link;
use crate::pages::benchmark::Benchmark;
use crate::pages::design::Design;
use crate::pages::library::aerodynamics::{self, Aerodynamics};
use crate::pages::library::{self, Library};
use crate::presets::{first, starts};
use crate::state::document::{Document, Run};
use crate::state::history::History;
use crate::state::preferences::Preferences;
use crate::state::{SaveState, State};
use crate::storage::{self, Store};
use leptos::ev::{DragEvent, KeyboardEvent};
use leptos::prelude::*;
use msape::case::version::BroughtUp;
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::rc::Rc;
use std::sync::Arc;
use wasm_bindgen_futures::spawn_local;

/// What is between header and footer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Page {
    /// Inputs and results of one design.
    Design,
    /// Outlines of vehicles.
    Library,
    /// Coefficients of bodies.
    Aerodynamics,
    /// Speed in this browser.
    Benchmark,
}

impl Page {
    /// The page of the address.
    fn now() -> Page {
        match window().location().hash().as_deref() {
            Ok("#/benchmark") => Page::Benchmark,
            Ok(hash) if hash.starts_with(library::ADDRESS) => Page::Library,
            Ok(hash) if hash.starts_with(aerodynamics::ADDRESS) => Page::Aerodynamics,
            _ => Page::Design,
        }
    }

    /// Whether a link in the header leads to where this page is.
    pub fn is_part_of(self, other: Page) -> bool {
        self == other || (self, other) == (Page::Aerodynamics, Page::Library)
    }

    fn title(self) -> &'static str {
        match self {
            Page::Design => "M-SAPE: planetary entry vehicles",
            Page::Library => "Library - M-SAPE: planetary entry vehicles",
            Page::Aerodynamics => "Aerodynamics - M-SAPE: planetary entry vehicles",
            Page::Benchmark => "Benchmark - M-SAPE: planetary entry vehicles",
        }
    }
}

/// The app.
#[component]
pub fn App() -> impl IntoView {
    let linked = linked_case();
    let is_linked = linked.is_some();
    let (case, remarks) = match linked {
        Some(linked) => (linked.case, linked.remarks),
        None => (first(), Vec::new()),
    };
    let state = State::new(Document::new(case), Preferences::load());
    state.version_remarks.set(remarks);
    provide_context(state);
    keep(state, is_linked);
    listen(state);
    forget_notices(state);
    let page = follow_address();
    view! {
        <a class="skip" href="#main" on:click=|event| {
            // The address after # belongs to links.
            event.prevent_default();
            focus_main();
        }>"Skip to the content"</a>
        <Header page />
        {move || match page.get() {
            Page::Design => view! { <Design /> }.into_any(),
            Page::Library => view! { <Library /> }.into_any(),
            Page::Aerodynamics => view! { <Aerodynamics /> }.into_any(),
            Page::Benchmark => view! { <Benchmark /> }.into_any(),
        }}
        <footer class="bottom">
            <p class="notice" role="status">{state.notice}</p>
            <p class="quiet">"M-SAPE " {env!("CARGO_PKG_VERSION")} ". Computed in this browser; nothing is sent anywhere. After NASA/TM-2014-218507. "<a href="#/benchmark">"Benchmark"</a></p>
        </footer>
    }
}

/// The page of the address. Another one starts at its top.
fn follow_address() -> Memo<Page> {
    let turned = RwSignal::new(Page::now());
    let page = Memo::new(move |_| turned.get());
    let turns = window_event_listener(leptos::ev::hashchange, move |_| turned.set(Page::now()));
    on_cleanup(move || turns.remove());
    Effect::new(move |before: Option<Page>| {
        let page = page.get();
        document().set_title(page.title());
        if before.is_some_and(|before| before != page) {
            window().scroll_to_with_x_and_y(0.0, 0.0);
            // When it is there.
            request_animation_frame(focus_main);
        }
        page
    });
    page
}

fn focus_main() {
    use wasm_bindgen::JsCast;
    let main = document().get_element_by_id("main");
    if let Some(main) = main.and_then(|main| main.dyn_into::<web_sys::HtmlElement>().ok()) {
        // An element that cannot take the focus leaves it where it is.
        let _ = main.focus();
    }
}

/// The case of the address, which is then cleared so that a reload keeps later edits.
fn linked_case() -> Option<BroughtUp> {
    let hash = window().location().hash().ok()?;
    let case = link::case(&hash, &starts());
    if case.is_some()
        && let Ok(history) = window().history()
    {
        // A browser that refuses shows the old address; nothing depends on it.
        let _ = history.replace_state_with_url(&wasm_bindgen::JsValue::NULL, "", Some("#/design"));
    }
    case
}

/// Opens what was kept, and from then on keeps every document.
fn keep(state: State, linked: bool) {
    spawn_local(async move {
        let store = match Store::open().await {
            Ok(store) => store,
            Err(error) => {
                state.save_state.set(SaveState::Refused(error.to_string()));
                return;
            }
        };
        let runs = match store.load().await {
            Ok(kept) => {
                let opened = !linked && state.history.with_untracked(History::is_pristine);
                restore(state, kept.document, &kept.runs, linked);
                if opened {
                    state.version_remarks.set(kept.remarks);
                }
                kept.runs
            }
            Err(error) => {
                state.save_state.set(SaveState::Refused(error.to_string()));
                BTreeMap::new()
            }
        };
        if !runs.is_empty() {
            state.protected.set(Some(storage::is_protected().await));
        }
        save_on_change(state, store, runs);
    });
}

fn restore(state: State, kept: Option<Document>, runs: &BTreeMap<String, Run>, linked: bool) {
    let now = state.document.get_untracked();
    let with_runs = |document: &Document| Document {
        runs: Arc::new(runs.clone()),
        ..document.clone()
    };
    let Some(kept) = kept else {
        if !runs.is_empty() {
            state.history.set(History::new(with_runs(&now)));
        }
        return;
    };
    if linked || !state.history.with_untracked(History::is_pristine) {
        // What was kept is one undo away.
        let mut history = History::new(kept.clone());
        let opened = Document {
            case: now.case.clone(),
            ..kept
        };
        history.edit("Open link", None, opened);
        state.history.set(history);
    } else {
        state.history.set(History::new(kept));
    }
}

/// Writes one document after the other; those that come while one is written wait, and only the newest is written.
fn save_on_change(state: State, store: Store, runs: BTreeMap<String, Run>) {
    let store = Rc::new(store);
    let kept = Rc::new(RefCell::new(runs));
    let busy = Rc::new(RefCell::new(false));
    let waiting: Rc<RefCell<Option<Arc<Document>>>> = Rc::default();
    Effect::new(move |_| {
        *waiting.borrow_mut() = Some(state.document.get());
        state.save_state.set(SaveState::Saving);
        if busy.replace(true) {
            return;
        }
        let (store, kept, busy, waiting) =
            (store.clone(), kept.clone(), busy.clone(), waiting.clone());
        spawn_local(async move {
            loop {
                let Some(document) = waiting.borrow_mut().take() else {
                    break;
                };
                let before = kept.borrow().clone();
                let saved = store.save(&before, &document).await;
                state.save_state.set(match saved {
                    Ok(()) => {
                        kept.replace((*document.runs).clone());
                        SaveState::Saved
                    }
                    Err(error) => SaveState::Refused(error.to_string()),
                });
            }
            busy.replace(false);
        });
    });
}

/// Takes a notice away when it has been there long enough to be read.
fn forget_notices(state: State) {
    Effect::new(move |_| {
        let shown = state.notice.get();
        let forget = move || {
            if state.notice.with_untracked(|notice| *notice == shown) {
                state.notice.set(String::new());
            }
        };
        set_timeout(forget, std::time::Duration::from_secs(8));
    });
}

fn listen(state: State) {
    let keys = window_event_listener(leptos::ev::keydown, move |event: KeyboardEvent| {
        if !(event.ctrl_key() || event.meta_key()) || event.alt_key() {
            return;
        }
        match (event.key().to_lowercase().as_str(), event.shift_key()) {
            ("z", false) => state.undo(),
            ("z", true) | ("y", _) => state.redo(),
            _ => return,
        }
        event.prevent_default();
    });
    let over = window_event_listener(leptos::ev::dragover, |event: DragEvent| {
        event.prevent_default();
    });
    let drop = window_event_listener(leptos::ev::drop, move |event: DragEvent| {
        event.prevent_default();
        let files = event.data_transfer().and_then(|data| data.files());
        if let Some(file) = files.and_then(|files| files.get(0)) {
            open_file(state, file);
        }
    });
    let links = window_event_listener(leptos::ev::hashchange, move |_| {
        if let Some(BroughtUp { case, remarks }) = linked_case() {
            crate::components::open::replace_case(state, "Open link", case);
            state.version_remarks.set(remarks);
        }
    });
    on_cleanup(move || {
        keys.remove();
        over.remove();
        drop.remove();
        links.remove();
    });
}
