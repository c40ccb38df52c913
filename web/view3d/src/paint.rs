//! Colors of the view: from the style sheet, of materials, and of a scale.

use web_sys::{HtmlElement, window};

/// Red, green and blue, from 0 to 1.
pub type Color = [f32; 3];

/// Color scale from zero to the largest value: dark to light, distinguishable without hue.
pub const SCALE: [Color; 6] = [
    [0.20, 0.10, 0.36],
    [0.46, 0.14, 0.46],
    [0.71, 0.22, 0.38],
    [0.90, 0.39, 0.22],
    [0.98, 0.63, 0.20],
    [0.99, 0.91, 0.60],
];

/// Colors of materials, in order of appearance.
const MATERIALS: [Color; 12] = [
    [0.33, 0.47, 0.65],
    [0.95, 0.56, 0.17],
    [0.35, 0.63, 0.31],
    [0.88, 0.34, 0.35],
    [0.46, 0.72, 0.70],
    [0.93, 0.79, 0.28],
    [0.69, 0.48, 0.63],
    [1.00, 0.62, 0.65],
    [0.61, 0.46, 0.37],
    [0.73, 0.69, 0.67],
    [0.20, 0.60, 0.80],
    [0.55, 0.60, 0.20],
];

/// Color of the material with this index.
pub fn of_material(place: usize) -> Color {
    MATERIALS[place % MATERIALS.len()]
}

/// CSS notation of a color.
pub fn css(color: Color) -> String {
    let [r, g, b] = color.map(|part| (part * 255.0).round() as u8);
    format!("rgb({r}, {g}, {b})")
}

/// Text color of an element; follows forced colors.
pub fn ink(element: &HtmlElement) -> Color {
    style(element, "color").unwrap_or([0.5; 3])
}

/// Background color of an element; follows forced colors.
pub fn ground(element: &HtmlElement) -> Color {
    style(element, "background-color").unwrap_or([1.0; 3])
}

/// Color of a style-sheet variable.
pub fn variable(element: &HtmlElement, name: &str) -> Color {
    style(element, name).unwrap_or([0.5; 3])
}

fn style(element: &HtmlElement, property: &str) -> Option<Color> {
    let styles = window()?.get_computed_style(element).ok()??;
    parsed(styles.get_property_value(property).ok()?.trim())
}

/// Color in the notation `#rrggbb`, `rgb(…)` or `rgba(…)`.
fn parsed(text: &str) -> Option<Color> {
    if let Some(hex) = text.strip_prefix('#') {
        let part = |i: usize| {
            let byte = u8::from_str_radix(hex.get(i..i + 2)?, 16).ok()?;
            Some(f32::from(byte) / 255.0)
        };
        return Some([part(0)?, part(2)?, part(4)?]);
    }
    let inside = text.split_once('(')?.1.trim_end_matches(')');
    let mut parts = inside
        .split([',', ' ', '/'])
        .filter(|part| !part.is_empty())
        .map(|part| part.parse::<f32>().ok());
    let mut next = || Some(parts.next()?? / 255.0);
    Some([next()?, next()?, next()?])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colors_of_the_style_sheet_are_read() {
        assert_eq!(parsed("#ff0033"), Some([1.0, 0.0, 0.2]));
        assert_eq!(parsed("rgb(255, 0, 51)"), Some([1.0, 0.0, 0.2]));
        assert_eq!(parsed("rgba(0 0 0 / 0.5)"), Some([0.0; 3]));
        assert_eq!(parsed("red"), None);
        assert_eq!(css([1.0, 0.0, 0.2]), "rgb(255, 0, 51)");
    }
}
