//! The integrator: where it stands, how long the next step shall be, and what it has cost.

use super::control::{Control, LN_LEAST_ERROR_BEFORE, Tolerance, first_step, memory};
use super::dormand_prince_54::DormandPrince54;
use super::dormand_prince_853::DormandPrince853;
use super::formula::{Origin, Trial};
use super::rk4::Rk4;
use super::step::Step;
use super::{Dense, Method, OdeError};
use crate::math;

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

/// An integration of y' = f(t, y) under way.
#[derive(Clone, Debug)]
pub struct Integrator<const N: usize> {
    method: Method,
    tolerance: Tolerance<N>,
    dense: Dense,
    longest: f64,
    maximum_steps: u64,
    t: f64,
    y: [f64; N],
    /// Slope at (t, y), where it is known.
    slope: Option<[f64; N]>,
    /// Length of the next step; unknown before the first.
    h: Option<f64>,
    /// Logarithm of the error of the last step, for the control.
    before: f64,
    /// Where the last step began; its slope is unknown when the right-hand side has changed since.
    last: Option<(Origin<N>, Renewed)>,
    statistics: Statistics,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Renewed {
    No,
    Yes,
}

impl<const N: usize> Integrator<N> {
    /// An integration that stands at (`t0`, `y0`); the length of the first step is found with that step.
    pub fn new(method: Method, tolerance: Tolerance<N>, t0: f64, y0: [f64; N]) -> Self {
        Self {
            method,
            tolerance,
            dense: Dense::default(),
            longest: f64::INFINITY,
            maximum_steps: MAXIMUM_STEPS,
            t: t0,
            y: y0,
            slope: None,
            h: None,
            before: LN_LEAST_ERROR_BEFORE,
            last: None,
            statistics: Statistics::default(),
        }
    }

