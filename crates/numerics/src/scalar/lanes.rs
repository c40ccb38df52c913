//! Several numbers at a time, side by side, for vector instructions.
//!
//! Plain arrays: the compiler makes vector instructions of the loops. Each lane takes the same operations in the same order as
//! `f64`, none of them fused, hence has the same bits; elementary functions are called lane by lane.

use super::{Mask, Scalar, row_number};
use crate::math;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// `N` numbers side by side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lanes<const N: usize>(
    /// The numbers.
    pub [f64; N],
);

/// `N` truth values side by side, each all ones or all zeros.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LanesMask<const N: usize>([u64; N]);

impl<const N: usize> Lanes<N> {
    #[inline(always)]
    fn map(self, f: impl Fn(f64) -> f64) -> Self {
        let mut out = self.0;
        for x in &mut out {
            *x = f(*x);
        }
        Self(out)
    }

    #[inline(always)]
    fn zip(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        let mut out = self.0;
        for (x, y) in out.iter_mut().zip(other.0) {
            *x = f(*x, y);
        }
        Self(out)
    }
}

macro_rules! operators {
    ($($trait:ident $name:ident $operator:tt;)*) => {$(
        impl<const N: usize> $trait for Lanes<N> {
            type Output = Self;
            #[inline(always)]
            fn $name(self, other: Self) -> Self {
                self.zip(other, |a, b| a $operator b)
            }
        }

        impl<const N: usize> $trait<f64> for Lanes<N> {
            type Output = Self;
            #[inline(always)]
            fn $name(self, other: f64) -> Self {
                self.map(|a| a $operator other)
            }
        }
    )*};
}

operators! {
    Add add +;
    Sub sub -;
    Mul mul *;
    Div div /;
}

impl<const N: usize> Neg for Lanes<N> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.map(|a| -a)
    }
}

impl<const N: usize> Scalar for Lanes<N> {
    type Mask = LanesMask<N>;
    type Value = Self;
    type Lane = f64;

    const LANES: usize = N;

    #[inline(always)]
    fn constant(value: f64) -> Self {
        Self([value; N])
    }
    #[inline(always)]
    fn value(self) -> Self {
        self
    }
    #[inline(always)]
    fn from_value(value: Self) -> Self {
        value
    }
    #[inline(always)]
    fn lane(self, lane: usize) -> f64 {
        self.0[lane.min(N - 1)]
    }
    #[inline(always)]
    fn set_lane(&mut self, lane: usize, number: f64) {
        self.0[lane.min(N - 1)] = number;
    }
    #[inline(always)]
    fn map_value(self, f: impl Fn(f64) -> f64) -> Self {
        self.map(f)
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        self.map(f64::sqrt)
    }
    #[inline]
    fn exp(self) -> Self {
        self.map(math::exp)
    }
    #[inline]
    fn ln(self) -> Self {
        self.map(math::ln)
    }
    #[inline]
    fn sin(self) -> Self {
        self.map(math::sin)
    }
    #[inline]
    fn cos(self) -> Self {
        self.map(math::cos)
    }
    #[inline]
    fn atan2(self, x: Self) -> Self {
        self.zip(x, math::atan2)
    }
    #[inline]
    fn pow(self, exponent: Self) -> Self {
        self.zip(exponent, math::pow)
    }
    #[inline(always)]
    fn less(self, other: Self) -> LanesMask<N> {
        let mut mask = [0; N];
        for ((mask, a), b) in mask.iter_mut().zip(self.0).zip(other.0) {
            *mask = if a < b { u64::MAX } else { 0 };
        }
        LanesMask(mask)
    }
    #[inline(always)]
    fn select(mask: LanesMask<N>, yes: Self, no: Self) -> Self {
        let mut out = no.0;
        for ((out, yes), mask) in out.iter_mut().zip(yes.0).zip(mask.0) {
            *out = f64::from_bits((mask & yes.to_bits()) | (!mask & out.to_bits()));
        }
        Self(out)
    }
    #[inline]
    fn lookup<const K: usize>(self, row: impl Fn(f64) -> [f64; K]) -> [Self; K] {
        across(|lane| row(self.0[lane]))
    }
    #[inline]
    fn lookup_pair<const K: usize>(
        self,
        other: Self,
        row: impl Fn(f64, f64) -> [f64; K],
    ) -> [Self; K] {
        across(|lane| row(self.0[lane], other.0[lane]))
    }
    #[inline(always)]
    fn gather<const K: usize>(self, rows: &[[f64; K]]) -> [Self; K] {
        let number = self.0.map(row_number);
        across(|lane| rows.get(number[lane]).copied().unwrap_or([0.0; K]))
    }
    #[inline(always)]
    fn abs(self) -> Self {
        self.map(f64::abs)
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        self.zip(other, |a, b| if a < b { a } else { b })
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        self.zip(other, |a, b| if a < b { b } else { a })
    }
}

