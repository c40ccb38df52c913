//! Outline in a CSV of a half-section, as `msape export` writes it: one row per segment; only the rows of component
//! `outline` count.
//!
//! ```text
//! bulge = tan(sweep / 4)
//! ```
//!
//! Lengths in the file are in mm, sweeps in deg; rows are returned in meters.
//!
//! # Valid
//! Files with the columns of [`crate::export::table::HEADER`].
//!
//! # References
//! - Own convention.

use super::{ImportFault, Imported, LengthUnit, MOST_FAULTS, shown};
use numerics::math::{RADIANS_PER_DEGREE, tan};

/// Whether the text has the columns of a half-section.
pub fn is_half_section(text: &str) -> bool {
    text.trim_start_matches('\u{feff}')
        .starts_with("component,body,segment,kind,")
}

/// The outline, or all faults of the text; lengths are in mm according to the column names, whatever `unit` is.
pub fn read(text: &str, unit: Option<LengthUnit>) -> Result<Imported, Vec<ImportFault>> {
    let text = text.trim_start_matches('\u{feff}');
    let mut reader = ::csv::Reader::from_reader(text.as_bytes());
    let header = reader.headers().cloned().unwrap_or_default();
    let wanted = [
        "x_start_mm",
        "r_start_mm",
        "x_end_mm",
        "r_end_mm",
        "sweep_deg",
    ];
    let places = wanted.map(|name| header.iter().position(|field| field == name));
    let missing = |(name, place): (&str, Option<usize>)| {
        place
            .is_none()
            .then(|| ImportFault::Header(format!("no column {name}")))
    };
    let mut faults: Vec<_> = wanted.into_iter().zip(places).filter_map(missing).collect();
    if !faults.is_empty() {
        return Err(faults);
    }
    let mut rows: Vec<Vec<f64>> = Vec::new();
    let mut end = None;
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
        if record.get(0) != Some("outline") {
            continue;
        }
        let line = record.position().map_or(0, ::csv::Position::line);
        let mut number = |place: Option<usize>| {
            let field = place.and_then(|place| record.get(place)).unwrap_or("");
            // a line has no sweep
            if field.is_empty() && place == places[4] {
                return 0.0;
            }
            let finite = field.parse().ok().filter(|x: &f64| x.is_finite());
            finite.unwrap_or_else(|| {
                faults.push(ImportFault::NotANumber {
                    line,
                    column: place.map_or(0, |place| place + 1),
                    text: shown(field),
                });
                0.0
            })
        };
        let [x, r, x_end, r_end, sweep_deg] = places.map(&mut number);
        let bulge = tan(sweep_deg * RADIANS_PER_DEGREE / 4.0);
        rows.push(vec![x / 1000.0, r / 1000.0, bulge]);
        end = Some(vec![x_end / 1000.0, r_end / 1000.0, 0.0]);
    }
    rows.extend(end);
    if rows.is_empty() && faults.is_empty() {
        faults.push(ImportFault::Empty("row of the component outline"));
    }
    let other = unit.filter(|unit| *unit != LengthUnit::Millimeter);
    let remarks = other.map(|unit| {
        format!(
            "the columns are in mm, as their names say; the unit {} is not used",
            unit.name()
        )
    });
    if faults.is_empty() {
        Ok(Imported {
            rows,
            remarks: remarks.into_iter().collect(),
        })
    } else {
        Err(faults)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::export::table::HEADER;

    #[test]
    fn only_the_outline_counts() {
        let text = format!(
            "{HEADER}\noutline,1,1,arc,0,0,1000,0,500,0,500,-180\nfoam,1,1,line,5,5,6,6,,,,\n"
        );
        assert!(is_half_section(&text));
        let Imported { rows, .. } = read(&text, None).unwrap();
        assert_eq!((rows.len(), rows[0][..2].to_vec()), (2, vec![0.0, 0.0]));
        // tan(−45°)
        assert!((rows[0][2] + 1.0).abs() < 1e-15);
        assert_eq!(rows[1], [1.0, 0.0, 0.0]);
    }

    #[test]
    fn every_fault_is_told() {
        let text = format!("{HEADER}\noutline,1,1,line,wide,0,1,x,,,,\n");
        let said: Vec<String> = read(&text, None)
            .unwrap_err()
            .iter()
            .map(ToString::to_string)
            .collect();
        assert_eq!(
            said,
            [
                "line 2: column 5: got \"wide\", must be a number",
                "line 2: column 8: got \"x\", must be a number"
            ]
        );
        let none = read(&format!("{HEADER}\n"), None).unwrap_err();
        assert!(
            none[0]
                .to_string()
                .contains("no row of the component outline")
        );
        assert!(read("component,body,segment,kind,x_start_mm\n", None).is_err());
    }
}
