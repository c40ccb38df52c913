//! A vehicle as the ground meets it.
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

/// A vehicle that meets the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Striker {
    /// Mass, kg.
    pub mass_kg: f64,
    /// Speed, m/s.
    pub speed_m_s: f64,
    /// Twice the nose radius, m.
    pub nose_diameter_m: f64,
    /// Cross-sections of the forebody.
    pub footprint: Footprint,
}

impl Striker {
    /// A vehicle with this forebody.
    pub fn new(forebody: &Forebody, mass_kg: f64, speed_m_s: f64) -> Striker {
        Striker {
            mass_kg,
            speed_m_s,
            nose_diameter_m: 2.0 * forebody.nose_radius_m,
            footprint: Footprint::new(forebody),
        }
    }
}
