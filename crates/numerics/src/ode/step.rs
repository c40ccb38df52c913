//! A step that was taken, and the state within it.
//!
//! ```text
//! y(θ) = r₀ + θ (r₁ + (1-θ) (r₂ + θ (r₃ + (1-θ) (r₄ + θ (r₅ + (1-θ) (r₆ + θ r₇))))))     θ = (t - t₀) / (t₁ - t₀)
//! r₀ = y₀    r₁ = y₁ - y₀    r₂ = h y'₀ - r₁    r₃ = r₁ - h y'₁ - r₂
//! ```
//!
//! r₀ to r₃ alone are the cubic Hermite polynomial; r₄ raises the order to 4 and r₄ to r₇ raise it to 7.
//!
//! # References
//! - \[hairer-norsett-wanner-1993\] section II.6.

use crate::scalar::{Scalar, Single};

/// r₁ to r₄.
const ROWS: usize = 4;
/// r₅ to r₇.
const MORE: usize = 3;

/// A step that was taken, with its dense output.
#[derive(Clone, Debug, PartialEq)]
pub struct Step<const N: usize, S = f64> {
    /// Beginning of the step.
    pub t0: S,
    /// End of the step.
    pub t1: S,
    /// State at the beginning.
    pub y0: [S; N],
    /// State at the end.
    pub y1: [S; N],
    /// r₁ to r₄.
    rows: [[S; N]; ROWS],
    /// r₅ to r₇, of the method of order 8 alone: apart, so that steps of the others stay small.
    more: Option<Box<[[S; N]; MORE]>>,
    /// End of the step to which the rows belong: later than `t1` where the step was cut.
    whole: S,
}

