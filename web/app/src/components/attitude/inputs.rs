//! Attitude, rates and center of gravity at the start.

use crate::components::number::NumberField;
use crate::components::rows::RowsField;
use leptos::prelude::*;
use msape::quantity::input::{self, Input, Kind};

/// Input keys of the card.
const FIELDS: [&Input; 5] = [
    &input::attitude::ALPHA_DEG,
    &input::attitude::BETA_DEG,
    &input::attitude::BANK_DEG,
    &input::attitude::BODY_RATES_DEG_S,
    &input::vehicle::CG_M,
];

/// The fields.
#[component]
pub fn Inputs() -> impl IntoView {
    view! {
        <div class="attitude-fields">
            {FIELDS.into_iter().map(|input| match input.kind {
                Kind::Rows(columns) => view! { <RowsField input columns /> }.into_any(),
                _ => view! { <NumberField input /> }.into_any(),
            }).collect_view()}
        </div>
        <p class="quiet">"Empty: along the velocity, without rates, with the center of gravity of the design. Coefficients are computed over the design's own outline; the "<a href="#/library/aerodynamics?o=design">"Aerodynamics page"</a>" shows and changes them."</p>
    }
}
