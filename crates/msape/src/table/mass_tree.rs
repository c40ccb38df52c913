//! The mass tree of a vehicle as a table.

use super::Table;
use crate::units::number::shortest;
use crate::vehicle::Vehicle;
use crate::vehicle::mass_tree::Line;

/// A column: key with unit, and the cell of a line.
type Column = (&'static str, fn(&Line) -> String);

const COLUMNS: [Column; 12] = [
    ("component", |line| line.name.clone()),
    ("material", |line| line.material.clone().unwrap_or_default()),
    ("density_kg_m3", |line| cell(line.density_kg_m3)),
    ("density_basis", |line| {
        let basis = line.density_basis.map(|basis| basis.name());
        basis.unwrap_or_default().to_string()
    }),
    ("volume_m3", |line| cell(line.volume_m3)),
    ("surface_area_m2", |line| cell(line.surface_area_m2)),
    ("wetted_area_m2", |line| cell(line.wetted_area_m2)),
    ("mass_kg", |line| shortest(line.mass_kg)),
    ("cg_from_nose_m", |line| shortest(line.cg_from_nose_m)),
    ("ixx_kg_m2", |line| shortest(line.ixx_kg_m2)),
    ("iyy_kg_m2", |line| shortest(line.iyy_kg_m2)),
    ("izz_kg_m2", |line| shortest(line.izz_kg_m2)),
];

fn cell(number: Option<f64>) -> String {
    number.map_or_else(String::new, shortest)
}

/// One row for each component, then the sum without margin, the margin, the whole, and the whole after landing; masses and inertias of
/// components are without margin, inertias through the row's own center of gravity.
///
/// ```
/// use msape::{Case, Library, Request, design, table};
///
/// let library = Library::builtin().unwrap();
/// let text = msape::library::data_file("cases/galahad.toml").unwrap();
/// let answer = design(&Case::from_text(text).unwrap(), &library, Request::Nothing).unwrap();
/// let csv = table::mass_tree(&answer.design.unwrap().vehicle).to_csv();
/// assert!(csv.starts_with("component,material,density_kg_m3,"));
/// assert!(csv.contains("\nMargin,"));
/// ```
pub fn mass_tree(vehicle: &Vehicle) -> Table {
    Table {
        headers: COLUMNS.iter().map(|(key, _)| key.to_string()).collect(),
        rows: vehicle
            .mass_tree()
            .lines()
            .map(|line| COLUMNS.iter().map(|(_, cell)| cell(line)).collect())
            .collect(),
    }
}
