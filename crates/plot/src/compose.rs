//! Conversion of a figure to shapes.

use crate::figure::{Figure, Kind, Series};
use crate::layout::{Sheet, layout, visible_events};
use crate::legend;
use crate::line;
use crate::mapping::{AxisMap, Mapping, Rect};
use crate::painter::Painter;
use crate::scene::{Point, Scene};
use crate::theme::{Rgb, Theme};
use std::collections::BTreeSet;

/// Series in px, ready to be drawn.
pub(crate) struct Drawn<'a> {
    pub(crate) series: &'a Series,
    pub(crate) color: Rgb,
    /// Parts inside the plot, px.
    pub(crate) parts: Vec<Vec<Point>>,
    /// Filled polygons of an area, px.
    pub(crate) fillings: Vec<Vec<Point>>,
}

/// Shapes of a figure of the given size, px, and its mapping from data to px.
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

/// Mapping of the vertical axis that a series uses.
pub(crate) fn axis_of<'a>(figure: &Figure, series: &Series, mapping: &'a Mapping) -> &'a AxisMap {
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
                    // one point per px is enough
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
                let thin = runs
                    .into_iter()
                    .map(line::thinned)
                    .map(|run| line::straightened(&run));
                thin.flat_map(|run| line::clipped(&run, &mapping.plot))
                    .collect()
            }
        };
        Drawn {
            series,
            color: theme.color(series.style.color),
            parts,
            fillings,
        }
    };
    figure.series.iter().map(draw).collect()
}

/// Positions that legend and labels should avoid.
pub(crate) fn occupied(figure: &Figure, mapping: &Mapping, drawn: &[Drawn]) -> Vec<Point> {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::{Axis, EventLine, LimitLine, Side};
    use crate::scene::Label;

    /// A figure with every kind of element.
    fn busy() -> Figure {
        let wave = |k: f64| {
            (0..200)
                .map(|i| (f64::from(i) * 3.3, k * f64::from(i * (200 - i))))
                .collect()
        };
        let mut right = Series::line("Speed", wave(0.001), 2);
        right.side = Side::Right;
        let event = |x: f64, label: &str| EventLine {
            x,
            label: label.to_owned(),
        };
        Figure {
            title: Some("A vehicle with a name that is rather long for a telephone".to_owned()),
            x: Axis::new("Time since the entry interface at 125 km", "s"),
            y: Axis::new(
                "Peak total heat flux with margin at the stagnation point",
                "W/m²",
            ),
            y2: Some(Axis::new("Speed relative to the planet", "km/s")),
            series: vec![
                Series::line("Convective", wave(1e3), 0),
                Series::line("Radiative", wave(500.0), 1),
                right,
            ],
            events: vec![
                event(0.0, "entry"),
                event(230.0, "peak deceleration"),
                event(240.0, "peak heat flux"),
                event(650.0, "ground"),
            ],
            limits: vec![LimitLine {
                y: 9e6,
                label: "limit of the material".to_owned(),
            }],
            ..Figure::default()
        }
    }

    #[test]
    fn labels_are_inside_the_figure_and_do_not_cover_each_other() {
        for size in [
            (320.0, 240.0),
            (360.0, 300.0),
            (500.0, 300.0),
            (800.0, 500.0),
        ] {
            let (scene, mapping) = compose(&busy(), &Theme::light(), size);
            let sheet = Rect {
                left_px: 0.0,
                top_px: 0.0,
                right_px: size.0,
                bottom_px: size.1,
            };
            let labels: Vec<&Label> = scene.labels();
            for (i, label) in labels.iter().enumerate() {
                let bounds = label.bounds();
                let corners = [
                    (bounds.left_px, bounds.top_px),
                    (bounds.right_px, bounds.bottom_px),
                ];
                assert!(
                    corners.iter().all(|c| sheet.contains(*c)),
                    "{size:?} {label:?}"
                );
                for other in &labels[i + 1..] {
                    let apart = !bounds.overlaps(&other.bounds());
                    assert!(apart, "{size:?} {} / {}", label.text, other.text);
                }
            }
            assert!(mapping.plot.height_px() > 24.0 && mapping.plot.width_px() > 150.0);
        }
    }

    #[test]
    fn without_data_the_figure_says_so() {
        let (scene, _) = compose(&Figure::default(), &Theme::light(), (320.0, 240.0));
        assert!(scene.labels().iter().any(|l| l.text == "No data"));
    }

    #[test]
    fn eighty_thousand_points_of_a_cloud_are_at_most_one_to_a_px() {
        let points = (0..80_000)
            .map(|i| (f64::from(i % 283), f64::from(i % 127)))
            .collect();
        let mut series = Series::line("a", points, 0);
        series.style.kind = Kind::Points;
        let figure = Figure {
            series: vec![series],
            ..Figure::default()
        };
        let (scene, _) = compose(&figure, &Theme::light(), (100.0, 80.0));
        assert!(scene.shapes.len() < 100 * 80, "{}", scene.shapes.len());
    }

    #[test]
    fn a_tiny_figure_is_drawn_without_fault() {
        for size in [(0.0, 0.0), (1.0, 1.0), (40.0, 20.0)] {
            assert!(!compose(&busy(), &Theme::dark(), size).0.shapes.is_empty());
        }
    }

    #[test]
    fn values_at_the_end_of_the_numbers_are_drawn_without_fault() {
        let points = vec![
            (-1e308, -1e308),
            (0.0, 1e-308),
            (1e308, 1e308),
            (f64::INFINITY, 0.0),
        ];
        let figure = Figure {
            series: vec![Series::line("a", points, 0)],
            ..Figure::default()
        };
        assert!(
            !compose(&figure, &Theme::light(), (320.0, 240.0))
                .0
                .shapes
                .is_empty()
        );
    }
}