/// The two ends of a step with their slopes.
pub(super) struct Ends<'a, const N: usize, S> {
    pub t: [S; 2],
    pub y: [&'a [S; N]; 2],
    pub slope: [&'a [S; N]; 2],
}

impl<const N: usize, S: Scalar> Step<N, S> {
    /// A step of no length.
    pub(super) fn none(t: S, y: [S; N]) -> Self {
        Self {
            t0: t,
            t1: t,
            y0: y,
            y1: y,
            rows: [[S::constant(0.0); N]; ROWS],
            more: None,
            whole: t,
        }
    }

    /// Becomes the step between `ends`: its cubic polynomial, corrected by r₄.
    #[inline]
    pub(super) fn set(&mut self, ends: &Ends<N, S>, correction: &[S; N]) {
        let h = ends.t[1] - ends.t[0];
        let ([y0, y1], [slope0, slope1]) = (ends.y, ends.slope);
        for i in 0..N {
            let rise = y1[i] - y0[i];
            let bend = h * slope0[i] - rise;
            self.rows[0][i] = rise;
            self.rows[1][i] = bend;
            self.rows[2][i] = rise - h * slope1[i] - bend;
            self.rows[3][i] = correction[i];
        }
        [self.t0, self.t1] = ends.t;
        (self.y0, self.y1) = (*y0, *y1);
        self.more = None;
        self.whole = self.t1;
    }

    /// Adds r₅ to r₇.
    pub(super) fn set_more(&mut self, more: [[S; N]; MORE]) {
        self.more = Some(Box::new(more));
    }

    /// Ends the step at a later instant, with a straight line in place of the dense output.
    #[inline]
    pub fn draw_out(&mut self, t1: S, y1: [S; N]) {
        self.rows = [[S::constant(0.0); N]; ROWS];
        for (i, rise) in self.rows[0].iter_mut().enumerate() {
            *rise = y1[i] - self.y0[i];
        }
        (self.t1, self.y1, self.whole, self.more) = (t1, y1, t1, None);
    }

    /// End of the step of one lane, and the state there.
    #[inline]
    pub fn end_of_lane(&self, lane: usize) -> (S::Lane, [S::Lane; N]) {
        (self.t1.lane(lane), of_lane(&self.y1, lane))
    }

    /// The step of one lane.
    #[inline]
    pub fn lane(&self, lane: usize) -> Step<N, S::Lane> {
        let mut rows = [[S::Lane::constant(0.0); N]; ROWS];
        for (row, all) in rows.iter_mut().zip(&self.rows) {
            *row = of_lane(all, lane);
        }
        let more = (self.more.as_ref()).map(|more| {
            let mut rows = [[S::Lane::constant(0.0); N]; MORE];
            for (row, all) in rows.iter_mut().zip(more.iter()) {
                *row = of_lane(all, lane);
            }
            Box::new(rows)
        });
        Step {
            t0: self.t0.lane(lane),
            t1: self.t1.lane(lane),
            y0: of_lane(&self.y0, lane),
            y1: of_lane(&self.y1, lane),
            rows,
            more,
            whole: self.whole.lane(lane),
        }
    }

    #[inline]
    fn interpolated(&self, i: usize, theta: S) -> S {
        let rest = S::constant(1.0) - theta;
        let mut sum = S::constant(0.0);
        if let Some(more) = &self.more {
            let [r5, r6, r7] = &**more;
            sum = (r7[i] * theta + r6[i]) * rest;
            sum = (sum + r5[i]) * theta;
        }
        let [r1, r2, r3, r4] = &self.rows;
        sum = (sum + r4[i]) * rest;
        sum = (sum + r3[i]) * theta;
        sum = (sum + r2[i]) * rest;
        sum = (sum + r1[i]) * theta;
        self.y0[i] + sum
    }

    /// The part of the step that is over at `t`.
    #[inline]
    fn part(&self, t: S) -> S {
        (t - self.t0) / (self.whole - self.t0)
    }
}

/// The numbers of one lane.
#[inline]
pub(super) fn of_lane<const N: usize, S: Scalar>(all: &[S; N], lane: usize) -> [S::Lane; N] {
    let mut one = [S::Lane::constant(0.0); N];
    for (one, all) in one.iter_mut().zip(all) {
        *one = all.lane(lane);
    }
    one
}

impl<const N: usize, S: Single> Step<N, S> {
    /// State at `t`, between [`Step::t0`] and [`Step::t1`]; exactly `y0` and `y1` there.
    #[inline]
    pub fn at(&self, t: S) -> [S; N] {
        if t == self.t1 {
            return self.y1;
        }
        let theta = self.part(t);
        let mut y = self.y0;
        for (i, y) in y.iter_mut().enumerate() {
            *y = self.interpolated(i, theta);
        }
        y
    }

    /// The instant `t` of the step; its ends move with their derivatives, what is within stays.
    #[inline]
    pub fn time(&self, t: f64) -> S {
        if t == self.t1.value() {
            self.t1
        } else if t == self.t0.value() {
            self.t0
        } else {
            S::constant(t)
        }
    }

    /// Component `i` of the state at `t`; not a number where there is no such component.
    #[inline]
    pub fn component(&self, i: usize, t: S) -> S {
        match self.y1.get(i) {
            None => S::constant(f64::NAN),
            Some(&y1) if t == self.t1 => y1,
            Some(_) => self.interpolated(i, self.part(t)),
        }
    }

    /// This step, ended at `t` within it.
    #[inline]
    pub fn cut(mut self, t: S) -> Self {
        self.y1 = self.at(t);
        self.t1 = t;
        self
    }
}

#[cfg(test)]
impl<const N: usize, S: Scalar> Step<N, S> {
    /// The step between `ends`.
    pub(super) fn new(ends: &Ends<N, S>, correction: &[S; N]) -> Self {
        let mut step = Self::none(ends.t[0], *ends.y[0]);
        step.set(ends, correction);
        step
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// y = t³ on 1…3: y' = 3 t² is 3 and 27.
    fn cube() -> Step<1> {
        let ends = Ends {
            t: [1.0, 3.0],
            y: [&[1.0], &[27.0]],
            slope: [&[3.0], &[27.0]],
        };
        Step::new(&ends, &[0.0])
    }

    #[test]
    fn hermite_polynomial_of_a_cube_is_the_cube() {
        assert_eq!(cube().at(2.0), [8.0]);
        assert_eq!(cube().component(0, 1.5), 3.375);
        assert_eq!(cube().at(1.0), [1.0]);
        assert_eq!(cube().at(3.0), [27.0]);
    }

    #[test]
    fn first_correction_adds_theta_squared_times_one_minus_theta_squared() {
        let ends = Ends {
            t: [0.0, 1.0],
            y: [&[0.0], &[0.0]],
            slope: [&[0.0], &[0.0]],
        };
        // 16 · (1/4)² (3/4)² = 9/16
        assert_eq!(Step::new(&ends, &[16.0]).at(0.25), [0.5625]);
    }

    #[test]
    fn step_that_is_cut_keeps_its_polynomial() {
        let cut = cube().cut(2.0);
        assert_eq!((cut.t1, cut.y1), (2.0, [8.0]));
        assert_eq!((cut.at(1.5), cut.at(2.0)), ([3.375], [8.0]));
    }

    #[test]
    fn step_that_is_drawn_out_is_a_line() {
        let mut step = cube();
        step.draw_out(5.0, [9.0]);
        assert_eq!((step.at(3.0), step.at(5.0)), ([5.0], [9.0]));
    }

    #[test]
    fn step_of_a_lane_is_that_of_the_lane() {
        use crate::scalar::Lanes;
        let two = |x| Lanes([x, 2.0 * x]);
        let ends = Ends {
            t: [Lanes([1.0; 2]), Lanes([3.0; 2])],
            y: [&[two(1.0)], &[two(27.0)]],
            slope: [&[two(3.0)], &[two(27.0)]],
        };
        let step = Step::new(&ends, &[Lanes([0.0; 2])]);
        assert_eq!(step.lane(0), cube());
        assert_eq!(step.lane(1).at(2.0), [16.0]);
    }

    #[test]
    fn component_that_is_not_there_is_not_a_number() {
        assert!(cube().component(1, 2.0).is_nan());
    }
}
