//! Equations of motion of a point mass, relative to the rotating planet.
//!
//! ```text
//! dr/dt = v
//! dv/dt = g(r) - ρ C_D A/(2 m) |u| u + a_L - 2 ω×v - ω×(ω×r)
//! dQ/dt = q̇
//! ```
//!
//! with r, v position (m) and velocity (m/s) in planet-fixed axes (z along the pole), u = v − wind the velocity relative
//! to the air, ρ in kg/m³, A in m², m in kg, ω in rad/s, Q the convective and radiative heat loads in J/m², a_L the lift
//! over mass of [`super::lift`] in m/s², where there is one.
//!
//! # Valid
//! The atmosphere rotates with the planet.
//!
//! # References
//! - \[samareh-2014\] section 3.2.

use super::mission::{Body, Mission};
use crate::aero::Drag;
use crate::heating::{Flow, HeatFlux};
use crate::planet::geodetic::Ellipsoid;
use crate::planet::horizon::Horizon;
use crate::planet::wind::Wind;
use numerics::scalar::Scalar;

/// Number of components of the state: position, velocity, two heat loads.
pub const STATES: usize = 8;
/// Index of the convective heat load in the state.
pub const CONVECTIVE: usize = 6;
/// Index of the radiative heat load in the state.
pub const RADIATIVE: usize = 7;

/// What surrounds the vehicle at one state.
#[derive(Clone, Copy, Debug)]
pub struct Surroundings<S> {
    /// Geodetic altitude, m.
    pub altitude_m: S,
    /// Geodetic vertical, unit vector.
    pub up: [S; 3],
    /// Density, kg/m³.
    pub density_kg_m3: S,
    /// Velocity relative to the air, m/s.
    pub air_velocity_m_s: [S; 3],
    /// Speed relative to the air, m/s.
    pub air_speed_m_s: S,
    /// Drag coefficient.
    pub drag_coefficient: S,
}

/// The equations for one vehicle, within one smooth piece of the atmosphere.
#[derive(Clone, Copy)]
pub struct Equations<'a> {
    /// Planet, atmosphere, wind, heating.
    pub mission: &'a Mission,
    /// The vehicle.
    pub body: &'a Body,
    /// Piece of the atmosphere that is continued smoothly.
    pub layer: usize,
    /// Figure of the planet.
    pub ellipsoid: Ellipsoid,
    /// How radiative heating is computed.
    pub radiation: Radiation,
}

/// How radiative heating is computed; the relations end at once below a speed, which the integrator meets with the end
/// of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Radiation {
    /// By the relation.
    Exact,
    /// With at least this speed, m/s: continued smoothly beyond the end of the relation, for the stages of a step.
    Continued(f64),
    /// Not at all: the vehicle is slower than the relation reaches down.
    Over,
}

impl<'a> Equations<'a> {
    /// The equations within one piece of the atmosphere.
    pub fn new(mission: &'a Mission, body: &'a Body, layer: usize) -> Self {
        Equations {
            mission,
            body,
            layer,
            ellipsoid: mission.planet.ellipsoid(),
            radiation: Radiation::Exact,
        }
    }

    /// What surrounds the vehicle.
    #[inline]
    pub fn surroundings<S: Scalar>(&self, y: &[S; STATES]) -> Surroundings<S> {
        let [x_m, y_m, z_m, vx, vy, vz, ..] = *y;
        let local = self.ellipsoid.local([x_m, y_m, z_m]);
        let density_kg_m3 = self
            .mission
            .atmosphere
            .density_in(self.layer, local.altitude_m);
        let air_velocity_m_s = match &self.mission.wind {
            Wind::Calm => [vx, vy, vz],
            wind => {
                let [east_m_s, north_m_s] = wind.east_north_m_s(local.altitude_m);
                let calm = S::constant(0.0);
                let [wx, wy, wz] = Horizon::new(local.up).vector([north_m_s, east_m_s, calm]);
                [vx - wx, vy - wy, vz - wz]
            }
        };
        let [ux, uy, uz] = air_velocity_m_s;
        let air_speed_m_s = (ux * ux + uy * uy + uz * uz).sqrt();
        let drag_coefficient = match &self.body.drag {
            Drag::Constant(coefficient) => S::constant(*coefficient),
            Drag::Table(table) => {
                let sound = self
                    .mission
                    .atmosphere
                    .speed_of_sound_in(self.layer, local.altitude_m);
                table.at(air_speed_m_s / sound)
            }
        };
        Surroundings {
            altitude_m: local.altitude_m,
            up: local.up,
            density_kg_m3,
            air_velocity_m_s,
            air_speed_m_s,
            drag_coefficient,
        }
    }

    /// Drag over mass and speed, 1/s: ρ C_D A |u| / (2 m).
    #[inline]
    pub fn drag_rate<S: Scalar>(&self, around: &Surroundings<S>) -> S {
        let area_over_mass = 0.5 * self.body.reference_area_m2 / self.body.mass_kg;
        around.density_kg_m3 * around.air_speed_m_s * around.drag_coefficient * area_over_mass
    }

    /// Mean free path over the length of the body.
    pub fn knudsen(&self, around: &Surroundings<f64>) -> f64 {
        let air = self
            .mission
            .atmosphere
            .air_in(self.layer, around.altitude_m);
        air.mean_free_path_m / self.body.reference_length_m
    }

    /// Heat fluxes at the stagnation point without margins.
    #[inline]
    pub fn heat_flux<S: Scalar>(&self, around: &Surroundings<S>) -> HeatFlux<S> {
        let flow = Flow {
            density_kg_m3: around.density_kg_m3,
            speed_m_s: around.air_speed_m_s,
            nose_radius_m: self.body.nose_radius_m,
        };
        match self.radiation {
            Radiation::Exact => self.mission.heating.heat_flux(&flow),
            Radiation::Continued(least_m_s) => self.mission.heating.continued(&flow, least_m_s),
            Radiation::Over => self.mission.heating.without_radiation(&flow),
        }
    }

    /// The derivative of the state of a point mass with drag alone.
    #[inline]
    pub fn derivative<S: Scalar>(&self, y: &[S; STATES]) -> [S; STATES] {
        let around = self.surroundings(y);
        let rate = self.drag_rate(&around);
        let [ux, uy, uz] = around.air_velocity_m_s;
        self.moved_by(y, &around, [-(rate * ux), -(rate * uy), -(rate * uz)])
    }

    /// The derivative of the state under an aerodynamic force over mass, planet-fixed axes, m/s².
    #[inline]
    pub fn moved_by<S: Scalar>(
        &self,
        y: &[S; STATES],
        around: &Surroundings<S>,
        [ax, ay, az]: [S; 3],
    ) -> [S; STATES] {
        let [x_m, y_m, z_m, vx, vy, vz, ..] = *y;
        let [gx, gy, gz] = self.mission.planet.gravity([x_m, y_m, z_m]);
        let omega = self.mission.planet.rotation_rate_rad_s;
        let heat_flux = self.heat_flux(around);
        [
            vx,
            vy,
            vz,
            gx + ax + vy * (2.0 * omega) + x_m * (omega * omega),
            gy + ay - vx * (2.0 * omega) + y_m * (omega * omega),
            gz + az,
            heat_flux.convective_w_m2,
            heat_flux.radiative_w_m2,
        ]
    }
}
