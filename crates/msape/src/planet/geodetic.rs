//! Height, latitude and longitude over an ellipsoid of revolution.
//!
//! ```text
//! x = (N + h) cos φ cos λ,  y = (N + h) cos φ sin λ,  z = (N (1 − e²) + h) sin φ,  N = a/√(1 − e² sin² φ)
//! tan β = (b z/(a p)) (1 + e′² b/r)                                        Bowring's first guess
//! tan φ = (z + e′² b sin³ β)/(p − e² a cos³ β)
//! h     = (p − a cos β) cos φ + (z − b sin β) sin φ − t²/(2 a)
//! t     = (z − b sin β) cos φ − (p − a cos β) sin φ
//! ```
//!
//! with a, b the equatorial and polar radius, h and all coordinates in m, φ, λ the geodetic latitude and longitude and β
//! the reduced latitude in rad, p = √(x² + y²), r = √(p² + z²), e² = 1 − b²/a², e′² = a²/b² − 1.
//!
//! # Valid
//! Altitudes above −10 km of any planet of a flattening up to a half, the poles included. [`Ellipsoid::local`] takes one
//! pass, two where the flattening is above 0.006, all where it is above 0.1, in square roots only: its height is good to
//! 1e-5 m to 500 km (Saturn, of 0.098: 1e-4 m) and to 1e-9 of the height beyond.
//!
//! # References
//! - \[bowring-1985\]; \[nga-wgs84\] for the forward conversion.

use numerics::scalar::Scalar;
use serde::{Deserialize, Serialize};

/// Geodetic position.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Geodetic<S> {
    /// Height above the ellipsoid, m.
    pub altitude_m: S,
    /// Geodetic latitude, rad.
    pub latitude_rad: S,
    /// Longitude, positive east, rad, in −π…π.
    pub longitude_rad: S,
}

/// Altitude and vertical of a position, for the atmosphere and the local horizon.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Local<S> {
    /// Height above the ellipsoid, m.
    pub altitude_m: S,
    /// Unit vector of the geodetic vertical, planet-fixed axes.
    pub up: [S; 3],
}

/// An ellipsoid of revolution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ellipsoid {
    /// Equatorial radius a, m.
    pub equatorial_radius_m: f64,
    /// Polar radius b, m.
    pub polar_radius_m: f64,
    /// e².
    e2: f64,
    /// e′².
    e2_prime: f64,
    /// Passes of the fast form.
    fast_passes: usize,
}

/// Passes of Bowring's formula after which nothing changes any more, for a flattening of a half.
const PASSES_TO_CONVERGENCE: usize = 5;
/// Flattening above which the fast form takes a second pass: that of Mars is just below, 7e-6 m.
const STRONG_FLATTENING: f64 = 0.006;
/// Flattening above which the fast form takes all passes: that of Saturn is just below.
const EXTREME_FLATTENING: f64 = 0.1;

impl Ellipsoid {
    /// The ellipsoid with these radii, m.
    pub const fn new(equatorial_radius_m: f64, polar_radius_m: f64) -> Self {
        let (a, b) = (equatorial_radius_m, polar_radius_m);
        Self {
            equatorial_radius_m,
            polar_radius_m,
            e2: 1.0 - (b / a) * (b / a),
            e2_prime: (a / b) * (a / b) - 1.0,
            fast_passes: match 1.0 - b / a {
                flattening if flattening > EXTREME_FLATTENING => PASSES_TO_CONVERGENCE,
                flattening if flattening > STRONG_FLATTENING => 2,
                _ => 1,
            },
        }
    }

    /// Planet-fixed coordinates of a geodetic position, m.
    pub fn cartesian_m<S: Scalar>(&self, position: &Geodetic<S>) -> [S; 3] {
        let Geodetic {
            altitude_m: h,
            latitude_rad,
            longitude_rad,
        } = *position;
        let (a, b) = (self.equatorial_radius_m, self.polar_radius_m);
        let (sin, cos) = (latitude_rad.sin(), latitude_rad.cos());
        // N = a²/√(a² cos² φ + b² sin² φ)
        let n = S::constant(a * a) / (cos * cos * (a * a) + sin * sin * (b * b)).sqrt();
        let p = (n + h) * cos;
        [
            p * longitude_rad.cos(),
            p * longitude_rad.sin(),
            (n * (b * b / (a * a)) + h) * sin,
        ]
    }

