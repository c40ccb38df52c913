//! Links that hold a case: its differences from a shipped case.
//!
//! `#/design?k=1f0c83a2&v=0.2&p=run-page&entry.speed_m_s=13000&n=My%20run`. Malformed or unknown parts are left out and
//! reported, never an error. A link is read against the shipped case and the defaults of its version; without a version
//! it belongs to the first. `k` is a checksum of the rest, which no longer matches if the link was truncated; it is
//! optional.

use crate::presets::{self, Start};
use msape::Case;
use msape::case::version::{BroughtUp, shipped};
use msape::case::{Value, Version};
use msape::quantity::input;

/// Length above which other programs may truncate a link.
pub const LENGTH_MAX: usize = 2_000;

/// Fragment of the address, after `#`, that restores a case.
pub fn fragment(case: &Case, starts: &[Start]) -> String {
    starts
        .iter()
        .map(|start| {
            let mut text = format!("v={}&p={}", Version::CURRENT, encode(&start.id));
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
        .map(|text| format!("/design?k={:08x}&{text}", sum(&text)))
        .unwrap_or_default()
}

/// FNV-1a of the decoded text, 32 bits, with offset basis and prime as published by Fowler, Noll and Vo.
fn sum(text: &str) -> u32 {
    let add = |sum: u32, byte: u8| (sum ^ u32::from(byte)).wrapping_mul(0x0100_0193);
    decode(text).bytes().fold(0x811c_9dc5, add)
}

/// Content of a link.
#[derive(Debug, Default, PartialEq)]
pub struct Linked {
    /// Case, with messages on what changed since it was made; `None` if the link names no known start.
    pub case: Option<BroughtUp>,
    /// Messages for the user.
    pub words: Vec<String>,
}

/// Content of a fragment, if it is a link to a case.
pub fn read(fragment: &str, starts: &[Start]) -> Option<Linked> {
    let fragment = fragment.trim_start_matches('#');
    let query = fragment.strip_prefix("/design?")?;
    let pairs: Vec<(String, String)> = query
        .split('&')
        .filter_map(|pair| pair.split_once('='))
        .map(|(key, value)| (decode(key), decode(value)))
        .collect();
    let mut words = Vec::new();
    if pairs.is_empty() || !is_whole(query) {
        words.push("This link was cut or changed after it was made: what it shows may not be what was sent.".to_string());
    }
    let unknown: Vec<&str> = pairs
        .iter()
        .filter(|(key, _)| !OWN_KEYS.contains(&key.as_str()) && input::find(key).is_none())
        .map(|(key, _)| key.as_str())
        .collect();
    if !unknown.is_empty() {
        words.push(format!(
            "The link has what this version does not know, and leaves out: {}.",
            short(&unknown.join(", "))
        ));
    }
    let given = |name: &str| pairs.iter().find(|(key, _)| key == name);
    let id = given("p").map(|(_, id)| id.as_str());
    let case = id.and_then(|id| case_of(id, &pairs, starts));
    if case.is_none() {
        words.push(match id {
            Some(id) => format!(
                "The link starts from a case that this version does not have: {}. Nothing was opened.",
                short(id)
            ),
            None => "The link does not say which case it starts from. Nothing was opened.".to_string(),
        });
    }
    Some(Linked { case, words })
}

/// Keys of a link that are not inputs: checksum, version, start, name.
const OWN_KEYS: [&str; 4] = ["k", "v", "p", "n"];

/// Whether the checksum matches, if there is one.
fn is_whole(query: &str) -> bool {
    let Some((given, rest)) = query
        .strip_prefix("k=")
        .map(|rest| rest.split_once('&').unwrap_or((rest, "")))
    else {
        return true;
    };
    u32::from_str_radix(given, 16).is_ok_and(|given| given == sum(rest))
}

/// First characters of a link's content, for a message.
fn short(text: &str) -> String {
    text.chars().take(100).collect()
}

fn case_of(id: &str, pairs: &[(String, String)], starts: &[Start]) -> Option<BroughtUp> {
    let version = pairs
        .iter()
        .find(|(key, _)| key == "v")
        .and_then(|(_, text)| Version::parse(text))
        .unwrap_or(Version::FIRST);
    let mut case = if version < Version::CURRENT {
        shipped(version, id).filter(presets::is_design)?
    } else {
        starts.iter().find(|start| start.id == id)?.case.clone()
    };
    for (key, text) in pairs {
        match key.as_str() {
            "k" | "p" | "v" => {}
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

    fn case(fragment: &str, starts: &[Start]) -> Option<BroughtUp> {
        read(fragment, starts)?.case
    }

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
        let linked = Linked {
            case: Some(case_got),
            words: Vec::new(),
        };
        assert_eq!(read(&text, &starts()), Some(linked));
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
        let links = include_str!("../../../tests/data/e134449/links.txt");
        for link in links.lines().filter(|line| !line.is_empty()) {
            let old = case(link, &starts()).unwrap_or_else(|| panic!("{link}"));
            let id = &link["#/design?p=".len()..].split('&').next().unwrap();
            let base = shipped(Version::FIRST, id).unwrap();
            // the inputs of the link, and everything else as in its shipped case
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

    #[test]
    fn a_link_that_was_cut_is_told_wherever_it_was_cut() {
        let mut sent = Case::run_page();
        sent.set("entry.speed_m_s", "13000");
        let whole = fragment(&sent, &starts());
        assert_eq!(read(&whole, &starts()).unwrap().words, [""; 0]);
        let begins = whole.find('?').unwrap();
        for end in begins + 1..whole.len() {
            let words = read(&whole[..end], &starts()).unwrap().words;
            assert!(words[0].contains("was cut"), "{}", &whole[..end]);
        }
        let changed = whole.replace("13000", "13001");
        assert!(read(&changed, &starts()).unwrap().words[0].contains("was cut"));
    }

    #[test]
    fn an_unknown_start_and_unknown_keys_are_told() {
        let linked = read("#/design?v=0.2&p=no-such", &starts()).unwrap();
        assert!(linked.case.is_none() && linked.words[0].contains("no-such"));
        let linked = read("#/design?p=run-page&nonsense=1", &starts()).unwrap();
        assert!(linked.case.is_some() && linked.words[0].contains("nonsense"));
        assert_eq!(read("#/design", &starts()), None);
        assert_eq!(read("#/library/vehicles", &starts()), None);
    }

    #[test]
    fn the_check_sum_is_that_of_its_source() {
        // test vectors published with FNV-1a: "" and "a"
        assert_eq!((sum(""), sum("a")), (0x811c_9dc5, 0xe40c_292c));
    }
}
