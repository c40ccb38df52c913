//! Points at which two segments meet.
//!
//! ```text
//! line, line: p + t u = q + s v         line, arc: |p + t u − c| = R         arc, arc: |x − c₁| = R₁, |x − c₂| = R₂
//! ```
//!
//! with t and s in 0..1 and lengths in m. Segments that lie on each other meet at the ends of the piece that they share.
//!
//! # Valid
//! Any two segments of positive length.
//!
//! # References
//! - Elementary plane geometry.

use crate::vehicle::segment::{Point, Segment};
use numerics::math::{atan2, hypot};

/// Distance of two points, m.
pub fn distance_m(a: Point, b: Point) -> f64 {
    hypot(a.x_m - b.x_m, a.r_m - b.r_m)
}

/// Points that two segments share to within `tolerance_m`; a few of them where they lie on each other.
pub fn meetings(a: &Segment, b: &Segment, tolerance_m: f64) -> Vec<Point> {
    let ([al, ar, ad, au], [bl, br, bd, bu]) = (a.bounds_m(), b.bounds_m());
    let apart = al > br + tolerance_m
        || bl > ar + tolerance_m
        || ad > bu + tolerance_m
        || bd > au + tolerance_m;
    if apart {
        return Vec::new();
    }
    let mut points = match (a, b) {
        (Segment::Line { .. }, Segment::Line { .. }) => line_line(a, b),
        (Segment::Line { .. }, Segment::Arc { .. }) => line_arc(a, b),
        (Segment::Arc { .. }, Segment::Line { .. }) => line_arc(b, a),
        (Segment::Arc { .. }, Segment::Arc { .. }) => arc_arc(a, b),
    };
    points.retain(|p| is_on(a, *p, tolerance_m) && is_on(b, *p, tolerance_m));
    points.dedup_by(|p, q| distance_m(*p, *q) <= tolerance_m);
    // an end of one on the other: tangents, and segments that lie on each other
    for (end, other) in [(a.start(), b), (a.end(), b), (b.start(), a), (b.end(), a)] {
        let new = points.iter().all(|p| distance_m(*p, end) > tolerance_m);
        if new && is_on(other, end, tolerance_m) {
            points.push(end);
        }
    }
    points
}

/// Whether a point lies on a segment to within `tolerance_m`.
pub fn is_on(segment: &Segment, point: Point, tolerance_m: f64) -> bool {
    if distance_m(point, segment.start()) <= tolerance_m
        || distance_m(point, segment.end()) <= tolerance_m
    {
        return true;
    }
    match *segment {
        Segment::Line { start, end } => {
            let (dx, dr) = (end.x_m - start.x_m, end.r_m - start.r_m);
            let length = hypot(dx, dr);
            let (px, pr) = (point.x_m - start.x_m, point.r_m - start.r_m);
            let (along, across) = ((px * dx + pr * dr) / length, (px * dr - pr * dx) / length);
            across.abs() <= tolerance_m && (0.0..=length).contains(&along)
        }
        Segment::Arc {
            center, radius_m, ..
        } => {
            let off = distance_m(point, center) - radius_m;
            let angle = atan2(point.r_m - center.r_m, point.x_m - center.x_m);
            off.abs() <= tolerance_m && segment.sweeps(angle)
        }
    }
}

fn line_line(a: &Segment, b: &Segment) -> Vec<Point> {
    let (p, q) = (a.start(), b.start());
    let (ux, ur) = (a.end().x_m - p.x_m, a.end().r_m - p.r_m);
    let (vx, vr) = (b.end().x_m - q.x_m, b.end().r_m - q.r_m);
    let cross = ux * vr - ur * vx;
    // parallel lines meet at ends only
    if cross.abs() <= 1e-14 * hypot(ux, ur) * hypot(vx, vr) {
        return Vec::new();
    }
    let t = ((q.x_m - p.x_m) * vr - (q.r_m - p.r_m) * vx) / cross;
    vec![Point {
        x_m: p.x_m + t * ux,
        r_m: p.r_m + t * ur,
    }]
}

