//! Density, pressure, temperature of the air against geometric altitude.
//!
//! ```text
//! ρ, p, T, a, γ, L of altitude, in smooth pieces
//! ```
//!
//! with ρ in kg/m³, p in Pa, T in K, speed of sound a in m/s, ratio of the heat capacities γ, mean free path L in m. An atmosphere is a row of pieces,
//! each smooth beyond its own ends, so that an integrator which ends its steps at the boundaries keeps its order.
//!
//! # Valid
//! Between the ends given by [`Atmosphere::valid_m`]; beyond them the end pieces continue.
//!
//! # References
//! - \[coesa-1976\]; each model names its own.

pub mod exponential;
pub mod piece;
pub mod table;
pub mod us_1976;

use super::gas::Gas;
use crate::data::Data;
use exponential::Exponential;
use numerics::scalar::Scalar;
pub use piece::Piece;
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use table::Table;
use us_1976::UsStandard1976;
use us1976::temperature::StandardTemperature;

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
    /// Ratio of the heat capacities.
    pub heat_capacity_ratio: S,
    /// Mean free path, m.
    pub mean_free_path_m: S,
}

/// Properties that an atmosphere lends to models of the same planet that give less than density, pressure and
/// temperature.
#[derive(Clone, Debug, PartialEq)]
pub struct PlanetAir {
    /// Gas.
    pub gas: Gas,
    /// Temperature by altitude.
    pub temperature: OwnTemperature,
}

/// Temperature by altitude of a planet's own atmosphere.
#[derive(Clone, Debug, PartialEq)]
pub enum OwnTemperature {
    /// Temperature of the U.S. Standard Atmosphere 1976.
    Standard(StandardTemperature),
    /// Temperature of a table.
    Table(Arc<Table>),
}

impl OwnTemperature {
    /// Kinetic temperature, K, at an altitude, m.
    #[inline]
    pub fn kinetic_k<S: Scalar>(&self, altitude_m: S) -> S {
        match self {
            Self::Standard(standard) => standard.kinetic_k(altitude_m),
            Self::Table(table) => table.temperature_k(altitude_m),
        }
    }
}

/// A model of the atmosphere.
#[derive(Clone, Debug, PartialEq)]
pub enum Atmosphere {
    /// The U.S. Standard Atmosphere 1976.
    UsStandard1976(Arc<UsStandard1976>),
    /// Rows, of a data file or of a user.
    Table(Arc<Table>),
    /// One scale height.
    Exponential(Arc<Exponential>),
}

impl Atmosphere {
    /// Title and atmosphere of a data file: a table, or else the definition of the U.S. Standard Atmosphere 1976.
    pub fn parse(data: Data) -> Result<(String, Self), String> {
        if data.has("table") {
            let (title, table) = Table::parse(data)?;
            return Ok((title, Self::Table(Arc::new(table))));
        }
        let (title, standard) = UsStandard1976::parse(data)?;
        Ok((title, Self::UsStandard1976(Arc::new(standard))))
    }

    /// Properties lent to models of the same planet that lack them.
    pub fn planet_air(&self) -> PlanetAir {
        match self {
            Self::UsStandard1976(us) => us.planet_air(),
            Self::Table(table) => PlanetAir {
                gas: table.gas().clone(),
                temperature: OwnTemperature::Table(table.clone()),
            },
            Self::Exponential(exponential) => exponential.planet_air().clone(),
        }
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
            Self::Table(table) => table.speed_of_sound_in(piece, altitude_m),
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
