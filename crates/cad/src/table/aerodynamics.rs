//! Reads a table of coefficients from a text file.
//!
//! ```text
//! field separator: semicolon, tab or comma, whichever the header holds;  # begins a comment;  decimal comma where it does not separate
//! columns by name: mach, alpha_deg (or alpha), knudsen (or kn) or altitude_m (or altitude_km), ca, cn, cm, or cd, cl, cm, and cmq
//! ```
//!
//! # Valid
//! One header, one table. Angles in deg, moments about the virtual apex with the diameter as length.
//!
//! # References
//! - Own convention.

use msape::aero::table::{Extrapolation, Grid, Row};

/// Faults are listed up to this number.
const MOST_FAULTS: usize = 100;

/// What a column holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Column {
    Mach,
    Alpha,
    Knudsen,
    AltitudeM,
    AltitudeKm,
    Ca,
    Cn,
    Cd,
    Cl,
    Cm,
    Cmq,
}

const NAMES: &str = "mach, alpha_deg, knudsen or altitude_m, ca, cn, cm, cd, cl, cmq";

fn column(heading: &str) -> Option<Column> {
    let plain: String = heading
        .to_lowercase()
        .chars()
        .filter(|c| c.is_alphanumeric())
        .collect();
    Some(match plain.as_str() {
        "mach" | "m" | "machnumber" => Column::Mach,
        "alpha" | "alphadeg" | "aoa" | "aoadeg" | "angleofattack" | "angleofattackdeg" => {
            Column::Alpha
        }
        "kn" | "knudsen" | "knudsennumber" => Column::Knudsen,
        "altitude" | "altitudem" | "h" | "hm" => Column::AltitudeM,
        "altitudekm" | "hkm" => Column::AltitudeKm,
        "ca" | "caxial" => Column::Ca,
        "cn" => Column::Cn,
        "cd" => Column::Cd,
        "cl" => Column::Cl,
        "cm" | "cmapex" => Column::Cm,
        "cmq" => Column::Cmq,
        _ => return None,
    })
}

/// Rows of a file, checked as a table: mach, alpha_deg, ca, cn, cm, cmq, knudsen and, instead of the last, altitude_m.
///
/// # Errors
/// Everything that is wrong with the file, each fault with its line.
pub fn read(text: &str) -> Result<Vec<Vec<f64>>, Vec<String>> {
    let rows = rows(text)?;
    Grid::try_new(&rows, Extrapolation::Hold)?;
    Ok(rows.iter().map(Row::cells).collect())
}

/// The rows of a file as they stand.
fn rows(text: &str) -> Result<Vec<Row>, Vec<String>> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let content = |line: &&str| !line.trim().is_empty() && !line.trim_start().starts_with('#');
    let first = text.lines().find(content).unwrap_or_default();
    let delimiter = [';', '\t', ',']
        .into_iter()
        .find(|d| first.contains(*d))
        .unwrap_or(',');
    let mut lines = text.lines().zip(1_u64..).filter(|(line, _)| content(line));
    let Some((header, _)) = lines.next() else {
        return Err(vec!["the file holds no table".to_string()]);
    };
    let columns = columns(header, delimiter)?;
    let (mut rows, mut faults) = (Vec::new(), Vec::new());
    for (line, number) in lines {
        if faults.len() >= MOST_FAULTS {
            break;
        }
        let fields: Vec<&str> = line.trim_end_matches(delimiter).split(delimiter).collect();
        if fields.len() != columns.len() {
            faults.push(format!(
                "line {number}: {} fields, must be {}",
                fields.len(),
                columns.len()
            ));
            continue;
        }
        let mut row = Row {
            line: number,
            ..Row::default()
        };
        for (field, column) in fields.iter().zip(&columns) {
            let plain = field.trim();
            let parsed = if delimiter == ',' {
                plain.parse::<f64>()
            } else {
                plain.replace(',', ".").parse::<f64>()
            };
            match parsed {
                Ok(value) if value.is_finite() => set(&mut row, *column, value),
                _ => {
                    let shown: String = plain.chars().take(40).collect();
                    faults.push(format!(
                        "line {number}: got \"{shown}\", must be a number; the table has a hole there"
                    ));
                }
            }
        }
        rows.push(row);
    }
    if faults.is_empty() {
        Ok(rows)
    } else {
        Err(faults)
    }
}

