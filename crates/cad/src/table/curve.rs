//! Curves of one quantity against another: drag and lift against Mach number, bank against time or speed.
//!
//! ```text
//! rows of equal Mach number:   replaced by their mean
//! ```
//!
//! # Valid
//! Two columns, or more of which two are named. Descending rows are reversed.
//!
//! # References
//! - Own convention.

use super::layout::{Layout, Sheet, listed};
use super::quantity::Quantity;
use super::sheet::sheet;
use super::{MOST_FAULTS, Table, TableFault};
use msape::quantity::input::{self, Input};

/// Largest relative difference of rows with equal Mach number on one curve, for rounded Mach numbers of an export;
/// assumed.
const ONE_CURVE: f64 = 0.1;
/// Largest number of lines with falling Mach number that are reported one by one.
const MOST_FALLS: usize = 3;

const DRAG: Layout = Layout {
    quantities: &[Quantity::Mach, Quantity::Drag, Quantity::Alpha],
    bare: (&[Quantity::Mach, Quantity::Drag], 2),
    whole: false,
};
const LIFT: Layout = Layout {
    quantities: &[Quantity::Mach, Quantity::Lift, Quantity::Alpha],
    bare: (&[Quantity::Mach, Quantity::Lift], 2),
    whole: false,
};
const BANK: Layout = Layout {
    quantities: &[Quantity::Time, Quantity::Speed, Quantity::Bank],
    bare: (&[Quantity::Time, Quantity::Bank], 2),
    whole: true,
};
const BANK_OVER_SPEED: Layout = Layout {
    bare: (&[Quantity::Speed, Quantity::Bank], 2),
    ..BANK
};
const BANK_SPEED_TABLE: &Input = &input::vehicle::BANK_SPEED_TABLE_DEG;

/// Mach number and drag coefficient of a point mass; from a table over the angle of attack, the rows at 0 deg.
pub fn drag(text: &str) -> Result<Table, Vec<TableFault>> {
    let sheet = sheet(text, &DRAG)?;
    curve(
        sheet,
        input::vehicle::DRAG_TABLE.key,
        [Quantity::Mach, Quantity::Drag],
    )
}

/// Mach number and lift coefficient of a point mass.
pub fn lift(text: &str) -> Result<Table, Vec<TableFault>> {
    let sheet = sheet(text, &LIFT)?;
    curve(
        sheet,
        input::vehicle::LIFT_TABLE.key,
        [Quantity::Mach, Quantity::Lift],
    )
}

/// Bank against time, or against speed where the file has a speed column or the input asks for it.
pub fn bank(text: &str, input: Option<&Input>) -> Result<Table, Vec<TableFault>> {
    let over_speed = input == Some(BANK_SPEED_TABLE);
    let sheet = sheet(text, if over_speed { &BANK_OVER_SPEED } else { &BANK })?;
    let has_time = sheet.has(Quantity::Time) && !over_speed;
    if has_time || !sheet.has(Quantity::Speed) {
        curve(
            sheet,
            input::vehicle::BANK_TABLE_DEG.key,
            [Quantity::Time, Quantity::Bank],
        )
    } else {
        curve(
            sheet,
            BANK_SPEED_TABLE.key,
            [Quantity::Speed, Quantity::Bank],
        )
    }
}

/// Rows of two columns; rows of equal Mach number are merged.
pub(super) fn curve(
    mut sheet: Sheet,
    key: &'static str,
    quantities: [Quantity; 2],
) -> Result<Table, Vec<TableFault>> {
    let missing: Vec<TableFault> = quantities
        .into_iter()
        .filter(|q| !sheet.has(*q))
        .map(|q| sheet.missing(q.names().0))
        .collect();
    if !missing.is_empty() {
        return Err(missing);
    }
    let [x, y] = quantities;
    let at_zero = |row: &[f64]| {
        sheet
            .value(row, Quantity::Alpha)
            .is_none_or(|alpha_deg| alpha_deg == 0.0)
    };
    let mut rows: Vec<(u64, Vec<f64>)> = sheet
        .rows
        .iter()
        .filter(|(_, row)| at_zero(row))
        .filter_map(|(line, row)| Some((*line, vec![sheet.value(row, x)?, sheet.value(row, y)?])))
        .collect();
    if rows.len() < sheet.rows.len() {
        let remark = format!(
            "{} of {} rows are at 0 deg of angle of attack; the others are left out",
            rows.len(),
            sheet.rows.len()
        );
        sheet.remarks.push(remark);
    }
    ascending(&mut rows, x.names().0, &mut sheet.remarks);
    let mut rows = if x == Quantity::Mach {
        let rows = means(rows, &mut sheet, y)?;
        one_branch(&rows)?;
        rows
    } else {
        rows
    };
    in_order(&rows, x.names().0)?;
    Ok(Table {
        key,
        rows: rows.drain(..).map(|(_, row)| row).collect(),
        remarks: sheet.remarks,
    })
}

