//! Files that a case names: nothing panics; what is accepted is finite, reproducible, reads back as written, and can be
//! checked.

use super::edits::{after, edits};
use super::samples::{TABLES, outlines};
use super::{Tally, hold};
use crate::designs::LIBRARY;
use cad::outline::{self, LengthUnit};
use cad::table::{self, Ground, Table};
use msape::Case;
use msape::case::Value;
use msape::problem::{self, FlightProblem};
use msape::quantity::input::{Kind, find};
use msape_tests::text::{PLAIN, case};
use proptest::prelude::*;
use proptest::sample::{Index, select};

/// Largest number of faults listed for one file.
const FAULTS_MAX: usize = 100;

fn told<T: ToString>(faults: &[T]) -> Result<(), TestCaseError> {
    prop_assert!(
        !faults.is_empty() && faults.len() <= FAULTS_MAX,
        "{} faults",
        faults.len()
    );
    for fault in faults {
        let text = fault.to_string();
        prop_assert!(!text.is_empty() && text.len() < 1_000, "{}", text);
    }
    Ok(())
}

fn all_finite(rows: &[Vec<f64>]) -> Result<(), TestCaseError> {
    prop_assert!(rows.iter().flatten().all(|x| x.is_finite()), "{:?}", rows);
    Ok(())
}

/// Rows as a plain file with the column names of their input.
fn plain_file(key: &str, rows: &[Vec<f64>]) -> String {
    let Some(Kind::Rows(columns)) = find(key).map(|input| input.kind) else {
        panic!("{key} takes no rows");
    };
    let width = rows.iter().map(Vec::len).max().unwrap_or_default();
    // a table over altitude has a column of Knudsen numbers that was not given, and a file may name only one of them
    let by_altitude = columns.iter().take(width).any(|c| c.name == "altitude_m");
    let kept = |place: usize| {
        let name = columns.get(place).map_or("", |column| column.name);
        !(by_altitude && name == "knudsen")
    };
    let line = |cells: &mut dyn Iterator<Item = (usize, String)>| {
        let cells: Vec<String> = cells
            .filter(|(place, _)| kept(*place))
            .map(|(_, cell)| cell)
            .collect();
        cells.join(",") + "\n"
    };
    let names = columns.iter().take(width).map(|c| c.name.to_string());
    let head = line(&mut names.enumerate());
    let body: String = rows
        .iter()
        .map(|row| line(&mut row.iter().map(f64::to_string).enumerate()))
        .collect();
    head + &body
}

/// Planets for tables that need radius and gas.
fn grounds() -> [Ground; 3] {
    ["earth", "mars", "jupiter"].map(|planet| {
        let mut case = Case::default();
        case.set("entry.planet", planet);
        Ground::of(&case, &LIBRARY)
    })
}

/// Checks the case that flies with the table: an answer or faults.
fn checked(table: &Table) -> Result<bool, TestCaseError> {
    let mut case = case(PLAIN, &[]);
    if table.key == "atmosphere.table" {
        case.set("atmosphere.exponential.density_kg_m3", "");
        case.set("atmosphere.exponential.scale_height_m", "");
    }
    if table.key.starts_with("vehicle.drag") || table.key == "vehicle.aerodynamics.table" {
        case.set("vehicle.drag_coefficient", "");
    }
    case.values
        .insert(table.key.to_string(), Value::Rows(table.rows.clone()));
    match FlightProblem::check(&case, &LIBRARY) {
        Ok(_) => Ok(true),
        Err(faults) => {
            told(&faults)?;
            Ok(false)
        }
    }
}

fn check_table(
    key: &str,
    bytes: &[u8],
    ground: &Ground,
    tally: &Tally,
) -> Result<(), TestCaseError> {
    let file = find(key).unwrap();
    let table = match table::read(file, bytes, ground) {
        Ok(table) => table,
        Err(faults) => return told(&faults),
    };
    tally.one("taken");
    all_finite(&table.rows)?;
    prop_assert!(table::read(file, bytes, ground).is_ok_and(|again| again == table));
    let plain = plain_file(table.key, &table.rows);
    match table::read(file, plain.as_bytes(), ground) {
        Ok(again) => prop_assert_eq!(&again.rows, &table.rows, "{}", plain),
        Err(faults) => prop_assert!(false, "{:?}\n{}", faults, plain),
    }
    if checked(&table)? {
        tally.one("accepted in a case");
    }
    Ok(())
}

