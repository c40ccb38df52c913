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

use super::held::Held;
use super::mission::{Body, Mission};
use super::numbers::Numbers;
use super::phase::{Change, Changed};
use super::reach::Arguments;
use super::within::Within;
use crate::aero::{Drag, DragTable};
use crate::heating::{Flow, HeatFlux};
use crate::planet::atmosphere::Air;
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

/// Surroundings of the vehicle at one state.
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

/// Equations of motion of one vehicle, or one per lane, with the table rows that hold for each.
#[derive(Clone, Copy)]
pub struct Equations<'a, S: Scalar = f64> {
    /// Planet, atmosphere, wind, heating.
    pub mission: &'a Mission,
    /// The vehicle, for what is the same in every lane: kind of drag and lift.
    pub body: &'a Body,
    /// Figure of the planet.
    pub ellipsoid: Ellipsoid,
    held: Held<S::Value>,
    numbers: Numbers<S>,
    /// Changes made by the phases begun so far, apart from the numbers.
    changed: Changed<S>,
    /// Number of phases so far, of one lane.
    phase: usize,
    /// A/(2 m), m²/kg.
    half_area_over_mass: S,
}

impl<'a> Equations<'a> {
    /// The equations with the numbers of the mission and the vehicle, by the rows at rest on the ground.
    pub fn new(mission: &'a Mission, body: &'a Body) -> Self {
        Self::with_numbers(mission, body, Numbers::of(mission, body))
    }
}

impl<'a, S: Scalar> Equations<'a, S> {
    /// The equations with the given numbers, by the rows at rest on the ground.
    pub fn with_numbers(mission: &'a Mission, body: &'a Body, numbers: Numbers<S>) -> Self {
        let at_rest = Held::of(mission, body, &Within::REST);
        Self::with_rows(mission, body, numbers, &at_rest)
    }

    fn with_rows(
        mission: &'a Mission,
        body: &'a Body,
        numbers: Numbers<S>,
        held: &Held<f64>,
    ) -> Self {
        Equations {
            mission,
            body,
            ellipsoid: mission.planet.ellipsoid(),
            held: Held::everywhere(held),
            half_area_over_mass: numbers.reference_area_m2 * 0.5 / numbers.mass_kg,
            changed: Changed::nothing(),
            phase: 0,
            numbers,
        }
    }

    /// The equations of one lane in every lane.
    pub fn everywhere(of: &Equations<'a, S::Lane>) -> Self {
        let numbers = Numbers::everywhere(&of.numbers);
        let mut all = Self::with_rows(of.mission, of.body, numbers, &of.held.lane(0));
        (0..S::LANES).for_each(|lane| all.set_lane_numbers(lane, of));
        all
    }

    /// Replaces the equations of one lane.
    pub fn set_lane(&mut self, lane: usize, of: &Equations<'a, S::Lane>) {
        self.set_lane_numbers(lane, of);
        self.set_lane_state(lane, of);
    }

    fn set_lane_numbers(&mut self, lane: usize, of: &Equations<'a, S::Lane>) {
        self.numbers.set_lane(lane, &of.numbers);
        self.changed.set_lane(lane, &of.changed);
        self.half_area_over_mass
            .set_lane(lane, of.half_area_over_mass);
    }

    /// Replaces the rows that hold and the phase of one lane.
    pub fn set_lane_state(&mut self, lane: usize, of: &Equations<'a, S::Lane>) {
        self.held.set_lane(lane, &of.held.lane(0));
        if !self.mission.phases.is_empty() {
            self.set_lane_numbers(lane, of);
        }
    }

    /// Continues by the rows about a place, in every lane.
    #[inline]
    pub fn hold(&mut self, within: &Within) {
        self.held = Held::everywhere(&Held::of(self.mission, self.body, within));
    }

    /// The rows that hold.
    #[inline]
    pub fn held(&self) -> &Held<S::Value> {
        &self.held
    }

    /// A phase that begins at a time, s.
    pub fn change(&mut self, change: &Change, t: S) {
        self.phase += 1;
        let numbers = &mut self.numbers;
        let replace = |number: &mut S, by: Option<f64>| {
            if let Some(by) = by {
                *number = S::constant(by);
            }
        };
        replace(&mut numbers.mass_kg, change.mass_kg);
        replace(&mut numbers.reference_area_m2, change.reference_area_m2);
        replace(&mut numbers.drag_coefficient, change.drag_coefficient);
        if change.drag_coefficient.is_some() {
            self.changed.constant_drag = S::constant(1.0);
        }
        if let Some(canopy) = change.canopy {
            self.changed.canopy_m2 = S::constant(canopy.drag_area_m2);
            // A parachute that inflates at once is full by now.
            (self.changed.canopy_since_s, self.changed.inflation_s) = match canopy.inflation_s {
                0.0 => (t - 1.0, S::constant(1.0)),
                inflation_s => (t, S::constant(inflation_s)),
            };
            self.changed.attachment_m = canopy.attachment_m.map(S::constant);
        }
        self.half_area_over_mass = numbers.reference_area_m2 * 0.5 / numbers.mass_kg;
    }

    /// Changes made by the phases begun so far, apart from the numbers.
    #[inline]
    pub fn changed(&self) -> &Changed<S> {
        &self.changed
    }

    /// Number of phases so far.
    pub fn phase(&self) -> usize {
        self.phase
    }

    /// Whether there are phases.
    #[inline]
    pub fn is_phased(&self) -> bool {
        !self.mission.phases.is_empty()
    }

