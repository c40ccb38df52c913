//! Findings on results of higher fidelity that the user [gives](super::inputs::Given) in the place of a model of the coupling.
//!
//! ```text
//! t = t_given      T = T_given      m = m_given
//! ```
//!
//! with thicknesses t in m, the payload's temperature T in K and masses m of components in kg, before the margin.
//!
//! # Valid
//! A given result is used; that of the model it replaces is reported with it. A component of given mass keeps the shape that the
//! rules give it.
//!
//! # References
//! - \[samareh-2014\] section 1: hooks to higher fidelity.

use super::inputs::DesignInput;
use super::sized::Sized;
use crate::finding::range::short;
use crate::finding::{Finding, Severity};
use crate::heating::given::USERS;
use crate::quantity::input;
use crate::tps::Side;
use crate::tps::mer::Sizing;
use crate::vehicle::Vehicle;

/// Remarks on all that is given.
pub(super) fn findings(input: &DesignInput, vehicle: &Vehicle, sized: &Sized) -> Vec<Finding> {
    let given = &input.given;
    let mut findings: Vec<Finding> = [
        (Side::Forebody, given.forebody_tps_m, &sized.forebody),
        (Side::Aftbody, given.aftbody_tps_m, &sized.aftbody),
    ]
    .into_iter()
    .filter_map(|(side, given_m, sizing)| Some(of_thickness(side, given_m?, sizing)))
    .collect();
    findings.extend(given.payload_temperature_k.map(|kelvin| {
        let correlation = short(input.soak.peak_temperature_k(&sized.soak));
        note(
            "payload_temperature_k",
            input::design::PAYLOAD_TEMPERATURE_K.key,
            kelvin,
            format!(
                "The payload's peak temperature is {USERS}, {} K; the soak correlation would say {correlation} K.",
                short(kelvin)
            ),
        )
    }));
    findings.extend(input.vehicle.given_masses.iter().map(|(kind, mass_kg)| {
        let label = kind.label();
        let field = kind.mass_input().map_or("", |input| input.key);
        let key = format!("{}_mass_kg", kind.key());
        match vehicle.component(*kind).filter(|part| part.volume_m3 > 0.0) {
            Some(part) => note(
                &key,
                field,
                *mass_kg,
                format!(
                    "{label}: the mass is {USERS}, {} kg before the margin, over the volume that the rules give it: {} kg/m³.",
                    short(*mass_kg),
                    short(part.density_kg_m3)
                ),
            ),
            None => Finding {
                severity: Severity::Exceeded,
                ..note(
                    &key,
                    field,
                    *mass_kg,
                    format!(
                        "{label}: this vehicle has none, so that the mass {USERS}, {} kg, is not in it.",
                        short(*mass_kg)
                    ),
                )
            },
        }
    }));
    findings
}

fn of_thickness(side: Side, given_m: f64, sizing: &Sizing) -> Finding {
    let name = side.name();
    let asked_m = sizing.asked_m;
    let [given_cm, asked_cm] = [given_m, asked_m].map(|m| short(100.0 * m));
    let key = format!("{name}_tps_thickness_m");
    let field = match side {
        Side::Forebody => input::design::FOREBODY_TPS_THICKNESS_M.key,
        Side::Aftbody => input::design::AFTBODY_TPS_THICKNESS_M.key,
    };
    let told = format!(
        "The {name}'s heat shield is {USERS} as {given_cm} cm thick; its mass-estimating relation asks for {asked_cm} cm"
    );
    let finding = note(&key, field, given_m, format!("{told}."));
    match given_m < asked_m {
        true => Finding {
            severity: Severity::Exceeded,
            valid: (Some(asked_m), None),
            message: format!("{told}, more than is given."),
            ..finding
        },
        false => finding,
    }
}

