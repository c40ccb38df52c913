//! Roots and extrema of a function of one variable, bracketed: without derivatives, always terminating.
//!
//! # References
//! - \[brent-1973\] chapters 4 (root) and 5 (extremum).

/// More iterations than either search needs: each halves, or divides by the golden ratio, at least every few
/// evaluations.
const MAXIMUM_ITERATIONS: u32 = 200;

/// Root of `f` between `a` and `b` within `tolerance`, or `None` when `f` has the same sign at both or is not a number.
///
/// ```
/// let root = numerics::root::brent(|x| x * x - 2.0, 0.0, 2.0, 1e-12);
/// assert!((root.unwrap() - 2f64.sqrt()).abs() < 1e-12);
/// ```
pub fn brent(f: impl FnMut(f64) -> f64, a: f64, b: f64, tolerance: f64) -> Option<f64> {
    bracket(f, a, b, tolerance).map(|[root, _]| root)
}

/// Two points within `tolerance` of each other with the root of `f` between them, the better one first; the same point
/// twice when it is a root exactly.
pub fn bracket(mut f: impl FnMut(f64) -> f64, a: f64, b: f64, tolerance: f64) -> Option<[f64; 2]> {
    let (mut a, mut b) = (a, b);
    let (mut fa, mut fb) = (f(a), f(b));
    if fa == 0.0 {
        return Some([a, a]);
    }
    let bracketed = fa * sign(fb) <= 0.0;
    if !bracketed {
        return None;
    }
    // b: best so far; c: the other side of the root; a: b before.
    let (mut c, mut fc) = (a, fa);
    let (mut step, mut step_before) = (b - a, b - a);
    for _ in 0..MAXIMUM_ITERATIONS {
        if fc.abs() < fb.abs() {
            (a, b, c) = (b, c, b);
            (fa, fb, fc) = (fb, fc, fb);
        }
        if fb == 0.0 {
            return Some([b, b]);
        }
        let least = 2.0 * f64::EPSILON * b.abs() + 0.5 * tolerance;
        let half = 0.5 * (c - b);
        if half.abs() <= least {
            return Some([b, c]);
        }
        let [p, q] = if a == c {
            secant([a, fa], [b, fb], half)
        } else {
            inverse_quadratic([a, fa], [b, fb], [c, fc])
        };
        if step_before.abs() >= least
            && fa.abs() > fb.abs()
            && 2.0 * p.abs()
                < (3.0 * (half * q).abs() - (least * q).abs()).min((step_before * q).abs())
            && (p * q * half >= 0.0)
        {
            (step_before, step) = (step, p / q);
        } else {
            (step_before, step) = (half, half);
        }
        (a, fa) = (b, fb);
        b += if step.abs() > least {
            step
        } else {
            least * sign(half)
        };
        fb = f(b);
        if fb.is_nan() {
            return None;
        }
        if fb * sign(fc) > 0.0 {
            (c, fc) = (a, fa);
            (step, step_before) = (b - a, b - a);
        }
    }
    Some([b, c])
}

fn sign(x: f64) -> f64 {
    if x == 0.0 { 0.0 } else { x.signum() }
}

/// Step p / q from b to the zero of the line through two points.
fn secant([_, fa]: [f64; 2], [_, fb]: [f64; 2], half: f64) -> [f64; 2] {
    let s = fb / fa;
    [-2.0 * half * s, 1.0 - s]
}

/// Step p / q from b to the zero of the quadratic x(f) through three points.
fn inverse_quadratic([a, fa]: [f64; 2], [b, fb]: [f64; 2], [c, fc]: [f64; 2]) -> [f64; 2] {
    let (q, r, s) = (fa / fc, fb / fc, fb / fa);
    [
        s * ((c - b) * q * (q - r) - (b - a) * (r - 1.0)),
        -(q - 1.0) * (r - 1.0) * (s - 1.0),
    ]
}

