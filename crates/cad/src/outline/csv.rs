//! Points of an outline from a CSV file, read with the common table reader.
//!
//! ```text
//! header:  x and r with their unit, such as  x (mm); r (mm)  or  x_m,r_m ; a column called bulge makes arcs
//! ```
//!
//! Rows are in meters, in the order of the file.
//!
//! # Valid
//! One outline per file. The unit is given in the header or by the case, which takes precedence.
//!
//! # References
//! - Own convention; the bulge is that of \[autodesk-dxf\].

use super::{ImportFault, Imported, LengthUnit, meters};
use crate::table::layout::Layout;
use crate::table::quantity::Quantity;
use crate::table::sheet::sheet;
use crate::table::{TableFault, with_plain_line_ends};
use msape::quantity::input;

const POINTS: Layout = Layout {
    quantities: &[Quantity::X, Quantity::R, Quantity::Bulge],
    bare: (&[Quantity::X, Quantity::R, Quantity::Bulge], 2),
    whole: true,
};

/// Points of a text, or all of its faults.
///
/// # Errors
/// All faults of the file, up to a hundred.
pub fn read(text: &str, unit: Option<LengthUnit>) -> Result<Imported, Vec<ImportFault>> {
    let text = with_plain_line_ends(text.to_owned());
    let mut sheet = sheet(&text, &POINTS).map_err(of_table)?;
    let places = [Quantity::X, Quantity::R].map(|quantity| sheet.place(quantity));
    let [Some(x), Some(r)] = places else {
        let missing = [Quantity::X, Quantity::R].into_iter().zip(places);
        let missing = missing.filter(|(_, place)| place.is_none());
        return Err(of_table(
            missing.map(|(q, _)| sheet.missing(q.names().0)).collect(),
        ));
    };
    let columns = [x, r].map(|place| sheet.columns.get(place));
    let mut named = columns
        .into_iter()
        .flatten()
        .filter(|column| column.named_unit)
        .map(|column| column.factor);
    let (first, second) = (named.next(), named.next());
    if first
        .zip(second)
        .is_some_and(|(first, second)| first != second)
    {
        let message = "x and r have different units".to_owned();
        return Err(vec![ImportFault::Header(message)]);
    }
    let meters = match (unit.map(meters), first) {
        (None, None) => return Err(vec![ImportFault::NoUnitInHeader]),
        (Some(meters), Some(other)) if meters != other => {
            let unit = &input::outline::FILE_UNIT;
            let remark = format!("the heading names another unit than {unit}, which is taken");
            sheet.remarks.push(remark.to_owned());
            meters
        }
        (Some(meters), _) | (None, Some(meters)) => meters,
    };
    // numbers already in this unit keep their bits
    let in_meters = |row: &[f64], place: usize| {
        let factor = sheet.columns.get(place).map_or(1.0, |column| column.factor);
        let value = row.get(place).copied().unwrap_or_default();
        if factor == meters {
            value
        } else {
            value / factor * meters
        }
    };
    let bulge = |row: &[f64]| sheet.value(row, Quantity::Bulge).unwrap_or(0.0);
    let mut rows: Vec<Vec<f64>> = sheet
        .rows
        .iter()
        .map(|(_, row)| vec![in_meters(row, x), in_meters(row, r), bulge(row)])
        .collect();
    // drop the repeated first point of a closed loop, as the loop closes along the axis anyway; an arc back to it is a
    // segment of its own
    while let [first, .., before, last] = rows.as_slice()
        && rows.len() > 3
        && first[..2] == last[..2]
        && before[2] == 0.0
    {
        rows.pop();
    }
    Ok(Imported {
        rows,
        remarks: sheet.remarks,
    })
}

fn of_table(faults: Vec<TableFault>) -> Vec<ImportFault> {
    faults.into_iter().map(ImportFault::Table).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn said(text: &str) -> Vec<String> {
        let faults = read(text, None).unwrap_err();
        faults.iter().map(ToString::to_string).collect()
    }

    fn rows(text: &str, unit: Option<LengthUnit>) -> Vec<Vec<f64>> {
        read(text, unit).unwrap().rows
    }

    #[test]
    fn german_file_in_millimeters_with_r_before_x() {
        let rows = rows("# cone\nr [mm];x [mm]\n0;0\n250,5;100\n0;100;\n", None);
        assert_eq!(rows[1], [0.1, 0.2505, 0.0]);
        assert_eq!(rows.len(), 3);
    }

    #[test]
    fn a_loop_is_closed_once_along_the_axis() {
        let unit = Some(LengthUnit::Meter);
        let loose = "0 0 0\n1 1 0\n2 0 0\n";
        for more in ["", "0 0 0\n", "0 0 0\n0 0 0\n"] {
            assert_eq!(rows(&format!("{loose}{more}"), unit).len(), 3, "{more}");
        }
        // the last segment is an arc, not a line on the axis
        assert_eq!(rows("1 0 0\n0.5 0.2 0\n0 0 -0.5\n1 0 0\n", unit).len(), 4);
    }

    #[test]
    fn inches_tabs_and_bulges() {
        let rows = rows("x_in\tr_in\tbulge\n0\t0\t-1\n10\t0\t0\n", None);
        assert_eq!(rows, [[0.0, 0.0, -1.0], [0.254, 0.0, 0.0]]);
    }

    #[test]
    fn a_row_of_units_a_title_blanks_and_a_column_more() {
        let text = "Cone of the wind tunnel\nx  r  mass\n(mm)  (mm)  (kg)\n0  0  1\n\n1000 500 2\n1000 0 3\n";
        let points = read(text, None).unwrap();
        assert_eq!(points.rows[1], [1.0, 0.5, 0.0]);
        assert_eq!(points.remarks, ["column left out: \"mass\""]);
    }

    #[test]
    fn without_a_header_the_case_says_the_unit() {
        let rows = rows("0 , 0\n1 , 1\n1 , 0\n", Some(LengthUnit::Foot));
        assert_eq!(rows[1], [0.3048, 0.3048, 0.0]);
        assert!(said("0,0\n1,1\n1,0\n")[0].contains("does not say its unit"));
    }

    #[test]
    fn the_unit_of_the_case_wins_and_is_told() {
        let points = read(
            "x_m,r_m\n0,0\n1000,500\n1000,0\n",
            Some(LengthUnit::Millimeter),
        )
        .unwrap();
        assert_eq!(points.rows[1], [1.0, 0.5, 0.0]);
        assert!(points.remarks[0].contains("another unit"));
    }

    #[test]
    fn every_fault_names_its_line() {
        assert_eq!(
            said("x_m,r_m\n0,0\n1,wide\n2\n3,0,nan\n4,nan\n"),
            [
                "line 3: column 2: got \"wide\", must be a number",
                "line 4: got 1 fields, must be 2",
                "line 5: got 3 fields, must be 2",
                "line 6: column 2: got \"nan\", must be a number; the table has a hole there"
            ]
        );
        assert!(said("x (furlong),r_m\n0,0\n")[0].contains("got the unit \"furlong\""));
        assert!(said("x_mm,r_m\n0,0\n")[0].contains("different units"));
        assert!(
            said("x_m,mass_kg\n0,0\n")[0].contains("no column for r; the others are \"mass_kg\"")
        );
        assert!(said("x_m\n0\n")[0].contains("no column for r"));
        assert!(said("")[0].contains("no row of numbers"));
        assert!(said("x_m,r_m\n0,inf\n0,0\n")[0].contains("must be a number"));
    }
}
