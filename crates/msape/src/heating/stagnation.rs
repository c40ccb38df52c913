//! Heating of the stagnation point: both models, the wall, the model factor and the margins; and its pressure.
//!
//! ```text
//! q̇ᶜ = f q̇ᶜ(cold) (1 − h_w/h₀)       nominal
//! q̇  = mᶜ q̇ᶜ + mʳ q̇ʳ                 margined total
//! ```
//!
//! with q̇ in W/m², f the model factor (a correction of the correlation, 1.33 from the report's Navier-Stokes
//! solutions), mᶜ and mʳ the user's margins. Factor and margin are different things and are kept apart: the default is
//! the portal's, margin 1.3 on plain Sutton-Graves with a factor of 1. Both above 1 are reported.
//!
//! # Valid
//! Ranges of the models; the hot wall for the gas of the planet, undissociated.
//!
//! # References
//! - \[samareh-2014\] section 3.4.3 and the run page of appendix D.

use super::convective::Convective;
use super::given::body::BodyHeating;
use super::given::{GivenHeating, Part};
use super::pressure::StagnationPressure;
use super::radiative::Radiative;
use super::wall::{ColdWall, Wall, WallGas};
use super::{Flow, PeakConditions};
use crate::data::Data;
use crate::finding::range::short;
use crate::finding::{Finding, Severity};
use crate::quantity::input;
use numerics::scalar::Scalar;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Default factor and margins, from `heating/margins.toml`.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Margins {
    /// Key of the reference.
    pub source: String,
    /// Place in it.
    pub place: String,
    /// Note on their meaning.
    pub note: String,
    /// Navier-Stokes over Sutton-Graves at the stagnation point.
    pub cfd_over_sutton_graves: f64,
    /// Margin on convective heating.
    pub convective_margin: f64,
    /// Margin on radiative heating.
    pub radiative_margin: f64,
}

impl Margins {
    /// Reads them from the text of `heating/margins.toml`.
    pub fn parse(data: Data) -> Result<Self, String> {
        data.read()
    }
}

/// Options of convective heating.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct ConvectiveOptions {
    /// Correction of the correlation.
    pub model_factor: f64,
    /// The user's margin on top.
    pub margin: f64,
    /// Wall.
    pub wall: Wall,
}

impl Default for ConvectiveOptions {
    fn default() -> Self {
        Self {
            model_factor: 1.0,
            margin: 1.0,
            wall: Wall::Cold,
        }
    }
}

/// The stagnation point's heating, complete.
#[derive(Clone, Debug, PartialEq)]
pub struct StagnationHeating {
    /// Convective model.
    pub convective: Convective,
    /// Options of convective heating.
    pub options: ConvectiveOptions,
    /// Radiative model.
    pub radiative: Radiative,
    /// The user's margin on radiative heating.
    pub radiative_margin: f64,
    /// Heat fluxes of the case at points of the body.
    pub body: Option<Arc<BodyHeating>>,
    /// Gas at the wall.
    pub gas: WallGas,
    /// Pressure.
    pub pressure: StagnationPressure,
}

/// Nominal heat fluxes, without margins.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct HeatFlux<S> {
    /// Convective heat flux, W/m².
    pub convective_w_m2: S,
    /// Radiative heat flux, W/m².
    pub radiative_w_m2: S,
}

impl<S: Scalar> HeatFlux<S> {
    /// Total heat flux, W/m².
    #[inline]
    pub fn total_w_m2(&self) -> S {
        self.convective_w_m2 + self.radiative_w_m2
    }
}

impl StagnationHeating {
    /// Nominal heat fluxes.
    #[inline]
    pub fn heat_flux<S: Scalar>(&self, flow: &Flow<S>) -> HeatFlux<S> {
        self.at_wall(ColdWall {
            convective_w_m2: self.convective.heat_flux_w_m2(flow),
            radiative_w_m2: self.radiative.heat_flux_w_m2(flow),
            speed_m_s: flow.speed_m_s,
        })
    }

    /// Nominal heat fluxes at another point of the body, by its table.
    pub fn heat_flux_of<S: Scalar>(&self, point: &GivenHeating, flow: &Flow<S>) -> HeatFlux<S> {
        let flux = |part| point.heat_flux_w_m2(part, flow);
        self.at_wall(ColdWall {
            convective_w_m2: flux(Part::Convective),
            radiative_w_m2: flux(Part::Radiative),
            speed_m_s: flow.speed_m_s,
        })
    }

    /// Heat flux at the wall: that of a relation for a cold wall, corrected by its factor.
    #[inline]
    fn at_wall<S: Scalar>(&self, relation: ColdWall<S>) -> HeatFlux<S> {
        let cold = ColdWall {
            convective_w_m2: relation.convective_w_m2 * self.options.model_factor,
            ..relation
        };
        HeatFlux {
            convective_w_m2: self.gas.convective_w_m2(self.options.wall, &cold),
            radiative_w_m2: cold.radiative_w_m2,
        }
    }

    /// The table of the case that gives heating in place of the relations, where one does.
    pub fn given(&self) -> Option<&GivenHeating> {
        match &self.convective {
            Convective::Given(table) => Some(table),
            _ => None,
        }
    }

