//! Smooth curves as pairs of arcs (biarcs): a rational Bézier curve is halved until two arcs that are tangent to it at
//! its ends, and to each other, approximate it.
//!
//! ```text
//! d = [−V·T + √((V·T)² + 2 (1 − T₀·T₁) V·V)] / [2 (1 − T₀·T₁)],  V = P₁ − P₀,  T = T₀ + T₁;  the arcs meet at (P₀ + P₁ + d (T₀ − T₁)) / 2
//! bulge = tan(α / 2), α from the tangent to the chord
//! ```
//!
//! with unit tangents T₀, T₁ at the ends P₀, P₁, lengths in m, α in rad.
//!
//! # Valid
//! Positive weights. Deviations are checked at fifteen points of each piece; a piece is halved at most twelve times.
//!
//! # References
//! - \[bolton-1975\] biarcs; \[piegl-tiller-1997\] section 1.4 (rational Bézier curves, de Casteljau's algorithm).

use super::affine::{Affine, cross, dot};
use msape::vehicle::body::points::bulged;
use msape::vehicle::segment::{Point, Segment};
use numerics::math::{atan2, hypot, tan};

/// Largest number of halvings.
const DEPTH: u32 = 12;
/// Number of intervals of a piece at whose inner ends the deviation is checked.
const LOOKS: u32 = 16;
/// Half the largest sweep of an arc of a pair, rad.
const MOST_TURN: f64 = 0.6;
/// Bulge below which an arc counts as a line.
const STRAIGHT: f64 = 1e-9;

/// Rational Bézier curve: weighted control points (w x, w y, w).
#[derive(Clone, Debug, PartialEq)]
pub struct Bezier(pub Vec<[f64; 3]>);

impl Bezier {
    /// The curve mapped by `map`.
    pub fn moved(&self, map: &Affine) -> Self {
        let place = |&[x, y, w]: &[f64; 3]| {
            let [x, y] = map.point([x / w, y / w]);
            [x * w, y * w, w]
        };
        Self(self.0.iter().map(place).collect())
    }

    /// Largest distance of a control point from the x axis.
    pub fn reach(&self) -> f64 {
        let distances = self.0.iter().map(|[_, y, w]| (y / w).abs());
        distances.fold(0.0, f64::max)
    }

    /// Start point.
    pub fn start(&self) -> [f64; 2] {
        self.at(0.0).0
    }

    /// End point.
    pub fn end(&self) -> [f64; 2] {
        self.at(1.0).0
    }

    /// Point and derivative at `t` in 0..1.
    fn at(&self, t: f64) -> ([f64; 2], [f64; 2]) {
        let mut level = self.0.clone();
        while level.len() > 2 {
            for i in 1..level.len() {
                if let Some([a, b]) = level
                    .get(i - 1..=i)
                    .and_then(|pair| <[_; 2]>::try_from(pair).ok())
                    && let Some(slot) = level.get_mut(i - 1)
                {
                    *slot = [0, 1, 2].map(|k| a[k] + t * (b[k] - a[k]));
                }
            }
            level.pop();
        }
        let (a, b) = match level.as_slice() {
            [a, b] => (*a, *b),
            [a] => (*a, *a),
            _ => ([0.0, 0.0, 1.0], [0.0, 0.0, 1.0]),
        };
        let degree = self.0.len().saturating_sub(1) as f64;
        let [x, y, w] = [0, 1, 2].map(|k| a[k] + t * (b[k] - a[k]));
        let point = [x / w, y / w];
        let slope = [0, 1].map(|k| degree * ((b[k] - a[k]) - point[k] * (b[2] - a[2])) / w);
        (point, slope)
    }

    /// Point and unit tangent at `t`; where the derivative vanishes, the tangent from the side of `inside`.
    fn tangent(&self, t: f64, inside: f64) -> ([f64; 2], [f64; 2]) {
        let (point, slope) = self.at(t);
        let (other, _) = self.at(t + 1e-4 * (inside - t));
        let toward = (inside - t).signum();
        let secant = [0, 1].map(|k| toward * (other[k] - point[k]));
        let stands = hypot(slope[0], slope[1]) * 1e-4 * (inside - t).abs()
            < 0.1 * hypot(secant[0], secant[1]);
        (point, unit(if stands { secant } else { slope }))
    }
}

fn unit(v: [f64; 2]) -> [f64; 2] {
    let length = hypot(v[0], v[1]);
    match length > 0.0 {
        true => v.map(|part| part / length),
        false => [1.0, 0.0],
    }
}

/// Points and bulges of consecutive curves, to within `tolerance`; stops at about `room` points.
pub fn flattened(curves: &[Bezier], tolerance: f64, room: usize) -> Vec<[f64; 3]> {
    let mut points = Vec::new();
    for curve in curves {
        halve(curve, [0.0, 1.0], tolerance, DEPTH, &mut points);
        if points.len() > room {
            break;
        }
    }
    if let Some(curve) = curves.last() {
        let ([x, y], _) = curve.at(1.0);
        points.push([x, y, 0.0]);
    }
    points
}

fn halve(curve: &Bezier, span: [f64; 2], tolerance: f64, depth: u32, points: &mut Vec<[f64; 3]>) {
    let [from, to] = span;
    let (start, t0) = curve.tangent(from, to);
    let (end, t1) = curve.tangent(to, from);
    let pair = pair(start, t0, end, t1).filter(|pair| follows(curve, span, pair, end, tolerance));
    match pair {
        Some([first, second]) if first[2].abs().max(second[2].abs()) < STRAIGHT => {
            points.push([first[0], first[1], 0.0]);
        }
        Some(pair) => points.extend(pair),
        // smallest piece reached: a line instead of arcs
        None if depth == 0 => points.push([start[0], start[1], 0.0]),
        None => {
            let middle = 0.5 * (from + to);
            halve(curve, [from, middle], tolerance, depth - 1, points);
            halve(curve, [middle, to], tolerance, depth - 1, points);
        }
    }
}

