//! The data file of an atmosphere: its gas, and its rows as columns.
//!
//! ```text
//! z in km, ρ in kg/m³, T in K, p in Pa, γ, σ of ρ in per cent: one list each, equally long
//! ```
//!
//! # Valid
//! Altitudes ascend; γ and σ may be missing.
//!
//! # References
//! - Own convention; each data file names its own.

use super::Table;
use super::row::Row;
use crate::data::Data;
use crate::planet::gas::GasData;
use serde::Deserialize;

/// A data file.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    #[serde(rename = "name")]
    _name: String,
    title: String,
    #[serde(rename = "source")]
    _source: String,
    #[serde(rename = "place")]
    _place: String,
    #[serde(rename = "note")]
    _note: String,
    gas: GasData,
    table: Columns,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Columns {
    altitude_km: Vec<f64>,
    density_kg_m3: Vec<f64>,
    temperature_k: Vec<f64>,
    pressure_pa: Vec<f64>,
    #[serde(default)]
    heat_capacity_ratio: Vec<f64>,
    #[serde(default)]
    density_sigma_percent: Vec<f64>,
    /// Above it the rows are assumed.
    assumed_above_km: Option<f64>,
}

impl Table {
    /// Title and atmosphere of a data file.
    pub fn parse(data: Data) -> Result<(String, Self), String> {
        let file: File = data.read()?;
        let columns = &file.table;
        let height = columns.altitude_km.len();
        let optional = |column: &[f64]| column.is_empty() || column.len() == height;
        let whole = [
            &columns.density_kg_m3,
            &columns.temperature_k,
            &columns.pressure_pa,
        ];
        if height < 2
            || whole.iter().any(|column| column.len() != height)
            || !optional(&columns.heat_capacity_ratio)
            || !optional(&columns.density_sigma_percent)
        {
            return Err("table: columns must be equally long, two rows at least".to_string());
        }
        let ascending = columns.altitude_km.is_sorted_by(|a, b| a < b);
        let positive = |column: &&Vec<f64>| column.iter().all(|x| *x > 0.0 && x.is_finite());
        if !ascending || !whole.iter().all(positive) {
            return Err("table: altitudes must ascend, the rest be above 0".to_string());
        }
        let at = |column: &[f64], i: usize| column.get(i).copied();
        let rows: Vec<Row> = (columns.altitude_km.iter().enumerate())
            .filter_map(|(i, altitude_km)| {
                Some(Row {
                    altitude_m: altitude_km * 1000.0,
                    density_kg_m3: at(&columns.density_kg_m3, i)?,
                    temperature_k: at(&columns.temperature_k, i),
                    pressure_pa: at(&columns.pressure_pa, i),
                    heat_capacity_ratio: at(&columns.heat_capacity_ratio, i),
                })
            })
            .collect();
        let sigmas = rows.iter().zip(&columns.density_sigma_percent);
        let density_sigma = sigmas.map(|(row, percent)| [row.altitude_m, percent / 100.0]);
        let table = Self {
            density_sigma: density_sigma.collect(),
            assumed_above_m: columns.assumed_above_km.map(|km| km * 1000.0),
            ..Self::of_rows(&rows, file.gas.gas()?, None)
        };
        Ok((file.title, table))
    }
}
