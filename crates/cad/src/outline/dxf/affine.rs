//! Affine maps of the plane: placement of a block in the drawing, conversion of file lengths to meters.
//!
//! ```text
//! x' = a x + b y + e        y' = c x + d y + f
//! ```
//!
//! with a to d dimensionless, or in m per unit of the file, and e and f in m.
//!
//! # Valid
//! Any finite numbers.
//!
//! # References
//! - Elementary plane geometry; \[autodesk-dxf\] arbitrary axis algorithm for objects seen from behind.

use numerics::math::{RADIANS_PER_DEGREE, sin_cos};

/// Affine map of the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Affine {
    /// Matrix columns: images of the x and y unit vectors.
    columns: [[f64; 2]; 2],
    /// Image of the origin.
    shift: [f64; 2],
}

/// Relative difference below which lengths are equal.
const SAME: f64 = 1e-9;

impl Affine {
    /// Scaling by `x` and `y` along the axes.
    pub fn scale(x: f64, y: f64) -> Self {
        let columns = [[x, 0.0], [0.0, y]];
        let shift = [0.0; 2];
        Self { columns, shift }
    }

    /// Translation by `shift`.
    pub fn shift(shift: [f64; 2]) -> Self {
        let columns = [[1.0, 0.0], [0.0, 1.0]];
        Self { columns, shift }
    }

    /// Rotation about the origin, counter-clockwise.
    pub fn turn(angle_deg: f64) -> Self {
        let (s, c) = sin_cos(angle_deg * RADIANS_PER_DEGREE);
        let columns = [[c, s], [-s, c]];
        let shift = [0.0; 2];
        Self { columns, shift }
    }

    /// Composition: `first`, then this map.
    pub fn after(&self, first: &Self) -> Self {
        Self {
            columns: first.columns.map(|column| self.direction(column)),
            shift: self.point(first.shift),
        }
    }

    /// Image of a point.
    pub fn point(&self, p: [f64; 2]) -> [f64; 2] {
        let [x, y] = self.direction(p);
        [x + self.shift[0], y + self.shift[1]]
    }

    /// Image of a direction.
    pub fn direction(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [u, v] = self.columns;
        [u[0] * x + v[0] * y, u[1] * x + v[1] * y]
    }

    /// 1 where the map keeps circles and their sense of rotation, −1 where it mirrors them; `None` where circles become
    /// ellipses.
    pub fn keeps_circles(&self) -> Option<f64> {
        let [u, v] = self.columns;
        circle(u, v).then(|| cross(u, v).signum())
    }
}

/// Whether two conjugate half-axes belong to a circle.
pub fn circle(u: [f64; 2], v: [f64; 2]) -> bool {
    let [uu, vv, uv] = [dot(u, u), dot(v, v), dot(u, v)];
    (uu - vv).abs() <= SAME * uu.max(vv) && uv.abs() <= SAME * uu.max(vv)
}

/// Scalar product.
pub fn dot(u: [f64; 2], v: [f64; 2]) -> f64 {
    u[0] * v[0] + u[1] * v[1]
}

/// Area of the parallelogram, positive where the second vector is to the left of the first.
pub fn cross(u: [f64; 2], v: [f64; 2]) -> f64 {
    u[0] * v[1] - u[1] * v[0]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn maps_are_done_from_right_to_left() {
        // (1, 0) scaled is (2, 0), rotated (0, 2), shifted (1, 2)
        let map =
            Affine::shift([1.0, 0.0]).after(&Affine::turn(90.0).after(&Affine::scale(2.0, 2.0)));
        let [x, y] = map.point([1.0, 0.0]);
        assert!((x - 1.0).abs() < 1e-15 && (y - 2.0).abs() < 1e-15);
        assert_eq!(map.keeps_circles(), Some(1.0));
        assert_eq!(Affine::scale(-1.0, 1.0).keeps_circles(), Some(-1.0));
        assert_eq!(Affine::scale(1.0, 2.0).keeps_circles(), None);
    }
}
