//! An answer as JSON: one object, keys in the order of the lists of quantities.
//!
//! Values that did not occur, and numbers that are not finite, are `null`.

use super::Answer;
use crate::answer::{landing, outputs, turning};
use crate::flight::Trajectory;
use crate::flight::points::PointHeat;
use crate::heating::given::body::Along;
use crate::quantity::Job;
use serde_json::{Number, Value, json as value};
use std::fmt;

/// The answer as one object: `name`, `outcome`, `reason`, `results`, `findings`, `adjustments`, `passes`, where some began `phases`, where the case gives
/// them `heating_points`, of a design
/// `mass_tree`, `structure`, `stability` and, where it was flown, `reorientation` and, where a time history was asked for, `trajectory` and, for a design, `landing`.
pub fn json(answer: &Answer, job: Job) -> Value {
    let trajectory = answer.flight.as_ref().and_then(|f| f.trajectory.as_ref());
    let member = |(key, member): (&str, Value)| match (key, trajectory) {
        ("trajectory", Some(trajectory)) => {
            let columns = trajectory.columns();
            let history = columns.map(|(column, values)| {
                let named = values.iter().map(|x| trajectory.name(column, *x));
                let values = match named.collect::<Option<Vec<&str>>>() {
                    Some(names) if !names.is_empty() => value!(names),
                    _ => value!(values),
                };
                (column.key.to_string(), values)
            });
            (key.to_string(), Value::Object(history.collect()))
        }
        _ => (key.to_string(), member),
    };
    Value::Object(members(answer, job).into_iter().map(member).collect())
}

/// The members of the object in their order; the time history is left null, as it may be long.
fn members(answer: &Answer, job: Job) -> Vec<(&'static str, Value)> {
    let mut members = vec![
        ("name", value!(answer.name)),
        ("outcome", value!(answer.outcome.name())),
        ("reason", value!(answer.reason)),
        ("results", results(answer, job)),
        ("findings", value!(answer.findings)),
        ("adjustments", value!(answer.adjustments)),
        ("passes", value!(answer.passes)),
    ];
    let begun = answer.flight.as_ref().map(|flight| &flight.phases);
    if let Some(phases) = begun.filter(|phases| !phases.is_empty()) {
        members.push(("phases", value!(phases)));
    }
    let points = answer.flight.as_ref().map(|flight| &flight.points);
    if let Some(points) = points.filter(|points| !points.is_empty()) {
        let points: Vec<Value> = points.iter().map(point).collect();
        members.push(("heating_points", value!(points)));
    }
    if let Some(design) = &answer.design {
        members.push(("mass_tree", value!(design.vehicle.mass_tree())));
        if let Some(structural) = &design.structural {
            members.push(("structure", value!(structural)));
        }
        if let Some(stability) = &design.stability {
            members.push(("stability", value!(stability)));
        }
        if let Some(flown) = &design.turning {
            members.push(("reorientation", turning::json(flown)));
        }
    }
    if answer
        .flight
        .as_ref()
        .is_some_and(|f| f.trajectory.is_some())
    {
        members.push(("trajectory", Value::Null));
        if let Some(design) = &answer.design {
            let history =
                landing::keyed(&design.landing).map(|(key, values)| (key, value!(values)));
            members.push(("landing", Value::Object(history.collect())));
        }
    }
    members
}

/// Heating at a point of the body, under the name of its column in the case.
fn point(point: &PointHeat) -> Value {
    let place = match point.along {
        Along::Radius => "radius_fraction",
        Along::Arc => "arc_fraction",
    };
    value!({
        place: point.fraction,
        "peak_total_margined_heat_flux_w_m2": point.peak_heat_flux_w_m2,
        "total_margined_heat_load_j_m2": point.heat_load_j_m2,
    })
}

/// The JSON object of an answer as text: one line for each number and for each column of the time history.
pub fn text(answer: &Answer, job: Job) -> String {
    let mut text = String::new();
    // Writing into a String cannot fail.
    let _ = write(answer, job, &mut text);
    text
}

/// Writes the text of [`text`] piece by piece, so that the text of a time history is never in memory as a whole.
///
/// # Errors
/// The error of the writer.
pub fn write(answer: &Answer, job: Job, out: &mut dyn fmt::Write) -> fmt::Result {
    let trajectory = answer.flight.as_ref().and_then(|f| f.trajectory.as_ref());
    let mut first = true;
    out.write_char('{')?;
    for (key, member) in members(answer, job) {
        out.write_str(if first { "\n  " } else { ",\n  " })?;
        first = false;
        write!(out, "{}: ", quoted(key))?;
        match (key, member) {
            ("trajectory", _) => {
                write_history(out, trajectory)?;
            }
            ("landing" | "structure" | "stability", Value::Object(object)) => {
                if object.is_empty() {
                    out.write_str("{}")?;
                }
                for (i, (column, values)) in object.iter().enumerate() {
                    out.write_str(if i == 0 { "{\n    " } else { ",\n    " })?;
                    write!(out, "{}: {values}", quoted(column))?;
                }
                if !object.is_empty() {
                    out.write_str("\n  }")?;
                }
            }
            // Line breaks inside strings are escaped, so every line break here is layout.
            (_, member) => out.write_str(&format!("{member:#}").replace('\n', "\n  "))?,
        }
    }
    out.write_str("\n}\n")
}

fn write_history(out: &mut dyn fmt::Write, trajectory: Option<&Trajectory>) -> fmt::Result {
    let mut empty = true;
    if let Some(trajectory) = trajectory {
        for (column, values) in trajectory.columns() {
            out.write_str(if empty { "{\n    " } else { ",\n    " })?;
            empty = false;
            write!(out, "{}: [", quoted(column.key))?;
            for (i, number) in values.iter().enumerate() {
                if i > 0 {
                    out.write_char(',')?;
                }
                match (trajectory.name(column, *number), Number::from_f64(*number)) {
                    (Some(name), _) => write!(out, "{}", quoted(name))?,
                    (None, Some(number)) => write!(out, "{number}")?,
                    (None, None) => out.write_str("null")?,
                }
            }
            out.write_char(']')?;
        }
    }
    out.write_str(if empty { "{}" } else { "\n  }" })
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
