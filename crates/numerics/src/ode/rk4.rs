//! The classical Runge-Kutta formula of order 4 at a fixed step; dense output by the cubic Hermite polynomial.
//!
//! # References
//! - \[hairer-norsett-wanner-1993\] section II.1, table 1.2.

use super::Dense;
use super::control::{Control, Tolerance};
use super::formula::{Origin, Trial, advance};
use super::step::{Ends, Step};
use crate::scalar::Scalar;

pub(super) struct Rk4<const N: usize, S> {
    y1: [S; N],
}

impl<const N: usize, S: Scalar> Trial<N, S> for Rk4<N, S> {
    // Never used: the step is fixed.
    const CONTROL: Control = Control {
        order: 4.0,
        proportional: 0.0,
        integral: 0.0,
        shrink: 1.0,
        grow: 1.0,
    };
    const EVALUATIONS: u32 = 3;

    #[inline]
    fn finishing(_dense: Dense) -> u32 {
        1
    }

    #[inline]
    fn take(f: &mut impl FnMut(S, &[S; N]) -> [S; N], origin: &Origin<N, S>, h: S) -> Self {
        let Origin { t, y, slope: k1 } = *origin;
        let k2 = &f(t + h / 2.0, &advance(y, h, [(1.0 / 2.0, k1)]));
        let k3 = &f(t + h / 2.0, &advance(y, h, [(1.0 / 2.0, k2)]));
        let k4 = &f(t + h, &advance(y, h, [(1.0, k3)]));
        let weights = [
            (1.0 / 6.0, k1),
            (2.0 / 6.0, k2),
            (2.0 / 6.0, k3),
            (1.0 / 6.0, k4),
        ];
        Self {
            y1: advance(y, h, weights),
        }
    }

    #[inline]
    fn y1(&self) -> &[S; N] {
        &self.y1
    }

    #[inline]
    fn error_squared(
        &self,
        _origin: &Origin<N, S>,
        _h: S::Value,
        _tolerance: &Tolerance<N>,
    ) -> S::Value {
        S::Value::constant(0.0)
    }

    #[inline]
    fn finish(
        &self,
        f: &mut impl FnMut(S, &[S; N]) -> [S; N],
        origin: &Origin<N, S>,
        t1: S,
        _dense: Dense,
        step: &mut Step<N, S>,
    ) -> [S; N] {
        let slope1 = f(t1, &self.y1);
        let ends = Ends {
            t: [origin.t, t1],
            y: [origin.y, &self.y1],
            slope: [origin.slope, &slope1],
        };
        step.set(&ends, &[S::constant(0.0); N]);
        slope1
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn unit_step_of_growth_is_65_over_24() {
        // 1 + 1 + 1/2 + 1/6 + 1/24
        let origin = Origin {
            t: 0.0,
            y: &[1.0],
            slope: &[1.0],
        };
        let trial = Rk4::take(&mut |_, y: &[f64; 1]| *y, &origin, 1.0);
        assert!((trial.y1()[0] - 65.0 / 24.0).abs() < 1e-15);
    }
}
