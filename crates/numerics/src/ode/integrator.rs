//! The integrator: where it stands, how long the next step shall be, and what it has cost; one flight or many.

use super::control::{Control, LN_LEAST_ERROR_BEFORE, Tolerance, first_step, memory};
use super::dormand_prince_54::DormandPrince54;
use super::dormand_prince_853::DormandPrince853;
use super::formula::{Origin, Trial, finite};
use super::rk4::Rk4;
use super::step::Step;
use super::{Dense, Method, OdeError};
use crate::scalar::{Mask, Scalar, Single};

/// Factor to the next trial after one that was not finite.
const RETREAT: f64 = 0.1;
/// A step that would end this close before the limit, as a part of itself, ends at the limit.
const STRETCH: f64 = 0.01;
/// The same for a fixed step: only the rounding of the sum of the steps.
const FIXED_STRETCH: f64 = 1e-9;
/// Least adaptive step, in units of the last place of t.
const LEAST_STEP: f64 = 16.0 * f64::EPSILON;
const MAXIMUM_STEPS: u64 = 1_000_000;

/// What an integration has cost.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Statistics {
    /// Steps taken, each counted once however often it was retaken.
    pub accepted: u64,
    /// Trials refused: too large an error, or not finite.
    pub rejected: u64,
    /// Evaluations of the right-hand side.
    pub evaluations: u64,
}

/// An integration of y' = f(t, y) under way: one, or in a number of several lanes one a lane, each with its own t and
/// its own steps.
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
    /// Where the slope is known.
    sloped: S::Mask,
    /// Length of the next step, where it is known.
    planned: S::Value,
    is_planned: S::Mask,
    /// Length of the next trial, where one of the same step was refused.
    h: S::Value,
    /// Where no trial of the next step was refused.
    fresh: S::Mask,
    /// Where the last trial was not finite.
    wild: S::Mask,
    /// Logarithm of the error of the last step, for the control.
    before: S::Value,
    /// Where the last step began; its slope is unknown when the right-hand side has changed since.
    last: Option<(Origin<N, S>, Renewed)>,
    accepted: S::Value,
    rejected: S::Value,
    evaluations: S::Value,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Renewed {
    No,
    Yes,
}

/// What became of a trial.
#[derive(Clone, Debug)]
pub struct Attempt<const N: usize, S: Scalar> {
    /// The step, in the lanes where it was accepted.
    pub step: Option<Step<N, S>>,
    /// Lanes whose step was accepted.
    pub accepted: S::Mask,
    /// Lanes that cannot go on; [`Integrator::fault`] says why.
    pub failed: S::Mask,
}

impl<const N: usize, S: Scalar> Integrator<N, S> {
    /// An integration that stands at (`t0`, `y0`); the length of the first step is found with that step.
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
            last: None,
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

    /// Where the integration stands.
    #[inline]
    pub fn t(&self) -> S {
        self.t
    }

    /// State at [`Integrator::t`].
    #[inline]
    pub fn y(&self) -> &[S; N] {
        &self.y
    }

    /// What the integration of a lane has cost so far.
    pub fn statistics_of(&self, lane: usize) -> Statistics {
        let count = |of: S::Value| of.lane(lane) as u64;
        Statistics {
            accepted: count(self.accepted),
            rejected: count(self.rejected),
            evaluations: count(self.evaluations),
        }
    }

    /// Begins another integration in a lane, as [`Integrator::new`] does.
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

    /// Puts the integration of a lane at (`t`, `y`), within the last step or elsewhere; the length of the next step and
    /// the counts are kept. Costs one evaluation.
    #[inline]
    pub fn put(&mut self, lane: usize, t: S::Lane, y: &[S::Lane; N]) {
        self.t.set_lane(lane, t);
        for (all, y) in self.y.iter_mut().zip(y) {
            all.set_lane(lane, *y);
        }
        self.sloped.set_lane(lane, false);
        self.last = None;
    }

    /// Says that the right-hand side of a lane has changed: its stored value is forgotten, the length of the next step is
    /// kept.
    #[inline]
    pub fn renew_lane(&mut self, lane: usize) {
        self.sloped.set_lane(lane, false);
        if let Some((_, renewed)) = &mut self.last {
            *renewed = Renewed::Yes;
        }
    }

    /// One trial of a step in each of the `active` lanes, not beyond `t_limit` (which may be infinite).
    ///
    /// Lanes in which it is accepted then stand at its end; the others stand where they stood and try a shorter one next time.
    #[inline]
    pub fn attempt(
        &mut self,
        f: &mut impl FnMut(S, &[S; N]) -> [S; N],
        t_limit: S::Value,
        active: S::Mask,
    ) -> Attempt<N, S> {
        match self.method {
            Method::DormandPrince54 => self.adaptive::<DormandPrince54<N, S>>(f, t_limit, active),
            Method::DormandPrince853 => self.adaptive::<DormandPrince853<N, S>>(f, t_limit, active),
            Method::Rk4 { step } => self.fixed(f, step, t_limit, active),
        }
    }

