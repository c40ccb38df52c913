//! Faults that keep an open chain of lines and arcs from being the outline of a body of revolution, with their places.
//!
//! ```text
//! r = 0 at both ends, r > 0 between them; no two segments share a point but neighbors their joint; V > 0
//! ```
//!
//! with r the distance from the axis in m and V the volume in m³, zero being a billionth of the outline's size.
//!
//! # Valid
//! Any chain of finite numbers; segments are compared where their boxes overlap.
//!
//! # References
//! - Own convention.

use crate::units::told;
use crate::vehicle::body::pairs::{MOST_PAIRS, near_pairs};
use crate::vehicle::crossing::{distance_m, meetings};
use crate::vehicle::profile::Profile;
use crate::vehicle::segment::{Point, Segment};
use std::fmt;
use thiserror::Error;

/// Ends closer than this part of the outline's size are the same point.
pub const TOLERANCE: f64 = 1e-9;
/// Faults are listed up to this number, assumed.
pub const MOST_FAULTS: usize = 100;

/// A point in a message.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct At(pub Point);

impl fmt::Display for At {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // to a micrometer, without the zeros at the end
        let short = |value: f64| told((value * 1e6).round() / 1e6 + 0.0);
        write!(
            f,
            "x = {} m, r = {} m",
            short(self.0.x_m),
            short(self.0.r_m)
        )
    }
}

/// A fault of an outline. Points and segments are counted from 1; segment 3 runs from point 3 to point 4.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum OutlineFault {
    /// Fewer than three points.
    #[error("got {points} points, must be at least 3: nose, side and aft end")]
    TooFewPoints {
        /// Points given.
        points: usize,
    },
    /// A coordinate, or bulge, that is not finite.
    #[error("point {point}: got {value}, must be a finite number")]
    NotFinite {
        /// Number of the point.
        point: usize,
        /// The number.
        value: f64,
    },
    /// An outline that does not begin or end on the axis.
    #[error("point {point} ({at}) must be on the axis, r = 0: the outline {which} there")]
    OffAxis {
        /// First or last point.
        point: usize,
        /// Place.
        at: At,
        /// Begins or ends.
        which: &'static str,
    },
    /// A point on the wrong side of the axis.
    #[error("point {point} ({at}) is on the other side of the axis: r must not be negative")]
    BelowAxis {
        /// Number of the point.
        point: usize,
        /// Place.
        at: At,
    },
    /// A point between the ends that lies on the axis.
    #[error("point {point} ({at}) touches the axis between the ends of the outline")]
    TouchesAxis {
        /// Number of the point.
        point: usize,
        /// Place.
        at: At,
    },
    /// An arc that dips below the axis between its ends.
    #[error("segment {segment}, an arc, crosses the axis: it reaches r = {lowest_m:.6} m")]
    ArcCrossesAxis {
        /// Number of the segment.
        segment: usize,
        /// Lowest r of the arc, m.
        lowest_m: f64,
    },
    /// Two points that are the same.
    #[error("points {point} and {} are the same ({at}): a segment has no length", point + 1)]
    NoLength {
        /// The first of the two.
        point: usize,
        /// Place.
        at: At,
    },
    /// Two segments that cross or touch.
    #[error("segment {one} crosses segment {other} at {at}")]
    Crossing {
        /// Number of one segment.
        one: usize,
        /// Number of the other segment.
        other: usize,
        /// Place.
        at: At,
    },
    /// A segment that runs back over the one before it.
    #[error("segment {segment} folds back onto segment {} at {at}", segment - 1)]
    FoldsBack {
        /// Number of the segment.
        segment: usize,
        /// Place.
        at: At,
    },
    /// More pairs of segments near each other than are examined.
    #[error("more than {MOST_PAIRS} pairs of segments come near each other; give fewer points")]
    Tangled,
    /// The outline encloses nothing.
    #[error("the outline encloses no volume")]
    NoVolume,
}

/// All faults of an open outline, up to [`MOST_FAULTS`].
pub fn faults(open: &Profile) -> Vec<OutlineFault> {
    let segments = &open.segments;
    let (Some(start), Some(end)) = (open.start(), open.end()) else {
        return vec![OutlineFault::TooFewPoints { points: 0 }];
    };
    let size = segments
        .iter()
        .map(|segment| segment.bounds_m())
        .fold(0.0, |size: f64, [left, right, low, high]| {
            size.max(right - left).max(high).max(-low)
        });
    let near = TOLERANCE * size;
    let mut list = Vec::new();
    for (point, at, which) in [(1, start, "begins"), (segments.len() + 1, end, "ends")] {
        if at.r_m.abs() > near {
            let at = At(at);
            list.push(OutlineFault::OffAxis { point, at, which });
        }
    }
    for (i, segment) in segments.iter().enumerate() {
        let (a, b) = (segment.start(), segment.end());
        if distance_m(a, b) <= near {
            let at = At(a);
            list.push(OutlineFault::NoLength { point: i + 1, at });
            continue;
        }
        let inner = i + 1 < segments.len();
        if inner && b.r_m < -near {
            let (point, at) = (i + 2, At(b));
            list.push(OutlineFault::BelowAxis { point, at });
        } else if inner && b.r_m <= near {
            let (point, at) = (i + 2, At(b));
            list.push(OutlineFault::TouchesAxis { point, at });
        }
        let lowest_m = segment.bounds_m()[2];
        if lowest_m < a.r_m.min(b.r_m) - near && lowest_m < -near {
            let segment = i + 1;
            list.push(OutlineFault::ArcCrossesAxis { segment, lowest_m });
        }
    }
    list.truncate(MOST_FAULTS);
    crossings(segments, near, &mut list);
    if list.is_empty() {
        let volume = open.clone().closed().solid().volume_m3;
        if volume <= TOLERANCE * size * size * size {
            list.push(OutlineFault::NoVolume);
        }
    }
    list
}

