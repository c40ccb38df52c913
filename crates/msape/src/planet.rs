//! A planet: figure, rotation, gravity; with its atmosphere and winds.
//!
//! ```text
//! x, y in the equator (x through longitude zero), z along the pole, planet-centered and turning with it
//! ```
//!
//! with lengths in m, rates in rad/s, accelerations in m/s².
//!
//! # Valid
//! Ellipsoids of revolution; each model names its own range.
//!
//! # References
//! - \[samareh-2014\] section 3.2; each data file names its own.

pub mod atmosphere;
pub mod gas;
pub mod geodesic;
pub mod geodetic;
pub mod gravity;
pub mod horizon;
pub mod rows;
pub mod wind;

use crate::data::Data;
use atmosphere::Atmosphere;
use geodetic::{Ellipsoid, Geodetic, Local};
pub use gravity::Gravity;
use numerics::scalar::Scalar;
use serde::{Deserialize, Serialize};
use thiserror::Error;

/// A planet without its air.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Planet {
    /// Key under which a case names it.
    #[serde(default)]
    pub name: String,
    /// Name for people.
    #[serde(default)]
    pub title: String,
    /// Key in the bibliography, of figure and rotation.
    #[serde(default)]
    pub source: String,
    /// Place in the source.
    #[serde(default)]
    pub place: String,
    /// Key in the bibliography, of the gravity; empty where it is that of the figure.
    #[serde(default)]
    pub gravity_source: String,
    /// Note on the figures.
    #[serde(default)]
    pub note: String,
    /// Equatorial radius, m.
    pub equatorial_radius_m: f64,
    /// Polar radius, m.
    pub polar_radius_m: f64,
    /// Rate of rotation, negative where retrograde, rad/s.
    pub rotation_rate_rad_s: f64,
    /// Customary altitude of the entry interface, m.
    pub entry_interface_m: f64,
    /// Name of its own atmosphere.
    pub atmosphere: String,
    /// Name of the planet whose heating relations it takes, where they do not name it.
    #[serde(default)]
    pub heating_as: Option<String>,
    /// Lowest altitude at which a flight may end, m: of its surface, or where its atmosphere is no longer known.
    pub lowest_altitude_m: f64,
    /// Altitudes through whose densities the closed form lays its exponential, m.
    pub exponential_fit_m: [f64; 2],
    /// Radius of the sphere on which downrange is measured, m; on the ellipsoid where absent.
    #[serde(default)]
    pub downrange_sphere_radius_m: Option<f64>,
    /// Name of the body in KML, where viewers have it.
    #[serde(default)]
    pub kml_target: Option<String>,
    /// Gravity.
    pub gravity: Gravity,
}

/// One thing wrong with the constants of a planet.
#[derive(Clone, Debug, PartialEq, Error)]
#[error("{key}: got {value} {unit}, must be {rule}")]
pub struct PlanetFault {
    /// Key of the constant.
    pub key: &'static str,
    /// Value given.
    pub value: f64,
    /// Unit.
    pub unit: &'static str,
    /// Rule that it breaks.
    pub rule: &'static str,
}

impl Planet {
    /// The planet of a data file.
    pub fn parse(data: Data) -> Result<Self, String> {
        let planet: Self = data.read()?;
        match planet.check().first() {
            None => Ok(planet),
            Some(fault) => Err(fault.to_string()),
        }
    }

