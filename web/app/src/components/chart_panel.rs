//! Chart with its reading, table and exports.

use crate::charts::{ChartSpec, Span};
use crate::components::chart::Chart;
use crate::components::chart::ChartFoot;
use crate::state::State;
use msape_kit::chart_table::ChartTable;
use msape_kit::display::{number, symbol};

use leptos::prelude::*;
use msape::Answer;
use msape::flight::columns::{columns, find};
use std::sync::Arc;

/// Chart of one column over another.
#[component]
pub fn ChartPanel(
    spec: RwSignal<ChartSpec>,
    span: RwSignal<Span>,
    /// Whether the columns can be chosen.
    #[prop(optional)]
    free: bool,
    /// Answer whose flight is drawn, instead of the newest.
    #[prop(optional)]
    answer: Option<Signal<Option<Arc<Answer>>>>,
    /// A separate cursor.
    #[prop(optional)]
    cursor: Option<RwSignal<Option<usize>>>,
) -> impl IntoView {
    let state = State::expect();
    let units = Memo::new(move |_| state.document.with(|document| document.units));
    let figure = Memo::new(move |_| {
        let (spec, units, span) = (spec.get(), units.get(), span.get());
        let drawn = |answer: &Answer| Some(spec.figure(answer.flight.as_ref()?, units, span));
        let figure = match answer {
            Some(answer) => answer.with(|answer| drawn(answer.as_ref()?)),
            None => state.latest.with(|latest| drawn(&latest.as_ref()?.answer)),
        };
        figure.unwrap_or_default()
    });
    let points = Memo::new(move |_| {
        figure.with(|figure| {
            figure
                .series
                .first()
                .map(|series| series.points.clone())
                .unwrap_or_default()
        })
    });
    let title = Signal::derive(move || spec.with(ChartSpec::title));
    let table_open = RwSignal::new(false);
    let focused = RwSignal::new(false);
    let cursor = cursor.unwrap_or(state.cursor);
    let reading = move || {
        cursor
            .get()
            .and_then(|row| {
                points.with(|points| points.get(row.min(points.len().checked_sub(1)?)).copied())
            })
            .map(|(x, y)| {
                let (spec, units) = (spec.get(), units.get());
                let part = |key: &str, value| {
                    find(key)
                        .map(|column| {
                            let symbol = symbol(units.of_column(column));
                            format!("{} {} {symbol}", column.label, number(value, 5))
                                .trim_end()
                                .to_string()
                        })
                        .unwrap_or_default()
                };
                format!("{}, {}", part(&spec.x, x), part(&spec.y, y))
            })
    };

    view! {
        <figure class="chart-panel">
            <figcaption>
                {if free {
                    view! { <ColumnChoice spec /> }.into_any()
                } else {
                    view! { <h3>{title}</h3> }.into_any()
                }}
            </figcaption>
            <Chart title spec=spec.into() figure points focused cursor />
            <ChartFoot title figure reading=Signal::derive(reading) focused table_open stem=title />
            <Show when=move || table_open.get() fallback=|| ()>
                <ChartTable figure title />
            </Show>
        </figure>
    }
}

/// The two lists of columns.
#[component]
fn ColumnChoice(spec: RwSignal<ChartSpec>) -> impl IntoView {
    let list = move |label: &'static str, get: fn(&mut ChartSpec) -> &mut String| {
        view! {
            <label class="inline">
                <span>{label}</span>
                <select on:change:target=move |event| {
                    let key = event.target().value();
                    spec.update(|spec| *get(spec) = key);
                }>
                    {columns().map(|column| view! {
                        <option value=column.key selected=move || *get(&mut spec.get()) == column.key>{column.label}</option>
                    }).collect_view()}
                </select>
            </label>
        }
    };
    view! {
        <div class="columns">
            <h3>"Any over any"</h3>
            {list("Plot", |spec| &mut spec.y)}
            {list("over", |spec| &mut spec.x)}
        </div>
    }
}
