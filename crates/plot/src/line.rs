//! Processing of lines for the backend: split at gaps, thinned, clipped to the plot and dashed.

use crate::figure::Dash;
use crate::mapping::{AxisMap, Rect};
use crate::scene::Point;

/// Number of points above which a line is thinned.
const MOST_POINTS: usize = 4000;
/// Width of the columns for thinning, px: a device pixel on a high-resolution screen.
const COLUMN_PX: f64 = 0.5;
/// Distance from a straight line that is not visible, px: half a unit of the SVG backend.
const STRAIGHT_PX: f64 = 0.05;
/// Largest number of successive points removed from a straight line.
const MOST_SKIPPED: usize = 24;
/// Coordinates are clamped to this many px, which the integers of any backend can hold.
const FARTHEST_PX: f64 = 1e6;

/// Runs of points that have a position on both axes, px.
pub(crate) fn runs(points: &[(f64, f64)], x: &AxisMap, y: &AxisMap) -> Vec<Vec<Point>> {
    let mut runs = vec![Vec::new()];
    for point in points {
        match (x.px(point.0), y.px(point.1)) {
            (Some(x_px), Some(y_px)) => {
                if let Some(run) = runs.last_mut() {
                    let hold = |v: f64| v.clamp(-FARTHEST_PX, FARTHEST_PX);
                    run.push((hold(x_px), hold(y_px)));
                }
            }
            _ => runs.push(Vec::new()),
        }
    }
    runs.retain(|run| !run.is_empty());
    runs
}

/// The run with at most four successive points per column: first, lowest, highest, last.
///
/// The picture does not change, since a column is no wider than a px.
pub(crate) fn thinned(run: Vec<Point>) -> Vec<Point> {
    if run.len() <= MOST_POINTS {
        return run;
    }
    let mut kept = Vec::new();
    let mut column: Vec<Point> = Vec::new();
    for point in run {
        let same = column
            .first()
            .is_some_and(|first| (first.0 / COLUMN_PX).floor() == (point.0 / COLUMN_PX).floor());
        if !same {
            keep_extremes(&column, &mut kept);
            column.clear();
        }
        column.push(point);
    }
    keep_extremes(&column, &mut kept);
    kept
}

fn keep_extremes(column: &[Point], kept: &mut Vec<Point>) {
    let order = |a: &(usize, &Point), b: &(usize, &Point)| a.1.1.total_cmp(&b.1.1);
    let lowest = column.iter().enumerate().min_by(order).map(|(i, _)| i);
    let highest = column.iter().enumerate().max_by(order).map(|(i, _)| i);
    let last = column.len().checked_sub(1);
    let mut chosen: Vec<usize> = [Some(0), lowest, highest, last]
        .into_iter()
        .flatten()
        .collect();
    chosen.sort_unstable();
    chosen.dedup();
    kept.extend(chosen.into_iter().filter_map(|i| column.get(i)));
}

/// The run without points that lie on the line between their neighbors to within a small fraction of a px.
pub(crate) fn straightened(run: &[Point]) -> Vec<Point> {
    let mut kept: Vec<Point> = Vec::new();
    let mut skipped: Vec<Point> = Vec::new();
    for &point in run {
        let is_straight = kept.last().is_some_and(|from| {
            skipped.len() <= MOST_SKIPPED && skipped.iter().all(|p| is_between(*from, *p, point))
        });
        if !is_straight {
            kept.extend(skipped.last());
            skipped.clear();
        }
        if kept.is_empty() {
            kept.push(point);
        } else {
            skipped.push(point);
        }
    }
    kept.extend(skipped.last());
    kept
}

/// Whether `p` is near the line from `a` to `b`, and between its ends.
fn is_between(a: Point, p: Point, b: Point) -> bool {
    let (dx, dy) = (b.0 - a.0, b.1 - a.1);
    let (px, py) = (p.0 - a.0, p.1 - a.1);
    let (across, along, square) = (dx * py - dy * px, dx * px + dy * py, dx * dx + dy * dy);
    across * across <= STRAIGHT_PX * STRAIGHT_PX * square && along >= 0.0 && along <= square
}

/// Parts of a line inside a rectangle (Liang–Barsky algorithm).
pub(crate) fn clipped(run: &[Point], rect: &Rect) -> Vec<Vec<Point>> {
    let mut parts: Vec<Vec<Point>> = Vec::new();
    if let [only] = run
        && rect.contains(*only)
    {
        return vec![vec![*only]];
    }
    for pair in run.windows(2) {
        let &[a, b] = pair else { continue };
        let Some((from, to)) = segment_inside(a, b, rect) else {
            continue;
        };
        match parts.last_mut() {
            Some(part) if part.last() == Some(&from) => part.push(to),
            _ => parts.push(vec![from, to]),
        }
    }
    parts
}

