//! Events along a step: where a function of (t, y) crosses zero, and where it is largest.
//!
//! Only the dense output is used, no evaluation of the right-hand side. A crossing is found by the signs at the ends of
//! the step; where a function may cross twice within a step, [`crossing_sampled`] also evaluates it in between.
//!
//! Values alone decide where an event is; its derivatives follow from those of the function there:
//!
//! ```text
//! g(t, p) = 0  →  dt/dp = −(∂g/∂p) / (∂g/∂t)
//! ```

use super::Step;
use crate::root;
use crate::scalar::Single;

/// Width of the final bracket, as a fraction of the step.
const CROSSING_TOLERANCE: f64 = 1e-13;
/// Tolerance of the place of a maximum, which rounding limits to about its square root.
const MAXIMUM_TOLERANCE: f64 = 1e-9;
/// Distance at which the slope along a step is evaluated, as a fraction of the step.
const SLOPE_PART: f64 = 1e-2;
/// Corrections of the place of a maximum; each squares the error.
const CORRECTIONS: usize = 4;
/// Distance at which slope and curvature along a step are evaluated for a maximum, as a fraction of the step: rounding
/// needs a larger one, the step a smaller one.
const TOP_PART: f64 = 1e-2;
/// Last correction but one of the place of a maximum, as a fraction of the step; the error is about its square.
const TOP_TOLERANCE: f64 = 1e-4;
/// Tolerance of the place of any other maximum, as a fraction of the step.
const COARSE_TOLERANCE: f64 = 1e-6;
/// Tolerance as a part of t: a search by values resolves no finer.
const NEAR_TIME: f64 = 1e-6;
/// A maximum this close to the end of a step, as a fraction of the step, moves with the end.
const NEAR_END: f64 = 1e-4;

/// Direction in which zero is crossed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// From below zero to above.
    Rising,
    /// From above zero to below.
    Falling,
    /// Either direction.
    Either,
}

/// Time at which `g` crosses zero along `step`, by its signs at both ends; the value of `g` there is zero or has the
/// new sign.
///
/// A zero at the very beginning belongs to the step before, a zero at the end to this one. After a retake that ends at a
/// crossing, rounding may leave either sign there: what must happen only once is for the caller to remember.
pub fn crossing<const N: usize, S: Single>(
    step: &Step<N, S>,
    g: impl Fn(S, &[S; N]) -> S,
    direction: Direction,
) -> Option<S> {
    crossing_sampled(step, g, direction, 0)
}

/// The first crossing as in [`crossing`], looking also at `interior` points spread evenly within the step.
pub fn crossing_sampled<const N: usize, S: Single>(
    step: &Step<N, S>,
    g: impl Fn(S, &[S; N]) -> S,
    direction: Direction,
    interior: u32,
) -> Option<S> {
    let along = |t: S| g(t, &step.at(t));
    let ends = [step.t0.value(), step.t1.value()];
    let length = ends[1] - ends[0];
    let (mut t_before, mut g_before) = (ends[0], g(step.t0, &step.y0).value());
    for n in 1..=interior + 1 {
        let last = n == interior + 1;
        let t = if last {
            ends[1]
        } else {
            ends[0] + length * f64::from(n) / f64::from(interior + 1)
        };
        let g_here = along(step.time(t)).value();
        if crosses(g_before, g_here, direction) {
            return root_between(step, along, [t_before, t], CROSSING_TOLERANCE * length);
        }
        (t_before, g_before) = (t, g_here);
    }
    None
}

/// Time at which `g` crosses zero between two instants of `step`, at which its signs differ, within `tolerance`; the
/// value of `g` there is zero or has the sign of the later instant.
pub fn root_between<const N: usize, S: Single>(
    step: &Step<N, S>,
    g: impl Fn(S) -> S,
    [from, to]: [f64; 2],
    tolerance: f64,
) -> Option<S> {
    let values = |t: f64| g(step.time(t)).value();
    let [x, other] = root::bracket(values, from, to, tolerance)?;
    let at = x.max(other);
    let d = SLOPE_PART * (step.t1 - step.t0).value();
    let rate = || {
        let near = values(at + d) - values(at - d);
        (8.0 * near - (values(at + 2.0 * d) - values(at - 2.0 * d))) / (12.0 * d)
    };
    Some(S::root(at, || g(S::constant(at)), rate))
}