    /// Heat fluxes with margins.
    #[inline]
    pub fn margined<S: Scalar>(&self, nominal: &HeatFlux<S>) -> HeatFlux<S> {
        HeatFlux {
            convective_w_m2: nominal.convective_w_m2 * self.options.margin,
            radiative_w_m2: nominal.radiative_w_m2 * self.radiative_margin,
        }
    }

    /// Findings: ranges of the models at peak heating, factor and margin together, warm wall.
    pub fn findings(&self, peak: &PeakConditions) -> Vec<Finding> {
        let mut findings = self.convective.findings(peak);
        findings.extend(self.radiative.findings(peak));
        findings.extend(self.body.as_ref().map(|body| body.finding()));
        let ConvectiveOptions {
            model_factor,
            margin,
            wall,
        } = self.options;
        let note = |key: &str, value: f64, message: String, source: &str| Finding {
            severity: Severity::Note,
            model: self.convective.name().into(),
            key: key.into(),
            value: Some(value),
            valid: (None, None),
            message,
            source: source.into(),
            field: Some(input::heating::CONVECTIVE_MARGIN.key.into()),
        };
        if model_factor > 1.0 && margin > 1.0 {
            let (f, m, product) = (
                short(model_factor),
                short(margin),
                short(model_factor * margin),
            );
            findings.push(note(
                "convective_model_factor",
                model_factor,
                format!("Convective heating carries the model factor {f} and the margin {m}: together {product}."),
                "NASA/TM-2014-218507, section 3.4.3 (factor) and run page (margin)",
            ));
        }
        if wall != Wall::Cold {
            findings.push(note(
                "peak_convective_heat_flux_w_m2",
                self.heat_flux(&Flow::new(peak.density_kg_m3, peak.speed_m_s, peak.nose_radius_m))
                .convective_w_m2,
                "Hot-wall heating is below what the mass-estimating relations expect: they take cold-wall values.".into(),
                "NASA/TM-2014-218507, Table 7",
            ));
        }
        findings
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::heating::pressure::{PressureFit, PressureModel};

    fn portal() -> StagnationHeating {
        let margins =
            Margins::parse(include_str!("../../data/heating/margins.toml").into()).unwrap();
        let sutton_graves = include_str!("../../data/heating/sutton-graves.toml");
        StagnationHeating {
            convective: Convective::sutton_graves(sutton_graves.into(), "earth-msape").unwrap(),
            options: ConvectiveOptions {
                margin: margins.convective_margin,
                ..ConvectiveOptions::default()
            },
            radiative: Radiative::tauber_sutton(
                include_str!("../../data/heating/tauber-sutton.toml").into(),
            )
            .unwrap(),
            radiative_margin: margins.radiative_margin,
            body: None,
            gas: WallGas::parse(
                include_str!("../../data/heating/hot-wall.toml").into(),
                "earth",
            )
            .unwrap(),
            pressure: StagnationPressure {
                model: PressureModel::NewtonianLimit,
                fit: PressureFit::parse(
                    include_str!("../../data/heating/stagnation-pressure.toml").into(),
                )
                .unwrap(),
            },
        }
    }

    fn flow() -> Flow<f64> {
        Flow::new(4e-4, 1.1e4, 0.35)
    }

    #[test]
    fn margin_is_on_top_of_the_nominal_flux() {
        let nominal = portal().heat_flux(&flow());
        let margined = portal().margined(&nominal);
        assert_eq!(margined.convective_w_m2, nominal.convective_w_m2 * 1.3);
        assert_eq!(
            margined.total_w_m2(),
            margined.convective_w_m2 + nominal.radiative_w_m2
        );
    }

    #[test]
    fn factor_and_margin_together_are_said() {
        let peak = PeakConditions {
            density_kg_m3: 4e-4,
            speed_m_s: 1.1e4,
            nose_radius_m: 0.35,
        };
        assert!(portal().findings(&peak).is_empty());
        let mut twice = portal();
        twice.options.model_factor = 1.33;
        let findings = twice.findings(&peak);
        assert_eq!(findings.len(), 1);
        assert!(
            findings[0].message.contains("1.729"),
            "{}",
            findings[0].message
        );
        assert_eq!(
            twice.heat_flux(&flow()).convective_w_m2,
            portal().heat_flux(&flow()).convective_w_m2 * 1.33
        );
    }

    #[test]
    fn equilibrium_wall_takes_less_than_the_cold_one_and_says_so() {
        let mut hot = portal();
        hot.options.wall = Wall::RadiativeEquilibrium {
            emissivity: hot.gas.wall_emissivity,
        };
        let ratio =
            hot.heat_flux(&flow()).convective_w_m2 / portal().heat_flux(&flow()).convective_w_m2;
        assert!(ratio > 0.85 && ratio < 0.99, "{ratio}");
        let peak = PeakConditions {
            density_kg_m3: 4e-4,
            speed_m_s: 1.1e4,
            nose_radius_m: 0.35,
        };
        assert_eq!(hot.findings(&peak).len(), 1);
    }
}
