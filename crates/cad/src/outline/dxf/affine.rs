//! Plane maps: how a block stands in the drawing, and lengths of the file in metres.
//!
//! ```text
//! x' = a x + b y + e        y' = c x + d y + f
//! ```
//!
//! with a to d without unit, or in m per unit of the file, e and f in m.
//!
//! # Valid
//! Any finite numbers.
//!
//! # References
//! - Elementary plane geometry; \[autodesk-dxf\] arbitrary axis algorithm for objects seen from behind.

use numerics::math::{RADIANS_PER_DEGREE, sin_cos};

/// A map of the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Affine {
    /// Columns x and y.
    columns: [[f64; 2]; 2],
    /// Where the origin goes.
    shift: [f64; 2],
}

/// Lengths that differ by this part are the same.
const SAME: f64 = 1e-9;

impl Affine {
    /// The plane stretched by `x` and `y` along its axes.
    pub fn scale(x: f64, y: f64) -> Self {
        let columns = [[x, 0.0], [0.0, y]];
        let shift = [0.0; 2];
        Self { columns, shift }
    }

    /// Everything moved by `shift`.
    pub fn shift(shift: [f64; 2]) -> Self {
        let columns = [[1.0, 0.0], [0.0, 1.0]];
        Self { columns, shift }
    }

    /// A turn about the origin, counter-clockwise.
    pub fn turn(angle_deg: f64) -> Self {
        let (s, c) = sin_cos(angle_deg * RADIANS_PER_DEGREE);
        let columns = [[c, s], [-s, c]];
        let shift = [0.0; 2];
        Self { columns, shift }
    }

    /// The map that does `first` and then this.
    pub fn after(&self, first: &Self) -> Self {
        Self {
            columns: first.columns.map(|column| self.direction(column)),
            shift: self.point(first.shift),
        }
    }

    /// Where a point goes.
    pub fn point(&self, p: [f64; 2]) -> [f64; 2] {
        let [x, y] = self.direction(p);
        [x + self.shift[0], y + self.shift[1]]
    }

    /// What becomes of a direction.
    pub fn direction(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [u, v] = self.columns;
        [u[0] * x + v[0] * y, u[1] * x + v[1] * y]
    }

    /// Whether it keeps circles: 1 where it keeps the sense of turning, −1 where it is a mirror; `None` where circles become ellipses.
    pub fn keeps_circles(&self) -> Option<f64> {
        let [u, v] = self.columns;
        circle(u, v).then(|| cross(u, v).signum())
    }
}

/// Whether two conjugate half-axes are those of a circle.
pub fn circle(u: [f64; 2], v: [f64; 2]) -> bool {
    let [uu, vv, uv] = [dot(u, u), dot(v, v), dot(u, v)];
    (uu - vv).abs() <= SAME * uu.max(vv) && uv.abs() <= SAME * uu.max(vv)
}

/// Scalar product.
pub fn dot(u: [f64; 2], v: [f64; 2]) -> f64 {
    u[0] * v[0] + u[1] * v[1]
}

/// Area of the parallelogram, positive where the second is to the left of the first.
pub fn cross(u: [f64; 2], v: [f64; 2]) -> f64 {
    u[0] * v[1] - u[1] * v[0]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn maps_are_done_from_right_to_left() {
        // (1, 0) doubled is (2, 0), turned (0, 2), moved (1, 2)
        let map =
            Affine::shift([1.0, 0.0]).after(&Affine::turn(90.0).after(&Affine::scale(2.0, 2.0)));
        let [x, y] = map.point([1.0, 0.0]);
        assert!((x - 1.0).abs() < 1e-15 && (y - 2.0).abs() < 1e-15);
        assert_eq!(map.keeps_circles(), Some(1.0));
        assert_eq!(Affine::scale(-1.0, 1.0).keeps_circles(), Some(-1.0));
        assert_eq!(Affine::scale(1.0, 2.0).keeps_circles(), None);
    }
}
