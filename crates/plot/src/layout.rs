//! Positions of all parts: margins follow the widths of labels, so that none is cut off.

use crate::event::{Placed, Room, place};
use crate::figure::{Aspect, Axis, Figure, Scale, Side};
use crate::mapping::{AxisMap, Mapping, Rect};
use crate::range::{Range, around_decades, horizontal, vertical};
use crate::text::{Weight, width_px, wrap};
use crate::theme::Theme;
use crate::tick::{Step, Tick, ticks};

/// Space along the edges of the figure, px.
pub(crate) const PAD_PX: f64 = 8.0;
/// Length of a tick mark with the gap to its label, px.
pub(crate) const TICK_PX: f64 = 7.0;
/// Line spacing in font sizes.
const LEADING: f64 = 1.35;
/// Smallest width and height of a plot, px, however small the figure.
const LEAST_PLOT_PX: f64 = 24.0;

/// Font sizes, px.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Sizes {
    pub(crate) title_px: f64,
    pub(crate) caption_px: f64,
    pub(crate) small_px: f64,
}

impl Sizes {
    pub(crate) fn new(theme: &Theme) -> Self {
        let caption_px = theme.font_size_px;
        Self {
            title_px: caption_px * 1.2,
            caption_px,
            small_px: caption_px * 0.92,
        }
    }

    pub(crate) fn row_px(size_px: f64) -> f64 {
        size_px * LEADING
    }
}

/// Lines of text below each other; `top_px` is the upper edge of the first.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Block {
    pub(crate) lines: Vec<String>,
    pub(crate) top_px: f64,
}

impl Block {
    fn stacked(text: &str, size_px: f64, weight: Weight, limit_px: f64, top_px: &mut f64) -> Self {
        let lines = wrap(text, size_px, weight, limit_px, 3);
        let block = Self {
            top_px: *top_px,
            lines,
        };
        *top_px += block.lines.len() as f64 * Sizes::row_px(size_px);
        block
    }
}

/// Positions of all parts of a figure.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Layout {
    pub(crate) mapping: Mapping,
    pub(crate) sizes: Sizes,
    pub(crate) title: Block,
    pub(crate) x_caption: Block,
    pub(crate) y_caption: Block,
    pub(crate) y2_caption: Block,
    /// Upper edge of a legend above the plot, px.
    pub(crate) legend_top_px: f64,
    pub(crate) events: Vec<Placed>,
    pub(crate) x_ticks: Vec<Tick>,
    pub(crate) y_ticks: Vec<Tick>,
    pub(crate) y2_ticks: Vec<Tick>,
}

/// Size of a figure and of a legend above the plot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Sheet {
    pub(crate) width_px: f64,
    pub(crate) height_px: f64,
    pub(crate) legend_height_px: f64,
}

/// Result of one round of the layout, used by the next.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Margins {
    left_px: f64,
    right_px: f64,
    event_rows: usize,
}

/// Layout of a figure. Margins and ticks depend on each other; three rounds converge.
pub(crate) fn layout(figure: &Figure, theme: &Theme, sheet: Sheet) -> Layout {
    let most_rows = if sheet.height_px < 300.0 { 2 } else { 4 };
    let margins = Margins {
        left_px: 40.0,
        right_px: PAD_PX,
        event_rows: most_rows,
    };
    let (_, margins) = round(figure, theme, sheet, margins, most_rows);
    let (_, margins) = round(figure, theme, sheet, margins, most_rows);
    round(figure, theme, sheet, margins, margins.event_rows).0
}

