//! Rows of an atmosphere from a file.
//!
//! ```text
//! ρ = p / (R T)                            where the file gives no density, as in a sounding
//! H₂ − H₁ = R T̄ / g₀ · ln(p₁ / p₂)         between two pressure altitudes
//! ```
//!
//! with H in m, R in J/(kg K) (on the Earth R*/M₀ of the standard atmosphere), p in Pa, T in K, T̄ the logarithmic mean
//! of two rows, that of a temperature linear between them, g₀ = 9.80665 m/s².
//!
//! # Valid
//! Density from the gas of the planet. Pressure altitude only on the Earth, where it is the geopotential altitude at
//! which the standard atmosphere has the pressure; the lowest row is assumed to be at its own pressure altitude, as the
//! pressure at sea level is unknown.
//!
//! # References
//! - \[coesa-1976\] for geopotential altitude, constants and pressure; \[wmo-8\] for soundings.

use super::altitude::{G_0_M_S2, Heights, MIXED_TO_M, geometric_m};
use super::columns::without_unit;
use super::curve::{ascending, in_order};
use super::layout::{Layout, Sheet};
use super::quantity::Quantity;
use super::sheet::sheet;
use super::{Ground, Table, TableFault};
use msape::quantity::input;
use numerics::math::ln;

/// Largest plausible density, kg/m³; 65 at the surface of Venus in the shipped atmosphere; assumed.
const DENSEST_KG_M3: f64 = 100.0;
/// Smallest plausible scale height, m: a tenth of the lowest of the shipped planets; assumed.
const THINNEST_M: f64 = 300.0;
/// Fraction of the Earth's standard pressure below which a pressure without unit cannot be in Pa; assumed.
const LOW: f64 = 0.05;
/// Least ratio of densities from which a scale height is judged; assumed.
const TELLING: f64 = 2.0;

const ATMOSPHERE: Layout = Layout {
    quantities: &[
        Quantity::Altitude,
        Quantity::Geopotential,
        Quantity::PressureAltitude,
        Quantity::Density,
        Quantity::Temperature,
        Quantity::Pressure,
    ],
    bare: (
        &[
            Quantity::Altitude,
            Quantity::Density,
            Quantity::Temperature,
            Quantity::Pressure,
        ],
        2,
    ),
    whole: false,
};

/// Altitude, density and, where the file has them, temperature and pressure.
pub fn read(text: &str, ground: &Ground) -> Result<Table, Vec<TableFault>> {
    let mut sheet = sheet(text, &ATMOSPHERE)?;
    let heights = Heights::of(&sheet, ground)?;
    let [has_density, has_temperature, has_pressure] =
        [Quantity::Density, Quantity::Temperature, Quantity::Pressure].map(|q| sheet.has(q));
    let gas_constant = ground.gas_constant_j_kg_k;
    let pressures = has_pressure || heights == Heights::Pressure;
    let from_pressure = !has_density && has_temperature && pressures;
    if !has_density && !from_pressure {
        return Err(vec![sheet.missing("density")]);
    }
    let r = match (from_pressure || heights == Heights::Pressure, gas_constant) {
        (true, None) => return Err(vec![TableFault::UnknownGas]),
        (_, gas_constant) => gas_constant.unwrap_or_default(),
    };
    if has_pressure && !has_temperature {
        sheet
            .remarks
            .push("the pressure is left out, as there is no temperature beside it".to_owned());
    }
    if from_pressure {
        sheet.remarks.push(format!(
            "density is p/(R T) of the planet's gas with R = {r:.3} J/(kg K)"
        ));
    }
    let mut rows: Vec<(u64, Vec<f64>)> = Vec::with_capacity(sheet.rows.len());
    for (line, row) in &sheet.rows {
        let value = |q: Quantity| sheet.value(row, q);
        let altitude_m = heights.altitude_m(&sheet, row, ground);
        let standard = ground
            .standard
            .as_ref()
            .filter(|_| heights == Heights::Pressure);
        let of_altitude = standard.map(|air| {
            air.air(geometric_m(altitude_m, ground.radius_m))
                .pressure_pa
        });
        // a pressure altitude gives the pressure directly
        let pressure_pa = of_altitude.or(value(Quantity::Pressure));
        let given_k = value(Quantity::Temperature);
        let given_kg_m3 = value(Quantity::Density);
        let density_kg_m3 = given_kg_m3.or_else(|| Some(pressure_pa? / (r * given_k?)));
        let temperature_k = given_k.or_else(|| Some(of_altitude? / (r * given_kg_m3?)));
        let mut cells = vec![altitude_m, density_kg_m3.unwrap_or_default()];
        cells.extend(temperature_k);
        if temperature_k.is_some() {
            cells.extend(pressure_pa);
        }
        rows.push((*line, cells));
    }
    if sheet.headed {
        has_its_unit(&sheet, &rows, ground)?;
    } else {
        falls_with_height(&rows)?;
        is_density(&rows)?;
    }
    if !sheet.has_unit(Quantity::Altitude) {
        is_in_meters(&rows)?;
    }
    sheet.remarks.extend(without_unit(&sheet));
    sheet.remarks.extend(heights.remark(ground));
    ascending(&mut rows, "altitude", &mut sheet.remarks);
    without_repeats(&mut rows, &mut sheet.remarks);
    in_order(&rows, "altitude")?;
    let mut rows: Vec<Vec<f64>> = rows.into_iter().map(|(_, row)| row).collect();
    if heights == Heights::Pressure {
        stacked(&mut rows, r, ground);
    }
    Ok(Table {
        key: input::atmosphere::TABLE.key,
        rows,
        remarks: sheet.remarks,
    })
}

