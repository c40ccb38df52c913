//! Length of the shortest line between two positions over the figure of a planet.
//!
//! ```text
//! ellipsoid:  λ = L + (1 − C) f sin α {σ + C sin σ [cos 2σₘ + C cos σ (2 cos² 2σₘ − 1)]},   d = b A (σ − Δσ)
//! sphere:     d = R atan2(|u × v|, u · v)
//! ```
//!
//! with d, R and the polar radius b in m, f the flattening, L and λ the differences of longitude on the ellipsoid and on the auxiliary sphere, σ
//! the arc and α the azimuth of the line at the equator on that sphere, in rad; A, B (in Δσ) and C series in f.
//!
//! # Valid
//! Heights are left out: the line is that of altitude zero. Ellipsoid: within 1e-9 of the length for flattenings up to
//! 0.01, 3e-5 at that of Saturn, 0.1; positions nearly opposite each other, within f times 180 deg, are reached by a
//! line up to f longer.
//!
//! # References
//! - \[vincenty-1975\] inverse formula.

use super::Planet;
use super::geodetic::{Ellipsoid, Geodetic};
use numerics::math::PI;
use numerics::scalar::{Mask, Scalar};

/// Largest number of iterations; each gains a factor of the flattening.
const ITERATIONS: usize = 40;
/// The difference of longitude is met within this, rad.
const CLOSE_RAD: f64 = 1e-13;

impl Planet {
    /// Distance of two positions over its figure, m: on the sphere of the planet's file, else along a geodesic of the ellipsoid.
    pub fn distance_m<S: Scalar>(&self, from: &Geodetic<S>, to: &Geodetic<S>) -> S {
        match self.downrange_sphere_radius_m {
            Some(radius_m) => great_circle_m(radius_m, from, to),
            None => geodesic_m(&self.ellipsoid(), from, to),
        }
    }

    /// Radius of the sphere that represents the figure in closed forms, m: that of its file, else the mean of its three
    /// axes.
    pub fn sphere_radius_m(&self) -> f64 {
        let mean_m = (2.0 * self.equatorial_radius_m + self.polar_radius_m) / 3.0;
        self.downrange_sphere_radius_m.unwrap_or(mean_m)
    }
}

/// Great-circle distance of two positions on a sphere, m, latitudes taken as they are.
pub fn great_circle_m<S: Scalar>(radius_m: f64, from: &Geodetic<S>, to: &Geodetic<S>) -> S {
    let (sin_1, cos_1) = (from.latitude_rad.sin(), from.latitude_rad.cos());
    let (sin_2, cos_2) = (to.latitude_rad.sin(), to.latitude_rad.cos());
    let turn_rad = to.longitude_rad - from.longitude_rad;
    let (sin_d, cos_d) = (turn_rad.sin(), turn_rad.cos());
    let (east, north) = (cos_2 * sin_d, cos_1 * sin_2 - sin_1 * cos_2 * cos_d);
    let across = (east * east + north * north).sqrt();
    across.atan2(sin_1 * sin_2 + cos_1 * cos_2 * cos_d) * radius_m
}

