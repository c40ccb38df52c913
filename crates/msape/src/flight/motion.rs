//! Interface of a motion to the integrator, the search for peaks and the time history, for any number of degrees of
//! freedom.
//!
//! ```text
//! y = (r, v, Q, …)
//! ```
//!
//! with r, v position (m) and velocity (m/s) in planet-fixed axes and Q the heat loads (J/m²): the state of a point mass
//! is the first part of the state of every motion.
//!
//! # Valid
//! Motions of one body.
//!
//! # References
//! - Own convention.

use super::equations::{Equations, STATES, Surroundings};
use super::freedom::Freedom;
use super::integration::point_tolerance;
use super::lift::{Lift, Source};
use super::phase::Stage;
use super::reach::Arguments;
use super::sample::Loads;
use super::within::Within;
use crate::aero::{Drag, DragTable};
use numerics::ode::Tolerance;
use numerics::scalar::{Scalar, Single};

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

    /// Mutable access to the part that does not depend on attitude.
    fn point_mut(&mut self) -> &mut Equations<'a, S>;

    /// Error allowed in a step.
    fn tolerance(&self) -> Tolerance<N>;

    /// The derivative of the state at a time, s, and in its surroundings.
    fn derivative_in(&self, t: S, y: &[S; N], around: &Surroundings<S>) -> [S; N];

    /// Loads at a time, s, in known surroundings.
    fn loads_in(&self, t: S, y: &[S; N], around: &Surroundings<S>) -> Loads<S>;

    /// Coefficient of the force against the velocity relative to the air.
    fn drag_coefficient(&self, t: S, y: &[S; N]) -> S;

    /// Surroundings of the body.
    #[inline]
    fn around(&self, y: &[S; N]) -> Surroundings<S> {
        self.point().surroundings(&head(y))
    }

    /// The derivative of the state at a time, s.
    #[inline]
    fn derivative(&self, t: S, y: &[S; N]) -> [S; N] {
        self.derivative_in(t, y, &self.around(y))
    }

    /// Loads at a time, s.
    #[inline]
    fn loads(&self, t: S, y: &[S; N]) -> Loads<S> {
        self.loads_in(t, y, &self.around(y))
    }

    /// Axial force or drag against Mach number, whose rows are kinks.
    #[inline]
    fn drag_table(&self) -> Option<&'a DragTable> {
        match &self.point().body.drag {
            Drag::Constant(_) => None,
            Drag::Table(table) => Some(table),
        }
    }

    /// Whether the drag table is used by the line that holds, so that the line changes only at the end of a step.
    #[inline]
    fn holds_drag(&self) -> bool {
        true
    }

    /// Arguments of table look-ups at a time, s; NaN where the motion has none.
    fn arguments(&self, t: S, y: &[S; N]) -> Arguments<S>;

    /// Attitude and rates, where the motion has them.
    fn attitude(&self, y: &[S; N]) -> Option<AttitudeSample>;

    /// This motion, given before any phase, in a stage of a flight.
    #[inline]
    fn in_stage(self, stage: &Stage<S>) -> Self {
        let mut motion = self.within(&stage.within);
        let mission = motion.point().mission;
        for phase in mission.phases.iter().take(stage.phases) {
            motion
                .point_mut()
                .change(&phase.change, stage.canopy_since_s);
        }
        motion
    }

    /// This motion with the rows that hold at a place.
    #[inline]
    fn within(mut self, within: &Within) -> Self {
        self.point_mut().hold(within);
        self
    }

    /// Position of a state among the rows of tables.
    fn place(&self, y: &[S; N]) -> Within
    where
        S: Single,
    {
        let altitude_m = (self.point().ellipsoid.local([y[0], y[1], y[2]]).altitude_m).value();
        let here = Within {
            altitude_m,
            ..Within::REST
        };
        let motion = self.within(&here);
        let point = motion.point();
        let around = point.surroundings(&head(y));
        let mach = around.air_speed_m_s / point.sound_m_s(around.altitude_m);
        Within {
            mach: mach.value(),
            speed_m_s: around.air_speed_m_s.value(),
            ..here
        }
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

/// Point mass, with lift where its body has some; or one per lane.
#[derive(Clone, Copy)]
pub struct PointMass<'a, S: Scalar = f64> {
    /// Equations of the point mass.
    pub point: Equations<'a, S>,
}

impl<S: Scalar> PointMass<'_, S> {
    /// Aerodynamic force over mass, parachute included, planet-fixed axes, m/s².
    #[inline]
    fn force_over_mass_m_s2(&self, t: S, around: &Surroundings<S>) -> [S; 3] {
        let u = around.air_velocity_m_s;
        let force = match self.lift() {
            None => {
                let rate = self.point.drag_rate(around);
                u.map(|u| -(rate * u))
            }
            Some(lift) => lift.force_over_mass_m_s2(&self.point, around, t),
        };
        if !self.point.is_phased() {
            return force;
        }
        let rate = self.point.canopy_rate(around, t);
        core::array::from_fn(|i| force[i] - rate * u[i])
    }

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
    fn derivative_in(&self, t: S, y: &[S; STATES], around: &Surroundings<S>) -> [S; STATES] {
        let force = self.force_over_mass_m_s2(t, around);
        self.point.moved_by(y, around, force)
    }

    #[inline]
    fn loads_in(&self, t: S, _y: &[S; STATES], around: &Surroundings<S>) -> Loads<S> {
        let deceleration_m_s2 = match self.lift() {
            None if !self.point.is_phased() => self.point.drag_rate(around) * around.air_speed_m_s,
            _ => {
                let [x, y, z] = self.force_over_mass_m_s2(t, around);
                (x * x + y * y + z * z).sqrt()
            }
        };
        Loads::new(&self.point, around, deceleration_m_s2)
    }

    #[inline]
    fn drag_coefficient(&self, _t: S, y: &[S; STATES]) -> S {
        let around = self.point.surroundings(y);
        match self.lift() {
            None => around.drag_coefficient,
            Some(lift) => lift.coefficients(&self.point, &around).drag,
        }
    }

    fn arguments(&self, t: S, y: &[S; STATES]) -> Arguments<S> {
        let around = self.point.surroundings(y);
        let none = S::constant(f64::NAN);
        let trim = self.lift().and_then(|lift| match &lift.source {
            Source::Trim(trim) => Some(trim),
            _ => None,
        });
        let [alpha_rad, knudsen] = match trim {
            None => [none; 2],
            Some(trim) => {
                let [mach, knudsen] = trim.mach_knudsen(&self.point, &around);
                [trim.coefficients(mach, knudsen)[2], knudsen]
            }
        };
        self.point.arguments(t, &around, alpha_rad, knudsen)
    }

    #[inline]
    fn attitude(&self, _y: &[S; STATES]) -> Option<AttitudeSample> {
        None
    }
}
