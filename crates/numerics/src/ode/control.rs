//! Error norm, first step and next step.
//!
//! ```text
//! error = √( 1/N Σ (eᵢ / sᵢ)² )         sᵢ = absoluteᵢ + relative max(|y₀ᵢ|, |y₁ᵢ|)
//! h_next = h · 0.9 error⁻ᵅ error_beforeᵝ     kept within shrink…grow
//! ```
//!
//! # References
//! - \[hairer-norsett-wanner-1993\] section II.4, eqs 4.11 to 4.13 and the first step after them; the constants of the
//!   codes DOPRI5 and DOP853.
//! - \[hairer-wanner-1996\] section IV.2, proportional-integral control.

use super::formula::{Origin, advance, values};
use crate::scalar::{Mask, Scalar};

const SAFETY: f64 = 0.9;
const SQRT_2: f64 = core::f64::consts::SQRT_2;
const LN_2: f64 = core::f64::consts::LN_2;
/// 2⁵²: above it all numbers are whole.
const WHOLE: f64 = 4_503_599_627_370_496.0;
/// ln 10⁻⁴: an error still smaller does not slow the step after the next; kept before the first step, too.
pub(super) const LN_LEAST_ERROR_BEFORE: f64 = -9.210_340_371_976_182;

/// The error allowed in a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance<const N: usize> {
    /// Error of each component relative to its value.
    pub relative: [f64; N],
    /// Error of each component, in its own unit; above zero where the component may be zero, infinite to leave the
    /// component out of the control.
    pub absolute: [f64; N],
}

impl<const N: usize> Tolerance<N> {
    /// Error allowed in each component of a step from `y0` to `y1`.
    #[inline]
    pub(super) fn scale<S: Scalar>(&self, y0: &[S; N], y1: &[S; N]) -> [S::Value; N] {
        core::array::from_fn(|i| {
            let largest = y0[i].value().abs().max(y1[i].value().abs());
            let allowed = largest * self.relative[i] + self.absolute[i];
            allowed.max(S::Value::constant(f64::MIN_POSITIVE))
        })
    }
}

/// Σ (eᵢ / sᵢ)² / N.
#[inline]
pub(super) fn mean_square<const N: usize, V: Scalar>(e: &[V; N], scale: &[V; N]) -> V {
    let mut sum = V::constant(0.0);
    for i in 0..N {
        let part = e[i] / scale[i];
        sum += part * part;
    }
    sum / N as f64
}

/// Constants of a formula's step control.
pub(super) struct Control {
    /// Order of the formula.
    pub order: f64,
    /// α: exponent of the error.
    pub proportional: f64,
    /// β: exponent of the error before.
    pub integral: f64,
    /// Least factor from one step to the next.
    pub shrink: f64,
    /// Largest factor from one step to the next.
    pub grow: f64,
}

impl Control {
    /// Factor to the next step after one that was accepted, from the logarithm of its error and [`memory`] of the step
    /// before it.
    #[inline]
    pub fn factor_accepted<V: Scalar<Value = V>>(&self, ln_error: V, before: V) -> V {
        let factor = rough_exp(before * self.integral - ln_error * self.proportional) * SAFETY;
        factor
            .max(V::constant(self.shrink))
            .min(V::constant(self.grow))
    }

    /// Factor to the next trial after one that was refused, from the logarithm of its error.
    #[inline]
    pub fn factor_refused<V: Scalar<Value = V>>(&self, ln_error: V) -> V {
        let factor = rough_exp(-(ln_error * self.proportional)) * SAFETY;
        factor
            .max(V::constant(self.shrink))
            .min(V::constant(SAFETY))
    }
}

/// Natural logarithm of a number above zero to 1e-9, by the exponent and a series: a step may be that much longer, and
/// all lanes are done at once.
///
/// ```text
/// ln(m 2ᵉ) = e ln 2 + ln √2 + 2 (t + t³/3 + t⁵/5 + t⁷/7 + t⁹/9)     t = (m - √2)/(m + √2)
/// ```
#[inline(always)]
pub(super) fn rough_ln<V: Scalar>(x: V) -> V::Value {
    x.map_value(|x| {
        let bits = x.to_bits();
        // The exponent as the low bits of a number at 2⁵².
        let exponent = f64::from_bits(WHOLE.to_bits() | (bits >> 52)) - (WHOLE + 1023.0);
        let m = f64::from_bits((bits & 0x000f_ffff_ffff_ffff) | 1.0_f64.to_bits());
        let t = (m - SQRT_2) / (m + SQRT_2);
        let t2 = t * t;
        let series = t2 * (t2 * (t2 * (t2 / 9.0 + 1.0 / 7.0) + 1.0 / 5.0) + 1.0 / 3.0) + 1.0;
        exponent * LN_2 + (0.5 * LN_2 + 2.0 * t * series)
    })
}