fn crosses(before: f64, here: f64, direction: Direction) -> bool {
    let rising = before < 0.0 && here >= 0.0;
    let falling = before > 0.0 && here <= 0.0;
    match direction {
        Direction::Rising => rising,
        Direction::Falling => falling,
        Direction::Either => rising || falling,
    }
}

/// Time at which `g` is largest along `step`, ends included, and its value there; of several maxima one is found.
pub fn maximum<const N: usize>(step: &Step<N>, g: impl Fn(f64, &[f64; N]) -> f64) -> (f64, f64) {
    let along = |t: f64| g(t, &step.at(t));
    root::maximum(
        along,
        step.t0,
        step.t1,
        MAXIMUM_TOLERANCE * (step.t1 - step.t0),
    )
}

/// Time at which `g` is largest along `step`, searched from the fraction `start` of the step: the zero of its slope
/// where that is within the step, else the largest value, ends included.
pub fn top<const N: usize, S: Single>(step: &Step<N, S>, g: impl Fn(S) -> S, start: f64) -> S {
    let (t0, t1) = (step.t0.value(), step.t1.value());
    let length = t1 - t0;
    if let Some(top) = level(step, &g, t0 + start * length) {
        return top;
    }
    let values = |t: f64| g(step.time(t)).value();
    let (t, _) = root::maximum(values, t0, t1, COARSE_TOLERANCE * length);
    let near = NEAR_END * length + NEAR_TIME * t1.abs();
    if t1 - t <= near {
        // A maximum at a jump that ends the step, or at its beginning, moves with that end.
        step.t1 + (t - t1)
    } else if t - t0 <= near {
        step.t0 + (t - t0)
    } else {
        level(step, &g, t).unwrap_or(step.time(t))
    }
}

/// Time within `step` at which the slope of `g` is zero and its curvature negative, searched from `t`.
///
/// ```text
/// t ← t − g'/g'',   g' = (g₁ − g₋₁)/(2d),   g'' = (g₁ − 2 g₀ + g₋₁)/d²
/// at last  g' = (8 (g₁ − g₋₁) − (g₂ − g₋₂))/(12d)
/// ```
fn level<const N: usize, S: Single>(
    step: &Step<N, S>,
    g: &impl Fn(S) -> S,
    mut t: f64,
) -> Option<S> {
    let (t0, t1) = (step.t0.value(), step.t1.value());
    let length = t1 - t0;
    let d = TOP_PART * length;
    let values = |t: f64| g(step.time(t)).value();
    for _ in 0..CORRECTIONS {
        let [before, here, after] = [t - d, t, t + d].map(values);
        let bend = after - 2.0 * here + before;
        let correction = -0.5 * d * (after - before) / bend;
        let next = t + correction;
        if !(bend < 0.0 && t0 <= next && next <= t1) {
            return None;
        }
        if correction.abs() > TOP_TOLERANCE * length {
            t = next;
            continue;
        }
        // The slope to order 4, so that the place does not depend on the length of the step.
        let [first, last] = [t - 2.0 * d, t + 2.0 * d].map(values);
        let plain = (8.0 * (after - before) - (last - first)) / (12.0 * d);
        let place = t - plain * (d * d) / bend;
        // The slope is zero there for every parameter: so the top moves with them.
        let slope = || {
            let g = |t: f64| g(S::constant(t));
            let near = g(t + d) - g(t - d);
            (near * 8.0 - (g(t + 2.0 * d) - g(t - 2.0 * d))) / (12.0 * d)
        };
        let rate = || (16.0 * (before + after) - (first + last) - 30.0 * here) / (12.0 * d * d);
        return Some(S::root(place, slope, rate));
    }
    None
}

