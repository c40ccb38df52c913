//! The radiative models.
//!
//! ```text
//! q̇ʳ = q̇(ρ, V, Rₙ),   0 below the onset speed
//! ```
//!
//! with q̇ʳ in W/m², ρ in kg/m³, V in m/s, Rₙ in m; each model in its own file.
//!
//! # Valid
//! Ranges of the models, as stated in their findings. At the onset speed the flux jumps: a few W/cm² at most in flight.
//!
//! # References
//! - \[tauber-sutton-1991\]; \[brandis-johnston-2014\].

use super::brandis_johnston::{BrandisJohnston, BrandisJohnstonRadiative};
use super::given::{GivenHeating, Part};
use super::tauber_sutton::TauberSutton;
use super::{Flow, PeakConditions};
use crate::data::Data;
use crate::finding::Finding;
use numerics::scalar::Scalar;
use std::sync::Arc;

/// A model of radiative heating.
#[derive(Clone, Debug, PartialEq)]
pub enum Radiative {
    /// No radiation.
    None,
    /// Tauber and Sutton: Earth or Mars.
    TauberSutton(TauberSutton),
    /// Brandis and Johnston: Earth.
    BrandisJohnston(BrandisJohnstonRadiative),
    /// A table of the case.
    Given(Arc<GivenHeating>),
}

impl Radiative {
    /// Tauber-Sutton, from the text of `heating/tauber-sutton.toml`.
    pub fn tauber_sutton(data: Data) -> Result<Self, String> {
        TauberSutton::parse(data).map(Self::TauberSutton)
    }

    /// Brandis-Johnston, from the text of `heating/brandis-johnston.toml`.
    pub fn brandis_johnston(data: Data) -> Result<Self, String> {
        BrandisJohnston::parse(data).map(|both| Self::BrandisJohnston(both.radiative))
    }

    /// Name as in case files.
    pub fn name(&self) -> &'static str {
        match self {
            Self::None => "none",
            Self::TauberSutton(_) => "tauber-sutton",
            Self::BrandisJohnston(_) => "brandis-johnston",
            Self::Given(table) => table.key,
        }
    }

    /// Speed below which there is no radiation and at which the flux jumps, m/s.
    pub fn onset_m_s(&self) -> Option<f64> {
        match self {
            Self::None | Self::Given(_) => None,
            Self::TauberSutton(model) => Some(model.onset_m_s()),
            Self::BrandisJohnston(model) => Some(model.onset_m_s()),
        }
    }

    /// Speeds at which the relation has a kink, m/s, ascending; at the first of them it begins.
    pub fn kinks_m_s(&self) -> Vec<f64> {
        match self {
            Self::None => Vec::new(),
            Self::TauberSutton(model) => model.table_speeds_m_s().collect(),
            Self::BrandisJohnston(model) => vec![model.onset_m_s()],
            Self::Given(table) => table.speeds_m_s().to_vec(),
        }
    }

    /// Heat flux, W/m².
    #[inline]
    pub fn heat_flux_w_m2<S: Scalar>(&self, flow: &Flow<S>) -> S {
        match self {
            Self::None => S::constant(0.0),
            Self::TauberSutton(model) => model.heat_flux_w_m2(flow),
            Self::BrandisJohnston(model) => model.heat_flux_w_m2(flow),
            Self::Given(table) => table.heat_flux_w_m2(Part::Radiative, flow),
        }
    }

    /// Findings where the peak is outside the ranges.
    pub fn findings(&self, peak: &PeakConditions) -> Vec<Finding> {
        match self {
            Self::None => Vec::new(),
            Self::TauberSutton(model) => model.findings(peak),
            Self::BrandisJohnston(model) => model.findings(peak),
            Self::Given(table) => vec![table.finding(Part::Radiative)],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_radiation_is_zero_and_has_no_onset() {
        let flow = Flow::new(1e-3, 1.4e4, 1.0);
        assert_eq!(Radiative::None.heat_flux_w_m2(&flow), 0.0);
        assert_eq!(Radiative::None.onset_m_s(), None);
    }
}
