//! Checks the coefficients over the angle of attack of a case.

use super::fitted_in_air::fitted_in_air;
use super::forms::beyond;
use super::planet::{atmosphere, planet};
use crate::aero::bridging::Bridging;
use crate::aero::damping::{Damping, Reading};
use crate::aero::database::{Database, GAMMA};
use crate::aero::standard::{AeroBody, Standard};
use crate::aero::table::{Content, Extrapolation, Given, Grid, Row, in_radians};
use crate::aero::{Drag, DragTable, Own};
use crate::case::Reader;
use crate::finding::range::short;
use crate::finding::{Finding, Severity};
use crate::flight::mission::Mission;
use crate::library::{Library, named, names};
use crate::planet::Planet;
use crate::planet::atmosphere::Atmosphere;
use crate::quantity::choice::DampingModel;
use crate::quantity::input::{self, Input};
use numerics::math::RADIANS_PER_DEGREE;

const TABLE: &Input = &input::vehicle::AERODYNAMICS_TABLE;
const DAMPING_TABLE: &Input = &input::vehicle::AERODYNAMICS_DAMPING_TABLE;

/// Air to which coefficients apply.
#[derive(Clone, Debug)]
pub(super) struct Medium {
    atmosphere: Atmosphere,
    /// Ratio of its heat capacities where the vehicle is slowed.
    pub heat_capacity_ratio: f64,
}

impl Medium {
    /// The air of a mission; that of the default planet where the mission is at fault, so that the vehicle is checked all the same.
    pub fn of(mission: Option<&Mission>, library: &Library) -> Option<Medium> {
        if let Some(mission) = mission {
            return Some(Medium {
                atmosphere: mission.atmosphere.clone(),
                heat_capacity_ratio: mission.heat_capacity_ratio(),
            });
        }
        let (_, world) = library.planets.first()?;
        Some(Medium::through(&world.planet, world.atmosphere.clone()))
    }

    /// The air of the planet of a case.
    pub(super) fn of_case(reader: &mut Reader, library: &Library) -> Option<Medium> {
        let planet = planet(reader, library);
        let atmosphere = atmosphere(reader, library, &planet)?;
        Some(Medium::through(&planet?.0, atmosphere))
    }

    fn through(planet: &Planet, atmosphere: Atmosphere) -> Medium {
        Medium {
            heat_capacity_ratio: planet.heat_capacity_ratio(&atmosphere),
            atmosphere,
        }
    }
}

/// The drag that a case names, constant or against Mach number; the outline's own where it names none.
pub(super) fn named_drag(
    reader: &mut Reader,
    library: &Library,
    gamma: Option<f64>,
) -> Option<Drag> {
    let own = [TABLE, &input::vehicle::DRAG_COEFFICIENT];
    let by_name = reader.given(&input::vehicle::AERODYNAMICS);
    if let (true, Some(gamma)) = (by_name || !reader.any_given(&own), gamma) {
        let name = reader
            .text(&input::vehicle::AERODYNAMICS)
            .filter(|_| by_name);
        fitted_in_air(reader, gamma, name.as_deref());
    }
    if reader.given(&input::vehicle::AERODYNAMICS) {
        let name = reader.name(&input::vehicle::AERODYNAMICS, &names(&library.aerodynamics))?;
        return named(&library.aerodynamics, name).map(|force| Drag::Table(force.table.clone()));
    }
    reader
        .given(&input::vehicle::DRAG_COEFFICIENT)
        .then(|| reader.number(&input::vehicle::DRAG_COEFFICIENT))
        .flatten()
        .map(Drag::Constant)
}

/// Coefficients that a case gives for a body, which may not be known yet.
#[derive(Clone, Debug)]
pub(super) enum Coefficients {
    /// A table of the case.
    Table(Box<OwnTable>),
    /// Computed from the outline.
    Computed(Box<Computed>),
}

impl Coefficients {
    /// Reads them for a body of about this diameter, with the drag at zero angle of attack that is given; `None` at a fault.
    pub(super) fn read(
        reader: &mut Reader,
        library: &Library,
        medium: &Medium,
        diameter_m: f64,
        drag: Option<&Drag>,
    ) -> Option<Coefficients> {
        let before = reader.faults.len();
        let bridging = reader.choice(&input::vehicle::AERODYNAMICS_BRIDGING);
        let wall = reader.number(&input::vehicle::AERODYNAMICS_WALL_TEMPERATURE_RATIO);
        let accommodation = reader.number(&input::vehicle::AERODYNAMICS_ACCOMMODATION);
        if reader.given(TABLE) {
            return OwnTable::read(reader, library, medium, diameter_m)
                .map(|table| Coefficients::Table(Box::new(table)));
        }
        let damping = damping(reader, library);
        if reader.faults.len() > before {
            return None;
        }
        Some(Coefficients::Computed(Box::new(Computed {
            standard: library.aero_standard().in_gas(medium.heat_capacity_ratio),
            heat_capacity_ratio: medium.heat_capacity_ratio,
            drag: drag.cloned(),
            damping: damping?,
            bridging: bridging?,
            wall_temperature_ratio: wall?,
            accommodation: accommodation?,
        })))
    }

