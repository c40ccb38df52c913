//! Density, pressure, temperature of the air against geometric altitude.
//!
//! ```text
//! ρ, p, T, a, L of altitude, in smooth pieces
//! ```
//!
//! with ρ in kg/m³, p in Pa, T in K, speed of sound a in m/s, mean free path L in m. An atmosphere is a row of pieces,
//! each smooth beyond its own ends, so that an integrator which ends its steps at the boundaries keeps its order.
//!
//! # Valid
//! Between the ends that [`Atmosphere::valid_m`] names; beyond them the end pieces go on.
//!
//! # References
//! - \[coesa-1976\]; each model names its own.

pub mod exponential;
pub mod piece;
pub mod table;
pub mod us_1976;

use crate::finding::{Finding, Severity};
use exponential::Exponential;
use numerics::scalar::Scalar;
pub use piece::Piece;
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use table::Table;
use us_1976::UsStandard1976;
use us_1976::temperature::StandardTemperature;

/// The air at one altitude.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Air<S> {
    /// Density, kg/m³.
    pub density_kg_m3: S,
    /// Pressure, Pa.
    pub pressure_pa: S,
    /// Kinetic temperature, K.
    pub temperature_k: S,
    /// Speed of sound, m/s.
    pub speed_of_sound_m_s: S,
    /// Mean free path, m.
    pub mean_free_path_m: S,
}

/// Air of the composition at sea level with the temperature of the U.S. Standard Atmosphere 1976: what models that
/// bring a density only take for the rest.
#[derive(Clone, Debug, PartialEq)]
pub struct StandardAir {
    /// Kinetic temperature by altitude.
    pub temperature: StandardTemperature,
    /// Ratio of the heat capacities.
    pub heat_capacity_ratio: f64,
    /// Gas constant of air, J/(kg K).
    pub gas_constant_j_kg_k: f64,
    /// Mean free path times density, kg/m².
    pub mean_free_path_kg_m2: f64,
}

impl StandardAir {
    /// Air of a density, kg/m³, and a temperature, K; pressure by the gas law unless given, Pa.
    #[inline]
    pub fn of<S: Scalar>(
        &self,
        density_kg_m3: S,
        temperature_k: S,
        pressure_pa: Option<S>,
    ) -> Air<S> {
        let r = self.gas_constant_j_kg_k;
        Air {
            density_kg_m3,
            pressure_pa: pressure_pa.unwrap_or(density_kg_m3 * temperature_k * r),
            temperature_k,
            speed_of_sound_m_s: (temperature_k * (self.heat_capacity_ratio * r)).sqrt(),
            mean_free_path_m: S::constant(self.mean_free_path_kg_m2) / density_kg_m3,
        }
    }
}

/// A model of the atmosphere.
#[derive(Clone, Debug, PartialEq)]
pub enum Atmosphere {
    /// The U.S. Standard Atmosphere 1976.
    UsStandard1976(Arc<UsStandard1976>),
    /// Rows that a user brings.
    Table(Arc<Table>),
    /// One scale height.
    Exponential(Arc<Exponential>),
}

impl Atmosphere {
    /// The U.S. Standard Atmosphere 1976 of its data file.
    pub fn us_1976(text: &str) -> Result<Self, String> {
        Ok(Self::UsStandard1976(Arc::new(UsStandard1976::parse(text)?)))
    }

    /// Geometric altitudes between the smooth pieces, m, ascending; one fewer than pieces.
    pub fn boundaries_m(&self) -> &[f64] {
        match self {
            Self::UsStandard1976(us) => us.boundaries_m(),
            Self::Table(table) => table.boundaries_m(),
            Self::Exponential(_) => &[],
        }
    }

    /// Index of the piece that an altitude, m, belongs to; a boundary belongs to the piece above.
    #[inline]
    pub fn layer(&self, altitude_m: f64) -> usize {
        self.boundaries_m()
            .partition_point(|boundary| *boundary <= altitude_m)
    }

