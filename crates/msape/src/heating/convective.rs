//! The convective models, cold wall.
//!
//! ```text
//! q̇ᶜ = q̇(ρ, V, Rₙ)
//! ```
//!
//! with q̇ᶜ in W/m², ρ in kg/m³, V in m/s, Rₙ in m; each model in its own file.
//!
//! # Valid
//! Ranges of the models, as stated in their findings.
//!
//! # References
//! - \[sutton-graves-1972\]; \[brandis-johnston-2014\].

use super::brandis_johnston::{BrandisJohnston, BrandisJohnstonConvective};
use super::given::{GivenHeating, Part};
use super::sutton_graves::SuttonGraves;
use super::{Flow, PeakConditions};
use crate::data::Data;
use crate::finding::Finding;
use numerics::scalar::Scalar;
use std::sync::Arc;

/// A model of convective heating.
#[derive(Clone, Debug, PartialEq)]
pub enum Convective {
    /// Sutton and Graves: any planet with a constant.
    SuttonGraves(SuttonGraves),
    /// Brandis and Johnston: Earth.
    BrandisJohnston(BrandisJohnstonConvective),
    /// A table of the case.
    Given(Arc<GivenHeating>),
}

impl Convective {
    /// Sutton-Graves for `planet`, from the text of `heating/sutton-graves.toml`.
    pub fn sutton_graves(data: Data, planet: &str) -> Result<Self, String> {
        SuttonGraves::parse(data, planet).map(Self::SuttonGraves)
    }

    /// Brandis-Johnston, from the text of `heating/brandis-johnston.toml`.
    pub fn brandis_johnston(data: Data) -> Result<Self, String> {
        BrandisJohnston::parse(data).map(|both| Self::BrandisJohnston(both.convective))
    }

    /// Name as in case files.
    pub fn name(&self) -> &'static str {
        match self {
            Self::SuttonGraves(_) => "sutton-graves",
            Self::BrandisJohnston(_) => "brandis-johnston",
            Self::Given(table) => table.key,
        }
    }

    /// Speeds at which the relation has a step or a kink, m/s, ascending.
    pub fn kinks_m_s(&self) -> Vec<f64> {
        match self {
            Self::SuttonGraves(_) => Vec::new(),
            Self::BrandisJohnston(model) => vec![model.switch_m_s()],
            Self::Given(table) => table.speeds_m_s().to_vec(),
        }
    }

    /// Cold-wall heat flux, W/m².
    #[inline]
    pub fn heat_flux_w_m2<S: Scalar>(&self, flow: &Flow<S>) -> S {
        match self {
            Self::SuttonGraves(model) => model.heat_flux_w_m2(flow),
            Self::BrandisJohnston(model) => model.heat_flux_w_m2(flow),
            Self::Given(table) => table.heat_flux_w_m2(Part::Convective, flow),
        }
    }

    /// Findings where the peak is outside the ranges.
    pub fn findings(&self, peak: &PeakConditions) -> Vec<Finding> {
        match self {
            Self::SuttonGraves(model) => model.findings(peak),
            Self::BrandisJohnston(model) => model.findings(peak),
            Self::Given(table) => vec![table.finding(Part::Convective)],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_those_of_case_files() {
        let sutton_graves = include_str!("../../data/heating/sutton-graves.toml");
        let brandis_johnston = include_str!("../../data/heating/brandis-johnston.toml");
        assert_eq!(
            Convective::sutton_graves(sutton_graves.into(), "earth")
                .unwrap()
                .name(),
            "sutton-graves"
        );
        assert_eq!(
            Convective::brandis_johnston(brandis_johnston.into())
                .unwrap()
                .name(),
            "brandis-johnston"
        );
    }
}
