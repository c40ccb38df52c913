//! The integrator: present state, length of the next step, and cost; one integration or many.

mod account;
mod alone;

use super::control::{Control, LN_LEAST_ERROR_BEFORE, Tolerance, first_step, memory, rough_ln};
use super::dormand_prince_54::DormandPrince54;
use super::dormand_prince_853::DormandPrince853;
use super::formula::{Origin, Trial, finite};
use super::rk4::Rk4;
use super::step::Step;
use super::{Dense, Method, OdeError};
use crate::scalar::{Mask, Scalar};
pub use account::{Attempt, Statistics};

/// Factor to the next trial after one that was not finite.
const RETREAT: f64 = 0.1;
/// A step that would end this close before the limit, as a fraction of the step, ends at the limit.
const STRETCH: f64 = 0.01;
/// Limit of the stretch of a fixed step: only the rounding of the sum of the steps.
const FIXED_STRETCH: f64 = 1e-9;
/// Least adaptive step, in units of the last place of t.
const LEAST_STEP: f64 = 16.0 * f64::EPSILON;
const MAXIMUM_STEPS: u64 = 1_000_000;

/// An integration of y' = f(t, y) in progress: one, or one per lane, each with its own t and its own steps.
///
/// With derivatives, the length of the steps is that of the values alone.
#[derive(Clone, Debug)]
pub struct Integrator<const N: usize, S: Scalar = f64> {
    method: Method,
    tolerance: Tolerance<N>,
    dense: Dense,
    longest: f64,
    maximum_steps: u64,
    t: S,
    y: [S; N],
    /// Slope at (t, y).
    slope: [S; N],
    /// Lanes in which the slope is known.
    sloped: S::Mask,
    /// Length of the next step, where it is known.
    planned: S::Value,
    is_planned: S::Mask,
    /// Length of the next trial, where one of the same step was refused.
    h: S::Value,
    /// Lanes in which no trial of the next step was refused.
    fresh: S::Mask,
    /// Lanes in which the last trial was not finite.
    wild: S::Mask,
    /// Logarithm of the error of the last step, for the control.
    before: S::Value,
    /// Lanes in which the last trial was not finite at its beginning.
    unsound: S::Mask,
    /// The last step.
    step: Step<N, S>,
    /// Slope at its beginning, where it can be taken again.
    slope0: Option<[S; N]>,
    accepted: S::Value,
    rejected: S::Value,
    evaluations: S::Value,
}

impl<const N: usize, S: Scalar> Integrator<N, S> {
    /// An integration at the state (`t0`, `y0`); the length of the first step is found with that step.
    pub fn new(method: Method, tolerance: Tolerance<N>, t0: S, y0: [S; N]) -> Self {
        let zero = S::Value::constant(0.0);
        Self {
            method,
            tolerance,
            dense: Dense::default(),
            longest: f64::INFINITY,
            maximum_steps: MAXIMUM_STEPS,
            t: t0,
            y: y0,
            slope: [S::constant(0.0); N],
            sloped: S::Mask::constant(false),
            planned: zero,
            is_planned: S::Mask::constant(false),
            h: zero,
            fresh: S::Mask::constant(true),
            wild: S::Mask::constant(false),
            before: S::Value::constant(LN_LEAST_ERROR_BEFORE),
            unsound: S::Mask::constant(false),
            step: Step::none(t0, y0),
            slope0: None,
            accepted: zero,
            rejected: zero,
            evaluations: zero,
        }
    }

    /// Sets what is spent on interpolation within the steps.
    pub fn with_dense(mut self, dense: Dense) -> Self {
        self.dense = dense;
        self
    }

    /// Sets the longest adaptive step, in the unit of t; one that ends at a limit may be a hundredth longer.
    pub fn with_longest_step(mut self, longest: f64) -> Self {
        self.longest = longest;
        self
    }

    /// Sets how many trials, accepted or refused, the integration may take; a million where it is not set.
    pub fn with_maximum_steps(mut self, maximum_steps: u64) -> Self {
        self.maximum_steps = maximum_steps;
        self
    }

    /// Present time of the integration.
    #[inline]
    pub fn t(&self) -> S {
        self.t
    }

    /// State at [`Integrator::t`].
    #[inline]
    pub fn y(&self) -> &[S; N] {
        &self.y
    }

    /// The step that the last trial took, in the lanes where it was accepted.
    #[inline]
    pub fn last_step(&self) -> &Step<N, S> {
        &self.step
    }

    /// Cost of the integration of a lane so far.
    pub fn statistics_of(&self, lane: usize) -> Statistics {
        let count = |of: S::Value| of.lane(lane) as u64;
        Statistics {
            accepted: count(self.accepted),
            rejected: count(self.rejected),
            evaluations: count(self.evaluations),
        }
    }