/// Start and bulge of two arcs from `start` to `end` with the tangents there; `None` where their sweep would be too
/// large.
fn pair(start: [f64; 2], t0: [f64; 2], end: [f64; 2], t1: [f64; 2]) -> Option<[[f64; 3]; 2]> {
    let v = [end[0] - start[0], end[1] - start[1]];
    let vt = dot(v, [t0[0] + t1[0], t0[1] + t1[1]]);
    // 1 − T₀·T₁ without cancellation
    let apart = [t1[0] - t0[0], t1[1] - t0[1]];
    let bend = 0.5 * dot(apart, apart);
    let root = (vt * vt + 2.0 * bend * dot(v, v)).sqrt();
    // the root in a form that holds for parallel tangents too
    let d = dot(v, v) / (vt + root);
    if !(vt > 0.0 && d.is_finite()) {
        return None;
    }
    let middle = [0, 1].map(|k| 0.5 * (start[k] + end[k] - d * apart[k]));
    let first = angle(t0, [middle[0] - start[0], middle[1] - start[1]]);
    let second = angle([end[0] - middle[0], end[1] - middle[1]], t1);
    let turns = first.abs().max(second.abs());
    (turns <= MOST_TURN).then(|| {
        [
            [start[0], start[1], tan(0.5 * first)],
            [middle[0], middle[1], tan(0.5 * second)],
        ]
    })
}

fn angle(from: [f64; 2], to: [f64; 2]) -> f64 {
    atan2(cross(from, to), dot(from, to))
}

/// Whether the curve stays within the tolerance of the arcs.
fn follows(
    curve: &Bezier,
    [from, to]: [f64; 2],
    [first, second]: &[[f64; 3]; 2],
    end: [f64; 2],
    tolerance: f64,
) -> bool {
    let [a, b, c] =
        [[first[0], first[1]], [second[0], second[1]], end].map(|[x_m, r_m]| Point { x_m, r_m });
    let arcs = [bulged(a, b, first[2]), bulged(b, c, second[2])];
    let along = [c.x_m - a.x_m, c.r_m - a.r_m];
    (1..LOOKS).all(|k| {
        let t = from + (to - from) * f64::from(k) / f64::from(LOOKS);
        let ([x, y], _) = curve.at(t);
        let beyond = dot([x - b.x_m, y - b.r_m], along) > 0.0;
        distance(&arcs[usize::from(beyond)], [x, y]) <= tolerance
    })
}

/// Distance of a point from the line or circle of a segment.
fn distance(segment: &Segment, [x, y]: [f64; 2]) -> f64 {
    match *segment {
        Segment::Line { start, end } => {
            let along = unit([end.x_m - start.x_m, end.r_m - start.r_m]);
            cross(along, [x - start.x_m, y - start.r_m]).abs()
        }
        Segment::Arc {
            center, radius_m, ..
        } => (hypot(x - center.x_m, y - center.r_m) - radius_m).abs(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_circle_is_two_arcs_and_a_line_is_a_line() {
        let w = 0.5_f64.sqrt();
        let quarter = Bezier(vec![[1.0, 0.0, 1.0], [w, w, w], [0.0, 1.0, 1.0]]);
        let points = flattened(&[quarter], 1e-12, 100);
        assert_eq!(points.len(), 3);
        // tan(45°/4) each
        assert!((points[0][2] - tan(std::f64::consts::PI / 16.0)).abs() < 1e-14);
        assert!((points[1][0] - w).abs() < 1e-15 && (points[1][1] - w).abs() < 1e-15);
        let line = Bezier(vec![[0.0, 0.0, 1.0], [1.0, 2.0, 1.0], [3.0, 6.0, 1.0]]);
        assert_eq!(
            flattened(&[line], 1e-12, 100),
            [[0.0, 0.0, 0.0], [3.0, 6.0, 0.0]]
        );
    }

    #[test]
    fn a_parabola_is_followed_and_the_error_falls_with_the_cube() {
        // y = x² from −1 to 1: ∫ y dx = 2/3
        let curve = Bezier(vec![[-1.0, 1.0, 1.0], [0.0, -1.0, 1.0], [1.0, 1.0, 1.0]]);
        let counts = [1e-4, 1e-7].map(|tolerance| {
            let points = flattened(std::slice::from_ref(&curve), tolerance, 10_000);
            let area: f64 = points
                .windows(2)
                .map(|p| {
                    let [a, b] = [p[0], p[1]].map(|q| Point {
                        x_m: q[0],
                        r_m: q[1],
                    });
                    bulged(a, b, p[0][2]).integrals().r_dx
                })
                .sum();
            assert!((area - 2.0 / 3.0).abs() < 0.5 * tolerance, "{area}");
            points.len() as f64
        });
        assert!(counts[1] / counts[0] < 16.0, "{counts:?}");
    }

    #[test]
    fn a_cusp_does_not_stop_it() {
        let cusp = Bezier(vec![
            [0.0, 0.0, 1.0],
            [1.0, 1.0, 1.0],
            [0.0, 1.0, 1.0],
            [1.0, 0.0, 1.0],
        ]);
        let still = Bezier(vec![[0.0, 0.0, 1.0], [0.0, 0.0, 1.0], [1.0, 1.0, 1.0]]);
        for curve in [cusp, still] {
            let points = flattened(&[curve], 1e-7, 100_000);
            assert!(points.iter().flatten().all(|number| number.is_finite()));
        }
    }
}