    /// Geodetic position of planet-fixed coordinates, m; the latitude is zero at the center.
    pub fn geodetic<S: Scalar>(&self, r: [S; 3]) -> Geodetic<S> {
        let [x, y, z] = r;
        let Foot {
            altitude_m,
            p_up,
            z_up,
        } = self.foot(r, PASSES_TO_CONVERGENCE);
        let p = (x * x + y * y).sqrt();
        Geodetic {
            altitude_m,
            latitude_rad: (z * z_up).atan2(p * p_up),
            longitude_rad: y.atan2(x),
        }
    }

    /// Height and vertical of planet-fixed coordinates, m, without trigonometric functions.
    #[inline]
    pub fn local<S: Scalar>(&self, r: [S; 3]) -> Local<S> {
        let Foot {
            altitude_m,
            p_up,
            z_up,
        } = self.foot(r, self.fast_passes);
        Local {
            altitude_m,
            up: [r[0] * p_up, r[1] * p_up, r[2] * z_up],
        }
    }

    /// The foot of the vertical, all through the reduced latitude, cos β = p c, sin β = z s.
    #[inline]
    fn foot<S: Scalar>(&self, r: [S; 3], passes: usize) -> Foot<S> {
        let (a, b) = (self.equatorial_radius_m, self.polar_radius_m);
        let (e2, e2_prime) = (self.e2, self.e2_prime);
        let [x, y, z] = r;
        let (p2, z2) = (x * x + y * y, z * z);
        let radius = (p2 + z2).sqrt();
        // tan β = z s / (p c)
        let (mut c, mut s) = (radius * a, (radius + e2_prime * b) * b);
        let (mut p_up, mut z_up) = (S::constant(1.0), S::constant(1.0));
        for pass in 0..passes {
            if pass > 0 {
                (c, s) = (p_up * a, z_up * b);
            }
            let scale = S::constant(1.0) / (p2 * c * c + z2 * s * s).sqrt();
            (c, s) = (c * scale, s * scale);
            p_up = S::constant(1.0) - p2 * c * c * c * (e2 * a);
            z_up = z2 * s * s * s * (e2_prime * b) + 1.0;
        }
        let scale = S::constant(1.0) / (p2 * p_up * p_up + z2 * z_up * z_up).sqrt();
        (p_up, z_up) = (p_up * scale, z_up * scale);
        let (p_over, z_over) = (S::constant(1.0) - c * a, S::constant(1.0) - s * b);
        // The guessed foot is t beside the true one, on a curve that bends away by t²/(2 a).
        let t = z_over * p_up - p_over * z_up;
        let altitude_m = p2 * p_up * p_over + z2 * z_up * z_over - p2 * z2 * t * t * (0.5 / a);
        Foot {
            altitude_m,
            p_up,
            z_up,
        }
    }
}

/// Height, and the vertical as cos φ / p and sin φ / z.
struct Foot<S> {
    altitude_m: S,
    p_up: S,
    z_up: S,
}

#[cfg(test)]
mod tests {
    use super::*;
    use numerics::math::{self, FRAC_PI_2, PI};

    const WGS84: Ellipsoid = Ellipsoid::new(6_378_137.0, 6_356_752.314_2);
    const SATURN: Ellipsoid = Ellipsoid::new(60_268_000.0, 54_364_000.0);
    /// Radii of the planet files, and figures that a case may have.
    const OTHERS: [(Ellipsoid, &str); 6] = [
        (Ellipsoid::new(3_396_190.0, 3_376_200.0), "mars"),
        (Ellipsoid::new(71_492_000.0, 66_854_000.0), "jupiter"),
        (Ellipsoid::new(25_559_000.0, 24_973_000.0), "uranus"),
        (Ellipsoid::new(24_764_000.0, 24_341_000.0), "neptune"),
        (Ellipsoid::new(6_378_137.0, 5_421_416.45), "0.15"),
        (Ellipsoid::new(6_378_137.0, 3_189_068.5), "0.5"),
    ];
    const SPHERE: Ellipsoid = Ellipsoid::new(6_051_800.0, 6_051_800.0);

