//! Navigation between the pages of the Library.

use crate::pages::library;
use leptos::prelude::*;

/// Links to the pages, with the current one marked.
#[component]
pub fn LibraryTabs() -> impl IntoView {
    let hash = window().location().hash().unwrap_or_default();
    let pages = [
        (library::ADDRESS, "Vehicles"),
        (library::aerodynamics::ADDRESS, "Aerodynamics"),
    ];
    view! {
        <nav class="pages library-pages" aria-label="Library">
            {pages.map(|(address, name)| {
                let is_now = hash.starts_with(address);
                view! { <a href=address aria-current=is_now.then_some("page")>{name}</a> }
            })}
        </nav>
    }
}
