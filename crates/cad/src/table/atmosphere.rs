//! Rows of an atmosphere or wind table from a text file, whatever the dialect.
//!
//! ```text
//! field separator: semicolon, tab or comma, whichever the first lines hold;  # begins a comment
//! decimal comma:   read as a point unless the comma separates the fields
//! header:          one line of names with units, such as  altitude (km); density (kg/m3); T [K]
//! ```
//!
//! Numbers come out in SI. Without a header the columns are those of [`Kind`] in their order, in SI.
//!
//! # Valid
//! One table a file. A header must name a unit where the number is not in SI.
//!
//! # References
//! - Own convention.

mod heading;

use heading::{Quantity, name_and_unit};
use thiserror::Error;

/// Faults are listed up to this number.
const MOST_FAULTS: usize = msape::planet::rows::MOST_FAULTS;
/// Characters of a field that a message shows.
const MOST_SHOWN: usize = 40;

/// What the file holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Altitude, density, temperature, pressure; the last two optional.
    Atmosphere,
    /// Altitude, eastward, northward wind.
    Wind,
}

/// One thing wrong with a file; lines are counted from 1.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum CsvFault {
    /// No row of numbers.
    #[error("the file holds no row of numbers")]
    Empty,
    /// A field that is not a number.
    #[error("line {line}: column {column}: got \"{text}\", must be a number")]
    NotANumber {
        /// Line of the file.
        line: u64,
        /// Column, from 1.
        column: usize,
        /// The field, shortened.
        text: String,
    },
    /// A column name that is not known, or comes twice.
    #[error("header: column {column}: got \"{text}\", must be one of {expected}, each once")]
    UnknownColumn {
        /// Column, from 1.
        column: usize,
        /// The name, shortened.
        text: String,
        /// Names that are understood.
        expected: &'static str,
    },
    /// A unit that is not known for its column.
    #[error("header: column {column}: got the unit \"{unit}\", must be one of {expected}")]
    UnknownUnit {
        /// Column, from 1.
        column: usize,
        /// The unit, shortened.
        unit: String,
        /// Units that are understood.
        expected: &'static str,
    },
    /// A needed column is missing.
    #[error("header: no column for {name}")]
    MissingColumn {
        /// The quantity.
        name: &'static str,
    },
    /// A line that cannot be read as text.
    #[error("line {line}: {reason}")]
    Unreadable {
        /// Line of the file.
        line: u64,
        /// Why.
        reason: String,
    },
}

/// A column of the file: what it is, and SI = factor × number + offset.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Reading {
    quantity: Quantity,
    factor: f64,
    offset: f64,
}

impl Kind {
    fn quantities(self) -> &'static [Quantity] {
        match self {
            Self::Atmosphere => &[
                Quantity::Altitude,
                Quantity::Density,
                Quantity::Temperature,
                Quantity::Pressure,
            ],
            Self::Wind => &[Quantity::Altitude, Quantity::Eastward, Quantity::Northward],
        }
    }

    fn needed(self) -> usize {
        match self {
            Self::Atmosphere => 2,
            Self::Wind => 3,
        }
    }

    fn expected(self) -> &'static str {
        match self {
            Self::Atmosphere => "altitude, density, temperature, pressure",
            Self::Wind => "altitude, eastward, northward",
        }
    }
}

