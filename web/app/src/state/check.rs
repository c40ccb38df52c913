//! State of each input: default, changed, unusual, faulty.

use msape::Case;
use msape::case::{Reader, Value};
use msape::quantity::input::{Kind, Preset, inputs};
use msape_worker::catalog::{Catalog, names};
use std::collections::BTreeMap;

/// States of all inputs, by key.
pub type Checks = BTreeMap<&'static str, Check>;

/// State of an input.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Check {
    /// Whether it differs from its default.
    pub changed: bool,
    /// Faults.
    pub faults: Vec<String>,
    /// Messages on unusual values.
    pub remarks: Vec<String>,
}

/// Checks every input on its own; conditions on several inputs are checked by the solver.
pub fn check_inputs(case: &Case, catalog: Option<&Catalog>) -> Checks {
    let mut reader = Reader::new(case);
    inputs()
        .map(|input| {
            let (faults, findings) = (reader.faults.len(), reader.findings.len());
            match input.kind {
                Kind::Number { .. } => drop(reader.number(input)),
                Kind::Flag => drop(reader.flag(input)),
                Kind::Choice(_) => {
                    let choices = names(catalog, input);
                    let names: Vec<&str> = choices.iter().map(|(name, _)| name.as_str()).collect();
                    if !names.is_empty() {
                        reader.name(input, &names);
                    }
                }
                Kind::Rows(_) => drop(reader.rows(input)),
                Kind::Text => drop(reader.words(input)),
            }
            let value = case.values.get(input.key);
            let changed = match (value, input.preset) {
                (None, _) => false,
                (Some(Value::Number(a)), Preset::Number(b)) => *a != b,
                (Some(Value::Flag(a)), Preset::Flag(b)) => *a != b,
                (Some(Value::Text(a)), Preset::Name(b)) => a != b,
                (Some(_), _) => true,
            };
            let check = Check {
                changed,
                faults: reader.faults[faults..]
                    .iter()
                    .map(|fault| fault.message.clone())
                    .collect(),
                remarks: reader.findings[findings..]
                    .iter()
                    .map(|finding| finding.message.clone())
                    .collect(),
            };
            (input.key, check)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faults_and_remarks_stand_at_their_inputs() {
        let mut case = Case::run_page();
        case.set("design.diameter_m", "-1");
        case.set("entry.speed_m_s", "9000");
        let checks = check_inputs(&case, None);
        assert_eq!(checks["design.diameter_m"].faults.len(), 1);
        assert_eq!(checks["entry.speed_m_s"].remarks.len(), 1);
        assert!(!checks["design.nose_radius_ratio"].changed);
    }
}