    /// The database of a body.
    ///
    /// # Errors
    /// Faults of a table over altitudes, at the diameter of the body.
    pub(super) fn of(&self, body: &AeroBody) -> Result<Database, Vec<String>> {
        match self {
            Coefficients::Table(table) => table.database(body.surface.diameter_m()),
            Coefficients::Computed(computed) => Ok(computed.database(body)),
        }
    }

    /// The database of a body; `None` where its table is at fault.
    pub(super) fn noted(&self, reader: &mut Reader, body: &AeroBody) -> Option<Database> {
        noted_database(reader, self.of(body))
    }

    /// Ratio of the heat capacities of the gas for which they are computed; that of air where they are a table.
    pub(super) fn heat_capacity_ratio(&self) -> f64 {
        match self {
            Coefficients::Table(_) => GAMMA,
            Coefficients::Computed(computed) => computed.heat_capacity_ratio,
        }
    }
}

/// How coefficients are computed from an outline.
#[derive(Clone, Debug)]
pub(super) struct Computed {
    standard: Standard,
    heat_capacity_ratio: f64,
    drag: Option<Drag>,
    damping: Damping,
    bridging: Bridging,
    wall_temperature_ratio: f64,
    accommodation: f64,
}

impl Computed {
    fn database(&self, body: &AeroBody) -> Database {
        let mut options = body.options(&self.standard, self.drag.as_ref());
        options.damping = self.damping.clone();
        options.bridging = self.bridging;
        options.wall_temperature_ratio = self.wall_temperature_ratio;
        options.accommodation = [self.accommodation; 2];
        Database::of_surface(&body.surface, options)
    }
}

/// Rows of a table of coefficients and the air in which their altitudes are Knudsen numbers.
#[derive(Clone, Debug)]
struct Rows {
    rows: Vec<Row>,
    rule: Extrapolation,
    medium: Medium,
}

impl Rows {
    /// The table of static coefficients of the case; `None` where it has none, or a faulty one.
    fn read(reader: &mut Reader, medium: &Medium) -> Option<Rows> {
        if !reader.given(TABLE) {
            return None;
        }
        let rule = beyond(reader, &input::vehicle::AERODYNAMICS_EXTRAPOLATION);
        let cells = reader.rows(TABLE)?;
        let rows = cells.iter().zip(1..);
        Some(Rows {
            rows: rows
                .map(|(cells, line)| Row::of_cells(cells, line))
                .collect(),
            rule,
            medium: medium.clone(),
        })
    }

    /// The grid for a body of this diameter, m.
    fn grid(&self, diameter_m: f64) -> Result<Grid, Vec<String>> {
        let knudsen = |altitude_m: f64| {
            let air = self.medium.atmosphere.air(altitude_m);
            air.mean_free_path_m / diameter_m
        };
        let rows = self.rows.iter().map(|row| Row {
            knudsen: row.altitude_m.map(knudsen).or(row.knudsen),
            ..*row
        });
        grid(&rows.collect::<Vec<_>>(), self.rule)
    }

    fn checked(&self, reader: &mut Reader, diameter_m: f64) -> Option<Grid> {
        noted(reader, TABLE, self.grid(diameter_m))
    }
}

/// A table of coefficients of the case and its damping.
#[derive(Clone, Debug)]
pub(super) struct OwnTable {
    rows: Rows,
    /// The rows for a body of this diameter, m.
    checked: (f64, Grid),
    damping: Damping,
    /// Whether the case gives this damping; otherwise that of the table takes precedence.
    damping_given: bool,
}

impl OwnTable {
    /// Reads it for a body of about this diameter; `None` where the case has none, or a faulty one.
    pub(super) fn read(
        reader: &mut Reader,
        library: &Library,
        medium: &Medium,
        diameter_m: f64,
    ) -> Option<OwnTable> {
        let before = reader.faults.len();
        let damping = damping(reader, library);
        let rows = Rows::read(reader, medium)?;
        let grid = rows.checked(reader, diameter_m)?;
        if reader.faults.len() > before {
            return None;
        }
        let given = [DAMPING_TABLE, &input::vehicle::AERODYNAMICS_DAMPING];
        Some(OwnTable {
            rows,
            checked: (diameter_m, grid),
            damping: damping?,
            damping_given: reader.any_given(&given),
        })
    }

