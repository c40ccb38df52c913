//! Largest heat flux on the shoulder over that at the stagnation point.
//!
//! ```text
//! q̇ₛ/q̇₀ = C (Rₛ/R_b)^m
//! ```
//!
//! with C = 1.08, m = −0.073, Rₛ shoulder and R_b vehicle radius.
//!
//! This replaces the report's power law, which is printed only as Figure 42 and is not readable: it was fitted for this
//! project to wind-tunnel ratios of blunt spherical segments (the points are in the data file).
//!
//! # Valid
//! Rₛ/R_b 0.05 to 0.25, zero angle of attack, Mach about 10. The report's own study covers 0.052 to 0.11.
//!
//! # References
//! - \[samareh-2014\] section 3.4.3; \[marvin-sinclair-1967\].

use crate::data::Data;
use crate::finding::range::{Check, Range};
use crate::finding::{Finding, Severity};
use crate::quantity::input;
use numerics::scalar::Single;
use serde::Deserialize;

/// The power law, from `heating/shoulder.toml`.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Shoulder {
    /// Key of the reference.
    pub source: String,
    /// Place in it.
    pub place: String,
    /// Note on the published law that this one replaces.
    pub note: String,
    /// Origin of the fit.
    pub provenance: String,
    c: f64,
    m: f64,
    /// The points behind it: Rₛ/R_b and ratio.
    pub points: Vec<[f64; 2]>,
    valid: Valid,
}

#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct Valid {
    shoulder_radius_ratio: Range,
}

impl Shoulder {
    /// Reads the law from the text of `heating/shoulder.toml`.
    pub fn parse(data: Data) -> Result<Self, String> {
        data.read()
    }

    /// Heat flux on the shoulder over that at the stagnation point.
    pub fn ratio<S: Single>(&self, shoulder_radius_ratio: S) -> S {
        // q̇ₛ/q̇₀ = C (Rₛ/R_b)^m
        shoulder_radius_ratio.pow(S::constant(self.m)) * self.c
    }

    /// Findings: origin of the law, and use outside its points.
    pub fn findings(&self, shoulder_radius_ratio: f64) -> Vec<Finding> {
        let source =
            "Marvin & Sinclair 1967, as tabulated in later literature; fitted for this project";
        let key = "shoulder_to_stagnation_heat_flux_ratio";
        let Range { min, max } = self.valid.shoulder_radius_ratio;
        let origin = Finding {
            severity: Severity::Note,
            model: "shoulder factor".into(),
            key: key.into(),
            value: Some(self.ratio(shoulder_radius_ratio)),
            valid: (None, None),
            message: "Shoulder heating is a substitute: the report's power law (Figure 42) is not readable, and this one \
                      is fitted to wind-tunnel ratios of spherical segments."
                .into(),
            source: source.into(),
            field: None,
        };
        let outside = Check {
            severity: Severity::Extrapolated,
            model: "shoulder factor",
            key: input::design::SHOULDER_RADIUS_RATIO.key,
            quantity: "Shoulder radius over vehicle radius",
            value: shoulder_radius_ratio,
            range: Range { min, max },
            unit: "",
            si_per_unit: 1.0,
            meaning: "the power law is used beyond its points",
            source,
            field: Some(input::design::SHOULDER_RADIUS_RATIO.key),
        };
        core::iter::once(origin).chain(outside.finding()).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn law() -> Shoulder {
        Shoulder::parse(include_str!("../../data/heating/shoulder.toml").into()).unwrap()
    }

    #[test]
    fn law_passes_its_end_points_within_half_a_percent_and_the_middle_within_four() {
        // 1.08 × 0.05^−0.073 = 1.344 (1.35), 0.15: 1.240 (1.28), 0.25: 1.195 (1.20)
        let misses: Vec<f64> = law()
            .points
            .iter()
            .map(|&[x, y]| (law().ratio(x) / y - 1.0).abs())
            .collect();
        assert!(
            misses[0] < 5e-3 && misses[1] < 4e-2 && misses[2] < 5e-3,
            "{misses:?}"
        );
    }

    #[test]
    fn origin_is_always_said_and_the_range_when_left() {
        assert_eq!(law().findings(0.07).len(), 1);
        assert_eq!(law().findings(0.02).len(), 2);
    }
}