    /// Starts another integration in a lane, as [`Integrator::new`] does.
    pub fn restart(&mut self, lane: usize, t0: S::Lane, y0: &[S::Lane; N]) {
        self.put(lane, t0, y0);
        self.is_planned.set_lane(lane, false);
        self.fresh.set_lane(lane, true);
        self.before.set_lane(lane, LN_LEAST_ERROR_BEFORE);
        for count in [
            &mut self.accepted,
            &mut self.rejected,
            &mut self.evaluations,
        ] {
            count.set_lane(lane, 0.0);
        }
    }

    /// Sets the integration of a lane to (`t`, `y`), within the last step or elsewhere; the length of the next step and
    /// the counts are kept. Costs one evaluation.
    #[inline]
    pub fn put(&mut self, lane: usize, t: S::Lane, y: &[S::Lane; N]) {
        self.t.set_lane(lane, t);
        for (all, y) in self.y.iter_mut().zip(y) {
            all.set_lane(lane, *y);
        }
        self.sloped.set_lane(lane, false);
        self.slope0 = None;
    }

    /// Marks the right-hand side of a lane as changed: its stored value is dropped, the length of the next step is
    /// kept.
    #[inline]
    pub fn renew_lane(&mut self, lane: usize) {
        self.sloped.set_lane(lane, false);
    }

    /// One trial of a step in each of the `active` lanes, not beyond `t_limit` (which may be infinite).
    ///
    /// Lanes in which it is accepted are then at its end; the others stay where they were and try a shorter one next
    /// time.
    #[inline]
    pub fn attempt(
        &mut self,
        f: &mut impl FnMut(S, &[S; N]) -> [S; N],
        t_limit: S,
        active: S::Mask,
    ) -> Attempt<S> {
        match self.method {
            Method::DormandPrince54 => self.adaptive::<DormandPrince54<N, S>>(f, t_limit, active),
            Method::DormandPrince853 => self.adaptive::<DormandPrince853<N, S>>(f, t_limit, active),
            Method::Rk4 { step } => self.fixed(f, step, t_limit, active),
        }
    }

    /// Reason why a lane cannot continue from its present state toward `t_limit`.
    pub fn fault(&self, lane: usize, t_limit: f64) -> OdeError {
        let t = self.t.value().lane(lane);
        let ahead = t < t_limit;
        let Statistics {
            accepted, rejected, ..
        } = self.statistics_of(lane);
        if !ahead {
            OdeError::Unreachable { t, end: t_limit }
        } else if accepted + rejected >= self.maximum_steps {
            OdeError::TooManySteps { t }
        } else if self.wild.lane(lane) || self.unsound.lane(lane) {
            OdeError::NotFinite { t }
        } else {
            OdeError::StepTooSmall { t }
        }
    }

    #[inline]
    fn adaptive<F: Trial<N, S>>(
        &mut self,
        f: &mut impl FnMut(S, &[S; N]) -> [S; N],
        t_limit: S,
        active: S::Mask,
    ) -> Attempt<S> {
        self.know_slope(f, active);
        let t = self.t.value();
        let longest = S::Value::constant(self.longest);
        let unplanned = active.and(self.is_planned.not());
        if unplanned.any() {
            let room = longest.min(t_limit.value() - t);
            let origin = Origin {
                t: self.t,
                y: &self.y,
                slope: &self.slope,
            };
            let first = first_step(f, &origin, &self.tolerance, F::CONTROL.order, room);
            self.planned = S::Value::select(unplanned, first, self.planned);
            self.is_planned = self.is_planned.or(active);
            self.count(unplanned, 1);
        }
        let wanted = S::Value::select(self.fresh, self.planned.min(longest), self.h);
        let at_limit = (t + wanted * (1.0 + STRETCH)).less(t_limit.value()).not();
        let t1 = S::select(at_limit, t_limit, self.t + S::from_value(wanted));
        let length = t1 - self.t;
        let h = length.value();
        let moves = (t.abs() * LEAST_STEP).less(h);
        let goes = (at_limit.and(self.fresh)).or(moves);
        let live = self.able(active, t_limit).and(goes);
        let mut attempt = Attempt {
            accepted: S::Mask::constant(false),
            failed: active.and(live.not()),
        };
        if !live.any() {
            return attempt;
        }
        let origin = Origin {
            t: self.t,
            y: &self.y,
            slope: &self.slope,
        };
        let trial = F::take(f, &origin, length);
        let error_squared = trial.error_squared(&origin, h, &self.tolerance);
        let tame = live.and(error_squared.finite()).and(finite(trial.y1()));
        let large = tame.and(S::Value::constant(1.0).less(error_squared));
        let passed = tame.and(large.not());
        let ln_error = rough_ln(error_squared) * 0.5;
        if passed.any() {
            let slope1 = trial.finish(f, &origin, t1, self.dense, &mut self.step);
            let accepted = passed.and(finite(&slope1));
            self.count(passed, F::finishing(self.dense));
            self.plan(&F::CONTROL, ln_error, h, accepted);
            self.accept(&slope1, accepted);
            attempt.accepted = accepted;
        }
        self.count(live, F::EVALUATIONS);
        let refused = live.and(attempt.accepted.not());
        if refused.any() {
            let shorter = h * F::CONTROL.factor_refused(ln_error);
            let h = S::Value::select(large, shorter, h * RETREAT);
            self.refuse(refused, h, refused.and(large.not()));
        }
        attempt
    }

