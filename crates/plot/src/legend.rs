//! Legend: in a corner of the plot that is free of lines, else in rows above the plot.

use crate::figure::Figure;
use crate::layout::{Layout, PAD_PX, Sizes};
use crate::mapping::Rect;
use crate::scene::Point;
use crate::text::{Weight, shorten, width_px};

/// Length of a line sample, px.
pub(crate) const SAMPLE_PX: f64 = 34.0;
/// Space between a sample and its name, px.
pub(crate) const GAP_PX: f64 = 6.0;
/// Padding of the frame, and space between adjacent entries, px.
const INSIDE_PX: f64 = 7.0;
/// Distance of the frame from the axes, px.
const OUTSIDE_PX: f64 = 8.0;

/// An entry: index of its series, name, and left end and middle of its row, px.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Entry {
    pub(crate) series: usize,
    pub(crate) name: String,
    pub(crate) at: Point,
}

/// Placed legend; it has a frame only inside the plot.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Legend {
    pub(crate) entries: Vec<Entry>,
    pub(crate) frame: Option<Rect>,
    /// Height of the rows above the plot, px; 0 for a legend in the plot.
    pub(crate) height_px: f64,
}

/// Names in the legend; empty for fewer than two named series.
fn names(figure: &Figure) -> Vec<(usize, String)> {
    let named = figure
        .series
        .iter()
        .enumerate()
        .filter(|(_, s)| !s.name.is_empty());
    let all: Vec<_> = named
        .map(|(i, s)| match figure.is_right(s) {
            true => (i, format!("{} (right axis)", s.name)),
            false => (i, s.name.clone()),
        })
        .collect();
    if all.len() > 1 { all } else { Vec::new() }
}

/// The legend in the first free corner: upper right, upper left, lower right, lower left. `occupied` are points along
/// lines; among free corners, that with the fewest event lines is taken.
pub(crate) fn in_corner(
    figure: &Figure,
    layout: &Layout,
    occupied: &[Point],
    events: &[f64],
) -> Option<Legend> {
    let names = names(figure);
    let (plot, size) = (layout.mapping.plot, layout.sizes.small_px);
    let row = Sizes::row_px(size);
    let widest = names
        .iter()
        .map(|n| width_px(&n.1, size, Weight::Normal))
        .fold(0.0, f64::max);
    let width = widest + SAMPLE_PX + GAP_PX + 2.0 * INSIDE_PX;
    let height = names.len() as f64 * row + INSIDE_PX;
    if names.is_empty() || width > 0.6 * plot.width_px() || height > 0.6 * plot.height_px() {
        return None;
    }
    let lefts = [
        plot.right_px - OUTSIDE_PX - width,
        plot.left_px + OUTSIDE_PX,
    ];
    let tops = [
        plot.top_px + OUTSIDE_PX,
        plot.bottom_px - OUTSIDE_PX - height,
    ];
    let frames = tops.into_iter().flat_map(|top_px| {
        lefts.into_iter().map(move |left_px| Rect {
            left_px,
            top_px,
            right_px: left_px + width,
            bottom_px: top_px + height,
        })
    });
    let struck = |frame: &Rect| {
        events
            .iter()
            .filter(|px| **px > frame.left_px && **px < frame.right_px)
            .count()
    };
    let free = |frame: &Rect| {
        let around = frame.grown(5.0);
        !occupied.iter().any(|p| around.contains(*p))
    };
    let frame = frames.filter(free).min_by_key(struck)?;
    let entries = names
        .into_iter()
        .enumerate()
        .map(|(i, (series, name))| Entry {
            series,
            name,
            at: (
                frame.left_px + INSIDE_PX,
                frame.top_px + INSIDE_PX / 2.0 + (i as f64 + 0.5) * row,
            ),
        })
        .collect();
    Some(Legend {
        entries,
        frame: Some(frame),
        height_px: 0.0,
    })
}

/// The legend in rows below `top_px`.
pub(crate) fn above(figure: &Figure, sizes: Sizes, width: f64, top_px: f64) -> Legend {
    let (size, row) = (sizes.small_px, Sizes::row_px(sizes.small_px));
    let limit = width - 2.0 * PAD_PX - SAMPLE_PX - GAP_PX;
    let (mut left, mut middle) = (PAD_PX, top_px + 0.5 * row);
    let mut entries = Vec::new();
    for (series, name) in names(figure) {
        let name = shorten(&name, size, Weight::Normal, limit);
        let length = SAMPLE_PX + GAP_PX + width_px(&name, size, Weight::Normal);
        if left > PAD_PX && left + length > width - PAD_PX {
            (left, middle) = (PAD_PX, middle + row);
        }
        entries.push(Entry {
            series,
            name,
            at: (left, middle),
        });
        left += length + 2.0 * INSIDE_PX;
    }
    let height_px = if entries.is_empty() {
        0.0
    } else {
        middle + 0.5 * row - top_px + 3.0
    };
    Legend {
        entries,
        frame: None,
        height_px,
    }
}
