//! Half-section of a drawing: cut at the axis, mirrored where it is below it, compared where both halves are drawn.
//!
//! ```text
//! (x, r, bulge) below the axis is (x, −r, −bulge) above it; halves are alike when points at the same part of their lengths are
//! within 10⁻⁵ of the drawing's size
//! ```
//!
//! Pieces on the axis are left out. A drawing about another line is a fault that names the line.
//!
//! # Valid
//! Same as [`super::chain`].
//!
//! # References
//! - Own convention.

use super::chain::{Path, TOLERANCE, joined};
use super::dxf::group::Place;
use super::{ImportFault, Imported};
use crate::export::chain::length_m;
use msape::vehicle::body::check::At;
use msape::vehicle::body::points::{bulged, chain};
use msape::vehicle::crossing::distance_m;
use msape::vehicle::segment::{Point, Segment};
use numerics::math::{PI, asin, tan};

/// Distance below which points of one path coincide, as a fraction of the drawing's size.
const ONE_POINT: f64 = 1e-8;
/// Largest slope of a piece near the axis that counts as lying on it.
const ALONG: f64 = 0.1;
/// Largest number of points for which other axes are tried.
const MOST_TRIED: usize = 10_000;
/// Largest bulge of an arc that is not halved: three quarters of a circle.
const MOST_BULGE: f64 = 2.4;

/// Rows of x, r and bulge of the outline that the paths form, with messages, or the reasons why they form none.
pub fn rows(paths: Vec<Path>, mut remarks: Vec<String>) -> Result<Imported, Vec<ImportFault>> {
    let size_m = size_m(&paths);
    match outline(&paths, size_m) {
        Ok((path, half)) => {
            remarks.extend(half.map(str::to_owned));
            let rows = path.points.into_iter().map(Vec::from).collect();
            Ok(Imported { rows, remarks })
        }
        Err(mut faults) => {
            faults.extend(elsewhere(&paths, size_m));
            Err(faults)
        }
    }
}

/// Size of the drawing, m: the larger of its length along x and its largest distance from the axis.
fn size_m(paths: &[Path]) -> f64 {
    let points = paths.iter().flat_map(|path| &path.points);
    let [from, to, far] = points.fold([f64::INFINITY, f64::NEG_INFINITY, 0.0], |[a, b, r], p| {
        [a.min(p[0]), b.max(p[0]), p[1].abs().max(r)]
    });
    (to - from).max(far)
}

fn outline(paths: &[Path], size_m: f64) -> Result<(Path, Option<&'static str>), Vec<ImportFault>> {
    let near_m = TOLERANCE * size_m;
    let (mut above, mut below) = (Vec::new(), Vec::new());
    for path in paths {
        cut(path, size_m, &mut above, &mut below);
    }
    match (above.is_empty(), below.is_empty()) {
        (true, true) => Err(vec![ImportFault::Empty("line or arc off the axis")]),
        (false, true) => Ok((joined(above, near_m)?, None)),
        (true, false) => Ok((
            joined(below, near_m)?,
            Some("the half below the axis is drawn; it is mirrored"),
        )),
        (false, false) => {
            let (above, below) = (joined(above, near_m)?, joined(below, near_m)?);
            match difference(&above, &below, near_m) {
                Some((at, apart_m)) => Err(vec![ImportFault::Chain(format!(
                    "the halves above and below the axis differ: at {} by {apart_m:.6} m; draw one half, or both alike",
                    At(at)
                ))]),
                None => Ok((
                    above,
                    Some("both halves are drawn and are alike; the upper one is read"),
                )),
            }
        }
    }
}