    /// Puts the integration at (`t`, `y`); the length of the next step and the counts are kept.
    pub fn at(mut self, t: f64, y: [f64; N]) -> Self {
        self.t = t;
        self.y = y;
        self.slope = None;
        self.last = None;
        self
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
    pub fn t(&self) -> f64 {
        self.t
    }

    /// State at [`Integrator::t`].
    #[inline]
    pub fn y(&self) -> &[f64; N] {
        &self.y
    }

    /// What the integration has cost so far.
    #[inline]
    pub fn statistics(&self) -> Statistics {
        self.statistics
    }

    /// Says that the right-hand side has changed: its stored value is forgotten, the length of the next step is kept.
    #[inline]
    pub fn renew(&mut self) {
        self.slope = None;
        if let Some((_, renewed)) = &mut self.last {
            *renewed = Renewed::Yes;
        }
    }

    /// One accepted step, not beyond `t_limit` (which may be infinite).
    ///
    /// # Errors
    /// Where `t_limit` is not ahead, the tolerance cannot be met, the right-hand side is not finite, or the allowance
    /// of steps is used up; the integration then still stands where it stood.
    #[inline]
    pub fn step(
        &mut self,
        f: &mut impl FnMut(f64, &[f64; N]) -> [f64; N],
        t_limit: f64,
    ) -> Result<Step<N>, OdeError> {
        let mut evaluations = 0;
        let mut counted = |t: f64, y: &[f64; N]| {
            evaluations += 1;
            f(t, y)
        };
        let step = match self.method {
            Method::DormandPrince54 => self.adaptive::<DormandPrince54<N>>(&mut counted, t_limit),
            Method::DormandPrince853 => self.adaptive::<DormandPrince853<N>>(&mut counted, t_limit),
            Method::Rk4 { step } => self.fixed(&mut counted, step, t_limit),
        };
        self.statistics.evaluations += evaluations;
        step
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
        f: &mut impl FnMut(f64, &[f64; N]) -> [f64; N],
        t_end: f64,
    ) -> Result<Step<N>, OdeError> {
        let mut evaluations = 0;
        let mut counted = |t: f64, y: &[f64; N]| {
            evaluations += 1;
            f(t, y)
        };
        let step = match self.method {
            Method::DormandPrince54 => self.again::<DormandPrince54<N>>(&mut counted, t_end),
            Method::DormandPrince853 => self.again::<DormandPrince853<N>>(&mut counted, t_end),
            Method::Rk4 { .. } => self.again::<Rk4<N>>(&mut counted, t_end),
        };
        self.statistics.evaluations += evaluations;
        step
    }

    fn adaptive<F: Trial<N>>(
        &mut self,
        f: &mut impl FnMut(f64, &[f64; N]) -> [f64; N],
        t_limit: f64,
    ) -> Result<Step<N>, OdeError> {
        let origin = self.origin(f, t_limit)?;
        let t = origin.t;
        let planned = match self.h {
            Some(h) => h,
            None => first_step(
                f,
                &origin,
                &self.tolerance,
                F::CONTROL.order,
                self.longest.min(t_limit - t),
            ),
        };
        let mut h = planned.min(self.longest);
        let mut refused = OdeError::StepTooSmall { t };
        let mut first_trial = true;
        loop {
            self.check_allowance()?;
            let at_limit = t + (1.0 + STRETCH) * h >= t_limit;
            let t1 = if at_limit { t_limit } else { t + h };
            // A comparison with a step that is not a number fails, too.
            if !(at_limit && first_trial || t1 - t > LEAST_STEP * t.abs()) {
                return Err(refused);
            }
            h = t1 - t;
            let trial = F::take(f, &origin, h);
            let error_squared = trial.error_squared(&origin, h, &self.tolerance);
            if error_squared.is_finite() && trial.y1().iter().all(|y| y.is_finite()) {
                if error_squared > 1.0 {
                    h *= F::CONTROL.factor_refused(0.5 * math::ln(error_squared));
                    refused = OdeError::StepTooSmall { t };
                    first_trial = false;
                    self.statistics.rejected += 1;
                    continue;
                }
                let (step, slope1) = trial.finish(f, &origin, t1, self.dense);
                if slope1.iter().all(|slope| slope.is_finite()) {
                    self.plan(
                        &F::CONTROL,
                        0.5 * math::ln(error_squared),
                        [h, planned],
                        first_trial,
                    );
                    self.accept(origin, &step, slope1);
                    self.statistics.accepted += 1;
                    return Ok(step);
                }
            }
            h *= RETREAT;
            refused = OdeError::NotFinite { t };
            first_trial = false;
            self.statistics.rejected += 1;
        }
    }

    /// Length of the next step after one of length `h` where `planned` was intended.
    fn plan(&mut self, control: &Control, ln_error: f64, [h, planned]: [f64; 2], first: bool) {
        let next = h * control.factor_accepted(ln_error, self.before);
        let cut_short = first && h < planned;
        self.h = Some(match (first, cut_short) {
            // A step cut short by its limit says little: the plan stands.
            (_, true) => next.max(planned),
            (false, _) => next.min(h),
            (true, _) => next,
        });
        if !cut_short {
            self.before = memory(ln_error);
        }
    }

    fn fixed(
        &mut self,
        f: &mut impl FnMut(f64, &[f64; N]) -> [f64; N],
        h: f64,
        t_limit: f64,
    ) -> Result<Step<N>, OdeError> {
        let origin = self.origin(f, t_limit)?;
        let t = origin.t;
        self.check_allowance()?;
        let t1 = if t + (1.0 + FIXED_STRETCH) * h >= t_limit {
            t_limit
        } else {
            t + h
        };
        if !(h > 0.0 && t1 > t) {
            return Err(OdeError::StepTooSmall { t });
        }
        let (step, slope1) = self.whole::<Rk4<N>>(f, &origin, t1)?;
        self.accept(origin, &step, slope1);
        self.statistics.accepted += 1;
        Ok(step)
    }

    fn again<F: Trial<N>>(
        &mut self,
        f: &mut impl FnMut(f64, &[f64; N]) -> [f64; N],
        t_end: f64,
    ) -> Result<Step<N>, OdeError> {
        let unreachable = OdeError::Unreachable {
            t: self.t,
            end: t_end,
        };
        let Some((mut origin, renewed)) = self.last.clone() else {
            return Err(unreachable);
        };
        if !(origin.t < t_end && t_end <= self.t) {
            return Err(unreachable);
        }
        if renewed == Renewed::Yes {
            origin.slope = f(origin.t, &origin.y);
        }
        let (step, slope1) = self.whole::<F>(f, &origin, t_end)?;
        self.accept(origin, &step, slope1);
        Ok(step)
    }

    /// The step from `origin` to `t1`, whatever its error.
    fn whole<F: Trial<N>>(
        &self,
        f: &mut impl FnMut(f64, &[f64; N]) -> [f64; N],
        origin: &Origin<N>,
        t1: f64,
    ) -> Result<(Step<N>, [f64; N]), OdeError> {
        let trial = F::take(f, origin, t1 - origin.t);
        let (step, slope1) = trial.finish(f, origin, t1, self.dense);
        if step.y1.iter().chain(&slope1).all(|y| y.is_finite()) {
            Ok((step, slope1))
        } else {
            Err(OdeError::NotFinite { t: origin.t })
        }
    }

    /// Where the next step begins, with its slope.
    fn origin(
        &mut self,
        f: &mut impl FnMut(f64, &[f64; N]) -> [f64; N],
        t_limit: f64,
    ) -> Result<Origin<N>, OdeError> {
        let (t, y) = (self.t, self.y);
        let ahead = t < t_limit;
        if !ahead {
            return Err(OdeError::Unreachable { t, end: t_limit });
        }
        let slope = self.slope.unwrap_or_else(|| f(t, &y));
        if !y.iter().chain(&slope).all(|y| y.is_finite()) {
            return Err(OdeError::NotFinite { t });
        }
        self.slope = Some(slope);
        Ok(Origin { t, y, slope })
    }

    fn accept(&mut self, origin: Origin<N>, step: &Step<N>, slope1: [f64; N]) {
        self.t = step.t1;
        self.y = step.y1;
        self.slope = Some(slope1);
        self.last = Some((origin, Renewed::No));
    }

    fn check_allowance(&self) -> Result<(), OdeError> {
        if self.statistics.accepted + self.statistics.rejected < self.maximum_steps {
            Ok(())
        } else {
            Err(OdeError::TooManySteps { t: self.t })
        }
    }
}
