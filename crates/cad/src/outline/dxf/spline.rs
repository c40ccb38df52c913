//! Conversion of a SPLINE to rational Bézier curves: from knots, control points and weights, or through fit points.
//!
//! ```text
//! control point j of the span [a, b]: the blossom of the span at n − j times a and j times b
//! fit points: h_i m_{i−1} + 2 (h_{i−1} + h_i) m_i + h_{i−1} m_{i+1} = 3 (h_i Δ_{i−1} + h_{i−1} Δ_i)
//! ```
//!
//! with the degree n, chords h as the steps of the parameter, slopes Δ of the chords and m of the curve. Without a
//! given tangent the curvature at an end is zero; a closed curve overlaps itself at both ends, so that it closes
//! smoothly.
//!
//! # Valid
//! Degrees up to 25, non-decreasing knots, positive weights; the spans between knots n and N, with N the number of
//! control points, which holds for clamped and for periodic knots.
//!
//! # References
//! - \[piegl-tiller-1997\] sections 5.4 (decomposition) and 9.3 (cubic interpolation), equation 9.5 for the chords;
//!   \[autodesk-dxf\] SPLINE.

use super::biarc::Bezier;
use numerics::math::hypot;

/// Highest degree read.
const MOST_DEGREE: usize = 25;
/// Largest decrease of a knot that counts as rounding, as a fraction of the range of the knots.
const ROUNDING: f64 = 1e-9;
/// Points by which a closed curve through fit points overlaps itself at each end: 0.27¹⁶ is below 1e-9.
const OVERLAP: usize = 16;

/// Bézier curves of a spline of `degree` with its knots and weighted control points (w x, w y, w), or what is wrong
/// with it.
pub fn decomposed(
    degree: usize,
    knots: &[f64],
    points: &[[f64; 3]],
) -> Result<Vec<Bezier>, String> {
    if !(1..=MOST_DEGREE).contains(&degree) {
        return Err(format!(
            "got the degree {degree}, must be 1 to {MOST_DEGREE}"
        ));
    }
    if points.len() <= degree {
        return Err(format!(
            "got {} control points, must be more than the degree {degree}",
            points.len()
        ));
    }
    let wanted = points.len() + degree + 1;
    if knots.len() != wanted {
        return Err(format!(
            "got {} knots, must be {wanted}: control points + degree + 1",
            knots.len()
        ));
    }
    let knots = &risen(knots)?;
    if points.iter().any(|point| point[2] <= 0.0) {
        return Err("got a weight of zero or less, must be above 0".to_owned());
    }
    let mut curves = Vec::new();
    for span in degree..points.len() {
        let (Some(&[a, b]), Some(local), Some(around)) = (
            knots.get(span..=span + 1).and_then(<[f64]>::first_chunk),
            points.get(span - degree..=span),
            knots.get(span - degree + 1..=span + degree),
        ) else {
            continue;
        };
        if b <= a {
            continue;
        }
        let control = |j: usize| blossom(local, around, |level| if level < j { b } else { a });
        curves.push(Bezier((0..=degree).map(control).collect()));
    }
    match curves.is_empty() {
        true => Err("got knots that are all the same".to_owned()),
        false => Ok(curves),
    }
}

/// Non-decreasing knots: a knot that falls by rounding takes the value of the one before.
fn risen(knots: &[f64]) -> Result<Vec<f64>, String> {
    let mut risen: Vec<f64> = Vec::with_capacity(knots.len());
    let range = knots
        .last()
        .zip(knots.first())
        .map_or(0.0, |(to, from)| to - from);
    for &knot in knots {
        let before = risen.last().copied().unwrap_or(knot);
        if before - knot > ROUNDING * range {
            return Err(format!(
                "got the knot {knot} after {before}, must not be less"
            ));
        }
        risen.push(before.max(knot));
    }
    Ok(risen)
}

/// Value of the polar form (blossom) of a span: `local` are its control points, `around` its knots.
fn blossom(local: &[[f64; 3]], around: &[f64], argument: impl Fn(usize) -> f64) -> [f64; 3] {
    let degree = local.len() - 1;
    let mut level = local.to_vec();
    for r in 1..=degree {
        let t = argument(r - 1);
        let next = level
            .iter()
            .zip(level.iter().skip(1))
            .enumerate()
            .map(|(i, (p, q))| {
                // knots i + r and i + degree + 1 of the span's neighborhood, without its first knot
                let knot = |k: usize| around.get(k).copied().unwrap_or(0.0);
                let (low, high) = (knot(i + r - 1), knot(i + degree));
                let part = (t - low) / (high - low);
                [0, 1, 2].map(|k| p[k] + part * (q[k] - p[k]))
            });
        level = next.collect();
    }
    level.first().copied().unwrap_or([0.0, 0.0, 1.0])
}

/// Cubic curves through points, with tangents at the ends where given.
pub fn through(points: &[[f64; 2]], tangents: [Option<[f64; 2]>; 2], closed: bool) -> Vec<Bezier> {
    let mut points = points.to_vec();
    points.dedup();
    if !closed {
        return open(&points, tangents);
    }
    if points.first() == points.last() {
        points.pop();
    }
    let count = points.len();
    let before = (count * OVERLAP).saturating_sub(OVERLAP);
    let round: Vec<[f64; 2]> = points
        .iter()
        .cycle()
        .skip(before)
        .take(count + 2 * OVERLAP + 1)
        .copied()
        .collect();
    open(&round, [None; 2])
        .into_iter()
        .skip(OVERLAP)
        .take(count)
        .collect()
}

