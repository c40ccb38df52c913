//! The formula of Dormand and Prince of order 5 with embedded order 4, first same as last, and its dense output of order 4.
//!
//! # References
//! - \[dormand-prince-1980\] table 2 (RK5(4)7M).
//! - \[hairer-norsett-wanner-1993\] table II.5.2; dense output (attributed there to Shampine) from their code DOPRI5.

use super::Dense;
use super::control::{Control, Tolerance, mean_square};
use super::formula::{Origin, Trial, advance, sum, values};
use super::step::{Ends, Step};
use crate::scalar::Scalar;

const BETA: f64 = 0.04;

pub(super) struct DormandPrince54<const N: usize, S> {
    /// k₃ to k₇ (k₁ is the origin's slope, k₂ has no weight); k₇ is the slope at the end.
    k: [[S; N]; 5],
    y1: [S; N],
}

impl<const N: usize, S: Scalar> Trial<N, S> for DormandPrince54<N, S> {
    const CONTROL: Control = Control {
        order: 5.0,
        proportional: 0.2 - 0.75 * BETA,
        integral: BETA,
        shrink: 0.2,
        grow: 10.0,
    };
    const EVALUATIONS: u32 = 6;

    #[inline]
    fn finishing(_dense: Dense) -> u32 {
        0
    }

    #[rustfmt::skip]
    #[inline]
    fn take(f: &mut impl FnMut(S, &[S; N]) -> [S; N], origin: &Origin<N, S>, h: S) -> Self {
        let Origin { t, y, slope: k1 } = *origin;
        let k2 = &f(t + h * (1.0 / 5.0), &advance(y, h, [(1.0 / 5.0, k1)]));
        let k3 = &f(t + h * (3.0 / 10.0), &advance(y, h, [(3.0 / 40.0, k1), (9.0 / 40.0, k2)]));
        let k4 = &f(t + h * (4.0 / 5.0), &advance(y, h, [(44.0 / 45.0, k1), (-56.0 / 15.0, k2), (32.0 / 9.0, k3)]));
        let k5 = &f(t + h * (8.0 / 9.0), &advance(y, h, [
            (19372.0 / 6561.0, k1), (-25360.0 / 2187.0, k2), (64448.0 / 6561.0, k3), (-212.0 / 729.0, k4),
        ]));
        let k6 = &f(t + h, &advance(y, h, [
            (9017.0 / 3168.0, k1), (-355.0 / 33.0, k2), (46732.0 / 5247.0, k3), (49.0 / 176.0, k4),
            (-5103.0 / 18656.0, k5),
        ]));
        let y1 = advance(y, h, [
            (35.0 / 384.0, k1), (500.0 / 1113.0, k3), (125.0 / 192.0, k4), (-2187.0 / 6784.0, k5), (11.0 / 84.0, k6),
        ]);
        let k7 = f(t + h, &y1);
        Self { k: [*k3, *k4, *k5, *k6, k7], y1 }
    }

    #[inline]
    fn y1(&self) -> &[S; N] {
        &self.y1
    }

    #[inline]
    fn error_squared(
        &self,
        origin: &Origin<N, S>,
        h: S::Value,
        tolerance: &Tolerance<N>,
    ) -> S::Value {
        let [k3, k4, k5, k6, k7] = &self.k;
        let error = sum([
            (71.0 / 57600.0, origin.slope),
            (-71.0 / 16695.0, k3),
            (71.0 / 1920.0, k4),
            (-17253.0 / 339200.0, k5),
            (22.0 / 525.0, k6),
            (-1.0 / 40.0, k7),
        ]);
        h * h * mean_square(&values(&error), &tolerance.scale(origin.y, &self.y1))
    }

    #[inline]
    fn finish(
        &self,
        _f: &mut impl FnMut(S, &[S; N]) -> [S; N],
        origin: &Origin<N, S>,
        t1: S,
        _dense: Dense,
        step: &mut Step<N, S>,
    ) -> [S; N] {
        let Self {
            k: [k3, k4, k5, k6, k7],
            y1,
        } = self;
        let h = t1 - origin.t;
        let correction = advance(
            &[S::constant(0.0); N],
            h,
            [
                (-12715105075.0 / 11282082432.0, origin.slope),
                (87487479700.0 / 32700410799.0, k3),
                (-10690763975.0 / 1880347072.0, k4),
                (701980252875.0 / 199316789632.0, k5),
                (-1453857185.0 / 822651844.0, k6),
                (69997945.0 / 29380423.0, k7),
            ],
        );
        let ends = Ends {
            t: [origin.t, t1],
            y: [origin.y, y1],
            slope: [origin.slope, k7],
        };
        step.set(&ends, &correction);
        *k7
    }
}
