//! Speeds and angles in the local geodetic horizon, relative to the planet and inertial.
//!
//! ```text
//! v  = V (cos γ cos ψ n̂ + cos γ sin ψ ê + sin γ û)
//! ê  = ẑ × û / |ẑ × û|,  n̂ = û × ê
//! vᵢ = v + ω ẑ × r
//! ```
//!
//! with V in m/s, γ the flight-path angle against the geodetic horizon (negative down) and ψ the azimuth from north,
//! clockwise, in rad; û the geodetic vertical, ω the rotation rate in rad/s, r in m. Inertial velocities are given in
//! the axes of the planet at the same instant.
//!
//! # Valid
//! Everywhere; on the axis itself, where every direction is south or north, east is that of the meridian of longitude
//! zero. A start at a pole has the meridian of its longitude: its distance from the axis is tiny, but not zero.
//!
//! # References
//! - \[vinh-1980\] chapter 2; the horizon is geodetic as in \[samareh-2014\] section 3.2.

use super::Planet;
use nalgebra::Vector3;
use numerics::math::PI;
use numerics::scalar::Scalar;
use serde::{Deserialize, Serialize};

/// A velocity as entry analysts write it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Velocity<S> {
    /// Speed, m/s.
    pub speed_m_s: S,
    /// Flight-path angle against the geodetic horizon, negative down, rad.
    pub flight_path_angle_rad: S,
    /// Azimuth from north, clockwise, rad, in 0…2π.
    pub azimuth_rad: S,
}

/// Unit vectors of the local horizon in planet-fixed axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Horizon<S> {
    /// North.
    pub north: [S; 3],
    /// East.
    pub east: [S; 3],
    /// Geodetic vertical.
    pub up: [S; 3],
}

/// Below this cosine of the latitude a position counts as on the axis: its square would vanish.
const POLE: f64 = 1e-150;

impl<S: Scalar> Horizon<S> {
    /// The horizon that belongs to a vertical.
    #[inline]
    pub fn new(up: [S; 3]) -> Self {
        let [x, y, z] = up;
        let cos_latitude = (x * x + y * y).sqrt();
        let pole = cos_latitude.less(S::constant(POLE));
        let scale = S::constant(1.0) / S::select(pole, S::constant(1.0), cos_latitude);
        let east_x = S::select(pole, S::constant(0.0), -y * scale);
        let east_y = S::select(pole, S::constant(1.0), x * scale);
        let north = [-z * east_y, z * east_x, x * east_y - y * east_x];
        Self {
            north,
            east: [east_x, east_y, S::constant(0.0)],
            up,
        }
    }

    /// North, east and up parts of a planet-fixed vector, in its unit.
    #[inline]
    pub fn parts(&self, vector: [S; 3]) -> [S; 3] {
        let vector = Vector3::from(vector);
        [self.north, self.east, self.up].map(|axis| Vector3::from(axis).dot(&vector))
    }

    /// Planet-fixed vector of its north, east and up parts, in their unit.
    #[inline]
    pub fn vector(&self, [north, east, up]: [S; 3]) -> [S; 3] {
        let along = |i: usize| self.north[i] * north + self.east[i] * east + self.up[i] * up;
        [along(0), along(1), along(2)]
    }

    /// Planet-fixed components of a velocity, m/s.
    pub fn cartesian_m_s(&self, velocity: &Velocity<S>) -> [S; 3] {
        let Velocity {
            speed_m_s: v,
            flight_path_angle_rad: gamma,
            azimuth_rad: psi,
        } = *velocity;
        let level = v * gamma.cos();
        self.vector([level * psi.cos(), level * psi.sin(), v * gamma.sin()])
    }

    /// Speed and angles of planet-fixed components, m/s; at rest both angles are zero.
    pub fn velocity(&self, cartesian_m_s: [S; 3]) -> Velocity<S> {
        let [north, east, up] = self.parts(cartesian_m_s);
        let level = (north * north + east * east).sqrt();
        let psi = east.atan2(north);
        Velocity {
            speed_m_s: (level * level + up * up).sqrt(),
            flight_path_angle_rad: up.atan2(level),
            azimuth_rad: S::select(psi.less(S::constant(0.0)), psi + 2.0 * PI, psi),
        }
    }
}

impl Planet {
    /// The horizon at planet-fixed coordinates, m.
    #[inline]
    pub fn horizon<S: Scalar>(&self, r: [S; 3]) -> Horizon<S> {
        Horizon::new(self.local(r).up)
    }

    /// Velocity of the rotating planet at planet-fixed coordinates, m/s.
    #[inline]
    pub fn rotation_m_s<S: Scalar>(&self, r: [S; 3]) -> [S; 3] {
        let omega = self.rotation_rate_rad_s;
        [-r[1] * omega, r[0] * omega, S::constant(0.0)]
    }

