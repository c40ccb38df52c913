//! Atomic hydrogen above 150 km, which flows upward through the other gases.
//!
//! ```text
//! n = [n₁₁ + ∫_z^500 φ/D (T/T₁₁)^(1+α) e^τ dz] (T₁₁/T)^(1+α) e^(−τ)
//! τ = ∫_500^z g M/(R* T) dz,   D = a/N (T/273.15)^b
//! ```
//!
//! with n in 1/m³, φ in 1/(m² s), D in m²/s, T in K, z in m, M in kg/kmol, N the sum of the other gases in 1/m³.
//! Above 500 km φ is zero.
//!
//! # Valid
//! 150 to 1000 km.
//!
//! # References
//! - \[coesa-1976\] equation 39.

use super::{FLUX_TOP_KM, HEAVY, Heterosphere, Span, Z11_M};
use crate::definition::Definition;
use crate::temperature::Segment;
use numerics::math;
use numerics::quadrature::Rule;

impl Heterosphere<'_> {
    /// Number density of atomic hydrogen, 1/m³, and its slope, 1/m⁴, at the knots; nothing below 150 km.
    pub(super) fn hydrogen(&self, span: &Span, cells: usize) -> Vec<(f64, f64)> {
        let Some(h) = self.definition.species.get(HEAVY) else {
            return Vec::new();
        };
        if span.from_m < FLUX_TOP_KM * 1000.0 {
            return Vec::new();
        }
        let Definition {
            diffusion,
            constants,
            ..
        } = self.definition;
        let temperature = |z: f64| self.upper.temperature_k(Segment::Exponential, z);
        let t_11 = temperature(Z11_M);
        let at_11 = self.gravity_integral(Z11_M, t_11);
        // (T/T₁₁)^(1+α) e^τ
        let weight = |z: f64, t: f64| {
            let tau = h.molar_mass_kg_kmol * (self.gravity_integral(z, t) - at_11);
            math::exp((1.0 + h.thermal_diffusion) * math::ln(t / t_11) + tau)
        };
        let flux = if span.from_m < Z11_M {
            diffusion.flux_of_h_per_m2_s
        } else {
            0.0
        };
        // φ/D
        let source = |z: f64, t: f64| {
            let mut n = 0.0;
            for (log, transported) in self.logs_above_120_km(z, t).iter().zip(&self.fluxes) {
                n += math::exp(log - transported.at(z)) / t;
            }
            flux * n / h.diffusion_a_per_m_s / math::exp(h.diffusion_b * math::ln(t / 273.15))
        };
        let integrand = |z: f64| {
            let t = temperature(z);
            source(z, t) * weight(z, t)
        };
        let mut from_above = diffusion.h_at_500_km_per_m3;
        let mut knots = Vec::with_capacity(cells + 1);
        for i in (0..=cells).rev() {
            let z = span.from_m + i as f64 * span.cell_m;
            if flux > 0.0 && i < cells {
                from_above += Rule::Gauss5.integral(integrand, [z, z + span.cell_m]);
            }
            let t = temperature(z);
            let n = if flux > 0.0 {
                from_above
            } else {
                diffusion.h_at_500_km_per_m3
            } / weight(z, t);
            let fall =
                (1.0 + h.thermal_diffusion) * self.upper.gradient_k_m(Segment::Exponential, z) / t
                    + h.molar_mass_kg_kmol * self.gravity_m_s2(z)
                        / (constants.gas_constant_j_kmol_k * t);
            knots.push((n, -source(z, t) - n * fall));
        }
        knots.reverse();
        knots
    }
}
