//! Tables of aerodynamic coefficients from a file, and of drag over the Mach number where there is no angle.
//!
//! ```text
//! columns by name: mach, alpha, knudsen or altitude, ca, cn, cm, or cd, cl, cm, and cmq
//! ```
//!
//! # Valid
//! Angles in deg unless the heading says rad, moments about the virtual apex with the diameter as length. Rows in any order,
//! without holes.
//!
//! # References
//! - Own convention.

use super::curve::curve;
use super::layout::{Layout, Sheet};
use super::quantity::Quantity;
use super::sheet::sheet;
use super::{Table, TableFault};
use msape::aero::table::{Extrapolation, Grid, Row, in_radians};

const COEFFICIENTS: Layout = Layout {
    quantities: &[
        Quantity::Mach,
        Quantity::Alpha,
        Quantity::Knudsen,
        Quantity::Altitude,
        Quantity::AxialForce,
        Quantity::NormalForce,
        Quantity::Drag,
        Quantity::Lift,
        Quantity::Moment,
        Quantity::PitchDamping,
    ],
    bare: (&[Quantity::Mach, Quantity::Drag], 2),
    whole: true,
};
const DAMPING: Layout = Layout {
    quantities: &[
        Quantity::Mach,
        Quantity::Alpha,
        Quantity::PitchDamping,
        Quantity::Knudsen,
    ],
    bare: (
        &[
            Quantity::Mach,
            Quantity::Alpha,
            Quantity::PitchDamping,
            Quantity::Knudsen,
        ],
        3,
    ),
    whole: true,
};
/// Rows of mach, alpha_deg, ca, cn, cm, cmq, knudsen and, instead of the last, altitude_m; or of drag over the Mach number.
pub fn read(text: &str) -> Result<Table, Vec<TableFault>> {
    let mut sheet = sheet(text, &COEFFICIENTS)?;
    let angle = [Quantity::Alpha, Quantity::Lift, Quantity::NormalForce];
    if !angle.iter().any(|q| sheet.has(*q)) && sheet.has(Quantity::Drag) {
        sheet
            .remarks
            .push("without an angle of attack it is the drag of a point mass".to_owned());
        return curve(
            sheet,
            "vehicle.drag_table",
            [Quantity::Mach, Quantity::Drag],
        );
    }
    let mut faults = Vec::new();
    for quantity in [Quantity::Mach, Quantity::Alpha] {
        if !sheet.has(quantity) {
            faults.push(sheet.missing(quantity.names().0));
        }
    }
    let forces = sheet.has(Quantity::AxialForce) && sheet.has(Quantity::NormalForce);
    let lift = !forces && sheet.has(Quantity::Drag) && sheet.has(Quantity::Lift);
    if !forces && !lift {
        faults.push(TableFault::Rows(
            "header: give ca and cn, or cd and cl".to_owned(),
        ));
    }
    if sheet.has(Quantity::Knudsen) && sheet.has(Quantity::Altitude) {
        faults.push(TableFault::Rows(
            "header: give knudsen or altitude, not both".to_owned(),
        ));
    }
    faults.extend(radians(&sheet));
    if !faults.is_empty() {
        return Err(faults);
    }
    let (others, used) = if lift {
        ([Quantity::AxialForce, Quantity::NormalForce], "cd and cl")
    } else {
        ([Quantity::Drag, Quantity::Lift], "ca and cn")
    };
    for other in others {
        if sheet.has(other) {
            let name = other.names().0;
            sheet
                .remarks
                .push(format!("{name} is left out beside {used}"));
        }
    }
    let mut rows: Vec<Row> = sheet
        .rows
        .iter()
        .map(|(line, cells)| row(&sheet, *line, cells, lift))
        .collect();
    sorted(&mut rows, &mut sheet.remarks);
    table(sheet, "vehicle.aerodynamics.table", &rows, Row::cells)
}

/// Rows of mach, alpha_deg, cmq and knudsen.
pub fn damping(text: &str) -> Result<Table, Vec<TableFault>> {
    let mut sheet = sheet(text, &DAMPING)?;
    let needed = [Quantity::Mach, Quantity::Alpha, Quantity::PitchDamping];
    let mut faults: Vec<TableFault> = needed
        .into_iter()
        .filter(|q| !sheet.has(*q))
        .map(|q| sheet.missing(q.names().0))
        .collect();
    faults.extend(radians(&sheet));
    if !faults.is_empty() {
        return Err(faults);
    }
    let mut rows: Vec<Row> = sheet
        .rows
        .iter()
        .map(|(line, cells)| row(&sheet, *line, cells, false))
        .collect();
    sorted(&mut rows, &mut sheet.remarks);
    table(sheet, "vehicle.aerodynamics.damping_table", &rows, |row| {
        let mut cells = vec![row.mach, row.alpha_deg, row.cmq.unwrap_or_default()];
        cells.extend(row.knudsen);
        cells
    })
}

fn row(sheet: &Sheet, line: u64, cells: &[f64], lift: bool) -> Row {
    let value = |quantity: Quantity| sheet.value(cells, quantity);
    let unless = |left_out: bool, quantity: Quantity| value(quantity).filter(|_| !left_out);
    Row {
        line,
        mach: value(Quantity::Mach).unwrap_or_default(),
        alpha_deg: value(Quantity::Alpha).unwrap_or_default(),
        knudsen: value(Quantity::Knudsen),
        altitude_m: value(Quantity::Altitude),
        ca: unless(lift, Quantity::AxialForce),
        cn: unless(lift, Quantity::NormalForce),
        cd: unless(!lift, Quantity::Drag),
        cl: unless(!lift, Quantity::Lift),
        cm: value(Quantity::Moment),
        cmq: value(Quantity::PitchDamping),
    }
}

/// Checks the rows as a table and puts them into the order of the input.
fn table(
    sheet: Sheet,
    key: &'static str,
    rows: &[Row],
    cells: fn(&Row) -> Vec<f64>,
) -> Result<Table, Vec<TableFault>> {
    if let Err(faults) = Grid::try_new(rows, Extrapolation::Hold) {
        return Err(faults.into_iter().map(TableFault::Rows).collect());
    }
    Ok(Table {
        key,
        rows: rows.iter().map(cells).collect(),
        remarks: sheet.remarks,
    })
}

/// Puts rows into the order Mach, Knudsen number or altitude, angle.
fn sorted(rows: &mut [Row], remarks: &mut Vec<String>) {
    let order = |a: &Row, b: &Row| {
        let key = |row: &Row| {
            [
                row.mach,
                row.knudsen.or(row.altitude_m).unwrap_or(0.0),
                row.alpha_deg,
            ]
        };
        let pairs = key(a).into_iter().zip(key(b));
        pairs.fold(std::cmp::Ordering::Equal, |found, (a, b)| {
            found.then(a.total_cmp(&b))
        })
    };
    if !rows.is_sorted_by(|a, b| order(a, b).is_le()) {
        rows.sort_by(order);
        remarks.push("the rows are put into the order Mach number, Knudsen number or altitude, angle of attack".to_owned());
    }
}

/// A fault where angles without unit end at a part of pi.
fn radians(sheet: &Sheet) -> Option<TableFault> {
    let place = sheet.place(Quantity::Alpha)?;
    let named = sheet
        .columns
        .get(place)
        .is_some_and(|column| column.named_unit);
    let angles = sheet
        .rows
        .iter()
        .filter_map(|(_, row)| row.get(place).map(|alpha| alpha.abs()));
    let largest = angles.fold(0.0, f64::max);
    (!named && in_radians(largest)).then_some(TableFault::Radians(largest))
}
