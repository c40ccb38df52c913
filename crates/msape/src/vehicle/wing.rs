//! Allowed places of the annulus around the lid, so that the wing between it and the shoulder is neither too steep nor too shallow.
//!
//! ```text
//! (x_a − x_s) cos φ + (r_s − r_a) sin φ − R_s ≥ 0      no steeper than φ, where the wing touches the shoulder further aft
//! (x_a − x_s)² + (r_s − r_a)² ≥ R_s²                   further aft than that: outside the shoulder's circle
//! R_s − (x_a − x_s) cos φ₀ − (r_s − r_a) sin φ₀ ≥ 0    no shallower than φ₀
//! ```
//!
//! with (x_a, r_a) the outer edge of the annulus and (x_s, r_s) the center of the shoulder arc in m, R_s its radius in m, φ and φ₀
//! the steepest and the least slope of the wing's aft side in rad.
//!
//! # Valid
//! 0 < φ₀ ≤ φ ≤ π/2.
//!
//! # References
//! - \[samareh-2014\] section 3.1.2.

use crate::vehicle::segment::{Point, half_chord_m};
use numerics::scalar::Single;

/// Least distance of the annulus from the shoulder's circle, so that the wing has a length, m.
const WING_LENGTH_M: f64 = 1e-6;

/// Allowed region of the outer edge of the annulus: inwards of the steepest wing and of the shoulder's circle, ahead of the
/// shallowest wing.
#[derive(Clone, Copy, Debug)]
pub struct Wing<S = f64> {
    /// Center of the shoulder arc.
    pub center: Point<S>,
    /// Radius of the shoulder arc, m.
    pub radius_m: S,
    /// Sine and cosine of the steepest slope.
    pub steepest: (S, S),
    /// Sine and cosine of the least slope.
    pub shallowest: (S, S),
}

impl<S: Single> Wing<S> {
    /// Distance of an edge behind the steepest wing, m.
    pub fn behind_steepest_m(&self, edge: Point<S>) -> S {
        let (s, c) = self.steepest;
        (edge.x_m - self.center.x_m) * c + (self.center.r_m - edge.r_m) * s - self.radius_m
    }

    /// Whether an edge is aft of the point where the steepest wing touches the shoulder: the shoulder limits it there.
    pub fn is_aft_of_steepest(&self, edge: Point<S>) -> bool {
        (self.radius_m * self.steepest.1).less(edge.x_m - self.center.x_m)
    }

    /// Distance of an edge ahead of the shallowest wing, inwards of where that touches the shoulder and inwards of the
    /// shoulder: the least of the three, m.
    pub fn room_m(&self, edge: Point<S>) -> S {
        let (s, c) = self.shallowest;
        let (behind, along) = (edge.x_m - self.center.x_m, self.center.r_m - edge.r_m);
        let ahead = self.radius_m - behind * c - along * s;
        let outside = if self.is_aft_of_steepest(edge) {
            along - self.circle_m(behind)
        } else {
            S::constant(f64::INFINITY)
        };
        ahead.min(along - self.radius_m * s).min(outside)
    }

    /// Half the width of the shoulder's circle at a distance behind its center, m; zero aft of it.
    fn circle_m(&self, behind_m: S) -> S {
        half_chord_m(self.radius_m, behind_m)
    }

    /// Largest distance from the axis of an edge at the axial position `x_m`: on the steepest wing, further aft on the
    /// shoulder's circle, at most where the shallowest wing touches it, m.
    pub fn widest_r_m(&self, x_m: S) -> S {
        let (behind, (s, c)) = (x_m - self.center.x_m, self.steepest);
        let inwards = if behind.value() <= (self.radius_m * c).value() {
            (self.radius_m - behind * c) / s
        } else {
            (self.circle_m(behind) + WING_LENGTH_M).max(self.radius_m * self.shallowest.0)
        };
        self.center.r_m - inwards
    }

    /// Distance of an edge inwards of the widest place, m.
    pub fn clearance_m(&self, edge: Point<S>) -> S {
        self.widest_r_m(edge.x_m) - edge.r_m
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use numerics::math::{PI, sin_cos};

    #[test]
    fn an_edge_has_room_between_30_and_5_deg_and_outside_the_shoulder() {
        let wing = Wing {
            center: Point { x_m: 1.0, r_m: 2.0 },
            radius_m: 0.5,
            steepest: sin_cos(PI / 6.0),
            shallowest: sin_cos(PI / 36.0),
        };
        let edge = |x_m, r_m| Point { x_m, r_m };
        // at the height of the center the steepest wing is 0.5 / sin 30° inwards of it
        assert!((wing.widest_r_m(1.0) - 1.0).abs() < 1e-15);
        assert!(wing.clearance_m(edge(1.0, 1.01)) < 0.0 && wing.clearance_m(edge(1.0, 0.99)) > 0.0);
        // 0.48 m aft of it the circle is √(0.5² − 0.48²) = 0.14 m inwards
        assert!((wing.widest_r_m(1.48) - 1.86).abs() < 2e-6);
        assert!(wing.room_m(edge(1.48, 1.87)) < 0.0 && wing.room_m(edge(1.48, 1.85)) > 0.0);
        // 1 m inwards the shallowest wing is at (0.5 − sin 5°) / cos 5° = 0.41442 m
        assert!(wing.room_m(edge(1.4145, 1.0)) < 0.0 && wing.room_m(edge(1.4143, 1.0)) > 0.0);
    }
}
