//! Smooth pieces of an atmosphere, one per lane, and the position of their rows in its tables.
//!
//! ```text
//! row = first row + (z − z₀)/w, whole, within the rows of the piece
//! ```
//!
//! with z in m, z₀ where the first row of the piece begins and w the height of a row, m.
//!
//! # Valid
//! Rows of equal height within a piece.
//!
//! # References
//! - Own convention.

use numerics::scalar::{Mask, Scalar};

/// A smooth piece of the atmosphere in each lane; all numbers are whole or constant, without derivatives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece<V> {
    /// Index of the piece, from below.
    layer: V,
    /// Start of the first row, m.
    first_m: V,
    /// Rows per meter, 1/m.
    rows_per_m: V,
    /// Index of the first row in the table.
    first_row: V,
    /// Number of rows.
    rows: V,
}

/// Position of an altitude among the rows of its piece.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place<V: Scalar> {
    /// Index of the row in the table, the nearest of the piece.
    pub row: V,
    /// Lanes whose altitude is among the rows.
    pub inside: V::Mask,
}

impl Piece<f64> {
    /// A piece without rows.
    pub(super) fn bare(layer: usize) -> Self {
        Self {
            layer: layer as f64,
            first_m: 0.0,
            rows_per_m: 0.0,
            first_row: 0.0,
            rows: 0.0,
        }
    }

    /// A piece whose rows, `rows` of `cell_m` each, begin at `first_m` with the row `first_row` of the table.
    pub(super) fn new(
        layer: usize,
        [first_m, cell_m]: [f64; 2],
        first_row: usize,
        rows: usize,
    ) -> Self {
        Self {
            layer: layer as f64,
            first_m,
            rows_per_m: 1.0 / cell_m,
            first_row: first_row as f64,
            rows: rows as f64,
        }
    }

    /// Index of the piece, from below.
    pub fn layer(&self) -> usize {
        self.layer as usize
    }
}

impl<V: Scalar<Value = V, Lane = f64>> Piece<V> {
    /// Equal pieces in every lane.
    pub fn everywhere(piece: &Piece<f64>) -> Self {
        let of = V::constant;
        Self {
            layer: of(piece.layer),
            first_m: of(piece.first_m),
            rows_per_m: of(piece.rows_per_m),
            first_row: of(piece.first_row),
            rows: of(piece.rows),
        }
    }

    /// The piece of one lane.
    pub fn lane(&self, lane: usize) -> Piece<f64> {
        Piece {
            layer: self.layer.lane(lane),
            first_m: self.first_m.lane(lane),
            rows_per_m: self.rows_per_m.lane(lane),
            first_row: self.first_row.lane(lane),
            rows: self.rows.lane(lane),
        }
    }

    /// Replaces the piece of one lane.
    pub fn set_lane(&mut self, lane: usize, piece: &Piece<f64>) {
        self.layer.set_lane(lane, piece.layer);
        self.first_m.set_lane(lane, piece.first_m);
        self.rows_per_m.set_lane(lane, piece.rows_per_m);
        self.first_row.set_lane(lane, piece.first_row);
        self.rows.set_lane(lane, piece.rows);
    }

    /// Index of the piece as a number, from below.
    #[inline]
    pub(super) fn layers(&self) -> V {
        self.layer
    }

    /// Position of an altitude, m, among the rows.
    #[inline]
    pub(super) fn place(&self, altitude_m: V) -> Place<V> {
        let zero = V::constant(0.0);
        let cell = (altitude_m - self.first_m) * self.rows_per_m;
        // Half a row down, and the nearest row is the one that holds.
        let held = (cell - 0.5).max(zero).min(self.rows - 1.0);
        Place {
            row: self.first_row + held,
            inside: cell.less(zero).not().and(cell.less(self.rows)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use numerics::scalar::Lanes;

    #[test]
    fn rows_are_counted_from_the_first_of_the_piece_and_end_with_the_last() {
        // Rows 7, 8 and 9 from 100 m, 50 m each.
        let piece = Piece::new(2, [100.0, 50.0], 7, 3);
        let row = |z: f64| piece.place(z).row.round();
        assert_eq!(
            [90.0, 101.0, 160.0, 249.0, 400.0].map(row),
            [7.0, 7.0, 8.0, 9.0, 9.0]
        );
        let inside = |z: f64| piece.place(z).inside;
        assert_eq!(
            [99.0, 100.0, 249.9, 250.0].map(inside),
            [false, true, true, false]
        );
    }

    #[test]
    fn each_lane_has_its_piece() {
        let low = Piece::new(0, [0.0, 10.0], 0, 5);
        let high = Piece::new(1, [50.0, 5.0], 5, 4);
        let mut both = Piece::<Lanes<2>>::everywhere(&low);
        both.set_lane(1, &high);
        assert_eq!((both.lane(0), both.lane(1)), (low, high));
        let rows = both.place(Lanes([33.0, 63.0])).row;
        assert_eq!([rows.lane(0).round(), rows.lane(1).round()], [3.0, 7.0]);
    }
}
