//! A rigid body: inertia, center of gravity, aerodynamics, attitude and rates at the start.

use super::aerodynamics::{Aerodynamics, Damping, Reference};
use super::inertia::Inertia;
use nalgebra::{UnitQuaternion, Vector3};

/// A rigid body.
#[derive(Clone, Debug, PartialEq)]
pub struct Rigid {
    /// Inertia about the center of gravity.
    pub inertia: Inertia,
    /// Center of gravity: x aft of the virtual apex, y to the right, z down, m.
    pub cg_m: [f64; 3],
    /// Lengths and area of the coefficients.
    pub reference: Reference,
    /// Force and moment.
    pub aerodynamics: Aerodynamics,
    /// Damping by constants.
    pub damping: Damping,
    /// Attitude at the start: from axes of the body to planet-fixed axes.
    pub attitude: UnitQuaternion<f64>,
    /// Inertial rates at the start, axes of the body, rad/s.
    pub rates_rad_s: Vector3<f64>,
}
