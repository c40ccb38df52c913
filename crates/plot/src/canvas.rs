//! A figure on an HTML canvas.

use crate::figure::Figure;
use crate::mapping::Mapping;
use crate::paint::{Frame, draw};
use crate::theme::Theme;
use plotters::prelude::{DrawingBackend, IntoDrawingArea};
use plotters_backend::{
    BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingErrorKind,
};
use plotters_canvas::CanvasBackend;
use wasm_bindgen::{JsCast, JsValue};
use web_sys::{CanvasRenderingContext2d, HtmlCanvasElement};

/// Plotters places by whole numbers; this many to a CSS px make lines smooth on any screen.
const UNITS_PER_PX: f64 = 16.0;

/// Result of drawing on a canvas.
type Drawn = Result<(), DrawingErrorKind<<CanvasBackend as DrawingBackend>::ErrorType>>;

/// A canvas that counts in finer units than those of its bitmap, for which its context is scaled:
/// plotters holds everything inside the size that the backend gives.
struct FineCanvas {
    inner: CanvasBackend,
    size: (u32, u32),
}

impl DrawingBackend for FineCanvas {
    type ErrorType = <CanvasBackend as DrawingBackend>::ErrorType;

    fn get_size(&self) -> (u32, u32) {
        self.size
    }

    fn ensure_prepared(&mut self) -> Drawn {
        self.inner.ensure_prepared()
    }

    fn present(&mut self) -> Drawn {
        self.inner.present()
    }

    fn draw_pixel(&mut self, point: BackendCoord, color: BackendColor) -> Drawn {
        self.inner.draw_pixel(point, color)
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        path: I,
        style: &S,
    ) -> Drawn {
        self.inner.draw_path(path, style)
    }

    fn fill_polygon<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        vertices: I,
        style: &S,
    ) -> Drawn {
        self.inner.fill_polygon(vertices, style)
    }

    fn draw_circle<S: BackendStyle>(
        &mut self,
        center: BackendCoord,
        radius: u32,
        style: &S,
        fill: bool,
    ) -> Drawn {
        self.inner.draw_circle(center, radius, style, fill)
    }

    fn draw_text<S: BackendTextStyle>(
        &mut self,
        text: &str,
        style: &S,
        place: BackendCoord,
    ) -> Drawn {
        self.inner.draw_text(text, style, place)
    }
}

/// Size of a canvas on the page and px of the screen in a CSS px.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CanvasSize {
    /// Width, CSS px.
    pub width_px: f64,
    /// Height, CSS px.
    pub height_px: f64,
    /// `window.devicePixelRatio`.
    pub device_pixel_ratio: f64,
}

/// Draws a figure on a canvas, whose bitmap is made as fine as the screen. Its size on the page is
/// left to the page's style.
///
/// # Errors
/// What the browser refuses: a context, or drawing on it.
pub fn canvas(
    figure: &Figure,
    theme: &Theme,
    element: &HtmlCanvasElement,
    size: CanvasSize,
) -> Result<Mapping, JsValue> {
    let ratio = if size.device_pixel_ratio > 0.0 {
        size.device_pixel_ratio
    } else {
        1.0
    };
    let bitmap = |px: f64| (px * ratio).round().max(1.0) as u32;
    let (width, height) = (bitmap(size.width_px), bitmap(size.height_px));
    // Setting a size empties the bitmap even if nothing changes.
    if element.width() != width || element.height() != height {
        element.set_width(width);
        element.set_height(height);
    }
    let context: CanvasRenderingContext2d = element
        .get_context("2d")?
        .ok_or_else(|| JsValue::from_str("no 2d context"))?
        .dyn_into()?;
    let scale = ratio / UNITS_PER_PX;
    context.set_transform(scale, 0.0, 0.0, scale, 0.0, 0.0)?;
    context.set_line_join("round");
    let frame = Frame::new(size.width_px, size.height_px, UNITS_PER_PX);
    let inner = CanvasBackend::with_canvas_object(element.clone())
        .ok_or_else(|| JsValue::from_str("no 2d context"))?;
    let units = |px: f64| (px * UNITS_PER_PX).ceil().max(1.0) as u32;
    let size = (units(size.width_px), units(size.height_px));
    let area = FineCanvas { inner, size }.into_drawing_area();
    draw(figure, theme, &frame, &area).map_err(|e| JsValue::from_str(&e.to_string()))
}