/// Fault that names the lines about which the drawing would be an outline, other than y = 0.
fn elsewhere(paths: &[Path], size_m: f64) -> Option<ImportFault> {
    if paths.iter().map(|path| path.points.len()).sum::<usize>() > MOST_TRIED {
        return None;
    }
    let mut lines: Vec<String> = Vec::new();
    let turned = |swap: bool, shift: f64| {
        let place = move |&[x, y, bulge]: &[f64; 3]| match swap {
            // exchanging x and y is a reflection, which reverses the sense of arcs
            true => [y, x - shift, -bulge],
            false => [x, y - shift, bulge],
        };
        paths.iter().map(move |path| Path {
            points: path.points.iter().map(place).collect(),
            place: path.place,
        })
    };
    for (swap, name) in [(false, "y"), (true, "x")] {
        let across = paths
            .iter()
            .flat_map(|path| &path.points)
            .map(|p| p[usize::from(!swap)]);
        let [low, high] = across.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], y| {
            [a.min(y), b.max(y)]
        });
        for shift in [0.0, low, 0.5 * (low + high), high] {
            if !swap && shift == 0.0 {
                continue;
            }
            let moved: Vec<Path> = turned(swap, shift).collect();
            if outline(&moved, size_m).is_ok() {
                let shown = (shift * 1e6).round() / 1e6 + 0.0;
                lines.push(format!("{name} = {shown} m"));
            }
        }
    }
    lines.dedup();
    (!lines.is_empty()).then(|| {
        ImportFault::Chain(format!(
            "it is an outline about the line {}; if that is its axis, turn and move it so that the axis is y = 0, the nose at the lesser x",
            lines.join(" or ")
        ))
    })
}

/// Side of the axis on which a piece lies.
#[derive(Clone, Copy, PartialEq)]
enum Side {
    Above,
    Below,
    Axis,
}

/// Sorts the pieces of a path into those above and those below the axis, the latter mirrored.
fn cut(path: &Path, size_m: f64, above: &mut Vec<Path>, below: &mut Vec<Path>) {
    let (one_m, near_m) = (ONE_POINT * size_m, TOLERANCE * size_m);
    let mut run: Vec<[f64; 3]> = Vec::new();
    let mut side = Side::Axis;
    let mut close = |run: &mut Vec<[f64; 3]>, side: Side| {
        let points = std::mem::take(run);
        let start = points.first().map_or(Point::default(), at);
        // ignore paths smaller than the distance at which ends are joined
        if points
            .iter()
            .all(|point| distance_m(at(point), start) <= near_m)
        {
            return;
        }
        let place: Place = path.place;
        match side {
            Side::Above => above.push(Path { points, place }),
            Side::Below => {
                let mirror = |[x, r, bulge]: [f64; 3]| [x, -r, -bulge];
                let points = points.into_iter().map(mirror).collect();
                below.push(Path { points, place });
            }
            Side::Axis => {}
        }
    };
    for (from, to, bulge) in one_sided(&path.points, one_m) {
        let new = side_of(from, to, bulge, near_m);
        if new != side || from.r_m == 0.0 {
            close(&mut run, side);
            side = new;
        }
        match run.last_mut() {
            Some(last) => last[2] = bulge,
            None => run.push([from.x_m, from.r_m, bulge]),
        }
        run.push([to.x_m, to.r_m, 0.0]);
    }
    close(&mut run, side);
}

fn at(point: &[f64; 3]) -> Point {
    Point {
        x_m: point[0],
        r_m: point[1],
    }
}

fn side_of(from: Point, to: Point, bulge: f64, near_m: f64) -> Side {
    let [left, right, low, high] = bulged(from, to, bulge).bounds_m();
    if high.max(-low) <= near_m && high - low <= ALONG * (right - left) {
        Side::Axis
    } else if high > -low {
        Side::Above
    } else {
        Side::Below
    }
}

/// Pieces of a path, each on one side of the axis: start, end and bulge. Points within `one_m` of the axis are moved
/// onto it; those within `one_m` of the previous point are dropped.
fn one_sided(points: &[[f64; 3]], one_m: f64) -> Vec<(Point, Point, f64)> {
    let mut pieces = Vec::new();
    let snapped = |point: &[f64; 3]| match at(point) {
        Point { x_m, r_m } if r_m.abs() <= one_m => Point::on_axis(x_m),
        point => point,
    };
    let mut from = points.first().map(snapped).unwrap_or_default();
    for (point, next) in points.iter().zip(points.iter().skip(1)) {
        let (to, bulge) = (snapped(next), point[2]);
        if bulge.abs() > MOST_BULGE {
            // half of the arc has the bulge b / (1 + √(1 + b²)); the midpoint is b times half the chord to the right
            let middle = Point {
                x_m: 0.5 * (from.x_m + to.x_m + bulge * (to.r_m - from.r_m)),
                r_m: 0.5 * (from.r_m + to.r_m - bulge * (to.x_m - from.x_m)),
            };
            let half = bulge / (1.0 + (1.0 + bulge * bulge).sqrt());
            at_axis(from, middle, half, one_m, &mut pieces);
            at_axis(middle, to, half, one_m, &mut pieces);
        } else if distance_m(from, to) > one_m {
            at_axis(from, to, bulge, one_m, &mut pieces);
        } else {
            continue;
        }
        from = to;
    }
    pieces
}