    /// Length of the next step after one of length `h`, in the lanes where it was accepted.
    #[inline]
    fn plan(&mut self, control: &Control, ln_error: S::Value, h: S::Value, accepted: S::Mask) {
        let next = h * control.factor_accepted(ln_error, self.before);
        let cut_short = self.fresh.and(h.less(self.planned));
        // A step cut short by its limit gives no information on the step size: the planned size stays.
        let after_refusal = S::Value::select(self.fresh, next, next.min(h));
        let planned = S::Value::select(cut_short, next.max(self.planned), after_refusal);
        self.planned = S::Value::select(accepted, planned, self.planned);
        let judged = accepted.and(cut_short.not());
        self.before = S::Value::select(judged, memory(ln_error), self.before);
    }

    #[inline]
    fn fixed(
        &mut self,
        f: &mut impl FnMut(S, &[S; N]) -> [S; N],
        h: f64,
        t_limit: S,
        active: S::Mask,
    ) -> Attempt<S> {
        self.know_slope(f, active);
        let t = self.t.value();
        let at_limit = (t + (1.0 + FIXED_STRETCH) * h).less(t_limit.value()).not();
        let t1 = S::select(at_limit, t_limit, self.t + h);
        let moves = if h > 0.0 {
            t.less(t1.value())
        } else {
            S::Mask::constant(false)
        };
        let live = self.able(active, t_limit).and(moves);
        if !live.any() {
            return Attempt {
                accepted: live,
                failed: active.and(live.not()),
            };
        }
        let origin = Origin {
            t: self.t,
            y: &self.y,
            slope: &self.slope,
        };
        let trial = Rk4::take(f, &origin, t1 - self.t);
        let slope1 = trial.finish(f, &origin, t1, self.dense, &mut self.step);
        let of_step = <Rk4<N, S> as Trial<N, S>>::EVALUATIONS;
        self.count(
            live,
            of_step + <Rk4<N, S> as Trial<N, S>>::finishing(self.dense),
        );
        let accepted = live.and(finite(&self.step.y1)).and(finite(&slope1));
        self.wild = live.and(accepted.not()).or(self.wild.and(live.not()));
        self.accept(&slope1, accepted);
        Attempt {
            accepted,
            failed: active.and(accepted.not()),
        }
    }

    /// Computes the slope where it is not known.
    #[inline]
    fn know_slope(&mut self, f: &mut impl FnMut(S, &[S; N]) -> [S; N], active: S::Mask) {
        let unknown = active.and(self.sloped.not());
        if unknown.any() {
            let slope = f(self.t, &self.y);
            for (known, slope) in self.slope.iter_mut().zip(slope) {
                *known = S::select(unknown, slope, *known);
            }
            // An accepted state is finite; one set by `put` need not be.
            let sound = finite(&self.y).and(finite(&self.slope));
            self.unsound = self.unsound.and(unknown.not()).or(unknown.and(sound.not()));
            self.sloped = self.sloped.or(active);
            self.count(unknown, 1);
        }
    }

    /// Lanes that may take a step toward `t_limit`.
    #[inline]
    fn able(&self, active: S::Mask, t_limit: S) -> S::Mask {
        let trials = self.accepted + self.rejected;
        let allowed = trials.less(S::Value::constant(self.maximum_steps as f64));
        let ahead = self.t.value().less(t_limit.value());
        active.and(ahead).and(allowed).and(self.unsound.not())
    }

    /// Moves to the end of the step where it is accepted.
    #[inline]
    fn accept(&mut self, slope1: &[S; N], accepted: S::Mask) {
        if S::LANES == 1 && accepted.any() {
            self.slope0 = Some(self.slope);
        }
        self.t = S::select(accepted, self.step.t1, self.t);
        for (i, slope1) in slope1.iter().enumerate() {
            self.y[i] = S::select(accepted, self.step.y1[i], self.y[i]);
            self.slope[i] = S::select(accepted, *slope1, self.slope[i]);
        }
        self.fresh = self.fresh.or(accepted);
        self.wild = self.wild.and(accepted.not());
        self.accepted = S::Value::select(accepted, self.accepted + 1.0, self.accepted);
    }

    #[inline]
    fn refuse(&mut self, refused: S::Mask, h: S::Value, wild: S::Mask) {
        self.h = S::Value::select(refused, h, self.h);
        self.fresh = self.fresh.and(refused.not());
        self.wild = wild.or(self.wild.and(refused.not()));
        self.rejected = S::Value::select(refused, self.rejected + 1.0, self.rejected);
    }

    #[inline]
    fn count(&mut self, lanes: S::Mask, evaluations: u32) {
        let more = self.evaluations + f64::from(evaluations);
        self.evaluations = S::Value::select(lanes, more, self.evaluations);
    }
}
