//! Checks which database a rigid body flies with: that of its own outline, or a table of the case.

use super::aerodynamics;
use super::outline::Outline;
use crate::aero::standard::AeroBody;
use crate::aero::{Drag, DragTable};
use crate::case::Reader;
use crate::finding::{Finding, Severity};
use crate::flight::six_dof::aerodynamics::OfOutline;
use crate::library::{Library, named};

/// The database of the outline of a case; with axial force by name where one is named, else that of the outline.
pub(super) fn database(
    reader: &mut Reader,
    library: &Library,
    outline: &Outline,
) -> Option<OfOutline> {
    let Outline::Body(body) = outline else {
        if *outline == Outline::Absent {
            reader.fault("vehicle.aerodynamics", "with vehicle.dof = 6 give an [outline] from which force and moment are computed, or constants in [vehicle.aerodynamics]");
        }
        return None;
    };
    let body = AeroBody::of_rigid(body, None);
    let (title, force) = axial_force(reader, library, &body)?;
    let database =
        aerodynamics::database(reader, library, &body, Some(&Drag::Table(force.clone())))?;
    let (message, axial_force) = match database.table() {
        Some(grid) => (
            "Coefficients are those of the table of the case.".to_string(),
            DragTable::try_new(&grid.axial_force_rows()).unwrap_or(force),
        ),
        None => (
            format!(
                "Coefficients are computed from the outline, axial force nose first from \"{title}\"; pitch damping between Mach 0.5 and free-molecular flow is a placeholder where no table of damping is given."
            ),
            force,
        ),
    };
    reader.findings.push(Finding {
        severity: Severity::Note,
        model: "aerodynamics".to_string(),
        key: "vehicle.aerodynamics".to_string(),
        value: None,
        valid: (None, None),
        message,
        source: "NASA/TM-2014-218507, section 3.3".to_string(),
        field: Some("vehicle.aerodynamics".to_string()),
    });
    Some(OfOutline {
        database,
        axial_force,
    })
}

/// Axial force nose first and its title.
fn axial_force(
    reader: &mut Reader,
    library: &Library,
    body: &AeroBody,
) -> Option<(String, DragTable)> {
    if !reader.given("vehicle.aerodynamics") {
        return Some(("the outline itself".to_string(), body.axial_force(library)));
    }
    let names: Vec<&str> = library
        .aerodynamics
        .iter()
        .map(|(name, _)| name.as_str())
        .collect();
    let name = reader.choice("vehicle.aerodynamics", &names)?;
    let force = named(&library.aerodynamics, name)?;
    Some((force.title.clone(), force.table.clone()))
}