fn columns(header: &str, delimiter: char) -> Result<Vec<Column>, Vec<String>> {
    let mut faults = Vec::new();
    let mut columns: Vec<Column> = Vec::new();
    for (heading, number) in header.trim_end_matches(delimiter).split(delimiter).zip(1..) {
        match column(heading) {
            Some(column) if !columns.contains(&column) => columns.push(column),
            _ => {
                let shown: String = heading.trim().chars().take(40).collect();
                faults.push(format!(
                    "header: column {number}: got \"{shown}\", must be one of {NAMES}, each once"
                ));
            }
        }
    }
    let has = |column: Column| columns.contains(&column);
    let forces = has(Column::Ca) && has(Column::Cn);
    let lift = has(Column::Cd) && has(Column::Cl);
    if faults.is_empty() {
        for (column, name) in [(Column::Mach, "mach"), (Column::Alpha, "alpha_deg")] {
            if !has(column) {
                faults.push(format!("header: no column for {name}"));
            }
        }
        if forces == lift {
            faults.push("header: give ca and cn, or cd and cl".to_string());
        }
        let places = [Column::Knudsen, Column::AltitudeM, Column::AltitudeKm];
        if places.into_iter().filter(|column| has(*column)).count() > 1 {
            faults.push("header: give knudsen or altitude, not both".to_string());
        }
    }
    if faults.is_empty() {
        Ok(columns)
    } else {
        Err(faults)
    }
}

fn set(row: &mut Row, column: Column, value: f64) {
    match column {
        Column::Mach => row.mach = value,
        Column::Alpha => row.alpha_deg = value,
        Column::Knudsen => row.knudsen = Some(value),
        Column::AltitudeM => row.altitude_m = Some(value),
        Column::AltitudeKm => row.altitude_m = Some(1e3 * value),
        Column::Ca => row.ca = Some(value),
        Column::Cn => row.cn = Some(value),
        Column::Cd => row.cd = Some(value),
        Column::Cl => row.cl = Some(value),
        Column::Cm => row.cm = Some(value),
        Column::Cmq => row.cmq = Some(value),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_dialects_of_one_table() {
        let plain = "# wind tunnel\nMach,alpha (deg),CA,CN\n1,0,1.5,0\n1,10,1.4,0.1\n";
        let german = "Mach;alpha_deg;CA;CN\n1;0;1,5;0\n1;10;1,4;0,1\n";
        let rows = read(plain).unwrap();
        assert_eq!(rows, [[1.0, 0.0, 1.5, 0.0], [1.0, 10.0, 1.4, 0.1]]);
        assert_eq!(read(german).unwrap(), rows);
        let high = "mach,alpha,altitude_km,ca,cn,cm\n20,0,80,1.5,0,0\n20,0,100,1.7,0,0\n";
        assert_eq!(
            read(high).unwrap()[1],
            [20.0, 0.0, 1.7, 0.0, 0.0, 0.0, 0.0, 1e5]
        );
    }

    #[test]
    fn faults_have_lines() {
        let faults = read("mach,alpha,ca,cn\n1,0,1,0\n1,5,,0.1\n1,10,x,0.1,7\n").unwrap_err();
        assert_eq!(faults.len(), 2, "{faults:?}");
        assert!(faults[0].starts_with("line 3: got \"\""));
        assert!(faults[1].starts_with("line 4: 5 fields, must be 4"));
        let faults = read("mach,alpha,ca,cn\n2,0,1,0\n\n1,0,1,0\n").unwrap_err();
        assert!(
            faults[0].starts_with("line 4: Mach number 1 after 2"),
            "{faults:?}"
        );
        let faults = read("mach,beta,ca\n").unwrap_err();
        assert!(faults[0].contains("got \"beta\""));
        assert_eq!(read("mach,ca\n").unwrap_err().len(), 2);
        assert_eq!(read("").unwrap_err(), ["the file holds no table"]);
    }
}
