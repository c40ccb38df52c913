//! Checks what a case says about coefficients over the angle of attack.

use super::DesignProblem;
use super::forms::{beyond, names, one_row};
use super::outline::rigid_body;
use super::planet::{atmosphere, planet};
use crate::aero::damping::{Damping, Reading};
use crate::aero::database::{Database, GAMMA};
use crate::aero::standard::AeroBody;
use crate::aero::table::{Content, Extrapolation, Given, Grid, Row, in_radians};
use crate::aero::{Drag, DragTable, Own};
use crate::case::{Case, InputError, Reader};
use crate::finding::range::short;
use crate::finding::{Finding, Severity};
use crate::flight::Request;
use crate::flight::mission::Mission;
use crate::library::{Library, named};
use crate::planet::Planet;
use crate::planet::atmosphere::Atmosphere;
use crate::quantity::choice::DampingModel;
use crate::quantity::input::{self, Input};
use numerics::math::RADIANS_PER_DEGREE;

const TABLE: &Input = &input::vehicle::AERODYNAMICS_TABLE;
const DAMPING_TABLE: &Input = &input::vehicle::AERODYNAMICS_DAMPING_TABLE;

/// The air for which coefficients are.
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
    fn of_case(reader: &mut Reader, library: &Library) -> Option<Medium> {
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

/// A body and the database of its coefficients.
pub type BodyCoefficients = (AeroBody, Database);

/// A body and its database, from a case with an outline or from a design.
///
/// # Errors
/// Every fault of the case at once.
pub fn aero(case: &Case, library: &Library) -> Result<BodyCoefficients, Vec<InputError>> {
    remarked_aero(case, library).map(|(found, _)| found)
}

/// The same with what the check remarked.
///
/// # Errors
/// Every fault of the case at once.
pub fn remarked_aero(
    case: &Case,
    library: &Library,
) -> Result<(BodyCoefficients, Vec<Finding>), Vec<InputError>> {
    let mut reader = Reader::new(case);
    let cg_m = one_row::<3>(&mut reader, &input::vehicle::CG_M).flatten();
    let body = match rigid_body(case, library) {
        Ok(Some(body)) => Some(AeroBody::of_rigid(&body, cg_m)),
        Ok(None) => designed(case, library, &mut reader),
        Err(faults) => {
            reader.faults.retain(|fault| !faults.contains(fault));
            reader.faults.extend(faults);
            None
        }
    };
    // What is wrong with the planet, the check of a design has said before.
    let medium = match reader.faults.is_empty() {
        true => Medium::of_case(&mut reader, library),
        false => None,
    };
    let gamma = medium.as_ref().map(|medium| medium.heat_capacity_ratio);
    let drag = named_drag(&mut reader, library, gamma);
    let database = (body.as_ref().zip(medium))
        .and_then(|(body, medium)| database(&mut reader, library, &medium, body, drag.as_ref()));
    match body.zip(database) {
        Some(found) if reader.faults.is_empty() => Ok((found, reader.into_findings())),
        _ => Err(reader.into_faults()),
    }
}

/// The vehicle of a design.
fn designed(case: &Case, library: &Library, reader: &mut Reader) -> Option<AeroBody> {
    if !case.values.keys().any(|key| key.starts_with("design.")) {
        reader.fault(
            "outline",
            "missing; give [outline], as a preset, by dimensions or by points, or the case of a design",
        );
        return None;
    }
    if !reader.faults.is_empty() {
        return None;
    }
    match DesignProblem::check(case, library) {
        Ok(problem) => {
            let answer = problem.solve(&case.name, Request::Nothing);
            match &answer.design {
                Some(design) => Some(AeroBody::of_vehicle(&answer.name, &design.vehicle)),
                None => {
                    let reason = answer.reason.unwrap_or_default();
                    reader.fault("design", format!("the vehicle does not close: {reason}"));
                    None
                }
            }
        }
        Err(faults) => {
            reader.faults.extend(faults);
            None
        }
    }
}

/// The drag that a case names, constant or against Mach number; the outline's own where it names none.
fn named_drag(reader: &mut Reader, library: &Library, gamma: Option<f64>) -> Option<Drag> {
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

/// The database of a body: a table of the case, else computed with the drag at zero angle of attack that is given.
pub(super) fn database(
    reader: &mut Reader,
    library: &Library,
    medium: &Medium,
    body: &AeroBody,
    drag: Option<&Drag>,
) -> Option<Database> {
    let before = reader.faults.len();
    let diameter_m = body.surface.diameter_m();
    let damping = damping(reader, library);
    let bridging = reader.choice(&input::vehicle::AERODYNAMICS_BRIDGING);
    let wall = reader.number(&input::vehicle::AERODYNAMICS_WALL_TEMPERATURE_RATIO);
    let accommodation = reader.number(&input::vehicle::AERODYNAMICS_ACCOMMODATION);
    if reader.given(TABLE) {
        return table_database(reader, library, medium, diameter_m);
    }
    if reader.faults.len() > before {
        return None;
    }
    let standard = library.aero_standard().in_gas(medium.heat_capacity_ratio);
    let mut options = body.options(&standard, drag);
    options.damping = damping?;
    options.bridging = bridging?;
    options.wall_temperature_ratio = wall?;
    options.accommodation = [accommodation?; 2];
    Some(Database::of_surface(&body.surface, options))
}

/// The database of a table of the case; `None` where it has none, or a faulty one.
pub(super) fn table_database(
    reader: &mut Reader,
    library: &Library,
    medium: &Medium,
    diameter_m: f64,
) -> Option<Database> {
    let before = reader.faults.len();
    let damping = damping(reader, library);
    let table = table(reader, medium, diameter_m);
    if reader.faults.len() > before {
        return None;
    }
    let grid = table?;
    let own = matches!(
        grid.content,
        Content::Static {
            damping: Given::Yes,
            ..
        }
    );
    let given = reader.given(DAMPING_TABLE) || reader.given(&input::vehicle::AERODYNAMICS_DAMPING);
    let damping = if own && !given {
        Damping::Table(grid.clone())
    } else {
        damping?
    };
    Some(Database::of_table(grid, diameter_m, damping))
}

/// Drag at zero angle of attack of a table of the case; `None` where it has none, or a faulty one.
pub(super) fn table_drag(reader: &mut Reader, medium: &Medium, diameter_m: f64) -> Option<Drag> {
    let grid = table(reader, medium, diameter_m)?;
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

/// Difference of the ratio of heat capacities from that of air within which a gas counts as air: assumed. Nitrogen and air at 250 to
/// 350 K are within 0.005; hydrogen with helium has 1.45 and carbon dioxide 1.3.
const OF_AIR: f64 = 0.02;

/// A finding where the axial force of an outline, which partly is a fit in air, or of a table by name is used in another gas.
pub(super) fn fitted_in_air(reader: &mut Reader, heat_capacity_ratio: f64, table: Option<&str>) {
    if (heat_capacity_ratio - GAMMA).abs() <= OF_AIR {
        return;
    }
    let gamma = short(heat_capacity_ratio);
    let (model, message, source) = match table {
        None => (
            "axial force of the outline",
            format!(
                "The axial force is corrected by a fit to solutions of the Euler equations, and below Mach 3 by tables, both of air; this gas has a ratio of heat capacities of {gamma}, which only the stagnation pressure takes."
            ),
            "data/aero-models/euler-correction.toml".to_string(),
        ),
        Some(name) => (
            "axial force by name",
            format!(
                "The axial force of {name} is that of air, or of a gas that its source does not name; this gas has a ratio of heat capacities of {gamma}, which the table does not take."
            ),
            format!("data/aerodynamics/{name}.csv"),
        ),
    };
    reader.findings.push(Finding {
        severity: Severity::Extrapolated,
        model: model.to_string(),
        key: "heat_capacity_ratio".to_string(),
        value: Some(heat_capacity_ratio),
        valid: (Some(GAMMA - OF_AIR), Some(GAMMA + OF_AIR)),
        message,
        source,
        field: Some(input::entry::PLANET.to_string()),
    });
}

/// The table of static coefficients of the case.
fn table(reader: &mut Reader, medium: &Medium, diameter_m: f64) -> Option<Grid> {
    let file = &input::vehicle::AERODYNAMICS_FILE;
    if reader.given(file) {
        reader.not_read(file);
    }
    if !reader.given(TABLE) {
        return None;
    }
    let rule = beyond(reader, &input::vehicle::AERODYNAMICS_EXTRAPOLATION);
    let rows: Vec<Row> = reader
        .rows(TABLE)?
        .iter()
        .zip(1..)
        .map(|(cells, line)| Row::of_cells(cells, line))
        .map(|row| Row {
            knudsen: row.altitude_m.map_or(row.knudsen, |altitude_m| {
                let air = medium.atmosphere.air(altitude_m);
                Some(air.mean_free_path_m / diameter_m)
            }),
            ..row
        })
        .collect();
    grid(reader, TABLE, &rows, rule)
}

fn grid(
    reader: &mut Reader,
    input: &'static Input,
    rows: &[Row],
    rule: Extrapolation,
) -> Option<Grid> {
    match Grid::try_new(rows, rule) {
        Ok(grid) => {
            let largest_deg = grid.alpha_max_rad() / RADIANS_PER_DEGREE;
            if in_radians(largest_deg) {
                reader.findings.push(of_radians(input, largest_deg));
            }
            Some(grid)
        }
        Err(faults) => {
            for fault in faults {
                reader.fault(input, fault.replace("line ", "row "));
            }
            None
        }
    }
}

/// What is said of angles that may be in radians.
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
        return grid(reader, DAMPING_TABLE, &rows, rule).map(Damping::Table);
    }
    Some(match model? {
        DampingModel::None => Damping::Absent,
        DampingModel::ReportPrinted => library.aero_standard().damping(Reading::Printed),
        DampingModel::Report => library.aero_standard().damping(Reading::Corrected),
    })
}

#[cfg(test)]
mod tests {
    use super::remarked_aero;
    use crate::finding::Finding;
    use crate::problem::{DesignProblem, FlightProblem};
    use crate::{Case, Library};

    fn case(name: &str, changes: &[(&str, &str)]) -> Case {
        let text = crate::library::data_file(name).unwrap();
        let mut case = Case::from_text(text).unwrap();
        for (key, value) in changes {
            case.set(key, value);
        }
        case
    }

    fn of_air(findings: &[Finding]) -> Option<&str> {
        let mut findings = findings.iter();
        let found = findings.find(|finding| finding.key == "heat_capacity_ratio")?;
        Some(&found.model)
    }

    #[test]
    fn what_was_fitted_in_air_is_told_in_another_gas() {
        let library = Library::builtin().unwrap();
        let stardust = "cases/stardust.toml";
        for planet in ["mars", "earth"] {
            let there = [
                ("entry.planet", planet),
                ("entry.atmosphere", "planet"),
                ("entry.radius_m", ""),
                ("entry.altitude_m", "120000"),
                ("heating.radiative", "none"),
                ("vehicle.drag_coefficient", ""),
            ];
            let told = |model: &'static str| (planet == "mars").then_some(model);
            for (key, value, model) in [
                (
                    "vehicle.aerodynamics",
                    "sphere-cone-70",
                    "axial force by name",
                ),
                ("outline.preset", "stardust", "axial force of the outline"),
            ] {
                let case = case(stardust, &[&there[..], &[(key, value)]].concat());
                let problem = FlightProblem::check(&case, &library).unwrap();
                assert_eq!(of_air(&problem.findings), told(model), "{planet} {key}");
            }
            for (name, model) in [
                ("mmeev-60", "axial force by name"),
                ("outline", "axial force of the outline"),
            ] {
                let of_design = [("design.aerodynamics", name)];
                let case = case(
                    "cases/galahad.toml",
                    &[&there[..5], &of_design[..]].concat(),
                );
                let problem = DesignProblem::check(&case, &library).unwrap();
                assert_eq!(of_air(&problem.findings), told(model), "{planet} {name}");
            }
            for (name, model) in [
                ("sphere-cone-70", "axial force by name"),
                ("", "axial force of the outline"),
            ] {
                let more = [
                    ("outline.preset", "stardust"),
                    ("vehicle.aerodynamics", name),
                ];
                let case = case(stardust, &[&there[..], &more[..]].concat());
                let (_, findings) = remarked_aero(&case, &library).unwrap();
                assert_eq!(of_air(&findings), told(model), "{planet} aero {name}");
            }
        }
    }
}
