//! Findings about the attitude.
//!
//! ```text
//! α beyond the range of constants;  heating with the nose away from the air;  damping that is assumed
//! ```
//!
//! with α the total angle of attack, rad.
//!
//! # Valid
//! Flights in six degrees of freedom.
//!
//! # References
//! - \[samareh-2014\] sections 3.3.2 and 3.3.7.

use super::aerodynamics::Aerodynamics;
use super::events::AttitudeEvents;
use super::rigid::Rigid;
use crate::aero::damping;
use crate::finding::{Finding, Severity};
use crate::quantity::input;
use numerics::math::RADIANS_PER_DEGREE;

/// Largest angle at which slopes at zero represent the coefficients, deg.
const LINEAR_DEG: f64 = 30.0;
/// Angle at peak heating beyond which the stagnation point is not on the nose, deg.
const NOSE_FORWARD_DEG: f64 = 30.0;

/// Remarks on a flight.
pub fn findings(rigid: &Rigid, attitude: &AttitudeEvents) -> Vec<Finding> {
    let mut findings = Vec::new();
    let largest_deg = attitude.maximum_total_alpha.angle_rad / RADIANS_PER_DEGREE;
    if let Aerodynamics::Constants(_) = rigid.aerodynamics
        && largest_deg > LINEAR_DEG
    {
        findings.push(Finding {
            severity: Severity::Extrapolated,
            model: "aerodynamic constants".to_string(),
            key: "maximum_total_alpha_deg".to_string(),
            value: Some(largest_deg),
            valid: (Some(0.0), Some(LINEAR_DEG)),
            message: format!("The total angle of attack reaches {largest_deg:.1} deg; constants are slopes at zero and are used beyond {LINEAR_DEG} deg. An outline gives coefficients at every angle."),
            source: "convention of this program".to_string(),
            field: Some(input::vehicle::AERODYNAMICS_CA.to_string()),
        });
    }
    if let Aerodynamics::Database(of) = &rigid.aerodynamics
        && let damping::Damping::Report { data, .. } = of.database.damping()
    {
        findings.push(Finding {
            severity: Severity::Note,
            model: "pitch damping".to_string(),
            key: "maximum_total_alpha_after_peak_heating_deg".to_string(),
            value: None,
            valid: (None, None),
            message: format!(
                "Pitch damping above Mach 0.5 is a placeholder, assumed. {}",
                data.placeholder_note()
            ),
            source: "assumed".to_string(),
            field: Some(input::vehicle::AERODYNAMICS_DAMPING_TABLE.to_string()),
        });
    }
    let heated_deg = attitude.total_alpha_at_peak_heating_rad / RADIANS_PER_DEGREE;
    if heated_deg > NOSE_FORWARD_DEG {
        findings.push(Finding {
            severity: Severity::Extrapolated,
            model: "stagnation heating".to_string(),
            key: "total_alpha_at_peak_heating_deg".to_string(),
            value: Some(heated_deg),
            valid: (Some(0.0), Some(NOSE_FORWARD_DEG)),
            message: format!("At the largest heat rate the total angle of attack is {heated_deg:.1} deg; heating is computed for the nose forward."),
            source: "NASA/TM-2014-218507, section 3.4".to_string(),
            field: None,
        });
    }
    findings
}
