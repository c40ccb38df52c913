//! Static stability of a designed vehicle: static margin and trims of its outline about its center of gravity.
//!
//! ```text
//! nose first: margin > 0;   another stable trim: the vehicle may stay there
//! ```
//!
//! with the margin in diameters. The numbers are those of [`crate::aero::stability`].
//!
//! # Valid
//! Static stability. Whether a vehicle gets into a trim depends on attitude and rates at entry: the flights of
//! [`turning`](crate::flight::six_dof::turning) try nine.
//!
//! # References
//! - \[samareh-2014\] summary, sections 3.1.2 and 3.3.2.

use crate::aero::stability::{RegimeStability, Stability};
use crate::aero::standard::AeroBody;
use crate::finding::{Finding, Severity};
use crate::vehicle::Vehicle;

const REPORT: &str = "NASA/TM-2014-218507, section 3.3.2";

/// Stability of a vehicle in a gas of a ratio of heat capacities.
pub fn of_vehicle(vehicle: &Vehicle, heat_capacity_ratio: f64) -> Option<Stability> {
    Stability::new(&AeroBody::of_vehicle("", vehicle), heat_capacity_ratio)
}

/// Findings on margins and trims, on a vehicle that is unstable nose first, and on one with another stable trim.
pub fn findings(stability: &Stability) -> Vec<Finding> {
    let regimes = [
        (
            "free_molecular",
            "free-molecular",
            &stability.free_molecular,
        ),
        ("hypersonic", "hypersonic", &stability.hypersonic),
    ];
    let mut findings = vec![summary(&regimes.map(|(_, name, regime)| (name, regime)))];
    for (key, name, regime) in regimes {
        findings.extend(unstable(key, name, regime));
        findings.extend(other_trim(key, name, regime));
    }
    findings
}

fn finding(severity: Severity, key: String, value: Option<f64>, message: String) -> Finding {
    Finding {
        severity,
        model: "static stability".to_string(),
        key,
        value,
        valid: (Some(0.0), None),
        message,
        source: REPORT.to_string(),
        field: None,
    }
}

fn summary(regimes: &[(&str, &RegimeStability)]) -> Finding {
    let of = |(name, regime): &(&str, &RegimeStability)| {
        let margin = regime.static_margin.map_or_else(
            || "no static margin".to_string(),
            |margin| format!("static margin {margin:.3} D"),
        );
        format!("{name} flow: {margin}, trims at {}", regime.words())
    };
    let words: Vec<String> = regimes.iter().map(of).collect();
    let message = format!("About its own center of gravity, {}.", words.join("; "));
    let mut note = finding(Severity::Note, String::new(), None, message);
    note.valid = (None, None);
    note
}

fn unstable(key: &str, name: &str, regime: &RegimeStability) -> Option<Finding> {
    let margin = regime.static_margin.filter(|margin| *margin <= 0.0)?;
    Some(finding(
        Severity::Exceeded,
        format!("{key}_static_margin"),
        Some(margin),
        format!(
            "In {name} flow the vehicle turns away from nose first: its center of gravity is {:.3} D behind the center of pressure.",
            -margin
        ),
    ))
}

fn other_trim(key: &str, name: &str, regime: &RegimeStability) -> Option<Finding> {
    let trim = regime.other_trim()?;
    let from = regime.turning_point().map_or_else(String::new, |point| {
        format!(
            " Beyond {:.1} deg the moment turns it there.",
            point.alpha_deg
        )
    });
    let mut found = finding(
        Severity::Extrapolated,
        format!("{key}_stable_trim_deg"),
        Some(trim.alpha_deg),
        format!(
            "In {name} flow the vehicle also trims at {:.1} deg, not nose first: an entry may stay there, and drag, heating and heat shield are computed for the nose forward.{from} Entries from a set of attitudes and rates show whether it turns round.",
            trim.alpha_deg
        ),
    );
    found.valid = (Some(0.0), Some(0.0));
    Some(found)
}

#[cfg(test)]
mod tests {
    use crate::{Case, Library, Request, design, library};

    /// Angle of the stable trim that is not nose first, and messages of the model.
    fn said(name: &str, panels_kg_m3: &str) -> (Option<f64>, Vec<String>) {
        let mut case = Case::from_text(library::data_file(name).unwrap()).unwrap();
        case.set("design.density_kg_m3.impact_panels", panels_kg_m3);
        let answer = design(&case, &Library::builtin().unwrap(), Request::Nothing).unwrap();
        let stability = answer.design.unwrap().stability.unwrap();
        assert!(stability.free_molecular.other_trim().is_none());
        let messages = answer.findings.into_iter();
        let messages = messages.filter(|f| f.model == "static stability");
        let angle = stability.hypersonic.other_trim().map(|t| t.alpha_deg);
        (angle, messages.map(|f| f.message).collect())
    }

    #[test]
    fn a_vehicle_with_a_backward_trim_says_so_and_one_without_does_not() {
        // An independent search with panels found 148 deg for the carbon-phenolic vehicle and 143 deg for the run page's, both
        // about as large as with the panels of version 0.1.
        for (name, about_deg) in [
            ("cases/msr-eev-cp.toml", 148.0),
            ("cases/run-page.toml", 143.0),
        ] {
            let (angle, messages) = said(name, "236");
            let angle = angle.unwrap();
            assert!((angle - about_deg).abs() < 2.0, "{name}: {angle}");
            assert!(
                messages[0].contains("static margin 0.")
                    && messages[0].contains("180 deg (unstable)")
            );
            assert!(messages[1].contains(&format!("also trims at {angle:.1} deg, not nose first")));
            assert_eq!(messages.len(), 2);
        }
        let (angle, messages) = said("cases/galahad.toml", "35");
        assert_eq!((angle, messages.len()), (None, 1), "{messages:?}");
    }
}
