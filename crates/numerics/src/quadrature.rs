//! Gauss-Legendre integration, one panel or several.
//!
//! ```text
//! ∫ f dx ≈ (b - a)/2 Σ wᵢ [f(m - dᵢ) + f(m + dᵢ)]      m = (a + b)/2    dᵢ = ξᵢ (b - a)/2
//! ```
//!
//! Exact for polynomials of degree 9 (five points) and 15 (eight points).
//!
//! ```
//! use numerics::quadrature::Rule;
//!
//! let area = Rule::Gauss5.integral(|x| x * x, [0.0, 3.0]);
//! assert!((area - 9.0).abs() < 1e-14);
//! ```
//!
//! # References
//! - Roots of the Legendre polynomials P₅ and P₈, computed to 22 digits; in the 15 digits printed there they are those of
//!   \[abramowitz-stegun-1964\] table 25.4.
#![allow(
    clippy::excessive_precision,
    reason = "more digits than a double holds, so that it is the nearest one"
)]

use crate::scalar::Single;

/// Weight of the middle of five points, 128/225.
const MIDDLE_5: f64 = 128.0 / 225.0;
/// ξᵢ, wᵢ.
const PAIRS_5: [[f64; 2]; 2] = [
    [0.5384693101056830910363, 0.4786286704993664680413],
    [0.9061798459386639927976, 0.2369268850561890875143],
];
const PAIRS_8: [[f64; 2]; 4] = [
    [0.1834346424956498049395, 0.3626837833783619829652],
    [0.5255324099163289858177, 0.3137066458778872873380],
    [0.7966664774136267395916, 0.2223810344533744705444],
    [0.9602898564975362316836, 0.1012285362903762591525],
];

/// Number of points in a panel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rule {
    /// Five points.
    Gauss5,
    /// Eight points.
    Gauss8,
}

impl Rule {
    /// Integral of `f` over `interval`, in one panel.
    #[inline]
    pub fn integral<S: Single>(self, mut f: impl FnMut(S) -> S, [a, b]: [S; 2]) -> S {
        let (m, half) = ((a + b) * 0.5, (b - a) * 0.5);
        let (mut sum, pairs) = match self {
            Self::Gauss5 => (f(m) * MIDDLE_5, PAIRS_5.as_slice()),
            Self::Gauss8 => (S::constant(0.0), PAIRS_8.as_slice()),
        };
        for &[xi, w] in pairs {
            let d = half * xi;
            sum += (f(m - d) + f(m + d)) * w;
        }
        sum * half
    }

    /// Points and weights of one panel, for sums of more than one function.
    #[inline]
    pub fn points(self, [a, b]: [f64; 2]) -> impl Iterator<Item = (f64, f64)> {
        let (m, half) = (0.5 * (a + b), 0.5 * (b - a));
        let (middle, pairs) = match self {
            Self::Gauss5 => (Some((m, MIDDLE_5 * half)), PAIRS_5.as_slice()),
            Self::Gauss8 => (None, PAIRS_8.as_slice()),
        };
        let both = pairs
            .iter()
            .flat_map(move |[xi, w]| [(m - xi * half, w * half), (m + xi * half, w * half)]);
        middle.into_iter().chain(both)
    }

    /// Integral of `f` over `interval`, in `panels` equal panels (at least one).
    pub fn composite<S: Single>(self, mut f: impl FnMut(S) -> S, [a, b]: [S; 2], panels: u32) -> S {
        let panels = panels.max(1);
        let end = |n: u32| {
            if n == panels {
                b
            } else {
                a + (b - a) * (f64::from(n) / f64::from(panels))
            }
        };
        (0..panels)
            .map(|n| self.integral(&mut f, [end(n), end(n + 1)]))
            .fold(S::constant(0.0), |sum, panel| sum + panel)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{PI, powi, sin};

    #[test]
    fn highest_exact_powers_are_8_and_14_and_no_more() {
        // ∫ x^n dx over -1…1 = 2 / (n + 1) for even n
        for (rule, exact, missed) in [(Rule::Gauss5, 8, 10), (Rule::Gauss8, 14, 16)] {
            let error = |n: u32| {
                (rule.integral(|x| powi(x, n), [-1.0, 1.0]) - 2.0 / f64::from(n + 1)).abs()
            };
            assert!(error(exact) < 1e-15, "{}", error(exact));
            assert!(error(missed) > 1e-5, "{}", error(missed));
        }
    }

    #[test]
    fn half_wave_of_the_sine_has_area_two() {
        assert!((Rule::Gauss8.integral(sin, [0.0, PI]) - 2.0).abs() < 1e-11);
        assert!((Rule::Gauss5.composite(sin, [0.0, PI], 8) - 2.0).abs() < 1e-13);
        assert!((Rule::Gauss5.composite(sin, [PI, 0.0], 8) + 2.0).abs() < 1e-13);
    }

    #[test]
    fn halving_the_panels_divides_the_error_by_two_to_the_tenth() {
        let exact = crate::math::exp(4.0) - 1.0;
        let error =
            |panels| (Rule::Gauss5.composite(crate::math::exp, [0.0, 4.0], panels) - exact).abs();
        let order = crate::math::ln(error(2) / error(4)) / crate::math::ln(2.0);
        assert!((9.7..10.3).contains(&order), "{order}");
    }
}