/// A piece, split where it crosses the axis.
fn at_axis(from: Point, to: Point, bulge: f64, one_m: f64, pieces: &mut Vec<(Point, Point, f64)>) {
    let segment = bulged(from, to, bulge);
    let [_, _, low, high] = segment.bounds_m();
    if low >= -one_m || high <= one_m {
        pieces.push((from, to, bulge));
        return;
    }
    match segment {
        Segment::Line { start, end } => {
            let part = start.r_m / (start.r_m - end.r_m);
            let on_axis = Point::on_axis(start.x_m + part * (end.x_m - start.x_m));
            pieces.extend([(from, on_axis, 0.0), (on_axis, to, 0.0)]);
        }
        Segment::Arc {
            center,
            radius_m,
            start_angle_rad,
            sweep_rad,
            ..
        } => {
            let up = asin((-center.r_m / radius_m).clamp(-1.0, 1.0));
            let turned = |angle: f64| {
                let turn = ((angle - start_angle_rad) * sweep_rad.signum()).rem_euclid(2.0 * PI);
                turn * sweep_rad.signum()
            };
            let mut cuts: Vec<f64> = [up, PI - up].map(turned).to_vec();
            cuts.retain(|turn| turn.abs() < sweep_rad.abs());
            cuts.sort_unstable_by(|a, b| a.abs().total_cmp(&b.abs()));
            let mut before = (from, 0.0);
            for turn in cuts {
                let x_m = center.x_m + radius_m * numerics::math::cos(start_angle_rad + turn);
                let on_axis = Point::on_axis(x_m);
                if distance_m(before.0, on_axis) > one_m {
                    pieces.push((before.0, on_axis, tan((turn - before.1) / 4.0)));
                    before = (on_axis, turn);
                }
            }
            if distance_m(before.0, to) > one_m {
                pieces.push((before.0, to, tan((sweep_rad - before.1) / 4.0)));
            }
        }
    }
}

/// Point where two paths are more than `near_m` apart, and the distance; compared at equal fractions of their lengths.
fn difference(one: &Path, other: &Path, near_m: f64) -> Option<(Point, f64)> {
    let [mut one, mut other] = [one, other].map(Walk::new);
    let mut parts: Vec<f64> = one.parts().chain(other.parts()).collect();
    parts.sort_unstable_by(f64::total_cmp);
    let middles: Vec<f64> = parts
        .windows(2)
        .map(|pair| 0.5 * (pair[0] + pair[1]))
        .collect();
    parts.extend(middles);
    parts.sort_unstable_by(f64::total_cmp);
    parts.into_iter().find_map(|part| {
        let [a, b] = [one.at(part), other.at(part)];
        let apart_m = distance_m(a, b);
        (apart_m > near_m).then_some((a, apart_m))
    })
}

/// Walk along a path by fraction of its length.
struct Walk {
    /// Segments, and the fraction of the length at which each ends.
    segments: Vec<(Segment, f64)>,
    next: usize,
}

impl Walk {
    fn new(path: &Path) -> Self {
        let rows: Vec<Vec<f64>> = path.points.iter().map(|point| point.to_vec()).collect();
        let segments = chain(&rows).segments;
        let whole: f64 = segments.iter().map(length_m).sum();
        let mut gone = 0.0;
        let segments = segments.into_iter().map(|segment| {
            gone += length_m(&segment);
            (segment, gone / whole)
        });
        Self {
            segments: segments.collect(),
            next: 0,
        }
    }

    fn parts(&self) -> impl Iterator<Item = f64> {
        self.segments.iter().map(|(_, part)| *part)
    }

