//! Interface of a Runge-Kutta formula to the integrator.

use super::Dense;
use super::control::{Control, Tolerance};
use super::step::Step;
use crate::scalar::{Mask, Scalar};

/// Start of a step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Origin<'a, const N: usize, S> {
    pub t: S,
    pub y: &'a [S; N],
    pub slope: &'a [S; N],
}

/// A step on trial: computed as far as is needed to judge it.
pub(super) trait Trial<const N: usize, S: Scalar>: Sized {
    /// Rule by which the length of the next step follows from the error.
    const CONTROL: Control;
    /// Evaluations of [`Trial::take`].
    const EVALUATIONS: u32;

    /// Evaluations of [`Trial::finish`].
    fn finishing(dense: Dense) -> u32;

    /// The step of length `h` from `origin`.
    fn take(f: &mut impl FnMut(S, &[S; N]) -> [S; N], origin: &Origin<N, S>, h: S) -> Self;

    /// State at the end.
    fn y1(&self) -> &[S; N];

    /// Square of the error over the tolerance, root mean square over the components; above 1 the step is refused.
    fn error_squared(
        &self,
        origin: &Origin<N, S>,
        h: S::Value,
        tolerance: &Tolerance<N>,
    ) -> S::Value;

    /// Writes the step, which ends at `t1`, to its place; the slope at its end.
    fn finish(
        &self,
        f: &mut impl FnMut(S, &[S; N]) -> [S; N],
        origin: &Origin<N, S>,
        t1: S,
        dense: Dense,
        step: &mut Step<N, S>,
    ) -> [S; N];
}

/// Σ aᵢ kᵢ, in the order of the terms.
#[inline(always)]
pub(super) fn sum<const N: usize, const M: usize, S: Scalar>(terms: [(f64, &[S; N]); M]) -> [S; N] {
    let mut sum = [S::constant(0.0); N];
    for i in 0..N {
        let mut of_i = S::constant(0.0);
        for (n, (a, k)) in terms.iter().enumerate() {
            of_i = match n {
                0 => k[i] * *a,
                _ => of_i + k[i] * *a,
            };
        }
        sum[i] = of_i;
    }
    sum
}

/// y + h Σ aᵢ kᵢ.
#[inline(always)]
pub(super) fn advance<const N: usize, const M: usize, S: Scalar>(
    y: &[S; N],
    h: S,
    terms: [(f64, &[S; N]); M],
) -> [S; N] {
    let mut sum = sum(terms);
    for i in 0..N {
        sum[i] = y[i] + h * sum[i];
    }
    sum
}

/// The values of numbers.
#[inline(always)]
pub(super) fn values<const N: usize, S: Scalar>(y: &[S; N]) -> [S::Value; N] {
    let mut values = [S::Value::constant(0.0); N];
    for (value, y) in values.iter_mut().zip(y) {
        *value = y.value();
    }
    values
}

/// Lanes in which all numbers are finite.
#[inline(always)]
pub(super) fn finite<const N: usize, S: Scalar>(y: &[S; N]) -> S::Mask {
    let mut all = S::Mask::constant(true);
    for y in y {
        all = all.and(y.finite());
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_plus_half_of_two_times_three_plus_four_is_six() {
        assert_eq!(advance(&[1.0], 0.5, [(2.0, &[3.0]), (1.0, &[4.0])]), [6.0]);
    }

    #[test]
    fn finite_is_asked_of_each() {
        assert!(finite(&[1.0, -2.0]) && !finite(&[1.0, f64::NAN]));
    }
}
