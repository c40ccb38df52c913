//! Widths of text without a font: the same on every machine.
//!
//! The advance widths are those of DejaVu Sans, one of the widest common sans-serif fonts, so that text also fits in a
//! narrower font.

/// Advance widths of the characters from space to tilde, thousandths of the font size.
const ASCII: [u16; 95] = [
    318, 401, 460, 838, 636, 950, 780, 275, 390, 390, 500, 838, 318, 361, 318, 337, 636, 636, 636,
    636, 636, 636, 636, 636, 636, 636, 337, 337, 838, 838, 838, 531, 1000, 684, 686, 698, 770, 632,
    575, 775, 752, 295, 295, 656, 557, 863, 748, 787, 603, 787, 695, 635, 611, 732, 684, 989, 685,
    611, 685, 390, 337, 390, 838, 500, 500, 613, 635, 550, 635, 615, 352, 635, 634, 278, 278, 579,
    278, 974, 634, 612, 635, 635, 411, 521, 392, 634, 592, 818, 592, 592, 525, 636, 337, 636, 838,
];

/// Largest ratio of the width of bold text to that of normal text.
const BOLD: f64 = 1.12;

/// Weight of a font.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Weight {
    /// Running text.
    Normal,
    /// Titles.
    Bold,
}

fn advance(c: char) -> u16 {
    let index = (c as usize).checked_sub(32);
    if let Some(width) = index.and_then(|i| ASCII.get(i)) {
        return *width;
    }
    match c {
        '\u{2009}' | '\u{202F}' => 200,
        '·' => 318,
        '²' | '³' | '¹' | '\u{2070}'..='\u{2079}' | '\u{2080}'..='\u{2089}' => 401,
        '°' | '–' => 500,
        '⁻' => 528,
        '×' | '−' | '≤' | '≥' | '→' | '←' => 838,
        '\u{80}'..='\u{3FF}' => 780,
        _ => 1000,
    }
}

/// Width of a line of text, px.
pub(crate) fn width_px(text: &str, size_px: f64, weight: Weight) -> f64 {
    let thousandths: u32 = text.chars().map(|c| u32::from(advance(c))).sum();
    let width = f64::from(thousandths) / 1000.0 * size_px;
    match weight {
        Weight::Normal => width,
        Weight::Bold => width * BOLD,
    }
}

/// The text in at most `rows` lines no wider than `limit_px`, broken at spaces; the rest is replaced by an ellipsis.
pub(crate) fn wrap(
    text: &str,
    size_px: f64,
    weight: Weight,
    limit_px: f64,
    rows: usize,
) -> Vec<String> {
    let fits = |line: &str| width_px(line, size_px, weight) <= limit_px;
    let mut lines: Vec<String> = Vec::new();
    for word in text.split(' ').filter(|w| !w.is_empty()) {
        let full = lines.len() >= rows;
        match lines.last_mut() {
            Some(line) if full || fits(&format!("{line} {word}")) => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
        .into_iter()
        .map(|line| shorten(&line, size_px, weight, limit_px))
        .collect()
}

/// The text, or as much of its beginning as fits with an ellipsis.
pub(crate) fn shorten(text: &str, size_px: f64, weight: Weight, limit_px: f64) -> String {
    if width_px(text, size_px, weight) <= limit_px {
        return text.to_owned();
    }
    let mut kept: String = text.to_owned();
    while !kept.is_empty() {
        kept.pop();
        let candidate = format!("{}…", kept.trim_end());
        if width_px(&candidate, size_px, weight) <= limit_px {
            return candidate;
        }
    }
    String::new()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn km_at_10_px_is_15_53_px() {
        // k 579 and m 974 thousandths: 1553 / 1000 × 10
        assert!((width_px("km", 10.0, Weight::Normal) - 15.53).abs() < 1e-12);
    }

    #[test]
    fn wrapped_lines_keep_every_word_and_fit() {
        let lines = wrap(
            "Total heat flux at the stagnation point",
            12.0,
            Weight::Normal,
            130.0,
            3,
        );
        assert_eq!(lines.join(" "), "Total heat flux at the stagnation point");
        assert!(lines.len() > 1);
        assert!(
            lines
                .iter()
                .all(|l| width_px(l, 12.0, Weight::Normal) <= 130.0)
        );
    }

    #[test]
    fn what_cannot_fit_ends_in_an_ellipsis() {
        let lines = wrap("one two three four five six", 12.0, Weight::Normal, 60.0, 2);
        assert_eq!(lines.len(), 2);
        assert!(lines[1].ends_with('…'), "{lines:?}");
        assert!(width_px(&lines[1], 12.0, Weight::Normal) <= 60.0);
    }
}
