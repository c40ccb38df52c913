//! Peak temperature of the payload container, hours after landing.
//!
//! ```text
//! X = d q̇^e HL^f D^g
//! T = a X² + b X + c,   X no smaller than −b/(2a)
//! ```
//!
//! with q̇ the peak stagnation heat flux in W/cm², HL the stagnation heat load in J/cm², D the diameter in m, T in °C
//! (arguments and result converted).
//!
//! The form is **deduced**: the equation is missing from the available copy of the report, its coefficients are there
//! (Tables 12 and 13). Of 60 candidates it is the only one that reproduces every temperature stated in the text.
//! Below its vertex the parabola would rise again: X is held there.
//!
//! # Valid
//! 100 to 1500 W/cm², 3000 to 38000 J/cm², 0.8 to 1.4 m; start at 17 °C; no ablation, no crushed foam. One vehicle of the
//! MSR concept, 1.05 m across with 4.02 cm of forebody heat shield (Table 9), scaled as a whole: the correlation is
//! for a thickness of 3.83 % of the diameter. The report does not say whether its fluxes carry margins: with margins the result is
//! conservative, and the callers pass cold-wall values with margins.
//!
//! # References
//! - \[samareh-2014\] section 3.6.4, Tables 9, 12 and 13; limitation 1 of section 3.6.5.

use crate::data::Data;
use crate::finding::range::{Check, Range, short};
use crate::finding::{Finding, Severity};
use crate::heating::PER_CM2;
use crate::quantity::input;
use crate::vehicle::Concept;
use numerics::scalar::Single;
use serde::{Deserialize, Serialize};

const MODEL: &str = "soak correlation";
const KEY: &str = "max_payload_temperature_k";

/// Kelvin at 0 °C.
const ZERO_CELSIUS_K: f64 = 273.15;

/// The correlation of a heat-shield material, as in its file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SoakCorrelation {
    /// Key of the reference.
    pub source: String,
    /// Place in the source.
    pub place: String,
    /// Method by which the form was found.
    pub note: String,
    /// Facts that were read from the source, and those deduced.
    pub provenance: String,
    a: f64,
    b: f64,
    c: f64,
    d: f64,
    e: f64,
    f: f64,
    g: f64,
    valid: Valid,
    fitted: Fitted,
}

/// The vehicle behind a correlation.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Fitted {
    place: String,
    note: String,
    concept: Concept,
    diameter_m: f64,
    forebody_tps_thickness_m: f64,
    thickness_tolerance_percent: f64,
}

impl Fitted {
    /// Thickness of the forebody's heat shield when the vehicle is scaled to a diameter, m.
    fn thickness_m(&self, diameter_m: f64) -> f64 {
        self.forebody_tps_thickness_m * diameter_m / self.diameter_m
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Valid {
    heat_flux_w_cm2: Range,
    heat_load_j_cm2: Range,
    diameter_m: Range,
}

/// Inputs of the correlation.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct SoakInput<S = f64> {
    /// Peak stagnation heat flux, cold wall, with margins, W/m².
    pub peak_heat_flux_w_m2: S,
    /// Stagnation heat load, cold wall, with margins, J/m².
    pub heat_load_j_m2: S,
    /// Vehicle diameter, m.
    pub diameter_m: S,
    /// Concept of the vehicle.
    pub concept: Concept,
    /// Thickness of the forebody's heat shield, m.
    pub forebody_tps_thickness_m: S,
}

impl SoakCorrelation {
    /// Reads a correlation from the text of its file.
    pub fn parse(data: Data) -> Result<Self, String> {
        let correlation: Self = data.read()?;
        if correlation.a > 0.0 {
            Ok(correlation)
        } else {
            Err(format!("a: got {}, must be above 0", correlation.a))
        }
    }

    /// Peak temperature of the payload container, K.
    pub fn peak_temperature_k<S: Single>(&self, input: &SoakInput<S>) -> S {
        let Self { a, b, c, .. } = *self;
        // below the vertex the parabola would rise again
        // in this order, so that no flux at all, whose powers are not numbers, stands at the vertex, too
        let x = S::constant(self.vertex()).max(self.x(input));
        // T = a X² + b X + c
        (x * a + b) * x + c + ZERO_CELSIUS_K
    }

    fn x<S: Single>(&self, input: &SoakInput<S>) -> S {
        let Self { d, e, f, g, .. } = *self;
        let (q, hl) = (
            input.peak_heat_flux_w_m2 / PER_CM2,
            input.heat_load_j_m2 / PER_CM2,
        );
        // X = d q̇^e HL^f D^g
        let [e, f, g] = [e, f, g].map(S::constant);
        q.pow(e) * d * hl.pow(f) * input.diameter_m.pow(g)
    }

