//! Findings about coefficients: which part is measured, computed or assumed.
//!
//! ```text
//! one finding a regime, one for damping, one for what lies beyond a table
//! ```
//!
//! # Valid
//! Findings name the origin of numbers; they change none.
//!
//! # References
//! - \[samareh-2014\] sections 3.3.1 and 3.3.7.

use super::{Polar, Theory};
use crate::aero::damping::Damping;
use crate::aero::database::{Database, Regime};
use crate::finding::{Finding, Severity};
use crate::quantity::input;
use numerics::math::RADIANS_PER_DEGREE;

fn note(message: String, source: &str, field: Option<&str>) -> Finding {
    Finding {
        severity: Severity::Note,
        model: "aerodynamics".to_string(),
        key: String::new(),
        value: None,
        valid: (None, None),
        message,
        source: source.to_string(),
        field: field.map(str::to_string),
    }
}

/// Findings beside a polar.
pub fn remarks(polar: &Polar, theory: &Theory, database: &Database) -> Vec<Finding> {
    let Theory::Blended { mach, knudsen } = *theory else {
        return Vec::new();
    };
    let mut findings = Vec::new();
    let mut regimes: Vec<Regime> = polar
        .rows
        .iter()
        .map(|row| {
            database
                .coefficients(mach, knudsen, row.alpha_deg * RADIANS_PER_DEGREE)
                .regime
        })
        .collect();
    regimes.sort_unstable();
    regimes.dedup();
    for regime in regimes {
        let message = format!(
            "Static coefficients, {}: {}.",
            regime.name(),
            regime.provenance()
        );
        findings.push(note(message, "NASA/TM-2014-218507, section 3.3", None));
    }
    if let Some(grid) = database.table() {
        for row in &polar.rows {
            let alpha = (row.alpha_deg * RADIANS_PER_DEGREE).abs();
            for message in grid.beyond(mach, knudsen, alpha) {
                let mut finding = note(
                    format!("Beyond the table: {message}."),
                    "the table of the case",
                    Some(input::vehicle::AERODYNAMICS_EXTRAPOLATION.key),
                );
                finding.severity = Severity::Extrapolated;
                if !findings.contains(&finding) {
                    findings.push(finding);
                }
            }
        }
    } else if polar.rows.iter().any(|row| row.alpha_deg.abs() > 90.0) && knudsen < 10.0 {
        let message = "Backward flight in a continuum is impact theory with an assumed base pressure; flow about a body that flies backwards is unsteady.";
        let mut finding = note(
            message.to_string(),
            "NASA/TM-2014-218507, section 3.3.2",
            None,
        );
        finding.severity = Severity::Extrapolated;
        findings.push(finding);
    }
    if let Damping::Report { data, .. } = database.damping()
        && data.blend(mach) > 0.0
    {
        let message = format!(
            "Pitch damping above Mach 0.5 is a placeholder, assumed. {}",
            data.placeholder_note()
        );
        findings.push(note(
            message,
            "assumed",
            Some(input::vehicle::AERODYNAMICS_DAMPING_TABLE.key),
        ));
    }
    findings
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn impact_theory_by_itself_needs_no_remark() {
        let polar = Polar {
            rows: Vec::new(),
            trim: Vec::new(),
            pressure_center: None,
            static_margin: None,
        };
        let grid = crate::aero::table::Grid::try_new(
            &[crate::aero::table::Row {
                ca: Some(1.0),
                cn: Some(0.0),
                ..Default::default()
            }],
            Default::default(),
        );
        let database = Database::of_table(grid.unwrap(), 1.0, Damping::Absent);
        assert!(remarks(&polar, &Theory::newtonian(None, 1.4), &database).is_empty());
    }
}
