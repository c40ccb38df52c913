//! Pyrolysis gas in equilibrium: enthalpy, molar mass and viscosity over pressure and temperature.
//!
//! ```text
//! y(p, T)   linear in T and ln p
//! d(p²)/dx = 2 μ R T ṁ / (M K)
//! ```
//!
//! with h in J/kg, M in kg/mol, μ in Pa s, p in Pa, T in K, ṁ in kg/(m² s) towards the wall, the permeability K in m².
//!
//! # Valid
//! Within the table; beyond, its ends hold and the enthalpy goes on along T.
//!
//! # References
//! - \[pato\].

use crate::fault::{Fault, check_row};
use numerics::math;

/// Molar gas constant, J/(mol K), of the SI since 2019.
pub const GAS_CONSTANT_J_MOLK: f64 = 8.314_462_618;

/// A row of the table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GasRow {
    /// Pressure, Pa.
    pub pressure_pa: f64,
    /// Temperature, K.
    pub temperature_k: f64,
    /// Molar mass, kg/mol.
    pub molar_mass_kg_mol: f64,
    /// Enthalpy against the elements at 298.15 K, J/kg.
    pub enthalpy_j_kg: f64,
    /// Viscosity, Pa s.
    pub viscosity_pa_s: f64,
}

/// Values of the gas at a pressure and temperature.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct GasValues {
    /// Enthalpy, J/kg.
    pub enthalpy_j_kg: f64,
    /// Its slope over temperature, J/(kg K).
    pub specific_heat_j_kgk: f64,
    /// Viscosity over molar mass, Pa s mol/kg.
    pub viscosity_per_molar_mass: f64,
}

/// Table of a gas: every pressure at every temperature.
#[derive(Clone, Debug, PartialEq)]
pub struct Gas {
    ln_p: Vec<f64>,
    t: Vec<f64>,
    /// Enthalpy and viscosity over molar mass, temperature by temperature within a pressure.
    values: Vec<[f64; 2]>,
}

/// Place between two knots: index of the first and share of the second, held at the ends.
#[inline]
pub(crate) fn place(knots: &[f64], x: f64) -> (usize, f64) {
    let last = knots.len().saturating_sub(2);
    let i = knots
        .partition_point(|knot| *knot <= x)
        .saturating_sub(1)
        .min(last);
    let (Some(a), Some(b)) = (knots.get(i), knots.get(i + 1)) else {
        return (0, 0.0);
    };
    (i, ((x - a) / (b - a)).clamp(0.0, 1.0))
}

/// Distinct values, ascending.
pub(crate) fn distinct(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values.dedup();
    values
}

impl Gas {
    /// The table of the rows, in any order.
    ///
    /// # Errors
    /// Numbers that are not finite or not positive, combinations that are missing or twice, fewer than two temperatures.
    pub fn try_new(mut rows: Vec<GasRow>) -> Result<Self, Fault> {
        const OF: &str = "gas";
        for (row, n) in rows.iter().zip(1..) {
            let least = f64::MIN_POSITIVE;
            check_row(
                OF,
                n,
                &[
                    ("p_Pa", row.pressure_pa, least),
                    ("T_K", row.temperature_k, least),
                    ("M_kg_mol", row.molar_mass_kg_mol, least),
                    ("mu_Pa_s", row.viscosity_pa_s, least),
                    ("h_J_kg", row.enthalpy_j_kg, f64::MIN),
                ],
            )?;
        }
        rows.sort_by(|a, b| {
            let pressure = a.pressure_pa.total_cmp(&b.pressure_pa);
            pressure.then(a.temperature_k.total_cmp(&b.temperature_k))
        });
        let p = distinct(rows.iter().map(|row| row.pressure_pa));
        let t = distinct(rows.iter().map(|row| row.temperature_k));
        if t.len() < 2 {
            return Err(Fault::TooFew {
                of: OF,
                key: "T_K",
                rows: t.len(),
                least: 2,
            });
        }
        let regular = rows.len() == p.len() * t.len()
            && rows
                .chunks(t.len())
                .all(|sheet| sheet.iter().zip(&t).all(|(row, t)| row.temperature_k == *t));
        if !regular {
            return Err(Fault::Irregular { of: OF, key: "T_K" });
        }
        let values = rows
            .iter()
            .map(|row| {
                [
                    row.enthalpy_j_kg,
                    row.viscosity_pa_s / row.molar_mass_kg_mol,
                ]
            })
            .collect();
        Ok(Self {
            ln_p: p.iter().map(|p| math::ln(*p)).collect(),
            t,
            values,
        })
    }

    /// Values at a pressure, Pa, and temperature, K.
    #[inline]
    pub fn at(&self, pressure_pa: f64, temperature_k: f64) -> GasValues {
        let (sheet, share_p) = if self.ln_p.len() > 1 {
            place(&self.ln_p, math::ln(pressure_pa.max(f64::MIN_POSITIVE)))
        } else {
            (0, 0.0)
        };
        let n = self.t.len();
        let last = n.saturating_sub(2);
        let i = self
            .t
            .partition_point(|t| *t <= temperature_k)
            .saturating_sub(1)
            .min(last);
        let (Some(t0), Some(t1)) = (self.t.get(i), self.t.get(i + 1)) else {
            return GasValues::default();
        };
        let dt = temperature_k - t0;
        let share = dt / (t1 - t0);
        let held = share.clamp(0.0, 1.0);
        let at = |sheet: usize| {
            let j = sheet * n + i;
            let (Some([h0, v0]), Some([h1, v1])) = (self.values.get(j), self.values.get(j + 1))
            else {
                return [0.0; 3];
            };
            [
                h0 + share * (h1 - h0),
                (h1 - h0) / (t1 - t0),
                v0 + held * (v1 - v0),
            ]
        };
        let low = at(sheet);
        let [h, c, v] = if share_p == 0.0 {
            low
        } else {
            let high = at(sheet + 1);
            [0, 1, 2].map(|i| low[i] + share_p * (high[i] - low[i]))
        };
        GasValues {
            enthalpy_j_kg: h,
            specific_heat_j_kgk: c,
            viscosity_per_molar_mass: v,
        }
    }

    /// Lowest and highest temperature, K.
    pub fn covered_k(&self) -> [f64; 2] {
        [self.t.first(), self.t.last()].map(|t| t.copied().unwrap_or_default())
    }
}
