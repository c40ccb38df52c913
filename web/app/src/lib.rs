//! The web app: pages turn signals into a case and an answer into signals; the core computes, in a worker.
//!
//! - `app`: the frame around the pages; `pages`: one file per page; `components`: parts of pages.
//! - `state`: the undo stack of immutable documents, the newest answer, questions to the workers, display state.
//! - `drawing`: the vehicle as a section.
//! - `timing`: the benchmark page's rule of repetitions.
//! - `storage`, `files`: the page's interfaces to IndexedDB and files; `saving`: automatic saving.
//!
//! Deliberately absent: physics, units and lists of variables. They are in `msape`.

mod app;
mod charts;
mod components;
mod drawing;
pub mod link;
mod pages;
pub mod presets;
mod saving;
mod state;
mod storage;
mod timing;

/// Removes the placeholder and mounts the app.
pub fn start() {
    console_error_panic_hook::set_once();
    if let Some(skeleton) = leptos::prelude::document().get_element_by_id("skeleton") {
        skeleton.remove();
    }
    leptos::mount::mount_to_body(app::App);
}
