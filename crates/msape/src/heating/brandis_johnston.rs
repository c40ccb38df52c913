//! Convective and radiative heat flux at the stagnation point for Earth entry after Brandis and Johnston.
//!
//! ```text
//! q̇ᶜ = C ρ^p V^n Rₙ^m                         two sets, below and above 9.5 km/s
//! q̇ʳ = 3.416e4 Rₙ^a ρ^1.261 f(V)              0 below 9.5 km/s
//! f   = −53.26 + 6555 / (1 + (16000/V)^8.25)
//! ```
//!
//! with q̇ in W/cm² (converted), ρ in kg/m³, V in m/s, Rₙ in m, and the capped exponent a of [`NoseExponent`].
//! Two sets of convective constants are in print; the data file holds the one used and describes the other.
//!
//! # Valid
//! 3 to 17 km/s (radiative 9.5 to 17), 1e-5 to 5e-3 kg/m³, 0.2 to 10 m. Beyond 17 km/s the formulas continue.
//!
//! # References
//! - \[brandis-johnston-2014\].

use super::nose_exponent::NoseExponent;
use super::{Flow, FlowRange, PER_CM2, PeakConditions};
use crate::data::Data;
use crate::finding::Finding;
use numerics::math;
use numerics::scalar::{Mask, Scalar};
use serde::Deserialize;

const SOURCE: &str = "Brandis & Johnston 2014, AIAA 2014-2374";

/// Both correlations: convective and radiative.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BrandisJohnston {
    /// Key of the reference.
    pub source: String,
    /// Place in it.
    pub place: String,
    /// Note on doubtful coefficients.
    pub note: String,
    /// Names of the planets whose gas they are for.
    pub planets: Vec<String>,
    /// Convective part.
    pub convective: BrandisJohnstonConvective,
    /// Radiative part.
    pub radiative: BrandisJohnstonRadiative,
}

/// Convective part.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BrandisJohnstonConvective {
    switch_m_s: f64,
    low: Power,
    high: Power,
    /// Ranges of the correlation.
    pub valid: FlowRange,
}

/// A product of powers, W/cm².
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct Power {
    c: f64,
    density_exponent: f64,
    speed_exponent: f64,
    nose_radius_exponent: f64,
}

/// Radiative part.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BrandisJohnstonRadiative {
    c: f64,
    density_exponent: f64,
    onset_m_s: f64,
    f: VelocityFunction,
    /// Exponent of the nose radius.
    pub exponent: NoseExponent,
    /// Ranges of the correlation.
    pub valid: FlowRange,
}

#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct VelocityFunction {
    offset: f64,
    amplitude: f64,
    reference_m_s: f64,
    exponent: f64,
}

impl BrandisJohnston {
    /// Reads both from the text of `heating/brandis-johnston.toml`.
    pub fn parse(data: Data) -> Result<Self, String> {
        data.read()
    }
}

impl BrandisJohnstonConvective {
    /// Speed at which the constants change from one set to the other, m/s.
    pub fn switch_m_s(&self) -> f64 {
        self.switch_m_s
    }

    /// Cold-wall heat flux, W/m².
    #[inline]
    pub fn heat_flux_w_m2<S: Scalar>(&self, flow: &Flow<S>) -> S {
        let Flow {
            density_kg_m3: rho,
            speed_m_s: v,
            nose_radius_m: r_n,
            chosen_by_m_s,
        } = *flow;
        let low = chosen_by_m_s.less(S::constant(self.switch_m_s));
        let pick = |get: fn(&Power) -> f64| {
            S::select(
                low,
                S::constant(get(&self.low)),
                S::constant(get(&self.high)),
            )
        };
        // q̇ = C ρ^p V^n Rₙ^m
        let exponent = rho.ln() * pick(|set| set.density_exponent)
            + v.ln() * pick(|set| set.speed_exponent)
            + pick(|set| set.nose_radius_exponent) * r_n.ln();
        exponent.exp() * pick(|set| set.c) * PER_CM2
    }

    /// Findings where the peak is outside the ranges.
    pub fn findings(&self, peak: &PeakConditions) -> Vec<Finding> {
        self.valid
            .findings("brandis-johnston convective", SOURCE, peak)
    }
}

impl BrandisJohnstonRadiative {
    /// Speed at which the correlation sets in, m/s.
    pub fn onset_m_s(&self) -> f64 {
        self.onset_m_s
    }

    /// Heat flux, W/m².
    #[inline]
    pub fn heat_flux_w_m2<S: Scalar>(&self, flow: &Flow<S>) -> S {
        let Flow {
            density_kg_m3: rho,
            speed_m_s: v,
            nose_radius_m: r_n,
            chosen_by_m_s,
        } = *flow;
        let below = chosen_by_m_s.less(S::constant(self.onset_m_s));
        let zero = S::constant(0.0);
        if below.all() {
            return zero;
        }
        let VelocityFunction {
            offset,
            amplitude,
            reference_m_s,
            exponent,
        } = self.f;
        let (ln_rho, ln_v) = (rho.ln(), v.ln());
        let a = self.exponent.value(ln_v, ln_rho, r_n);
        // f = −53.26 + 6555 / (1 + (16000/V)^8.25)
        let ratio = ((S::constant(math::ln(reference_m_s)) - ln_v) * exponent).exp();
        let f = S::constant(amplitude) / (ratio + 1.0) + offset;
        // q̇ = C Rₙ^a ρ^1.261 f(V)
        let q = (a * r_n.ln() + ln_rho * self.density_exponent).exp() * f * (self.c * PER_CM2);
        S::select(below, zero, q)
    }

    /// Findings where the peak is outside the ranges.
    pub fn findings(&self, peak: &PeakConditions) -> Vec<Finding> {
        if peak.speed_m_s < self.onset_m_s {
            return Vec::new();
        }
        self.valid
            .findings("brandis-johnston radiative", SOURCE, peak)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn both() -> BrandisJohnston {
        BrandisJohnston::parse(include_str!("../../data/heating/brandis-johnston.toml").into())
            .unwrap()
    }

    #[test]
    fn convective_at_unit_density_and_nose_is_c_times_v_to_n() {
        // 3162.2777 m/s = 10^3.5: 7.455e-9 × 10^(3.5 × 3.089) W/cm² = 7.455e-9 × 10^10.8115 × 1e4 W/m²
        let flow = Flow::new(1.0, math::pow(10.0, 3.5), 1.0);
        let by_hand = 7.455e-5 * math::pow(10.0, 10.8115);
        assert!((both().convective.heat_flux_w_m2(&flow) / by_hand - 1.0).abs() < 1e-12);
    }

    #[test]
    fn radiative_at_the_reference_speed_has_f_of_half_the_amplitude() {
        // V = 16 km/s: f = −53.26 + 6555/2 = 3224.24; ρ = R = 1
        let flow = Flow::new(1.0, 16000.0, 1.0);
        assert!((both().radiative.heat_flux_w_m2(&flow) / (3.416e8 * 3224.24) - 1.0).abs() < 1e-12);
        let slow = Flow::new(1.0, 9499.0, 1.0);
        assert_eq!(both().radiative.heat_flux_w_m2(&slow), 0.0);
    }

    #[test]
    fn step_at_the_switch_is_small() {
        // the source's sets meet within 2 % at flight conditions
        let at = |v| both().convective.heat_flux_w_m2(&Flow::new(2e-4, v, 0.35));
        let step: f64 = at(9500.0) / at(9499.999) - 1.0;
        assert!(step.abs() < 0.02 && step != 0.0, "{step}");
    }
}
