//! One small trait over which physics is written once: plain numbers, [`Dual`] numbers with their derivatives, and
//! [`Lanes`] of several numbers at a time.
//!
//! Branches are written with [`Scalar::select`], tables with [`Scalar::lookup`] or [`Scalar::gather`] (the row is
//! chosen by the value, the polynomial is then evaluated in `Self`, so that derivatives and lanes are carried through).
//!
//! ```
//! use numerics::scalar::{Dual, Lanes, Scalar};
//!
//! fn cube<S: Scalar>(x: S) -> S {
//!     x * x * x
//! }
//! assert_eq!(cube(2.0), 8.0);
//! assert_eq!(cube(Lanes([2.0, 3.0])), Lanes([8.0, 27.0]));
//! // dx³/dx = 3 x²
//! assert_eq!(cube(Dual::variable(2.0, 0)), Dual { value: 8.0, slope: [12.0] });
//! ```

mod dual;
pub mod functions;
mod lanes;

use crate::math;
use core::fmt::Debug;
use core::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};
pub use dual::Dual;
pub use lanes::{Lanes, LanesMask};
use num_traits::Zero;

/// The operations of a number that vectors of it need besides: in place, and its zero.
macro_rules! in_place {
    ($number:ident) => {
        impl<const N: usize> core::ops::AddAssign for $number<N> {
            #[inline(always)]
            fn add_assign(&mut self, other: Self) {
                *self = *self + other;
            }
        }

        impl<const N: usize> core::ops::SubAssign for $number<N> {
            #[inline(always)]
            fn sub_assign(&mut self, other: Self) {
                *self = *self - other;
            }
        }

        impl<const N: usize> core::ops::MulAssign for $number<N> {
            #[inline(always)]
            fn mul_assign(&mut self, other: Self) {
                *self = *self * other;
            }
        }

        impl<const N: usize> num_traits::Zero for $number<N> {
            #[inline(always)]
            fn zero() -> Self {
                Self::constant(0.0)
            }

            #[inline]
            fn is_zero(&self) -> bool {
                *self == Self::zero()
            }
        }
    };
}

in_place!(Dual);
in_place!(Lanes);

/// Added to a number between 0 and 2³¹, leaves the nearest whole number in the low bits.
const WHOLE: f64 = 4_503_599_627_370_496.0;

/// A real number as physics sees it.
pub trait Scalar:
    Copy
    + nalgebra::Scalar
    + Zero
    + AddAssign
    + SubAssign
    + MulAssign
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
    /// Outcome of a comparison: one truth value per lane.
    type Mask: Mask;
    /// The number without its derivatives.
    type Value: Scalar<Mask = Self::Mask, Value = Self::Value, Lane = f64>;
    /// The number of one lane.
    type Lane: Single;

    /// Number of lanes.
    const LANES: usize;

    /// The constant `value`.
    fn constant(value: f64) -> Self;
    /// The number without its derivatives.
    fn value(self) -> Self::Value;
    /// A number whose derivatives are zero.
    fn from_value(value: Self::Value) -> Self;
    /// The number of one lane, the last where there are fewer.
    fn lane(self, lane: usize) -> Self::Lane;
    /// Replaces the number of one lane.
    fn set_lane(&mut self, lane: usize, number: Self::Lane);
    /// A function of the value in each lane.
    fn map_value(self, f: impl Fn(f64) -> f64) -> Self::Value;
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
    /// The row of a table that belongs to the values of `self` and `other`.
    fn lookup_pair<const K: usize>(
        self,
        other: Self,
        row: impl Fn(f64, f64) -> [f64; K],
    ) -> [Self; K];
    /// The row whose number is nearest to the value of `self`, 0 or above; zeros beyond the last.
    fn gather<const K: usize>(self, rows: &[[f64; K]]) -> [Self; K];

    /// The absolute value.
    #[inline]
    fn abs(self) -> Self {
        Self::select(self.less(Self::constant(0.0)), -self, self)
    }

    /// The smaller of two numbers, `other` where they are equal.
    ///
    /// If one of them is NaN, it is `other`, unlike `f64::min`, which gives the one that is a number.
    #[inline]
    fn min(self, other: Self) -> Self {
        Self::select(self.less(other), self, other)
    }

    /// The larger of two numbers, `self` where they are equal.
    ///
    /// If one of them is NaN, it is `self`, unlike `f64::max`, which gives the one that is a number.
    #[inline]
    fn max(self, other: Self) -> Self {
        Self::select(self.less(other), other, self)
    }

    /// The number held between `least` and `largest`, which are in order; a NaN stays one, as with `f64::clamp`.
    #[inline]
    fn clamp(self, least: Self, largest: Self) -> Self {
        let held = Self::select(largest.less(self), largest, self);
        Self::select(self.less(least), least, held)
    }

    /// Lanes in which the value is finite, neither infinite nor NaN.
    #[inline]
    fn finite(self) -> Self::Mask {
        self.abs().less(Self::constant(f64::INFINITY))
    }
}