/// Rows of the lanes, transposed to lanes of the columns.
#[inline(always)]
fn across<const K: usize, const N: usize>(row: impl Fn(usize) -> [f64; K]) -> [Lanes<N>; K] {
    let mut columns = [Lanes([0.0; N]); K];
    for lane in 0..N {
        let row = row(lane);
        for (column, value) in columns.iter_mut().zip(row) {
            column.0[lane] = value;
        }
    }
    columns
}

impl<const N: usize> Mask for LanesMask<N> {
    #[inline(always)]
    fn constant(holds: bool) -> Self {
        Self([if holds { u64::MAX } else { 0 }; N])
    }
    #[inline(always)]
    fn and(mut self, other: Self) -> Self {
        for (a, b) in self.0.iter_mut().zip(other.0) {
            *a &= b;
        }
        self
    }
    #[inline(always)]
    fn or(mut self, other: Self) -> Self {
        for (a, b) in self.0.iter_mut().zip(other.0) {
            *a |= b;
        }
        self
    }
    #[inline(always)]
    fn not(mut self) -> Self {
        for a in &mut self.0 {
            *a = !*a;
        }
        self
    }
    #[inline(always)]
    fn any(self) -> bool {
        self.0.iter().fold(0, |any, a| any | a) != 0
    }
    #[inline(always)]
    fn all(self) -> bool {
        self.0.iter().fold(u64::MAX, |all, a| all & a) != 0
    }
    #[inline(always)]
    fn lane(self, lane: usize) -> bool {
        self.0[lane.min(N - 1)] != 0
    }
    #[inline(always)]
    fn set_lane(&mut self, lane: usize, holds: bool) {
        self.0[lane.min(N - 1)] = if holds { u64::MAX } else { 0 };
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every function of the trait once, of two numbers.
    fn mixture<S: Scalar>(x: S, y: S) -> [S; 4] {
        let rows = [[0.5, 2.0], [1.5, 3.0], [-1.0, 0.25]];
        let [base, slope] = x.gather(&rows);
        let [double, shifted] = x.lookup(|x| [2.0 * x, x + 0.1]);
        let [other] = x.lookup_pair(y, |x, y| [x - 3.0 * y]);
        let both = x.less(y).and(y.less(S::constant(1.4))).or(x.finite().not());
        [
            (x * y + x / y - y).abs().sqrt() * (x * 0.3 - 0.1).exp() + (y + 2.0).ln() / 3.0,
            x.sin() * y.cos() + y.atan2(-x) + x.pow(y),
            (base + slope * x).min(y * 9.0) + (x - y).max(double) * shifted,
            S::select(both, x * other, y),
        ]
    }

    #[test]
    fn each_lane_has_the_bits_of_a_plain_number() {
        for i in 0..100 {
            let x: [f64; 4] = core::array::from_fn(|lane| 0.02 * f64::from(i) + 0.1 * lane as f64);
            let y: [f64; 4] = core::array::from_fn(|lane| 1.7 - 0.013 * f64::from(i) * lane as f64);
            let lanes = mixture(Lanes(x), Lanes(y));
            for lane in 0..4 {
                let alone = mixture(x[lane], y[lane]);
                assert_eq!(
                    lanes.map(|s| s.lane(lane).to_bits()),
                    alone.map(f64::to_bits)
                );
            }
        }
    }

    #[test]
    fn lanes_are_replaced_one_at_a_time() {
        let mut x = Lanes([1.0, 2.0, 3.0]);
        x.set_lane(1, 9.0);
        assert_eq!(x, Lanes([1.0, 9.0, 3.0]));
        let mut mask = x.less(Lanes::constant(4.0));
        assert!(mask.any() && !mask.all() && mask.lane(0) && !mask.lane(1));
        mask.set_lane(1, true);
        assert!(mask.all() && !mask.not().any());
    }

    #[test]
    fn one_that_is_no_number_spoils_no_other() {
        let x = Lanes([f64::NAN, 4.0]).sqrt() * 2.0;
        assert!(x.lane(0).is_nan());
        assert_eq!(x.lane(1), 4.0);
        assert_eq!(x.finite(), Lanes([1.0, 0.0]).less(Lanes([0.0, 1.0])));
    }
}
