//! Linear algebra of structures: symmetric matrices, and their lowest eigenvalue. Small matrices are nalgebra's.
//!
//! - [`skyline`]: storage by columns, LDLᵀ, solutions.
//! - [`sparse`]: a symmetric matrix of few entries.
//! - [`lanczos`]: the lowest eigenvalue of K x = λ M x.

pub mod lanczos;
pub mod skyline;
pub mod sparse;

/// Σ aᵢ bᵢ over the shorter of both, in four sums that are added in a fixed order.
#[inline]
pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    let n = a.len().min(b.len());
    let (a, b) = (a.split_at(n).0, b.split_at(n).0);
    let mut sums = [0.0; 4];
    let (mut a4, mut b4) = (a.chunks_exact(4), b.chunks_exact(4));
    for (p, q) in (&mut a4).zip(&mut b4) {
        for (sum, (x, y)) in sums.iter_mut().zip(p.iter().zip(q)) {
            *sum += x * y;
        }
    }
    let rest: f64 = a4
        .remainder()
        .iter()
        .zip(b4.remainder())
        .map(|(x, y)| x * y)
        .sum();
    let [s0, s1, s2, s3] = sums;
    (s0 + s1) + (s2 + s3) + rest
}

/// a ← a + f b.
#[inline]
pub fn add_scaled(a: &mut [f64], f: f64, b: &[f64]) {
    for (x, y) in a.iter_mut().zip(b) {
        *x += f * y;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_to_six_squared_add_up_to_91() {
        let a = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0];
        assert_eq!(dot(&a, &a), 91.0);
        assert_eq!(dot(&a, &[1.0]), 1.0);
    }
}