    /// The point at a fraction of the length, which must not be less than in the previous call.
    fn at(&mut self, part: f64) -> Point {
        while self.next + 1 < self.segments.len()
            && self
                .segments
                .get(self.next)
                .is_some_and(|(_, end)| *end < part)
        {
            self.next += 1;
        }
        let before = self.next.checked_sub(1).and_then(|i| self.segments.get(i));
        let from = before.map_or(0.0, |(_, part)| *part);
        self.segments
            .get(self.next)
            .map_or(Point::default(), |(segment, to)| {
                let inside = (part - from) / (to - from);
                segment.at(if inside.is_finite() {
                    inside.clamp(0.0, 1.0)
                } else {
                    1.0
                })
            })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn path(points: &[[f64; 3]]) -> Path {
        Path {
            points: points.to_vec(),
            place: Place::Line(1),
        }
    }

    fn read(paths: &[Path]) -> Result<(Vec<Vec<f64>>, String), String> {
        match rows(paths.to_vec(), Vec::new()) {
            Ok(Imported { rows, remarks }) => Ok((rows, remarks.join("; "))),
            Err(faults) => Err(faults
                .iter()
                .map(ToString::to_string)
                .collect::<Vec<_>>()
                .join("; ")),
        }
    }

    const CONE: [[f64; 3]; 3] = [[0.0, 0.0, 0.0], [2.0, 1.0, 0.0], [2.0, 0.0, 0.0]];

    fn mapped(map: impl Fn([f64; 3]) -> [f64; 3]) -> Path {
        path(&CONE.map(map))
    }

    #[test]
    fn the_lower_half_is_mirrored_and_both_are_compared() {
        let upper = path(&CONE);
        let lower = mapped(|[x, r, b]| [x, -r, b]);
        let (rows, said) = read(std::slice::from_ref(&lower)).unwrap();
        assert_eq!(rows, CONE.map(Vec::from));
        assert!(said.contains("mirrored"));
        let (rows, said) = read(&[upper.clone(), lower]).unwrap();
        assert_eq!(rows, CONE.map(Vec::from));
        assert!(said.contains("alike"));
        let shorter = mapped(|[x, r, b]| [x, -0.99 * r, b]);
        let fault = read(&[upper, shorter]).unwrap_err();
        assert!(fault.contains("differ: at x = "), "{fault}");
    }

    #[test]
    fn a_closed_line_about_the_axis_is_cut_at_it() {
        // a square on its corner, started off the axis: a double cone of height 1 each
        let square = [[1.0, 1.0], [2.0, 0.0], [1.0, -1.0], [0.0, 0.0], [1.0, 1.0]];
        let (rows, _) = read(&[path(&square.map(|[x, r]| [x, r, 0.0]))]).unwrap();
        assert_eq!(rows, [[0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [2.0, 0.0, 0.0]]);
        // a circle as two half-circles, cut at the top and at the bottom
        let circle = [[1.0, 1.0, 1.0], [1.0, -1.0, 1.0], [1.0, 1.0, 0.0]];
        let (rows, _) = read(&[path(&circle)]).unwrap();
        assert!((rows[0][0].abs() + (rows[2][0] - 2.0).abs()) < 1e-15);
        assert!((rows[0][2] + tan(PI / 8.0)).abs() < 1e-15);
        // as one arc of almost a full turn with its ends far above
        let bulge = tan(0.99 * PI / 2.0);
        let gap = numerics::math::sin(0.01 * PI);
        let most = [
            [1.0 - gap, 0.999_506_560_365_731_6, bulge],
            [1.0 + gap, 0.999_506_560_365_731_6, 0.0],
        ];
        let lid = [
            [1.0 - gap, 0.999_506_560_365_731_6, -0.0],
            [1.0 + gap, 0.999_506_560_365_731_6, 0.0],
        ];
        assert!(
            read(&[path(&most), path(&lid)])
                .unwrap_err()
                .contains("differ")
        );
    }

    #[test]
    fn a_drawing_about_another_line_says_which() {
        for (map, said) in [
            (mapped(|[x, r, b]| [r, x, b]), "about the line x = 0 m"),
            (
                mapped(|[x, r, b]| [x, r + 3.0, b]),
                "about the line y = 3 m",
            ),
            (
                mapped(|[x, r, b]| [5.0 - r, x + 7.0, b]),
                "about the line x = 5 m",
            ),
        ] {
            let fault = read(&[map]).unwrap_err();
            assert!(fault.contains(said), "{fault}");
        }
    }

    #[test]
    fn pieces_along_the_axis_and_slips_over_it_do_not_count() {
        let mut points = CONE.to_vec();
        points[2][1] = -1e-6; // beyond the axis by less than the distance at which ends are joined
        points.push([0.0, 0.0, 0.0]);
        let (rows, said) =
            read(&[path(&points), path(&[[-1.0, 0.0, 0.0], [9.0, 1e-7, 0.0]])]).unwrap();
        assert_eq!((rows.len(), said.as_str()), (3, ""));
        assert_eq!(rows[2][1], 0.0);
    }
}
