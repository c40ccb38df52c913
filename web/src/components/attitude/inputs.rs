//! Attitude, rates and center of gravity at the start.

use crate::components::number::NumberField;
use crate::components::rows::RowsField;
use leptos::prelude::*;
use msape::quantity::input::{self, Kind};

/// Input keys of the card.
const FIELDS: [&str; 5] = [
    "attitude.alpha_deg",
    "attitude.beta_deg",
    "attitude.bank_deg",
    "attitude.body_rates_deg_s",
    "vehicle.cg_m",
];

/// The fields.
#[component]
pub fn Inputs() -> impl IntoView {
    view! {
        <div class="attitude-fields">
            {FIELDS.into_iter().filter_map(input::find).map(|input| match input.kind {
                Kind::Rows(columns) => view! { <RowsField input columns /> }.into_any(),
                _ => view! { <NumberField input /> }.into_any(),
            }).collect_view()}
        </div>
        <p class="quiet">"Empty: along the velocity, without rates, with the centre of gravity of the design. Coefficients are computed over the design's own outline; the "<a href="#/library/aerodynamics?o=design">"Aerodynamics page"</a>" shows and changes them."</p>
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_fields_are_inputs() {
        for key in FIELDS {
            assert!(input::find(key).is_some(), "{key}");
        }
    }
}
