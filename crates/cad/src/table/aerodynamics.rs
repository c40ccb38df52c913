//! Tables of aerodynamic coefficients from a file, and of drag against Mach number where there is no angle.
//!
//! ```text
//! columns by name: mach, alpha, knudsen or altitude, ca, cn, cm, or cd, cl, cm, and cmq
//! ```
//!
//! # Valid
//! Angles in deg unless the heading says rad; moments about the virtual apex with the diameter as reference length.
//! Rows in any order, on a complete grid.
//!
//! # References
//! - Own convention.

use super::curve::curve;
use super::layout::{Layout, Sheet};
use super::quantity::Quantity;
use super::sheet::sheet;
use super::{Table, TableFault};
use msape::aero::table::{Extrapolation, Grid, Row, in_radians};
use msape::quantity::input;
use numerics::math::{PI, RADIANS_PER_DEGREE};

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
/// Largest distance from a whole degree of an angle printed in rad with at least four decimals, deg: 0.00005 rad are
/// 0.003 deg.
const WHOLE_DEG: f64 = 3e-3;
/// Largest Mach number of a table.
const MOST_MACH: f64 = 1000.0;
/// Largest difference of mirrored coefficients: tables are printed with three or four decimals.
const ALIKE: f64 = 2e-3;
/// Largest difference of angles that count as equal, deg.
const SAME_DEG: f64 = 1e-9;

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
/// Rows of mach, alpha_deg, ca, cn, cm, cmq, knudsen and, instead of the last, altitude_m; or of drag against Mach
/// number.
pub fn read(text: &str) -> Result<Table, Vec<TableFault>> {
    let mut sheet = sheet(text, &COEFFICIENTS)?;
    let angle = [Quantity::Alpha, Quantity::Lift, Quantity::NormalForce];
    if !angle.iter().any(|q| sheet.has(*q)) && sheet.has(Quantity::Drag) {
        sheet
            .remarks
            .push("without an angle of attack it is the drag of a point mass".to_owned());
        return curve(
            sheet,
            input::vehicle::DRAG_TABLE.key,
            [Quantity::Mach, Quantity::Drag],
        );
    }
    let mut faults = Vec::new();
    if !sheet.has(Quantity::Alpha) {
        if !sheet.has(Quantity::Mach) {
            faults.push(sheet.missing(Quantity::Mach.names().0));
        }
        faults.push(sheet.missing(Quantity::Alpha.names().0));
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
    if !sheet.has(Quantity::Mach) {
        sheet
            .remarks
            .push("without a Mach number its coefficients count at every one".to_owned());
        rows = of_every_mach(&rows);
    }
    sorted(&mut rows, &mut sheet.remarks);
    without_mirrored(&mut rows, &mut sheet.remarks);
    table(
        sheet,
        input::vehicle::AERODYNAMICS_TABLE.key,
        &rows,
        Row::cells,
    )
}

/// The rows repeated at the smallest and the largest Mach number allowed, for a table without Mach number.
fn of_every_mach(rows: &[Row]) -> Vec<Row> {
    let at = |mach: f64| rows.iter().map(move |row| Row { mach, ..*row });
    at(0.0).chain(at(MOST_MACH)).collect()
}

/// Removes the rows below 0 deg if each mirrors one above; those above may extend to larger angles.
fn without_mirrored(rows: &mut Vec<Row>, remarks: &mut Vec<String>) {
    let above: Vec<Row> = rows
        .iter()
        .filter(|r| r.alpha_deg >= 0.0)
        .copied()
        .collect();
    let mirrors = |row: &Row, other: &Row| {
        let place = |r: &Row| [r.mach, r.knudsen.or(r.altitude_m).unwrap_or(0.0)];
        let same = |a: Option<f64>, b: Option<f64>| match (a, b) {
            (Some(a), Some(b)) => (a - b).abs() <= ALIKE,
            (a, b) => a.is_none() && b.is_none(),
        };
        let turned = |value: Option<f64>| value.map(|value| -value);
        // normal force, lift and moment are odd in the angle, the others even
        place(row) == place(other)
            && (row.alpha_deg + other.alpha_deg).abs() < SAME_DEG
            && same(row.ca, other.ca)
            && same(row.cd, other.cd)
            && same(row.cmq, other.cmq)
            && same(row.cn, turned(other.cn))
            && same(row.cl, turned(other.cl))
            && same(row.cm, turned(other.cm))
    };
    let below = rows.len() - above.len();
    let all = rows
        .iter()
        .filter(|row| row.alpha_deg < 0.0)
        .all(|row| above.iter().any(|other| mirrors(row, other)));
    if below > 0 && all {
        remarks.push("the angles below 0 deg mirror those above and are left out".to_owned());
        *rows = above;
    }
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
    table(
        sheet,
        input::vehicle::AERODYNAMICS_DAMPING_TABLE.key,
        &rows,
        |row| {
            let mut cells = vec![row.mach, row.alpha_deg, row.cmq.unwrap_or_default()];
            cells.extend(row.knudsen);
            cells
        },
    )
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

/// Checks the rows as a table and puts the columns into the order of the input.
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

/// Sorts rows by Mach number, Knudsen number or altitude, and angle.
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

/// A fault where angles without unit appear to be in radians.
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
    let largest = angles.clone().fold(0.0, f64::max);
    // every angle is a whole number of degrees when read as radians
    let whole = |angle: f64| {
        let deg = angle / RADIANS_PER_DEGREE;
        deg >= 0.5 && (deg - deg.round()).abs() < WHOLE_DEG
    };
    let all =
        angles.filter(|angle| *angle > 0.0).all(whole) && largest > 0.0 && largest <= 2.0 * PI;
    (!named && (all || in_radians(largest))).then_some(TableFault::Radians(largest))
}