/// One fault instead of many where Mach numbers fall repeatedly.
fn one_branch(rows: &[(u64, Vec<f64>)]) -> Result<(), Vec<TableFault>> {
    let mut falls = rows.windows(2).filter_map(|pair| match pair {
        [(_, a), (line, b)] => (b.first() <= a.first()).then_some(*line),
        _ => None,
    });
    match (falls.next(), falls.count()) {
        (Some(line), more) if more > MOST_FALLS => Err(vec![TableFault::Branches { line, more }]),
        _ => Ok(()),
    }
}

/// Rows of equal first number replaced by their mean; a fault where they belong to different curves.
fn means(
    rows: Vec<(u64, Vec<f64>)>,
    sheet: &mut Sheet,
    y: Quantity,
) -> Result<Vec<(u64, Vec<f64>)>, Vec<TableFault>> {
    let mut joined: Vec<(u64, Vec<f64>)> = Vec::with_capacity(rows.len());
    let (mut groups, mut widest) = (0, (0, 0.0));
    for same in rows.chunk_by(|(_, a), (_, b)| a.first() == b.first()) {
        let values = || same.iter().filter_map(|(_, row)| row.get(1).copied());
        let (Some((line, row)), Some(first)) = (same.first(), values().next()) else {
            continue;
        };
        let mut row = row.clone();
        if same.len() > 1 {
            groups += 1;
            let (low, high) = values().fold((first, first), |(low, high), value| {
                (low.min(value), high.max(value))
            });
            if high - low > widest.1 {
                widest = (*line, high - low);
            }
            if !sheet.unknown.is_empty() && high - low > ONE_CURVE * high.abs().max(low.abs()) {
                return Err(vec![TableFault::Curves {
                    line: *line,
                    mach: row.first().copied().unwrap_or_default(),
                    name: y.names().0,
                    range: [low, high],
                    others: listed(&sheet.unknown),
                }]);
            }
            if let Some(value) = row.get_mut(1) {
                *value = values().sum::<f64>() / same.len() as f64;
            }
        }
        joined.push((*line, row));
    }
    if groups > 0 {
        let apart = if widest.1 > 0.0 {
            format!("; they differ by up to {:.3} (line {})", widest.1, widest.0)
        } else {
            String::new()
        };
        sheet.remarks.push(format!(
            "at {groups} Mach numbers stands more than one row, of which the mean is taken{apart}"
        ));
    }
    Ok(joined)
}

/// Reverses descending rows.
pub(super) fn ascending(rows: &mut [(u64, Vec<f64>)], name: &str, remarks: &mut Vec<String>) {
    let first = |row: &(u64, Vec<f64>)| row.1.first().copied().unwrap_or_default();
    let descends = rows.len() > 1
        && rows
            .windows(2)
            .all(|pair| matches!(pair, [a, b] if first(a) >= first(b)))
        && rows.first().map(first) != rows.last().map(first);
    if descends {
        rows.reverse();
        remarks.push(format!("the rows descend in {name} and are turned round"));
    }
}

/// Faults of rows that do not ascend.
pub(super) fn in_order(
    rows: &[(u64, Vec<f64>)],
    name: &'static str,
) -> Result<(), Vec<TableFault>> {
    let fault = |pair: &[(u64, Vec<f64>)]| match pair {
        [(_, a), (line, b)] => match (a.first(), b.first()) {
            (Some(before), Some(value)) if value <= before => Some(TableFault::Order {
                line: *line,
                name,
                value: *value,
                before: *before,
            }),
            _ => None,
        },
        _ => None,
    };
    let faults: Vec<TableFault> = rows
        .windows(2)
        .filter_map(fault)
        .take(MOST_FAULTS)
        .collect();
    if faults.is_empty() {
        Ok(())
    } else {
        Err(faults)
    }
}