/// A number of one lane, whose value may steer the program.
pub trait Single:
    Scalar<Mask = bool, Value = f64, Lane = Self> + PartialEq + Send + Sync + 'static
{
    /// The root at `at` of a function that has there the value `residual`, zero but for its derivatives, and the rate
    /// of change `rate`; both are called only where there are derivatives.
    ///
    /// ```text
    /// g(t, p) = 0  →  dt/dp = −(∂g/∂p) / (∂g/∂t)
    /// ```
    fn root(at: f64, residual: impl FnOnce() -> Self, rate: impl FnOnce() -> f64) -> Self;

    /// The place near `at` at which `f` equals its value there without derivatives: a root that was found by value. `f`
    /// is called only where there are derivatives, on the branch that it takes at `at`.
    fn implicit(at: f64, f: impl Fn(Self) -> Self) -> Self;

    /// The roots of as many equations as unknowns: `rates` has a row for each equation, a column for each unknown.
    fn roots<const K: usize>(
        at: [f64; K],
        residual: impl FnOnce() -> [Self; K],
        rates: impl FnOnce() -> [[f64; K]; K],
    ) -> [Self; K];
}

/// Outcome of a comparison: one truth value per lane.
pub trait Mask: Copy + Debug {
    /// Equal truth values in every lane.
    fn constant(holds: bool) -> Self;
    /// Lanes in which both hold.
    fn and(self, other: Self) -> Self;
    /// Lanes in which one of them holds, or both.
    fn or(self, other: Self) -> Self;
    /// Lanes in which it does not hold.
    fn not(self) -> Self;
    /// Whether it holds in some lane.
    fn any(self) -> bool;
    /// Whether it holds in every lane.
    fn all(self) -> bool;
    /// Whether it holds in a lane.
    fn lane(self, lane: usize) -> bool;
    /// Replaces the truth value of one lane.
    fn set_lane(&mut self, lane: usize, holds: bool);
}

impl Mask for bool {
    #[inline]
    fn constant(holds: bool) -> Self {
        holds
    }
    #[inline]
    fn and(self, other: Self) -> Self {
        self && other
    }
    #[inline]
    fn or(self, other: Self) -> Self {
        self || other
    }
    #[inline]
    fn not(self) -> Self {
        !self
    }
    #[inline]
    fn any(self) -> bool {
        self
    }
    #[inline]
    fn all(self) -> bool {
        self
    }
    #[inline]
    fn lane(self, _lane: usize) -> bool {
        self
    }
    #[inline]
    fn set_lane(&mut self, _lane: usize, holds: bool) {
        *self = holds;
    }
}

/// Number of the row nearest to `x`, 0 or above.
#[inline]
fn row_number(x: f64) -> usize {
    ((x + WHOLE).to_bits() & 0x7fff_ffff) as usize
}

impl Scalar for f64 {
    type Mask = bool;
    type Value = f64;
    type Lane = f64;

    const LANES: usize = 1;