/// Place between `a` and `b` at which `f` is largest, within `tolerance`, and its value there.
///
/// Finds one of several maxima; the ends are among the candidates. About half the digits of x are attainable.
///
/// ```
/// let (x, f) = numerics::root::maximum(|x| x * (2.0 - x), 0.0, 3.0, 1e-9);
/// assert!((x - 1.0).abs() < 1e-7 && (f - 1.0).abs() < 1e-14);
/// ```
pub fn maximum(mut f: impl FnMut(f64) -> f64, a: f64, b: f64, tolerance: f64) -> (f64, f64) {
    /// The smaller part of the golden section, (3 - √5) / 2.
    const GOLDEN: f64 = 0.381_966_011_250_105_1;
    let ends = [(a, f(a)), (b, f(b))];
    let (mut a, mut b) = (a.min(b), a.max(b));
    let root_epsilon = f64::EPSILON.sqrt();
    // x: best so far; w: second best; v: w before.
    let mut x = a + GOLDEN * (b - a);
    let (mut w, mut v) = (x, x);
    let mut fx = f(x);
    let (mut fw, mut fv) = (fx, fx);
    let (mut step, mut step_before) = (0.0_f64, 0.0_f64);
    for _ in 0..MAXIMUM_ITERATIONS {
        let middle = 0.5 * (a + b);
        let least = root_epsilon * x.abs() + tolerance / 3.0;
        if (x - middle).abs() <= 2.0 * least - 0.5 * (b - a) {
            break;
        }
        // Vertex of the parabola through x, w and v, as a step p / q from x.
        let r = (x - w) * (fx - fv);
        let q = (x - v) * (fx - fw);
        let p = (x - v) * q - (x - w) * r;
        let q = 2.0 * (q - r);
        let (p, q) = if q > 0.0 { (-p, q) } else { (p, -q) };
        let parabolic = step_before.abs() > least
            && p.abs() < (0.5 * q * step_before).abs()
            && p > q * (a - x)
            && p < q * (b - x);
        step_before = step;
        if parabolic {
            step = p / q;
            let u = x + step;
            if u - a < 2.0 * least || b - u < 2.0 * least {
                step = least * sign_or_one(middle - x);
            }
        } else {
            step_before = if x < middle { b - x } else { a - x };
            step = GOLDEN * step_before;
        }
        let u = x + if step.abs() >= least {
            step
        } else {
            least * sign_or_one(step)
        };
        let fu = f(u);
        if fu >= fx {
            if u < x {
                b = x
            } else {
                a = x
            }
            (v, fv, w, fw, x, fx) = (w, fw, x, fx, u, fu);
        } else {
            if u < x {
                a = u
            } else {
                b = u
            }
            if fu >= fw || w == x {
                (v, fv, w, fw) = (w, fw, u, fu);
            } else if fu >= fv || v == x || v == w {
                (v, fv) = (u, fu);
            }
        }
    }
    ends.into_iter().fold(
        (x, fx),
        |best, end| if end.1 >= best.1 { end } else { best },
    )
}

fn sign_or_one(x: f64) -> f64 {
    if x < 0.0 { -1.0 } else { 1.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math;

    #[test]
    fn cosine_vanishes_at_half_pi() {
        let mut calls = 0;
        let f = |x: f64| {
            calls += 1;
            math::cos(x)
        };
        let root = brent(f, 0.0, 3.0, 1e-14).unwrap();
        assert!((root - math::FRAC_PI_2).abs() < 1e-14);
        assert!(calls < 12, "{calls}");
    }

    #[test]
    fn root_of_a_flat_ninth_power_is_found_within_tolerance() {
        let root = brent(|x| math::powi(x - 0.3, 9), -1.0, 4.0, 1e-9).unwrap();
        assert!((root - 0.3).abs() <= 1e-9);
    }

    #[test]
    fn jump_counts_as_a_root() {
        let [x, y] = bracket(|x| if x < 1.5 { -1.0 } else { 1e9 }, 0.0, 4.0, 1e-12).unwrap();
        assert!(x.min(y) < 1.5 && x.max(y) >= 1.5 && (x - y).abs() <= 1.1e-12);
    }

    #[test]
    fn no_bracket_gives_nothing() {
        assert_eq!(brent(|x| x * x + 1.0, -1.0, 1.0, 1e-9), None);
        assert_eq!(brent(|_| f64::NAN, -1.0, 1.0, 1e-9), None);
        assert_eq!(
            brent(|x| if x < 0.0 { -1.0 } else { f64::NAN }, -1.0, 1.0, 1e-9),
            None
        );
        assert_eq!(
            brent(
                |x| if x.abs() == 1.0 { x } else { f64::NAN },
                -1.0,
                1.0,
                1e-9
            ),
            None
        );
    }

    #[test]
    fn root_at_an_end_is_exact() {
        assert_eq!(brent(|x| x, 0.0, 1.0, 1e-9), Some(0.0));
        assert_eq!(brent(|x| x, -1.0, 0.0, 1e-9), Some(0.0));
    }

    #[test]
    fn tiny_values_do_not_underflow_the_sign_test() {
        let root = brent(|x| 1e-200 * (x - 1.0), 0.0, 3.0, 1e-12).unwrap();
        assert!((root - 1.0).abs() < 1e-12);
    }

    #[test]
    fn maximum_of_x_exp_minus_x_is_at_one() {
        let mut calls = 0;
        let f = |x: f64| {
            calls += 1;
            x * math::exp(-x)
        };
        let (x, value) = maximum(f, 0.0, 5.0, 1e-8);
        assert!((x - 1.0).abs() < 1e-7, "{x}");
        assert!((value - math::exp(-1.0)).abs() < 1e-15);
        assert!(calls < 40, "{calls}");
    }

    #[test]
    fn maximum_at_an_end_is_that_end() {
        assert_eq!(maximum(|x| x, 0.0, 2.0, 1e-6), (2.0, 2.0));
        assert_eq!(maximum(|x| -x, 0.0, 2.0, 1e-6), (0.0, 0.0));
    }
}
