//! Density and molar mass of the gases together.
//!
//! ```text
//! ρ = Σ nᵢ Mᵢ / N_A,   M = Σ nᵢ Mᵢ / Σ nᵢ
//! ```
//!
//! with n in 1/m³, M in kg/kmol, N_A in 1/kmol, ρ in kg/m³, and the slopes of both by altitude.
//!
//! # Valid
//! Wherever one gas at least has a density above 0.
//!
//! # References
//! - \[coesa-1976\].

use super::SpanKnots;
use crate::Knot;

/// Sums over the gases: n, n M and their slopes.
#[derive(Default)]
pub struct Sums {
    /// Number density, 1/m³, and its slope, 1/m⁴.
    n: f64,
    n_slope: f64,
    /// n M, kg/(kmol m³), and its slope.
    mass: f64,
    mass_slope: f64,
}

impl Sums {
    /// Adds a gas: n and its slope, and M.
    pub fn add(&mut self, n: f64, slope: f64, molar_mass_kg_kmol: f64) {
        self.n += n;
        self.n_slope += slope;
        self.mass += n * molar_mass_kg_kmol;
        self.mass_slope += slope * molar_mass_kg_kmol;
    }

    /// Density and molar mass as the next knots.
    pub fn push(&self, avogadro_per_kmol: f64, knots: &mut SpanKnots) {
        let Self {
            n,
            n_slope,
            mass,
            mass_slope,
        } = self;
        let (m, per_kg) = (mass / n, avogadro_per_kmol);
        knots.density.push(Knot {
            value: mass / per_kg,
            slope_per_m: mass_slope / per_kg,
        });
        knots.molar_mass.push(Knot {
            value: m,
            slope_per_m: m * (mass_slope / mass - n_slope / n),
        });
    }
}
