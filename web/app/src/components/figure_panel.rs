//! Figure of several curves with its reading, table and exports.

use crate::charts::ChartSpec;
use crate::components::chart::Chart;
use crate::components::chart::ChartFoot;
use leptos::prelude::*;
use msape_kit::display::number;
use msape_plot::{Figure, readings, table};

/// Largest number of rows of the table; the file has all of them.
const ROWS: usize = 46;

/// Figure whose curves share one cursor.
#[component]
pub fn FigurePanel(
    #[prop(into)] title: Signal<String>,
    figure: Memo<Figure>,
    /// Prefix of file names.
    #[prop(into)]
    stem: Signal<String>,
    /// Content below the figure.
    #[prop(optional, into)]
    note: ViewFn,
) -> impl IntoView {
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
    let file = Signal::derive(move || format!("{} {}", stem.get(), title.get()));
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
            <ChartFoot title figure reading=Signal::derive(reading) focused table_open stem=file />
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