    /// Inertial velocity, m/s, of a velocity relative to the planet, m/s, at coordinates in m.
    #[inline]
    pub fn inertial_m_s<S: Scalar>(&self, r: [S; 3], relative_m_s: [S; 3]) -> [S; 3] {
        let [x, y, z] = self.rotation_m_s(r);
        [
            relative_m_s[0] + x,
            relative_m_s[1] + y,
            relative_m_s[2] + z,
        ]
    }

    /// Velocity relative to the planet, m/s, of an inertial velocity, m/s, at coordinates in m.
    #[inline]
    pub fn relative_m_s<S: Scalar>(&self, r: [S; 3], inertial_m_s: [S; 3]) -> [S; 3] {
        let [x, y, z] = self.rotation_m_s(r);
        [
            inertial_m_s[0] - x,
            inertial_m_s[1] - y,
            inertial_m_s[2] - z,
        ]
    }

    /// Inertial speed and angles of an entry state given relative to the planet, at coordinates in m.
    pub fn inertial_from_relative<S: Scalar>(
        &self,
        r: [S; 3],
        relative: &Velocity<S>,
    ) -> Velocity<S> {
        let horizon = self.horizon(r);
        horizon.velocity(self.inertial_m_s(r, horizon.cartesian_m_s(relative)))
    }

    /// Speed and angles relative to the planet of an inertial entry state, at coordinates in m.
    pub fn relative_from_inertial<S: Scalar>(
        &self,
        r: [S; 3],
        inertial: &Velocity<S>,
    ) -> Velocity<S> {
        let horizon = self.horizon(r);
        horizon.velocity(self.relative_m_s(r, horizon.cartesian_m_s(inertial)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::planet::geodetic::Geodetic;
    use numerics::math::RADIANS_PER_DEGREE as DEG;

    fn earth() -> Planet {
        Planet::parse(include_str!("../../data/planets/earth-msape.toml").into()).unwrap()
    }

    fn interface(planet: &Planet) -> [f64; 3] {
        planet.cartesian_m(&Geodetic {
            altitude_m: 125e3,
            latitude_rad: 33.0 * DEG,
            longitude_rad: 246.3833 * DEG,
        })
    }

    #[test]
    fn inertial_speeds_of_an_independent_integrator() {
        // Its figures have four and three decimals.
        let planet = earth();
        for (speed_m_s, gamma, psi, inertial, digit) in [
            (12_000.0, -8.0, 0.0, 12_006.601_5, 1e-4),
            (12_000.0, -8.0, 90.0, 12_394.344_9, 1e-4),
            (11_560.0, -25.0, 90.0, 11_921.984, 1e-3),
        ] {
            let relative = Velocity {
                speed_m_s,
                flight_path_angle_rad: gamma * DEG,
                azimuth_rad: psi * DEG,
            };
            let ours = planet.inertial_from_relative(interface(&planet), &relative);
            assert!(
                (ours.speed_m_s - inertial).abs() < digit,
                "{}",
                ours.speed_m_s
            );
        }
    }

    #[test]
    fn inertial_and_back() {
        let planet = earth();
        for psi in [0.1, 1.6, 3.2, 6.1] {
            let relative = Velocity {
                speed_m_s: 7_800.0,
                flight_path_angle_rad: -0.2,
                azimuth_rad: psi,
            };
            let r = interface(&planet);
            let back =
                planet.relative_from_inertial(r, &planet.inertial_from_relative(r, &relative));
            assert!((back.speed_m_s - 7_800.0).abs() < 1e-11);
            assert!((back.flight_path_angle_rad + 0.2).abs() < 1e-14);
            assert!((back.azimuth_rad - psi).abs() < 1e-14);
        }
    }

    #[test]
    fn over_the_equator_east_is_y_and_north_is_z() {
        let horizon = Horizon::new([1.0, 0.0, 0.0]);
        assert_eq!(
            (horizon.east, horizon.north),
            ([0.0, 1.0, 0.0], [0.0, 0.0, 1.0])
        );
        // 5 m/s, azimuth 90°: 3-4-5 with 3 m/s down
        let v = horizon.velocity([-3.0, 4.0, 0.0]);
        assert_eq!(v.speed_m_s, 5.0);
        assert!((v.flight_path_angle_rad - numerics::math::atan2(-3.0, 4.0)).abs() < 1e-16);
        assert_eq!(v.azimuth_rad, numerics::math::FRAC_PI_2);
    }

    #[test]
    fn at_the_pole_and_at_rest_everything_is_finite() {
        let horizon = Horizon::new([0.0, 0.0, 1.0]);
        assert_eq!(
            (horizon.east, horizon.north),
            ([0.0, 1.0, 0.0], [-1.0, 0.0, 0.0])
        );
        let rest = horizon.velocity([0.0; 3]);
        assert_eq!(
            (rest.speed_m_s, rest.flight_path_angle_rad, rest.azimuth_rad),
            (0.0, 0.0, 0.0)
        );
    }
}
