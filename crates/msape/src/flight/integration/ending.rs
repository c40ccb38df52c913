//! End of a flight, and its reason.
//!
//! ```text
//! E = v_i²/2 − μ/r        below zero on a bound orbit
//! ```
//!
//! with E in J/kg, v_i the inertial speed in m/s, μ in m³/s² and r in m.
//!
//! # Valid
//! Range of [`super`].
//!
//! # References
//! - Own convention.

use super::MOST_STEPS;
use super::course::{Course, Next};
use crate::flight::LANDED_WITHIN_M;
use crate::flight::motion::Motion;
use crate::flight::reach::Axis;
use crate::outcome::Outcome;
use crate::planet::Gravity;
use crate::quantity::input;
use numerics::ode::OdeError;
use numerics::scalar::Single;

impl<'a, M: Motion<'a, N, S>, const N: usize, S: Single> Course<'_, M, N, S> {
    /// Ends a flight that is wanted no further.
    pub fn stop(&mut self) {
        self.record.reason = Some("stopped on request".to_string());
    }

    pub(super) fn land(&mut self) {
        let ground_m = self.marks.ground_m;
        let below_m = ground_m - self.here.altitude_m;
        if below_m > LANDED_WITHIN_M {
            self.record.reason = Some(format!(
                "the flight is {below_m:.1} m below the final altitude of {ground_m} m and falls: it does not come up to it"
            ));
            return;
        }
        let (outcome, reason) = match self.motion.point().mission.stop.altitude_m {
            Some(altitude_m) if altitude_m > 0.0 => (Outcome::Stopped, None),
            Some(_) => (Outcome::Landed, None),
            None => (
                Outcome::Landed,
                Some(format!("fell to {ground_m} m, below any ground")),
            ),
        };
        (self.record.outcome, self.record.reason) = (outcome, reason);
    }

    pub(super) fn leave(&mut self) {
        let exit_km = self.exit_m.unwrap_or_default() / 1e3;
        let bound = self.energy_j_kg(&self.now().1) < 0.0;
        let (outcome, orbit) = match bound {
            true => (Outcome::Captured, "on a bound orbit"),
            false => (Outcome::SkippedOut, "faster than escape speed"),
        };
        self.record.outcome = outcome;
        self.record.reason = Some(format!("rose through {exit_km:.0} km again, {orbit}"));
    }

    /// Ends a flight that leaves a table beyond which the case refuses to continue.
    pub(super) fn refuse(&mut self, axis: usize) {
        self.record.outcome = Outcome::Stopped;
        self.record.refused = Some(axis);
        self.record.reason = self.marks.axes.get(axis).map(Axis::refusal);
    }

    /// Ends a flight whose fixed step is too long.
    pub(super) fn blow_up(&mut self) -> Next<N, S> {
        let (t, _) = self.now();
        self.record.outcome = Outcome::GaveUp;
        self.record.reason = Some(format!(
            "the fixed step is too long: after {:.2} s the energy grows, as no air makes it; give a shorter {} or an adaptive method",
            t.value(),
            input::solver::STEP_S
        ));
        Next::Over
    }

    pub(super) fn run_out(&mut self) -> Next<N, S> {
        if self.motion.point().mission.stop.time_s.is_none() {
            self.record.outcome = Outcome::GaveUp;
            self.record.reason = Some("still in flight after 30 days".to_string());
        }
        Next::Over
    }

    /// Ends a flight that cannot be integrated further.
    pub fn give_up(&mut self, fault: &OdeError) {
        self.record.outcome = Outcome::GaveUp;
        self.record.reason = Some(match fault {
            OdeError::TooManySteps { t } => format!(
                "the limit of work, {MOST_STEPS} trials of steps, was reached after {t:.1} s of flight"
            ),
            fault => format!("the integration was given up: {fault}"),
        });
    }

    /// Energy of the inertial motion over mass, J/kg; negative on a bound orbit.
    pub(super) fn energy_j_kg(&self, y: &[S; N]) -> f64 {
        let planet = &self.motion.point().mission.planet;
        let Gravity::Zonal { mu_m3_s2, .. } = planet.gravity else {
            return -1.0;
        };
        let [x, y, z, vx, vy, vz] = [y[0], y[1], y[2], y[3], y[4], y[5]].map(S::value);
        let omega = planet.rotation_rate_rad_s;
        let (vx, vy) = (vx - omega * y, vy + omega * x);
        let radius_m = (x * x + y * y + z * z).sqrt();
        0.5 * (vx * vx + vy * vy + vz * vz) - mu_m3_s2 / radius_m
    }
}
