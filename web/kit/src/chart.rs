//! Figure on a canvas with a cursor.

use crate::observe;
use leptos::ev::{KeyboardEvent, PointerEvent};
use leptos::html::{Canvas, Div};
use leptos::prelude::*;
use msape_plot::{CanvasSize, Figure, Mapping, Theme, canvas, summary};

/// Draws a figure and moves a cursor along the points of its first series.
#[component]
pub fn Chart(
    /// Name for those who do not see it.
    #[prop(into)]
    title: Signal<String>,
    /// The figure.
    #[prop(into)]
    figure: Signal<Figure>,
    /// Points of its first series.
    #[prop(into)]
    points: Signal<Vec<(f64, f64)>>,
    /// Whether x increases along the points, so that the nearest is sought along x alone.
    #[prop(into)]
    along_x: Signal<bool>,
    /// Whether the page is dark.
    #[prop(into)]
    dark: Signal<bool>,
    /// Index of the point at the cursor; charts may share it.
    cursor: RwSignal<Option<usize>>,
    /// Set to whether the chart has the focus.
    focused: RwSignal<bool>,
    /// Whether the chart has no cursor.
    #[prop(optional)]
    still: bool,
) -> impl IntoView {
    let frame = NodeRef::<Div>::new();
    let surface = NodeRef::<Canvas>::new();
    let size = RwSignal::new((0.0, 0.0));
    let mapping = RwSignal::new(None::<Mapping>);
    let in_view = RwSignal::new(true);
    observe::size(frame, size);
    observe::in_view(frame, in_view);

    let draw = move || {
        let (width_px, height_px) = size.get();
        let theme = theme(dark.get());
        let Some(element) = surface.get() else {
            return;
        };
        if width_px < 1.0 || height_px < 1.0 {
            return;
        }
        let size = CanvasSize {
            width_px,
            height_px,
            device_pixel_ratio: window().device_pixel_ratio(),
        };
        match figure.with(|figure| canvas(figure, &theme, &element, size)) {
            Ok(drawn) => mapping.set(Some(drawn)),
            Err(error) => leptos::logging::error!("the chart cannot be drawn: {error:?}"),
        }
    };
    let newest = StoredValue::new(0_u64);
    Effect::new(move |_| {
        newest.update_value(|count| *count += 1);
        if in_view.get() {
            draw();
            return;
        }
        // a chart out of sight waits until the edits pause
        let this = newest.get_value();
        figure.track();
        let draw_later = move || {
            if newest.try_get_value() == Some(this) {
                untrack(draw);
            }
        };
        set_timeout(draw_later, std::time::Duration::from_millis(300));
    });

    let at_cursor = Memo::new(move |_| {
        let row = cursor.get().filter(|_| !still)?;
        points.with(|points| points.get(row.min(points.len().checked_sub(1)?)).copied())
    });
    let place = move || {
        let (x, y) = at_cursor.get()?;
        let mapping = mapping.get()?;
        let place = (mapping.x.px(x)?, mapping.y.px(y)?);
        mapping
            .plot
            .contains(place)
            .then_some((mapping, place.0, place.1))
    };
    let point = move |event: PointerEvent| {
        let Some(mapping) = mapping.get_untracked().filter(|_| !still) else {
            return;
        };
        let at = (f64::from(event.offset_x()), f64::from(event.offset_y()));
        let row =
            points.with_untracked(|points| nearest(points, &mapping, at, along_x.get_untracked()));
        cursor.set(row);
    };
    let on_key = move |event: KeyboardEvent| {
        let count = points.with_untracked(Vec::len);
        let last = count.saturating_sub(1);
        let step = if event.shift_key() {
            (count / 20).max(1)
        } else {
            1
        };
        let now = cursor.get_untracked();
        let next = match event.key().as_str() {
            "ArrowRight" => Some(now.map_or(0, |row| (row + step).min(last))),
            "ArrowLeft" => Some(now.map_or(last, |row| row.saturating_sub(step))),
            "Home" => Some(0),
            "End" => Some(last),
            "Escape" => None,
            _ => return,
        };
        if still {
            return;
        }
        event.prevent_default();
        cursor.set(next.filter(|_| count > 0));
    };
    let description = move || {
        let title = title.get();
        let words = figure.with(summary);
        let keys = if still {
            ""
        } else {
            " Left and right arrow keys move the cursor."
        };
        format!("{title}. {words}{keys}")
    };

    view! {
        <div
            class="chart"
            node_ref=frame
            role=if still { "img" } else { "application" }
            aria-roledescription=(!still).then_some("chart")
            tabindex=(!still).then_some("0")
            aria-label=description
            on:keydown=on_key
            on:focus=move |_| focused.set(true)
            on:blur=move |_| focused.set(false)
            on:pointermove=point
            on:pointerdown=point
            on:pointerleave=move |_| cursor.set(None)
        >
            <canvas node_ref=surface aria-hidden="true"></canvas>
            <svg class="chart-cursor" aria-hidden="true" focusable="false">
                {move || place().map(|(mapping, x, y)| view! {
                    <line x1=x x2=x y1=mapping.plot.top_px y2=mapping.plot.bottom_px></line>
                    <circle cx=x cy=y r="4.5"></circle>
                })}
            </svg>
        </div>
    }
}

/// Theme of figures.
pub fn theme(dark: bool) -> Theme {
    if dark { Theme::dark() } else { Theme::light() }
}

/// Row of the point nearest to a position: along x where x increases with the rows, else in the plane.
fn nearest(
    points: &[(f64, f64)],
    mapping: &Mapping,
    (x_px, y_px): (f64, f64),
    along_x: bool,
) -> Option<usize> {
    let distance = |(x, y): &(f64, f64)| {
        let dx = mapping.x.px(*x)? - x_px;
        let dy = if along_x {
            0.0
        } else {
            mapping.y.px(*y)? - y_px
        };
        Some(dx * dx + dy * dy)
    };
    points
        .iter()
        .enumerate()
        .filter_map(|(row, point)| Some((row, distance(point)?)))
        .min_by(|a, b| a.1.total_cmp(&b.1))
        .map(|(row, _)| row)
}
