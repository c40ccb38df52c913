//! The record of one pass of the coupling.

use super::crossings::CROSSINGS;
use crate::flight::mission::Model;
use serde::{Deserialize, Serialize};

/// A pass of the coupling through the modules.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Pass {
    /// Number of the pass, from 1.
    pub number: u32,
    /// Model of flight used.
    pub flight_model: Model,
    /// Values that cross between the modules, by key of [`super::crossings::CROSSINGS`].
    pub crossings: [f64; CROSSINGS.len()],
    /// Entry mass, kg; in the last pass that of the vehicle made for its flight.
    pub mass_kg: f64,
    /// Change of the entry mass since the pass before, kg; absent in the first.
    pub mass_change_kg: Option<f64>,
    /// Estimated distance of the entry mass from its fixed point, kg; absent until two passes allow an estimate.
    #[serde(default)]
    pub mass_distance_kg: Option<f64>,
}
