//! Legend of a color scale.

use leptos::prelude::*;
use msape_kit::display::number;
use msape_view3d::paint::{SCALE, css};

/// Identifier of the gradient, for other drawings.
pub const GRADIENT: &str = "scale-colors";
/// Number of marks along the scale.
const MARKS: usize = 4;

/// Color bar from zero to the largest value.
#[component]
pub fn Scale(largest: f64, unit: String) -> impl IntoView {
    let stops = SCALE.into_iter().enumerate().map(|(i, color)| {
        let offset = i as f64 / (SCALE.len() - 1) as f64;
        view! { <stop offset=offset stop-color=css(color)></stop> }
    });
    let name = format!(
        "Scale of colors from 0 to {} {unit}, dark to light",
        number(largest, 3)
    );
    let marks = (0..=MARKS).map(|i| {
        let part = i as f64 / MARKS as f64;
        let anchor = match i {
            0 => "start",
            MARKS => "end",
            _ => "middle",
        };
        view! { <text x=200.0 * part y="30" text-anchor=anchor>{number(largest * part, 3)}</text> }
    });
    view! {
        <svg class="scale" viewBox="0 0 200 46" role="img" aria-label=name>
            <defs><linearGradient id=GRADIENT>{stops.collect_view()}</linearGradient></defs>
            <rect width="200" height="16" rx="2" fill=format!("url(#{GRADIENT})")></rect>
            {marks.collect_view()}
            <text x="200" y="43" text-anchor="end">{unit}</text>
        </svg>
    }
}
