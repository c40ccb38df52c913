//! Links that hold a case: what differs from one that ships with the program.
//!
//! `#/design?v=0.2&p=run-page&entry.speed_m_s=13000&n=My%20run`. What is malformed or unknown is left out, never an error.
//! A link is read against the shipped case and the defaults of its version; without one it is of the first.

use crate::presets::{self, Start};
use msape::Case;
use msape::case::version::{BroughtUp, shipped};
use msape::case::{Value, Version};
use msape::quantity::input;

/// Links longer than this may be cut by other programs.
pub const LENGTH_MAX: usize = 2_000;

/// The part of the address after `#` that restores a case.
pub fn fragment(case: &Case, starts: &[Start]) -> String {
    starts
        .iter()
        .map(|start| {
            let mut text = format!("/design?v={}&p={}", Version::CURRENT, encode(&start.id));
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

/// The case of a link, if it is one, and remarks on what changed since it was made.
pub fn case(fragment: &str, starts: &[Start]) -> Option<BroughtUp> {
    let fragment = fragment.trim_start_matches('#');
    let query = fragment.strip_prefix("/design?")?;
    let pairs: Vec<(String, String)> = query
        .split('&')
        .filter_map(|pair| pair.split_once('='))
        .map(|(key, value)| (decode(key), decode(value)))
        .collect();
    let given = |name: &str| pairs.iter().find(|(key, _)| key == name);
    let version = given("v")
        .and_then(|(_, text)| Version::parse(text))
        .unwrap_or(Version::FIRST);
    let id = given("p")?.1.as_str();
    let mut case = if version < Version::CURRENT {
        shipped(version, id).filter(presets::is_design)?
    } else {
        starts.iter().find(|start| start.id == id)?.case.clone()
    };
    for (key, text) in &pairs {
        match key.as_str() {
            "p" | "v" => {}
            "n" => case.name = text.clone(),
            key => set(&mut case, key, text),
        }
    }
    let mut brought_up = case.brought_up_from(version);
    if version > Version::CURRENT {
        brought_up.remarks.push(format!(
            "The link was made with version {version}; this is {}, whose defaults it gets.",
            Version::CURRENT
        ));
    }
    Some(brought_up)
}

fn set(case: &mut Case, key: &str, text: &str) {
    if input::find(key).is_none() {
        return;
    }
    match text.strip_prefix("rows:") {
        Some(rows) => {
            let rows: Option<Vec<Vec<f64>>> = rows
                .split(';')
                .map(|row| row.split(',').map(|cell| cell.parse().ok()).collect())
                .collect();
            if let Some(rows) = rows {
                case.values
                    .insert(input::canonical_key(key), Value::Rows(rows));
            }
        }
        None => case.set(key, text),
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
        let remarks = Vec::new();
        let case_got = BroughtUp {
            case: case_sent,
            remarks,
        };
        assert_eq!(case(&text, &starts()), Some(case_got));
    }

    #[test]
    fn what_is_malformed_is_left_out() {
        let text = format!("#/design?v=0.2&p={RUN_PAGE}&entry.speed_m_s=13000&nonsense=1&%zz&n");
        let case = case(&text, &starts()).unwrap().case;
        assert_eq!(case.text("entry.speed_m_s").as_deref(), Some("13000"));
        assert_eq!(case.values.len(), Case::run_page().values.len());
    }

    #[test]
    fn links_of_the_first_version_keep_its_shipped_cases_and_defaults() {
        let links = include_str!("../../tests/data/e134449/links.txt");
        for link in links.lines().filter(|line| !line.is_empty()) {
            let old = case(link, &starts()).unwrap_or_else(|| panic!("{link}"));
            let id = &link["#/design?p=".len()..].split('&').next().unwrap();
            let base = shipped(Version::FIRST, id).unwrap();
            // what the link says, and everything else as its shipped case was
            for (key, value) in &base.values {
                if link.contains(&format!("&{key}=")) {
                    let said = link.split(&format!("&{key}=")).nth(1).unwrap();
                    let said = decode(said.split('&').next().unwrap());
                    assert_eq!(
                        old.case.text(key).unwrap_or_default(),
                        said,
                        "{key} of {link}"
                    );
                } else {
                    assert_eq!(old.case.values.get(key), Some(value), "{key} of {link}");
                }
            }
            assert_eq!(old.case.version_note(), None, "{link}");
            assert!(!old.remarks.is_empty(), "{link}");
        }
    }

    #[test]
    fn a_link_of_a_newer_program_says_so() {
        let text = format!("#/design?v=99.0&p={RUN_PAGE}");
        let newer = case(&text, &starts()).unwrap();
        assert!(newer.remarks[0].contains("version 99.0"));
    }
}
