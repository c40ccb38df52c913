//! Heat fluxes over speed and density from a file, of the stagnation point or of points along the forebody.
//!
//! ```text
//! columns by name: speed, density, convective and radiative, or total; r or s as a fraction
//! ```
//!
//! # Valid
//! Each speed with each density, in any order, without holes. A total heat flux stands as convective beside radiative fluxes of 0.
//!
//! # References
//! - Own convention.

use super::columns::without_unit;
use super::layout::Layout;
use super::quantity::Quantity;
use super::sheet::sheet;
use super::{Table, TableFault};
use msape::aero::table::Extrapolation;
use msape::heating::given::GivenHeating;
use msape::heating::given::body::{Along, BodyHeating};

const HEATING: Layout = Layout {
    quantities: &[
        Quantity::Speed,
        Quantity::Density,
        Quantity::Convective,
        Quantity::Radiative,
        Quantity::TotalHeat,
        Quantity::RadiusFraction,
        Quantity::ArcFraction,
    ],
    bare: (
        &[
            Quantity::Speed,
            Quantity::Density,
            Quantity::Convective,
            Quantity::Radiative,
        ],
        4,
    ),
    whole: true,
};

/// Rows of speed, density and heat fluxes; before them the fraction, where the file has one.
pub fn read(text: &str) -> Result<Table, Vec<TableFault>> {
    let mut sheet = sheet(text, &HEATING)?;
    let needed = [Quantity::Speed, Quantity::Density];
    let mut faults: Vec<TableFault> = needed
        .into_iter()
        .filter(|q| !sheet.has(*q))
        .map(|q| sheet.missing(q.names().0))
        .collect();
    let [convective, radiative, total, radius, arc] = [
        Quantity::Convective,
        Quantity::Radiative,
        Quantity::TotalHeat,
        Quantity::RadiusFraction,
        Quantity::ArcFraction,
    ]
    .map(|q| sheet.has(q));
    let along = match (radius, arc) {
        (true, true) => {
            let fault = "header: give r or s as a fraction, not both";
            faults.push(TableFault::Rows(fault.to_owned()));
            None
        }
        (true, false) => Some((
            Quantity::RadiusFraction,
            Along::Radius,
            "heating.radius_table",
        )),
        (false, true) => Some((Quantity::ArcFraction, Along::Arc, "heating.arc_table")),
        (false, false) => None,
    };
    let by_parts = convective && (radiative || along.is_none());
    if !by_parts && (convective || radiative || !total) {
        let also = match along {
            Some(_) => "convective and radiative heat flux, or total",
            None => "convective heat flux, if wanted with radiative, or total",
        };
        faults.push(TableFault::Rows(format!("header: give {also}")));
    }
    if !faults.is_empty() {
        return Err(faults);
    }
    if by_parts && total {
        let remark = "total is left out beside convective";
        sheet.remarks.push(remark.to_owned());
    }
    if !by_parts {
        let remark = "the total heat flux counts as convective, with its margin, and there is no radiative one beside it";
        sheet.remarks.push(remark.to_owned());
    } else if !radiative {
        let remark = "without a radiative heat flux the relation of the case stays for it";
        sheet.remarks.push(remark.to_owned());
    }
    sheet.remarks.extend(without_unit(&sheet));
    let row = |cells: &[f64]| {
        let value = |q: Quantity| sheet.value(cells, q);
        let mut row: Vec<f64> = along.iter().filter_map(|(q, ..)| value(*q)).collect();
        row.extend(needed.into_iter().filter_map(value));
        if by_parts {
            row.extend(value(Quantity::Convective));
            row.extend(value(Quantity::Radiative));
        } else {
            row.extend(
                value(Quantity::TotalHeat)
                    .map(|total| [total, 0.0])
                    .into_iter()
                    .flatten(),
            );
        }
        row
    };
    let rows: Vec<Vec<f64>> = sheet.rows.iter().map(|(_, cells)| row(cells)).collect();
    let hold = Extrapolation::Hold;
    let (key, checked) = match along {
        None => {
            let key = "heating.table";
            (key, GivenHeating::try_new(key, &rows, hold).map(drop))
        }
        Some((_, along, key)) => (key, BodyHeating::try_new(key, along, &rows, hold).map(drop)),
    };
    match checked {
        Err(faults) => Err(faults.into_iter().map(TableFault::Rows).collect()),
        Ok(()) => Ok(Table {
            key,
            rows,
            remarks: sheet.remarks,
        }),
    }
}
