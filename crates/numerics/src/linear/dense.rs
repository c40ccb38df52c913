//! A few linear equations: elimination with the largest pivot of the column.
//!
//! ```text
//! A X = B
//! ```
//!
//! # References
//! - Gauss and Jordan, elementary.

/// Solution of `K` equations with `N` right-hand sides; not finite where the matrix is singular.
pub fn solve<const K: usize, const N: usize>(
    mut a: [[f64; K]; K],
    mut b: [[f64; N]; K],
) -> [[f64; N]; K] {
    for k in 0..K {
        let largest = (k..K).max_by(|&i, &j| a[i][k].abs().total_cmp(&a[j][k].abs()));
        let pivot = largest.unwrap_or(k);
        a.swap(k, pivot);
        b.swap(k, pivot);
        let (row, right) = (a[k], b[k]);
        // all other rows: the matrix becomes diagonal
        for i in (0..K).filter(|&i| i != k) {
            let factor = a[i][k] / row[k];
            (0..K).for_each(|j| a[i][j] -= factor * row[j]);
            (0..N).for_each(|j| b[i][j] -= factor * right[j]);
        }
    }
    core::array::from_fn(|k| b[k].map(|x| x / a[k][k]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_equations_with_a_zero_first() {
        // x = 1, y = 2, z = 3 and their negatives
        let a = [[0.0, 1.0, 1.0], [2.0, 0.0, 1.0], [1.0, 1.0, 1.0]];
        let x = solve(a, [[5.0, -5.0], [5.0, -5.0], [6.0, -6.0]]);
        assert_eq!(x, [[1.0, -1.0], [2.0, -2.0], [3.0, -3.0]]);
    }
}
