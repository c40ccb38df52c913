//! Rows from files, by the same readers as the command line.

use crate::desk::Desk;
use crate::protocol::Question;
use cad::outline::{self, Imported};
use cad::table::{self, Ground, Table};
use msape::progress::Progress;
use msape::quantity::input::{self, find};
use msape::vehicle::body::from_rows;
use msape::{Case, Library};
use serde::{Deserialize, Serialize};

/// Asks for the rows of a file, in bytes.
#[derive(Debug, Serialize, Deserialize)]
pub struct Read(pub FileKind, pub Vec<u8>);

impl Question for Read {
    type Answer = ReadRows;
    type Refusal = Vec<String>;

    fn answer(self, desk: &Desk, _: &mut dyn Progress) -> Result<ReadRows, Vec<String>> {
        read(&self.0, &self.1, &desk.library)
    }
}

/// Kind of file to read.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum FileKind {
    /// Rows for a table of a case.
    Table {
        /// Key of the table.
        table: String,
        /// The case to which it belongs.
        case: Box<Case>,
    },
    /// Coefficients with angles of attack.
    Coefficients,
    /// Outline: name of the file, and symbol of its unit if given.
    Outline(String, Option<String>),
}

/// Rows read from a file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ReadRows {
    /// Key of the input that takes them.
    pub key: String,
    /// Rows in the form of a case.
    pub rows: Vec<Vec<f64>>,
    /// Messages of the reader.
    pub remarks: Vec<String>,
}

/// The rows of a file, or every fault of it with its line.
fn read(kind: &FileKind, bytes: &[u8], library: &Library) -> Result<ReadRows, Vec<String>> {
    match kind {
        FileKind::Table { table, case } => {
            let table = find(table).ok_or_else(|| vec![format!("{table}: is no input")])?;
            let ground = Ground::of(case, library);
            let read = table::read_for(table, bytes, &ground);
            Ok(rows(read.map_err(words)?))
        }
        FileKind::Coefficients => {
            let read = table::read(
                &input::vehicle::AERODYNAMICS_FILE,
                bytes,
                &Ground::earth(library),
            );
            let read = rows(read.map_err(words)?);
            if read.key == input::vehicle::AERODYNAMICS_TABLE.key {
                return Ok(read);
            }
            Err(vec![
                "the file is drag over the Mach number, as a point mass has it; a table here has angles of attack".to_string(),
            ])
        }
        FileKind::Outline(name, unit) => {
            let unit = unit.as_deref().and_then(outline::unit_of);
            let Imported { rows, remarks } = outline::read(name, bytes, unit).map_err(words)?;
            from_rows(name, &rows).map_err(words)?;
            let key = input::outline::POINTS.to_string();
            Ok(ReadRows { key, rows, remarks })
        }
    }
}

fn rows(Table { key, rows, remarks }: Table) -> ReadRows {
    let key = key.to_string();
    ReadRows { key, rows, remarks }
}

fn words<T: ToString>(faults: Vec<T>) -> Vec<String> {
    faults.iter().map(ToString::to_string).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn air(case: &Case) -> FileKind {
        FileKind::Table {
            table: "atmosphere.table".to_string(),
            case: Box::new(case.clone()),
        }
    }

    fn read(kind: FileKind, text: &str) -> Result<ReadRows, Vec<String>> {
        super::read(&kind, text.as_bytes(), &Library::builtin().unwrap())
    }

    #[test]
    fn an_outline_that_crosses_the_axis_is_refused() {
        let outline = |text: &str| read(FileKind::Outline("x.csv".to_string(), None), text);
        let faults = outline("x (m), r (m)\n0, 0\n1, 1\n2, -1\n3, 0\n").unwrap_err();
        assert!(faults[0].contains("axis"), "{faults:?}");
        assert!(outline("x (m), r (m)\n0, 0\n1, 1\n2, 0\n").is_ok());
        let unit = FileKind::Outline("x.csv".to_string(), Some("mm".to_string()));
        let rows = read(unit, "x, r\n0, 0\n1, 1\n2, 0\n").unwrap().rows;
        assert_eq!(rows[1][0], 0.001);
    }

    #[test]
    fn a_table_of_coefficients_has_angles_of_attack() {
        let faults = read(
            FileKind::Coefficients,
            "mach,alpha,ca,cn\n1,0,1,0\n1,5,,0\n",
        );
        assert!(faults.unwrap_err()[0].starts_with("line 3"));
        let drag = read(FileKind::Coefficients, "mach,cd\n1,1.2\n5,1.4\n").unwrap_err();
        assert!(drag[0].contains("drag over the Mach number"), "{drag:?}");
    }

    #[test]
    fn a_table_is_read_for_the_planet_of_its_case() {
        let mut mars = Case::default();
        mars.set("entry.planet", "mars");
        let read = |case: &Case| {
            read(
                air(case),
                "geopotential_altitude_m, density_kg_m3\n0, 0.02\n10000, 0.008\n",
            )
            .unwrap()
        };
        let (there, here) = (read(&mars), read(&Case::default()));
        assert_eq!(here.key, "atmosphere.table");
        // r H / (r − H) with 6356.766 km, and with the 3389.5 km of Mars
        assert!((here.rows[1][0] - 10_015.76).abs() < 0.01, "{here:?}");
        assert!((there.rows[1][0] - 10_029.6).abs() < 0.1, "{there:?}");
    }

    #[test]
    fn a_spreadsheet_in_germany_is_read_and_thousands_are_not_guessed() {
        let read = |text: &str| read(air(&Case::default()), text).map(|table| table.rows);
        let rows = vec![vec![0.0, 1.225], vec![1e3, 1.1]];
        assert_eq!(read("0\t1,2250\n1000\t1,1\n"), Ok(rows.clone()));
        assert_eq!(read("z (km);rho (kg/m3)\n0;1,225\n1;1,1\n"), Ok(rows));
        assert!(read("0 1,225\n1000 1,100\n").is_err());
        assert!(read("0 x").is_err());
    }
    #[test]
    fn rows_reach_the_table_that_they_were_pasted_for_or_none() {
        let read = |table: &str, text: &str| {
            let kind = FileKind::Table {
                table: table.to_string(),
                case: Box::default(),
            };
            read(kind, text)
        };
        let table = "vehicle.bank_speed_table_deg";
        let rows = read(table, "7000\t0,5\n8000\t1,5\n").unwrap();
        assert_eq!((rows.key.as_str(), rows.rows.len()), (table, 2));
        let other = read(table, "t (s);bank (deg)\n0;0,5\n9;1,5\n").unwrap_err();
        assert!(other[0].contains("vehicle.bank_table_deg"), "{other:?}");
    }
}
