//! Drawing of a figure as SVG: text stays text, and the same figure gives the same bytes everywhere.

use crate::figure::Figure;
use crate::paint::{Frame, draw};
use crate::summary::summary;
use crate::theme::Theme;
use plotters::prelude::{IntoDrawingArea, SVGBackend};

/// Backend units per CSS px: a tenth of a px is fine enough for print.
const UNITS_PER_PX: f64 = 10.0;
/// Divisor that plotters' SVG backend applies to font sizes.
const FONT_DIVISOR: f64 = 1.24;
/// Downward shift of text, in font sizes: the backend centers lower-case letters; digits and capitals are centered
/// lower.
const TEXT_DROP_EM: f64 = 0.1;

/// The figure as an SVG document with title and description.
pub fn svg(figure: &Figure, theme: &Theme, width_px: u32, height_px: u32) -> String {
    let frame = Frame {
        width_px: f64::from(width_px),
        height_px: f64::from(height_px),
        units_per_px: UNITS_PER_PX,
        font_divisor: FONT_DIVISOR,
        text_drop_em: TEXT_DROP_EM,
    };
    let units = |px: u32| px.saturating_mul(UNITS_PER_PX as u32);
    let mut drawn = String::new();
    {
        let size = (units(width_px), units(height_px));
        let area = SVGBackend::with_string(&mut drawn, size).into_drawing_area();
        // writing to a string cannot fail
        let done = draw(figure, theme, &frame, &area).is_ok() && area.present().is_ok();
        debug_assert!(done);
    }
    let body = drawn.split_once('\n').map_or("", |(_, body)| body);
    let title = escaped(figure.title.as_deref().unwrap_or(&figure.y.label));
    let description = escaped(&match figure.description.is_empty() {
        true => summary(figure),
        false => figure.description.clone(),
    });
    let (width, height) = (units(width_px), units(height_px));
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" width=\"{width_px}\" \
         height=\"{height_px}\" viewBox=\"0 0 {width} {height}\" stroke-linejoin=\"round\">\n\
         <title>{title}</title>\n<desc>{description}</desc>\n{body}"
    )
}

/// Text escaped for an element; characters that XML does not allow are removed.
fn escaped(text: &str) -> String {
    let mut safe = String::new();
    for c in text.chars() {
        match c {
            '<' => safe.push_str("&lt;"),
            '>' => safe.push_str("&gt;"),
            '&' => safe.push_str("&amp;"),
            // noncharacters, not allowed in XML
            '\u{fffe}' | '\u{ffff}' => {}
            c if c.is_control() => safe.push(' '),
            c => safe.push(c),
        }
    }
    safe
}
