//! Checks from step to step: tables of the case, drag, energy.
//!
//! ```text
//! E = v²/2 − μ/r − ω² (x² + y²)/2
//! ```
//!
//! with E in J/kg, v relative to the planet in m/s, μ in m³/s², ω in rad/s: air that rotates with the planet takes E
//! away and gives none.
//!
//! # Valid
//! Wind may add energy: the square of its speed.
//!
//! # References
//! - \[vinh-1980\] chapter 2 for the energy in rotating axes (Jacobi's integral).

use super::course::Course;
use crate::flight::motion::Motion;
use crate::flight::reach::{Argument, Axis, Push};
use crate::planet::Gravity;
use numerics::ode::Step;
use numerics::root;
use numerics::scalar::Single;

/// Number of parts of a step, at the ends of which the state is checked.
const PARTS: u32 = 4;
/// Rise of the energy, as a part of the largest kinetic energy so far, that no rounding and no zonal term makes. The potential that is
/// left out is J2 (R/r)² of the whole at most, 1.6 % on Saturn (J2 0.0163, the largest of the library), and on a circular orbit the potential is
/// twice the kinetic energy: 3.3 %. The rest, to 10 %, is assumed, for the error of a step that is long but stable; an unstable method passes
/// it within a few steps, for its error grows by powers.
const RISE: f64 = 0.1;
/// Tolerance of the time at which a table is left, as a fraction of the step.
const TOLERANCE: f64 = 1e-9;

/// Energy of a flight at a fixed step so far, J/kg.
#[derive(Clone, Copy, Debug)]
pub(super) struct Energy {
    least: f64,
    kinetic: f64,
}

impl Energy {
    pub(super) const UNKNOWN: Energy = Energy {
        least: f64::INFINITY,
        kinetic: 0.0,
    };
}

impl<'a, M: Motion<'a, N, S>, const N: usize, S: Single> Course<'_, M, N, S> {
    /// Whether each step is checked for a phase or the end of a table.
    #[inline]
    pub(super) fn is_watched(&self) -> bool {
        self.marks.refuses || !self.motion.point().mission.phases.is_empty()
    }

    /// Records the state at a time: arguments of table look-ups, and the drag.
    pub(super) fn look(&mut self, t: S, y: &[S; N]) {
        let marks = self.marks;
        if !marks.looks_along() {
            return;
        }
        let arguments = self.motion.arguments(t, y).map(S::value);
        let t_s = t.value();
        for (span, axis) in self.record.spans.iter_mut().zip(&marks.axes) {
            span.take(arguments[axis.argument as usize], t_s);
        }
        if marks.may_push {
            let drag_coefficient = self.motion.drag_coefficient(t, y).value();
            let least = self.record.pushed.map_or(0.0, |push| push.drag_coefficient);
            if drag_coefficient < least - ROUNDING {
                self.record.pushed = Some(Push {
                    drag_coefficient,
                    total_alpha_rad: arguments[Argument::TotalAlpha as usize],
                    mach: arguments[Argument::Mach as usize],
                    time_s: t_s,
                });
            }
        }
    }

    /// Checks a step: tables of the attitude, which may oscillate, within it; all others at its end.
    pub(super) fn look_along(&mut self, step: &Step<N, S>) {
        let swings = |axis: &Axis| axis.argument == Argument::TotalAlpha;
        if self.marks.axes.iter().any(swings) || self.marks.may_push {
            for i in 1..PARTS {
                let t = part(step, i);
                self.look(t, &step.at(t));
            }
        }
        self.look(step.t1, &step.y1);
    }

    /// The axis of a table beyond which the state is and the case refuses to continue.
    pub(super) fn refused(&self, t: S, y: &[S; N]) -> Option<usize> {
        if !self.marks.refuses {
            return None;
        }
        let arguments = self.motion.arguments(t, y).map(S::value);
        let beyond = |axis: &Axis| {
            axis.refuses() && axis.refused_excess(arguments[axis.argument as usize]) > 0.0
        };
        self.marks.axes.iter().position(beyond)
    }

    /// The time within a step at which it first leaves such a table, and the axis.
    pub(super) fn refused_in(&self, step: &Step<N, S>) -> Option<(S, usize)> {
        if !self.marks.refuses {
            return None;
        }
        let mut before = step.t0;
        for i in 1..=PARTS {
            let t = part(step, i);
            if let Some(index) = self.refused(t, &step.at(t)) {
                let axis = self.marks.axes.get(index)?;
                let excess = |t: f64| {
                    let t = step.time(t);
                    let arguments = self.motion.arguments(t, &step.at(t));
                    axis.refused_excess(arguments[axis.argument as usize].value())
                };
                let (from, to) = (before.value(), t.value());
                let tolerance = TOLERANCE * (step.t1 - step.t0).value();
                let when = root::brent(excess, from, to, tolerance).unwrap_or(to);
                return Some((step.time(when), index));
            }
            before = t;
        }
        None
    }

    /// Whether the energy has grown as no air makes it: a fixed step that is too long.
    pub(super) fn is_unstable(&mut self, y: &[S; N]) -> bool {
        let Some(allowance) = self.marks.wind_energy_j_kg else {
            return false;
        };
        let [x, y, z, vx, vy, vz] = [y[0], y[1], y[2], y[3], y[4], y[5]].map(S::value);
        let planet = &self.motion.point().mission.planet;
        let omega = planet.rotation_rate_rad_s;
        let kinetic = 0.5 * (vx * vx + vy * vy + vz * vz);
        let radius_m = (x * x + y * y + z * z).sqrt();
        let potential = match planet.gravity {
            Gravity::Zonal { mu_m3_s2, .. } => -mu_m3_s2 / radius_m,
            Gravity::Uniform { acceleration_m_s2 } => acceleration_m_s2 * radius_m,
        };
        let energy = kinetic + potential - 0.5 * omega * omega * (x * x + y * y);
        let before = self.energy;
        self.energy = Energy {
            least: before.least.min(energy),
            kinetic: before.kinetic.max(kinetic),
        };
        energy - before.least > RISE * before.kinetic + allowance
    }
}

/// Drag coefficient below zero that is rounding.
const ROUNDING: f64 = 1e-6;

fn part<const N: usize, S: Single>(step: &Step<N, S>, i: u32) -> S {
    if i == PARTS {
        return step.t1;
    }
    step.t0 + (step.t1 - step.t0) * (f64::from(i) / f64::from(PARTS))
}
