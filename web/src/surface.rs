//! Drawing on a canvas, which there is in the browser only; elsewhere the app is built to be tested.

#[cfg(target_arch = "wasm32")]
pub use msape_plot::{CanvasSize, canvas};

/// Stands for the canvas of the browser.
#[cfg(not(target_arch = "wasm32"))]
pub struct CanvasSize {
    /// Width, CSS px.
    pub width_px: f64,
    /// Height, CSS px.
    pub height_px: f64,
    /// `window.devicePixelRatio`.
    pub device_pixel_ratio: f64,
}

/// Draws nothing.
///
/// # Errors
/// Always: there is no canvas.
#[cfg(not(target_arch = "wasm32"))]
pub fn canvas(
    _: &msape_plot::Figure,
    _: &msape_plot::Theme,
    _: &web_sys::HtmlCanvasElement,
    size: CanvasSize,
) -> Result<msape_plot::Mapping, wasm_bindgen::JsValue> {
    let CanvasSize {
        width_px,
        height_px,
        device_pixel_ratio,
    } = size;
    let _ = (width_px, height_px, device_pixel_ratio);
    Err(wasm_bindgen::JsValue::NULL)
}
