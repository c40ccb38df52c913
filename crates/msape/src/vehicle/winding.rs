//! Winding number of a closed curve of lines and arcs about a point.
//!
//! ```text
//! w = Σ ∠(start, p, end) / 2π  +  Σ sign(sweep) over arcs whose segment of the circle holds p
//! ```
//!
//! with ∠ the angle between −π and π under which the chord of a piece is seen from p.
//!
//! # Valid
//! Points off the curve; arcs of less than a full turn, and full circles.
//!
//! # References
//! - Elementary: between an arc and its chord lies a segment of the circle, whose boundary runs once round its inside.

use crate::vehicle::crossing::distance_m;
use crate::vehicle::profile::Profile;
use crate::vehicle::segment::{Point, Segment};
use numerics::math::{PI, atan2};

impl Profile {
    /// Winding number of the closed curve about a point: 0 outside, 1 or −1 inside of a curve that does not cross itself.
    pub fn winding_number(&self, point: Point) -> i32 {
        let (mut angle, mut turns) = (0.0, 0);
        for segment in &self.segments {
            let (a, b) = (segment.start(), segment.end());
            let (ax, ar) = (a.x_m - point.x_m, a.r_m - point.r_m);
            let (bx, br) = (b.x_m - point.x_m, b.r_m - point.r_m);
            angle += atan2(ax * br - ar * bx, ax * bx + ar * br);
            if let Segment::Arc {
                center,
                radius_m,
                sweep_rad,
                ..
            } = *segment
                && distance_m(center, point) < radius_m
            {
                // an arc that turns left bulges to the right of its chord
                let side =
                    (b.x_m - a.x_m) * (point.r_m - a.r_m) - (b.r_m - a.r_m) * (point.x_m - a.x_m);
                let full = sweep_rad.abs() >= 2.0 * PI * (1.0 - 1e-12);
                if full || side * sweep_rad < 0.0 {
                    turns += if sweep_rad > 0.0 { 1 } else { -1 };
                }
            }
        }
        turns + (angle / (2.0 * PI)).round() as i32
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn point(x_m: f64, r_m: f64) -> Point {
        Point { x_m, r_m }
    }

    #[test]
    fn half_a_ring_holds_what_is_between_its_arcs() {
        let center = point(0.0, 0.0);
        let ring = Profile {
            segments: vec![Segment::arc(center, 2.0, PI, -PI)],
        }
        .then(&Profile {
            segments: vec![Segment::arc(center, 1.0, 0.0, PI)],
        })
        .closed();
        for (p, want) in [
            (point(0.0, 1.5), -1),
            (point(1.5, 0.1), -1),
            (point(0.0, 0.5), 0),
            (point(0.0, 2.5), 0),
            (point(-1.9, 0.1), -1),
            (point(0.0, -1.5), 0),
        ] {
            assert_eq!(ring.winding_number(p), want, "{p:?}");
            assert_eq!(ring.reversed().winding_number(p), -want, "{p:?}");
        }
    }

    #[test]
    fn three_quarters_of_a_circle_and_a_full_one() {
        let pie = Profile {
            segments: vec![Segment::arc(point(0.0, 3.0), 1.0, 0.0, 1.5 * PI)],
        }
        .closed();
        assert_eq!(pie.winding_number(point(-0.5, 3.0)), 1);
        assert_eq!(pie.winding_number(point(0.1, 3.1)), 1);
        assert_eq!(pie.winding_number(point(0.6, 2.4)), 0);
        let circle = Profile {
            segments: vec![Segment::arc(point(0.0, 3.0), 1.0, 0.3, 2.0 * PI)],
        };
        assert_eq!(circle.winding_number(point(0.9, 3.0)), 1);
        assert_eq!(circle.winding_number(point(1.1, 3.0)), 0);
    }
}