fn round(
    figure: &Figure,
    theme: &Theme,
    sheet: Sheet,
    margins: Margins,
    rows: usize,
) -> (Layout, Margins) {
    let sizes = Sizes::new(theme);
    let limit = sheet.width_px - 2.0 * PAD_PX;
    let small_row = Sizes::row_px(sizes.small_px);

    let mut top = PAD_PX;
    let title = figure.title.as_deref().unwrap_or("");
    let title = Block::stacked(title, sizes.title_px, Weight::Bold, limit, &mut top);
    let legend_top_px = top;
    top += sheet.legend_height_px;
    let (y_caption, y2_caption) = vertical_captions(figure, sizes, limit, &mut top);
    top += (margins.event_rows as f64 * small_row).max(0.7 * sizes.small_px);

    let mut x_caption = Block::stacked(
        &figure.x.caption(),
        sizes.caption_px,
        Weight::Normal,
        limit,
        &mut 0.0,
    );
    let caption_height = x_caption.lines.len() as f64 * Sizes::row_px(sizes.caption_px);
    x_caption.top_px = sheet.height_px - PAD_PX / 2.0 - caption_height;
    let plot = Rect {
        left_px: margins.left_px.round(),
        top_px: top.round(),
        right_px: (sheet.width_px - margins.right_px)
            .round()
            .max(margins.left_px + LEAST_PLOT_PX),
        bottom_px: (x_caption.top_px - TICK_PX - small_row)
            .round()
            .max(top + LEAST_PLOT_PX),
    };

    let (mapping, shown) = map(figure, plot);
    let [x_ticks, y_ticks, y2_ticks] = axis_ticks(&mapping, shown, sizes);
    let widest = |ticks: &[Tick]| {
        ticks
            .iter()
            .map(|t| width_px(&t.label, sizes.small_px, Weight::Normal))
            .fold(0.0, f64::max)
    };
    // half of the outermost labels of the horizontal axis may extend beyond the plot
    let (mut out_left, mut out_right) = (0.0_f64, 0.0_f64);
    for tick in &x_ticks {
        let half = width_px(&tick.label, sizes.small_px, Weight::Normal) / 2.0;
        if let Some(px) = mapping.x.px(tick.value).filter(|_| tick.is_major()) {
            out_left = out_left.max(plot.left_px - (px - half));
            out_right = out_right.max(px + half - plot.right_px);
        }
    }
    let right_labels = if y2_ticks.is_empty() {
        0.0
    } else {
        TICK_PX + widest(&y2_ticks)
    };
    let lines = visible_events(figure, &mapping);
    let room = Room {
        left_px: plot.left_px,
        right_px: sheet.width_px - PAD_PX,
        rows,
        size_px: sizes.small_px,
    };
    let events = place(&lines, &room);
    let next = Margins {
        left_px: PAD_PX + (TICK_PX + widest(&y_ticks)).max(out_left),
        right_px: PAD_PX + right_labels.max(out_right),
        event_rows: events.iter().map(|p| p.row + 1).max().unwrap_or(0),
    };
    let layout = Layout {
        mapping,
        sizes,
        title,
        x_caption,
        y_caption,
        y2_caption,
        legend_top_px,
        events,
        x_ticks,
        y_ticks,
        y2_ticks,
    };
    (layout, next)
}

/// Captions of the vertical axes above their ends; below each other where they do not fit side by side.
fn vertical_captions(figure: &Figure, sizes: Sizes, limit: f64, top: &mut f64) -> (Block, Block) {
    let size = sizes.caption_px;
    let right = figure.y2.as_ref().map(Axis::caption).unwrap_or_default();
    let left = figure.y.caption();
    let width = |t: &str| width_px(t, size, Weight::Normal);
    if width(&left) + width(&right) + 24.0 <= limit {
        let mut right_top = *top;
        let right = Block::stacked(&right, size, Weight::Normal, limit, &mut right_top);
        let left = Block::stacked(&left, size, Weight::Normal, limit, top);
        *top = top.max(right_top);
        return (left, right);
    }
    let left = Block::stacked(&left, size, Weight::Normal, limit, top);
    let right = Block::stacked(&right, size, Weight::Normal, limit, top);
    (left, right)
}

/// Events inside the plot: index, place in px, label.
pub(crate) fn visible_events<'a>(
    figure: &'a Figure,
    mapping: &Mapping,
) -> Vec<(usize, f64, &'a str)> {
    let plot = mapping.plot;
    let inside = |px: &f64| *px >= plot.left_px - 0.5 && *px <= plot.right_px + 0.5;
    let events = figure.events.iter().enumerate();
    events
        .filter_map(|(i, e)| Some((i, mapping.x.px(e.x).filter(inside)?, e.label.as_str())))
        .collect()
}

/// Axes that have data, and so ticks.
#[derive(Clone, Copy)]
struct Shown {
    x: bool,
    y: bool,
    y2: bool,
}

fn map(figure: &Figure, plot: Rect) -> (Mapping, Shown) {
    let x_range = horizontal(figure);
    let empty = |scale| match scale {
        Scale::Linear => Range {
            from: 0.0,
            to: 1.0,
            fixed: true,
        },
        Scale::Log => Range {
            from: 1.0,
            to: 10.0,
            fixed: true,
        },
    };
    let mut x = x_range.unwrap_or(empty(figure.x.scale));
    let y_range = vertical(figure, Side::Left, x);
    let y2_range = figure
        .y2
        .as_ref()
        .and_then(|_| vertical(figure, Side::Right, x));
    let linear = figure.x.scale == Scale::Linear && figure.y.scale == Scale::Linear;
    let mut y = y_range.unwrap_or(empty(figure.y.scale));
    if figure.aspect == Aspect::Equal && linear {
        equalize(&mut x, &mut y, plot);
    } else {
        y = rounded(y, figure.y.scale, plot);
    }
    let vertical_map = |range: Range, scale| AxisMap {
        scale,
        from: range.from,
        to: range.to,
        from_px: plot.bottom_px,
        to_px: plot.top_px,
    };
    let y2 = figure.y2.as_ref().map(|axis| {
        let range = y2_range.unwrap_or(empty(axis.scale));
        vertical_map(rounded(range, axis.scale, plot), axis.scale)
    });
    let x = AxisMap {
        scale: figure.x.scale,
        from: x.from,
        to: x.to,
        from_px: plot.left_px,
        to_px: plot.right_px,
    };
    let mapping = Mapping {
        plot,
        x,
        y: vertical_map(y, figure.y.scale),
        y2,
    };
    (
        mapping,
        Shown {
            x: x_range.is_some(),
            y: y_range.is_some(),
            y2: y2_range.is_some(),
        },
    )
}

