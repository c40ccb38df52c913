//! The first natural frequency of each harmonic.
//!
//! ```text
//! K a = ω² M a        f = ω / 2π
//! ```
//!
//! with ω in rad/s, f in Hz.
//!
//! # Valid
//! Small vibrations; supports that leave no rigid motion in the harmonic; no torsion in the harmonic 0.
//!
//! # References
//! - \[bathe-1996\] chapter 10.

use super::model::{Freedoms, Model};
use numerics::linear::lanczos::{Options, lowest_eigenvalue};
use numerics::linear::skyline::Factor;
use numerics::math::PI;
use serde::{Deserialize, Serialize};

/// A natural frequency.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Frequency {
    /// Number of waves round the axis.
    pub harmonic: u32,
    /// Frequency, Hz.
    pub frequency_hz: f64,
}

/// The lowest frequency of the harmonic of `freedoms`, for a factored stiffness.
pub fn first_frequency(
    model: &Model,
    freedoms: &Freedoms,
    stiffness: &Factor,
) -> Option<Frequency> {
    let value = lowest_eigenvalue(stiffness, &model.mass(freedoms), Options::default())?;
    Some(Frequency {
        harmonic: freedoms.harmonic,
        frequency_hz: value.sqrt() / (2.0 * PI),
    })
}
