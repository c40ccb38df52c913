//! The coupled design: passes through the modules until the mass converges.
//!
//! - [`inputs`]: what a design is made from, checked.
//! - [`drag`]: drag of the vehicle, by name or from its outline.
//! - [`coupling`]: the passes, steps 4 to 12 of section 2.2 of the report, made into an answer. [`start`]: where they may begin.
//! - `passes`, `lighter`: the passes themselves, and the lighter of two vehicles that both carry themselves.
//! - `flown`, `sized`: the flight of one pass, and the heat shields that it requires.
//! - `given`: findings on results that the user gives.
//! - [`stability`]: static margin and trims of the converged design.
//! - [`structural`]: structural rules and shell model of the converged design.
//! - [`crossings`]: what crosses between the modules, for the N-squared view.
//! - [`misfit`]: why a vehicle does not close, at the inputs concerned.

pub mod coupling;
pub mod crossings;
pub mod drag;
mod flown;
mod given;
pub mod inputs;
mod lighter;
pub mod misfit;
mod pass;
mod passes;
mod sized;
pub mod stability;
pub mod start;
pub mod structural;

pub use pass::Pass;

use crate::aero::stability::Stability;
use crate::design::structural::Structural;
use crate::finding::{Adjustment, Finding};
use crate::flight::Flight;
use crate::flight::six_dof::turning::Turning;
use crate::outcome::Outcome;
use crate::tps::Environment;
use crate::tps::mer::Sizing;
use crate::vehicle::Vehicle;
use crate::vehicle::impact::landing::Landing;
use serde::{Deserialize, Serialize};

/// The end of the coupling: the last pass, how it ended, and the record of all passes.
#[derive(Clone, Debug, PartialEq)]
pub struct Solution {
    /// Outcome: how the computation ended.
    pub outcome: Outcome,
    /// Reason for the outcome in one sentence, where it needs one.
    pub reason: Option<String>,
    /// The flight of the last pass; absent where the vehicle does not close.
    pub flight: Option<Flight>,
    /// The designed vehicle; absent where it does not close.
    pub design: Option<Design>,
    /// Inputs that the closing rules changed.
    pub adjustments: Vec<Adjustment>,
    /// Remarks on models, limits and assumptions.
    pub findings: Vec<Finding>,
    /// The passes.
    pub passes: Vec<Pass>,
}

/// A designed vehicle and what was sized for it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Design {
    /// Geometry, mass, impact, structure.
    pub vehicle: Vehicle,
    /// Landing on the chosen ground and on a rigid surface.
    pub landing: Landing,
    /// Heat shield of the forebody.
    pub forebody_tps: Sizing,
    /// Heat shield of the aftbody.
    pub aftbody_tps: Sizing,
    /// Density of the forebody's heat shield, kg/m³.
    pub forebody_tps_density_kg_m3: f64,
    /// Density of the aftbody's heat shield, kg/m³.
    pub aftbody_tps_density_kg_m3: f64,
    /// Largest heat flux on the aftbody with margins, W/m².
    pub aftbody_heat_flux_w_m2: f64,
    /// Heat load on the aftbody with margins, J/m².
    pub aftbody_heat_load_j_m2: f64,
    /// Largest heat flux on the shoulder with margins, W/m².
    pub shoulder_heat_flux_w_m2: f64,
    /// Largest heat flux on the shoulder over that of the stagnation point.
    pub shoulder_heat_flux_ratio: f64,
    /// Heat load on the shoulder with margins, with the factor of the flux, J/m².
    pub shoulder_heat_load_j_m2: f64,
    /// Point of the forebody at which its heat shield is sized, and the environment there.
    pub forebody_judged: Environment,
    /// Largest pressure on the aftbody, Pa.
    pub aftbody_pressure_pa: f64,
    /// Peak temperature of the payload container, K.
    pub payload_temperature_k: f64,
    /// Drag coefficient at impact.
    pub impact_drag_coefficient: f64,
    /// Speed at which drag equals the weight where the vehicle lands, equation 2, m/s.
    pub terminal_speed_m_s: f64,
    /// Half-angle of the forebody cone, rad.
    pub cone_half_angle_rad: f64,
    /// Mass of the payload, kg.
    pub payload_mass_kg: f64,
    /// Structural rules and shell model, computed once when the passes are done; absent where a study leaves it out.
    pub structural: Option<Structural>,
    /// Static margin and trims, computed once when the passes are done; absent where a study leaves them out.
    pub stability: Option<Stability>,
    /// Entries from a set of attitudes and rates; absent if not requested.
    pub turning: Option<Turning>,
    /// Number of passes.
    pub passes: u32,
    /// Estimated distance of the entry mass from its fixed point, kg.
    pub mass_residual_kg: Option<f64>,
}
