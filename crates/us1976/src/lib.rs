//! The U.S. Standard Atmosphere 1976 from its definition: closed forms to 86 km, integrated gases to 1000 km.
//!
//! ```text
//! to 86 km       ρ(z) of layers of linear temperature
//! 86–1000 km     ρ(z), M(z) of the integrated gases
//! ```
//!
//! A crate of its own, so that the build of the core can integrate the gases of the shipped definition once and the program
//! that solves cases need not.
//!
//! # References
//! - \[coesa-1976\].

pub mod definition;
pub mod heterosphere;
pub mod lower;
pub mod temperature;

#[cfg(test)]
mod sample;

/// A value and its slope.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Knot {
    /// Value in the unit of the curve.
    pub value: f64,
    /// Slope, that unit per m.
    pub slope_per_m: f64,
}
