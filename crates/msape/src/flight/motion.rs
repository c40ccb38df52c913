//! What the integrator, the search for peaks and the time history ask of a motion, whatever its degrees of freedom.
//!
//! ```text
//! y = (r, v, Q, …)
//! ```
//!
//! with r, v position (m) and velocity (m/s) in planet-fixed axes and Q the heat loads (J/m²): the state of a point mass
//! stands first in the state of every motion.
//!
//! # Valid
//! Motions of one body.
//!
//! # References
//! - Own convention.

use super::equations::{Equations, STATES};
use super::freedom::Freedom;
use super::integration::point_tolerance;
use super::lift::Lift;
use super::sample::{EARTH_G_M_S2, Loads};
use crate::aero::{Drag, DragTable};
use numerics::ode::Tolerance;

/// A motion with a state of `N` numbers, the first [`STATES`] of which are those of a point mass.
pub trait Motion<'a, const N: usize>: Copy {
    /// The part that does not depend on attitude.
    fn point(&self) -> &Equations<'a>;

    /// The same, to be changed.
    fn point_mut(&mut self) -> &mut Equations<'a>;

    /// Error allowed in a step.
    fn tolerance(&self) -> Tolerance<N>;

    /// The derivative of the state at a time, s.
    fn derivative(&self, t: f64, y: &[f64; N]) -> [f64; N];

    /// What changes fast, at a time, s.
    fn loads(&self, t: f64, y: &[f64; N]) -> Loads;

    /// Coefficient of the force against the velocity relative to the air.
    fn drag_coefficient(&self, t: f64, y: &[f64; N]) -> f64;

    /// Axial force or drag against Mach number, whose rows are kinks.
    #[inline]
    fn drag_table(&self) -> Option<&'a DragTable> {
        match &self.point().body.drag {
            Drag::Constant(_) => None,
            Drag::Table(table) => Some(table),
        }
    }

    /// Attitude and rates, where the motion has them.
    fn attitude(&self, y: &[f64; N]) -> Option<AttitudeSample>;

    /// The same motion in another piece of the atmosphere.
    #[inline]
    fn in_layer(mut self, layer: usize) -> Self {
        self.point_mut().layer = layer;
        self
    }
}

/// Attitude at one instant, as a time history shows it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AttitudeSample {
    /// Angle between the axis of the body and its velocity relative to the air, rad.
    pub total_alpha_rad: f64,
    /// Yaw, pitch and roll against local north, east and down, rad.
    pub yaw_pitch_roll_rad: [f64; 3],
    /// Inertial rates about the axes of the body, rad/s.
    pub rates_rad_s: [f64; 3],
}

/// The part of a state that a point mass has.
#[inline]
pub fn head<const N: usize>(y: &[f64; N]) -> [f64; STATES] {
    core::array::from_fn(|i| y[i])
}

/// A point mass, with lift where its body has some.
#[derive(Clone, Copy)]
pub struct PointMass<'a> {
    /// Its equations.
    pub point: Equations<'a>,
}

impl PointMass<'_> {
    #[inline]
    fn lift(&self) -> Option<&Lift> {
        match &self.point.body.freedom {
            Freedom::Lifting(lift) => Some(lift),
            Freedom::Ballistic | Freedom::Rigid(_) => None,
        }
    }
}

impl<'a> Motion<'a, STATES> for PointMass<'a> {
    #[inline]
    fn point(&self) -> &Equations<'a> {
        &self.point
    }

    #[inline]
    fn point_mut(&mut self) -> &mut Equations<'a> {
        &mut self.point
    }

    fn tolerance(&self) -> Tolerance<STATES> {
        point_tolerance(self.point.mission.solver.tolerance)
    }

    #[inline]
    fn derivative(&self, t: f64, y: &[f64; STATES]) -> [f64; STATES] {
        match self.lift() {
            None => self.point.derivative(y),
            Some(lift) => {
                let around = self.point.surroundings(y);
                let force = lift.force_over_mass_m_s2(&self.point, &around, t);
                self.point.moved_by(y, &around, force)
            }
        }
    }

    #[inline]
    fn loads(&self, t: f64, y: &[f64; STATES]) -> Loads {
        let around = self.point.surroundings(y);
        let deceleration_m_s2 = match self.lift() {
            None => self.point.drag_rate(&around) * around.air_speed_m_s,
            Some(lift) => {
                let [x, y, z] = lift.force_over_mass_m_s2(&self.point, &around, t);
                (x * x + y * y + z * z).sqrt()
            }
        };
        Loads {
            deceleration_earth_g: deceleration_m_s2 / EARTH_G_M_S2,
            dynamic_pressure_pa: 0.5
                * around.density_kg_m3
                * around.air_speed_m_s
                * around.air_speed_m_s,
            heat_flux: self.point.heat_flux(&around),
        }
    }

    #[inline]
    fn drag_coefficient(&self, _t: f64, y: &[f64; STATES]) -> f64 {
        let around = self.point.surroundings(y);
        match self.lift() {
            None => around.drag_coefficient,
            Some(lift) => lift.coefficients(&self.point, &around).drag,
        }
    }

    #[inline]
    fn attitude(&self, _y: &[f64; STATES]) -> Option<AttitudeSample> {
        None
    }
}