fn segment_inside(a: Point, b: Point, rect: &Rect) -> Option<(Point, Point)> {
    let (dx, dy) = (b.0 - a.0, b.1 - a.1);
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    let sides = [
        (-dx, a.0 - rect.left_px),
        (dx, rect.right_px - a.0),
        (-dy, a.1 - rect.top_px),
        (dy, rect.bottom_px - a.1),
    ];
    for (towards, distance) in sides {
        if towards == 0.0 {
            if distance < 0.0 {
                return None;
            }
        } else if towards < 0.0 {
            enter = enter.max(distance / towards);
        } else {
            leave = leave.min(distance / towards);
        }
    }
    let at = |t: f64| (a.0 + t * dx, a.1 + t * dy);
    let from = if enter > 0.0 { at(enter) } else { a };
    let to = if leave < 1.0 { at(leave) } else { b };
    (enter <= leave).then_some((from, to))
}

/// Part of a polygon inside a rectangle (Sutherland–Hodgman algorithm).
pub(crate) fn clipped_polygon(polygon: Vec<Point>, rect: &Rect) -> Vec<Point> {
    type Depth = fn(Point, &Rect) -> f64;
    let sides: [Depth; 4] = [
        |p, r| p.0 - r.left_px,
        |p, r| r.right_px - p.0,
        |p, r| p.1 - r.top_px,
        |p, r| r.bottom_px - p.1,
    ];
    sides.iter().fold(polygon, |polygon, depth| {
        let mut inside = Vec::new();
        let nexts = polygon.iter().cycle().skip(1);
        for (&a, &b) in polygon.iter().zip(nexts) {
            let (at_a, at_b) = (depth(a, rect), depth(b, rect));
            if at_a >= 0.0 {
                inside.push(a);
            }
            if (at_a >= 0.0) != (at_b >= 0.0) {
                let t = at_a / (at_a - at_b);
                inside.push((a.0 + t * (b.0 - a.0), a.1 + t * (b.1 - a.1)));
            }
        }
        inside
    })
}

/// Dash pattern, alternating dash and gap, in line widths.
pub(crate) fn pattern(dash: Dash) -> &'static [f64] {
    match dash {
        Dash::Solid => &[],
        Dash::Dash => &[4.5, 2.5],
        Dash::Dot => &[1.2, 1.8],
        Dash::DashDot => &[5.5, 2.0, 1.2, 2.0],
        Dash::LongDash => &[7.5, 2.5],
    }
}

/// Dashes of a line; `pattern` in px. An empty pattern leaves the line whole.
pub(crate) fn dashed(line: &[Point], pattern: &[f64]) -> Vec<Vec<Point>> {
    if pattern.is_empty() || pattern.iter().sum::<f64>() <= 0.0 {
        return vec![line.to_vec()];
    }
    let mut lengths = pattern
        .iter()
        .copied()
        .cycle()
        .zip([true, false].into_iter().cycle());
    let (mut left, mut inked) = lengths.next().unwrap_or((1.0, true));
    let mut dashes: Vec<Vec<Point>> = line.first().map(|p| vec![*p]).into_iter().collect();
    for pair in line.windows(2) {
        let &[a, b] = pair else { continue };
        let (dx, dy) = (b.0 - a.0, b.1 - a.1);
        let length = (dx * dx + dy * dy).sqrt();
        let mut done = 0.0;
        while length - done > left {
            done += left;
            let turn = (a.0 + dx * done / length, a.1 + dy * done / length);
            if inked && let Some(dash) = dashes.last_mut() {
                dash.push(turn);
            } else {
                dashes.push(vec![turn]);
            }
            (left, inked) = lengths.next().unwrap_or((1.0, true));
        }
        left -= length - done;
        if inked && let Some(dash) = dashes.last_mut() {
            dash.push(b);
        }
    }
    dashes.retain(|dash| dash.len() > 1);
    dashes
}

/// Positions about `every_px` apart along a line, the first at half that distance from its start.
pub(crate) fn spaced(line: &[Point], every_px: f64) -> Vec<Point> {
    let mut places = Vec::new();
    let mut left = every_px / 2.0;
    for pair in line.windows(2) {
        let &[a, b] = pair else { continue };
        let (dx, dy) = (b.0 - a.0, b.1 - a.1);
        let length = (dx * dx + dy * dy).sqrt();
        let mut done = 0.0;
        while length - done > left {
            done += left;
            places.push((a.0 + dx * done / length, a.1 + dy * done / length));
            left = every_px;
        }
        left -= length - done;
    }
    places
}

