//! Aerodynamics page of the Library: coefficients of a body over angle, Mach and Knudsen number.

use crate::components::aerodynamics::form::{DatabaseForm, PlacesForm};
use crate::components::aerodynamics::import::TableImport;
use crate::components::aerodynamics::plots::Plots;
use crate::components::aerodynamics::sources::Sources;
use crate::components::aerodynamics::usage::Usage;
use crate::components::aerodynamics::{AeroView, bodies};
use crate::components::library_tabs::LibraryTabs;
use crate::state::State;
use leptos::prelude::*;

/// Address of the page.
pub const ADDRESS: &str = "#/library/aerodynamics";

/// The page.
#[component]
pub fn Aerodynamics() -> impl IntoView {
    let state = State::expect();
    let view = AeroView::new(state, super::linked(ADDRESS).unwrap_or_default());
    provide_context(view);
    let list = Memo::new(move |_| bodies(state));
    let title = move || {
        view.body.with(|body| {
            let title = body.as_ref().map(|body| body.title.clone());
            match view.table.get() {
                Some(table) => format!("{}, table {table}", title.unwrap_or_default()),
                None => title.unwrap_or_default(),
            }
        })
    };
    view! {
        <main id="main" class="library" tabindex="-1">
            <section class="card library-list" aria-labelledby="databases-title">
                <LibraryTabs />
                <h2 id="databases-title">"Aerodynamics"</h2>
                <ul class="outline-list">
                    {move || list.get().into_iter().map(|body| {
                        let (id, this) = (body.id.clone(), body.id);
                        let is_now = move || view.body.with(|body| body.as_ref().is_some_and(|body| body.id == this));
                        view! {
                            <li>
                                <button type="button" class="wide" aria-pressed=move || is_now().to_string()
                                    on:click=move |_| {
                                        super::link(ADDRESS, &id);
                                        view.chosen.set(id.clone());
                                    }>{body.title}</button>
                            </li>
                        }
                    }).collect_view()}
                </ul>
                <TableImport />
            </section>
            <div class="library-main">
                <section class="card" aria-labelledby="database-title">
                    <header>
                        <h2 id="database-title">{title}</h2>
                        <Usage />
                    </header>
                    <PlacesForm />
                    <details class="group">
                        <summary><h3>"Choices of the database"</h3></summary>
                        <DatabaseForm />
                    </details>
                    <Sources />
                </section>
                <Plots />
            </div>
        </main>
    }
}