/// Rows in SI and in the order of the case file: altitude, density, temperature, pressure, or altitude, eastward,
/// northward; or what is wrong with the file, up to a hundred faults.
pub fn read(text: &str, kind: Kind) -> Result<Vec<Vec<f64>>, Vec<CsvFault>> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let delimiter = delimiter(text);
    let mut reader = ::csv::ReaderBuilder::new()
        .delimiter(delimiter)
        .comment(Some(b'#'))
        .has_headers(false)
        .flexible(true)
        .trim(::csv::Trim::All)
        .from_reader(text.as_bytes());
    let (mut rows, mut faults) = (Vec::new(), Vec::new());
    let mut readings: Option<Vec<Reading>> = None;
    for record in reader.records() {
        if faults.len() >= MOST_FAULTS {
            break;
        }
        let record = match record {
            Ok(record) => record,
            Err(error) => {
                let line = error.position().map_or(0, |p| p.line());
                faults.push(CsvFault::Unreadable {
                    line,
                    reason: error.to_string(),
                });
                continue;
            }
        };
        let line = record.position().map_or(0, |p| p.line());
        // A separator at the end of the line makes no column.
        let mut fields: Vec<&str> = record.iter().collect();
        while fields.last().is_some_and(|field| field.is_empty()) {
            fields.pop();
        }
        if fields.is_empty() {
            continue;
        }
        if readings.is_none()
            && rows.is_empty()
            && fields.iter().all(|f| number(f, delimiter).is_none())
        {
            match header(&fields, kind) {
                Ok(found) => readings = Some(found),
                Err(found) => return Err(found),
            }
            continue;
        }
        let before = faults.len();
        let mut row = Vec::with_capacity(fields.len());
        for (i, field) in fields.iter().enumerate() {
            match number(field, delimiter) {
                Some(value) => row.push(value),
                None => faults.push(CsvFault::NotANumber {
                    line,
                    column: i + 1,
                    text: shorten(field),
                }),
            }
        }
        if faults.len() == before {
            rows.push(
                readings
                    .as_ref()
                    .map_or(row.clone(), |readings| in_order(&row, readings, kind)),
            );
        }
    }
    if rows.is_empty() && faults.is_empty() {
        faults.push(CsvFault::Empty);
    }
    if faults.is_empty() {
        Ok(rows)
    } else {
        Err(faults)
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

fn shorten(text: &str) -> String {
    text.chars().take(MOST_SHOWN).collect()
}

/// What each column of the header is.
fn header(fields: &[&str], kind: Kind) -> Result<Vec<Reading>, Vec<CsvFault>> {
    let (mut readings, mut faults): (Vec<Reading>, Vec<CsvFault>) = (Vec::new(), Vec::new());
    for (i, field) in fields.iter().enumerate() {
        let column = i + 1;
        let (name, unit) = name_and_unit(field);
        let known = kind
            .quantities()
            .iter()
            .copied()
            .find(|quantity| quantity.names().1.contains(&name.as_str()));
        let quantity = match known {
            Some(quantity) if readings.iter().all(|r| r.quantity != quantity) => quantity,
            _ => {
                let (text, expected) = (shorten(field), kind.expected());
                faults.push(CsvFault::UnknownColumn {
                    column,
                    text,
                    expected,
                });
                continue;
            }
        };
        let (expected, units) = quantity.units();
        let found = if unit.is_empty() {
            units.first()
        } else {
            units.iter().find(|u| u.0.contains(&unit.as_str()))
        };
        match found {
            Some((_, factor, offset)) => readings.push(Reading {
                quantity,
                factor: *factor,
                offset: *offset,
            }),
            None => faults.push(CsvFault::UnknownUnit {
                column,
                unit: shorten(&unit),
                expected,
            }),
        }
        if faults.len() >= MOST_FAULTS {
            break;
        }
    }
    let needed = kind.quantities().iter().enumerate();
    for (i, quantity) in needed {
        let found = readings.iter().any(|r| r.quantity == *quantity);
        let later = kind
            .quantities()
            .iter()
            .skip(i + 1)
            .any(|q| readings.iter().any(|r| r.quantity == *q));
        // Temperature may be missing, but not before a pressure: rows are told apart by their length.
        if !found && faults.is_empty() && (i < kind.needed() || later) {
            faults.push(CsvFault::MissingColumn {
                name: quantity.names().0,
            });
        }
    }
    if faults.is_empty() {
        Ok(readings)
    } else {
        Err(faults)
    }
}

/// The row in SI and in the order of its kind; a number too many or too few is left for the checks of the table.
fn in_order(row: &[f64], readings: &[Reading], kind: Kind) -> Vec<f64> {
    if row.len() != readings.len() {
        return row.to_vec();
    }
    let pick = |quantity: &Quantity| {
        let pair = readings
            .iter()
            .zip(row)
            .find(|(reading, _)| reading.quantity == *quantity);
        pair.map(|(reading, value)| value * reading.factor + reading.offset)
    };
    kind.quantities().iter().filter_map(pick).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn german_file_with_units_in_another_order() {
        let text =
            "# radiosonde\nT [°C];Altitude (km);Density (g/m³)\n15,0;0,0;1225,0\n-56,5;11;364,8;\n";
        let rows = read(text, Kind::Atmosphere).unwrap();
        assert_eq!(rows.len(), 2);
        // 15 + 273.15, 1225 × 1e-3; 11 km = 11000 m
        assert!((rows[0][1] - 1.225).abs() < 1e-12 && (rows[0][2] - 288.15).abs() < 1e-12);
        assert_eq!(rows[1][0], 11_000.0);
    }

    #[test]
    fn keys_of_the_case_file_are_headings() {
        let rows = read(
            "altitude_m,density_kg_m3,temperature_K,pressure_Pa\n0,1.2,288,1e5\n",
            Kind::Atmosphere,
        );
        assert_eq!(rows.unwrap(), [[0.0, 1.2, 288.0, 1e5]]);
        let rows = read(
            "altitude_m\teastward_m_s\tnorthward_m_s\n0\t5\t-1\n",
            Kind::Wind,
        )
        .unwrap();
        assert_eq!(rows, [[0.0, 5.0, -1.0]]);
        let rows = read("alt_ft,rho (slug/ft^3)\n1000,0.002377\n", Kind::Atmosphere).unwrap();
        // 1000 × 0.3048; 0.002377 × 515.3788 = 1.22506
        assert!((rows[0][0] - 304.8).abs() < 1e-10 && (rows[0][1] - 1.22506).abs() < 1e-5);
    }

    #[test]
    fn without_a_header_columns_are_in_order_and_in_si() {
        let rows = read("0.0, 1.225\n1000.0, 1.112\n", Kind::Atmosphere).unwrap();
        assert_eq!(rows, [[0.0, 1.225], [1000.0, 1.112]]);
    }

    #[test]
    fn faults_name_line_column_and_text() {
        let faults = read(
            "altitude_m,density_kg_m3\n0,1.2\n1000,dense\n2000,thin\n",
            Kind::Atmosphere,
        )
        .unwrap_err();
        assert_eq!(faults.len(), 2);
        assert_eq!(
            faults[0].to_string(),
            "line 3: column 2: got \"dense\", must be a number"
        );
        let faults = read("altitude (furlong),humidity\n0,1\n", Kind::Atmosphere).unwrap_err();
        assert!(
            faults[0]
                .to_string()
                .contains("got the unit \"furlong\", must be one of m, km, ft, kft")
        );
        assert!(faults[1].to_string().contains("got \"humidity\""));
        assert_eq!(
            read("altitude_m,temperature_K\n0,288\n", Kind::Atmosphere).unwrap_err(),
            [CsvFault::MissingColumn { name: "density" }]
        );
        assert_eq!(
            read("# nothing\n\n", Kind::Atmosphere).unwrap_err(),
            [CsvFault::Empty]
        );
    }

    #[test]
    fn ten_megabytes_of_garbage_make_a_hundred_faults_at_most() {
        let garbage = "1;x;y\n".repeat(1_700_000);
        let faults = read(&garbage, Kind::Atmosphere).unwrap_err();
        assert!(
            (2..=MOST_FAULTS + 2).contains(&faults.len()),
            "{}",
            faults.len()
        );
        assert!(read(&"\u{1}ÿ,\"".repeat(2_000_000), Kind::Atmosphere).is_err());
    }
}
