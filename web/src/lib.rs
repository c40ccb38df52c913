//! The web app: pages turn signals into a case and an answer into signals; the core computes, in a worker.
//!
//! - `app`: the frame around the pages; `pages`: one file per page; `components`: parts of pages.
//! - `state`: the undo stack of immutable documents, the newest answer, display state.
//! - [`solver`], [`tools`] and [`protocol`]: the two workers and their messages; [`serve`]: the workers' side of the
//!   connection; `catalog`: library data shown by the page.
//! - `drawing` and `view3d`: the vehicle as a section and in three dimensions.
//! - `clock` and `timing`: time measurement of the benchmark page.
//! - `worker`, `storage`, `files`: the page's interfaces to the workers, IndexedDB and files; `saving`: automatic
//!   saving.
//!
//! Deliberately absent: physics, units and lists of variables. They are in `msape`.

mod aerodynamics;
mod app;
mod catalog;
mod charts;
mod clock;
mod components;
mod display;
mod drawing;
mod files;
pub mod link;
mod observe;
mod pages;
pub mod presets;
pub mod protocol;
mod saving;
pub mod serve;
pub mod solver;
mod state;
mod storage;
mod timing;
pub mod tools;
mod view3d;
mod worker;

/// Removes the placeholder and mounts the app.
pub fn start() {
    console_error_panic_hook::set_once();
    if let Some(skeleton) = leptos::prelude::document().get_element_by_id("skeleton") {
        skeleton.remove();
    }
    leptos::mount::mount_to_body(app::App);
}
