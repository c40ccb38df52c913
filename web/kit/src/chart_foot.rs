//! Footer of a chart: reading, table, exports.

use crate::chart::theme;
use crate::files;
use leptos::prelude::*;
use msape_plot::{CanvasSize, Figure, canvas, csv, svg};
use wasm_bindgen::{JsCast, JsValue};
use web_sys::HtmlCanvasElement;

/// Size of exported images, CSS px.
const EXPORT_PX: (u32, u32) = (800, 500);

/// Reading, table and exports of a figure.
#[component]
pub fn ChartFoot(
    /// Name of the figure.
    #[prop(into)]
    title: Signal<String>,
    /// The figure.
    #[prop(into)]
    figure: Signal<Figure>,
    /// Values at the cursor.
    #[prop(into)]
    reading: Signal<Option<String>>,
    /// Whether this chart has the focus: only that chart is announced.
    focused: RwSignal<bool>,
    /// Whether the table is shown.
    table_open: RwSignal<bool>,
    /// File name without extension.
    #[prop(into)]
    stem: Signal<String>,
    /// Gets the result of each export.
    #[prop(into)]
    on_saved: Callback<Result<(), JsValue>>,
) -> impl IntoView {
    let name = move |extension| files::file_name(&stem.get_untracked(), extension);
    view! {
        <div class="chart-foot">
            <p class="reading" aria-live=move || if focused.get() { "polite" } else { "off" }>{move || reading.get().unwrap_or_else(|| "\u{a0}".to_string())}</p>
            <div class="tools">
                <button type="button" class="small" aria-pressed=move || table_open.get().to_string()
                    aria-label=move || format!("Table of {}", title.get())
                    on:click=move |_| table_open.update(|open| *open = !*open)>"Table"</button>
                <button type="button" class="small" aria-label=move || format!("SVG of {}", title.get())
                    on:click=move |_| on_saved.run(files::download(&name("svg"), "image/svg+xml", &drawn(&figure.get_untracked(), &title.get_untracked())))>"SVG"</button>
                <button type="button" class="small" aria-label=move || format!("PNG of {}", title.get())
                    on:click=move |_| on_saved.run(png(&figure.get_untracked(), name("png")))>"PNG"</button>
                <button type="button" class="small" aria-label=move || format!("CSV of {}", title.get())
                    on:click=move |_| on_saved.run(files::download(&name("csv"), "text/csv", &csv(&figure.get_untracked())))>"CSV"</button>
            </div>
        </div>
    }
}

/// A figure with its title as SVG.
fn drawn(figure: &Figure, title: &str) -> String {
    let titled = Figure {
        title: Some(title.to_string()),
        ..figure.clone()
    };
    svg(&titled, &theme(false), EXPORT_PX.0, EXPORT_PX.1)
}

/// Offers a figure for download as PNG.
///
/// # Errors
/// Errors of the browser.
fn png(figure: &Figure, name: String) -> Result<(), JsValue> {
    let element: HtmlCanvasElement = document().create_element("canvas")?.unchecked_into();
    let size = CanvasSize {
        width_px: f64::from(EXPORT_PX.0),
        height_px: f64::from(EXPORT_PX.1),
        device_pixel_ratio: 2.0,
    };
    canvas(figure, &theme(false), &element, size)?;
    files::download_png(name, &element)
}
