//! The U.S. Standard Atmosphere 1976, from its definition: closed forms to 86 km, integrated gases to 1000 km.
//!
//! ```text
//! to 86 km       ρ(z) of one layer of linear temperature
//! 86–1000 km     ln ρ, M: cubic Hermite through knots of the integrated definition,  p = ρ N_A k T / M
//! above          ln ρ continued with its last slope
//! a = √(γ R* T / M),   L = M / (√2 π σ² N_A ρ)
//! ```
//!
//! with z in m, ρ in kg/m³, p in Pa, T in K, M in kg/kmol, a in m/s, mean free path L in m.
//!
//! # Valid
//! −5 to 1000 km. The document gives a speed of sound to 86 km only; above it is formal.
//!
//! # References
//! - \[coesa-1976\].

pub mod definition;
pub mod hermite;
pub mod heterosphere;
pub mod lower;
pub mod temperature;

use super::Air;
use definition::Definition;
use hermite::{Curve, Knot};
use heterosphere::{Heterosphere, SPANS};
use lower::Lower;
use numerics::scalar::Scalar;
use temperature::{Segment, StandardTemperature, Upper};

/// The standard atmosphere, ready for use.
#[derive(Clone, Debug, PartialEq)]
pub struct UsStandard1976 {
    temperature: StandardTemperature,
    spans: Vec<UpperSpan>,
    boundaries_m: Vec<f64>,
    gas: Gas,
}

/// What the equation of state needs.
#[derive(Clone, Debug, PartialEq)]
struct Gas {
    heat_capacity_ratio: f64,
    gas_constant_j_kmol_k: f64,
    /// N_A k, J/(kmol K).
    pressure_constant_j_kmol_k: f64,
    sea_level_molar_mass_kg_kmol: f64,
    /// 1/(√2 π σ² N_A), kmol/m².
    mean_free_path_constant: f64,
}

#[derive(Clone, Debug, PartialEq)]
struct UpperSpan {
    segment: Segment,
    ln_density: Curve,
    molar_mass: Curve,
}

impl UsStandard1976 {
    /// Lowest and highest altitude of the definition, m.
    pub const VALID_M: (f64, f64) = (-5_000.0, 1_000_000.0);

    /// The atmosphere of the data file `us-1976.toml`.
    pub fn parse(text: &str) -> Result<Self, String> {
        Ok(Self::new(&Definition::parse(text)?))
    }

    /// The atmosphere of a definition; integrates the heterosphere.
    pub fn new(definition: &Definition) -> Self {
        let c = &definition.constants;
        let temperature = StandardTemperature {
            lower: Lower::new(definition),
            upper: Upper::new(definition),
        };
        let mut boundaries_m = temperature.lower.tops_m.clone();
        let mut spans = Vec::with_capacity(SPANS.len() + 1);
        for (span, knots) in SPANS
            .iter()
            .zip(Heterosphere::new(definition, &temperature.upper).knots())
        {
            spans.push(UpperSpan {
                segment: span.segment,
                ln_density: Curve::new(span.from_m, span.cell_m, &knots.ln_density),
                molar_mass: Curve::new(span.from_m, span.cell_m, &knots.molar_mass),
            });
            boundaries_m.push(span.to_m);
            if let (true, Some(density), Some(mass)) = (
                span.to_m == Self::VALID_M.1,
                knots.ln_density.last(),
                knots.molar_mass.last(),
            ) {
                spans.push(UpperSpan {
                    segment: span.segment,
                    ln_density: Curve::line(span.to_m, *density),
                    molar_mass: Curve::line(
                        span.to_m,
                        Knot {
                            slope_per_m: 0.0,
                            ..*mass
                        },
                    ),
                });
            }
        }
        let gas = Gas {
            heat_capacity_ratio: c.heat_capacity_ratio,
            gas_constant_j_kmol_k: c.gas_constant_j_kmol_k,
            pressure_constant_j_kmol_k: c.avogadro_per_kmol * c.boltzmann_j_k,
            sea_level_molar_mass_kg_kmol: c.sea_level_molar_mass_kg_kmol,
            mean_free_path_constant: lower::mean_free_path_constant(definition),
        };
        Self {
            temperature,
            spans,
            boundaries_m,
            gas,
        }
    }

    /// Temperature of this atmosphere by altitude, for models that bring a density only.
    pub fn standard_air(&self) -> super::StandardAir {
        super::StandardAir {
            temperature: self.temperature.clone(),
            heat_capacity_ratio: self.gas.heat_capacity_ratio,
            gas_constant_j_kg_k: self.gas.gas_constant_j_kmol_k
                / self.gas.sea_level_molar_mass_kg_kmol,
            mean_free_path_kg_m2: self.gas.mean_free_path_constant
                * self.gas.sea_level_molar_mass_kg_kmol,
        }
    }

    /// Altitudes between the smooth pieces, m, ascending.
    pub fn boundaries_m(&self) -> &[f64] {
        &self.boundaries_m
    }

    fn span(&self, layer: usize) -> Option<&UpperSpan> {
        self.spans
            .get(layer.saturating_sub(self.temperature.lower.layers.len()))
            .or(self.spans.last())
    }

    /// Density of one piece, kg/m³.
    #[inline]
    pub fn density_in<S: Scalar>(&self, layer: usize, altitude_m: S) -> S {
        if let Some(lower) = self.temperature.lower.layers.get(layer) {
            return lower.density_kg_m3(altitude_m);
        }
        self.span(layer).map_or(S::constant(0.0), |span| {
            span.ln_density.at(altitude_m).exp()
        })
    }

    /// Everything of one piece.
    #[inline]
    pub fn air_in<S: Scalar>(&self, layer: usize, altitude_m: S) -> Air<S> {
        let Gas {
            heat_capacity_ratio,
            gas_constant_j_kmol_k,
            sea_level_molar_mass_kg_kmol: m_0,
            ..
        } = self.gas;
        let (pressure_pa, density_kg_m3, temperature_k, m) =
            if let Some(lower) = self.temperature.lower.layers.get(layer) {
                let (p, rho, t_m) = lower.state(altitude_m);
                let ratio = self.temperature.lower.ratio.at(altitude_m);
                (p, rho, t_m * ratio, ratio * m_0)
            } else if let Some(span) = self.span(layer) {
                let rho = span.ln_density.at(altitude_m).exp();
                let m = span.molar_mass.at(altitude_m);
                let t = self
                    .temperature
                    .upper
                    .temperature_k(span.segment, altitude_m);
                (rho * t / m * self.gas.pressure_constant_j_kmol_k, rho, t, m)
            } else {
                (
                    S::constant(0.0),
                    S::constant(0.0),
                    S::constant(0.0),
                    S::constant(m_0),
                )
            };
        Air {
            density_kg_m3,
            pressure_pa,
            temperature_k,
            speed_of_sound_m_s: (temperature_k / m * (heat_capacity_ratio * gas_constant_j_kmol_k))
                .sqrt(),
            mean_free_path_m: lower::mean_free_path_m(
                self.gas.mean_free_path_constant,
                m,
                density_kg_m3,
            ),
        }
    }
}

#[cfg(test)]
mod tests;