/// Length of the geodesic between two positions, m.
pub fn geodesic_m<S: Scalar>(ellipsoid: &Ellipsoid, from: &Geodetic<S>, to: &Geodetic<S>) -> S {
    let (one, tiny) = (S::constant(1.0), S::constant(1e-30));
    let f = 1.0 - ellipsoid.polar_radius_m / ellipsoid.equatorial_radius_m;
    // tan U = (1 − f) tan φ
    let reduced = |latitude_rad: S| {
        let (z, p) = (latitude_rad.sin() * (1.0 - f), latitude_rad.cos());
        let length = (z * z + p * p).sqrt();
        (z / length, p / length)
    };
    let ((sin_1, cos_1), (sin_2, cos_2)) = (reduced(from.latitude_rad), reduced(to.latitude_rad));
    let full =
        (to.longitude_rad - from.longitude_rad).map_value(|l| 2.0 * PI * (l / (2.0 * PI)).round());
    let longitude_rad = to.longitude_rad - from.longitude_rad - S::from_value(full);
    let mut turn_rad = longitude_rad;
    let mut line = Line::new([sin_1, cos_1], [sin_2, cos_2], turn_rad, tiny);
    for _ in 0..ITERATIONS {
        let Line {
            sigma_rad,
            sin_sigma,
            cos_sigma,
            sin_alpha,
            cos2_alpha,
            cos_2_middle,
        } = line;
        let c = cos2_alpha * (f / 16.0) * ((one * 4.0 - cos2_alpha * 3.0) * f + 4.0);
        let middle = c * cos_sigma * (cos_2_middle * cos_2_middle * 2.0 - 1.0) + cos_2_middle;
        let shift = (one - c) * f * sin_alpha * (sigma_rad + c * sin_sigma * middle);
        // no solution beyond 180 deg: the positions are nearly opposite each other
        let next = (longitude_rad + shift).clamp(S::constant(-PI), S::constant(PI));
        let change = (next - turn_rad).abs();
        turn_rad = next;
        line = Line::new([sin_1, cos_1], [sin_2, cos_2], turn_rad, tiny);
        if change.less(S::constant(CLOSE_RAD)).all() {
            break;
        }
    }
    let Line {
        sigma_rad,
        sin_sigma,
        cos_sigma,
        cos2_alpha,
        cos_2_middle,
        ..
    } = line;
    let u2 = cos2_alpha * (1.0 / ((1.0 - f) * (1.0 - f)) - 1.0);
    let a = u2 / 16384.0 * (u2 * (u2 * (one * 320.0 - u2 * 175.0) - 768.0) + 4096.0) + 1.0;
    let b = u2 / 1024.0 * (u2 * (u2 * (one * 74.0 - u2 * 47.0) - 128.0) + 256.0);
    let square = cos_2_middle * cos_2_middle;
    let inner = cos_sigma * (square * 2.0 - 1.0)
        - b / 6.0 * cos_2_middle * (sin_sigma * sin_sigma * 4.0 - 3.0) * (square * 4.0 - 3.0);
    let correction_rad = b * sin_sigma * (cos_2_middle + b / 4.0 * inner);
    a * (sigma_rad - correction_rad) * ellipsoid.polar_radius_m
}

/// The line on the auxiliary sphere.
struct Line<S> {
    sigma_rad: S,
    sin_sigma: S,
    cos_sigma: S,
    sin_alpha: S,
    cos2_alpha: S,
    cos_2_middle: S,
}

