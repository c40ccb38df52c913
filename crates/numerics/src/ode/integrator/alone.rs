//! Methods of an integration of one lane only: a step as a result, and the repetition of a step.

use super::super::dormand_prince_54::DormandPrince54;
use super::super::dormand_prince_853::DormandPrince853;
use super::super::formula::{Origin, Trial, finite};
use super::super::rk4::Rk4;
use super::super::step::Step;
use super::super::{Method, OdeError};
use super::Integrator;
use super::Statistics;
use crate::scalar::Single;

impl<const N: usize, S: Single> Integrator<N, S> {
    /// Sets the integration to (`t`, `y`); the length of the next step and the counts are kept.
    pub fn at(mut self, t: S, y: [S; N]) -> Self {
        self.put(0, t, &y);
        self
    }

    /// Cost of the integration so far.
    #[inline]
    pub fn statistics(&self) -> Statistics {
        self.statistics_of(0)
    }

    /// Marks the right-hand side as changed: its stored value is dropped, the length of the next step is kept.
    #[inline]
    pub fn renew(&mut self) {
        self.renew_lane(0);
    }

    /// One accepted step, not beyond `t_limit` (which may be infinite).
    ///
    /// # Errors
    /// Where `t_limit` is not ahead, the tolerance cannot be met, the right-hand side is not finite, or the allowance
    /// of steps is used up; the integration then stays where it was.
    #[inline]
    pub fn step(
        &mut self,
        f: &mut impl FnMut(S, &[S; N]) -> [S; N],
        t_limit: f64,
    ) -> Result<Step<N, S>, OdeError> {
        loop {
            let attempt = self.attempt(f, S::constant(t_limit), true);
            if attempt.accepted {
                return Ok(self.step.clone());
            }
            if attempt.failed {
                let fault = self.fault(0, t_limit);
                self.fresh = true;
                return Err(fault);
            }
        }
    }

    /// Takes the last step again so that it ends at `t_end`, beyond its beginning and not beyond its end.
    ///
    /// The integration is then at `t_end`, with the accuracy of a step, not only of the dense output. May be
    /// repeated with an earlier end.
    ///
    /// # Errors
    /// Where `t_end` is not within the last step, or the right-hand side is not finite; the integration then stays
    /// where it was.
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
        let Some(known) = self.slope0 else {
            return Err(OdeError::Unreachable { t, end });
        };
        let (t0, y0) = (self.step.t0, self.step.y0);
        if !(t0.value() < end && end <= t) {
            return Err(OdeError::Unreachable { t, end });
        }
        // The right-hand side may have changed since.
        let slope0 = if self.sloped {
            known
        } else {
            self.count(true, 1);
            f(t0, &y0)
        };
        let origin = Origin {
            t: t0,
            y: &y0,
            slope: &slope0,
        };
        let trial = F::take(f, &origin, t_end - t0);
        let mut step = self.step.clone();
        let slope1 = trial.finish(f, &origin, t_end, self.dense, &mut step);
        self.count(true, F::EVALUATIONS + F::finishing(self.dense));
        if !(finite(&step.y1) && finite(&slope1)) {
            return Err(OdeError::NotFinite { t: t0.value() });
        }
        self.step = step.clone();
        (self.t, self.y, self.slope) = (step.t1, step.y1, slope1);
        self.slope0 = Some(slope0);
        self.sloped = true;
        Ok(step)
    }
}