    /// Why a lane cannot go on from where it stands towards `t_limit`.
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
        } else if self.wild.lane(lane) || !self.sound().lane(lane) {
            OdeError::NotFinite { t }
        } else {
            OdeError::StepTooSmall { t }
        }
    }

    #[inline]
    fn adaptive<F: Trial<N, S>>(
        &mut self,
        f: &mut impl FnMut(S, &[S; N]) -> [S; N],
        t_limit: S::Value,
        active: S::Mask,
    ) -> Attempt<N, S> {
        let origin = self.origin(f, active);
        let longest = S::Value::constant(self.longest);
        let unplanned = active.and(self.is_planned.not());
        if unplanned.any() {
            let room = longest.min(t_limit - origin.t.value());
            let first = first_step(f, &origin, &self.tolerance, F::CONTROL.order, room);
            self.planned = S::Value::select(unplanned, first, self.planned);
            self.is_planned = self.is_planned.or(active);
            self.count(unplanned, 1);
        }
        let wanted = S::Value::select(self.fresh, self.planned.min(longest), self.h);
        let at_limit = (origin.t.value() + wanted * (1.0 + STRETCH))
            .less(t_limit)
            .not();
        let t1 = S::select(
            at_limit,
            S::from_value(t_limit),
            origin.t + S::from_value(wanted),
        );
        let length = t1 - origin.t;
        let h = length.value();
        let moves = (origin.t.value().abs() * LEAST_STEP).less(h);
        let goes = (at_limit.and(self.fresh)).or(moves);
        let live = self.able(active, t_limit).and(goes);
        let mut attempt = Attempt {
            step: None,
            accepted: S::Mask::constant(false),
            failed: active.and(live.not()),
        };
        if !live.any() {
            return attempt;
        }
        let trial = F::take(f, &origin, length);
        self.count(live, F::EVALUATIONS);
        let error_squared = trial.error_squared(&origin, h, &self.tolerance);
        let tame = live.and(error_squared.finite()).and(finite(trial.y1()));
        let large = tame.and(S::Value::constant(1.0).less(error_squared));
        let passed = tame.and(large.not());
        let ln_error = error_squared.ln() * 0.5;
        if passed.any() {
            self.count(passed, F::finishing(self.dense));
            let (step, slope1) = trial.finish(f, &origin, t1, self.dense);
            let accepted = passed.and(finite(&slope1));
            self.plan(&F::CONTROL, ln_error, h, accepted);
            self.accept(origin, &step, slope1, accepted);
            attempt.step = Some(step);
            attempt.accepted = accepted;
        }
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
        // A step cut short by its limit says little: the plan stands.
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
        t_limit: S::Value,
        active: S::Mask,
    ) -> Attempt<N, S> {
        let origin = self.origin(f, active);
        let t = origin.t.value();
        let at_limit = (t + (1.0 + FIXED_STRETCH) * h).less(t_limit).not();
        let t1 = S::select(at_limit, S::from_value(t_limit), origin.t + h);
        let moves = if h > 0.0 {
            t.less(t1.value())
        } else {
            S::Mask::constant(false)
        };
        let live = self.able(active, t_limit).and(moves);
        if !live.any() {
            return Attempt {
                step: None,
                accepted: live,
                failed: active.and(live.not()),
            };
        }
        let trial = Rk4::take(f, &origin, t1 - origin.t);
        let (step, slope1) = trial.finish(f, &origin, t1, self.dense);
        self.count(live, <Rk4<N, S> as Trial<N, S>>::EVALUATIONS);
        self.count(live, <Rk4<N, S> as Trial<N, S>>::finishing(self.dense));
        let accepted = live.and(finite(&step.y1)).and(finite(&slope1));
        self.wild = live.and(accepted.not()).or(self.wild.and(live.not()));
        self.accept(origin, &step, slope1, accepted);
        Attempt {
            step: Some(step),
            accepted,
            failed: active.and(accepted.not()),
        }
    }

    /// Where the next step begins, with its slope.
    #[inline]
    fn origin(
        &mut self,
        f: &mut impl FnMut(S, &[S; N]) -> [S; N],
        active: S::Mask,
    ) -> Origin<N, S> {
        let unknown = active.and(self.sloped.not());
        if unknown.any() {
            let slope = f(self.t, &self.y);
            for (known, slope) in self.slope.iter_mut().zip(slope) {
                *known = S::select(unknown, slope, *known);
            }
            self.sloped = self.sloped.or(active);
            self.count(unknown, 1);
        }
        Origin {
            t: self.t,
            y: self.y,
            slope: self.slope,
        }
    }

    /// Where state and slope are numbers.
    #[inline]
    fn sound(&self) -> S::Mask {
        finite(&self.y).and(finite(&self.slope))
    }

    /// Lanes that may take a step towards `t_limit`.
    #[inline]
    fn able(&self, active: S::Mask, t_limit: S::Value) -> S::Mask {
        let trials = self.accepted + self.rejected;
        let allowed = trials.less(S::Value::constant(self.maximum_steps as f64));
        let ahead = self.t.value().less(t_limit);
        active.and(ahead).and(allowed).and(self.sound())
    }

    #[inline]
    fn accept(
        &mut self,
        origin: Origin<N, S>,
        step: &Step<N, S>,
        slope1: [S; N],
        accepted: S::Mask,
    ) {
        self.t = S::select(accepted, step.t1, self.t);
        for i in 0..N {
            self.y[i] = S::select(accepted, step.y1[i], self.y[i]);
            self.slope[i] = S::select(accepted, slope1[i], self.slope[i]);
        }
        self.fresh = self.fresh.or(accepted);
        self.wild = self.wild.and(accepted.not());
        self.accepted = S::Value::select(accepted, self.accepted + 1.0, self.accepted);
        if S::LANES == 1 && accepted.any() {
            self.last = Some((origin, Renewed::No));
        }
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

impl<const N: usize, S: Single> Integrator<N, S> {
    /// Puts the integration at (`t`, `y`); the length of the next step and the counts are kept.
    pub fn at(mut self, t: S, y: [S; N]) -> Self {
        self.put(0, t, &y);
        self
    }

    /// What the integration has cost so far.
    #[inline]
    pub fn statistics(&self) -> Statistics {
        self.statistics_of(0)
    }

    /// Says that the right-hand side has changed: its stored value is forgotten, the length of the next step is kept.
    #[inline]
    pub fn renew(&mut self) {
        self.renew_lane(0);
    }

    /// One accepted step, not beyond `t_limit` (which may be infinite).
    ///
    /// # Errors
    /// Where `t_limit` is not ahead, the tolerance cannot be met, the right-hand side is not finite, or the allowance
    /// of steps is used up; the integration then still stands where it stood.
    #[inline]
    pub fn step(
        &mut self,
        f: &mut impl FnMut(S, &[S; N]) -> [S; N],
        t_limit: f64,
    ) -> Result<Step<N, S>, OdeError> {
        loop {
            let attempt = self.attempt(f, t_limit, true);
            match attempt.step {
                Some(step) if attempt.accepted => return Ok(step),
                _ if attempt.failed => {
                    let fault = self.fault(0, t_limit);
                    self.fresh = true;
                    return Err(fault);
                }
                _ => {}
            }
        }
    }

    /// Takes the last step again so that it ends at `t_end`, beyond its beginning and not beyond its end.
    ///
    /// The integration then stands at `t_end`, with the accuracy of a step, not only of the dense output. May be
    /// repeated with an earlier end.
    ///
    /// # Errors
    /// Where `t_end` is not within the last step, or the right-hand side is not finite; the integration then still
    /// stands where it stood.
    #[inline]
    pub fn retake(
        &mut self,
        f: &mut impl FnMut(S, &[S; N]) -> [S; N],
        t_end: S,
    ) -> Result<Step<N, S>, OdeError> {
        match self.method {
            Method::DormandPrince54 => self.again::<DormandPrince54<N, S>>(f, t_end),
            Method::DormandPrince853 => self.again::<DormandPrince853<N, S>>(f, t_end),
            Method::Rk4 { .. } => self.again::<Rk4<N, S>>(f, t_end),
        }
    }

    fn again<F: Trial<N, S>>(
        &mut self,
        f: &mut impl FnMut(S, &[S; N]) -> [S; N],
        t_end: S,
    ) -> Result<Step<N, S>, OdeError> {
        let (t, end) = (self.t.value(), t_end.value());
        let Some((mut origin, renewed)) = self.last.clone() else {
            return Err(OdeError::Unreachable { t, end });
        };
        let t0 = origin.t.value();
        if !(t0 < end && end <= t) {
            return Err(OdeError::Unreachable { t, end });
        }
        if renewed == Renewed::Yes {
            origin.slope = f(origin.t, &origin.y);
            self.count(true, 1);
        }
        let trial = F::take(f, &origin, t_end - origin.t);
        let (step, slope1) = trial.finish(f, &origin, t_end, self.dense);
        self.count(true, F::EVALUATIONS + F::finishing(self.dense));
        if !(finite(&step.y1) && finite(&slope1)) {
            return Err(OdeError::NotFinite { t: t0 });
        }
        // The step was counted when it was first taken.
        self.accepted -= 1.0;
        self.accept(origin, &step, slope1, true);
        self.sloped = true;
        Ok(step)
    }
}
