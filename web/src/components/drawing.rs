//! The vehicle's section, to scale.

use leptos::prelude::*;

/// The drawing.
#[component]
pub fn Drawing() -> impl IntoView {
    view! { <p class="quiet">"The vehicle is drawn here."</p> }
}
