//! Drawing of a figure on an HTML canvas.

use crate::figure::Figure;
use crate::mapping::Mapping;
use crate::paint::{Frame, draw};
use crate::theme::Theme;
use plotters::drawing::DrawingAreaErrorKind;
use plotters::prelude::{DrawingBackend, IntoDrawingArea};
use plotters_backend::{
    BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingErrorKind,
};
use plotters_canvas::CanvasBackend;
use wasm_bindgen::{JsCast, JsValue};
use web_sys::{CanvasRenderingContext2d, HtmlCanvasElement};

/// Backend units per CSS px: plotters uses integer coordinates, and this many units make lines smooth on any screen.
const UNITS_PER_PX: f64 = 16.0;

/// Result of drawing on a canvas.
type Drawn = Result<(), DrawingErrorKind<<CanvasBackend as DrawingBackend>::ErrorType>>;

/// Canvas with coordinates finer than the pixels of its bitmap, to which its context is scaled: plotters clips
/// everything to the size reported by the backend.
///
/// Lines of the same color and width are collected into one path, which a browser draws many times faster than separate
/// dashes.
struct FineCanvas {
    inner: CanvasBackend,
    context: CanvasRenderingContext2d,
    size: (u32, u32),
    /// Color and width of the collected lines, if there are any.
    look: Option<((u8, u8, u8), f64, u32)>,
}

impl FineCanvas {
    /// Draws the collected lines.
    fn flush(&mut self) {
        if self.look.take().is_some() {
            self.context.stroke();
        }
    }
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
        self.flush();
        self.inner.present()
    }

    fn draw_pixel(&mut self, point: BackendCoord, color: BackendColor) -> Drawn {
        self.flush();
        self.inner.draw_pixel(point, color)
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        path: I,
        style: &S,
    ) -> Drawn {
        let BackendColor { rgb, alpha } = style.color();
        let look = Some((rgb, alpha, style.stroke_width()));
        // translucent lines are drawn separately, so that crossings are visible
        if self.look != look || alpha < 1.0 {
            self.flush();
            let (r, g, b) = rgb;
            self.context
                .set_stroke_style_str(&format!("rgba({r},{g},{b},{alpha})"));
            self.context.set_line_width(f64::from(style.stroke_width()));
            self.context.begin_path();
            self.look = look;
        }
        let mut points = path.into_iter();
        if let Some((x, y)) = points.next() {
            self.context.move_to(f64::from(x), f64::from(y));
        }
        for (x, y) in points {
            self.context.line_to(f64::from(x), f64::from(y));
        }
        Ok(())
    }

    fn fill_polygon<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        vertices: I,
        style: &S,
    ) -> Drawn {
        self.flush();
        self.inner.fill_polygon(vertices, style)
    }

    fn draw_circle<S: BackendStyle>(
        &mut self,
        center: BackendCoord,
        radius: u32,
        style: &S,
        fill: bool,
    ) -> Drawn {
        self.flush();
        self.inner.draw_circle(center, radius, style, fill)
    }

    fn draw_text<S: BackendTextStyle>(
        &mut self,
        text: &str,
        style: &S,
        place: BackendCoord,
    ) -> Drawn {
        self.flush();
        self.inner.draw_text(text, style, place)
    }
}

/// Size of a canvas on the page, and screen pixels per CSS px.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CanvasSize {
    /// Width, CSS px.
    pub width_px: f64,
    /// Height, CSS px.
    pub height_px: f64,
    /// `window.devicePixelRatio`.
    pub device_pixel_ratio: f64,
}

/// Draws a figure on a canvas, whose bitmap gets the resolution of the screen. Its size on the page is left to the
/// style sheet.
///
/// # Errors
/// Browser errors: no context, or a failed drawing operation.
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
    // setting a size clears the bitmap even if the size stays the same
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
    let area = FineCanvas {
        inner,
        context,
        size,
        look: None,
    }
    .into_drawing_area();
    let fault = |e: DrawingAreaErrorKind<_>| JsValue::from_str(&e.to_string());
    let mapping = draw(figure, theme, &frame, &area).map_err(fault)?;
    area.present().map_err(fault)?;
    Ok(mapping)
}
