//! Numbers of one flight: those that may differ from lane to lane, and with respect to which derivatives may be taken.
//!
//! ```text
//! ρ = f_ρ ρ(h),   C_D = f_D C_D(M),   w = f_w w(h),   q̇ = f_q q̇(ρ, V, Rₙ)
//! ```
//!
//! with factors f without unit, 1 where a case does not give them.
//!
//! # Valid
//! One planet, one atmosphere, one kind of drag and lift for all lanes.
//!
//! Derivatives exist except in isolated flights: with two peaks of equal height, with a nose radius at a cap of the
//! exponent of radiative heating (1 and 2 m), and with a peak on the row of a drag table, whose ballistic coefficient
//! has a kink there. A peak at the end of a row (onset of radiation) moves with it. Derivatives of the time and place
//! of a peak are by the interpolation within its step, less exact than a step; in the U.S. Standard Atmosphere they are
//! those of one cell of its table, 2e-5 beside the mean of neighbors, because the curvature jumps from cell to cell.
//! Where the exponent of radiative heating meets its cap, between densities of a table of heating, at rows of lift, bank angle
//! and coefficients of a body at an angle of attack, and at layers of a temperature that is lent to a table or an exponential,
//! no step ends: derivatives there have the error of a step across a kink, which falls with the tolerance.
//!
//! # References
//! - Own convention.

use super::mission::{Body, Mission, Start};
use crate::aero::Drag;
use crate::planet::Planet;
use crate::planet::geodetic::Geodetic;
use crate::planet::horizon::Velocity;
use numerics::scalar::Scalar;

/// Numbers of one flight, of one per lane, or with derivatives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Numbers<S = f64> {
    /// Entry state.
    pub start: Start<S>,
    /// Mass, kg.
    pub mass_kg: S,
    /// Reference area of the drag coefficient, m².
    pub reference_area_m2: S,
    /// Nose radius, m.
    pub nose_radius_m: S,
    /// Length of the Knudsen number, m.
    pub reference_length_m: S,
    /// Drag coefficient where it is the same at every Mach number.
    pub drag_coefficient: S,
    /// Factor on the drag coefficient.
    pub drag_factor: S,
    /// Factor on the density of the air.
    pub density_factor: S,
    /// Factor on the wind.
    pub wind_factor: S,
    /// Factor on convective heating.
    pub convective_factor: S,
    /// Factor on radiative heating.
    pub radiative_factor: S,
}

impl Numbers {
    /// The numbers of a mission and a vehicle.
    pub fn of(mission: &Mission, body: &Body) -> Self {
        Self {
            start: mission.start,
            mass_kg: body.mass_kg,
            reference_area_m2: body.reference_area_m2,
            nose_radius_m: body.nose_radius_m,
            reference_length_m: body.reference_length_m,
            drag_coefficient: match &body.drag {
                Drag::Constant(coefficient) => *coefficient,
                Drag::Table(_) => 1.0,
            },
            drag_factor: 1.0,
            density_factor: 1.0,
            wind_factor: 1.0,
            convective_factor: 1.0,
            radiative_factor: 1.0,
        }
    }
}

/// Applies a function to each number.
macro_rules! each {
    ($from:expr, $f:expr) => {{
        let (from, f) = ($from, $f);
        let velocity = |v: &Velocity<_>| Velocity {
            speed_m_s: f(v.speed_m_s),
            flight_path_angle_rad: f(v.flight_path_angle_rad),
            azimuth_rad: f(v.azimuth_rad),
        };
        Numbers {
            start: Start {
                position_m: from.start.position_m.map(f),
                velocity_m_s: from.start.velocity_m_s.map(f),
                relative: velocity(&from.start.relative),
                inertial: velocity(&from.start.inertial),
            },
            mass_kg: f(from.mass_kg),
            reference_area_m2: f(from.reference_area_m2),
            nose_radius_m: f(from.nose_radius_m),
            reference_length_m: f(from.reference_length_m),
            drag_coefficient: f(from.drag_coefficient),
            drag_factor: f(from.drag_factor),
            density_factor: f(from.density_factor),
            wind_factor: f(from.wind_factor),
            convective_factor: f(from.convective_factor),
            radiative_factor: f(from.radiative_factor),
        }
    }};
}

impl<S: Scalar> Numbers<S> {
    /// Equal numbers in every lane, without derivatives.
    pub fn constant(numbers: &Numbers) -> Self {
        each!(numbers, S::constant)
    }

    /// Equal numbers in every lane.
    pub fn everywhere(numbers: &Numbers<S::Lane>) -> Self {
        each!(numbers, |number: S::Lane| {
            let mut all = S::constant(0.0);
            (0..S::LANES).for_each(|lane| all.set_lane(lane, number));
            all
        })
    }

    /// Replaces the numbers of one lane.
    pub fn set_lane(&mut self, lane: usize, numbers: &Numbers<S::Lane>) {
        let velocity = |all: &mut Velocity<S>, one: &Velocity<S::Lane>| {
            all.speed_m_s.set_lane(lane, one.speed_m_s);
            all.flight_path_angle_rad
                .set_lane(lane, one.flight_path_angle_rad);
            all.azimuth_rad.set_lane(lane, one.azimuth_rad);
        };
        let vector = |all: &mut [S; 3], one: &[S::Lane; 3]| {
            for (all, one) in all.iter_mut().zip(one) {
                all.set_lane(lane, *one);
            }
        };
        vector(&mut self.start.position_m, &numbers.start.position_m);
        vector(&mut self.start.velocity_m_s, &numbers.start.velocity_m_s);
        velocity(&mut self.start.relative, &numbers.start.relative);
        velocity(&mut self.start.inertial, &numbers.start.inertial);
        for (all, one) in [
            (&mut self.mass_kg, numbers.mass_kg),
            (&mut self.reference_area_m2, numbers.reference_area_m2),
            (&mut self.nose_radius_m, numbers.nose_radius_m),
            (&mut self.reference_length_m, numbers.reference_length_m),
            (&mut self.drag_coefficient, numbers.drag_coefficient),
            (&mut self.drag_factor, numbers.drag_factor),
            (&mut self.density_factor, numbers.density_factor),
            (&mut self.wind_factor, numbers.wind_factor),
            (&mut self.convective_factor, numbers.convective_factor),
            (&mut self.radiative_factor, numbers.radiative_factor),
        ] {
            all.set_lane(lane, one);
        }
    }
}

impl<S: Scalar> Start<S> {
    /// The entry state at a position with a velocity relative to the planet.
    pub fn relative(planet: &Planet, position: &Geodetic<S>, relative: Velocity<S>) -> Self {
        let position_m = planet.cartesian_m(position);
        let horizon = planet.horizon(position_m);
        let velocity_m_s = horizon.cartesian_m_s(&relative);
        Self {
            position_m,
            velocity_m_s,
            relative,
            inertial: horizon.velocity(planet.inertial_m_s(position_m, velocity_m_s)),
        }
    }
}
