//! Additions to the data: event and limit lines, legend and cursor.

use crate::compose::{Drawn, axis_of, occupied};
use crate::figure::{Cursor, Figure, Kind, Marker};
use crate::layout::{Sizes, visible_events};
use crate::legend::{GAP_PX, Legend, SAMPLE_PX};
use crate::line;
use crate::mapping::{Mapping, Rect};
use crate::marker;
use crate::painter::{MARKER_PX, Painter};
use crate::scene::{Anchor, Label, Point, Shape, sharp};
use crate::text::{Weight, shorten};
use crate::theme::Rgb;

/// Dash and gap lengths of event lines, px.
const EVENT_DASHES: [f64; 2] = [4.0, 3.0];
/// Dash and gap lengths of limit lines, px.
const LIMIT_DASHES: [f64; 2] = [7.0, 4.0];
/// Largest number of cursor dots on one line.
const CURSOR_DOTS: usize = 8;

impl Painter<'_> {
    /// Event lines with their labels above the plot.
    pub(crate) fn event_lines(&mut self, figure: &Figure) {
        let (layout, plot) = (self.layout, self.layout.mapping.plot);
        let row = Sizes::row_px(layout.sizes.small_px);
        for (index, x_px, label) in visible_events(figure, &layout.mapping) {
            let x = sharp(x_px);
            let mut top = plot.top_px;
            if let Some(placed) = layout.events.iter().find(|p| p.index == index) {
                let middle = plot.top_px - (placed.row as f64 + 0.5) * row;
                self.small(
                    label,
                    (placed.left_px, middle),
                    Anchor::Start,
                    self.theme.muted,
                );
                top = middle - 0.45 * layout.sizes.small_px;
            }
            for dash in line::dashed(&[(x, plot.bottom_px), (x, top)], &EVENT_DASHES) {
                self.scene.path(dash, self.theme.event, 1.0);
            }
        }
    }

    /// Limit lines, drawn below the series.
    pub(crate) fn limit_lines(&mut self, figure: &Figure) {
        let plot = self.layout.mapping.plot;
        let places: Vec<f64> = figure
            .limits
            .iter()
            .filter_map(|l| self.inside(l.y))
            .collect();
        for y_px in places {
            let y = sharp(y_px);
            let ends = [(plot.left_px, y), (plot.right_px, y)];
            for dash in line::dashed(&ends, &LIMIT_DASHES) {
                self.scene.path(dash, self.theme.limit, 1.5);
            }
        }
    }

    /// Position of a value of the left axis, px, if it lies inside the plot.
    pub(crate) fn inside(&self, y: f64) -> Option<f64> {
        let Mapping { plot, y: axis, .. } = &self.layout.mapping;
        axis.px(y)
            .filter(|px| *px >= plot.top_px - 0.5 && *px <= plot.bottom_px + 0.5)
    }

    /// Labels of limits, each at the end and on the side of its line that covers the least data.
    pub(crate) fn limit_labels(&mut self, figure: &Figure, drawn: &[Drawn], legend: &Legend) {
        let (plot, size_px) = (self.layout.mapping.plot, self.layout.sizes.small_px);
        let taken = occupied(figure, &self.layout.mapping, drawn);
        let mut boxes: Vec<Rect> = legend.frame.into_iter().collect();
        for limit in figure.limits.iter().filter(|l| !l.label.is_empty()) {
            let Some(y_px) = self.inside(limit.y) else {
                continue;
            };
            let text = shorten(
                &limit.label,
                size_px,
                Weight::Normal,
                plot.width_px() - 12.0,
            );
            let label = |(x_px, anchor, down): (f64, Anchor, f64)| Label {
                text: text.clone(),
                at: (x_px, y_px + down * 0.85 * size_px),
                anchor,
                size_px,
                weight: Weight::Normal,
                color: self.theme.limit,
            };
            let (left, right) = (plot.left_px + 6.0, plot.right_px - 6.0);
            let places = [
                (right, Anchor::End, -1.0),
                (left, Anchor::Start, -1.0),
                (right, Anchor::End, 1.0),
                (left, Anchor::Start, 1.0),
            ];
            let badness = |label: &Label| {
                let bounds = label.bounds();
                let out = bounds.top_px < plot.top_px || bounds.bottom_px > plot.bottom_px;
                let covered = boxes.iter().filter(|b| b.overlaps(&bounds)).count();
                let on_data = taken.iter().filter(|p| bounds.contains(**p)).count();
                usize::from(out) * 10_000 + covered * 1000 + on_data
            };
            if let Some(label) = places.into_iter().map(label).min_by_key(badness) {
                let bounds = label.bounds();
                boxes.push(bounds);
                self.scene
                    .rect(bounds.grown(1.0), self.theme.background, 0.75);
                self.scene.text(label);
            }
        }
    }

    /// Frame and entries of the legend.
    pub(crate) fn legend(&mut self, figure: &Figure, legend: &Legend) {
        if let Some(frame) = legend.frame {
            self.scene.rect(frame, self.theme.background, 0.88);
            let Rect {
                left_px: l,
                top_px: t,
                right_px: r,
                bottom_px: b,
            } = frame;
            let edge = [(l, t), (r, t), (r, b), (l, b), (l, t)];
            let edge = edge.map(|(x, y)| (sharp(x), sharp(y))).to_vec();
            self.scene.path(edge, self.theme.grid, 1.0);
        }
        for entry in &legend.entries {
            let Some(series) = figure.series.get(entry.series) else {
                continue;
            };
            let (style, color) = (series.style, self.theme.color(series.style.color));
            let (left, y) = entry.at;
            let middle = (left + SAMPLE_PX / 2.0, y);
            match style.kind {
                Kind::Line => self.stroke(&[(left, y), (left + SAMPLE_PX, y)], style.dash, color),
                Kind::Area => {
                    let (left_px, right_px) = (left + 4.0, left + SAMPLE_PX - 4.0);
                    let patch = Rect {
                        left_px,
                        top_px: y - 4.0,
                        right_px,
                        bottom_px: y + 4.0,
                    };
                    self.scene.rect(patch, color, 0.2);
                    self.stroke(
                        &[
                            (left_px, y - 4.0),
                            (right_px, y - 4.0),
                            (right_px, y + 4.0),
                            (left_px, y + 4.0),
                            (left_px, y - 4.0),
                        ],
                        style.dash,
                        color,
                    );
                }
                Kind::Points => {}
            }
            let fallback = (style.kind == Kind::Points).then_some(Marker::Circle);
            if let Some(marker) = style.marker.or(fallback) {
                marker::add(self.scene, marker, middle, MARKER_PX, color);
            }
            let at = (left + SAMPLE_PX + GAP_PX, y);
            self.small(&entry.name, at, Anchor::Start, self.theme.text);
        }
    }

    /// The cursor with its dots.
    pub(crate) fn cursor(&mut self, figure: &Figure, cursor: Cursor) {
        let mapping = self.layout.mapping;
        let plot = mapping.plot;
        let (x, point) = match cursor {
            Cursor::X(x) => (x, None),
            Cursor::Point(x, y) => (x, Some(y)),
        };
        let within = |px: &f64| *px >= plot.left_px - 0.5 && *px <= plot.right_px + 0.5;
        let Some(x_px) = mapping.x.px(x).filter(within) else {
            return;
        };
        self.upright(x_px, (plot.top_px, plot.bottom_px), self.theme.cursor);
        if let Some(y) = point {
            if let Some(y_px) = self.inside(y) {
                self.level((plot.left_px, plot.right_px), y_px, self.theme.cursor);
                self.cursor_dot((x_px, y_px), self.theme.cursor);
            }
            return;
        }
        for series in figure.series.iter().filter(|s| s.style.kind == Kind::Line) {
            let axis = axis_of(figure, series, &mapping);
            for y in line::crossings(&series.points, x, CURSOR_DOTS) {
                if let Some(at) = axis
                    .px(y)
                    .map(|y_px| (x_px, y_px))
                    .filter(|p| plot.contains(*p))
                {
                    self.cursor_dot(at, self.theme.color(series.style.color));
                }
            }
        }
    }

    /// Dot with a ring in the background color, which separates it from lines.
    pub(crate) fn cursor_dot(&mut self, at: Point, color: Rgb) {
        let ring = Shape::Dot {
            at,
            radius_px: 5.5,
            color: self.theme.background,
        };
        self.scene.shapes.push(ring);
        self.scene.shapes.push(Shape::Dot {
            at,
            radius_px: 4.0,
            color,
        });
    }
}
