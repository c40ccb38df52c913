//! Frame around the pages: storage, links, keyboard shortcuts.

use crate::components::header::Header;
use crate::components::kept::Kept;
use crate::components::open::open_file;
use crate::link::{self, Linked};
use crate::pages::benchmark::Benchmark;
use crate::pages::design::Design;
use crate::pages::library::aerodynamics::{self, Aerodynamics};
use crate::pages::library::{self, Library};
use crate::presets::{first, starts};
use crate::saving::Saver;
use crate::saving::choices::of_link;
use crate::state::State;
use crate::state::document::Document;
use crate::state::preferences::Preferences;
use leptos::ev::{DragEvent, KeyboardEvent};
use leptos::prelude::*;
use msape::case::version::BroughtUp;

/// Page between header and footer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Page {
    /// Inputs and results of one design.
    Design,
    /// Outlines of vehicles.
    Library,
    /// Coefficients of bodies.
    Aerodynamics,
    /// Speed of the solver in this browser.
    Benchmark,
}

impl Page {
    /// Page of the current address.
    fn now() -> Page {
        match window().location().hash().as_deref() {
            Ok("#/benchmark") => Page::Benchmark,
            Ok(hash) if hash.starts_with(library::ADDRESS) => Page::Library,
            Ok(hash) if hash.starts_with(aerodynamics::ADDRESS) => Page::Aerodynamics,
            _ => Page::Design,
        }
    }

    /// Whether the current page belongs to a link of the header.
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

/// Root component.
#[component]
pub fn App() -> impl IntoView {
    let Linked { case, words } = linked().unwrap_or_default();
    let is_linked = case.is_some();
    let BroughtUp { case, remarks } = case.unwrap_or_else(|| BroughtUp {
        case: first(),
        remarks: Vec::new(),
    });
    let state = State::new(Document::new(case), Preferences::load());
    state.version_remarks.set(remarks);
    state.keeping.link_words.set(words);
    provide_context(state);
    state.saver.set_value(Some(Saver::start(state, is_linked)));
    listen(state);
    forget_notices(state);
    let page = follow_address();
    view! {
        <a class="skip" href="#main" on:click=|event| {
            // the fragment of the address is used by links
            event.prevent_default();
            focus_main();
        }>"Skip to the content"</a>
        <Header page />
        <Kept />
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

/// Page of the current address; a new page starts at its top.
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
            // focus once the element exists
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
        // an element that cannot take the focus leaves it where it is
        let _ = main.focus();
    }
}

/// Content of the link in the address, if there is one.
fn linked() -> Option<Linked> {
    let hash = window().location().hash().ok()?;
    link::read(&hash, &starts())
}

/// Removes the link from the address, so that a reload keeps later edits.
pub fn leave_link() {
    if linked().is_some()
        && let Ok(history) = window().history()
    {
        // if the browser refuses, the old address stays; nothing depends on it
        let _ = history.replace_state_with_url(&wasm_bindgen::JsValue::NULL, "", Some("#/design"));
    }
}

/// Clears a notice after enough time to read it.
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
        let Some(Linked { case, words }) = linked() else {
            return;
        };
        state.keeping.link_words.set(words);
        if let Some(BroughtUp { case, remarks }) = case {
            state.edit("Open link", None, |now| of_link(now, case));
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