    fn vertex(&self) -> f64 {
        -self.b / (2.0 * self.a)
    }

    /// Findings: that the form is deduced, and where the correlation is used beyond its data.
    pub fn findings(&self, input: &SoakInput) -> Vec<Finding> {
        const SOURCE: &str = "NASA/TM-2014-218507, section 3.6";
        let temperature = Some(self.peak_temperature_k(input));
        let note = |message: &str| Finding {
            severity: Severity::Note,
            model: MODEL.into(),
            key: KEY.into(),
            value: temperature,
            valid: (None, None),
            message: message.into(),
            source: "NASA/TM-2014-218507, Tables 12 and 13".into(),
            field: None,
        };
        let mut findings = vec![note(
            "The form of the soak correlation is deduced: the report prints its coefficients, its equation is missing.",
        )];
        if self.x(input) < self.vertex() {
            findings.push(note("Heating is so mild that the correlation would turn up: its least temperature is given."));
        }
        let load = Check {
            severity: Severity::Extrapolated,
            model: MODEL,
            key: "total_margined_heat_load_j_m2",
            quantity: "Heat load",
            value: input.heat_load_j_m2 / PER_CM2,
            range: self.valid.heat_load_j_cm2,
            unit: "J/cm²",
            si_per_unit: PER_CM2,
            meaning: "the soak correlation was not fitted there",
            source: SOURCE,
            field: Some(input::entry::FLIGHT_PATH_ANGLE_DEG.key),
        };
        let flux = Check {
            key: "peak_total_margined_heat_flux_w_m2",
            quantity: "Peak heat flux",
            value: input.peak_heat_flux_w_m2 / PER_CM2,
            range: self.valid.heat_flux_w_cm2,
            unit: "W/cm²",
            ..load
        };
        let diameter = Check {
            key: "diameter_m",
            quantity: "Diameter",
            value: input.diameter_m,
            range: self.valid.diameter_m,
            unit: "m",
            si_per_unit: 1.0,
            field: Some(input::design::DIAMETER_M.key),
            ..load
        };
        let tolerance = self.fitted.thickness_tolerance_percent / 100.0;
        let thickness_cm = 100.0 * self.fitted.thickness_m(input.diameter_m);
        let meaning = format!(
            "the correlation is of one vehicle with {} cm at {} m, scaled with the diameter, and does not know the thickness",
            short(100.0 * self.fitted.forebody_tps_thickness_m),
            short(self.fitted.diameter_m),
        );
        let thickness = Check {
            key: "forebody_tps_thickness_m",
            quantity: "Forebody heat-shield thickness",
            value: 100.0 * input.forebody_tps_thickness_m,
            range: Range {
                min: Some(thickness_cm * (1.0 - tolerance)),
                max: Some(thickness_cm * (1.0 + tolerance)),
            },
            unit: "cm",
            si_per_unit: 0.01,
            meaning: &meaning,
            source: "NASA/TM-2014-218507, Table 9 and section 3.6.5",
            field: None,
            ..load
        };
        findings.extend(
            [flux, load, diameter, thickness]
                .iter()
                .filter_map(Check::finding),
        );
        findings.extend(self.other_concept(input, temperature));
        findings
    }

