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

/// r₁ to r₇.
const ROWS: usize = 7;

/// A step that was taken, with its dense output.
#[derive(Clone, Debug, PartialEq)]
pub struct Step<const N: usize> {
    /// Beginning of the step.
    pub t0: f64,
    /// End of the step.
    pub t1: f64,
    /// State at the beginning.
    pub y0: [f64; N],
    /// State at the end.
    pub y1: [f64; N],
    /// r₁ to r₇, of which the first `used` count.
    rows: [[f64; N]; ROWS],
    used: usize,
}

/// The two ends of a step with their slopes.
pub(super) struct Ends<'a, const N: usize> {
    pub t: [f64; 2],
    pub y: [&'a [f64; N]; 2],
    pub slope: [&'a [f64; N]; 2],
}

impl<const N: usize> Step<N> {
    /// The step between `ends`, its cubic polynomial corrected by r₄ and the following, as many as there are.
    #[inline]
    pub(super) fn new<const M: usize>(ends: &Ends<N>, corrections: &[[f64; N]; M]) -> Self {
        let h = ends.t[1] - ends.t[0];
        let ([y0, y1], [slope0, slope1]) = (ends.y, ends.slope);
        let rise: [f64; N] = core::array::from_fn(|i| y1[i] - y0[i]);
        let bend: [f64; N] = core::array::from_fn(|i| h * slope0[i] - rise[i]);
        let rest: [f64; N] = core::array::from_fn(|i| rise[i] - h * slope1[i] - bend[i]);
        let none = [0.0; N];
        let mut rows = [rise, bend, rest, none, none, none, none];
        for (row, correction) in rows.iter_mut().skip(3).zip(corrections) {
            *row = *correction;
        }
        let used = (3 + M).min(ROWS);
        Self {
            t0: ends.t[0],
            t1: ends.t[1],
            y0: *ends.y[0],
            y1: *ends.y[1],
            rows,
            used,
        }
    }

    /// State at `t`, between [`Step::t0`] and [`Step::t1`]; exactly `y0` and `y1` there.
    #[inline]
    pub fn at(&self, t: f64) -> [f64; N] {
        if t == self.t1 {
            return self.y1;
        }
        let theta = (t - self.t0) / (self.t1 - self.t0);
        core::array::from_fn(|i| self.value(i, theta))
    }

    /// Component `i` of the state at `t`; not a number where there is no such component.
    #[inline]
    pub fn component(&self, i: usize, t: f64) -> f64 {
        match self.y1.get(i) {
            None => f64::NAN,
            Some(&y1) if t == self.t1 => y1,
            Some(_) => self.value(i, (t - self.t0) / (self.t1 - self.t0)),
        }
    }

    #[inline]
    fn value(&self, i: usize, theta: f64) -> f64 {
        let factor = [theta, 1.0 - theta];
        let mut sum = 0.0;
        for (n, row) in self.rows.iter().enumerate().take(self.used).rev() {
            sum = (sum + row[i]) * factor[n % 2];
        }
        self.y0[i] + sum
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
        Step::new(&ends, &[])
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
        assert_eq!(Step::new(&ends, &[[16.0]]).at(0.25), [0.5625]);
    }

    #[test]
    fn component_that_is_not_there_is_not_a_number() {
        assert!(cube().component(1, 2.0).is_nan());
    }
}