#[cfg(test)]
mod tests {
    use super::super::step::Ends;
    use super::*;
    use crate::scalar::{Dual, Scalar};

    /// y = t² - t on 0…2: y' = 2 t - 1 is -1 and 3.
    fn parabola() -> Step<1> {
        Step::new(
            &Ends {
                t: [0.0, 2.0],
                y: [&[0.0], &[2.0]],
                slope: [&[-1.0], &[3.0]],
            },
            &[0.0],
        )
    }

    #[test]
    fn zero_at_the_beginning_belongs_to_the_step_before() {
        assert_eq!(crossing(&parabola(), |_, y| y[0], Direction::Either), None);
    }

    #[test]
    fn parabola_less_three_quarters_rises_through_zero_at_one_and_a_half() {
        let t = crossing(&parabola(), |_, y| y[0] - 0.75, Direction::Rising).unwrap();
        assert!((t - 1.5).abs() < 1e-12);
        assert_eq!(
            crossing(&parabola(), |_, y| y[0] - 0.75, Direction::Falling),
            None
        );
    }

    #[test]
    fn two_crossings_in_a_step_are_seen_with_interior_points() {
        // t² - t + 0.16 = 0 at 0.2 and 0.8
        let g = |_: f64, y: &[f64; 1]| y[0] + 0.16;
        assert_eq!(crossing(&parabola(), g, Direction::Either), None);
        let falling = crossing_sampled(&parabola(), g, Direction::Falling, 3).unwrap();
        let rising = crossing_sampled(&parabola(), g, Direction::Rising, 3).unwrap();
        assert!((falling - 0.2).abs() < 1e-12 && (rising - 0.8).abs() < 1e-12);
    }

    #[test]
    fn crossing_at_the_end_is_the_end() {
        assert_eq!(
            crossing(&parabola(), |_, y| y[0] - 2.0, Direction::Rising),
            Some(2.0)
        );
    }

    #[test]
    fn value_at_the_crossing_has_the_new_sign() {
        let step = parabola();
        for level in 1..20 {
            let g = |_: f64, y: &[f64; 1]| y[0] - 0.1 * f64::from(level);
            let t = crossing(&step, g, Direction::Rising).unwrap();
            assert!(g(t, &step.at(t)) >= 0.0);
        }
    }

    #[test]
    fn top_is_where_the_slope_vanishes_or_at_the_end() {
        let step = parabola();
        let t = top(&step, |t| -step.at(t)[0], 0.9);
        assert!((t - 0.5).abs() < 1e-12);
        // t² − t is largest at the end of 0…2.
        assert_eq!(top(&step, |t| step.at(t)[0], 0.3), 2.0);
    }

    #[test]
    fn crossing_and_top_move_with_a_parameter() {
        // p t² − t at p = 1: zero at 1/p, derivative −1; lowest at 1/(2p), derivative −1/2.
        let p = Dual::<1>::variable(1.0, 0);
        let number = Dual::<1>::constant;
        let step = Step::new(
            &Ends {
                t: [number(0.0), number(2.0)],
                y: [&[number(0.0)], &[p * 4.0 - 2.0]],
                slope: [&[number(-1.0)], &[p * 4.0 - 1.0]],
            },
            &[number(0.0)],
        );
        let zero = crossing_sampled(&step, |_, y| y[0], Direction::Rising, 3).unwrap();
        assert!((zero.value - 1.0).abs() < 1e-12 && (zero.slope[0] + 1.0).abs() < 1e-9);
        let lowest = top(&step, |t| -step.at(t)[0], 0.3);
        assert!((lowest.value - 0.5).abs() < 1e-12 && (lowest.slope[0] + 0.5).abs() < 1e-9);
    }

    #[test]
    fn maximum_of_t_minus_t_squared_is_a_quarter_at_one_half() {
        let (t, value) = maximum(&parabola(), |_, y| -y[0]);
        assert!((t - 0.5).abs() < 1e-7 && (value - 0.25).abs() < 1e-15);
    }
}
