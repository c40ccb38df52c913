//! Profiles as edges with normals, ready for revolution.

use cad::export::mesh::{Station, stations};
use msape::vehicle::profile::Profile;
use msape::vehicle::segment::{Point, Segment};

/// Largest distance of an edge from its arc, as a fraction of the radius: an edge of 0.2 rad.
const MOST_SAGITTA: f64 = 0.005;
/// Distance from the axis that counts as on it, m.
const ON_AXIS_M: f64 = 1e-9;

/// End of an edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corner {
    /// Position.
    pub at: Point,
    /// Axial component of the outward normal.
    pub normal_x: f64,
    /// Radial component of the outward normal.
    pub normal_r: f64,
    /// Painted value; negative if there is none.
    pub value: f32,
}

/// Part of a profile, short enough to be straight.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Edge {
    /// Start.
    pub start: Corner,
    /// End.
    pub end: Corner,
}

impl Edge {
    /// Whether it lies on the axis, where it gives no surface.
    pub fn is_on_axis(&self) -> bool {
        self.start.at.r_m.abs() < ON_AXIS_M && self.end.at.r_m.abs() < ON_AXIS_M
    }
}

/// Edges of a closed profile, oriented with the body on their left; `value` gives the painted value at a point.
pub fn edges(
    profile: &Profile,
    chord_error_m: f64,
    value: impl Fn(&Segment, Point) -> f32,
) -> Vec<Edge> {
    // the body is on the left where the enclosed area, ∮ −r dx, is positive
    let is_left = profile
        .segments
        .iter()
        .map(|segment| segment.integrals().r_dx)
        .sum::<f64>()
        < 0.0;
    let mut edges = Vec::new();
    let mut add = |original: &Segment, run: &Segment| {
        of_segment(run, chord_error_m, |at| value(original, at), &mut edges);
    };
    if is_left {
        profile.segments.iter().for_each(|s| add(s, s));
    } else {
        let backwards = profile.segments.iter().rev();
        backwards.for_each(|s| add(s, &s.reversed()));
    }
    edges
}

fn of_segment(
    segment: &Segment,
    chord_error_m: f64,
    value: impl Fn(Point) -> f32,
    edges: &mut Vec<Edge>,
) {
    let (start, end) = (segment.start(), segment.end());
    let length_m = (end.x_m - start.x_m).hypot(end.r_m - start.r_m);
    let (chord_error_m, longest_m) = match *segment {
        Segment::Line { .. } if length_m <= 0.0 => return,
        Segment::Line { .. } => {
            let pieces = pieces_of_line(&value, start, end);
            (chord_error_m, length_m / pieces as f64)
        }
        // colors change along an arc
        Segment::Arc { radius_m, .. } => {
            (chord_error_m.min(MOST_SAGITTA * radius_m), f64::INFINITY)
        }
    };
    // the body is on the left, so the outward normal is to the right
    let corner = |station: &Station| Corner {
        at: station.at,
        normal_x: -station.normal.0,
        normal_r: -station.normal.1,
        value: value(station.at),
    };
    let corners: Vec<Corner> = stations(segment, chord_error_m, longest_m)
        .iter()
        .map(corner)
        .collect();
    edges.extend(corners.windows(2).map(|pair| Edge {
        start: pair[0],
        end: pair[1],
    }));
}

/// Number of edges of a line: one, or more where the painted value changes along it.
fn pieces_of_line(value: &impl Fn(Point) -> f32, start: Point, end: Point) -> usize {
    if value(start) == value(end) { 1 } else { 24 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    fn ball() -> Profile {
        let half = Segment::arc(Point { x_m: 3.0, r_m: 0.0 }, 2.0, PI, -PI);
        Profile {
            segments: vec![half],
        }
        .closed()
    }

    #[test]
    fn normals_point_out_of_a_ball_whichever_way_it_is_run() {
        for profile in [ball(), ball().reversed()] {
            let edges = edges(&profile, 1e-3, |_, _| -1.0);
            for corner in edges.iter().flat_map(|edge| [edge.start, edge.end]) {
                let out = (corner.at.x_m - 3.0) * corner.normal_x + corner.at.r_m * corner.normal_r;
                let on_axis = corner.normal_r < 0.0 && corner.at.r_m == 0.0;
                assert!(on_axis || (out - 2.0).abs() < 1e-12, "{corner:?}");
            }
        }
    }

    #[test]
    fn edges_close_and_stay_within_the_chord_error() {
        let edges = edges(&ball(), 1e-3, |_, _| -1.0);
        for pair in edges.windows(2) {
            assert_eq!(pair[0].end.at, pair[1].start.at);
        }
        assert_eq!(edges[0].start.at, edges[edges.len() - 1].end.at);
        for edge in edges.iter().filter(|edge| !edge.is_on_axis()) {
            let middle_x = 0.5 * (edge.start.at.x_m + edge.end.at.x_m) - 3.0;
            let middle_r = 0.5 * (edge.start.at.r_m + edge.end.at.r_m);
            let error = 2.0 - middle_x.hypot(middle_r);
            assert!((0.0..=1.0001e-3).contains(&error), "{error}");
        }
        assert_eq!(edges.iter().filter(|edge| edge.is_on_axis()).count(), 1);
    }
}