fn note(key: &str, field: &str, value: f64, message: String) -> Finding {
    Finding {
        severity: Severity::Note,
        model: "given".into(),
        key: key.into(),
        value: Some(value),
        valid: (None, None),
        message,
        source: USERS.into(),
        field: Some(field.into()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vehicle::ComponentKind;
    use crate::{Answer, Case, Library, Outcome, Request, design};

    fn solved(changes: &[(&str, &str)]) -> Answer {
        let text = crate::library::data_file("cases/msr-eev-pica.toml").unwrap();
        let mut case = Case::from_text(text).unwrap();
        for (key, value) in changes {
            case.set(key, value);
        }
        let library = Library::builtin().unwrap();
        let answer = design(&case, &library, Request::Nothing).unwrap();
        assert_eq!(answer.outcome, Outcome::Converged);
        answer
    }

    fn said<'a>(answer: &'a Answer, key: &str) -> &'a Finding {
        let mut findings = answer.findings.iter();
        findings
            .find(|finding| finding.source == USERS && finding.key == key)
            .unwrap()
    }

    #[test]
    fn a_thickness_that_is_given_is_used_and_judged_by_the_relation() {
        let answer = solved(&[
            ("design.forebody_tps_thickness_m", "3 cm"),
            ("design.aftbody_tps_thickness_m", "0.03"),
        ]);
        let design = answer.design.as_ref().unwrap();
        let depths = design.vehicle.layout.depths;
        assert_eq!((depths.forebody_tps_m, depths.aftbody_tps_m), (0.03, 0.03));
        // Table 7 requires about 4.5 cm of PICA here: both numbers are reported
        let asked_m = design.forebody_tps.asked_m;
        assert!(asked_m > 0.04 && asked_m < 0.05, "{asked_m}");
        let thin = said(&answer, "forebody_tps_thickness_m");
        assert_eq!(thin.severity, Severity::Exceeded);
        assert_eq!(thin.valid, (Some(asked_m), None));
        let both = thin.message.contains("as 3 cm") && thin.message.contains("more than is given");
        assert!(both, "{}", thin.message);
        let thick = said(&answer, "aftbody_tps_thickness_m");
        assert_eq!(thick.severity, Severity::Note);
    }

    #[test]
    fn masses_that_are_given_stand_in_the_tree_with_the_margin_of_the_others() {
        let changes = [
            ("design.component_mass_kg.body_foam", "2"),
            ("design.component_mass_kg.lid_insulation", "0"),
            ("design.payload_temperature_k", "300"),
        ];
        let answer = solved(&changes);
        let design = answer.design.as_ref().unwrap();
        let vehicle = &design.vehicle;
        let foam = vehicle.component(ComponentKind::BodyFoam).unwrap();
        // 2 kg and 30 % of margin
        assert!((foam.mass_kg - 2.0).abs() < 1e-12);
        assert!((foam.mass_with_margin_kg - 2.6).abs() < 1e-12);
        assert_eq!(foam.density_basis.name(), "given");
        assert_eq!(vehicle.component_mass_kg(ComponentKind::LidInsulation), 0.0);
        let sum: f64 = vehicle
            .components
            .iter()
            .map(|c| c.mass_with_margin_kg)
            .sum();
        assert!((sum - vehicle.mass.mass_kg).abs() < 1e-9);
        assert_eq!(design.payload_temperature_k, 300.0);
        assert!(
            said(&answer, "payload_temperature_k")
                .message
                .contains("300 K")
        );
        let no_soak = answer
            .findings
            .iter()
            .all(|finding| finding.model != "soak correlation");
        assert!(no_soak);
    }

    #[test]
    fn a_mass_of_what_is_not_there_is_told_and_one_beside_a_density_refused() {
        let text = crate::library::data_file("cases/galahad.toml").unwrap();
        let library = Library::builtin().unwrap();
        let mut case = Case::from_text(text).unwrap();
        case.set("design.component_mass_kg.impact_shell", "1");
        let answer = design(&case, &library, Request::Nothing).unwrap();
        let none = said(&answer, "impact_shell_mass_kg");
        assert_eq!(none.severity, Severity::Exceeded);
        case.set("design.component_mass_kg.body_foam", "1");
        case.set("design.density_kg_m3.body_foam", "50");
        let faults = design(&case, &library, Request::Nothing).unwrap_err();
        assert_eq!(
            faults[0].to_string(),
            "design.component_mass_kg.body_foam: given together with design.density_kg_m3.body_foam; give one of them"
        );
    }
}