impl<S: Scalar> Line<S> {
    /// The line from sine and cosine of the reduced latitudes and a difference of longitude.
    fn new([sin_1, cos_1]: [S; 2], [sin_2, cos_2]: [S; 2], turn_rad: S, tiny: S) -> Self {
        let (sin_l, cos_l) = (turn_rad.sin(), turn_rad.cos());
        let (east, north) = (cos_2 * sin_l, cos_1 * sin_2 - sin_1 * cos_2 * cos_l);
        let sin_sigma = (east * east + north * north).sqrt();
        let cos_sigma = sin_1 * sin_2 + cos_1 * cos_2 * cos_l;
        // zero where the positions coincide
        let sin_alpha = cos_1 * cos_2 * sin_l / sin_sigma.max(tiny);
        let cos2_alpha = (S::constant(1.0) - sin_alpha * sin_alpha).max(S::constant(0.0));
        let along_equator = cos2_alpha.less(S::constant(1e-14));
        let middle = cos_sigma - sin_1 * sin_2 * 2.0 / cos2_alpha.max(tiny);
        Self {
            sigma_rad: sin_sigma.atan2(cos_sigma),
            sin_sigma,
            cos_sigma,
            sin_alpha,
            cos2_alpha,
            cos_2_middle: S::select(along_equator, S::constant(0.0), middle),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use numerics::math::RADIANS_PER_DEGREE;

    fn at(latitude_deg: f64, longitude_deg: f64) -> Geodetic<f64> {
        Geodetic {
            altitude_m: 0.0,
            latitude_rad: latitude_deg * RADIANS_PER_DEGREE,
            longitude_rad: longitude_deg * RADIANS_PER_DEGREE,
        }
    }

    #[test]
    fn a_degree_of_the_sphere_of_6371_km() {
        let length = |from, to| great_circle_m(6_371_000.0, &from, &to);
        assert!((length(at(30.0, 5.0), at(31.0, 5.0)) - 111_194.927).abs() < 1e-3);
        assert!((length(at(0.0, 0.0), at(90.0, 77.0)) - 10_007_543.398).abs() < 1e-3);
        assert!((length(at(0.0, 179.5), at(0.0, -179.5)) - 111_194.927).abs() < 1e-3);
    }

    #[test]
    fn lengths_over_four_planets_are_those_of_geographiclib() {
        // \[karney-2013\], geographiclib, in m to a millimeter.
        let figures = [
            (
                [6_378_137.0, 6_356_752.314_2],
                1e-9,
                [1_464_095.460, 10_909_619.390, 8_269_825.103, 147_756.323],
            ),
            (
                [3_396_190.0, 3_376_200.0],
                1e-9,
                [779_813.852, 5_796_455.430, 4_398_964.390, 78_876.786],
            ),
            (
                [71_492e3, 66_854e3],
                2e-6,
                [
                    16_522_416.725,
                    116_053_600.522,
                    90_362_596.012,
                    1_765_119.306,
                ],
            ),
            (
                [60_268e3, 54_364e3],
                3e-5,
                [
                    13_977_630.977,
                    95_182_154.855,
                    75_094_241.892,
                    1_542_567.881,
                ],
            ),
        ];
        let pairs = [
            (at(20.0, 0.0), at(21.0, 14.0)),
            (at(-30.0, 170.0), at(45.0, -120.0)),
            (at(10.0, 5.0), at(80.0, 60.0)),
            (at(-89.0, 0.0), at(-89.5, 120.0)),
        ];
        for ([a, b], within, lengths) in figures {
            let ellipsoid = Ellipsoid::new(a, b);
            for ((from, to), expected) in pairs.iter().zip(lengths) {
                let got = geodesic_m(&ellipsoid, from, to);
                let off = (got - expected).abs();
                assert!(
                    off < within * expected + 1e-3,
                    "{a}: {got} against {expected}"
                );
                assert!((geodesic_m(&ellipsoid, to, from) - got).abs() < 1e-6 * got);
            }
        }
    }

    #[test]
    fn one_place_and_opposite_places_have_a_length() {
        let mars = Ellipsoid::new(3_396_190.0, 3_376_200.0);
        assert_eq!(geodesic_m(&mars, &at(20.0, 5.0), &at(20.0, 5.0)), 0.0);
        assert_eq!(
            geodesic_m(&mars, &at(90.0, 5.0), &at(90.0, 95.0)).round(),
            0.0
        );
        // 5 deg of the equator across the date line
        let five = geodesic_m(&mars, &at(0.0, 178.0), &at(0.0, -177.0));
        assert!((five - 3_396_190.0 * 5.0 * RADIANS_PER_DEGREE).abs() < 1e-6);
        // half the meridian: π times the mean radius, but for f²/16
        let half = geodesic_m(&mars, &at(-90.0, 0.0), &at(90.0, 0.0));
        assert!((half / (PI * 3_386_195.0) - 1.0).abs() < 1e-5, "{half}");
        let opposite = geodesic_m(&mars, &at(1.0, 0.0), &at(-1.0, 179.9));
        assert!((0.99..1.006).contains(&(opposite / half)), "{opposite}");
    }
}