fn open(points: &[[f64; 2]], tangents: [Option<[f64; 2]>; 2]) -> Vec<Bezier> {
    let chords: Vec<(f64, [f64; 2])> = points
        .windows(2)
        .map(|pair| {
            let step = [0, 1].map(|k| pair[1][k] - pair[0][k]);
            let length = hypot(step[0], step[1]);
            (length, step.map(|part| part / length))
        })
        .collect();
    let ([(_, first), ..], [.., (_, last)]) = (chords.as_slice(), chords.as_slice()) else {
        return Vec::new();
    };
    // rows (lower, main and upper diagonal, right side) of the tridiagonal system for the slopes
    let end = |tangent: Option<[f64; 2]>, chord: &[f64; 2]| match tangent {
        Some(tangent) => (1.0, 0.0, tangent),
        None => (2.0, 1.0, chord.map(|part| 3.0 * part)),
    };
    let (middle, above, right) = end(tangents[0], first);
    let mut rows = vec![(0.0, middle, above, right)];
    rows.extend(
        chords
            .iter()
            .zip(chords.iter().skip(1))
            .map(|(&(h0, d0), &(h1, d1))| {
                let right = [0, 1].map(|k| 3.0 * (h1 * d0[k] + h0 * d1[k]));
                (h1, 2.0 * (h0 + h1), h0, right)
            }),
    );
    let (middle, below, right) = end(tangents[1], last);
    rows.push((below, middle, 0.0, right));
    // Thomas algorithm: forward elimination, then back substitution
    let mut passed: Vec<(f64, [f64; 2])> = Vec::with_capacity(rows.len());
    for (below, middle, above, right) in rows {
        let (ratio, value) = passed.last().copied().unwrap_or((0.0, [0.0; 2]));
        let pivot = middle - below * ratio;
        passed.push((
            above / pivot,
            [0, 1].map(|k| (right[k] - below * value[k]) / pivot),
        ));
    }
    let mut slopes: Vec<[f64; 2]> = Vec::with_capacity(passed.len());
    for (ratio, value) in passed.into_iter().rev() {
        let next = slopes.last().copied().unwrap_or([0.0; 2]);
        slopes.push([0, 1].map(|k| value[k] - ratio * next[k]));
    }
    slopes.reverse();
    let ends = points.windows(2).zip(slopes.windows(2));
    ends.zip(&chords)
        .map(|((p, m), (h, _))| {
            let third = h / 3.0;
            let before = [0, 1].map(|k| p[0][k] + third * m[0][k]);
            let after = [0, 1].map(|k| p[1][k] - third * m[1][k]);
            Bezier(
                [p[0], before, after, p[1]]
                    .map(|[x, y]| [x, y, 1.0])
                    .to_vec(),
            )
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_clamped_span_is_its_own_bezier_curve() {
        let points = [
            [0.0, 0.0, 1.0],
            [1.0, 2.0, 1.0],
            [3.0, 1.0, 1.0],
            [4.0, 0.0, 1.0],
        ];
        let knots = [0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0];
        assert_eq!(
            decomposed(3, &knots, &points).unwrap(),
            [Bezier(points.to_vec())]
        );
        assert!(
            decomposed(3, &knots[1..], &points)
                .unwrap_err()
                .contains("got 7 knots, must be 8")
        );
        assert!(decomposed(0, &knots, &points).is_err());
        assert!(decomposed(3, &[0.0; 8], &points).is_err());
    }

    #[test]
    fn a_uniform_quadratic_runs_from_middle_to_middle() {
        // knots 0, 1, 2 ...: each span runs between the midpoints of successive control points
        let points = [
            [0.0, 0.0, 1.0],
            [2.0, 0.0, 1.0],
            [2.0, 2.0, 1.0],
            [0.0, 2.0, 1.0],
        ];
        let knots: Vec<f64> = (0..7).map(f64::from).collect();
        let spans = decomposed(2, &knots, &points).unwrap();
        assert_eq!(spans.len(), 2);
        assert_eq!(
            spans[0],
            Bezier(vec![[1.0, 0.0, 1.0], [2.0, 0.0, 1.0], [2.0, 1.0, 1.0]])
        );
        assert_eq!(
            spans[1],
            Bezier(vec![[2.0, 1.0, 1.0], [2.0, 2.0, 1.0], [1.0, 2.0, 1.0]])
        );
    }

    #[test]
    fn no_points_are_no_curve() {
        for closed in [false, true] {
            assert!(through(&[], [None; 2], closed).is_empty());
        }
    }

    #[test]
    fn a_curve_through_points_of_a_line_is_the_line_and_a_closed_one_is_round() {
        let line = through(&[[0.0, 0.0], [1.0, 1.0], [3.0, 3.0]], [None; 2], false);
        for Bezier(points) in &line {
            assert!(points.iter().all(|p| (p[0] - p[1]).abs() < 1e-15));
        }
        let square = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]];
        let ring = through(&square, [None; 2], true);
        assert_eq!(ring.len(), 4);
        // by symmetry the slope at (1, 0) is along y: the second control point is at x = 1
        for (Bezier(points), at) in ring.iter().zip(square) {
            assert!((points[0][0] - at[0]).abs() < 1e-15 && (points[0][1] - at[1]).abs() < 1e-15);
        }
        assert!((ring[0].0[1][0] - 1.0).abs() < 1e-8 && (ring[0].0[2][1] - 1.0).abs() < 1e-8);
    }
}
