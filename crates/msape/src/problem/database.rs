//! Checks which database a rigid body flies with: that of its own outline.

use super::outline::Outline;
use crate::aero::AxialForce;
use crate::aero::bridging::Bridging;
use crate::aero::damping::{Damping, Reading};
use crate::aero::database::{Database, Options};
use crate::case::Reader;
use crate::finding::{Finding, Severity};
use crate::flight::six_dof::aerodynamics::OfOutline;
use crate::library::{Library, named};
use crate::vehicle::body::RigidBody;
use numerics::math::RADIANS_PER_DEGREE;

/// The database of the outline of a case; with axial force by name where one is named, else by the angle of the cone.
pub(super) fn database(
    reader: &mut Reader,
    library: &Library,
    outline: &Outline,
) -> Option<OfOutline> {
    let Outline::Body(body) = outline else {
        if *outline == Outline::Absent {
            reader.fault("vehicle.aerodynamics", "has axial force alone; with vehicle.dof = 6 give an [outline] from which the rest is computed, or constants in [vehicle.aerodynamics]");
        }
        return None;
    };
    let force = if reader.given("vehicle.aerodynamics") {
        let names: Vec<&str> = library
            .aerodynamics
            .iter()
            .map(|(name, _)| name.as_str())
            .collect();
        let name = reader.choice("vehicle.aerodynamics", &names)?;
        named(&library.aerodynamics, name)
    } else {
        nearest(library, body)
    }?;
    reader.findings.push(Finding {
        severity: Severity::Note,
        model: "aerodynamics".to_string(),
        key: "vehicle.aerodynamics".to_string(),
        value: None,
        valid: (None, None),
        message: format!("Coefficients are computed from the outline, axial force nose first from \"{}\"; pitch damping between Mach 0.5 and free-molecular flow is a placeholder.", force.title),
        source: "NASA/TM-2014-218507, section 3.3".to_string(),
        field: Some("vehicle.aerodynamics".to_string()),
    });
    let options = Options {
        axial_force: force.table.clone(),
        bridging: Bridging::SineSquared,
        wall_temperature_ratio: 1.0,
        accommodation: [1.0, 1.0],
        damping: Damping::Report {
            data: library.aero_models.damping.clone(),
            reading: Reading::Corrected,
        },
    };
    Some(OfOutline {
        database: Database::of_outline(&body.outline, body.diameter_m, options),
        axial_force: force.table.clone(),
    })
}

/// The axial force whose cone is nearest to that of a body; of 60 deg where it has none.
fn nearest<'l>(library: &'l Library, body: &RigidBody) -> Option<&'l AxialForce> {
    let degrees = body
        .cone_half_angle_rad
        .map_or(60.0, |angle| angle / RADIANS_PER_DEGREE);
    let distance = |force: &AxialForce| (force.cone_half_angle_deg - degrees).abs();
    let forces = library.aerodynamics.iter().map(|(_, force)| force);
    forces.min_by(|a, b| distance(a).total_cmp(&distance(b)))
}
