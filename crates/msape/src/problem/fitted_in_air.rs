//! The finding on an axial force that was fitted in air and is used in another gas.

use crate::aero::database::GAMMA;
use crate::case::Reader;
use crate::finding::range::short;
use crate::finding::{Finding, Severity};
use crate::quantity::input;

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