/// Geopotential heights of rows given at pressure altitudes, m: each layer has the thickness of its mean temperature.
fn stacked(rows: &mut [Vec<f64>], gas_constant: f64, ground: &Ground) {
    let mut below: Option<[f64; 3]> = None;
    for row in rows {
        let [altitude, _, temperature, pressure] = row.as_mut_slice() else {
            continue;
        };
        let height = below.map_or(*altitude, |[height, pressure_below, temperature_below]| {
            let warmer = *temperature - temperature_below;
            // the logarithmic mean of equal temperatures is 0/0
            let mean = if warmer == 0.0 {
                *temperature
            } else {
                warmer / ln(*temperature / temperature_below)
            };
            height + gas_constant * mean / G_0_M_S2 * ln(pressure_below / *pressure)
        });
        below = Some([height, *pressure, *temperature]);
        *altitude = geometric_m(height, ground.radius_m);
    }
}

/// Removes rows at the altitude of the previous row, which soundings contain.
pub(super) fn without_repeats(rows: &mut Vec<(u64, Vec<f64>)>, remarks: &mut Vec<String>) {
    let before = rows.len();
    rows.dedup_by(|b, a| a.1 == b.1);
    if rows.len() < before {
        remarks.push(format!(
            "{} repeated rows are left out",
            before - rows.len()
        ));
    }
}

/// A fault where temperatures without unit cannot be in K, or pressures on the Earth cannot be in Pa.
fn has_its_unit(
    sheet: &Sheet,
    rows: &[(u64, Vec<f64>)],
    ground: &Ground,
) -> Result<(), Vec<TableFault>> {
    let fault = |line: u64, name, value, taken, such| TableFault::NoUnit {
        line,
        name,
        value,
        taken,
        such,
    };
    for ((line, cells), (_, row)) in sheet.rows.iter().zip(rows) {
        let of = |q: Quantity| sheet.value(cells, q).filter(|_| !sheet.has_unit(q));
        if let Some(value) = of(Quantity::Temperature).filter(|t| *t <= 0.0) {
            let found = fault(*line, "temperature", value, "K", "temperature_C");
            return Err(vec![found]);
        }
        let standard = ground.standard.as_ref().filter(|_| row[0] <= MIXED_TO_M);
        if let (Some(value), Some(air)) = (of(Quantity::Pressure), standard)
            && value < LOW * air.air(row[0]).pressure_pa
        {
            let found = fault(*line, "pressure", value, "Pa", "pressure_hPa");
            return Err(vec![found]);
        }
    }
    Ok(())
}

/// A fault where a table without heading has temperatures or pressures in its second column.
fn is_density(rows: &[(u64, Vec<f64>)]) -> Result<(), Vec<TableFault>> {
    let density = |(line, row): &(u64, Vec<f64>)| Some((*line, *row.get(1)?));
    let found = rows.iter().filter_map(density);
    match found.into_iter().find(|(_, value)| *value > DENSEST_KG_M3) {
        Some((line, value)) => Err(vec![TableFault::TooDense { line, value }]),
        None => Ok(()),
    }
}

/// A fault where altitudes without unit, taken in m, give an implausibly small scale height.
fn is_in_meters(rows: &[(u64, Vec<f64>)]) -> Result<(), Vec<TableFault>> {
    let ends = rows.first().zip(rows.last());
    let Some(((_, first), (_, last))) = ends else {
        return Ok(());
    };
    let rise = (last[0] - first[0]).abs();
    let fall = (first[1] / last[1]).max(last[1] / first[1]);
    if fall.is_finite() && fall > TELLING && rise < ln(fall) * THINNEST_M {
        return Err(vec![TableFault::Steep { rise, fall }]);
    }
    Ok(())
}

/// A fault where the second column of a table without heading does not fall with height, as density does.
fn falls_with_height(rows: &[(u64, Vec<f64>)]) -> Result<(), Vec<TableFault>> {
    let ends = rows.first().zip(rows.last());
    let Some(((line, first), (last_line, last))) = ends else {
        return Ok(());
    };
    let (rises, grows) = (last[0] > first[0], last[1] >= first[1]);
    if rows.len() > 1 && rises == grows {
        let line = *line.max(last_line);
        return Err(vec![TableFault::NotADensity { line }]);
    }
    Ok(())
}
