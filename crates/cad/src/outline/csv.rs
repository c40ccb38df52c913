//! Points of an outline from a CSV file, whatever the dialect, or the profile that this program exports.
//!
//! ```text
//! field separator: semicolon, tab or comma, whichever the first line holds;  # begins a comment
//! decimal comma:   read as a point unless the comma separates the fields
//! header:          x and r with their unit, such as  x (mm); r (mm)  or  x_m,r_m ; a column called bulge makes arcs
//! ```
//!
//! Rows come out in metres, in the order of the file.
//!
//! # Valid
//! One outline a file. The unit stands in the header or comes with the case.
//!
//! # References
//! - Own convention; the bulge is that of \[autodesk-dxf\].

use super::{ImportFault, LengthUnit, MOST_FAULTS, shown};

/// A column that is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Column {
    X,
    R,
    Bulge,
}

/// Columns of a header, by their places, and the unit it names.
type Header = (Vec<(Column, usize)>, Option<LengthUnit>);

/// Rows of x, r in metres and bulge, or everything that is wrong with the text.
pub fn read(text: &str, unit: Option<LengthUnit>) -> Result<Vec<Vec<f64>>, Vec<ImportFault>> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let delimiter = delimiter(text);
    let mut reader = ::csv::ReaderBuilder::new()
        .delimiter(delimiter)
        .comment(Some(b'#'))
        .has_headers(false)
        .flexible(true)
        .trim(::csv::Trim::All)
        .from_reader(text.as_bytes());
    let mut header: Option<Header> = None;
    let (mut rows, mut faults) = (Vec::new(), Vec::new());
    let mut first = true;
    for record in reader.records() {
        if faults.len() >= MOST_FAULTS {
            break;
        }
        let record = match record {
            Ok(record) => record,
            Err(error) => {
                faults.push(ImportFault::Unreadable {
                    line: error.position().map_or(0, ::csv::Position::line),
                    reason: error.to_string(),
                });
                continue;
            }
        };
        let line = record.position().map_or(0, ::csv::Position::line);
        let mut fields: Vec<&str> = record.iter().collect();
        while fields.last().is_some_and(|field| field.is_empty()) {
            fields.pop();
        }
        if fields.is_empty() {
            continue;
        }
        let words = fields
            .iter()
            .all(|field| number(field, delimiter).is_none());
        if first && words {
            header = Some(heading(&fields)?);
        } else {
            match row(&fields, header.as_ref(), line, delimiter) {
                Ok(row) => rows.push(row),
                Err(found) => faults.extend(found),
            }
        }
        first = false;
    }
    // a closed loop repeats its first point, which closes along the axis anyway
    if rows.len() > 3 && rows.first().map(|r| [r[0], r[1]]) == rows.last().map(|r| [r[0], r[1]]) {
        rows.pop();
    }
    if rows.is_empty() && faults.is_empty() {
        faults.push(ImportFault::Empty("row of numbers"));
    }
    let unit = header.and_then(|(_, unit)| unit).or(unit);
    if unit.is_none() {
        faults.push(ImportFault::NoUnitInHeader);
    }
    match unit {
        Some(unit) if faults.is_empty() => {
            let scale =
                |row: [f64; 3]| vec![row[0] * unit.metres(), row[1] * unit.metres(), row[2]];
            Ok(rows.into_iter().map(scale).collect())
        }
        _ => Err(faults),
    }
}

/// The separator of the first line that is not a comment.
fn delimiter(text: &str) -> u8 {
    let first = text
        .lines()
        .find(|line| !line.trim().is_empty() && !line.starts_with('#'))
        .unwrap_or("");
    [b';', b'\t', b',']
        .into_iter()
        .find(|d| first.as_bytes().contains(d))
        .unwrap_or(b',')
}

fn number(field: &str, delimiter: u8) -> Option<f64> {
    match field.parse() {
        Ok(value) => Some(value),
        Err(_) if delimiter != b',' => field.replace(',', ".").parse().ok(),
        Err(_) => None,
    }
}

