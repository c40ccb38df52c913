//! From a figure to the shapes that show it.

use crate::figure::{Cursor, Dash, Figure, Kind, Marker, Series};
use crate::layout::{Block, Layout, PAD_PX, Sheet, Sizes, TICK_PX, layout, visible_events};
use crate::legend::{self, GAP_PX, Legend, SAMPLE_PX};
use crate::line;
use crate::mapping::{AxisMap, Mapping, Rect};
use crate::marker;
use crate::scene::{Anchor, Label, Point, Scene, Shape, sharp};
use crate::text::{Weight, shorten};
use crate::theme::{Rgb, Theme};
use crate::tick::Tick;
use std::collections::BTreeSet;

/// Radius of markers, px.
const MARKER_PX: f64 = 3.4;
/// Distance of markers along a line, px.
const MARKER_EVERY_PX: f64 = 64.0;
/// Lengths of dash and gap of event lines, px.
const EVENT_DASHES: [f64; 2] = [4.0, 3.0];
/// Lengths of dash and gap of limit lines, px.
const LIMIT_DASHES: [f64; 2] = [7.0, 4.0];
/// Most dots of a cursor on one line.
const CURSOR_DOTS: usize = 8;

/// A series ready to be drawn.
struct Drawn<'a> {
    series: &'a Series,
    colour: Rgb,
    /// Parts inside the plot, px.
    parts: Vec<Vec<Point>>,
    /// Filling of an area, px.
    fillings: Vec<Vec<Point>>,
}

/// The shapes of a figure of the given size, px, and where its data are on them.
pub(crate) fn compose(
    figure: &Figure,
    theme: &Theme,
    (width_px, height_px): (f64, f64),
) -> (Scene, Mapping) {
    let sheet = Sheet {
        width_px,
        height_px,
        legend_height_px: 0.0,
    };
    let mut layout_now = layout(figure, theme, sheet);
    let mut drawn = series(figure, theme, &layout_now.mapping);
    let occupied = occupied(figure, &layout_now.mapping, &drawn);
    let events: Vec<f64> = visible_events(figure, &layout_now.mapping)
        .iter()
        .map(|e| e.1)
        .collect();
    let corner = legend::in_corner(figure, &layout_now, &occupied, &events);
    let legend = corner.unwrap_or_else(|| {
        let legend = legend::above(figure, layout_now.sizes, width_px, layout_now.legend_top_px);
        let sheet = Sheet {
            legend_height_px: legend.height_px,
            ..sheet
        };
        layout_now = layout(figure, theme, sheet);
        drawn = series(figure, theme, &layout_now.mapping);
        legend
    });

    let mut scene = Scene::default();
    let all = Rect {
        left_px: 0.0,
        top_px: 0.0,
        right_px: width_px,
        bottom_px: height_px,
    };
    scene.rect(all, theme.background, 1.0);
    let mut painter = Painter {
        scene: &mut scene,
        theme,
        layout: &layout_now,
    };
    painter.grid();
    painter.areas(&drawn);
    painter.event_lines(figure);
    painter.limit_lines(figure);
    painter.series(&drawn);
    painter.axes();
    painter.captions(width_px);
    painter.limit_labels(figure, &drawn, &legend);
    painter.legend(figure, &legend);
    if drawn.iter().all(|d| d.parts.is_empty()) {
        painter.no_data();
    }
    if let Some(cursor) = figure.cursor {
        painter.cursor(figure, cursor);
    }
    (scene, layout_now.mapping)
}

fn axis_of<'a>(figure: &Figure, series: &Series, mapping: &'a Mapping) -> &'a AxisMap {
    match (&mapping.y2, figure.is_right(series)) {
        (Some(right), true) => right,
        _ => &mapping.y,
    }
}

fn series<'a>(figure: &'a Figure, theme: &Theme, mapping: &Mapping) -> Vec<Drawn<'a>> {
    let draw = |series: &'a Series| {
        let mut runs = line::runs(&series.points, &mapping.x, axis_of(figure, series, mapping));
        let mut fillings = Vec::new();
        let parts = match series.style.kind {
            Kind::Points => {
                let mut seen = BTreeSet::new();
                runs.into_iter()
                    .flatten()
                    .filter(|p| mapping.plot.grown(0.5).contains(*p))
                    // Of points on the same px one is enough.
                    .filter(|p| seen.insert((p.0.round() as i64, p.1.round() as i64)))
                    .map(|p| vec![p])
                    .collect()
            }
            kind => {
                if kind == Kind::Area {
                    for run in &mut runs {
                        run.extend(run.first().copied());
                        fillings.push(line::clipped_polygon(run.clone(), &mapping.plot));
                    }
                }
                let thin = runs.into_iter().map(line::thinned);
                thin.flat_map(|run| line::clipped(&run, &mapping.plot))
                    .collect()
            }
        };
        Drawn {
            series,
            colour: theme.colour(series.style.colour),
            parts,
            fillings,
        }
    };
    figure.series.iter().map(draw).collect()
}

