//! Dual numbers: a value and its derivatives with respect to `N` parameters, forward mode.
//!
//! ```text
//! f(a) = (f(a.value), f'(a.value) a.slope)
//! ```
//!
//! The value takes the same operations in the same order as `f64`, hence has the same bits; comparisons and table rows
//! go by the value alone.
//!
//! # References
//! - \[griewank-walther-2008\] chapter 3.

use super::{Scalar, Single};
use crate::math;
use core::ops::{Add, Div, Mul, Neg, Sub};
use nalgebra::SMatrix;

/// A number with its derivatives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dual<const N: usize> {
    /// The number.
    pub value: f64,
    /// Derivatives of the number.
    pub slope: [f64; N],
}

impl<const N: usize> Dual<N> {
    /// Parameter number `index`, whose derivative with respect to itself is one.
    #[inline]
    pub fn variable(value: f64, index: usize) -> Self {
        Self {
            value,
            slope: core::array::from_fn(|i| if i == index { 1.0 } else { 0.0 }),
        }
    }

    /// The function with this value and this derivative at `self`; nothing that moves gives nothing that moves.
    #[inline]
    fn chain(self, value: f64, rate: f64) -> Self {
        // At the end of a domain the rate is infinite, and zero times infinity would be NaN.
        let slope = self.slope.map(|s| if s == 0.0 { 0.0 } else { s * rate });
        Self { value, slope }
    }

    #[inline]
    fn with(self, value: f64, slope: impl Fn(usize) -> f64) -> Self {
        Self {
            value,
            slope: core::array::from_fn(slope),
        }
    }
}

impl<const N: usize> Neg for Dual<N> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        self.with(-self.value, |i| -self.slope[i])
    }
}

impl<const N: usize> Add for Dual<N> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        self.with(self.value + other.value, |i| self.slope[i] + other.slope[i])
    }
}

impl<const N: usize> Sub for Dual<N> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        self.with(self.value - other.value, |i| self.slope[i] - other.slope[i])
    }
}

impl<const N: usize> Mul for Dual<N> {
    type Output = Self;
    #[inline]
    #[expect(clippy::suspicious_arithmetic_impl, reason = "the product rule")]
    fn mul(self, other: Self) -> Self {
        self.with(self.value * other.value, |i| {
            self.slope[i] * other.value + self.value * other.slope[i]
        })
    }
}

impl<const N: usize> Div for Dual<N> {
    type Output = Self;
    #[inline]
    #[expect(clippy::suspicious_arithmetic_impl, reason = "the quotient rule")]
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        self.with(value, |i| {
            (self.slope[i] - value * other.slope[i]) / other.value
        })
    }
}

impl<const N: usize> Add<f64> for Dual<N> {
    type Output = Self;
    #[inline]
    fn add(self, other: f64) -> Self {
        self.with(self.value + other, |i| self.slope[i])
    }
}

impl<const N: usize> Sub<f64> for Dual<N> {
    type Output = Self;
    #[inline]
    fn sub(self, other: f64) -> Self {
        self.with(self.value - other, |i| self.slope[i])
    }
}

impl<const N: usize> Mul<f64> for Dual<N> {
    type Output = Self;
    #[inline]
    fn mul(self, other: f64) -> Self {
        self.with(self.value * other, |i| self.slope[i] * other)
    }
}

impl<const N: usize> Div<f64> for Dual<N> {
    type Output = Self;
    #[inline]
    fn div(self, other: f64) -> Self {
        self.with(self.value / other, |i| self.slope[i] / other)
    }
}

impl<const N: usize> Scalar for Dual<N> {
    type Mask = bool;
    type Value = f64;
    type Lane = Self;

    const LANES: usize = 1;

    #[inline]
    fn constant(value: f64) -> Self {
        Self {
            value,
            slope: [0.0; N],
        }
    }
    #[inline]
    fn value(self) -> f64 {
        self.value
    }
    #[inline]
    fn from_value(value: f64) -> Self {
        Self::constant(value)
    }
    #[inline]
    fn lane(self, _lane: usize) -> Self {
        self
    }
    #[inline]
    fn set_lane(&mut self, _lane: usize, number: Self) {
        *self = number;
    }
    #[inline(always)]
    fn map_value(self, f: impl Fn(f64) -> f64) -> f64 {
        f(self.value)
    }
    #[inline]
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.chain(root, 0.5 / root)
    }
    #[inline]
    fn exp(self) -> Self {
        let value = math::exp(self.value);
        self.chain(value, value)
    }
    #[inline]
    fn ln(self) -> Self {
        self.chain(math::ln(self.value), 1.0 / self.value)
    }
    #[inline]
    fn sin(self) -> Self {
        self.chain(math::sin(self.value), math::cos(self.value))
    }
    #[inline]
    fn cos(self) -> Self {
        self.chain(math::cos(self.value), -math::sin(self.value))
    }
    #[inline]
    fn atan2(self, x: Self) -> Self {
        let (y, x) = (self, x);
        let square = x.value * x.value + y.value * y.value;
        let value = math::atan2(y.value, x.value);
        if square == 0.0 {
            return Self::constant(value);
        }
        self.with(value, |i| {
            (x.value * y.slope[i] - y.value * x.slope[i]) / square
        })
    }
    #[inline]
    fn pow(self, exponent: Self) -> Self {
        let value = math::pow(self.value, exponent.value);
        let of_base = exponent.value * math::pow(self.value, exponent.value - 1.0);
        let of_exponent = value * math::ln(self.value);
        let (base, exponent) = (
            self.chain(value, of_base),
            exponent.chain(value, of_exponent),
        );
        self.with(value, |i| base.slope[i] + exponent.slope[i])
    }
    #[inline]
    fn less(self, other: Self) -> bool {
        self.value < other.value
    }
    #[inline]
    fn select(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }
    #[inline]
    fn lookup<const K: usize>(self, row: impl Fn(f64) -> [f64; K]) -> [Self; K] {
        row(self.value).map(Self::constant)
    }
    #[inline]
    fn lookup_pair<const K: usize>(
        self,
        other: Self,
        row: impl Fn(f64, f64) -> [f64; K],
    ) -> [Self; K] {
        row(self.value, other.value).map(Self::constant)
    }
    #[inline]
    fn gather<const K: usize>(self, rows: &[[f64; K]]) -> [Self; K] {
        self.value.gather(rows).map(Self::constant)
    }
}