    /// Lowest and highest altitude at which the model is backed by its source, m.
    pub fn valid_m(&self) -> (f64, f64) {
        match self {
            Self::UsStandard1976(_) => UsStandard1976::VALID_M,
            Self::Table(table) => table.valid_m(),
            Self::Exponential(_) => (f64::NEG_INFINITY, f64::INFINITY),
        }
    }

    /// A remark when altitudes from `lowest_m` to `highest_m` leave the range of the model.
    pub fn finding(&self, lowest_m: f64, highest_m: f64) -> Option<Finding> {
        let (bottom_m, top_m) = self.valid_m();
        let value = if highest_m > top_m {
            highest_m
        } else {
            lowest_m
        };
        if (bottom_m..=top_m).contains(&value) {
            return None;
        }
        let (model, source) = match self {
            Self::UsStandard1976(_) => ("us-1976", "NASA-TM-X-74335"),
            Self::Table(_) => ("atmosphere table", "the rows given"),
            Self::Exponential(_) => ("exponential atmosphere", "its definition"),
        };
        Some(Finding {
            severity: Severity::Extrapolated,
            model: model.to_string(),
            key: "altitude_m".to_string(),
            value: Some(value),
            valid: (Some(bottom_m), Some(top_m)),
            message: format!(
                "Density was extrapolated to {} km; the atmosphere covers {} to {} km.",
                value / 1000.0,
                bottom_m / 1000.0,
                top_m / 1000.0
            ),
            source: source.to_string(),
            field: Some("entry.atmosphere".to_string()),
        })
    }

    /// The piece with an index, for [`Atmosphere::density_in`] and the like.
    pub fn piece(&self, layer: usize) -> Piece<f64> {
        match self {
            Self::UsStandard1976(us) => us.piece(layer),
            Self::Table(_) | Self::Exponential(_) => Piece::bare(layer),
        }
    }

    /// Density of one piece, kg/m³, continued smoothly beyond its ends.
    #[inline]
    pub fn density_in<S: Scalar>(&self, piece: &Piece<S::Value>, altitude_m: S) -> S {
        match self {
            Self::UsStandard1976(us) => us.density_in(piece, altitude_m),
            Self::Table(table) => table.density_in(piece, altitude_m),
            Self::Exponential(exponential) => exponential.density_kg_m3(altitude_m),
        }
    }

    /// Everything of one piece, continued smoothly beyond its ends.
    #[inline]
    pub fn air_in<S: Scalar>(&self, piece: &Piece<S::Value>, altitude_m: S) -> Air<S> {
        match self {
            Self::UsStandard1976(us) => us.air_in(piece, altitude_m),
            Self::Table(table) => table.air_in(piece, altitude_m),
            Self::Exponential(exponential) => exponential.air(altitude_m),
        }
    }

    /// Speed of sound of one piece, m/s, continued smoothly beyond its ends.
    #[inline]
    pub fn speed_of_sound_in<S: Scalar>(&self, piece: &Piece<S::Value>, altitude_m: S) -> S {
        match self {
            Self::UsStandard1976(us) => us.speed_of_sound_in(piece, altitude_m),
            Self::Table(table) => table.air_in(piece, altitude_m).speed_of_sound_m_s,
            Self::Exponential(exponential) => exponential.air(altitude_m).speed_of_sound_m_s,
        }
    }

    /// Density, kg/m³, the piece chosen by the altitude, m.
    pub fn density_kg_m3(&self, altitude_m: f64) -> f64 {
        self.density_in(&self.piece(self.layer(altitude_m)), altitude_m)
    }

    /// Everything, the piece chosen by the altitude, m.
    pub fn air(&self, altitude_m: f64) -> Air<f64> {
        self.air_in(&self.piece(self.layer(altitude_m)), altitude_m)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn leaving_the_range_is_a_finding() {
        let air = Atmosphere::us_1976(include_str!("../../data/atmospheres/us-1976.toml")).unwrap();
        assert_eq!(air.finding(0.0, 125e3), None);
        assert_eq!(air.finding(-10e3, 125e3).unwrap().value, Some(-10e3));
        assert!(
            air.finding(0.0, 2e6)
                .unwrap()
                .message
                .contains("to 2000 km; the atmosphere covers -5 to 1000 km")
        );
    }
}