    /// A vehicle of another concept than the one behind the correlation.
    fn other_concept(&self, input: &SoakInput, temperature_k: Option<f64>) -> Option<Finding> {
        (input.concept != self.fitted.concept).then(|| Finding {
            severity: Severity::Extrapolated,
            model: MODEL.into(),
            key: KEY.into(),
            value: temperature_k,
            valid: (None, None),
            message: format!(
                "The soak correlation is of a vehicle of the {} concept, this one is of the {} concept: payload, foam and \
                 heat paths differ.",
                self.fitted.concept.label(),
                input.concept.label()
            ),
            source: "NASA/TM-2014-218507, section 3.6.1 and Table 9".into(),
            field: Some(input::design::MSR_MODE.key.into()),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pica() -> SoakCorrelation {
        SoakCorrelation::parse(include_str!("../data/soak/pica.toml").into()).unwrap()
    }

    fn carbon_phenolic() -> SoakCorrelation {
        SoakCorrelation::parse(include_str!("../data/soak/carbon-phenolic.toml").into()).unwrap()
    }

    fn input(q_w_cm2: f64, hl_j_cm2: f64, diameter_m: f64) -> SoakInput {
        SoakInput {
            peak_heat_flux_w_m2: q_w_cm2 * 1e4,
            heat_load_j_m2: hl_j_cm2 * 1e4,
            diameter_m,
            concept: Concept::Msr,
            forebody_tps_thickness_m: 0.0402 * diameter_m / 1.05,
        }
    }

    #[test]
    fn both_trajectories_of_section_3_6_give_the_independently_computed_temperatures() {
        // three printed decimals
        let cases = [
            (pica(), 692.0, 3000.0, 18.835),
            (pica(), 1000.0, 38000.0, 28.296),
            (carbon_phenolic(), 692.0, 3000.0, 24.663),
            (carbon_phenolic(), 1000.0, 38000.0, 53.807),
        ];
        for (model, q, hl, celsius) in cases {
            let ours = model.peak_temperature_k(&input(q, hl, 1.05)) - 273.15;
            assert!(
                (ours - celsius).abs() < 5.1e-4,
                "{q} {hl}: {ours} against {celsius}"
            );
        }
    }

    #[test]
    fn temperatures_stated_in_the_text_are_met() {
        // PICA stays below 30 °C; carbon phenolic below 25 °C at 3000 J/cm² and beyond 50 °C at 38000 J/cm²
        let celsius =
            |model: SoakCorrelation, q, hl| model.peak_temperature_k(&input(q, hl, 1.05)) - 273.15;
        assert!(celsius(pica(), 1000.0, 38000.0) < 30.0);
        assert!(celsius(carbon_phenolic(), 692.0, 3000.0) < 25.0);
        assert!(celsius(carbon_phenolic(), 1000.0, 38000.0) > 50.0);
    }

    #[test]
    fn below_its_vertex_pica_is_held_at_18_49_degrees() {
        // c − b²/(4a) = 44.0988662 − 9.471745/0.3698164 = 18.4869 °C
        let mild = input(1500.0, 200.0, 1.4);
        assert!((pica().peak_temperature_k(&mild) - 273.15 - 18.4869).abs() < 1e-3);
        assert!(
            pica()
                .findings(&mild)
                .iter()
                .any(|finding| finding.message.contains("least temperature"))
        );
    }

    #[test]
    fn without_any_flux_it_stands_at_its_vertex() {
        // e is negative for both: 0^e is infinite, and infinite times 0^f is not a number
        for model in [pica(), carbon_phenolic()] {
            let SoakCorrelation { a, b, c, .. } = model;
            assert!(model.x(&input(0.0, 0.0, 1.05)).is_nan());
            let celsius = model.peak_temperature_k(&input(0.0, 0.0, 1.05)) - ZERO_CELSIUS_K;
            assert!(
                (celsius - (c - b * b / (4.0 * a))).abs() < 1e-9,
                "{celsius}"
            );
        }
    }

    #[test]
    fn smaller_vehicles_are_hotter_inside() {
        let [small, large] =
            [0.9, 1.2].map(|d| carbon_phenolic().peak_temperature_k(&input(1000.0, 20000.0, d)));
        assert!(small > large);
    }

    #[test]
    fn deduction_is_always_said_and_each_range_when_left() {
        assert_eq!(pica().findings(&input(1000.0, 20000.0, 1.0)).len(), 1);
        let findings = pica().findings(&input(1600.0, 40000.0, 1.5));
        assert_eq!(findings.len(), 4);
        assert!(findings[0].message.contains("deduced"));
    }

    #[test]
    fn another_concept_and_another_thickness_are_said() {
        let table_9 = input(1000.0, 20000.0, 1.05);
        let keys = |input: SoakInput| -> Vec<String> {
            let findings = pica().findings(&input).into_iter().skip(1);
            findings.map(|finding| finding.key).collect()
        };
        assert!(keys(table_9).is_empty());
        let other = SoakInput {
            concept: Concept::NonMsr,
            ..table_9
        };
        assert_eq!(keys(other), ["max_payload_temperature_k"]);
        // 6.3 % of 4.02 cm is 0.253 cm; at 0.9 m the scaled model has 4.02 × 0.9 / 1.05 = 3.446 cm
        for (diameter_m, thickness_cm, silent) in [
            (1.05, 4.27, true),
            (1.05, 4.28, false),
            (1.05, 3.76, false),
            (0.9, 3.446, true),
            (0.9, 4.02, false),
        ] {
            let other = SoakInput {
                forebody_tps_thickness_m: thickness_cm / 100.0,
                ..input(1000.0, 20000.0, diameter_m)
            };
            let keys = keys(other);
            assert_eq!(keys.is_empty(), silent, "{diameter_m} m, {thickness_cm} cm");
            assert!(keys.iter().all(|key| key == "forebody_tps_thickness_m"));
        }
    }
}