    /// All faults of the constants.
    pub fn check(&self) -> Vec<PlanetFault> {
        let mut faults = Vec::new();
        let mut must = |holds: bool, key, value, unit, rule| {
            if !holds {
                faults.push(PlanetFault {
                    key,
                    value,
                    unit,
                    rule,
                });
            }
        };
        let positive = |value: f64| value > 0.0 && value.is_finite();
        const POSITIVE: &str = "above 0 and finite";
        let (a, b) = (self.equatorial_radius_m, self.polar_radius_m);
        must(positive(a), "equatorial_radius_m", a, "m", POSITIVE);
        must(positive(b), "polar_radius_m", b, "m", POSITIVE);
        let round = (0.5..=1.0).contains(&(b / a)) || !positive(a) || !positive(b);
        must(
            round,
            "polar_radius_m",
            b,
            "m",
            "between half the equatorial radius and all of it",
        );
        must(
            self.rotation_rate_rad_s.is_finite(),
            "rotation_rate_rad_s",
            self.rotation_rate_rad_s,
            "rad/s",
            "finite",
        );
        must(
            positive(self.entry_interface_m),
            "entry_interface_m",
            self.entry_interface_m,
            "m",
            POSITIVE,
        );
        let [low_m, high_m] = self.exponential_fit_m;
        must(
            low_m < high_m && (high_m - low_m).is_finite(),
            "exponential_fit_m",
            low_m,
            "m",
            "below the second altitude",
        );
        let lowest_m = self.lowest_altitude_m;
        must(
            lowest_m <= 0.0 && lowest_m.is_finite(),
            "lowest_altitude_m",
            lowest_m,
            "m",
            "0 or below, and finite",
        );
        let sphere_m = self.downrange_sphere_radius_m.unwrap_or(a);
        must(
            positive(sphere_m) || !positive(a),
            "downrange_sphere_radius_m",
            sphere_m,
            "m",
            POSITIVE,
        );
        match self.gravity {
            Gravity::Zonal {
                mu_m3_s2,
                j2,
                j3,
                j4,
                reference_radius_m,
            } => {
                must(
                    positive(mu_m3_s2),
                    "gravity.mu_m3_s2",
                    mu_m3_s2,
                    "m³/s²",
                    POSITIVE,
                );
                must(
                    positive(reference_radius_m),
                    "gravity.reference_radius_m",
                    reference_radius_m,
                    "m",
                    POSITIVE,
                );
                for (key, value) in [("gravity.j2", j2), ("gravity.j3", j3), ("gravity.j4", j4)] {
                    must(value.abs() < 0.1, key, value, "", "between -0.1 and 0.1");
                }
            }
            Gravity::Uniform {
                acceleration_m_s2: g,
            } => {
                must(
                    g >= 0.0 && g.is_finite(),
                    "gravity.acceleration_m_s2",
                    g,
                    "m/s²",
                    "0 or above, and finite",
                );
            }
        }
        faults
    }

    /// Acceleration of gravity at planet-fixed coordinates, m, in m/s².
    #[inline]
    pub fn gravity<S: Scalar>(&self, r: [S; 3]) -> [S; 3] {
        self.gravity.acceleration_m_s2(r)
    }

    /// Acceleration of a body let go at planet-fixed coordinates, m, in m/s²: attraction less the centrifugal part.
    pub fn effective_gravity<S: Scalar>(&self, r: [S; 3]) -> [S; 3] {
        let [x, y, z] = self.gravity(r);
        let omega_2 = self.rotation_rate_rad_s * self.rotation_rate_rad_s;
        // g − ω × (ω × r)
        [x + r[0] * omega_2, y + r[1] * omega_2, z]
    }

    /// Ratio of the heat capacities of the air where vehicles are slowed, at the lower altitude of the closed form.
    pub fn heat_capacity_ratio(&self, atmosphere: &Atmosphere) -> f64 {
        let [altitude_m, _] = self.exponential_fit_m;
        atmosphere.air(altitude_m).heat_capacity_ratio
    }

    /// The figure.
    #[inline]
    pub fn ellipsoid(&self) -> Ellipsoid {
        Ellipsoid::new(self.equatorial_radius_m, self.polar_radius_m)
    }

    /// Height and vertical at planet-fixed coordinates, m; the fast form.
    #[inline]
    pub fn local<S: Scalar>(&self, r: [S; 3]) -> Local<S> {
        self.ellipsoid().local(r)
    }

    /// Geodetic position of planet-fixed coordinates, m.
    pub fn geodetic<S: Scalar>(&self, r: [S; 3]) -> Geodetic<S> {
        self.ellipsoid().geodetic(r)
    }

