//! A figure of several curves with its reading, its table twin and its exports.

use crate::charts::ChartSpec;
use crate::components::chart::Chart;
use crate::components::chart_panel::{drawn, png, save};
use crate::display::number;
use crate::files;
use crate::state::State;
use leptos::prelude::*;
use msape_plot::{Figure, csv, readings, table};

/// Most rows of the table twin; the file has all of them.
const ROWS: usize = 46;

/// A figure whose curves share one cursor.
#[component]
pub fn FigurePanel(
    #[prop(into)] title: Signal<String>,
    figure: Memo<Figure>,
    /// Begins the names of files.
    #[prop(into)]
    stem: Signal<String>,
    /// What stands below the figure.
    #[prop(optional, into)]
    note: ViewFn,
) -> impl IntoView {
    let state = State::expect();
    let cursor = RwSignal::new(None::<usize>);
    let focused = RwSignal::new(false);
    let table_open = RwSignal::new(false);
    let points = Memo::new(move |_| {
        figure.with(|figure| {
            let first = figure.series.first();
            first
                .map(|series| series.points.clone())
                .unwrap_or_default()
        })
    });
    let reading = move || {
        let row = cursor.get()?;
        let (x, _) = points.with(|points| points.get(row).copied())?;
        Some(figure.with(|figure| {
            let values = readings(figure, x)
                .into_iter()
                .map(|reading| format!("{} {}", reading.name, reading.text));
            let values: Vec<String> = values.collect();
            let at = format!("{} {} {}", figure.x.label, number(x, 4), figure.x.unit);
            format!("{}: {}", at.trim_end(), values.join("; "))
        }))
    };
    let name = move |extension| {
        files::file_name(
            &format!("{} {}", stem.get_untracked(), title.get_untracked()),
            extension,
        )
    };
    let spec = Signal::stored(ChartSpec {
        x: String::new(),
        y: String::new(),
    });
    let twin = move || figure.with(|figure| table(figure, ROWS));
    view! {
        <figure class="chart-panel">
            <figcaption><h3>{title}</h3></figcaption>
            <Chart title spec figure points focused cursor=cursor />
            {note.run()}
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
                <div class="chart-table wide-table" tabindex="0" role="region" aria-label=move || format!("Numbers of {}", title.get())>
                    <table>
                        <thead><tr>{move || twin().header.into_iter().map(|text| view! { <th scope="col">{text}</th> }).collect_view()}</tr></thead>
                        <tbody>
                            {move || twin().rows.into_iter().map(|row| view! {
                                <tr>{row.into_iter().map(|text| view! { <td>{text}</td> }).collect_view()}</tr>
                            }).collect_view()}
                        </tbody>
                    </table>
                    <p class="quiet">{move || { let twin = twin(); format!("{} of {} rows; the CSV has all of them.", twin.rows.len(), twin.total) }}</p>
                </div>
            </Show>
        </figure>
    }
}