/// A segment that has a length: its place among those, its number.
type Numbered<'a> = (usize, usize, &'a Segment);

/// Crossings of any two segments.
fn crossings(segments: &[Segment], near: f64, list: &mut Vec<OutlineFault>) {
    let numbered: Vec<Numbered> = segments
        .iter()
        .enumerate()
        .filter(|(_, segment)| distance_m(segment.start(), segment.end()) > near)
        .enumerate()
        .map(|(place, (i, segment))| (place, i + 1, segment))
        .collect();
    let boxes: Vec<[f64; 4]> = numbered.iter().map(|(.., s)| s.bounds_m()).collect();
    let mut found: Vec<(usize, usize, OutlineFault)> = Vec::new();
    let room = MOST_FAULTS.saturating_sub(list.len());
    let whole = near_pairs(&boxes, near, |i, j| {
        if let (Some(first), Some(second)) = (numbered.get(i), numbered.get(j))
            && let Some(fault) = crossing(first, second, near)
        {
            found.push((first.1, second.1, fault));
        }
        found.len() < room
    });
    found.sort_unstable_by_key(|(i, j, _)| (*i, *j));
    list.extend(found.into_iter().map(|(_, _, fault)| fault));
    if !whole {
        list.push(OutlineFault::Tangled);
    }
}

fn crossing(first: &Numbered, second: &Numbered, near: f64) -> Option<OutlineFault> {
    let ((p, one, a), (q, other, b)) = (*first, *second);
    let joint = (q == p + 1).then(|| a.end());
    let mut points = meetings(a, b, near);
    // neighbors share their joint
    let loose = 1e3 * near;
    points.retain(|p| joint.is_none_or(|joint| distance_m(*p, joint) > loose));
    let at = At(*points.first()?);
    let folds = joint.is_some()
        && match (a, b) {
            (Segment::Line { start, end }, Segment::Line { end: next, .. }) => {
                let (dx, dr) = (end.x_m - start.x_m, end.r_m - start.r_m);
                dx * (next.x_m - end.x_m) + dr * (next.r_m - end.r_m) < 0.0
            }
            _ => false,
        };
    Some(match folds {
        true => OutlineFault::FoldsBack { segment: other, at },
        false => OutlineFault::Crossing { one, other, at },
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vehicle::body::points::chain;

    fn said(rows: &[[f64; 2]]) -> Vec<String> {
        let rows: Vec<Vec<f64>> = rows.iter().map(|row| row.to_vec()).collect();
        let profile = chain(&rows);
        faults(&profile).iter().map(ToString::to_string).collect()
    }

    #[test]
    fn a_cone_is_an_outline() {
        assert!(said(&[[0.0, 0.0], [1.0, 1.0], [1.0, 0.0]]).is_empty());
    }

    #[test]
    fn a_bow_tie_says_where_it_crosses() {
        let bow = [[0.0, 0.0], [2.0, 2.0], [2.0, 1.0], [0.5, 3.0], [3.0, 0.0]];
        assert_eq!(
            said(&bow),
            [
                "segment 1 crosses segment 3 at x = 1.571429 m, r = 1.571429 m",
                "segment 1 crosses segment 4 at x = 1.636364 m, r = 1.636364 m",
                "segment 2 crosses segment 4 at x = 2 m, r = 1.2 m"
            ]
        );
    }

    #[test]
    fn what_leaves_the_half_plane_says_how_far() {
        assert_eq!(
            said(&[[0.0, 0.1], [1.0, 1.0], [1.5, -0.25], [2.0, 0.5], [3.0, 0.0]])[..2],
            [
                "point 1 (x = 0 m, r = 0.1 m) must be on the axis, r = 0: the outline begins there",
                "point 3 (x = 1.5 m, r = -0.25 m) is on the other side of the axis: r must not be negative"
            ]
        );
        let touches = said(&[[0.0, 0.0], [1.0, 1.0], [2.0, 0.0], [3.0, 1.0], [4.0, 0.0]]);
        assert!(touches[0].starts_with("point 3 (x = 2 m, r = 0 m) touches the axis"));
    }

    #[test]
    fn doubled_and_folded_points_are_named() {
        assert_eq!(
            said(&[[0.0, 0.0], [1.0, 1.0], [1.0, 1.0], [2.0, 0.0]]),
            ["points 2 and 3 are the same (x = 1 m, r = 1 m): a segment has no length"]
        );
        let folded = said(&[[0.0, 0.0], [0.0, 2.0], [0.0, 1.0], [2.0, 0.0]]);
        assert!(
            folded[0].starts_with("segment 2 folds back onto segment 1"),
            "{folded:?}"
        );
    }

    #[test]
    fn nothing_and_a_line_on_the_axis_are_no_bodies() {
        assert_eq!(faults(&Profile::default()).len(), 1);
        let flat = said(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]]);
        assert!(!flat.is_empty());
    }
}
