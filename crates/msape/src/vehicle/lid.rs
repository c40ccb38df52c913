//! The lid over the payload, and the edge of the annulus around it.
//!
//! ```text
//! r_a = √(R_L² − (x_a − x_L)²) + width
//! ```
//!
//! with R_L the lid's radius about x_L, x_a its foot and r_a the outer edge of the annulus, m.
//!
//! # Valid
//! A foot within the radius of its center.
//!
//! # References
//! - \[samareh-2014\] section 3.1.2.

use crate::vehicle::segment::{Point, half_chord_m};
use numerics::scalar::Single;

/// A lid: a spherical cap on the plane of the annulus.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lid<S = f64> {
    /// Axial position of its center, m.
    pub center_x_m: S,
    /// Outer radius, m.
    pub radius_m: S,
    /// Axial position of its foot, m.
    pub foot_x_m: S,
}

impl<S: Single> Lid<S> {
    /// Outer edge of the annulus around the lid.
    pub fn edge(&self, annulus_width_m: f64) -> Point<S> {
        let height = self.foot_x_m - self.center_x_m;
        Point {
            x_m: self.foot_x_m,
            r_m: half_chord_m(self.radius_m, height) + annulus_width_m,
        }
    }
}
