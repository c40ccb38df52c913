//! Events along a step: where a function of (t, y) crosses zero, and where it is largest.
//!
//! Only the dense output is used, no evaluation of the right-hand side. A crossing is looked for by the signs at the
//! ends of the step; where a function may cross twice within a step, [`crossing_sampled`] looks in between as well.

use super::Step;
use crate::root;

/// Width of the bracket that is left, as a part of the step.
const CROSSING_TOLERANCE: f64 = 1e-13;
/// The place of a maximum cannot be told better than about the square root of the rounding.
const MAXIMUM_TOLERANCE: f64 = 1e-9;

/// The way in which zero is crossed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// From below zero to above.
    Rising,
    /// From above zero to below.
    Falling,
    /// Either way.
    Either,
}

/// Where `g` crosses zero along `step`, by its signs at both ends; the value of `g` there is zero or has the new sign.
///
/// A zero at the very beginning belongs to the step before, a zero at the end to this one. After a retake that ends at a
/// crossing, rounding may leave either sign there: what must happen only once is for the caller to remember.
pub fn crossing<const N: usize>(
    step: &Step<N>,
    g: impl Fn(f64, &[f64; N]) -> f64,
    direction: Direction,
) -> Option<f64> {
    crossing_sampled(step, g, direction, 0)
}

/// The first crossing as in [`crossing`], looking also at `interior` points spread evenly within the step.
pub fn crossing_sampled<const N: usize>(
    step: &Step<N>,
    g: impl Fn(f64, &[f64; N]) -> f64,
    direction: Direction,
    interior: u32,
) -> Option<f64> {
    let length = step.t1 - step.t0;
    let (mut t_before, mut g_before) = (step.t0, g(step.t0, &step.y0));
    for n in 1..=interior + 1 {
        let last = n == interior + 1;
        let t = if last {
            step.t1
        } else {
            step.t0 + length * f64::from(n) / f64::from(interior + 1)
        };
        let g_here = g(t, &step.at(t));
        if crosses(g_before, g_here, direction) {
            let along = |t: f64| g(t, &step.at(t));
            let [x, other] = root::bracket(along, t_before, t, CROSSING_TOLERANCE * length)?;
            return Some(x.max(other));
        }
        (t_before, g_before) = (t, g_here);
    }
    None
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

/// Where `g` is largest along `step`, ends included, and its value there; of several maxima one is found.
pub fn maximum<const N: usize>(step: &Step<N>, g: impl Fn(f64, &[f64; N]) -> f64) -> (f64, f64) {
    let along = |t: f64| g(t, &step.at(t));
    root::maximum(
        along,
        step.t0,
        step.t1,
        MAXIMUM_TOLERANCE * (step.t1 - step.t0),
    )
}

#[cfg(test)]
mod tests {
    use super::super::step::Ends;
    use super::*;

    /// y = t² - t on 0…2: y' = 2 t - 1 is -1 and 3.
    fn parabola() -> Step<1> {
        Step::new(
            &Ends {
                t: [0.0, 2.0],
                y: [&[0.0], &[2.0]],
                slope: [&[-1.0], &[3.0]],
            },
            &[],
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
    fn maximum_of_t_minus_t_squared_is_a_quarter_at_one_half() {
        let (t, value) = maximum(&parabola(), |_, y| -y[0]);
        assert!((t - 0.5).abs() < 1e-7 && (value - 0.25).abs() < 1e-15);
    }
}
