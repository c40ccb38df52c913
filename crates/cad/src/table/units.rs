//! Quantities given in several units.
//!
//! ```text
//! Altitude (km)   Altitude (ft)        one is read, in SI units if available, and the others are compared with it
//! ```
//!
//! # Valid
//! Different units; a quantity given twice in one unit is a fault, as the file does not say which to use.
//!
//! # References
//! - Own convention.

use super::layout::{Column, Sheet};
use super::{TableFault, shown};

/// Largest differences of a value in two units, relative to itself and to the largest of its column: figures are
/// rounded; assumed.
const ALIKE: [f64; 2] = [0.02, 1e-3];

/// Chooses the column to read of a quantity given in several units; the others are kept for comparison.
pub(super) fn chosen(sheet: &mut Sheet, names: &[&str], line: u64, faults: &mut Vec<TableFault>) {
    let mut columns: Vec<Column> = Vec::with_capacity(sheet.columns.len());
    let mut spares = Vec::new();
    let name = |column: &Column| names.get(column.place).map_or(String::new(), |n| shown(n));
    for column in &sheet.columns {
        if columns.iter().any(|c| c.quantity == column.quantity) {
            continue;
        }
        let same: Vec<&Column> = sheet
            .columns
            .iter()
            .filter(|c| c.quantity == column.quantity)
            .collect();
        let named = || same.iter().filter(|c| c.named_unit);
        // SI needs no conversion; a column with a named unit is safer than one without
        let si = named().find(|c| c.factor == 1.0 && c.offset == 0.0);
        let best = **si.or(named().next()).unwrap_or(&column);
        columns.push(best);
        for other in same.iter().filter(|c| c.place != best.place) {
            let later = if other.place > best.place {
                other
            } else {
                &best
            };
            let twice = TableFault::TwiceNamed {
                line,
                column: later.place + 1,
                text: name(later),
                name: best.quantity.names().0,
            };
            if other.named_unit && (other.factor, other.offset) != (best.factor, best.offset) {
                let spare = true;
                spares.push(Column { spare, ..**other });
                sheet.twice.push(twice);
            } else {
                faults.push(twice);
            }
        }
        if same.len() > 1 {
            sheet.remarks.push(format!(
                "{} stands in several columns, of which \"{}\" is read",
                best.quantity.names().0,
                name(&best)
            ));
        }
    }
    columns.extend(spares);
    sheet.columns = columns;
}

/// A fault where the values of a quantity in two units disagree.
pub(super) fn agree(sheet: &Sheet) -> Result<(), Vec<TableFault>> {
    let [part, of_largest] = ALIKE;
    let spares = sheet.columns.iter().enumerate().filter(|(_, c)| c.spare);
    for ((place, spare), twice) in spares.zip(&sheet.twice) {
        let Some(read) = sheet.place(spare.quantity) else {
            continue;
        };
        let pairs = || {
            let pair =
                |(line, row): &(u64, Vec<f64>)| Some((*line, *row.get(read)?, *row.get(place)?));
            sheet.rows.iter().filter_map(pair)
        };
        let largest = pairs().map(|(_, value, _)| value.abs()).fold(0.0, f64::max);
        if largest == 0.0 {
            return Err(vec![twice.clone()]);
        }
        let apart = pairs()
            .find(|(_, a, b)| (a - b).abs() > part * a.abs().max(b.abs()) + of_largest * largest);
        if let Some((line, value, other)) = apart {
            return Err(vec![TableFault::Disagree {
                line,
                name: spare.quantity.names().0,
                columns: [read, place].map(|n| sheet.columns.get(n).map_or(0, |c| c.place + 1)),
                values: [value, other],
            }]);
        }
    }
    Ok(())
}