/// Values of y where a line crosses `x`, at most `most` of them.
pub(crate) fn crossings(points: &[(f64, f64)], x: f64, most: usize) -> Vec<f64> {
    let mut found = Vec::new();
    for pair in points.windows(2) {
        let &[a, b] = pair else { continue };
        let within = (a.0 <= x && x <= b.0) || (b.0 <= x && x <= a.0);
        if !within {
            continue;
        }
        let y = if a.0 == b.0 {
            a.1
        } else {
            a.1 + (x - a.0) / (b.0 - a.0) * (b.1 - a.1)
        };
        if y.is_finite() && found.last() != Some(&y) && found.len() < most {
            found.push(y);
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::Scale;

    const SQUARE: Rect = Rect {
        left_px: 0.0,
        top_px: 0.0,
        right_px: 10.0,
        bottom_px: 10.0,
    };

    #[test]
    fn points_without_a_place_break_the_line() {
        let axis = |scale| AxisMap {
            scale,
            from: 1.0,
            to: 10.0,
            from_px: 0.0,
            to_px: 9.0,
        };
        let points = [
            (1.0, 1.0),
            (2.0, 2.0),
            (3.0, f64::NAN),
            (4.0, 4.0),
            (5.0, -5.0),
            (6.0, 6.0),
        ];
        let lengths = |y: &AxisMap| -> Vec<usize> {
            runs(&points, &axis(Scale::Linear), y)
                .iter()
                .map(Vec::len)
                .collect()
        };
        assert_eq!(lengths(&axis(Scale::Linear)), [2, 3]);
        assert_eq!(lengths(&axis(Scale::Log)), [2, 1, 1]);
    }

    #[test]
    fn a_line_that_leaves_and_returns_has_two_parts() {
        let parts = clipped(&[(5.0, 5.0), (15.0, 5.0), (15.0, 8.0), (5.0, 8.0)], &SQUARE);
        assert_eq!(
            parts,
            [vec![(5.0, 5.0), (10.0, 5.0)], vec![(10.0, 8.0), (5.0, 8.0)]]
        );
    }

    #[test]
    fn a_line_across_is_cut_at_both_edges() {
        assert_eq!(
            clipped(&[(-5.0, 5.0), (15.0, 5.0)], &SQUARE),
            [vec![(0.0, 5.0), (10.0, 5.0)]]
        );
        assert!(clipped(&[(-5.0, 20.0), (15.0, 20.0)], &SQUARE).is_empty());
    }

    #[test]
    fn a_polygon_over_the_corner_keeps_its_quarter() {
        let quarter = clipped_polygon(
            vec![(5.0, 5.0), (15.0, 5.0), (15.0, 15.0), (5.0, 15.0)],
            &SQUARE,
        );
        let (mut twice, n) = (0.0, quarter.len());
        for i in 0..n {
            let (a, b) = (quarter[i], quarter[(i + 1) % n]);
            twice += a.0 * b.1 - b.0 * a.1;
        }
        // 5 × 5
        assert_eq!(twice / 2.0, 25.0);
    }

    #[test]
    fn thinning_keeps_the_peak_and_the_ends() {
        let peak = 70_001;
        let run: Vec<Point> = (0..100_000)
            .map(|i| {
                (
                    f64::from(i) * 0.005,
                    if i == peak { -90.0 } else { f64::from(i % 7) },
                )
            })
            .collect();
        let thin = thinned(run.clone());
        // 500 px in columns of half a px, four points each
        assert!(thin.len() <= 4 * 1000 + 4, "{}", thin.len());
        assert!(thin.contains(&run[peak as usize]));
        assert_eq!((thin.first(), thin.last()), (run.first(), run.last()));
    }

    #[test]
    fn a_straight_line_keeps_its_ends_and_a_corner_its_point() {
        let straight: Vec<Point> = (0..=20)
            .map(|i| (f64::from(i), 2.0 * f64::from(i)))
            .collect();
        assert_eq!(straightened(&straight), [(0.0, 0.0), (20.0, 40.0)]);
        let back = [(0.0, 0.0), (5.0, 0.0), (9.0, 0.0), (3.0, 0.0)];
        assert_eq!(straightened(&back), [(0.0, 0.0), (9.0, 0.0), (3.0, 0.0)]);
        assert_eq!(straightened(&back[..1]), [(0.0, 0.0)]);
    }

    #[test]
    fn dashes_of_2_with_gaps_of_1_on_a_length_of_7() {
        let dashes = dashed(&[(0.0, 0.0), (7.0, 0.0)], &[2.0, 1.0]);
        let ends: Vec<_> = dashes.iter().map(|d| (d[0].0, d[d.len() - 1].0)).collect();
        assert_eq!(ends, [(0.0, 2.0), (3.0, 5.0), (6.0, 7.0)]);
    }

    #[test]
    fn dashes_go_round_corners() {
        let dashes = dashed(&[(0.0, 0.0), (1.0, 0.0), (1.0, 3.0)], &[2.0, 1.0]);
        assert_eq!(
            dashes,
            [
                vec![(0.0, 0.0), (1.0, 0.0), (1.0, 1.0)],
                vec![(1.0, 2.0), (1.0, 3.0)]
            ]
        );
    }

    #[test]
    fn crossing_is_interpolated() {
        assert_eq!(crossings(&[(0.0, 0.0), (10.0, 20.0)], 2.5, 1), [5.0]);
        assert_eq!(
            crossings(&[(0.0, 0.0), (2.0, 2.0), (0.0, 4.0)], 1.0, 8),
            [1.0, 3.0]
        );
        assert!(crossings(&[(0.0, 0.0), (2.0, 2.0)], 3.0, 8).is_empty());
    }
}
