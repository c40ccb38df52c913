//! One small trait over which physics is written once: plain numbers now, SIMD lanes and dual numbers later.
//!
//! Branches are written with [`Scalar::select`], tables with [`Scalar::lookup`] (the row is chosen by the value, the
//! polynomial is then evaluated in `Self`, so that derivatives and lanes flow through).

use crate::math;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// A real number as physics sees it.
pub trait Scalar:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + Add<f64, Output = Self>
    + Sub<f64, Output = Self>
    + Mul<f64, Output = Self>
    + Div<f64, Output = Self>
{
    /// The outcome of a comparison: one truth value a lane.
    type Mask: Copy;

    /// The constant `value`.
    fn constant(value: f64) -> Self;
    /// Square root.
    fn sqrt(self) -> Self;
    /// Exponential function.
    fn exp(self) -> Self;
    /// Natural logarithm.
    fn ln(self) -> Self;
    /// Sine, rad.
    fn sin(self) -> Self;
    /// Cosine, rad.
    fn cos(self) -> Self;
    /// Angle of the point (`x`, `self`), rad.
    fn atan2(self, x: Self) -> Self;
    /// `self` to the power `exponent`.
    fn pow(self, exponent: Self) -> Self;
    /// Whether `self` is below `other`.
    fn less(self, other: Self) -> Self::Mask;
    /// `yes` where `mask` holds, `no` elsewhere.
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;
    /// The row of a table that belongs to the value of `self`.
    fn lookup<const K: usize>(self, row: impl Fn(f64) -> [f64; K]) -> [Self; K];

    /// Whether `mask` holds in every lane: a shortcut past work whose outcome is not selected. `false` is always safe.
    #[inline]
    fn all(_mask: Self::Mask) -> bool {
        false
    }

    /// The smaller of two numbers.
    #[inline]
    fn min(self, other: Self) -> Self {
        Self::select(self.less(other), self, other)
    }

    /// The larger of two numbers.
    #[inline]
    fn max(self, other: Self) -> Self {
        Self::select(self.less(other), other, self)
    }
}

impl Scalar for f64 {
    type Mask = bool;

    #[inline]
    fn constant(value: f64) -> Self {
        value
    }
    #[inline]
    fn sqrt(self) -> Self {
        f64::sqrt(self)
    }
    #[inline]
    fn exp(self) -> Self {
        math::exp(self)
    }
    #[inline]
    fn ln(self) -> Self {
        math::ln(self)
    }
    #[inline]
    fn sin(self) -> Self {
        math::sin(self)
    }
    #[inline]
    fn cos(self) -> Self {
        math::cos(self)
    }
    #[inline]
    fn atan2(self, x: Self) -> Self {
        math::atan2(self, x)
    }
    #[inline]
    fn pow(self, exponent: Self) -> Self {
        math::pow(self, exponent)
    }
    #[inline]
    fn less(self, other: Self) -> bool {
        self < other
    }
    #[inline]
    fn select(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }
    #[inline]
    fn all(mask: bool) -> bool {
        mask
    }
    #[inline]
    fn lookup<const K: usize>(self, row: impl Fn(f64) -> [f64; K]) -> [Self; K] {
        row(self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn clamp_above_two<S: Scalar>(x: S) -> S {
        x.min(S::constant(2.0))
    }

    #[test]
    fn select_takes_the_smaller() {
        assert_eq!(clamp_above_two(3.0), 2.0);
        assert_eq!(clamp_above_two(1.0), 1.0);
    }
}
