//! Rows between knots, and the row before the first and after the last.

/// n + 1 rows for n knots: row i holds from knot i - 1 to knot i.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Rows<const K: usize> {
    search: Search,
    before: [f64; K],
    rows: Vec<[f64; K]>,
}

/// Method by which the row is found.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Search {
    /// Bisection, among knots at any distance.
    Binary(Vec<f64>),
    /// Division, where the knots are evenly spaced.
    Uniform { first: f64, per_knot: f64 },
}

impl<const K: usize> Rows<K> {
    /// Rows after the first knot, one for each knot, and the row before it.
    pub fn new(search: Search, before: [f64; K], rows: Vec<[f64; K]>) -> Self {
        Self {
            search,
            before,
            rows,
        }
    }

    /// The row that holds at `x`.
    #[inline]
    pub fn row(&self, x: f64) -> [f64; K] {
        let knots_before = match &self.search {
            Search::Binary(knots) => knots.partition_point(|&knot| knot <= x),
            // The cast maps negative numbers and NaN to 0.
            Search::Uniform { first, per_knot } => ((x - first) * per_knot + 1.0) as usize,
        };
        let index = knots_before.min(self.rows.len());
        *index
            .checked_sub(1)
            .and_then(|i| self.rows.get(i))
            .unwrap_or(&self.before)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn row_is_that_of_the_last_knot_not_above() {
        let binary = Search::Binary(vec![1.0, 2.0, 3.0]);
        for search in [
            binary,
            Search::Uniform {
                first: 1.0,
                per_knot: 1.0,
            },
        ] {
            let rows = Rows::new(search, [0.0], vec![[1.0], [2.0], [3.0]]);
            let found = [-9.0, 0.9, 1.0, 1.9, 2.0, 2.5, 3.0, 1e300].map(|x| rows.row(x)[0]);
            assert_eq!(found, [0.0, 0.0, 1.0, 1.0, 2.0, 2.0, 3.0, 3.0]);
            assert_eq!(rows.row(f64::NAN), [0.0]);
        }
    }
}
