//! The lowest eigenvalue of K x = λ M x, by Lanczos' method on K⁻¹ M.
//!
//! ```text
//! β q' = K⁻¹ M q − α q − β q_before      α = qᵀ M K⁻¹ M q      qᵀ M q = 1
//! 1/λ ≈ the largest eigenvalue of the tridiagonal matrix of α and β
//! ```
//!
//! Every vector is made orthogonal to all before it, so that rounding does not produce copies of eigenvalues. The
//! largest eigenvalue of the tridiagonal matrix rises with each step; it is found by bisection on the signs of Sturm's
//! sequence.
//!
//! # References
//! - \[parlett-1998\] chapters 7 and 13.

use super::skyline::Factor;
use super::sparse::Sparse;
use super::{add_scaled, dot};

/// Conditions that end the iteration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// Relative change of the eigenvalue that ends it where two steps in a row change it by no more: a single step may be as
    /// quiet while a start with little of the lowest mode still shows another one.
    pub tolerance: f64,
    /// Largest number of steps.
    pub most_steps: usize,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            tolerance: 1e-9,
            most_steps: 40,
        }
    }
}

/// The lowest eigenvalue; `None` when the mass is zero or the iteration does not settle.
pub fn lowest_eigenvalue(stiffness: &Factor, mass: &Sparse, options: Options) -> Option<f64> {
    // any vector that is orthogonal to no mode: multiples of the golden section
    let start = (1..=mass.size()).map(|i| 0.5 + (i as f64 * 0.618_033_988_749_894_9).fract());
    lowest_from(start.collect(), stiffness, mass, options)
}

/// The lowest eigenvalue, from a vector.
fn lowest_from(
    mut q: Vec<f64>,
    stiffness: &Factor,
    mass: &Sparse,
    options: Options,
) -> Option<f64> {
    let size = mass.size();
    stiffness.solve(&mut q);
    let mut mq = vec![0.0; size];
    mass.multiply(&q, &mut mq);
    let norm = dot(&q, &mq).sqrt();
    if !(norm > 0.0 && norm.is_finite()) {
        return None;
    }
    scale(&mut q, 1.0 / norm);
    scale(&mut mq, 1.0 / norm);
    // vectors, and M times them
    let (mut basis, mut images) = (Vec::new(), Vec::new());
    let (mut alphas, mut betas): (Vec<f64>, Vec<f64>) = (Vec::new(), Vec::new());
    let (mut last, mut was_quiet) = (0.0_f64, false);
    for _ in 0..options.most_steps.min(size) {
        let mut next = mq.clone();
        stiffness.solve(&mut next);
        alphas.push(dot(&next, &mq));
        basis.push(q);
        images.push(mq);
        let value = largest_of_tridiagonal(&alphas, &betas, last);
        let is_quiet = (value - last).abs() <= options.tolerance * value;
        if was_quiet && is_quiet {
            return Some(1.0 / value);
        }
        (last, was_quiet) = (value, is_quiet);
        for (vector, image) in basis.iter().zip(&images).rev() {
            let part = dot(&next, image);
            add_scaled(&mut next, -part, vector);
        }
        let mut image = vec![0.0; size];
        mass.multiply(&next, &mut image);
        let beta = dot(&next, &image).max(0.0).sqrt();
        // the remainder is rounding: the Krylov space is exhausted
        if beta <= 1e-14 * value {
            return Some(1.0 / value);
        }
        scale(&mut next, 1.0 / beta);
        scale(&mut image, 1.0 / beta);
        betas.push(beta);
        (q, mq) = (next, image);
    }
    (basis.len() == size && last > 0.0).then(|| 1.0 / last)
}

fn scale(vector: &mut [f64], factor: f64) {
    vector.iter_mut().for_each(|x| *x *= factor);
}

/// Largest eigenvalue of the symmetric tridiagonal matrix, known to be at least `least`, by bisection.
fn largest_of_tridiagonal(diagonal: &[f64], beside: &[f64], least: f64) -> f64 {
    let edge = |i: usize| beside.get(i).map_or(0.0, |b| b.abs());
    let (mut low, mut high) = (least, f64::NEG_INFINITY);
    for (i, &a) in diagonal.iter().enumerate() {
        let before = if i > 0 { edge(i - 1) } else { 0.0 };
        let after = if i + 1 < diagonal.len() { edge(i) } else { 0.0 };
        low = low.max(a);
        high = high.max(a + before + after);
    }
    // an eigenvalue lies above x when a pivot of T − x is positive
    let any_above = |x: f64| {
        let mut pivot = f64::NEG_INFINITY;
        diagonal.iter().enumerate().any(|(i, &a)| {
            let b = if i > 0 { edge(i - 1) } else { 0.0 };
            pivot = a - x - b * b / pivot;
            pivot >= 0.0
        })
    };
    while high - low > 1e-13 * high.abs() {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            break;
        }
        if any_above(middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

#[cfg(test)]
mod tests {
    use super::super::skyline::Skyline;
    use super::*;
    use crate::math::{PI, sin};

    /// n masses of 1 between springs of 1, both ends held.
    fn chain(n: usize) -> (Factor, Sparse) {
        let first: Vec<usize> = (0..n).map(|j: usize| j.saturating_sub(1)).collect();
        let mut k = Skyline::new(&first);
        let mut m = Sparse::new(n);
        for i in 0..n {
            k.add(i, i, 2.0);
            m.add(i, i, 1.0);
            if i > 0 {
                k.add(i - 1, i, -1.0);
            }
        }
        (k.factor().unwrap(), m)
    }

    /// λ = 4 sin²(π j / 2(n + 1)) of mode j of the chain.
    fn eigenvalue(j: usize, n: usize) -> f64 {
        let s = sin(0.5 * PI * j as f64 / (n + 1) as f64);
        4.0 * s * s
    }

    #[test]
    fn chain_of_springs_has_its_closed_form() {
        let (k, m) = chain(60);
        let got = lowest_eigenvalue(&k, &m, Options::default()).unwrap();
        assert!((got / eigenvalue(1, 60) - 1.0).abs() < 1e-9, "{got}");
    }

    /// The first two values are those of the second mode, equal to 1e-11.
    #[test]
    fn a_start_with_little_of_the_lowest_mode_finds_it() {
        let n = 60;
        let (k, m) = chain(n);
        let place = |i: usize| (i + 1) as f64 / (n + 1) as f64;
        let part = |j: usize, i: usize| {
            let part = if j == 2 { 1.0 } else { 1e-6 };
            // the search divides each mode by its eigenvalue first
            part * eigenvalue(j, n) * sin(PI * j as f64 * place(i))
        };
        let start = (0..n).map(|i| (1..=n).map(|j| part(j, i)).sum());
        let got = lowest_from(start.collect(), &k, &m, Options::default()).unwrap();
        assert!((got / eigenvalue(1, n) - 1.0).abs() < 1e-9, "{got}");
    }

    #[test]
    fn largest_of_2_1_1_2_is_3() {
        // the bisection ends at 1e-13 of it
        assert!((largest_of_tridiagonal(&[2.0, 2.0], &[1.0], 0.0) - 3.0).abs() < 3e-13);
        assert_eq!(largest_of_tridiagonal(&[5.0], &[], 0.0), 5.0);
    }

    #[test]
    fn no_mass_has_no_eigenvalue() {
        let mut k = Skyline::new(&[0]);
        k.add(0, 0, 1.0);
        let m = Sparse::new(1);
        assert_eq!(
            lowest_eigenvalue(&k.factor().unwrap(), &m, Options::default()),
            None
        );
    }
}
