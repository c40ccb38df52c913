//! Colors, font and line widths of a figure.
//!
//! The palette has the hues of Okabe and Ito, which are distinguishable with any color vision, darkened (lightened on a
//! dark background) where a line would have less than 3 : 1 contrast.

/// An opaque color: red, green, blue.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rgb(pub u8, pub u8, pub u8);

/// Colors, font and line widths of a figure.
#[derive(Clone, Debug, PartialEq)]
pub struct Theme {
    /// Background of figure and plot.
    pub background: Rgb,
    /// Title and captions.
    pub text: Rgb,
    /// Tick labels and event labels.
    pub muted: Rgb,
    /// Axis lines and ticks.
    pub axis: Rgb,
    /// Major grid, at labeled ticks.
    pub grid: Rgb,
    /// Minor grid.
    pub minor_grid: Rgb,
    /// Event lines.
    pub event: Rgb,
    /// Limit lines and their labels.
    pub limit: Rgb,
    /// Cursor.
    pub cursor: Rgb,
    /// Colors of series.
    pub palette: [Rgb; 8],
    /// Font families, as in CSS.
    pub font_family: String,
    /// Font size of captions, px; tick and event labels are slightly smaller.
    pub font_size_px: f64,
    /// Width of series lines, px.
    pub line_width_px: f64,
}

const FAMILY: &str = "system-ui, -apple-system, 'Segoe UI', Roboto, Helvetica, Arial, sans-serif";

impl Theme {
    /// Dark on white.
    pub fn light() -> Self {
        Self {
            background: Rgb(0xFF, 0xFF, 0xFF),
            text: Rgb(0x1B, 0x1F, 0x24),
            muted: Rgb(0x52, 0x5A, 0x65),
            axis: Rgb(0x7A, 0x84, 0x91),
            grid: Rgb(0xDD, 0xE1, 0xE6),
            minor_grid: Rgb(0xF1, 0xF3, 0xF5),
            event: Rgb(0x8A, 0x93, 0x9F),
            limit: Rgb(0xB4, 0x23, 0x18),
            cursor: Rgb(0x1B, 0x1F, 0x24),
            palette: [
                Rgb(0x00, 0x72, 0xB2),
                Rgb(0xD5, 0x5E, 0x00),
                Rgb(0x00, 0x9E, 0x73),
                Rgb(0xC4, 0x74, 0xA0),
                Rgb(0xC0, 0x85, 0x00),
                Rgb(0x4A, 0x99, 0xC6),
                Rgb(0x9B, 0x93, 0x2B),
                Rgb(0x00, 0x00, 0x00),
            ],
            font_family: FAMILY.to_owned(),
            font_size_px: 12.0,
            line_width_px: 1.8,
        }
    }

    /// Light on near black.
    pub fn dark() -> Self {
        Self {
            background: Rgb(0x14, 0x18, 0x1F),
            text: Rgb(0xE8, 0xEB, 0xEF),
            muted: Rgb(0xA9, 0xB2, 0xBD),
            axis: Rgb(0x7A, 0x85, 0x93),
            grid: Rgb(0x30, 0x38, 0x43),
            minor_grid: Rgb(0x1E, 0x24, 0x2C),
            event: Rgb(0x7E, 0x89, 0x97),
            limit: Rgb(0xFF, 0x8A, 0x80),
            cursor: Rgb(0xE8, 0xEB, 0xEF),
            palette: [
                Rgb(0x56, 0xB4, 0xE9),
                Rgb(0xF0, 0x7F, 0x2E),
                Rgb(0x00, 0xB8, 0x86),
                Rgb(0xCC, 0x79, 0xA7),
                Rgb(0xE6, 0x9F, 0x00),
                Rgb(0x2B, 0x8A, 0xC8),
                Rgb(0xF0, 0xE4, 0x42),
                Rgb(0xFF, 0xFF, 0xFF),
            ],
            ..Self::light()
        }
    }

    /// Black on white, heavier lines, contrast of at least 4.5 : 1 except the grid.
    pub fn high_contrast_light() -> Self {
        Self {
            text: Rgb(0, 0, 0),
            muted: Rgb(0, 0, 0),
            axis: Rgb(0, 0, 0),
            grid: Rgb(0xB0, 0xB0, 0xB0),
            minor_grid: Rgb(0xE4, 0xE4, 0xE4),
            event: Rgb(0x40, 0x40, 0x40),
            limit: Rgb(0x9A, 0x00, 0x00),
            cursor: Rgb(0, 0, 0),
            palette: [
                Rgb(0x00, 0x5A, 0x8F),
                Rgb(0xA8, 0x48, 0x00),
                Rgb(0x00, 0x73, 0x54),
                Rgb(0x9A, 0x4A, 0x78),
                Rgb(0x86, 0x5C, 0x00),
                Rgb(0x2A, 0x73, 0xA0),
                Rgb(0x6B, 0x65, 0x10),
                Rgb(0, 0, 0),
            ],
            line_width_px: 2.6,
            ..Self::light()
        }
    }

    /// White on black, heavier lines, contrast of at least 4.5 : 1 except the grid.
    pub fn high_contrast_dark() -> Self {
        Self {
            background: Rgb(0, 0, 0),
            text: Rgb(0xFF, 0xFF, 0xFF),
            muted: Rgb(0xFF, 0xFF, 0xFF),
            axis: Rgb(0xFF, 0xFF, 0xFF),
            grid: Rgb(0x5A, 0x5A, 0x5A),
            minor_grid: Rgb(0x2C, 0x2C, 0x2C),
            event: Rgb(0xC8, 0xC8, 0xC8),
            cursor: Rgb(0xFF, 0xFF, 0xFF),
            line_width_px: 2.6,
            ..Self::dark()
        }
    }

    /// Color of a series.
    pub(crate) fn color(&self, index: usize) -> Rgb {
        self.palette
            .get(index % self.palette.len())
            .copied()
            .unwrap_or(self.text)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use numerics::math::pow;

    /// Contrast ratio as defined by WCAG 2.
    fn contrast(a: Rgb, b: Rgb) -> f64 {
        let part = |c: u8| {
            let c = f64::from(c) / 255.0;
            if c <= 0.039_28 {
                c / 12.92
            } else {
                pow((c + 0.055) / 1.055, 2.4)
            }
        };
        let luminance = |c: Rgb| 0.2126 * part(c.0) + 0.7152 * part(c.1) + 0.0722 * part(c.2);
        let (a, b) = (luminance(a) + 0.05, luminance(b) + 0.05);
        if a > b { a / b } else { b / a }
    }

    #[test]
    fn text_has_4_5_to_1_and_lines_have_3_to_1() {
        // WCAG 2.2, success criteria 1.4.3 and 1.4.11
        for theme in [Theme::light(), Theme::dark()] {
            for text in [theme.text, theme.muted, theme.limit] {
                assert!(contrast(text, theme.background) >= 4.5, "{text:?}");
            }
            for line in theme
                .palette
                .iter()
                .chain([&theme.axis, &theme.event, &theme.cursor])
            {
                assert!(contrast(*line, theme.background) >= 3.0, "{line:?}");
            }
        }
    }

    #[test]
    fn high_contrast_has_4_5_to_1_for_every_line() {
        for theme in [Theme::high_contrast_light(), Theme::high_contrast_dark()] {
            for line in theme
                .palette
                .iter()
                .chain([&theme.muted, &theme.event, &theme.limit])
            {
                assert!(contrast(*line, theme.background) >= 4.5, "{line:?}");
            }
        }
    }
}
