//! A symmetric matrix of which each column is kept from its first entry down to the diagonal, and its factors.
//!
//! ```text
//! K = Lᵀ D L      g_ij = k_ij − Σ_k l_ki g_kj      l_ij = g_ij / d_i      d_j = k_jj − Σ_k l_kj g_kj
//! ```
//!
//! with i < j and sums over the rows that both columns keep: no entry appears outside the skyline.
//!
//! ```
//! use numerics::linear::skyline::Skyline;
//!
//! // [4 2; 2 3] x = [8 7]: x = [1.25, 1.5]
//! let mut k = Skyline::new(&[0, 0]);
//! k.add(0, 0, 4.0);
//! k.add(0, 1, 2.0);
//! k.add(1, 1, 3.0);
//! let mut x = [8.0, 7.0];
//! k.factor().unwrap().solve(&mut x);
//! assert!((x[0] - 1.25).abs() < 1e-15 && (x[1] - 1.5).abs() < 1e-15);
//! ```
//!
//! # References
//! - \[bathe-1996\] section 8.2.3, active columns.

use super::{add_scaled, dot};

/// A symmetric matrix under its skyline.
#[derive(Clone, Debug, PartialEq)]
pub struct Skyline {
    /// First row kept of each column.
    first: Vec<usize>,
    /// Index among the values of the first row of each column; one more at the end.
    start: Vec<usize>,
    values: Vec<f64>,
}

impl Skyline {
    /// A matrix of zeros; `first` is the first row kept of each column, at most the column itself.
    pub fn new(first: &[usize]) -> Self {
        let first: Vec<usize> = first.iter().enumerate().map(|(j, &f)| f.min(j)).collect();
        let mut start = Vec::with_capacity(first.len() + 1);
        let mut end = 0;
        for (j, f) in first.iter().enumerate() {
            start.push(end);
            end += j + 1 - f;
        }
        start.push(end);
        Self {
            first,
            start,
            values: vec![0.0; end],
        }
    }

    /// Number of rows.
    pub fn size(&self) -> usize {
        self.first.len()
    }

    /// Number of entries kept.
    pub fn entries(&self) -> usize {
        self.values.len()
    }

    /// Adds `value` to the entry of row `i` and column `j`, and with it to its mirror; what is outside the skyline is lost.
    #[inline]
    pub fn add(&mut self, i: usize, j: usize, value: f64) {
        let (row, column) = if i < j { (i, j) } else { (j, i) };
        let (Some(&first), Some(&start)) = (self.first.get(column), self.start.get(column)) else {
            return;
        };
        debug_assert!(row >= first, "({row}, {column}) is outside the skyline");
        if row >= first
            && let Some(entry) = self.values.get_mut(start + row - first)
        {
            *entry += value;
        }
    }

    /// First row and entries of each column.
    fn columns(&self) -> impl DoubleEndedIterator<Item = (usize, &[f64])> + ExactSizeIterator {
        (0..self.first.len()).map(|j| {
            (
                self.first[j],
                &self.values[self.start[j]..self.start[j + 1]],
            )
        })
    }

    /// LDLᵀ; `None` unless every pivot is positive and finite.
    pub fn factor(mut self) -> Option<Factor> {
        let size = self.size();
        let mut inverse = Vec::with_capacity(size);
        for j in 0..size {
            let first = self.first[j];
            let (done, rest) = self.values.split_at_mut(self.start[j]);
            let column = rest.get_mut(..=j - first)?;
            for i in first + 1..j {
                let from = self.first[i].max(first);
                let above = &done[self.start[i] + from - self.first[i]..self.start[i + 1] - 1];
                let (known, here) = column.split_at_mut(i - first);
                let sum = dot(above, known.get(from - first..)?);
                *here.first_mut()? -= sum;
            }
            let (diagonal, above) = column.split_last_mut()?;
            let mut pivot = *diagonal;
            for (g, d) in above.iter_mut().zip(inverse.get(first..)?) {
                let l = *g * d;
                pivot -= l * *g;
                *g = l;
            }
            if !(pivot > 0.0 && pivot.is_finite()) {
                return None;
            }
            *diagonal = pivot;
            inverse.push(1.0 / pivot);
        }
        Some(Factor {
            matrix: self,
            inverse,
        })
    }
}

/// A matrix as LDLᵀ.
#[derive(Clone, Debug, PartialEq)]
pub struct Factor {
    /// L, with D on the diagonal.
    matrix: Skyline,
    /// 1/D.
    inverse: Vec<f64>,
}

impl Factor {
    /// Replaces the right-hand side `b` by the solution of K x = b.
    pub fn solve(&self, b: &mut [f64]) {
        for (j, (first, column)) in self.matrix.columns().enumerate() {
            let sum = dot(
                column.split_last().map_or(&[], |(_, above)| above),
                b.get(first..j).unwrap_or_default(),
            );
            if let Some(bj) = b.get_mut(j) {
                *bj -= sum;
            }
        }
        for (x, d) in b.iter_mut().zip(&self.inverse) {
            *x *= d;
        }
        for (j, (first, column)) in self.matrix.columns().enumerate().rev() {
            let (Some((_, above)), Some(&bj)) = (column.split_last(), b.get(j)) else {
                continue;
            };
            if let Some(rows) = b.get_mut(first..j) {
                add_scaled(rows, -bj, above);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::sparse::Sparse;
    use super::*;

    /// Second differences with one far coupling: 3 on the diagonal, −1 beside it, −½ between 0 and 4.
    fn matrix() -> (Skyline, Sparse) {
        let (mut k, mut same) = (Skyline::new(&[0, 0, 1, 2, 0]), Sparse::new(5));
        let diagonal = (0..5).map(|i| (i, i, 3.0));
        let beside = (0..4).map(|i| (i + 1, i, -1.0));
        for (i, j, value) in diagonal.chain(beside).chain([(4, 0, -0.5)]) {
            k.add(i, j, value);
            same.add(i, j, value);
        }
        (k, same)
    }

    #[test]
    fn solution_put_back_gives_the_right_hand_side() {
        let want = [1.0, -2.0, 0.5, 4.0, 3.0];
        let (k, same) = matrix();
        assert_eq!((k.size(), k.entries()), (5, 12));
        let mut x = want;
        k.factor().unwrap().solve(&mut x);
        let mut back = [0.0; 5];
        same.multiply(&x, &mut back);
        for (got, want) in back.iter().zip(want) {
            assert!((got - want).abs() < 1e-14, "{got} against {want}");
        }
    }

    #[test]
    fn a_matrix_that_is_not_positive_has_no_factors() {
        let mut k = Skyline::new(&[0, 0]);
        k.add(0, 0, 1.0);
        k.add(1, 0, 2.0);
        k.add(1, 1, 4.0);
        assert_eq!(k.factor(), None);
    }
}