    /// The database of a body of this diameter.
    ///
    /// # Errors
    /// Faults of a table over altitudes, at this diameter.
    pub(super) fn database(&self, diameter_m: f64) -> Result<Database, Vec<String>> {
        let grid = match &self.checked {
            (of_m, grid) if *of_m == diameter_m => grid.clone(),
            _ => self.rows.grid(diameter_m)?,
        };
        let has_damping = matches!(
            grid.content,
            Content::Static {
                damping: Given::Yes,
                ..
            }
        );
        let damping = match has_damping && !self.damping_given {
            true => Damping::Table(grid.clone()),
            false => self.damping.clone(),
        };
        Ok(Database::of_table(grid, diameter_m, damping))
    }
}

/// A database, or `None` with the faults of its table noted.
pub(super) fn noted_database(
    reader: &mut Reader,
    database: Result<Database, Vec<String>>,
) -> Option<Database> {
    let mut note = |faults: Vec<String>| {
        let faults = faults.into_iter();
        faults.for_each(|fault| reader.fault(TABLE, fault));
    };
    database.map_err(&mut note).ok()
}

/// Drag at zero angle of attack of a table of the case; `None` where it has none, or a faulty one.
pub(super) fn table_drag(reader: &mut Reader, medium: &Medium, diameter_m: f64) -> Option<Drag> {
    let grid = Rows::read(reader, medium)?.checked(reader, diameter_m)?;
    let rows = grid.axial_force_rows();
    let own = Own {
        key: TABLE.key,
        extrapolation: grid.extrapolation,
    };
    match DragTable::try_new(&rows) {
        Ok(table) => Some(Drag::Table(table.of_case(own))),
        Err(faults) => {
            faults
                .iter()
                .for_each(|fault| reader.fault(TABLE, fault.as_str()));
            None
        }
    }
}

/// A grid of rows of a case, whose faults name the row.
fn grid(rows: &[Row], rule: Extrapolation) -> Result<Grid, Vec<String>> {
    let of_row = |faults: Vec<String>| {
        let faults = faults.iter().map(|fault| fault.replace("line ", "row "));
        faults.collect()
    };
    Grid::try_new(rows, rule).map_err(of_row)
}

/// A grid with its remark, or `None` with its faults noted.
fn noted(
    reader: &mut Reader,
    input: &'static Input,
    grid: Result<Grid, Vec<String>>,
) -> Option<Grid> {
    match grid {
        Ok(grid) => {
            let largest_deg = grid.alpha_max_rad() / RADIANS_PER_DEGREE;
            if in_radians(largest_deg) {
                reader.findings.push(of_radians(input, largest_deg));
            }
            Some(grid)
        }
        Err(faults) => {
            for fault in faults {
                reader.fault(input, fault);
            }
            None
        }
    }
}

/// Finding on angles of a table that may be in radians.
fn of_radians(input: &Input, largest_deg: f64) -> Finding {
    Finding {
        severity: Severity::Exceeded,
        model: input.to_string(),
        key: input::column::ALPHA_DEG.name.to_string(),
        value: Some(largest_deg),
        valid: (Some(0.0), Some(180.0)),
        message: format!(
            "The largest angle of the table is {} deg, a part of pi: are its angles in rad?",
            short(largest_deg)
        ),
        source: "the rows given".to_string(),
        field: Some(input.to_string()),
    }
}

fn damping(reader: &mut Reader, library: &Library) -> Option<Damping> {
    let model = reader.choice(&input::vehicle::AERODYNAMICS_DAMPING);
    if reader.given(DAMPING_TABLE) {
        let rule = beyond(reader, &input::vehicle::AERODYNAMICS_EXTRAPOLATION);
        let rows: Vec<Row> = reader
            .rows(DAMPING_TABLE)?
            .iter()
            .zip(1..)
            .map(|(cells, line)| Row::of_damping(cells, line))
            .collect();
        return noted(reader, DAMPING_TABLE, grid(&rows, rule)).map(Damping::Table);
    }
    Some(match model? {
        DampingModel::None => Damping::Absent,
        DampingModel::ReportPrinted => library.aero_standard().damping(Reading::Printed),
        DampingModel::Report => library.aero_standard().damping(Reading::Corrected),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faults_of_a_table_of_a_case_name_its_rows() {
        let row = Row::of_cells(&[1.0, 0.0, 1.5, 0.0], 2);
        let faults = grid(&[row, row], Extrapolation::Hold).unwrap_err();
        assert!(
            faults.concat().contains("row 2") && !faults.concat().contains("line"),
            "{faults:?}"
        );
    }
}