impl<const N: usize> Single for Dual<N> {
    #[inline]
    fn root(at: f64, residual: impl FnOnce() -> Self, rate: impl FnOnce() -> f64) -> Self {
        residual().chain(at, -1.0 / rate())
    }
    fn implicit(at: f64, f: impl Fn(Self) -> Self) -> Self {
        let residual = f(Self::constant(at));
        let Some(index) = residual.slope.iter().position(|slope| *slope != 0.0) else {
            return Self::constant(at);
        };
        // one more where the place itself moves with that parameter
        let moved = f(Self::variable(at, index));
        let rate = moved.slope[index] - residual.slope[index];
        residual.chain(at, -1.0 / rate)
    }
    fn roots<const K: usize>(
        at: [f64; K],
        residual: impl FnOnce() -> [Self; K],
        rates: impl FnOnce() -> [[f64; K]; K],
    ) -> [Self; K] {
        let (rates, residual) = (rates(), residual());
        let rates = SMatrix::<f64, K, K>::from_fn(|i, j| rates[i][j]);
        let slopes = SMatrix::<f64, K, N>::from_fn(|i, j| residual[i].slope[j]);
        let inverse = rates.try_inverse();
        // without an inverse nothing tells how the roots move
        let moved = inverse.map(|inverse| inverse * -slopes);
        core::array::from_fn(|i| Self {
            value: at[i],
            slope: core::array::from_fn(|j| moved.map_or(f64::NAN, |moved| moved[(i, j)])),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every function of the trait once, of two numbers.
    fn mixture<S: Scalar>(x: S, y: S) -> S {
        let rows = [[0.5, 2.0], [1.5, 3.0]];
        let [base, slope] = x.gather(&rows);
        let [other] = x.lookup_pair(y, |x, y| [x + y]);
        (x * y + x / y - y).abs().sqrt() * (x * 0.3 - 0.1).exp()
            + (y + 2.0).ln() / 3.0
            + x.sin() * y.cos()
            + y.atan2(x)
            + x.pow(y)
            + (base + slope * x).min(y * 9.0)
            + (x - y).abs().max(-x)
            + S::select(x.less(y), x * other, y)
    }

    #[test]
    fn value_has_the_bits_of_a_plain_number() {
        for i in 0..200 {
            let (x, y) = (0.31 + 0.007 * f64::from(i), 1.21 + 0.003 * f64::from(i));
            let dual = mixture(Dual::<2>::variable(x, 0), Dual::variable(y, 1));
            assert_eq!(dual.value.to_bits(), mixture(x, y).to_bits());
        }
    }

    #[test]
    fn derivatives_are_those_of_central_differences() {
        for i in 0..50 {
            // The rows change at 0.5, the order of x and y at none of these.
            let (x, y) = (0.51 + 0.013 * f64::from(i), 1.21 + 0.003 * f64::from(i));
            let dual = mixture(Dual::<2>::variable(x, 0), Dual::variable(y, 1));
            let h = 1e-6;
            // The row of lookup_pair is a constant to derivatives: its product with x is put back.
            let by_x = (mixture(x + h, y) - mixture(x - h, y)) / (2.0 * h) - x;
            let by_y = (mixture(x, y + h) - mixture(x, y - h)) / (2.0 * h) - x;
            for (slope, difference) in dual.slope.iter().zip([by_x, by_y]) {
                let error = (slope - difference).abs() / (1.0 + difference.abs());
                // The square root is taken near its end, where differences are worst.
                assert!(error < 1e-7, "{i}: {dual:?} {difference}");
            }
        }
    }

    #[test]
    fn root_of_a_constant_at_zero_does_not_move() {
        let zero = Dual::<1>::constant(0.0).sqrt();
        assert_eq!(zero, Dual::constant(0.0));
        let [x, y] = [0.0, -1.0].map(Dual::<1>::constant);
        assert_eq!(x.atan2(y), Dual::constant(math::PI));
    }

    #[test]
    fn time_to_fall_moves_by_that_of_the_height_over_the_speed() {
        // h − 5 t² = 0: t = √(h/5), dt/dh = 1/(10 t); at h = 20 m t = 2 s, rate −20 m/s.
        let h = Dual::<1>::variable(20.0, 0);
        let residual = h - 5.0 * 2.0 * 2.0;
        assert_eq!(
            Single::root(2.0, || residual, || -20.0),
            Dual {
                value: 2.0,
                slope: [0.05]
            }
        );
        let root: f64 = Single::root(2.0, || 0.0, || -20.0);
        assert_eq!(root, 2.0);
    }
}