/// Places that a legend or label should keep clear of.
fn occupied(figure: &Figure, mapping: &Mapping, drawn: &[Drawn]) -> Vec<Point> {
    let plot = mapping.plot;
    let parts = drawn.iter().flat_map(|d| &d.parts);
    let along = parts.flat_map(|p| line::spaced(p, 4.0).into_iter().chain(p.iter().copied()));
    let limits = figure
        .limits
        .iter()
        .filter_map(|l| mapping.y.px(l.y))
        .flat_map(|y_px| line::spaced(&[(plot.left_px, y_px), (plot.right_px, y_px)], 8.0));
    along.chain(limits).collect()
}

struct Painter<'a> {
    scene: &'a mut Scene,
    theme: &'a Theme,
    layout: &'a Layout,
}

impl Painter<'_> {
    fn level(&mut self, (left, right): (f64, f64), y_px: f64, colour: Rgb) {
        let y = sharp(y_px);
        self.scene.path(vec![(left, y), (right, y)], colour, 1.0);
    }

    fn upright(&mut self, x_px: f64, (top, bottom): (f64, f64), colour: Rgb) {
        let x = sharp(x_px);
        self.scene.path(vec![(x, top), (x, bottom)], colour, 1.0);
    }

    fn small(&mut self, text: &str, at: Point, anchor: Anchor, colour: Rgb) {
        let size_px = self.layout.sizes.small_px;
        let text = text.to_owned();
        self.scene.text(Label {
            text,
            at,
            anchor,
            size_px,
            weight: Weight::Normal,
            colour,
        });
    }

    /// Minor grid under major grid; the right axis has none.
    fn grid(&mut self) {
        let (plot, theme) = (self.layout.mapping.plot, self.theme);
        let layout = self.layout;
        for (is_major, colour) in [(false, theme.minor_grid), (true, theme.grid)] {
            for (x_px, _) in places(&layout.x_ticks, &layout.mapping.x, is_major) {
                self.upright(x_px, (plot.top_px, plot.bottom_px), colour);
            }
            for (y_px, _) in places(&layout.y_ticks, &layout.mapping.y, is_major) {
                self.level((plot.left_px, plot.right_px), y_px, colour);
            }
        }
    }

    fn axes(&mut self) {
        let (layout, axis, text) = (self.layout, self.theme.axis, self.theme.muted);
        let Mapping { plot, x, y, y2 } = layout.mapping;
        let mark = TICK_PX - 3.0;
        let (left, right) = (plot.left_px, plot.right_px + 1.0);
        for (x_px, label) in places(&layout.x_ticks, &x, true) {
            self.upright(x_px, (plot.bottom_px, plot.bottom_px + mark), axis);
            let below = plot.bottom_px + TICK_PX + 0.5 * layout.sizes.small_px;
            self.small(label, (sharp(x_px), below), Anchor::Middle, text);
        }
        for (y_px, label) in places(&layout.y_ticks, &y, true) {
            self.level((left - mark, left), y_px, axis);
            self.small(label, (left - TICK_PX, sharp(y_px)), Anchor::End, text);
        }
        if let Some(y2) = y2 {
            for (y_px, label) in places(&layout.y2_ticks, &y2, true) {
                self.level((right, right + mark), y_px, axis);
                self.small(
                    label,
                    (right + TICK_PX - 1.0, sharp(y_px)),
                    Anchor::Start,
                    text,
                );
            }
            self.upright(plot.right_px, (plot.top_px, plot.bottom_px), axis);
        }
        self.upright(left, (plot.top_px, plot.bottom_px), axis);
        self.level((left, right), plot.bottom_px, axis);
    }

    fn captions(&mut self, width_px: f64) {
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
        // Under the middle of the plot, but not beyond the edges of the figure.
        let widest = x_caption
            .lines
            .iter()
            .map(|l| crate::text::width_px(l, running.0, running.1))
            .fold(0.0, f64::max);
        let most = (width_px - PAD_PX - widest / 2.0).max(width_px / 2.0);
        let middle = ((plot.left_px + plot.right_px) / 2.0).min(most);
        self.block(x_caption, middle, Anchor::Middle, running);
    }

    fn block(
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
            let colour = self.theme.text;
            self.scene.text(Label {
                text: text.clone(),
                at,
                anchor,
                size_px,
                weight,
                colour,
            });
        }
    }

    fn event_lines(&mut self, figure: &Figure) {
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

    fn limit_lines(&mut self, figure: &Figure) {
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

    /// Place of a value of the left axis, px, if it is in the plot.
    fn inside(&self, y: f64) -> Option<f64> {
        let Mapping { plot, y: axis, .. } = &self.layout.mapping;
        axis.px(y)
            .filter(|px| *px >= plot.top_px - 0.5 && *px <= plot.bottom_px + 0.5)
    }

    /// Labels of limits, each at the end and on the side of its line with the fewest data under it.
    fn limit_labels(&mut self, figure: &Figure, drawn: &[Drawn], legend: &Legend) {
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
                colour: self.theme.limit,
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

    fn areas(&mut self, drawn: &[Drawn]) {
        for area in drawn {
            for points in &area.fillings {
                let points = points.clone();
                self.scene.shapes.push(Shape::Fill {
                    points,
                    colour: area.colour,
                    opacity: 0.2,
                });
            }
        }
    }

    fn series(&mut self, drawn: &[Drawn]) {
        for Drawn {
            series,
            colour,
            parts,
            ..
        } in drawn
        {
            let style = series.style;
            if style.kind == Kind::Points {
                let marker = style.marker.unwrap_or(Marker::Circle);
                for at in parts.iter().flatten() {
                    marker::add(self.scene, marker, *at, MARKER_PX * 0.85, *colour);
                }
                continue;
            }
            for part in parts {
                // A point alone between gaps is still seen.
                if let [only] = part.as_slice() {
                    let marker = style.marker.unwrap_or(Marker::Circle);
                    marker::add(self.scene, marker, *only, MARKER_PX * 0.8, *colour);
                    continue;
                }
                self.stroke(part, style.dash, *colour);
                for at in style
                    .marker
                    .iter()
                    .flat_map(|_| line::spaced(part, MARKER_EVERY_PX))
                {
                    let marker = style.marker.unwrap_or(Marker::Circle);
                    marker::add(self.scene, marker, at, MARKER_PX, *colour);
                }
            }
        }
    }

    fn stroke(&mut self, points: &[Point], dash: Dash, colour: Rgb) {
        let width = self.theme.line_width_px;
        let pattern: Vec<f64> = line::pattern(dash).iter().map(|d| d * width).collect();
        for dash in line::dashed(points, &pattern) {
            self.scene.path(dash, colour, width);
        }
    }

    fn legend(&mut self, figure: &Figure, legend: &Legend) {
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
            let (style, colour) = (series.style, self.theme.colour(series.style.colour));
            let (left, y) = entry.at;
            let middle = (left + SAMPLE_PX / 2.0, y);
            match style.kind {
                Kind::Line => self.stroke(&[(left, y), (left + SAMPLE_PX, y)], style.dash, colour),
                Kind::Area => {
                    let (left_px, right_px) = (left + 4.0, left + SAMPLE_PX - 4.0);
                    let patch = Rect {
                        left_px,
                        top_px: y - 4.0,
                        right_px,
                        bottom_px: y + 4.0,
                    };
                    self.scene.rect(patch, colour, 0.2);
                    self.stroke(
                        &[
                            (left_px, y - 4.0),
                            (right_px, y - 4.0),
                            (right_px, y + 4.0),
                            (left_px, y + 4.0),
                            (left_px, y - 4.0),
                        ],
                        style.dash,
                        colour,
                    );
                }
                Kind::Points => {}
            }
            let fallback = (style.kind == Kind::Points).then_some(Marker::Circle);
            if let Some(marker) = style.marker.or(fallback) {
                marker::add(self.scene, marker, middle, MARKER_PX, colour);
            }
            let at = (left + SAMPLE_PX + GAP_PX, y);
            self.small(&entry.name, at, Anchor::Start, self.theme.text);
        }
    }

    fn no_data(&mut self) {
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
            colour: self.theme.muted,
        });
    }

    fn cursor(&mut self, figure: &Figure, cursor: Cursor) {
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
                    self.cursor_dot(at, self.theme.colour(series.style.colour));
                }
            }
        }
    }

    fn cursor_dot(&mut self, at: Point, colour: Rgb) {
        let ring = Shape::Dot {
            at,
            radius_px: 5.5,
            colour: self.theme.background,
        };
        self.scene.shapes.push(ring);
        self.scene.shapes.push(Shape::Dot {
            at,
            radius_px: 4.0,
            colour,
        });
    }
}

/// Places and labels of the major or the minor ticks, px.
fn places<'a>(ticks: &'a [Tick], axis: &AxisMap, is_major: bool) -> Vec<(f64, &'a str)> {
    ticks
        .iter()
        .filter(|t| t.is_major() == is_major)
        .filter_map(|t| Some((axis.px(t.value)?, t.label.as_str())))
        .collect()
}
