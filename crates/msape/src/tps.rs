//! Heat shield: thickness from mass-estimating relations, and the limits of its materials.
//!
//! - [`material`]: a material's relation, limits and properties, one file each in `data/materials`.
//! - [`mer`]: thickness from heat load and entry speed.
//! - [`environment`]: heat flux, heat load and pressure where a heat shield is judged.
//! - [`limits`]: findings, where a material or a relation is used beyond what is known.
//! - [`fit_space`]: the trajectories behind the relations.
//! - [`concept`]: a forebody's heat shield, bond and carrier together, one file each in `data/concepts`.
//!
//! Loads are for a cold wall and include the user's margins; the relations themselves contain no margin (section 3.5.1).
//!
//! Deliberately absent: conduction and ablation in depth, which are in `ablation` beside this folder.

pub mod concept;
pub mod environment;
pub mod fit_space;
pub mod limits;
pub mod material;
pub mod mer;

use serde::{Deserialize, Serialize};

pub use environment::{Environment, JudgedAt, Point};

/// Pascals in an atmosphere.
pub const PA_PER_ATM: f64 = 101_325.0;

/// Side of the vehicle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Side {
    /// Forebody: ahead of the shoulder.
    Forebody,
    /// Aftbody: behind the shoulder.
    Aftbody,
}

impl Side {
    /// Name as in keys.
    pub fn name(self) -> &'static str {
        match self {
            Self::Forebody => "forebody",
            Self::Aftbody => "aftbody",
        }
    }
}