#[test]
fn changed_tables() {
    let files: Vec<(&str, &str)> = TABLES
        .iter()
        .flat_map(|(key, texts)| texts.iter().map(move |text| (*key, *text)))
        .collect();
    let grounds = grounds();
    let drawn = (any::<Index>(), any::<Index>(), any::<Index>(), edits());
    hold(
        "tables",
        6_000,
        &drawn,
        |(one, other, ground, edits), tally| {
            let (key, text) = files[one.index(files.len())];
            let bytes = after(
                text.as_bytes(),
                edits,
                files[other.index(files.len())].1.as_bytes(),
            );
            check_table(key, &bytes, &grounds[ground.index(grounds.len())], tally)
        },
    );
}

fn check_outline(
    name: &str,
    bytes: &[u8],
    unit: Option<LengthUnit>,
    tally: &Tally,
) -> Result<(), TestCaseError> {
    let read = match outline::read(name, bytes, unit) {
        Ok(read) => read,
        Err(faults) => return told(&faults),
    };
    tally.one("taken");
    all_finite(&read.rows)?;
    prop_assert!(outline::read(name, bytes, unit).is_ok_and(|again| again == read));
    let mut plain = "x_m,r_m,bulge\n".to_string();
    for row in &read.rows {
        plain.push_str(&format!("{},{},{}\n", row[0], row[1], row[2]));
    }
    match outline::read("a.csv", plain.as_bytes(), None) {
        Ok(again) => prop_assert_eq!(&again.rows, &read.rows, "{}", plain),
        Err(faults) => prop_assert!(false, "{:?}\n{}", faults, plain),
    }
    let mut case = Case::default();
    case.values
        .insert("outline.points".to_string(), Value::Rows(read.rows));
    match problem::rigid_body(&case, &LIBRARY) {
        Err(faults) => told(&faults),
        Ok(None) => {
            prop_assert!(false, "no body");
            Ok(())
        }
        Ok(Some(body)) => {
            tally.one("bodies");
            let facts = serde_json::to_value(body.facts()).unwrap();
            let lost: Vec<_> = facts
                .as_object()
                .unwrap()
                .iter()
                .filter(|(_, x)| x.is_null())
                .map(|(key, _)| key.clone())
                .collect();
            let optional = ["nose", "cone", "virtual", "shoulder"];
            let lost: Vec<_> = lost
                .iter()
                .filter(|key| !optional.iter().any(|o| key.starts_with(o)))
                .collect();
            prop_assert!(lost.is_empty(), "not finite: {:?}", lost);
            Ok(())
        }
    }
}

#[test]
fn changed_outlines_and_drawings() {
    let files = outlines();
    let units = vec![None, Some(LengthUnit::Millimeter), Some(LengthUnit::Inch)];
    let drawn = (any::<Index>(), any::<Index>(), select(units), edits());
    hold(
        "outlines",
        3_000,
        &drawn,
        |(one, other, unit, edits), tally| {
            let (name, file) = &files[one.index(files.len())];
            let bytes = after(file, edits, &files[other.index(files.len())].1);
            check_outline(name, &bytes, *unit, tally)
        },
    );
}

#[test]
fn bytes_without_sense_as_files() {
    let drawn = prop::collection::vec(any::<u8>(), 0..600);
    let ground = Ground::earth(&LIBRARY);
    hold("bytes as files", 400, &drawn, |bytes, tally| {
        for (key, _) in TABLES {
            check_table(key, bytes, &ground, tally)?;
        }
        check_outline("a.csv", bytes, Some(LengthUnit::Meter), tally)?;
        check_outline("a.dxf", bytes, Some(LengthUnit::Meter), tally)
    });
}
