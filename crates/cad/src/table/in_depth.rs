//! Conditions at the wall of a heat shield in time, from a CSV file in the columns of the interchange.
//!
//! ```text
//! t_s,p_Pa,CH_kg_m2s,h_r_J_kg[,q_rad_W_m2][,chemistry]        t_s,T_K,p_Pa[,recession_m_s]
//! ```
//!
//! # Valid
//! Columns by these names in any order; commas, semicolons or tabs between them; `#` begins a remark.
//! # References
//! - Own convention, after the tables that PATO reads.

use super::{MOST_FAULTS, Table, TableFault, shown};
use msape::quantity::input::{Input, Kind, tps};

/// Rows of an environment.
pub fn environment(text: &str) -> Result<Table, Vec<TableFault>> {
    // Without radiation there is none; without a word on chemistry the boundary layer reaches the wall.
    read(text, &tps::ENVIRONMENT_TABLE, &[0.0, 1.0])
}

/// Rows of a surface temperature.
pub fn surface_temperature(text: &str) -> Result<Table, Vec<TableFault>> {
    read(text, &tps::SURFACE_TEMPERATURE_TABLE, &[0.0])
}

/// Rows of an input by the names of its columns; `otherwise` are the values of those that may be absent.
fn read(text: &str, input: &Input, otherwise: &[f64]) -> Result<Table, Vec<TableFault>> {
    let Kind::Rows(columns) = input.kind else {
        return Err(vec![TableFault::NoFile(input.to_string())]);
    };
    let fault = |message: String| TableFault::Rows(message);
    let mut lines = text
        .lines()
        .zip(1..)
        .filter(|(line, _)| !line.trim().is_empty() && !line.trim_start().starts_with('#'));
    let names: Vec<&str> = columns.iter().map(|column| column.name).collect();
    let Some((header, _)) = lines.next() else {
        return Err(vec![TableFault::Empty]);
    };
    let sign = [',', ';', '\t']
        .into_iter()
        .max_by_key(|sign| header.matches(*sign).count())
        .unwrap_or(',');
    let has_number = |(line, _): (&str, _)| {
        let mut cells = line.split(sign);
        cells.any(|cell| cell.trim().parse::<f64>().is_ok())
    };
    // a file that is no table is not shown
    if !lines.clone().any(has_number) {
        return Err(vec![TableFault::Empty]);
    }
    let headings: Vec<&str> = header
        .split(sign)
        .map(|heading| heading.trim().trim_matches('"'))
        .collect();
    let mut faults = Vec::new();
    for heading in headings.iter().filter(|heading| !names.contains(heading)) {
        faults.push(fault(format!(
            "header: \"{}\" is not known; must be {}",
            shown(heading),
            names.join(", ")
        )));
    }
    let places: Vec<Option<usize>> = names
        .iter()
        .map(|name| headings.iter().position(|heading| heading == name))
        .collect();
    for (column, place) in columns.iter().zip(&places) {
        if column.required && place.is_none() {
            faults.push(fault(format!("header: {} is missing", column.name)));
        }
    }
    if !faults.is_empty() {
        return Err(faults);
    }
    let required = columns.iter().filter(|column| column.required).count();
    let mut rows = Vec::new();
    for (line, number) in lines {
        let cells: Vec<&str> = line.split(sign).map(str::trim).collect();
        let mut row = Vec::with_capacity(columns.len());
        for (i, (column, place)) in columns.iter().zip(&places).enumerate() {
            let Some(place) = place else {
                row.push(
                    i.checked_sub(required)
                        .and_then(|i| otherwise.get(i))
                        .copied()
                        .unwrap_or_default(),
                );
                continue;
            };
            let cell = cells.get(*place).copied().unwrap_or_default();
            match cell.parse::<f64>() {
                Ok(value) if value.is_finite() => row.push(value),
                _ if faults.len() < MOST_FAULTS => {
                    faults.push(fault(format!(
                        "line {number}: {}: got \"{}\", must be a finite number",
                        column.name,
                        shown(cell)
                    )));
                }
                _ => {}
            }
        }
        rows.push(row);
    }
    if !faults.is_empty() {
        return Err(faults);
    }
    Ok(Table {
        key: input.key,
        rows,
        remarks: Vec::new(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_in_any_order_and_absent_ones_have_their_values() {
        let table = environment(
            "# x\np_Pa;t_s;h_r_J_kg;CH_kg_m2s;chemistry\n1e5;0;1e6;0.3;1\n1e5;1;0;0;0\n",
        )
        .unwrap();
        assert_eq!(table.key, "tps.environment_table");
        assert_eq!(
            table.rows,
            [
                [0.0, 1e5, 0.3, 1e6, 0.0, 1.0],
                [1.0, 1e5, 0.0, 0.0, 0.0, 0.0]
            ]
        );
        let held = surface_temperature("t_s,T_K,p_Pa\n0,300,1e5\n").unwrap();
        assert_eq!(held.rows, [[0.0, 300.0, 1e5, 0.0]]);
    }

    #[test]
    fn faults_name_line_column_and_value() {
        let said = |text: &str| {
            let faults = environment(text).unwrap_err();
            faults
                .iter()
                .map(ToString::to_string)
                .collect::<Vec<_>>()
                .join("\n")
        };
        assert!(
            said("t_s,p_Pa,CH_kg_m2s,h_r_cal_g\n0,1,2,3\n")
                .contains("\"h_r_cal_g\" is not known; must be t_s, p_Pa")
        );
        assert!(said("t_s,p_Pa,CH_kg_m2s\n0,1,2\n").contains("h_r_J_kg is missing"));
        assert!(
            said("t_s,p_Pa,CH_kg_m2s,h_r_J_kg\n0,1,NaN,2\n")
                .contains("line 2: CH_kg_m2s: got \"NaN\"")
        );
        assert_eq!(said(""), "the file holds no row of numbers");
        assert_eq!(said("t_s,p_Pa\n"), "the file holds no row of numbers");
    }
}
