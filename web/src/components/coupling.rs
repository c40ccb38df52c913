//! How the modules depend on each other, and what crosses between them.

use crate::components::residuals::Residuals;
use leptos::prelude::*;

/// The coupling view.
#[component]
pub fn Coupling() -> impl IntoView {
    view! {
        <section class="card" aria-labelledby="coupling-title">
            <h2 id="coupling-title">"Coupling"</h2>
            <Residuals />
        </section>
    }
}
