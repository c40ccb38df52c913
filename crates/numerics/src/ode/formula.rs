//! What the integrator asks of a Runge-Kutta formula.

use super::Dense;
use super::control::{Control, Tolerance};
use super::step::Step;

/// Where a step begins.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Origin<const N: usize> {
    pub t: f64,
    pub y: [f64; N],
    pub slope: [f64; N],
}

/// A step on trial: computed as far as is needed to judge it.
pub(super) trait Trial<const N: usize>: Sized {
    /// How the length of the next step follows from the error.
    const CONTROL: Control;

    /// The step of length `h` from `origin`.
    fn take(f: &mut impl FnMut(f64, &[f64; N]) -> [f64; N], origin: &Origin<N>, h: f64) -> Self;

    /// State at the end.
    fn y1(&self) -> &[f64; N];

    /// Square of the error over the tolerance, root mean square over the components; above 1 the step is refused.
    fn error_squared(&self, origin: &Origin<N>, h: f64, tolerance: &Tolerance<N>) -> f64;

    /// The step, which ends at `t1`, and the slope at its end.
    fn finish(
        self,
        f: &mut impl FnMut(f64, &[f64; N]) -> [f64; N],
        origin: &Origin<N>,
        t1: f64,
        dense: Dense,
    ) -> (Step<N>, [f64; N]);
}

/// Σ aᵢ kᵢ, in the order of the terms.
#[inline(always)]
pub(super) fn sum<const N: usize, const M: usize>(terms: [(f64, &[f64; N]); M]) -> [f64; N] {
    let mut sum = [0.0; N];
    for (a, k) in terms {
        for i in 0..N {
            sum[i] += a * k[i];
        }
    }
    sum
}

/// y + h Σ aᵢ kᵢ.
#[inline(always)]
pub(super) fn advance<const N: usize, const M: usize>(
    y: &[f64; N],
    h: f64,
    terms: [(f64, &[f64; N]); M],
) -> [f64; N] {
    let mut sum = sum(terms);
    for i in 0..N {
        sum[i] = y[i] + h * sum[i];
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_plus_half_of_two_times_three_plus_four_is_six() {
        assert_eq!(advance(&[1.0], 0.5, [(2.0, &[3.0]), (1.0, &[4.0])]), [6.0]);
    }
}
