//! Numbers of a chart, in pages.

use crate::display::number;
use leptos::ev::KeyboardEvent;
use leptos::prelude::*;
use msape_plot::Figure;

/// Rows per page.
const ROWS: usize = 25;

/// Target page of a pager button or key, from the current and the last page, all from 0.
type Turn = fn(usize, usize) -> usize;

/// Pager buttons: label, accessible name, target.
const TURNS: [(&str, &str, Turn); 4] = [
    ("First", "First rows", |_, _| 0),
    ("Previous", "Previous rows", |now, _| now.saturating_sub(1)),
    ("Next", "Next rows", |now, last| (now + 1).min(last)),
    ("Last", "Last rows", |_, last| last),
];

/// Table of a chart.
#[component]
pub fn ChartTable(
    /// The figure.
    #[prop(into)]
    figure: Signal<Figure>,
    /// Its name.
    #[prop(into)]
    title: Signal<String>,
) -> impl IntoView {
    let page = RwSignal::new(0_usize);
    let points =
        Memo::new(move |_| figure.with(|figure| Some(figure.series.first()?.points.clone())));
    let count = Memo::new(move |_| points.with(|points| points.as_ref().map_or(0, Vec::len)));
    let last = Memo::new(move |_| last_page(count.get()));
    let now = Memo::new(move |_| page.get().min(last.get()));
    let rows = move || {
        let (from, to) = rows_of(now.get(), count.get());
        points.with(|points| {
            let points = points.iter().flatten();
            points
                .skip(from)
                .take(to - from)
                .copied()
                .collect::<Vec<_>>()
        })
    };
    let turn = move |turn: Turn| page.set(turn(now.get_untracked(), last.get_untracked()));
    let on_key = move |event: KeyboardEvent| {
        if let Some(found) = turn_of_key(&event.key()) {
            turn(found);
            event.prevent_default();
        }
    };
    let shown = move || {
        let (from, to) = rows_of(now.get(), count.get());
        let first = if to > from { from + 1 } else { 0 };
        format!("rows {first}-{to} of {}", count.get())
    };
    view! {
        <div class="chart-table" on:keydown=on_key>
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
            <div class="pager" role="group" aria-label="Rows of the table">
                {TURNS.map(|(words, label, leads)| {
                    // a button without effect keeps the focus, so that keyboard users do not lose it
                    let leads_nowhere = move || leads(now.get(), last.get()) == now.get();
                    view! {
                        <button type="button" class="small" aria-label=label
                            aria-disabled=move || leads_nowhere().to_string()
                            on:click=move |_| turn(leads)>{words}</button>
                    }
                })}
                <span role="status">{shown}</span>
            </div>
        </div>
    }
}

/// Index of the last page for a number of rows, from 0.
fn last_page(count: usize) -> usize {
    count.div_ceil(ROWS).saturating_sub(1)
}

/// First row of a page and the one after its last, from 0.
fn rows_of(page: usize, count: usize) -> (usize, usize) {
    let from = (page * ROWS).min(count);
    (from, (from + ROWS).min(count))
}

fn turn_of_key(key: &str) -> Option<Turn> {
    let at = match key {
        "Home" => 0,
        "PageUp" => 1,
        "PageDown" => 2,
        "End" => 3,
        _ => return None,
    };
    TURNS.get(at).map(|(_, _, turn)| *turn)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turning_shows_every_row_once_and_ends() {
        for count in [0, 1, 25, 26, 50, 1003] {
            let last = last_page(count);
            let (mut page, mut seen) = (0, Vec::new());
            loop {
                let (from, to) = rows_of(page, count);
                seen.extend(from..to);
                let next = turn_of_key("PageDown").unwrap()(page, last);
                if next == page {
                    break;
                }
                page = next;
            }
            assert_eq!(seen, (0..count).collect::<Vec<_>>());
            assert_eq!(turn_of_key("End").unwrap()(0, last), page);
            assert_eq!(turn_of_key("Home").unwrap()(page, last), 0);
            assert_eq!(
                turn_of_key("PageUp").unwrap()(page, last),
                page.saturating_sub(1)
            );
        }
    }
}
