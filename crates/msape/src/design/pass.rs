//! The record of one pass of the coupling.

use serde::{Deserialize, Serialize};

/// One pass of the coupling through the modules.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Pass {
    /// Number of the pass, from 1.
    pub number: u32,
    /// Model of flight used: `allen-eggers` or `three-dof`.
    pub flight_model: String,
    /// Values that cross between the modules, by key of [`super::crossings::CROSSINGS`].
    pub crossings: Vec<f64>,
    /// Entry mass, kg.
    pub mass_kg: f64,
    /// Change of the entry mass since the pass before, kg; absent in the first.
    pub mass_change_kg: Option<f64>,
}
