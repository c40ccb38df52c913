//! The numbers of a chart, a page at a time.

use crate::display::number;
use leptos::prelude::*;
use msape_plot::Figure;

/// Rows on a page.
const ROWS: usize = 25;

/// The table twin of a chart.
#[component]
pub fn ChartTable(figure: Memo<Figure>, title: Signal<String>) -> impl IntoView {
    let page = RwSignal::new(0_usize);
    let count = Memo::new(move |_| {
        figure.with(|figure| {
            figure
                .series
                .first()
                .map_or(0, |series| series.points.len())
        })
    });
    let pages = move || count.get().div_ceil(ROWS).max(1);
    let now = Memo::new(move |_| page.get().min(pages() - 1));
    let rows = move || {
        figure.with(|figure| {
            figure
                .series
                .first()
                .map(|series| {
                    let start = now.get() * ROWS;
                    series
                        .points
                        .iter()
                        .skip(start)
                        .take(ROWS)
                        .copied()
                        .collect::<Vec<_>>()
                })
                .unwrap_or_default()
        })
    };
    view! {
        <div class="chart-table">
            <table>
                <caption class="hidden-visually">{title}</caption>
                <thead>
                    <tr>
                        <th scope="col">{move || figure.with(|figure| figure.x.caption())}</th>
                        <th scope="col">{move || figure.with(|figure| figure.y.caption())}</th>
                    </tr>
                </thead>
                <tbody>
                    {move || rows().into_iter().map(|(x, y)| view! {
                        <tr><td>{number(x, 6)}</td><td>{number(y, 6)}</td></tr>
                    }).collect_view()}
                </tbody>
            </table>
            <div class="pager">
                <button type="button" class="small" disabled=move || now.get() == 0
                    on:click=move |_| page.set(now.get_untracked().saturating_sub(1))>"Previous rows"</button>
                <span>{move || format!("{} to {} of {}", now.get() * ROWS + 1, ((now.get() + 1) * ROWS).min(count.get()), count.get())}</span>
                <button type="button" class="small" disabled=move || now.get() + 1 >= pages()
                    on:click=move |_| page.set(now.get_untracked() + 1)>"Next rows"</button>
            </div>
        </div>
    }
}
