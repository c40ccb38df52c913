//! Settings, end and account of a run.
//!
//! ```text
//! imbalance of energy = (stored − in through the wall + out through the back) / (all that went over both edges)
//! imbalance of mass   = (stored + gas that left + char that left) / (gas and char that left)
//! ```
//!
//! with energies in J and masses in kg per m² of the initial wall.
//!
//! # Valid
//! Any run.
//!
//! # References
//! - \[assumed\]: the scales of the balances.

use crate::fault::Fault;
use crate::grid::Resolution;
use crate::stack::Stack;
use crate::stage::Edges;
use crate::wall::WallSettings;

/// Way in which a run ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Outcome {
    /// At the time asked for.
    Finished,
    /// When the joint's temperature had passed its maximum and no heat came any more.
    Cooled,
    /// The first layer was gone.
    BurntThrough,
    /// At the limit of work.
    OutOfWork,
    /// No step was short enough.
    NotSettled,
    /// By whoever watched.
    Stopped,
}

/// End of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Until {
    /// A time, s.
    Time(f64),
    /// The fall of the temperature behind a layer after the last row of the environment, or a time, s, at the latest.
    Cooled {
        /// Layer, from 0.
        layer: usize,
        /// Latest time, s.
        at_most_s: f64,
    },
}

/// Settings of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// Temperature of all layers at the start, K.
    pub initial_temperature_k: f64,
    /// Wall.
    pub wall: WallSettings,
    /// End.
    pub until: Until,
    /// Interval of the rows of the history, s; none keeps the first and the last.
    pub output_step_s: Option<f64>,
    /// Depths from the initial wall at which temperatures are kept, m; beyond the back there is none.
    pub depths_m: Vec<f64>,
    /// Cells.
    pub resolution: Resolution,
    /// Error of a step, K.
    pub tolerance_k: f64,
    /// Most steps, those that were taken back included.
    pub most_steps: usize,
}

impl Settings {
    pub(crate) fn check(&self, stack: &Stack) -> Result<(), Fault> {
        const OF: &str = "settings";
        let end = match self.until {
            Until::Time(t) | Until::Cooled { at_most_s: t, .. } => t,
        };
        let step = self.output_step_s.unwrap_or(1.0);
        for (key, value, least, most) in [
            (
                "initial_temperature_k",
                self.initial_temperature_k,
                1.0,
                5000.0,
            ),
            (
                "sink_temperature_k",
                self.wall.sink_temperature_k,
                0.0,
                5000.0,
            ),
            ("blowing", self.wall.blowing, 0.0, 2.0),
            ("until_s", end, -1e9, 1e9),
            ("output_step_s", step, 1e-6, 1e9),
            ("tolerance_k", self.tolerance_k, 1e-9, 1e3),
            ("cells", self.resolution.cells as f64, 3.0, 20_000.0),
            (
                "cells_behind",
                self.resolution.cells_behind as f64,
                1.0,
                20_000.0,
            ),
            ("stretch", self.resolution.stretch, 1.0, 1e6),
        ] {
            if !(least..=most).contains(&value) {
                return Err(Fault::Range {
                    of: OF,
                    key,
                    value,
                    least,
                    most,
                });
            }
        }
        for &value in &self.depths_m {
            if !(0.0..=f64::MAX).contains(&value) {
                return Err(Fault::Range {
                    of: OF,
                    key: "depths_m",
                    value,
                    least: 0.0,
                    most: f64::MAX,
                });
            }
        }
        if let Until::Cooled { layer, .. } = self.until
            && layer >= stack.layers.len()
        {
            let (value, most) = (layer as f64, stack.layers.len() as f64 - 1.0);
            return Err(Fault::Range {
                of: OF,
                key: "layer",
                value,
                least: 0.0,
                most,
            });
        }
        Ok(())
    }
}

/// Account of a run.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Account {
    /// Steps taken.
    pub steps: usize,
    /// Steps taken back.
    pub taken_back: usize,
    /// Corrections in all stages.
    pub corrections: usize,
    /// Energy in through the wall, gas and char that leave counted, J per m² of the initial wall.
    pub wall_j_m2: f64,
    /// Energy out through the back, J/m².
    pub back_j_m2: f64,
    /// Gas that left, kg/m².
    pub gas_kg_m2: f64,
    /// Char that left, kg/m².
    pub char_kg_m2: f64,
    /// Energy of all layers less that at the start, J/m².
    pub stored_j_m2: f64,
    /// Mass of all layers less that at the start, kg/m².
    pub stored_kg_m2: f64,
    /// Sum of the sizes of all flows of energy over the edges, J/m²: the scale of the balance.
    pub turned_over_j_m2: f64,
}

impl Account {
    /// Adds a step, with the weights of its stages, s, and the flows at their ends.
    pub(crate) fn add(&mut self, weights_s: [f64; 2], edges: &[Edges; 2]) {
        self.steps += 1;
        for (edges, h) in edges.iter().zip(weights_s) {
            self.wall_j_m2 += h * edges.wall_w_m2;
            self.back_j_m2 += h * edges.back_w_m2;
            self.gas_kg_m2 += h * edges.gas;
            self.char_kg_m2 += h * edges.char;
            self.turned_over_j_m2 += h * (edges.wall_w_m2.abs() + edges.back_w_m2.abs());
        }
    }

    /// Energy that is missing over the energy that went over the edges.
    pub fn energy_imbalance(&self) -> f64 {
        (self.stored_j_m2 - self.wall_j_m2 + self.back_j_m2)
            / self.turned_over_j_m2.max(f64::MIN_POSITIVE)
    }

    /// Mass that is missing over the mass that left.
    pub fn mass_imbalance(&self) -> f64 {
        let left = self.gas_kg_m2 + self.char_kg_m2;
        (self.stored_kg_m2 + left) / left.max(f64::MIN_POSITIVE)
    }
}
