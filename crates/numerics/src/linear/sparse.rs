//! A symmetric matrix of few entries: its diagonal, and the entries that couple two rows.
//!
//! ```
//! use numerics::linear::sparse::Sparse;
//!
//! // [2 1; 1 3] [1 2] = [4 7]
//! let mut m = Sparse::new(2);
//! m.add(0, 0, 2.0);
//! m.add(1, 1, 3.0);
//! m.add(1, 0, 1.0);
//! let mut y = [0.0; 2];
//! m.multiply(&[1.0, 2.0], &mut y);
//! assert_eq!(y, [4.0, 7.0]);
//! ```

/// A symmetric matrix of few entries.
#[derive(Clone, Debug, PartialEq)]
pub struct Sparse {
    diagonal: Vec<f64>,
    /// Row, column and entry off the diagonal; one of several that meet adds to the others.
    beside: Vec<(usize, usize, f64)>,
}

impl Sparse {
    /// A matrix of zeros of the given size.
    pub fn new(size: usize) -> Self {
        Self {
            diagonal: vec![0.0; size],
            beside: Vec::with_capacity(2 * size),
        }
    }

    /// Number of rows.
    pub fn size(&self) -> usize {
        self.diagonal.len()
    }

    /// Adds `value` to the entry of row `i` and column `j`, and with it to its mirror; what is outside the matrix is lost.
    #[inline]
    pub fn add(&mut self, i: usize, j: usize, value: f64) {
        if i != j {
            self.beside.push((i, j, value));
        } else if let Some(entry) = self.diagonal.get_mut(i) {
            *entry += value;
        }
    }

    /// y ← M x.
    pub fn multiply(&self, x: &[f64], y: &mut [f64]) {
        for ((y, x), m) in y.iter_mut().zip(x).zip(&self.diagonal) {
            *y = m * x;
        }
        for &(i, j, m) in &self.beside {
            if let (Some(&xi), Some(&xj)) = (x.get(i), x.get(j)) {
                if let Some(yi) = y.get_mut(i) {
                    *yi += m * xj;
                }
                if let Some(yj) = y.get_mut(j) {
                    *yj += m * xi;
                }
            }
        }
    }
}