    /// Positions over all latitudes, some longitudes and the given altitudes.
    fn positions(altitudes_m: &[f64]) -> Vec<Geodetic<f64>> {
        let mut all = Vec::new();
        for altitude_m in altitudes_m {
            for i in 0..=360 {
                let latitude_rad = (f64::from(i) / 360.0 - 0.5) * PI;
                for longitude_rad in [-3.1, -1.0, 0.0, 0.3, 2.0] {
                    all.push(Geodetic {
                        altitude_m: *altitude_m,
                        latitude_rad,
                        longitude_rad,
                    });
                }
            }
        }
        all
    }

    #[test]
    fn at_the_equator_and_the_pole_the_height_is_counted_from_the_radii() {
        let on = |altitude_m, latitude_rad| {
            WGS84.cartesian_m(&Geodetic {
                altitude_m,
                latitude_rad,
                longitude_rad: FRAC_PI_2,
            })
        };
        assert!((on(1000.0, 0.0)[1] - 6_379_137.0).abs() < 1e-9);
        assert!((on(1000.0, FRAC_PI_2)[2] - 6_357_752.314_2).abs() < 1e-9);
    }

    #[test]
    fn the_published_example_of_45_degrees() {
        // N = a/√(1 − e²/2) = 6 388 838.290 m; x = N cos 45°, z = N (1 − e²) sin 45°
        let [x, _, z] = WGS84.cartesian_m(&Geodetic {
            altitude_m: 0.0,
            latitude_rad: PI / 4.0,
            longitude_rad: 0.0,
        });
        assert!((x - 4_517_590.879).abs() < 1e-3, "{x}");
        assert!((z - 4_487_348.409).abs() < 1e-3, "{z}");
    }

    #[test]
    fn there_and_back() {
        // 4 units in the last place of the distance from the center, which the coordinates carry.
        for (ellipsoid, name) in [(WGS84, "wgs84"), (SATURN, "saturn"), (SPHERE, "sphere")] {
            for position in positions(&[-10e3, 0.0, 125e3, 1e6]) {
                let back = ellipsoid.geodetic(ellipsoid.cartesian_m(&position));
                let ulp = (ellipsoid.equatorial_radius_m + 1e6) * f64::EPSILON;
                assert!(
                    (back.altitude_m - position.altitude_m).abs() < 4.0 * ulp,
                    "{name} {position:?} {back:?}"
                );
                assert!(
                    (back.latitude_rad - position.latitude_rad).abs() < 1e-14,
                    "{name} {back:?}"
                );
                let at_pole = position.latitude_rad.abs() > FRAC_PI_2 - 1e-9;
                assert!(
                    at_pole || (back.longitude_rad - position.longitude_rad).abs() < 1e-14,
                    "{name} {back:?}"
                );
            }
        }
    }

    #[test]
    fn the_fast_height_and_vertical() {
        let known = [(WGS84, "wgs84"), (SATURN, "saturn"), (SPHERE, "sphere")];
        for (ellipsoid, name) in known.into_iter().chain(OTHERS) {
            for position in positions(&[-10e3, 0.0, 50e3, 125e3, 500e3, 2e6, 2e7, 4e8]) {
                let local = ellipsoid.local(ellipsoid.cartesian_m(&position));
                let error = (local.altitude_m - position.altitude_m).abs();
                let near_m = if name == "saturn" { 1e-4 } else { 1e-5 };
                let allowed = (position.altitude_m * 1e-9).max(near_m);
                assert!(error < allowed, "{name} {position:?}: {error:e} m");
                let (sin, cos) = math::sin_cos(position.latitude_rad);
                let (sin_l, cos_l) = math::sin_cos(position.longitude_rad);
                let up = [cos * cos_l, cos * sin_l, sin];
                let tilt = local
                    .up
                    .iter()
                    .zip(up)
                    .map(|(a, b)| (a - b).abs())
                    .fold(0.0, f64::max);
                assert!(tilt < 1e-6, "{name} {position:?}: {tilt:e} rad");
            }
        }
    }

    #[test]
    fn on_a_sphere_the_height_is_the_distance_less_the_radius() {
        let local = SPHERE.local([3_000_000.0, -4_000_000.0, 12_000_000.0]);
        // 13 000 000 − 6 051 800; two units in the last place of the distance
        assert!((local.altitude_m - 6_948_200.0).abs() < 4e-9);
        assert!((local.up[2] - 12.0 / 13.0).abs() < 2e-16);
    }
}
