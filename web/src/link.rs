//! Links that hold a case: what differs from one that ships with the program.
//!
//! `#/design?p=run-page&entry.speed_m_s=13000&n=My%20run`. What is malformed or unknown is left out, never an error.

use crate::presets::Start;
use msape::Case;
use msape::case::Value;
use msape::quantity::input;

/// Links longer than this may be cut by other programs.
pub const LENGTH_MAX: usize = 2_000;

/// The part of the address after `#` that restores a case.
pub fn fragment(case: &Case, starts: &[Start]) -> String {
    starts
        .iter()
        .map(|start| {
            let mut text = format!("/design?p={}", encode(&start.id));
            if case.name != start.case.name {
                text.push_str(&format!("&n={}", encode(&case.name)));
            }
            for key in case.values.keys().chain(start.case.values.keys()) {
                let (now, then) = (case.values.get(key), start.case.values.get(key));
                let part = format!("&{key}=");
                if now != then && !text.contains(&part) {
                    text.push_str(&part);
                    text.push_str(&now.map(spelled).unwrap_or_default());
                }
            }
            text
        })
        .min_by_key(String::len)
        .unwrap_or_default()
}

/// The case of a link, if it is one.
pub fn case(fragment: &str, starts: &[Start]) -> Option<Case> {
    let fragment = fragment.trim_start_matches('#');
    let query = fragment.strip_prefix("/design?")?;
    let pairs: Vec<(String, String)> = query
        .split('&')
        .filter_map(|pair| pair.split_once('='))
        .map(|(key, value)| (decode(key), decode(value)))
        .collect();
    let id = pairs.iter().find(|(key, _)| key == "p")?.1.as_str();
    let mut case = starts.iter().find(|start| start.id == id)?.case.clone();
    for (key, text) in &pairs {
        match key.as_str() {
            "p" => {}
            "n" => case.name = text.clone(),
            key => set(&mut case, key, text),
        }
    }
    Some(case)
}

fn set(case: &mut Case, key: &str, text: &str) {
    let Some(input) = input::find(key) else {
        return;
    };
    match text.strip_prefix("rows:") {
        Some(rows) => {
            let rows: Option<Vec<Vec<f64>>> = rows
                .split(';')
                .map(|row| row.split(',').map(|cell| cell.parse().ok()).collect())
                .collect();
            if let Some(rows) = rows {
                case.values.insert(input.key.to_string(), Value::Rows(rows));
            }
        }
        None => case.set(input.key, text),
    }
}

fn spelled(value: &Value) -> String {
    match value {
        Value::Number(number) => number.to_string(),
        Value::Text(text) | Value::Other(text) => encode(text),
        Value::Flag(flag) => flag.to_string(),
        Value::Rows(rows) => {
            let rows: Vec<String> = rows
                .iter()
                .map(|row| {
                    let cells: Vec<String> = row.iter().map(f64::to_string).collect();
                    cells.join(",")
                })
                .collect();
            format!("rows:{}", rows.join(";"))
        }
    }
}

fn encode(text: &str) -> String {
    text.bytes()
        .map(|byte| match byte {
            b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'-' | b'_' | b'.' => {
                char::from(byte).to_string()
            }
            _ => format!("%{byte:02X}"),
        })
        .collect()
}

fn decode(text: &str) -> String {
    let bytes = text.as_bytes();
    let mut decoded = Vec::with_capacity(bytes.len());
    let mut i = 0;
    while let Some(&byte) = bytes.get(i) {
        let hex = (byte == b'%')
            .then(|| bytes.get(i + 1..i + 3))
            .flatten()
            .and_then(|pair| std::str::from_utf8(pair).ok())
            .and_then(|pair| u8::from_str_radix(pair, 16).ok());
        match hex {
            Some(value) => {
                decoded.push(value);
                i += 3;
            }
            None => {
                decoded.push(if byte == b'+' { b' ' } else { byte });
                i += 1;
            }
        }
    }
    String::from_utf8_lossy(&decoded).into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::presets::{RUN_PAGE, starts};

    #[test]
    fn a_link_restores_the_case() {
        let mut case_sent = Case::run_page();
        case_sent.name = "Äpfel & more".to_string();
        case_sent.set("entry.speed_m_s", "13 km/s");
        case_sent.set("design.payload_diameter_ratio", "");
        case_sent.values.insert(
            "atmosphere.table".to_string(),
            Value::Rows(vec![vec![0.0, 1.225], vec![1e3, 1.1]]),
        );
        let text = fragment(&case_sent, &starts());
        assert_eq!(case(&text, &starts()), Some(case_sent));
    }

    #[test]
    fn what_is_malformed_is_left_out() {
        let text = format!("#/design?p={RUN_PAGE}&entry.speed_m_s=13000&nonsense=1&%zz&n");
        let case = case(&text, &starts()).unwrap();
        assert_eq!(case.text("entry.speed_m_s").as_deref(), Some("13000"));
        assert_eq!(case.values.len(), Case::run_page().values.len());
    }
}
