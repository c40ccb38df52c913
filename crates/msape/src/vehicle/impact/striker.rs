//! A vehicle at impact on the ground.
//!
//! ```text
//! Dₙ = 2 Rₙ
//! ```
//!
//! with Dₙ the nose diameter of equation 1 and Rₙ the nose radius in m.
//!
//! # Valid
//! Nose first, along the axis.
//!
//! # References
//! - \[samareh-2014\] section 3.1.5.

use crate::vehicle::forebody::Forebody;
use crate::vehicle::impact::footprint::Footprint;
use numerics::scalar::Single;

/// A vehicle at impact on the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Striker<S = f64> {
    /// Mass, kg.
    pub mass_kg: S,
    /// Speed, m/s.
    pub speed_m_s: S,
    /// Twice the nose radius, m.
    pub nose_diameter_m: S,
    /// Cross-sections of the forebody.
    pub footprint: Footprint<S>,
}

impl<S: Single> Striker<S> {
    /// A vehicle with this forebody.
    pub fn new(forebody: &Forebody<S>, mass_kg: S, speed_m_s: S) -> Striker<S> {
        Striker {
            mass_kg,
            speed_m_s,
            nose_diameter_m: forebody.nose_radius_m * 2.0,
            footprint: Footprint::new(forebody),
        }
    }
}
