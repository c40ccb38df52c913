//! One row of an atmosphere.
//!
//! ```text
//! p = ρ R T,   M = R* ρ T/p
//! ```
//!
//! with p in Pa, ρ in kg/m³, T in K, R in J/(kg K), R* in J/(kmol K), M in kg/kmol.
//!
//! # Valid
//! A perfect gas.
//!
//! # References
//! - Own convention.

use crate::planet::gas::GAS_CONSTANT_J_KMOL_K;

/// The air of one row; what is not given is absent.
#[derive(Clone, Copy, Debug)]
pub(super) struct Row {
    /// Altitude, m.
    pub altitude_m: f64,
    /// Density, kg/m³.
    pub density_kg_m3: f64,
    /// Temperature, K.
    pub temperature_k: Option<f64>,
    /// Pressure, Pa.
    pub pressure_pa: Option<f64>,
    /// Ratio of the heat capacities.
    pub heat_capacity_ratio: Option<f64>,
}

impl Row {
    /// Air of the columns that are given, the rest of the gas; a column of zeros is not given.
    pub fn of_cells(cells: &[f64], given: [bool; 3], gas_constant_j_kg_k: f64) -> Option<Row> {
        let cell = |i: usize| (*given.get(i)?).then(|| cells.get(i + 1).copied())?;
        let (density, temperature_k, pressure_pa) = (cell(0), cell(1), cell(2));
        let r = gas_constant_j_kg_k;
        // p = ρ R T
        let density_of = || Some(pressure_pa? / (temperature_k? * r));
        let temperature_of = |density: f64| Some(pressure_pa? / (density * r));
        let density_kg_m3 = density.or_else(density_of)?;
        Some(Row {
            altitude_m: *cells.first()?,
            density_kg_m3,
            temperature_k: temperature_k.or_else(|| temperature_of(density_kg_m3)),
            pressure_pa,
            heat_capacity_ratio: None,
        })
    }

    /// Molar mass that density, temperature and pressure make, kg/kmol.
    pub fn molar_mass_kg_kmol(&self) -> Option<f64> {
        Some(GAS_CONSTANT_J_KMOL_K * self.density_kg_m3 * self.temperature_k? / self.pressure_pa?)
    }
}
