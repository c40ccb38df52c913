//! Recorded answers: each number as the shortest text that reads back to its bits, time histories as a digest of the
//! bits of each column, and a digest of the whole answer, including geometry.

use crate::shipped::Shipped;
use msape::flight::columns::columns;
use msape::{Answer, Library, Request, answer};
use serde_json::{Map, Value, json};

/// Recorded answers by name of the case.
pub static RECORDED: &[(&str, &str)] = include!(concat!(env!("OUT_DIR"), "/snapshots.rs"));

/// Uniform step of the second time history, s; not a divisor of the duration of any flight.
const UNIFORM_STEP_S: f64 = 0.7;

/// Record of a case.
///
/// # Errors
/// All faults of the case, or an internal error: a history that changes the results.
pub fn take(shipped: &Shipped, library: &Library) -> Result<Value, String> {
    let solve = |request| {
        shipped
            .solve(library, request)
            .map_err(|faults| format!("{}: refused: {faults:?}", shipped.name))
    };
    let plain = solve(Request::Nothing)?;
    let mut recorded = answer::json(&plain, shipped.job);
    recorded["everything"] = json!(digest_of_all(&plain)?);
    for (key, request) in [
        ("history_at_steps", Request::Steps),
        ("history_uniform", Request::Uniform(UNIFORM_STEP_S)),
    ] {
        let mut with_history = solve(request)?;
        recorded[key] = history(&with_history);
        if let Some(flight) = &mut with_history.flight {
            flight.trajectory = None;
        }
        if with_history != plain {
            return Err(format!(
                "{}: asking for a history changes the answer",
                shipped.name
            ));
        }
    }
    Ok(recorded)
}

/// Digest of the bits of each column, and the number of rows.
fn history(answer: &Answer) -> Value {
    let trajectory = answer.flight.as_ref().and_then(|f| f.trajectory.as_ref());
    let Some(trajectory) = trajectory else {
        return Value::Null;
    };
    let mut object = Map::new();
    object.insert("rows".to_string(), json!(trajectory.rows()));
    for (column, values) in columns().zip(&trajectory.values) {
        let bytes = values.iter().flat_map(|value| bits(*value).to_le_bytes());
        object.insert(column.key.to_string(), json!(hexadecimal(digest(bytes))));
    }
    Value::Object(object)
}

/// Bits of a number; all NaN values are equal.
fn bits(number: f64) -> u64 {
    if number.is_nan() { f64::NAN } else { number }.to_bits()
}

/// Digest of the whole answer as text that keeps every bit.
fn digest_of_all(answer: &Answer) -> Result<String, String> {
    let text = serde_json::to_string(answer).map_err(|error| error.to_string())?;
    Ok(hexadecimal(digest(text.bytes())))
}

/// Hash of bytes (FNV-1a, 64 bit).
pub fn digest(bytes: impl Iterator<Item = u8>) -> u64 {
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
    })
}

fn hexadecimal(digest: u64) -> String {
    format!("{digest:016x}")
}

/// Differences to a recorded answer, one line per quantity; numbers are compared to the bit.
pub fn differences(recorded: &Value, now: &Value) -> Vec<String> {
    let mut lines = Vec::new();
    compare("", recorded, now, &mut lines);
    lines
}

fn compare(path: &str, recorded: &Value, now: &Value, lines: &mut Vec<String>) {
    match (recorded, now) {
        (Value::Object(a), Value::Object(b)) => {
            for (key, was) in a {
                let is = b.get(key).unwrap_or(&Value::Null);
                compare(&join(path, key), was, is, lines);
            }
            let added = b.iter().filter(|(key, _)| !a.contains_key(*key));
            lines.extend(added.map(|(key, is)| format!("{}: new, {is}", join(path, key))));
        }
        (Value::Array(a), Value::Array(b)) => {
            if a.len() != b.len() {
                lines.push(format!("{path}: {} entries, now {}", a.len(), b.len()));
            }
            for (i, (was, is)) in a.iter().zip(b).enumerate() {
                compare(&join(path, &i.to_string()), was, is, lines);
            }
        }
        _ if same(recorded, now) => {}
        _ => lines.push(format!(
            "{path}: {recorded}, now {now}{}",
            part(recorded, now)
        )),
    }
}

fn join(path: &str, key: &str) -> String {
    if path.is_empty() {
        key.to_string()
    } else {
        format!("{path}.{key}")
    }
}

/// Bitwise equality: zero and negative zero differ.
fn same(recorded: &Value, now: &Value) -> bool {
    let bits = |value: &Value| value.as_f64().map(f64::to_bits);
    recorded == now && bits(recorded) == bits(now)
}

/// Change relative to the recorded value.
fn part(recorded: &Value, now: &Value) -> String {
    match (recorded.as_f64(), now.as_f64()) {
        (Some(was), Some(is)) if was != 0.0 => format!(" ({:+.1e} of it)", (is - was) / was.abs()),
        _ => String::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_bit_of_one_number_is_a_difference() {
        let was = json!({"results": {"a": 0.1, "b": null}, "list": [1.0]});
        let mut now = was.clone();
        assert!(differences(&was, &now).is_empty());
        now["results"]["a"] = json!(f64::from_bits(0.1_f64.to_bits() + 1));
        now["results"]["b"] = json!(-0.0);
        now["list"] = json!([1.0, 2.0]);
        assert_eq!(
            differences(&was, &now),
            [
                "results.a: 0.1, now 0.10000000000000002 (+1.4e-16 of it)",
                "results.b: null, now -0.0",
                "list: 1 entries, now 2",
            ]
        );
        assert_eq!(differences(&json!(0.0), &json!(-0.0)).len(), 1);
    }

    #[test]
    fn the_digest_is_that_of_the_published_example() {
        // FNV-1a, 64 bit, of "a" is af63dc4c8601ec8c
        assert_eq!(
            hexadecimal(digest(b"a".iter().copied())),
            "af63dc4c8601ec8c"
        );
    }
}
