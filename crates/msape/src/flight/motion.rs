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

use super::equations::{Equations, STATES, Surroundings};
use super::freedom::Freedom;
use super::integration::point_tolerance;
use super::lift::Lift;
use super::sample::Loads;
use crate::aero::{Drag, DragTable};
use crate::planet::atmosphere::Piece;
use numerics::ode::Tolerance;
use numerics::scalar::Scalar;

/// A motion with a state of `N` numbers, the first [`STATES`] of which are those of a point mass; of one body, or of one a
/// lane.
pub trait Motion<'a, const N: usize, S: Scalar = f64>: Copy {
    /// The motion of one lane.
    type Lane: Motion<'a, N, S::Lane, Lane = Self::Lane>;

    /// The motion of one lane in every lane.
    fn everywhere(of: &Self::Lane) -> Self;

    /// Replaces the motion of one lane.
    fn set_lane(&mut self, lane: usize, of: &Self::Lane);

    /// The part that does not depend on attitude.
    fn point(&self) -> &Equations<'a, S>;

    /// The same, to be changed.
    fn point_mut(&mut self) -> &mut Equations<'a, S>;

    /// Error allowed in a step.
    fn tolerance(&self) -> Tolerance<N>;

    /// The derivative of the state at a time, s.
    fn derivative(&self, t: S, y: &[S; N]) -> [S; N];

    /// What changes fast, at a time, s, and what surrounds the body there.
    fn loads_around(&self, t: S, y: &[S; N]) -> (Loads<S>, Surroundings<S>);

    /// Coefficient of the force against the velocity relative to the air.
    fn drag_coefficient(&self, t: S, y: &[S; N]) -> S;

    /// What changes fast, at a time, s.
    #[inline]
    fn loads(&self, t: S, y: &[S; N]) -> Loads<S> {
        self.loads_around(t, y).0
    }

    /// Axial force or drag against Mach number, whose rows are kinks.
    #[inline]
    fn drag_table(&self) -> Option<&'a DragTable> {
        match &self.point().body.drag {
            Drag::Constant(_) => None,
            Drag::Table(table) => Some(table),
        }
    }

    /// Attitude and rates, where the motion has them.
    fn attitude(&self, y: &[S; N]) -> Option<AttitudeSample>;

    /// The same motion in another piece of the atmosphere.
    #[inline]
    fn in_layer(mut self, layer: usize) -> Self {
        let piece = self.point().mission.atmosphere.piece(layer);
        self.point_mut().piece = Piece::everywhere(&piece);
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
pub fn head<const N: usize, S: Scalar>(y: &[S; N]) -> [S; STATES] {
    core::array::from_fn(|i| y[i])
}

/// A point mass, with lift where its body has some; or one a lane.
#[derive(Clone, Copy)]
pub struct PointMass<'a, S: Scalar = f64> {
    /// Its equations.
    pub point: Equations<'a, S>,
}

impl<S: Scalar> PointMass<'_, S> {
    #[inline]
    fn lift(&self) -> Option<&Lift> {
        match &self.point.body.freedom {
            Freedom::Lifting(lift) => Some(lift),
            Freedom::Ballistic | Freedom::Rigid(_) => None,
        }
    }
}

impl<'a, S: Scalar> Motion<'a, STATES, S> for PointMass<'a, S> {
    type Lane = PointMass<'a, S::Lane>;

    fn everywhere(of: &Self::Lane) -> Self {
        Self {
            point: Equations::everywhere(&of.point),
        }
    }

    fn set_lane(&mut self, lane: usize, of: &Self::Lane) {
        self.point.set_lane(lane, &of.point);
    }

    #[inline]
    fn point(&self) -> &Equations<'a, S> {
        &self.point
    }

    #[inline]
    fn point_mut(&mut self) -> &mut Equations<'a, S> {
        &mut self.point
    }

    fn tolerance(&self) -> Tolerance<STATES> {
        point_tolerance(self.point.mission.solver.tolerance)
    }

    #[inline]
    fn derivative(&self, t: S, y: &[S; STATES]) -> [S; STATES] {
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
    fn loads_around(&self, t: S, y: &[S; STATES]) -> (Loads<S>, Surroundings<S>) {
        let around = self.point.surroundings(y);
        let deceleration_m_s2 = match self.lift() {
            None => self.point.drag_rate(&around) * around.air_speed_m_s,
            Some(lift) => {
                let [x, y, z] = lift.force_over_mass_m_s2(&self.point, &around, t);
                (x * x + y * y + z * z).sqrt()
            }
        };
        let loads = Loads::new(&self.point, &around, deceleration_m_s2);
        (loads, around)
    }

    #[inline]
    fn drag_coefficient(&self, _t: S, y: &[S; STATES]) -> S {
        let around = self.point.surroundings(y);
        match self.lift() {
            None => around.drag_coefficient,
            Some(lift) => lift.coefficients(&self.point, &around).drag,
        }
    }

    #[inline]
    fn attitude(&self, _y: &[S; STATES]) -> Option<AttitudeSample> {
        None
    }
}
