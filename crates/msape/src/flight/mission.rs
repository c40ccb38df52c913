//! Mission: vehicle, planet and air, entry state, end of the flight and accuracy.

use super::freedom::Freedom;
use super::phase::Phase;
use crate::aero::Drag;
use crate::aero::table::Extrapolation;
use crate::heating::StagnationHeating;
use crate::planet::Planet;
use crate::planet::atmosphere::Atmosphere;
use crate::planet::horizon::Velocity;
use crate::planet::wind::Wind;
pub use crate::quantity::choice::FlightModel as Model;
use numerics::ode::Method;

/// Default accuracy of a flight: peak deceleration and heat load to 1e-5.
pub const DEFAULT_TOLERANCE: f64 = 3e-6;

/// A vehicle as flight sees it.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// Mass, kg.
    pub mass_kg: f64,
    /// Reference area of the drag coefficient, m².
    pub reference_area_m2: f64,
    /// Nose radius, m.
    pub nose_radius_m: f64,
    /// Drag coefficient.
    pub drag: Drag,
    /// Length of the Knudsen number: the largest diameter, m.
    pub reference_length_m: f64,
    /// Motion beyond drag.
    pub freedom: Freedom,
}

/// Entry state in planet-fixed axes, and the same in words.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Start<S = f64> {
    /// Position, planet-fixed axes with z along the pole, m.
    pub position_m: [S; 3],
    /// Velocity relative to the rotating planet, same axes, m/s.
    pub velocity_m_s: [S; 3],
    /// Velocity relative to the planet in the local horizon.
    pub relative: Velocity<S>,
    /// Inertial velocity in the local horizon.
    pub inertial: Velocity<S>,
}

/// Conditions that end a flight.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stop {
    /// Geodetic altitude that ends a fall, m.
    pub altitude_m: Option<f64>,
    /// Time after the start, s.
    pub time_s: Option<f64>,
    /// Number of passes through the atmosphere after which leaving it ends the flight; absent, the first does, or where a
    /// time is given, none.
    pub passes: Option<u32>,
}

impl Stop {
    /// Number of times the vehicle may leave the atmosphere on a bound orbit and come back.
    pub fn exits(&self) -> u32 {
        match (self.passes, self.time_s) {
            (Some(passes), _) => passes.saturating_sub(1),
            (None, Some(_)) => u32::MAX,
            (None, None) => 0,
        }
    }
}

/// Settings of the computation of the flight.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solver {
    /// Model.
    pub model: Model,
    /// Method of integration.
    pub method: Method,
    /// Relative error per step.
    pub tolerance: f64,
}

/// Everything about a flight but the vehicle.
#[derive(Clone, Debug)]
pub struct Mission {
    /// The planet.
    pub planet: Planet,
    /// Atmosphere of the planet.
    pub atmosphere: Atmosphere,
    /// Wind of the planet.
    pub wind: Wind,
    /// Entry state.
    pub start: Start,
    /// Heating at the stagnation point.
    pub heating: StagnationHeating,
    /// Emissivity of the wall for its radiative-equilibrium temperature.
    pub wall_emissivity: f64,
    /// Phases, in the order in which they begin.
    pub phases: Vec<Phase>,
    /// End of the flight.
    pub stop: Stop,
    /// Rules beyond the ends of the tables.
    pub beyond: Beyond,
    /// Settings of the computation.
    pub solver: Solver,
}

/// Rules beyond the ends of the tables of a mission.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Beyond {
    /// Rule for the atmosphere.
    pub atmosphere: Extrapolation,
    /// Rule for the wind.
    pub wind: Extrapolation,
}

impl Mission {
    /// Ratio of the heat capacities of the air where the vehicle is slowed.
    pub fn heat_capacity_ratio(&self) -> f64 {
        self.planet.heat_capacity_ratio(&self.atmosphere)
    }
}
