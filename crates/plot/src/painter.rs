//! Parts of a figure as shapes.

use crate::compose::Drawn;
use crate::figure::{Dash, Kind, Marker};
use crate::layout::{Block, Layout, PAD_PX, Sizes, TICK_PX};
use crate::line;
use crate::mapping::{AxisMap, Mapping};
use crate::marker;
use crate::scene::{Anchor, Label, Point, Scene, Shape, sharp};
use crate::text::Weight;
use crate::theme::{Rgb, Theme};
use crate::tick::Tick;

/// Radius of markers, px.
pub(crate) const MARKER_PX: f64 = 3.4;
/// Spacing of markers along a line, px.
const MARKER_EVERY_PX: f64 = 64.0;
/// Mean spacing of grid lines below which the minor ones are omitted, px.
const DENSEST_PX: f64 = 8.0;

/// Adds the parts of a figure with a layout to a scene.
pub(crate) struct Painter<'a> {
    pub(crate) scene: &'a mut Scene,
    pub(crate) theme: &'a Theme,
    pub(crate) layout: &'a Layout,
}

impl Painter<'_> {
    /// Horizontal line one px wide.
    pub(crate) fn level(&mut self, (left, right): (f64, f64), y_px: f64, color: Rgb) {
        let y = sharp(y_px);
        self.scene.path(vec![(left, y), (right, y)], color, 1.0);
    }

    /// Vertical line one px wide.
    pub(crate) fn upright(&mut self, x_px: f64, (top, bottom): (f64, f64), color: Rgb) {
        let x = sharp(x_px);
        self.scene.path(vec![(x, top), (x, bottom)], color, 1.0);
    }

    /// Text in the size of tick labels.
    pub(crate) fn small(&mut self, text: &str, at: Point, anchor: Anchor, color: Rgb) {
        let size_px = self.layout.sizes.small_px;
        let text = text.to_owned();
        self.scene.text(Label {
            text,
            at,
            anchor,
            size_px,
            weight: Weight::Normal,
            color,
        });
    }

    /// Minor grid, where it is not too dense, below the major grid; none for the right axis.
    pub(crate) fn grid(&mut self) {
        let (layout, theme) = (self.layout, self.theme);
        let Mapping { plot, x, y, .. } = layout.mapping;
        let is_open = |ticks: &[Tick], length: f64| length > DENSEST_PX * ticks.len() as f64;
        let is_fine =
            is_open(&layout.x_ticks, plot.width_px()) && is_open(&layout.y_ticks, plot.height_px());
        let kinds = [(false, theme.minor_grid), (true, theme.grid)];
        for (is_major, color) in kinds.into_iter().filter(|kind| kind.0 || is_fine) {
            for (x_px, _) in places(&layout.x_ticks, &x, is_major) {
                self.upright(x_px, (plot.top_px, plot.bottom_px), color);
            }
            for (y_px, _) in places(&layout.y_ticks, &y, is_major) {
                self.level((plot.left_px, plot.right_px), y_px, color);
            }
        }
    }

    /// Axis lines, ticks and their labels.
    pub(crate) fn axes(&mut self) {
        let (layout, axis, text) = (self.layout, self.theme.axis, self.theme.muted);
        let Mapping { plot, x, y, y2 } = layout.mapping;
        let mark = TICK_PX - 3.0;
        let (left, right) = (plot.left_px, plot.right_px + 1.0);
        let x_places = places(&layout.x_ticks, &x, true);
        let y_places = places(&layout.y_ticks, &y, true);
        let y2_places = y2
            .map(|y2| places(&layout.y2_ticks, &y2, true))
            .unwrap_or_default();

        for (x_px, _) in &x_places {
            self.upright(*x_px, (plot.bottom_px, plot.bottom_px + mark), axis);
        }
        for (y_px, _) in &y_places {
            self.level((left - mark, left), *y_px, axis);
        }
        for (y_px, _) in &y2_places {
            self.level((right, right + mark), *y_px, axis);
        }
        if y2.is_some() {
            self.upright(plot.right_px, (plot.top_px, plot.bottom_px), axis);
        }
        self.upright(left, (plot.top_px, plot.bottom_px), axis);
        self.level((left, right), plot.bottom_px, axis);

        let below = plot.bottom_px + TICK_PX + 0.5 * layout.sizes.small_px;
        for (x_px, label) in x_places {
            self.small(label, (sharp(x_px), below), Anchor::Middle, text);
        }
        for (y_px, label) in y_places {
            self.small(label, (left - TICK_PX, sharp(y_px)), Anchor::End, text);
        }
        for (y_px, label) in y2_places {
            self.small(
                label,
                (right + TICK_PX - 1.0, sharp(y_px)),
                Anchor::Start,
                text,
            );
        }
    }

    /// Title and captions of the axes.
    pub(crate) fn captions(&mut self, width_px: f64) {
        let Layout {
            mapping,
            sizes,
            title,
            x_caption,
            y_caption,
            y2_caption,
            ..
        } = self.layout;
        let plot = mapping.plot;
        self.block(title, PAD_PX, Anchor::Start, (sizes.title_px, Weight::Bold));
        let running = (sizes.caption_px, Weight::Normal);
        self.block(y_caption, PAD_PX, Anchor::Start, running);
        self.block(y2_caption, width_px - PAD_PX, Anchor::End, running);
        // centered below the plot, but kept inside the figure
        let widest = x_caption
            .lines
            .iter()
            .map(|l| crate::text::width_px(l, running.0, running.1))
            .fold(0.0, f64::max);
        let most = (width_px - PAD_PX - widest / 2.0).max(width_px / 2.0);
        let middle = ((plot.left_px + plot.right_px) / 2.0).min(most);
        self.block(x_caption, middle, Anchor::Middle, running);
    }

    /// Lines of text below each other.
    pub(crate) fn block(
        &mut self,
        block: &Block,
        x_px: f64,
        anchor: Anchor,
        (size_px, weight): (f64, Weight),
    ) {
        for (i, text) in block.lines.iter().enumerate() {
            let at = (
                x_px,
                block.top_px + (i as f64 + 0.5) * Sizes::row_px(size_px),
            );
            let color = self.theme.text;
            self.scene.text(Label {
                text: text.clone(),
                at,
                anchor,
                size_px,
                weight,
                color,
            });
        }
    }

    /// Fillings of areas.
    pub(crate) fn areas(&mut self, drawn: &[Drawn]) {
        for area in drawn {
            for points in &area.fillings {
                let points = points.clone();
                self.scene.shapes.push(Shape::Fill {
                    points,
                    color: area.color,
                    opacity: 0.2,
                });
            }
        }
    }

    /// Lines, outlines and points of the series.
    pub(crate) fn series(&mut self, drawn: &[Drawn]) {
        for Drawn {
            series,
            color,
            parts,
            ..
        } in drawn
        {
            let style = series.style;
            if style.kind == Kind::Points {
                let marker = style.marker.unwrap_or(Marker::Circle);
                for at in parts.iter().flatten() {
                    marker::add(self.scene, marker, *at, MARKER_PX * 0.85, *color);
                }
                continue;
            }
            for part in parts {
                // make an isolated point between gaps visible
                if let [only] = part.as_slice() {
                    let marker = style.marker.unwrap_or(Marker::Circle);
                    marker::add(self.scene, marker, *only, MARKER_PX * 0.8, *color);
                    continue;
                }
                self.stroke(part, style.dash, *color);
                for at in style
                    .marker
                    .iter()
                    .flat_map(|_| line::spaced(part, MARKER_EVERY_PX))
                {
                    let marker = style.marker.unwrap_or(Marker::Circle);
                    marker::add(self.scene, marker, at, MARKER_PX, *color);
                }
            }
        }
    }

    /// Dashed line in the width of the series lines.
    pub(crate) fn stroke(&mut self, points: &[Point], dash: Dash, color: Rgb) {
        let width = self.theme.line_width_px;
        let pattern: Vec<f64> = line::pattern(dash).iter().map(|d| d * width).collect();
        for dash in line::dashed(points, &pattern) {
            self.scene.path(dash, color, width);
        }
    }

    /// Note that there is nothing to show.
    pub(crate) fn no_data(&mut self) {
        let plot = self.layout.mapping.plot;
        let middle = (
            (plot.left_px + plot.right_px) / 2.0,
            (plot.top_px + plot.bottom_px) / 2.0,
        );
        self.scene.text(Label {
            text: "No data".to_owned(),
            at: middle,
            anchor: Anchor::Middle,
            size_px: self.layout.sizes.title_px,
            weight: Weight::Normal,
            color: self.theme.muted,
        });
    }
}

/// Positions and labels of the major or the minor ticks, px.
fn places<'a>(ticks: &'a [Tick], axis: &AxisMap, is_major: bool) -> Vec<(f64, &'a str)> {
    ticks
        .iter()
        .filter(|t| t.is_major() == is_major)
        .filter_map(|t| Some((axis.px(t.value)?, t.label.as_str())))
        .collect()
}
