//! Rows of wind from a file: components, or speed and the direction it blows from.
//!
//! ```text
//! east = −w sin d        north = −w cos d
//! ```
//!
//! with w the speed in m/s and d the direction the wind blows from, clockwise from north.
//!
//! # Valid
//! Horizontal wind.
//!
//! # References
//! - \[wmo-8\] for the direction of the wind.

use super::altitude::Heights;
use super::atmosphere;
use super::columns::without_unit;
use super::curve::{ascending, in_order};
use super::layout::Layout;
use super::quantity::Quantity;
use super::sheet::sheet;
use super::{Ground, Table, TableFault};
use msape::quantity::input;
use numerics::math::{RADIANS_PER_DEGREE, cos, sin};

const WIND: Layout = Layout {
    quantities: &[
        Quantity::Altitude,
        Quantity::Geopotential,
        Quantity::Eastward,
        Quantity::Northward,
        Quantity::WindSpeed,
        Quantity::WindDirection,
    ],
    bare: (
        &[Quantity::Altitude, Quantity::Eastward, Quantity::Northward],
        3,
    ),
    whole: false,
};

/// Altitude, eastward and northward wind.
pub fn read(text: &str, ground: &Ground) -> Result<Table, Vec<TableFault>> {
    let mut sheet = sheet(text, &WIND)?;
    let components = [Quantity::Eastward, Quantity::Northward];
    let polar = [Quantity::WindSpeed, Quantity::WindDirection];
    let by_components = components.iter().all(|q| sheet.has(*q));
    if !by_components && !polar.iter().all(|q| sheet.has(*q)) {
        let wanted = if polar.iter().any(|q| sheet.has(*q)) {
            polar
        } else {
            components
        };
        return Err(wanted
            .iter()
            .filter(|q| !sheet.has(**q))
            .map(|q| sheet.missing(q.names().0))
            .collect());
    }
    let heights = Heights::of(&sheet, ground)?;
    if !by_components {
        sheet
            .remarks
            .push("the direction is that from which the wind blows".to_owned());
    }
    let mut rows = Vec::with_capacity(sheet.rows.len());
    for (line, row) in &sheet.rows {
        let value = |q: Quantity| sheet.value(row, q).unwrap_or_default();
        let [east, north] = if by_components {
            components.map(value)
        } else {
            let [speed, from_rad] = [value(polar[0]), value(polar[1]) * RADIANS_PER_DEGREE];
            [-speed * sin(from_rad), -speed * cos(from_rad)]
        };
        let altitude_m = heights.altitude_m(&sheet, row, ground);
        rows.push((*line, vec![altitude_m, east, north]));
    }
    sheet.remarks.extend(without_unit(&sheet));
    sheet.remarks.extend(heights.remark(ground));
    ascending(&mut rows, "altitude", &mut sheet.remarks);
    atmosphere::without_repeats(&mut rows, &mut sheet.remarks);
    in_order(&rows, "altitude")?;
    Ok(Table {
        key: input::wind::TABLE.key,
        rows: rows.into_iter().map(|(_, row)| row).collect(),
        remarks: sheet.remarks,
    })
}