    #[inline]
    fn constant(value: f64) -> Self {
        value
    }
    #[inline]
    fn value(self) -> f64 {
        self
    }
    #[inline]
    fn from_value(value: f64) -> Self {
        value
    }
    #[inline]
    fn lane(self, _lane: usize) -> f64 {
        self
    }
    #[inline]
    fn set_lane(&mut self, _lane: usize, number: f64) {
        *self = number;
    }
    #[inline(always)]
    fn map_value(self, f: impl Fn(f64) -> f64) -> f64 {
        f(self)
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
    fn lookup<const K: usize>(self, row: impl Fn(f64) -> [f64; K]) -> [Self; K] {
        row(self)
    }
    #[inline]
    fn lookup_pair<const K: usize>(
        self,
        other: Self,
        row: impl Fn(f64, f64) -> [f64; K],
    ) -> [Self; K] {
        row(self, other)
    }
    #[inline]
    fn gather<const K: usize>(self, rows: &[[f64; K]]) -> [Self; K] {
        rows.get(row_number(self)).copied().unwrap_or([0.0; K])
    }
    #[inline]
    fn abs(self) -> Self {
        f64::abs(self)
    }
}

impl Single for f64 {
    #[inline]
    fn root(at: f64, _residual: impl FnOnce() -> f64, _rate: impl FnOnce() -> f64) -> f64 {
        at
    }
    #[inline]
    fn implicit(at: f64, _f: impl Fn(f64) -> f64) -> f64 {
        at
    }
    #[inline]
    fn roots<const K: usize>(
        at: [f64; K],
        _residual: impl FnOnce() -> [f64; K],
        _rates: impl FnOnce() -> [[f64; K]; K],
    ) -> [f64; K] {
        at
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
        assert_eq!(clamp_above_two(Lanes([3.0, 1.0])), Lanes([2.0, 1.0]));
    }

    #[test]
    fn row_is_the_nearest_and_zero_beyond_the_last() {
        let rows = [[10.0], [20.0], [30.0]];
        let found = [0.0, 0.4, 0.6, 1.9, 2.4].map(|x: f64| x.gather(&rows)[0]);
        assert_eq!(found, [10.0, 10.0, 20.0, 30.0, 30.0]);
        assert_eq!(7.0.gather(&rows), [0.0]);
        // A NaN takes the first row and stays NaN in results of both.
        assert_eq!(f64::NAN.gather(&rows), [10.0]);
    }

    #[test]
    fn masks_of_one_lane_are_truth_values() {
        let (yes, no) = (
            <bool as Mask>::constant(true),
            <bool as Mask>::constant(false),
        );
        assert_eq!(
            (yes.and(no), yes.or(no), Mask::not(yes)),
            (false, true, false)
        );
        assert!(yes.any() && yes.all() && yes.lane(0) && !no.any());
    }

    #[test]
    fn of_nan_and_a_number_the_larger_is_the_first_and_the_smaller_the_second() {
        fn both<S: Scalar>(x: S, y: S) -> [S; 2] {
            [x.max(y), x.min(y)]
        }
        let [largest, least] = both(f64::NAN, 1.0);
        assert!(largest.is_nan() && least == 1.0);
        let [largest, least] = both(1.0, f64::NAN);
        assert!(largest == 1.0 && least.is_nan());
    }

    #[test]
    fn clamped_numbers_are_those_of_plain_ones_and_nan_stays_nan() {
        fn held<S: Scalar>(x: S) -> S {
            x.clamp(S::constant(1.0), S::constant(2.0))
        }
        let numbers = [0.5, 1.0, 1.5, 2.0, f64::INFINITY, f64::NAN];
        let expected = numbers.map(|x| f64::clamp(x, 1.0, 2.0).to_bits());
        assert_eq!(numbers.map(|x| held(x).to_bits()), expected);
        assert_eq!(held(Lanes(numbers)).0.map(f64::to_bits), expected);
        // inside it moves, outside it does not
        let slopes = numbers.map(|x| held(Dual::<1>::variable(x, 0)).slope[0]);
        assert_eq!(slopes, [0.0, 1.0, 1.0, 1.0, 0.0, 1.0]);
    }

    #[test]
    fn finite_is_neither_infinite_nor_nothing() {
        assert_eq!(
            [1.0, f64::NEG_INFINITY, f64::NAN].map(Scalar::finite),
            [true, false, false]
        );
    }
}
