//! Charts with the theme and the status line of the app.

use crate::charts::ChartSpec;
use crate::components::export::save;
use crate::state::State;
use leptos::prelude::*;
use msape_kit::{chart, chart_foot};
use msape_plot::Figure;

/// Draws a figure; `points` are those of its first series, one for each row of the time history.
#[component]
pub fn Chart(
    title: Signal<String>,
    spec: Signal<ChartSpec>,
    figure: Memo<Figure>,
    points: Memo<Vec<(f64, f64)>>,
    focused: RwSignal<bool>,
    /// Whether the chart has no cursor.
    #[prop(optional)]
    still: bool,
    /// A separate cursor instead of the one shared by all charts of the flight.
    #[prop(optional)]
    cursor: Option<RwSignal<Option<usize>>>,
) -> impl IntoView {
    let state = State::expect();
    // a figure without columns of a flight: its first curve runs along x
    let along_x = move || spec.with(|spec| ["", "time_s"].contains(&spec.x.as_str()));
    let cursor = cursor.unwrap_or(state.cursor);
    view! {
        <chart::Chart title figure points along_x=Signal::derive(along_x) dark=state.preferences.dark cursor focused still />
    }
}

/// Reading, table and exports of a figure; the status line tells how an export went.
#[component]
pub fn ChartFoot(
    title: Signal<String>,
    figure: Memo<Figure>,
    /// Values at the cursor.
    #[prop(into)]
    reading: Signal<Option<String>>,
    focused: RwSignal<bool>,
    table_open: RwSignal<bool>,
    /// File name without extension.
    #[prop(into)]
    stem: Signal<String>,
) -> impl IntoView {
    let state = State::expect();
    view! {
        <chart_foot::ChartFoot title figure reading focused table_open stem on_saved=move |result| save(state, result) />
    }
}