    /// Drag of the parachute over mass and speed, 1/s.
    #[inline]
    pub fn canopy_rate(&self, around: &Surroundings<S>, t: S) -> S {
        around.density_kg_m3 * around.air_speed_m_s * self.changed.canopy_m2(t) * 0.5
            / self.numbers.mass_kg
    }

    /// The numbers of the flight.
    #[inline]
    pub fn numbers(&self) -> &Numbers<S> {
        &self.numbers
    }

    /// Surroundings of the vehicle.
    #[inline]
    pub fn surroundings(&self, y: &[S; STATES]) -> Surroundings<S> {
        let [x_m, y_m, z_m, vx, vy, vz, ..] = *y;
        let local = self.ellipsoid.local([x_m, y_m, z_m]);
        let density_kg_m3 = self
            .mission
            .atmosphere
            .density_in(&self.held.piece, local.altitude_m)
            * self.numbers.density_factor;
        let air_velocity_m_s = match &self.mission.wind {
            Wind::Calm => [vx, vy, vz],
            _ => {
                let row = self.held.wind.map(S::from_value);
                let [east_m_s, north_m_s] = Wind::east_north_m_s(row, local.altitude_m)
                    .map(|wind| wind * self.numbers.wind_factor);
                let calm = S::constant(0.0);
                let [wx, wy, wz] = Horizon::new(local.up).vector([north_m_s, east_m_s, calm]);
                [vx - wx, vy - wy, vz - wz]
            }
        };
        let [ux, uy, uz] = air_velocity_m_s;
        let air_speed_m_s = (ux * ux + uy * uy + uz * uz).sqrt();
        let drag_coefficient = match &self.body.drag {
            Drag::Constant(_) => self.numbers.drag_coefficient,
            Drag::Table(_) => {
                let line = self.held.drag.map(S::from_value);
                let mach = air_speed_m_s / self.sound_m_s(local.altitude_m);
                let by_table = DragTable::by_line(line, mach);
                if self.is_phased() {
                    let constant = self.changed.constant_drag;
                    let rest = S::constant(1.0) - constant;
                    self.numbers.drag_coefficient * constant + by_table * rest
                } else {
                    by_table
                }
            }
        };
        Surroundings {
            altitude_m: local.altitude_m,
            up: local.up,
            density_kg_m3,
            air_velocity_m_s,
            air_speed_m_s,
            drag_coefficient: drag_coefficient * self.numbers.drag_factor,
        }
    }

    /// Speed of sound at an altitude, m, in m/s.
    #[inline]
    pub fn sound_m_s(&self, altitude_m: S) -> S {
        self.mission
            .atmosphere
            .speed_of_sound_in(&self.held.piece, altitude_m)
    }

    /// The air at an altitude, m, its density, pressure and mean free path those of the flight.
    #[inline]
    pub fn air(&self, altitude_m: S) -> Air<S> {
        let factor = self.numbers.density_factor;
        let air = self.mission.atmosphere.air_in(&self.held.piece, altitude_m);
        Air {
            density_kg_m3: air.density_kg_m3 * factor,
            pressure_pa: air.pressure_pa * factor,
            mean_free_path_m: air.mean_free_path_m / factor,
            ..air
        }
    }

    /// Drag over mass and speed, 1/s: ρ C_D A |u| / (2 m).
    #[inline]
    pub fn drag_rate(&self, around: &Surroundings<S>) -> S {
        around.density_kg_m3
            * around.air_speed_m_s
            * around.drag_coefficient
            * self.half_area_over_mass
    }

    /// Half the reference area over mass, m²/kg.
    #[inline]
    pub fn half_area_over_mass_m2_kg(&self) -> S {
        self.half_area_over_mass
    }

    /// Mean free path over the length of the body.
    pub fn knudsen(&self, around: &Surroundings<S>) -> S {
        self.air(around.altitude_m).mean_free_path_m / self.numbers.reference_length_m
    }

    /// Arguments of table look-ups, in the order of [`super::reach::Argument`].
    pub fn arguments(
        &self,
        t: S,
        around: &Surroundings<S>,
        total_alpha_rad: S,
        knudsen: S,
    ) -> Arguments<S> {
        let speed_m_s = around.air_speed_m_s;
        [
            around.altitude_m,
            speed_m_s,
            speed_m_s / self.sound_m_s(around.altitude_m),
            t,
            total_alpha_rad,
            knudsen,
            around.density_kg_m3,
        ]
    }

    /// The flow that heats, with rows and branches of heating chosen by the rows that hold.
    #[inline]
    pub fn flow(&self, around: &Surroundings<S>) -> Flow<S> {
        Flow {
            chosen_by_m_s: S::from_value(self.held.speed_m_s),
            density_kg_m3: around.density_kg_m3,
            speed_m_s: around.air_speed_m_s,
            nose_radius_m: self.numbers.nose_radius_m,
        }
    }

    /// Heat fluxes at the stagnation point without margins.
    #[inline]
    pub fn heat_flux(&self, around: &Surroundings<S>) -> HeatFlux<S> {
        self.with_factors(self.mission.heating.heat_flux(&self.flow(around)))
    }

    /// Heat fluxes with the factors of the flight.
    #[inline]
    pub fn with_factors(&self, flux: HeatFlux<S>) -> HeatFlux<S> {
        HeatFlux {
            convective_w_m2: flux.convective_w_m2 * self.numbers.convective_factor,
            radiative_w_m2: flux.radiative_w_m2 * self.numbers.radiative_factor,
        }
    }

    /// The derivative of the state under an aerodynamic force over mass, planet-fixed axes, m/s².
    #[inline]
    pub fn moved_by(
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
