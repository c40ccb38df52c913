//! Convective heat flux at the stagnation point, cold wall, after Sutton and Graves.
//!
//! ```text
//! q̇ = k √(ρ / Rₙ) V³
//! ```
//!
//! with q̇ in W/m², k in kg^½/m (one a planet), ρ in kg/m³, Rₙ in m, V in m/s. The report prints eq. 8 with W/cm²; its
//! constant 1.74153e-4 gives W/m².
//!
//! # Valid
//! Laminar continuum flow, total enthalpy 2.3 to 116 MJ/kg (2.1 to 15.2 km/s).
//!
//! # References
//! - \[samareh-2014\] eq. 8; \[sutton-graves-1972\] eq. 33 and 42.

use super::{Flow, FlowRange, PeakConditions};
use crate::data::Data;
use crate::finding::Finding;
use crate::finding::range::Range;
use numerics::scalar::Scalar;
use serde::Deserialize;

/// The correlation for the gas of one planet.
#[derive(Clone, Debug, PartialEq)]
pub struct SuttonGraves {
    /// Constant of the gas, kg^½/m.
    pub k: f64,
    /// Ranges of the correlation.
    pub valid: FlowRange,
    /// Source of the constant.
    pub place: String,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
#[expect(
    dead_code,
    reason = "citations are read by people and by the tests of the data folder"
)]
struct File {
    source: String,
    place: String,
    note: String,
    gas: Vec<Gas>,
    valid: Valid,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Gas {
    planets: Vec<String>,
    k: f64,
    place: String,
    provenance: String,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Valid {
    speed_m_s: Range,
    #[serde(rename = "place")]
    _place: String,
}

impl SuttonGraves {
    /// Reads the constant of `planet` from the text of `heating/sutton-graves.toml`.
    pub fn parse(data: Data, planet: &str) -> Result<Self, String> {
        super::of_planet(Self::all(data)?, planet)
            .ok_or_else(|| format!("no Sutton-Graves constant for planet `{planet}`"))
    }

    /// Reads all constants of such a file, each with the names of its planets.
    pub fn all(data: Data) -> Result<Vec<(Vec<String>, Self)>, String> {
        let file: File = data.read()?;
        let valid = FlowRange {
            speed_m_s: file.valid.speed_m_s,
            ..FlowRange::default()
        };
        file.gas
            .into_iter()
            .map(|gas| match gas.k > 0.0 && gas.k.is_finite() {
                true => Ok((
                    gas.planets,
                    Self {
                        k: gas.k,
                        valid,
                        place: format!("{} ({})", gas.place, gas.provenance),
                    },
                )),
                false => Err(format!("k: got {} kg^0.5/m, must be above 0", gas.k)),
            })
            .collect()
    }

    /// Cold-wall heat flux, W/m².
    #[inline]
    pub fn heat_flux_w_m2<S: Scalar>(&self, flow: &Flow<S>) -> S {
        let Flow {
            density_kg_m3: rho,
            speed_m_s: v,
            nose_radius_m: r_n,
            ..
        } = *flow;
        // q̇ = k √(ρ / Rₙ) V³
        (rho / r_n).sqrt() * self.k * (v * v * v)
    }

    /// Findings where the peak is outside the ranges.
    pub fn findings(&self, peak: &PeakConditions) -> Vec<Finding> {
        self.valid.findings(
            "sutton-graves",
            "NASA TR R-376, range of total enthalpy",
            peak,
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = include_str!("../../data/heating/sutton-graves.toml");

    #[test]
    fn density_of_nose_radius_over_ten_thousand_gives_k_v3_over_a_hundred() {
        // √(1e-4) = 0.01; 1.74153e-4 × 0.01 × 1e12 = 1.74153e6 W/m²
        let model = SuttonGraves::parse(TEXT.into(), "earth").unwrap();
        let q = model.heat_flux_w_m2(&Flow::new(1e-4, 1e4, 1.0));
        assert!((q - 1.74153e6).abs() < 1e-6);
    }

    #[test]
    fn each_planet_has_its_constant_and_an_unknown_one_none() {
        assert_eq!(
            SuttonGraves::parse(TEXT.into(), "mars").unwrap().k,
            1.9027e-4
        );
        assert_eq!(
            SuttonGraves::parse(TEXT.into(), "earth-msape"),
            SuttonGraves::parse(TEXT.into(), "earth")
        );
        assert!(
            SuttonGraves::parse(TEXT.into(), "pluto")
                .unwrap_err()
                .contains("pluto")
        );
        let minus = TEXT.replacen("k = 1.9027e-4", "k = -1.0", 1);
        assert!(
            SuttonGraves::all(minus.as_str().into())
                .unwrap_err()
                .contains("got -1")
        );
    }

    #[test]
    fn speed_beyond_the_enthalpy_range_is_found() {
        let model = SuttonGraves::parse(TEXT.into(), "earth").unwrap();
        let peak = PeakConditions {
            density_kg_m3: 1e-4,
            speed_m_s: 1.2e4,
            nose_radius_m: 0.3,
        };
        assert!(model.findings(&peak).is_empty());
        assert_eq!(
            model
                .findings(&PeakConditions {
                    speed_m_s: 1.6e4,
                    ..peak
                })
                .len(),
            1
        );
    }
}
