//! Cells of listings in fixed columns, where blanks stand for missing values.
//!
//! ```text
//!    PRES   HGHT   TEMP   DRCT   SKNT
//!   485.0   5893  -12.9                 the last, or the first, characters of names and numbers are above one another
//! ```
//!
//! # Valid
//! Rows without tabs and quotes, below a heading with one word per column. Other rows are left as they were split.
//!
//! # References
//! - Own convention.

use super::heading::{Heading, heading};
use super::layout::Cut;
use super::quantity::Quantity;
use std::borrow::Cow;

/// Assigns the cells of incomplete rows to the headings above them.
pub(super) fn place(cuts: &mut [Cut], quantities: &[Quantity]) {
    let known = |cut: &Cut| {
        let names = cut.cells.iter();
        names
            .filter(|name| heading(name, quantities) != Heading::Unknown)
            .count()
    };
    let above = cuts.iter().take_while(|cut| !cut.data);
    let heading = above
        .map(|cut| (known(cut), cut))
        .filter(|(known, cut)| *known > 1 && spans(cut).len() == cut.cells.len())
        .max_by_key(|(known, _)| *known);
    let Some((_, heading)) = heading else { return };
    let names = spans(heading);
    for cut in cuts.iter_mut().filter(|cut| cut.data) {
        let words = spans(cut);
        if words.len() != cut.cells.len() || words.len() >= names.len() {
            continue;
        }
        let below = |end: fn(&[usize; 2]) -> usize| -> Option<Vec<usize>> {
            let place = |word| names.iter().position(|name| end(name) == end(word));
            words.iter().map(place).collect()
        };
        // columns are aligned at their last characters, or else at their first
        let Some(places) = below(|span| span[1]).or_else(|| below(|span| span[0])) else {
            continue;
        };
        let count = places.last().map_or(0, |last| last + 1);
        let mut cells = vec![Cow::Borrowed(""); count];
        for (place, cell) in places.into_iter().zip(std::mem::take(&mut cut.cells)) {
            if let Some(at) = cells.get_mut(place) {
                *at = cell;
            }
        }
        cut.cells = cells;
        cut.placed = true;
    }
}

/// Index of the first character of each word of a line and of the one after the last; empty where the line has tabs or
/// quotes.
fn spans(cut: &Cut) -> Vec<[usize; 2]> {
    let mut spans: Vec<[usize; 2]> = Vec::new();
    let mut inside = false;
    for (place, sign) in (cut.line.indent..).zip(cut.line.text.chars()) {
        match sign {
            '\t' | '"' => return Vec::new(),
            sign if sign.is_whitespace() => inside = false,
            _ if inside => {
                if let Some(span) = spans.last_mut() {
                    span[1] = place + 1;
                }
            }
            _ => {
                spans.push([place, place + 1]);
                inside = true;
            }
        }
    }
    spans
}
