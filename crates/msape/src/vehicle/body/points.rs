//! An outline from rows of points, with arcs where a row has a bulge.
//!
//! ```text
//! bulge = tan(sweep / 4)      R = L (1 + b²) / (4 |b|)      distance of the center from the chord = L (1 − b²) / (4 b)
//! ```
//!
//! with L the chord to the next point in m, R the radius in m, the sweep in rad, positive from the x axis towards the r axis; a bulge of
//! zero is a straight line, one of −1 a half-circle outwards. This is the convention of polylines in DXF files.
//!
//! # Valid
//! Finite bulges.
//!
//! # References
//! - \[autodesk-dxf\] group code 42 of LWPOLYLINE.

use crate::vehicle::body::RigidBody;
use crate::vehicle::body::check::{MOST_FAULTS, OutlineFault, faults};
use crate::vehicle::profile::Profile;
use crate::vehicle::segment::{Point, Segment};
use numerics::math::{atan, atan2, hypot};

/// Bulges below this are straight: a sagitta of less than a billionth of the chord.
const STRAIGHT: f64 = 2e-9;

/// The piece from `start` to `end` with a bulge.
pub fn bulged(start: Point, end: Point, bulge: f64) -> Segment {
    let (dx, dr) = (end.x_m - start.x_m, end.r_m - start.r_m);
    let length = hypot(dx, dr);
    if bulge.abs() < STRAIGHT || length == 0.0 {
        return Segment::Line { start, end };
    }
    let off = (1.0 - bulge * bulge) / (4.0 * bulge);
    let center = Point {
        x_m: 0.5 * (start.x_m + end.x_m) - off * dr,
        r_m: 0.5 * (start.r_m + end.r_m) + off * dx,
    };
    Segment::Arc {
        start,
        end,
        center,
        radius_m: length * (1.0 + bulge * bulge) / (4.0 * bulge.abs()),
        start_angle_rad: atan2(start.r_m - center.r_m, start.x_m - center.x_m),
        sweep_rad: 4.0 * atan(bulge),
    }
}

/// The chain through rows of x, r and, where there is a third number, the bulge to the next point.
pub fn chain(rows: &[Vec<f64>]) -> Profile {
    let point = |row: &[f64]| Point {
        x_m: row.first().copied().unwrap_or(0.0),
        r_m: row.get(1).copied().unwrap_or(0.0),
    };
    let segments = rows
        .iter()
        .zip(rows.iter().skip(1))
        .map(|(row, next)| bulged(point(row), point(next), row.get(2).copied().unwrap_or(0.0)))
        .collect();
    Profile { segments }
}

/// The rows of a chain: the inverse of [`chain`].
pub fn rows(open: &Profile) -> Vec<Vec<f64>> {
    let mut rows: Vec<Vec<f64>> = open
        .segments
        .iter()
        .map(|segment| {
            let start = segment.start();
            let bulge = match *segment {
                Segment::Line { .. } => 0.0,
                Segment::Arc { sweep_rad, .. } => numerics::math::tan(sweep_rad / 4.0),
            };
            vec![start.x_m, start.r_m, bulge]
        })
        .collect();
    rows.extend(open.end().map(|end| vec![end.x_m, end.r_m, 0.0]));
    rows
}

/// A body from rows of points, or all faults of these.
pub fn from_rows(name: &str, rows: &[Vec<f64>]) -> Result<RigidBody, Vec<OutlineFault>> {
    let mut list: Vec<OutlineFault> = Vec::new();
    let curved = rows.iter().any(|row| row.get(2).is_some_and(|b| *b != 0.0));
    if rows.len() < 3 - usize::from(curved) {
        let points = rows.len();
        list.push(OutlineFault::TooFewPoints { points });
    }
    for (i, row) in rows.iter().enumerate() {
        if let Some(&value) = row.iter().find(|value| !value.is_finite()) {
            let point = i + 1;
            list.push(OutlineFault::NotFinite { point, value });
        }
    }
    list.truncate(MOST_FAULTS);
    if !list.is_empty() {
        return Err(list);
    }
    let mut open = chain(rows);
    list = faults(&open);
    if !list.is_empty() {
        return Err(list);
    }
    let mut notes = Vec::new();
    if let (Some(start), Some(end)) = (open.start(), open.end())
        && start.x_m > end.x_m
    {
        open = open.reversed();
        notes
            .push("The points run from aft to nose; the nose is the end with the lesser x.".into());
    }
    on_axis(&mut open);
    Ok(RigidBody::from_outline(name, open, notes))
}