fn heading(fields: &[&str]) -> Result<Header, Vec<ImportFault>> {
    let mut columns: Vec<(Column, usize)> = Vec::new();
    let mut unit = None;
    let mut faults = Vec::new();
    for (place, field) in fields.iter().enumerate() {
        let (name, symbol) = name_and_unit(field);
        let column = match name.as_str() {
            "x" | "z" | "axial" => Column::X,
            "r" | "y" | "radius" | "radial" => Column::R,
            "bulge" => Column::Bulge,
            _ => {
                let message = format!(
                    "column {}: got \"{}\", must be one of x, r, bulge, with the unit of x and r",
                    place + 1,
                    shown(field)
                );
                faults.push(ImportFault::Header(message));
                continue;
            }
        };
        if columns.iter().any(|(other, _)| *other == column) {
            let message = format!("column {}: \"{}\" stands twice", place + 1, shown(field));
            faults.push(ImportFault::Header(message));
        }
        columns.push((column, place));
        if column == Column::Bulge || symbol.is_empty() {
            continue;
        }
        match LengthUnit::of(&symbol) {
            None => faults.push(ImportFault::UnknownUnit {
                place: format!("header: column {}", place + 1),
                unit: shown(&symbol),
            }),
            Some(found) if unit.is_some_and(|unit| unit != found) => faults.push(
                ImportFault::Header("x and r have different units".to_owned()),
            ),
            Some(found) => unit = Some(found),
        }
    }
    for (column, name) in [(Column::X, "x"), (Column::R, "r")] {
        if !columns.iter().any(|(other, _)| *other == column) && faults.is_empty() {
            faults.push(ImportFault::Header(format!("no column for {name}")));
        }
    }
    if faults.is_empty() {
        Ok((columns, unit))
    } else {
        Err(faults)
    }
}

/// The parts of a heading: `x (mm)`, `r [in]`, `x_m`.
fn name_and_unit(field: &str) -> (String, String) {
    let plain = field.to_lowercase();
    let mut parts = plain.splitn(2, |c: char| "([,_ \t".contains(c));
    let name = parts.next().unwrap_or("").trim().to_owned();
    let unit = parts.next().unwrap_or("");
    let unit = unit.chars().filter(|c| !"()[]_ ,\t".contains(*c)).collect();
    (name, unit)
}

fn row(
    fields: &[&str],
    header: Option<&Header>,
    line: u64,
    delimiter: u8,
) -> Result<[f64; 3], Vec<ImportFault>> {
    let plain = [(Column::X, 0), (Column::R, 1), (Column::Bulge, 2)];
    let columns = header.map_or(&plain[..], |(columns, _)| &columns[..]);
    let (fewest, most) = match header {
        Some(_) => (columns.len(), columns.len()),
        None => (2, 3),
    };
    if fields.len() < fewest || fields.len() > most {
        let (found, wanted) = (fields.len(), most.min(fewest.max(2)));
        return Err(vec![ImportFault::Fields {
            line,
            found,
            wanted,
        }]);
    }
    let (mut row, mut faults) = ([0.0; 3], Vec::new());
    for &(column, place) in columns {
        let Some(field) = fields.get(place) else {
            continue;
        };
        let target = match column {
            Column::X => &mut row[0],
            Column::R => &mut row[1],
            Column::Bulge => &mut row[2],
        };
        match number(field, delimiter).filter(|value| value.is_finite()) {
            Some(value) => *target = value,
            None => faults.push(ImportFault::NotANumber {
                line,
                column: place + 1,
                text: shown(field),
            }),
        }
    }
    if faults.is_empty() {
        Ok(row)
    } else {
        Err(faults)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn said(text: &str) -> Vec<String> {
        let faults = read(text, None).unwrap_err();
        faults.iter().map(ToString::to_string).collect()
    }

    #[test]
    fn german_file_in_millimetres_with_r_before_x() {
        let rows = read("# cone\nr [mm];x [mm]\n0;0\n250,5;100\n0;100;\n", None).unwrap();
        assert_eq!(rows[1], [0.1, 0.2505, 0.0]);
        assert_eq!(rows.len(), 3);
    }

    #[test]
    fn inches_tabs_and_bulges() {
        let rows = read("x_in\tr_in\tbulge\n0\t0\t-1\n10\t0\t0\n", None).unwrap();
        assert_eq!(rows, [[0.0, 0.0, -1.0], [0.254, 0.0, 0.0]]);
    }

    #[test]
    fn without_a_header_the_case_says_the_unit() {
        let rows = read("0 , 0\n1 , 1\n1 , 0\n", Some(LengthUnit::Foot)).unwrap();
        assert_eq!(rows[1], [0.3048, 0.3048, 0.0]);
        assert!(said("0,0\n1,1\n1,0\n")[0].contains("does not say its unit"));
    }

    #[test]
    fn every_fault_names_its_line() {
        assert_eq!(
            said("x_m,r_m\n0,0\n1,wide\n2\n3,0,nan\n"),
            [
                "line 3: column 2: got \"wide\", must be a number",
                "line 4: got 1 fields, must be 2",
                "line 5: got 3 fields, must be 2"
            ]
        );
        assert!(said("x_furlong,r_m\n0,0\n")[0].contains("got the unit \"furlong\""));
        assert!(said("x_mm,r_m\n0,0\n")[0].contains("different units"));
        assert!(said("x_m,mass_kg\n0,0\n")[0].contains("got \"mass_kg\""));
        assert!(said("x_m\n0\n")[0].contains("no column for r"));
        assert!(said("")[0].contains("no row of numbers"));
        assert!(said("x_m,r_m\n0,inf\n")[0].contains("must be a number"));
    }
}
