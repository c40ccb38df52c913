//! Functions of numbers with derivatives beside those of the trait: the value by `math`, with its bits.
//!
//! ```text
//! d sin x = cos x dx    d ∛x = dx / (3 ∛x²)    d arcsin x = dx / √(1 − x²)    d √(x² + y²) = (x dx + y dy) / √(x² + y²)
//! ```

use super::Single;
use crate::math;

/// A function of `x` with its value there and its rate of change, which is called only where there are derivatives.
#[inline]
pub fn function<S: Single>(x: S, value: f64, rate: impl FnOnce() -> f64) -> S {
    S::root(value, || x - x.value(), || -1.0 / rate())
}

/// Sine and cosine of `x`, rad.
#[inline]
pub fn sin_cos<S: Single>(x: S) -> (S, S) {
    let (sin, cos) = math::sin_cos(x.value());
    (function(x, sin, || cos), function(x, cos, || -sin))
}

/// Cube root.
#[inline]
pub fn cbrt<S: Single>(x: S) -> S {
    let root = math::cbrt(x.value());
    function(x, root, || 1.0 / (3.0 * root * root))
}

/// Arc sine, rad.
#[inline]
pub fn asin<S: Single>(x: S) -> S {
    let rate = || 1.0 / (1.0 - x.value() * x.value()).sqrt();
    function(x, math::asin(x.value()), rate)
}

/// Length of the vector (`x`, `y`).
#[inline]
pub fn hypot<S: Single>(x: S, y: S) -> S {
    let length = math::hypot(x.value(), y.value());
    S::root(length, || x * x + y * y - length * length, || -2.0 * length)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::Dual;

    /// Each function once.
    fn mixture<S: Single>(x: S, y: S) -> S {
        let (s, c) = sin_cos(x);
        let root = S::implicit(math::cbrt(x.value() + y.value()), |z| z * z * z - x - y);
        s * y + c / y + cbrt(x * y) + asin(x / y) + hypot(x, y) * root
    }

    #[test]
    fn derivatives_are_those_of_central_differences_and_values_those_of_math() {
        for i in 0..20 {
            let (x, y) = (0.31 + 0.03 * f64::from(i), 1.21 + 0.02 * f64::from(i));
            let dual = mixture(Dual::<2>::variable(x, 0), Dual::variable(y, 1));
            assert_eq!(dual.value.to_bits(), mixture(x, y).to_bits());
            let h = 1e-5;
            let by_x = (mixture(x + h, y) - mixture(x - h, y)) / (2.0 * h);
            let by_y = (mixture(x, y + h) - mixture(x, y - h)) / (2.0 * h);
            for (slope, difference) in dual.slope.iter().zip([by_x, by_y]) {
                assert!(
                    (slope / difference - 1.0).abs() < 1e-7,
                    "{dual:?} {difference}"
                );
            }
        }
    }

    #[test]
    fn cube_root_rises_without_bound_at_zero_and_of_a_constant_does_not_move() {
        let zero = cbrt(Dual::<2>::variable(0.0, 0));
        assert_eq!((zero.value, zero.slope), (0.0, [f64::INFINITY, 0.0]));
    }

    #[test]
    fn two_equations_move_together() {
        // x + y = a, x y = b at (2, 3): dx/da = x/(x − y) = −2, dy/da = 3; dx/db = 1/(y − x) = 1, dy/db = −1
        let (a, b) = (Dual::<2>::variable(5.0, 0), Dual::variable(6.0, 1));
        let [x, y] = [2.0, 3.0];
        let residual = || [-a + (x + y), -b + x * y];
        let [x, y] = Single::roots([x, y], residual, || [[1.0, 1.0], [y, x]]);
        assert_eq!((x.slope, y.slope), ([-2.0, 1.0], [3.0, -1.0]));
    }
}
