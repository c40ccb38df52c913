//! A place by which rows of tables are chosen.
//!
//! ```text
//! h, M, V
//! ```
//!
//! with h the geodetic altitude in m, M the Mach number and V the speed relative to the air in m/s.
//!
//! # Valid
//! Any place.
//!
//! # References
//! - Own convention.

/// A place within the rows that hold.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Within {
    /// Geodetic altitude, m.
    pub altitude_m: f64,
    /// Mach number.
    pub mach: f64,
    /// Speed relative to the air, m/s.
    pub speed_m_s: f64,
}

impl Within {
    /// A vehicle at rest on the ground.
    pub const REST: Within = Within {
        altitude_m: 0.0,
        mach: 0.0,
        speed_m_s: 0.0,
    };
}
