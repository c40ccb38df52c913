//! An answer as JSON: one object, keys in the order of the lists of quantities.
//!
//! What did not occur, and what is not a finite number, is `null`.

use super::Answer;
use crate::answer::{landing, outputs, turning};
use crate::quantity::Job;
use serde_json::{Map, Value, json as value};

/// The answer as one object: `name`, `outcome`, `reason`, `results`, `findings`, `adjustments`, `passes`, where some began `phases`, of a design
/// `mass_tree`, `structure`, `stability` and, where it was flown, `reorientation` and, where a time history was asked for, `trajectory` and, for a design, `landing`.
pub fn json(answer: &Answer, job: Job) -> Value {
    let mut object = Map::new();
    object.insert("name".to_string(), value!(answer.name));
    object.insert("outcome".to_string(), value!(answer.outcome.name()));
    object.insert("reason".to_string(), value!(answer.reason));
    object.insert("results".to_string(), results(answer, job));
    object.insert("findings".to_string(), value!(answer.findings));
    object.insert("adjustments".to_string(), value!(answer.adjustments));
    object.insert("passes".to_string(), value!(answer.passes));
    let begun = answer.flight.as_ref().map(|flight| &flight.phases);
    if let Some(phases) = begun.filter(|phases| !phases.is_empty()) {
        object.insert("phases".to_string(), value!(phases));
    }
    if let Some(design) = &answer.design {
        let tree = design.vehicle.mass_tree();
        object.insert("mass_tree".to_string(), value!(tree));
    }
    if let Some(structural) = answer.design.as_ref().and_then(|d| d.structural.as_ref()) {
        object.insert("structure".to_string(), value!(structural));
    }
    if let Some(design) = &answer.design {
        if let Some(stability) = &design.stability {
            object.insert("stability".to_string(), value!(stability));
        }
        if let Some(flown) = &design.turning {
            object.insert("reorientation".to_string(), turning::json(flown));
        }
    }
    if let Some(trajectory) = answer.flight.as_ref().and_then(|f| f.trajectory.as_ref()) {
        let history = trajectory
            .columns()
            .map(|(column, values)| {
                let named = values.iter().map(|x| trajectory.name(column, *x));
                let values = match named.collect::<Option<Vec<&str>>>() {
                    Some(names) if !names.is_empty() => value!(names),
                    _ => value!(values),
                };
                (column.key.to_string(), values)
            })
            .collect();
        object.insert("trajectory".to_string(), Value::Object(history));
        if let Some(design) = &answer.design {
            let history =
                landing::keyed(&design.landing).map(|(key, values)| (key, value!(values)));
            object.insert("landing".to_string(), Value::Object(history.collect()));
        }
    }
    Value::Object(object)
}

/// The same object as text, a line for each number and for each column of the time history.
pub fn text(answer: &Answer, job: Job) -> String {
    let Value::Object(object) = json(answer, job) else {
        return String::new();
    };
    let members = object
        .iter()
        .map(|(key, member)| match (key.as_str(), member) {
            ("trajectory" | "landing" | "structure" | "stability", Value::Object(history)) => {
                lines(
                    history
                        .iter()
                        .map(|(column, values)| format!("{}: {values}", quoted(column))),
                )
                .map_or_else(
                    || format!("{}: {{}}", quoted(key)),
                    |inner| format!("{}: {{\n{inner}\n}}", quoted(key)),
                )
            }
            // Line breaks inside strings are escaped, so every line break here is layout.
            _ => format!("{}: {member:#}", quoted(key)),
        });
    format!("{{\n{}\n}}\n", lines(members).unwrap_or_default())
}

fn results(answer: &Answer, job: Job) -> Value {
    let results = outputs(job)
        .map(|output| {
            let number = (output.get)(answer).filter(|number| number.is_finite());
            (output.key.to_string(), value!(number))
        })
        .collect();
    Value::Object(results)
}

/// Members divided by commas, one step further in; `None` when there are none.
fn lines(members: impl Iterator<Item = String>) -> Option<String> {
    members
        .map(|member| format!("  {}", member.replace('\n', "\n  ")))
        .reduce(|all, member| format!("{all},\n{member}"))
}

fn quoted(text: &str) -> Value {
    Value::String(text.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::answer::sample;

    #[test]
    fn keys_stand_in_the_order_of_the_lists_and_what_did_not_occur_is_null() {
        let answer = sample::flight();
        let Value::Object(object) = json(&answer, Job::Fly) else {
            unreachable!()
        };
        let keys: Vec<_> = object.keys().map(String::as_str).collect();
        assert_eq!(
            keys,
            [
                "name",
                "outcome",
                "reason",
                "results",
                "findings",
                "adjustments",
                "passes",
                "trajectory"
            ]
        );
        let results = object["results"].as_object().unwrap();
        let listed: Vec<_> = outputs(Job::Fly).map(|output| output.key).collect();
        assert_eq!(results.keys().collect::<Vec<_>>(), listed);
        assert_eq!(results["peak_deceleration_earth_g"], value!(29.84381));
        assert_eq!(results["peak_radiative_heat_flux_w_m2"], Value::Null);
        assert_eq!(results["mach_5_time_s"], Value::Null);
        // A ballistic coefficient without drag is infinite.
        assert_eq!(results["ballistic_coefficient_kg_m2"], Value::Null);
        assert_eq!(object["outcome"], value!("landed"));
        assert_eq!(object["trajectory"]["time_s"], value!([0.0, 2.0, 4.0]));
    }

    #[test]
    fn the_text_reads_back_to_the_same_object() {
        for answer in [sample::flight(), sample::not_closed()] {
            let text = text(&answer, Job::Fly);
            let read: Value = serde_json::from_str(&text).unwrap();
            assert_eq!(read, json(&answer, Job::Fly));
        }
        let text = text(&sample::flight(), Job::Fly);
        assert!(text.starts_with("{\n  \"name\": \"sample \\\"one\\\", first\",\n  \"outcome\": \"landed\",\n  \"reason\": null,\n  \"results\": {\n    \"peak_deceleration_earth_g\": 29.84381,\n"));
        assert!(text.contains("\n  \"trajectory\": {\n    \"time_s\": [0.0,2.0,4.0],\n"));
        assert!(text.ends_with("]\n  }\n}\n"));
    }
}