fn line_arc(line: &Segment, arc: &Segment) -> Vec<Point> {
    let Segment::Arc {
        center, radius_m, ..
    } = *arc
    else {
        return Vec::new();
    };
    let (p, end) = (line.start(), line.end());
    let length = distance_m(p, end);
    let (ux, ur) = ((end.x_m - p.x_m) / length, (end.r_m - p.r_m) / length);
    let (cx, cr) = (center.x_m - p.x_m, center.r_m - p.r_m);
    let (along, across) = (cx * ux + cr * ur, cx * ur - cr * ux);
    // a line that touches may miss by rounding
    let half = radius_m * radius_m - across * across;
    if half < -1e-9 * radius_m * radius_m {
        return Vec::new();
    }
    let half = half.max(0.0).sqrt();
    let at = |t: f64| Point {
        x_m: p.x_m + t * ux,
        r_m: p.r_m + t * ur,
    };
    vec![at(along - half), at(along + half)]
}

fn arc_arc(a: &Segment, b: &Segment) -> Vec<Point> {
    let (
        &Segment::Arc {
            center: c,
            radius_m: r,
            ..
        },
        &Segment::Arc {
            center: d,
            radius_m: s,
            ..
        },
    ) = (a, b)
    else {
        return Vec::new();
    };
    let between = distance_m(c, d);
    if between <= 1e-12 * r {
        return Vec::new();
    }
    let (ux, ur) = ((d.x_m - c.x_m) / between, (d.r_m - c.r_m) / between);
    let along = (between * between + r * r - s * s) / (2.0 * between);
    let half = r * r - along * along;
    if half < -1e-9 * r * r {
        return Vec::new();
    }
    let half = half.max(0.0).sqrt();
    let at = |across: f64| Point {
        x_m: c.x_m + along * ux - across * ur,
        r_m: c.r_m + along * ur + across * ux,
    };
    vec![at(half), at(-half)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use numerics::math::PI;

    fn point(x_m: f64, r_m: f64) -> Point {
        Point { x_m, r_m }
    }

    fn line(x0: f64, r0: f64, x1: f64, r1: f64) -> Segment {
        Segment::Line {
            start: point(x0, r0),
            end: point(x1, r1),
        }
    }

    fn found(a: &Segment, b: &Segment) -> Vec<Point> {
        let mut points = meetings(a, b, 1e-9);
        points.sort_by(|p, q| p.x_m.total_cmp(&q.x_m));
        points
    }

    #[test]
    fn diagonals_of_a_square_cross_in_its_middle() {
        assert_eq!(
            found(&line(0.0, 0.0, 2.0, 2.0), &line(0.0, 2.0, 2.0, 0.0)),
            [point(1.0, 1.0)]
        );
        assert!(found(&line(0.0, 0.0, 1.0, 1.0), &line(2.0, 0.0, 3.0, 1.0)).is_empty());
    }

    #[test]
    fn a_chord_cuts_a_half_circle_where_it_is() {
        let arc = Segment::arc(point(0.0, 0.0), 5.0, 0.0, PI);
        // 3² + 4² = 5²
        let cuts = found(&line(-6.0, 4.0, 6.0, 4.0), &arc);
        assert!(distance_m(cuts[0], point(-3.0, 4.0)) < 1e-14);
        assert!(distance_m(cuts[1], point(3.0, 4.0)) < 1e-14);
        assert!(found(&line(-6.0, -4.0, 6.0, -4.0), &arc).is_empty());
        // tangent
        assert_eq!(found(&line(-6.0, 5.0, 6.0, 5.0), &arc).len(), 1);
    }

    #[test]
    fn two_circles_of_5_at_a_distance_of_6_meet_4_off_the_line() {
        let one = Segment::arc(point(0.0, 0.0), 5.0, 0.0, PI);
        let other = Segment::arc(point(6.0, 0.0), 5.0, 0.0, PI);
        let cuts = found(&one, &other);
        assert!(cuts.len() == 1 && distance_m(cuts[0], point(3.0, 4.0)) < 1e-14);
    }

    #[test]
    fn lines_on_each_other_share_the_ends_of_the_common_piece() {
        let shared = found(&line(0.0, 1.0, 2.0, 1.0), &line(1.0, 1.0, 3.0, 1.0));
        assert_eq!(shared, [point(1.0, 1.0), point(2.0, 1.0)]);
    }
}