/// Exponential function to 1e-9, by the nearest power of two and a series.
#[inline(always)]
pub(super) fn rough_exp<V: Scalar>(x: V) -> V::Value {
    x.map_value(|x| {
        let held = if x < 500.0 { x } else { 500.0 };
        let held = if held < -500.0 { -500.0 } else { held };
        // Adding and taking away 1.5 · 2⁵² leaves the nearest whole number.
        let power = (held * (1.0 / LN_2) + 1.5 * WHOLE) - 1.5 * WHOLE;
        let r = held - power * LN_2;
        let high = r * (r * (r * (r / 40320.0 + 1.0 / 5040.0) + 1.0 / 720.0) + 1.0 / 120.0);
        let series = r * (r * (r * (r * (high + 1.0 / 24.0) + 1.0 / 6.0) + 0.5) + 1.0) + 1.0;
        f64::from_bits((power + (WHOLE + 1023.0)).to_bits() << 52) * series
    })
}

/// Logarithm of the error of an accepted step as the control keeps it, from its logarithm `ln_error`.
#[inline]
pub(super) fn memory<V: Scalar>(ln_error: V) -> V {
    ln_error.max(V::constant(LN_LEAST_ERROR_BEFORE))
}

/// Length of the first step, not above `longest`, at the cost of one evaluation.
pub(super) fn first_step<const N: usize, S: Scalar>(
    f: &mut impl FnMut(S, &[S; N]) -> [S; N],
    origin: &Origin<N, S>,
    tolerance: &Tolerance<N>,
    order: f64,
    longest: S::Value,
) -> S::Value {
    let Origin { t, y, slope } = *origin;
    let number = S::Value::constant;
    let scale = tolerance.scale(y, y);
    let (d0, d1) = (
        mean_square(&values(y), &scale).sqrt(),
        mean_square(&values(slope), &scale).sqrt(),
    );
    let little = d0.less(number(1e-5)).or(d1.less(number(1e-5)));
    let h0 = S::Value::select(little, number(1e-6), d0 * 0.01 / d1).min(longest);
    let h = S::from_value(h0);
    let ahead = f(t + h, &advance(y, h, [(1.0, slope)]));
    let change = core::array::from_fn(|i| (ahead[i] - slope[i]).value());
    let d2 = mean_square(&change, &scale).sqrt() / h0;
    // A trial point where the right-hand side is not finite gives no estimate.
    let largest = S::Value::select(d2.finite(), d1.max(d2), d1);
    let still = number(1e-15).less(largest).not();
    let h1 = S::Value::select(
        still,
        (h0 * 1e-3).max(number(1e-6)),
        (number(0.01) / largest).pow(number(1.0 / order)),
    );
    (h0 * 100.0).min(h1).min(longest)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math;

    const CONTROL: Control = Control {
        order: 5.0,
        proportional: 0.2,
        integral: 0.0,
        shrink: 0.2,
        grow: 10.0,
    };

    #[test]
    fn scale_is_absolute_plus_relative_of_the_larger() {
        let tolerance = Tolerance {
            relative: [0.5],
            absolute: [1.0],
        };
        assert_eq!(tolerance.scale(&[-4.0], &[2.0]), [3.0]);
    }

    #[test]
    fn errors_of_three_and_four_make_a_mean_square_of_12_5() {
        assert_eq!(mean_square(&[3.0, 4.0], &[1.0, 1.0]), 12.5);
    }

    #[test]
    fn error_32_times_too_large_halves_the_step_but_for_safety() {
        // 32^(-1/5) = 1/2
        assert!((CONTROL.factor_refused(math::ln(32.0)) - 0.45).abs() < 1e-9);
        assert!((CONTROL.factor_accepted(-math::ln(32.0), 0.0) - 1.8).abs() < 1e-9);
    }

    #[test]
    fn factor_stays_within_its_limits() {
        assert_eq!(CONTROL.factor_accepted(math::ln(0.0), 0.0), 10.0);
        assert_eq!(CONTROL.factor_refused(math::ln(1e300)), 0.2);
    }

    #[test]
    fn rough_functions_are_good_to_1e_minus_9() {
        for i in -400..400 {
            let x = 0.1 * f64::from(i);
            assert!((rough_exp(x) / math::exp(x) - 1.0).abs() < 1e-9, "{x}");
            assert!((rough_ln(math::exp(x)) - x).abs() < 1e-9, "{x}");
        }
        assert!(rough_ln(0.0) < -700.0 && rough_ln(f64::INFINITY) > 700.0);
        assert!(rough_exp(1e9) > 1e200 && rough_exp(-1e9) < 1e-200);
    }

    #[test]
    fn memory_ends_at_an_error_of_1e_minus_4() {
        assert_eq!(memory(math::ln(0.0)), math::ln(1e-4));
        assert_eq!(memory(math::ln(0.5)), math::ln(0.5));
    }

    #[test]
    fn first_step_of_exponential_growth() {
        // s = 0.01 + 0.01·1, d0 = d1 = d2 (for y' = y) = 50, h0 = 0.01, h1 = (0.01/50)^(1/4) = 0.1189
        let origin = Origin {
            t: 0.0,
            y: &[1.0],
            slope: &[1.0],
        };
        let tolerance = Tolerance {
            relative: [0.01; 1],
            absolute: [0.01],
        };
        let h = first_step(&mut |_, y: &[f64; 1]| *y, &origin, &tolerance, 4.0, 1e9);
        assert!((h - 0.118_920_711_5).abs() < 1e-9, "{h}");
        assert_eq!(
            first_step(&mut |_, y: &[f64; 1]| *y, &origin, &tolerance, 4.0, 0.05),
            0.05
        );
    }
}