/// Widens, about its middle, the range with fewer units per px until both scales are equal.
fn equalize(x: &mut Range, y: &mut Range, plot: Rect) {
    let per_px_x = (x.to - x.from).abs() / plot.width_px();
    let per_px_y = (y.to - y.from).abs() / plot.height_px();
    let (range, factor) = if per_px_x < per_px_y {
        (x, per_px_y / per_px_x)
    } else {
        (y, per_px_x / per_px_y)
    };
    let (middle, half) = (
        (range.from + range.to) / 2.0,
        (range.to - range.from) / 2.0 * factor,
    );
    (range.from, range.to) = (middle - half, middle + half);
}

/// Vertical range that follows the data, extended to the nearest ticks.
fn rounded(range: Range, scale: Scale, plot: Rect) -> Range {
    if range.fixed {
        return range;
    }
    let (from, to) = match scale {
        Scale::Log => around_decades((range.from, range.to)),
        Scale::Linear => {
            let step = Step::at_least((range.to - range.from) / most_y(plot) as f64);
            step.around((range.from, range.to))
        }
    };
    Range { from, to, ..range }
}

fn most_x(plot: Rect) -> usize {
    (plot.width_px() / 48.0).clamp(2.0, 12.0) as usize
}

fn most_y(plot: Rect) -> usize {
    let height = plot.height_px();
    // accept dense labels rather than fewer than four steps
    (height / 42.0)
        .max((height / 24.0).min(4.0))
        .clamp(2.0, 9.0) as usize
}

fn axis_ticks(mapping: &Mapping, shown: Shown, sizes: Sizes) -> [Vec<Tick>; 3] {
    let on = |axis: &AxisMap, most: usize, gap_px: f64, length: &dyn Fn(&str) -> f64| {
        ticks((axis.from, axis.to), axis.scale, most, |ticks| {
            let mut spans: Vec<(f64, f64)> = ticks
                .iter()
                .filter(|t| t.is_major())
                .filter_map(|t| Some((axis.px(t.value)?, length(&t.label) / 2.0)))
                .collect();
            spans.sort_by(|a, b| a.0.total_cmp(&b.0));
            spans.windows(2).all(|pair| match pair {
                [a, b] => a.0 + a.1 + gap_px <= b.0 - b.1,
                _ => true,
            })
        })
    };
    let across = |label: &str| width_px(label, sizes.small_px, Weight::Normal);
    let upright = |_: &str| sizes.small_px;
    let y_axis = |axis: &AxisMap| on(axis, most_y(mapping.plot), 0.6 * sizes.small_px, &upright);
    let only = |shown: bool, ticks: Vec<Tick>| if shown { ticks } else { Vec::new() };
    [
        only(shown.x, on(&mapping.x, most_x(mapping.plot), 10.0, &across)),
        only(shown.y, y_axis(&mapping.y)),
        mapping
            .y2
            .as_ref()
            .map(|axis| only(shown.y2, y_axis(axis)))
            .unwrap_or_default(),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::Series;

    const SHEET: Sheet = Sheet {
        width_px: 400.0,
        height_px: 300.0,
        legend_height_px: 0.0,
    };

    #[test]
    fn equal_aspect_gives_a_unit_the_same_length_both_ways() {
        let figure = Figure {
            series: vec![Series::line("a", vec![(0.0, 0.0), (2.0, 0.3)], 0)],
            aspect: Aspect::Equal,
            ..Figure::default()
        };
        let Mapping { x, y, .. } = layout(&figure, &Theme::light(), SHEET).mapping;
        let x_px = x.px(1.0).unwrap() - x.px(0.0).unwrap();
        let y_px = y.px(0.0).unwrap() - y.px(1.0).unwrap();
        assert!((x_px - y_px).abs() < 1e-9, "{x_px} {y_px}");
    }

    #[test]
    fn wide_labels_widen_the_left_margin() {
        let left = |top: f64| {
            let points = vec![(0.0, 0.0), (1.0, top)];
            let figure = Figure {
                series: vec![Series::line("a", points, 0)],
                ..Figure::default()
            };
            layout(&figure, &Theme::light(), SHEET).mapping.plot.left_px
        };
        assert!(left(125_000.0) > left(5.0) + 20.0);
    }
}
