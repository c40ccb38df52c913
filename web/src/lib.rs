//! The app: pages turn signals into a case and an answer into signals; the core computes, in a worker.
//!
//! - `app`: the frame around the pages; `pages`: one file per page; `components`: what they are made of.
//! - `state`: the undo stack of immutable documents, the newest answer, what is shown.
//! - [`solver`], [`tools`] and [`protocol`]: what the two workers do and how the page asks for it; [`serve`]: their end of the line;
//!   `catalog`: what the page shows of the library.
//! - `drawing` and `view3d`: the vehicle as a section and in three dimensions.
//! - `clock` and `timing`: what the benchmark page measures with.
//! - `worker`, `storage`, `files`: the page's ends of the worker, of IndexedDB and of files; `saving`: what is kept, and when.
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

/// Takes the skeleton away and shows the app.
pub fn start() {
    console_error_panic_hook::set_once();
    if let Some(skeleton) = leptos::prelude::document().get_element_by_id("skeleton") {
        skeleton.remove();
    }
    leptos::mount::mount_to_body(app::App);
}
