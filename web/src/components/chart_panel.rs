//! A chart with its reading, its table twin and its exports.

use crate::charts::{ChartSpec, Span};
use crate::components::chart::{Chart, theme};
use crate::components::chart_table::ChartTable;
use crate::display::{number, symbol};
use crate::files;
use crate::state::State;

use leptos::prelude::*;
use msape::Answer;
use msape::quantity::trajectory::{columns, find};
use msape_plot::{CanvasSize, Figure, canvas, csv, svg};
use std::sync::Arc;
use wasm_bindgen::JsCast;
use web_sys::HtmlCanvasElement;

/// Size of exported drawings, CSS px.
const EXPORT_PX: (u32, u32) = (800, 500);

/// A chart of one column over another.
#[component]
pub fn ChartPanel(
    spec: RwSignal<ChartSpec>,
    span: RwSignal<Span>,
    /// Whether the columns can be chosen.
    #[prop(optional)]
    free: bool,
    /// The answer whose flight is drawn, in the place of the newest.
    #[prop(optional)]
    answer: Option<Signal<Option<Arc<Answer>>>>,
    /// A cursor of its own.
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
    // Of all charts, only the one with the focus speaks.
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
    let name = move |extension| files::file_name(&title.get_untracked(), extension);

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
            <div class="chart-foot">
                <p class="reading" aria-live=move || if focused.get() { "polite" } else { "off" }>{move || reading().unwrap_or_else(|| "\u{a0}".to_string())}</p>
                <div class="tools">
                    <button type="button" class="small" aria-pressed=move || table_open.get().to_string()
                        aria-label=move || format!("Table of {}", title.get())
                        on:click=move |_| table_open.update(|open| *open = !*open)>"Table"</button>
                    <button type="button" class="small" aria-label=move || format!("SVG of {}", title.get())
                        on:click=move |_| save(state, files::download(&name("svg"), "image/svg+xml", &drawn(&figure.get_untracked(), &title.get_untracked())))>"SVG"</button>
                    <button type="button" class="small" aria-label=move || format!("PNG of {}", title.get())
                        on:click=move |_| save(state, png(&figure.get_untracked(), name("png")))>"PNG"</button>
                    <button type="button" class="small" aria-label=move || format!("CSV of {}", title.get())
                        on:click=move |_| save(state, files::download(&name("csv"), "text/csv", &csv(&figure.get_untracked())))>"CSV"</button>
                </div>
            </div>
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
                    {columns().iter().map(|column| view! {
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

/// A figure with its title as SVG.
pub fn drawn(figure: &Figure, title: &str) -> String {
    let titled = Figure {
        title: Some(title.to_string()),
        ..figure.clone()
    };
    svg(&titled, &theme(false), EXPORT_PX.0, EXPORT_PX.1)
}

/// Hands a figure to the user as PNG.
///
/// # Errors
/// What the browser refuses.
pub fn png(figure: &Figure, name: String) -> Result<(), wasm_bindgen::JsValue> {
    let element: HtmlCanvasElement = document().create_element("canvas")?.unchecked_into();
    let size = CanvasSize {
        width_px: f64::from(EXPORT_PX.0),
        height_px: f64::from(EXPORT_PX.1),
        device_pixel_ratio: 2.0,
    };
    canvas(figure, &theme(false), &element, size)?;
    files::download_png(name, &element)
}

/// Says what became of an export.
pub fn save(state: State, result: Result<(), wasm_bindgen::JsValue>) {
    state.notice.set(match result {
        Ok(()) => "Exported.".to_string(),
        Err(error) => format!("The browser refused the export: {error:?}"),
    });
}
