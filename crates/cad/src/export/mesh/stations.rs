//! Points along a segment, close enough to be joined by straight pieces, with the normals of the segment.

use msape::vehicle::segment::{Point, Segment};
use numerics::math::{PI, asin, hypot, sin_cos};

/// Fewest and most chords of a full circle.
const CHORDS: (f64, f64) = (12.0, 1440.0);

/// Point of a segment with its normal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Station {
    /// Position in the half-section.
    pub at: Point,
    /// Unit normal (x, r), to the left of the segment's direction.
    pub normal: (f64, f64),
}

/// Angle of a chord that is `error_m` away from a circle of radius `radius_m`, rad.
fn step_rad(radius_m: f64, error_m: f64) -> f64 {
    let share = (error_m / (2.0 * radius_m)).clamp(0.0, 1.0);
    4.0 * asin(share.sqrt())
}

/// Number of chords of an arc.
pub(super) fn chords(sweep_rad: f64, radius_m: f64, error_m: f64) -> usize {
    let (fewest, most) = CHORDS;
    let circle = (2.0 * PI / step_rad(radius_m, error_m)).clamp(fewest, most);
    // the small term keeps rounding from adding a chord
    ((circle * sweep_rad.abs() / (2.0 * PI) - 1e-9).ceil() as usize).max(1)
}

/// Stations of a segment: chords deviate by at most `chord_error_m`, straight pieces are at most `longest_piece_m`
/// long.
pub fn stations(segment: &Segment, chord_error_m: f64, longest_piece_m: f64) -> Vec<Station> {
    match *segment {
        Segment::Line { start, end } => {
            let (dx, dr) = (end.x_m - start.x_m, end.r_m - start.r_m);
            let length = hypot(dx, dr);
            let normal = (-dr / length, dx / length);
            let pieces = (length / longest_piece_m).ceil().clamp(1.0, 1000.0);
            ends_kept((start, end), pieces as usize, |k| {
                let t = k as f64 / pieces;
                let at = Point {
                    x_m: start.x_m + t * dx,
                    r_m: start.r_m + t * dr,
                };
                Station { at, normal }
            })
        }
        Segment::Arc {
            start,
            end,
            center,
            radius_m,
            start_angle_rad,
            sweep_rad,
        } => {
            let pieces = chords(sweep_rad, radius_m, chord_error_m);
            // the outside is on the left: away from the center where the arc runs from r towards x
            let side = if sweep_rad < 0.0 { 1.0 } else { -1.0 };
            ends_kept((start, end), pieces, |k| {
                let (s, c) = sin_cos(start_angle_rad + sweep_rad * k as f64 / pieces as f64);
                let at = Point {
                    x_m: center.x_m + radius_m * c,
                    r_m: center.r_m + radius_m * s,
                };
                Station {
                    at,
                    normal: (side * c, side * s),
                }
            })
        }
    }
}

/// Stations 0 to `pieces`, with the first and the last exactly at the ends.
fn ends_kept(
    (start, end): (Point, Point),
    pieces: usize,
    station: impl Fn(usize) -> Station,
) -> Vec<Station> {
    let kept = |k: usize| {
        let at = match k {
            0 => start,
            k if k == pieces => end,
            k => station(k).at,
        };
        Station { at, ..station(k) }
    };
    (0..=pieces).map(kept).collect()
}