    /// Planet-fixed coordinates of a geodetic position, m.
    pub fn cartesian_m<S: Scalar>(&self, position: &Geodetic<S>) -> [S; 3] {
        self.ellipsoid().cartesian_m(position)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FILES: [(&str, &str); 9] = [
        (
            "earth-msape",
            include_str!("../data/planets/earth-msape.toml"),
        ),
        ("earth", include_str!("../data/planets/earth.toml")),
        ("venus", include_str!("../data/planets/venus.toml")),
        ("mars", include_str!("../data/planets/mars.toml")),
        ("titan", include_str!("../data/planets/titan.toml")),
        ("jupiter", include_str!("../data/planets/jupiter.toml")),
        ("saturn", include_str!("../data/planets/saturn.toml")),
        ("uranus", include_str!("../data/planets/uranus.toml")),
        ("neptune", include_str!("../data/planets/neptune.toml")),
    ];

    #[test]
    fn every_file_reads_and_is_named_after_itself_and_has_a_source() {
        let bibliography = include_str!("../data/references.bib");
        for (name, text) in FILES {
            let planet = Planet::parse(text.into()).unwrap();
            assert_eq!(planet.name, name);
            for source in [&planet.source, &planet.gravity_source] {
                assert!(
                    bibliography.contains(&format!("{{{source},")),
                    "{name}: {source}"
                );
            }
        }
    }

    #[test]
    fn gravity_and_rotation_at_the_equator_make_the_known_weight() {
        // Normal gravity of WGS84 at the equator is 9.7803253 m/s²; without J6 and the rest it is met to 1e-5.
        let earth = Planet::parse(FILES[1].1.into()).unwrap();
        let [g, ..] = earth.effective_gravity([earth.equatorial_radius_m, 0.0, 0.0]);
        assert!((g + 9.7803253).abs() < 2e-5, "{g}");
    }

    #[test]
    fn the_report_s_planet_is_the_report_s() {
        let planet = Planet::parse(FILES[0].1.into()).unwrap();
        assert_eq!(planet.equatorial_radius_m, 6378.1e3);
        assert_eq!(planet.polar_radius_m, 6356.8e3);
        let Gravity::Zonal {
            mu_m3_s2,
            j2,
            reference_radius_m,
            ..
        } = planet.gravity
        else {
            panic!("zonal")
        };
        assert_eq!(
            (mu_m3_s2, j2, reference_radius_m),
            (3.986e14, 1.0823e-3, 6378.1e3)
        );
    }

    #[test]
    fn all_faults_are_named() {
        let text = FILES[0]
            .1
            .replace("6378100.0\npolar", "-1.0\npolar")
            .replace("j2 = 1.0823e-3", "j2 = 1.0823");
        let planet: Planet = toml::from_str(&text).unwrap();
        let keys: Vec<&str> = planet.check().iter().map(|f| f.key).collect();
        assert_eq!(keys, ["equatorial_radius_m", "gravity.j2"]);
        assert!(
            Planet::parse(text.as_str().into())
                .unwrap_err()
                .contains("got -1 m")
        );
        assert!(Planet::parse("nonsense = 1".into()).is_err());
    }

    #[test]
    fn a_body_dropped_from_30000_ft_for_30_s() {
        // NASA/TM-2015-218675, check case 1: six programs agree on 15598.90 ft within 0.01 ft, 2.101 ft/s eastward,
        // 960.293 ft/s down. Theirs is J2 only: J4 and J3 change the fall by 2e-6 of 14401 ft, 0.03 ft.
        const FOOT: f64 = 0.3048;
        let earth = Planet::parse(FILES[1].1.into()).unwrap();
        let start = Geodetic {
            altitude_m: 30_000.0 * FOOT,
            latitude_rad: 0.0,
            longitude_rad: 0.0,
        };
        let mut r = earth.cartesian_m(&start);
        let mut v = earth.inertial_m_s(r, [0.0; 3]);
        let add =
            |a: [f64; 3], b: [f64; 3], h: f64| [a[0] + h * b[0], a[1] + h * b[1], a[2] + h * b[2]];
        // The axes of the start, not turning: gravity is the same about the pole. Nyström's form of Runge-Kutta.
        let h = 0.5;
        for _ in 0..60 {
            let a_1 = earth.gravity(r);
            let a_2 = earth.gravity(add(add(r, v, h / 2.0), a_1, h * h / 8.0));
            let a_3 = earth.gravity(add(add(r, v, h), a_2, h * h / 2.0));
            r = add(add(add(r, v, h), a_1, h * h / 6.0), a_2, h * h / 3.0);
            v = add(add(add(v, a_1, h / 6.0), a_2, h * 2.0 / 3.0), a_3, h / 6.0);
        }
        let relative = earth.horizon(r).parts(earth.relative_m_s(r, v));
        let altitude_ft = earth.geodetic(r).altitude_m / FOOT;
        assert!((altitude_ft - 15_598.904).abs() < 0.05, "{altitude_ft}");
        assert!(
            (relative[1] / FOOT - 2.101).abs() < 1e-3,
            "{}",
            relative[1] / FOOT
        );
        assert!(
            (relative[2] / FOOT + 960.293).abs() < 3e-3,
            "{}",
            relative[2] / FOOT
        );
    }
}