/// Both ends, which are within rounding of the axis, put on it.
fn on_axis(open: &mut Profile) {
    if let Some(Segment::Line { start, .. } | Segment::Arc { start, .. }) =
        open.segments.first_mut()
    {
        start.r_m = 0.0;
    }
    if let Some(Segment::Line { end, .. } | Segment::Arc { end, .. }) = open.segments.last_mut() {
        end.r_m = 0.0;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use numerics::math::PI;

    #[test]
    fn a_bulge_of_minus_one_is_a_half_circle_outwards() {
        // a sphere of radius 1: from (0, 0) over (1, 1) to (2, 0), clockwise
        let one = from_rows("ball", &[vec![0.0, 0.0, -1.0], vec![2.0, 0.0, 0.0]]).unwrap();
        assert!((one.outline.solid().volume_m3 - 4.0 * PI / 3.0).abs() < 1e-14);
        let quarter = -numerics::math::tan(PI / 8.0);
        let rows = [
            vec![0.0, 0.0, quarter],
            vec![1.0, 1.0, quarter],
            vec![2.0, 0.0, 0.0],
        ];
        let body = from_rows("ball", &rows).unwrap();
        assert!((body.outline.solid().volume_m3 - 4.0 * PI / 3.0).abs() < 1e-14);
        assert!((body.diameter_m - 2.0).abs() < 1e-15);
        assert!((body.nose_radius_m.unwrap() - 1.0).abs() < 1e-15);
        assert!((body.length_m() - 2.0).abs() < 1e-15);
    }

    #[test]
    fn rows_of_an_outline_give_the_outline_again() {
        let shape = crate::vehicle::body::Shape {
            diameter_m: 1.0,
            nose_radius_m: 0.3,
            shoulder_radius_m: 0.05,
            cone_half_angle_rad: Some(1.0),
            aft: crate::vehicle::body::shape::Aft::Mmeev,
        };
        let open = shape.outline();
        let body = from_rows("again", &rows(&open)).unwrap();
        let (was, is) = (open.closed().solid(), body.outline.solid());
        assert!((was.volume_m3 / is.volume_m3 - 1.0).abs() < 1e-14);
        assert!((body.cone_half_angle_rad.unwrap() - 1.0).abs() < 1e-12);
        assert!((body.nose_radius_m.unwrap() / 0.3 - 1.0).abs() < 1e-12);
        assert!(body.virtual_apex_x_m.unwrap().abs() < 1e-12);
    }

    #[test]
    fn points_from_aft_to_nose_are_turned_round() {
        let body = from_rows("cone", &[vec![1.0, 0.0], vec![1.0, 1.0], vec![0.0, 0.0]]).unwrap();
        assert_eq!(body.nose_tip_x_m(), 0.0);
        assert_eq!(body.notes.len(), 1);
        assert!((body.cone_half_angle_rad.unwrap() - PI / 4.0).abs() < 1e-15);
    }

    #[test]
    fn a_nose_of_points_has_a_radius() {
        // on a circle of 0.5 about (0.5, 0)
        let mut rows: Vec<Vec<f64>> = (0..6)
            .map(|i| {
                let (s, c) = numerics::math::sin_cos(0.1 * f64::from(i));
                vec![0.5 - 0.5 * c, 0.5 * s]
            })
            .collect();
        rows.push(vec![1.0, 0.9]);
        rows.push(vec![1.0, 0.0]);
        let body = from_rows("blunt", &rows).unwrap();
        assert!((body.nose_radius_m.unwrap() - 0.5).abs() < 1e-12);
    }
}
