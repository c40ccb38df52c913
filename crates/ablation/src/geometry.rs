//! Volume under the initial wall of a plane, cylindrical or spherical normal.
//!
//! ```text
//! A(x) = (1 − x/R)ⁿ          n = 0 plane, 1 cylinder, 2 sphere
//! y(x) = ∫ A dx = R (1 − (1 − x/R)ⁿ⁺¹) / (n + 1)
//! ```
//!
//! with x in m from the initial wall inwards, R its radius of curvature in m, A per area of the initial wall, y in m.
//!
//! # Valid
//! 0 ≤ x ≤ R.
//!
//! # References
//! - \[assumed\]: geometry.

use numerics::math;

/// Shape of the surfaces of equal depth.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Geometry {
    /// Parallel planes.
    #[default]
    Planar,
    /// Cylinders about one axis.
    Cylindrical {
        /// Radius of the initial wall, m.
        radius_m: f64,
    },
    /// Spheres about one center.
    Spherical {
        /// Radius of the initial wall, m.
        radius_m: f64,
    },
}

impl Geometry {
    /// Radius of the initial wall, m; none of a plane.
    pub fn radius_m(self) -> Option<f64> {
        match self {
            Self::Planar => None,
            Self::Cylindrical { radius_m } | Self::Spherical { radius_m } => Some(radius_m),
        }
    }

    /// Area at a depth, m, over that of the initial wall.
    #[inline]
    pub fn area(self, x: f64) -> f64 {
        match self {
            Self::Planar => 1.0,
            Self::Cylindrical { radius_m: r } => 1.0 - x / r,
            Self::Spherical { radius_m: r } => (1.0 - x / r) * (1.0 - x / r),
        }
    }

    /// Volume between the initial wall and a depth, m, per area of the initial wall, m.
    #[inline]
    pub fn volume_m(self, x: f64) -> f64 {
        match self {
            Self::Planar => x,
            Self::Cylindrical { radius_m: r } => x * (1.0 - 0.5 * x / r),
            Self::Spherical { radius_m: r } => {
                let q = x / r;
                x * (1.0 - q + q * q / 3.0)
            }
        }
    }

    /// Depth, m, of a volume between it and the initial wall, m.
    #[inline]
    pub fn depth_m(self, volume_m: f64) -> f64 {
        let left = |n: f64, r: f64| (1.0 - n * volume_m / r).max(0.0);
        match self {
            Self::Planar => volume_m,
            Self::Cylindrical { radius_m: r } => {
                let q = left(2.0, r);
                // R (1 − √q), without the difference of near numbers.
                r * (1.0 - q) / (1.0 + q.sqrt())
            }
            Self::Spherical { radius_m: r } => {
                let q = left(3.0, r);
                let c = math::cbrt(q);
                r * (1.0 - q) / (1.0 + c + c * c)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_the_radius_holds_three_quarters_and_seven_eighths() {
        // Cylinder: R/2 (1 − 1/4) = 0.375 R; sphere: R/3 (1 − 1/8) = 0.291666… R.
        let cylinder = Geometry::Cylindrical { radius_m: 2.0 };
        let sphere = Geometry::Spherical { radius_m: 2.0 };
        assert_eq!(cylinder.volume_m(1.0), 0.75);
        assert!((sphere.volume_m(1.0) - 7.0 / 12.0).abs() < 1e-15);
        assert_eq!([cylinder.area(1.0), sphere.area(1.0)], [0.5, 0.25]);
    }

    #[test]
    fn depth_undoes_volume() {
        for radius_m in [0.3, 100.0] {
            for geometry in [
                Geometry::Planar,
                Geometry::Cylindrical { radius_m },
                Geometry::Spherical { radius_m },
            ] {
                for x in [0.0, 1e-9, 0.05, 0.29] {
                    assert!(
                        (geometry.depth_m(geometry.volume_m(x)) - x).abs() < 1e-13,
                        "{geometry:?} {x}"
                    );
                }
            }
        }
    }
}
