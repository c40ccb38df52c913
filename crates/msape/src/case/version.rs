//! The version of the program that a case was written for, and what later versions changed.
//!
//! A case leaves inputs open, and a link contains only the differences from a shipped case: both depend on defaults and
//! presets of the program that wrote them. `data/versions` lists the differences of each version, `cases/0.1` contains the
//! shipped cases as they were. A record of the program itself is [brought up](Case::brought_up_from): it keeps the old
//! defaults as explicit values. A file is read unchanged, with a [note](Case::version_note) on each default that
//! has changed since.

use super::Case;
use crate::finding::Finding;
use crate::library::case_file;
use crate::quantity::input::{self, Preset};
use crate::units::canonical;
use serde::{Deserialize, Serialize};
use std::fmt;

/// A version of the program, as far as it determines the defaults.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub struct Version {
    /// Number before the first point.
    pub major: u32,
    /// Number after the first point.
    pub minor: u32,
}

impl Version {
    /// The first version, which did not write a version into its cases.
    pub const FIRST: Version = Version { major: 0, minor: 1 };
    /// This version.
    pub const CURRENT: Version = Version { major: 0, minor: 2 };

    /// Reads a version such as `0.2`; a third number is ignored.
    pub fn parse(text: &str) -> Option<Version> {
        let mut parts = text.split('.').map(|part| part.parse::<u32>().ok());
        Some(Version {
            major: parts.next()??,
            minor: parts.next()??,
        })
    }
}

impl Default for Version {
    fn default() -> Version {
        Version::CURRENT
    }
}

impl fmt::Display for Version {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}.{}", self.major, self.minor)
    }
}

/// Earlier versions with a list of differences, each with its file and the folder of its shipped cases.
const EARLIER: [(Version, &str, &str); 1] = [(Version::FIRST, "versions/0.1.toml", "cases/0.1")];

/// Differences of an earlier version from this one.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Changes {
    #[serde(rename = "source")]
    _source: String,
    #[serde(rename = "place")]
    _place: String,
    #[serde(rename = "same")]
    _same: Vec<String>,
    default: Vec<OldDefault>,
    mended: Vec<Mended>,
}

/// A default of an earlier version.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct OldDefault {
    key: String,
    was: String,
    now: Option<String>,
    /// Cases in which the old default is still valid; all cases if absent.
    #[serde(rename = "where")]
    only: Option<Place>,
}

/// Cases in which an input has one of some values, or is left open.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Place {
    key: String,
    values: Vec<String>,
}

/// A fault of an earlier version, in cases that have a section.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Mended {
    section: String,
    what: String,
    /// Cases that it affects; all cases if absent.
    #[serde(rename = "where")]
    only: Option<Place>,
}

impl Mended {
    /// Whether a corrected fault affects a case.
    fn concerns(&self, case: &Case) -> bool {
        let there = |Place { key, values }: &Place| {
            let text = case.text(key);
            text.is_some_and(|text| values.contains(&text))
        };
        case.has_section(&self.section) && self.only.as_ref().is_none_or(there)
    }
}

/// A case that keeps the defaults of its version, with remarks.
#[derive(Clone, Debug, PartialEq)]
pub struct BroughtUp {
    /// The case, of this version.
    pub case: Case,
    /// Findings on old defaults written into the case, and on faults corrected since.
    pub remarks: Vec<String>,
}

/// A shipped case, such as `galahad`, as it was in a version.
pub fn shipped(version: Version, id: &str) -> Option<Case> {
    let now = format!("cases/{id}.toml");
    let text = EARLIER
        .iter()
        .filter(|(of, ..)| *of >= version)
        .find_map(|(_, _, folder)| case_file(&format!("{folder}/{id}.toml")))
        .or_else(|| case_file(&now))?;
    Case::from_toml(text).ok()
}

/// Differences of all versions from `version` on, the oldest first: a default that changed twice is taken from the oldest.
fn since(version: Version) -> Vec<(Version, Changes)> {
    EARLIER
        .iter()
        .filter(|(of, ..)| *of >= version)
        .filter_map(|(of, file, _)| Some((*of, toml::from_str(case_file(file)?).ok()?)))
        .collect()
}

impl OldDefault {
    fn line(&self, version: Version) -> String {
        format!(
            "{} was {} by default in version {version}, now {}",
            self.key,
            self.was,
            self.now.clone().unwrap_or_else(|| preset(&self.key))
        )
    }
}

/// The default of an input as text with its unit.
fn preset(key: &str) -> String {
    let Some(input) = input::find(key) else {
        return "unknown".to_owned();
    };
    match input.preset {
        Preset::Absent => "left open".to_owned(),
        Preset::Name(name) => name.to_owned(),
        Preset::Flag(flag) => flag.to_string(),
        Preset::Number(number) => match input.kind {
            input::Kind::Number { dimension, .. } => {
                format!("{number} {}", canonical(dimension).symbol)
                    .trim_end()
                    .to_owned()
            }
            _ => number.to_string(),
        },
    }
}

/// Sections that affect a case only if it contains them.
const OPTIONAL_SECTIONS: [&str; 3] = ["design", "vehicle", "outline"];

impl Case {
    fn has_section(&self, section: &str) -> bool {
        self.values
            .keys()
            .any(|key| key.split('.').next() == Some(section))
    }

    /// Whether an old default acts on this case: left open, in a section that counts.
    fn leaves_open(&self, old: &OldDefault) -> bool {
        let section = old.key.split('.').next().unwrap_or_default();
        input::find(&old.key).is_some()
            && !self.values.contains_key(&old.key)
            && (!OPTIONAL_SECTIONS.contains(&section) || self.has_section(section))
    }

    /// Whether an old default would now be refused in this case.
    fn outgrew(&self, old: &OldDefault) -> bool {
        let place = old.only.as_ref();
        place.is_some_and(|Place { key, values }| {
            let text = self.text(key);
            text.is_some_and(|text| !values.contains(&text))
        })
    }

    /// The case with the defaults of `version` for the inputs that it leaves open.
    #[must_use]
    pub fn brought_up_from(self, version: Version) -> BroughtUp {
        brought_up(self, &since(version))
    }

    /// Findings on each default that changed since the case was written and that it leaves open.
    pub fn version_note(&self) -> Option<Finding> {
        note(self, &since(self.version))
    }
}

fn brought_up(mut case: Case, changes: &[(Version, Changes)]) -> BroughtUp {
    let mut remarks = Vec::new();
    for (version, changes) in changes {
        for old in &changes.default {
            if case.leaves_open(old) && !case.outgrew(old) {
                remarks.push(format!("{}: {} is kept.", old.line(*version), old.was));
                case.set(&old.key, &old.was);
            } else if case.leaves_open(old) {
                remarks.push(format!("{}, which is taken.", old.line(*version)));
            }
        }
        let mended = changes.mended.iter();
        let concerned = mended.filter(|mended| mended.concerns(&case));
        remarks.extend(concerned.map(|mended| format!("Since version {version}: {}", mended.what)));
    }
    case.version = Version::CURRENT;
    BroughtUp { case, remarks }
}

fn note(case: &Case, changes: &[(Version, Changes)]) -> Option<Finding> {
    let mut lines: Vec<String> = Vec::new();
    for (version, changes) in changes {
        let open = changes.default.iter().filter(|old| case.leaves_open(old));
        lines.extend(open.map(|old| old.line(*version)));
    }
    (!lines.is_empty()).then(|| {
        let message = format!(
            "The case is of version {} and leaves open what has another default now: {}. Give the old value to keep it, or version = \"{}\" to take the new one.",
            case.version,
            lines.join("; "),
            Version::CURRENT
        );
        Finding {
            field: None,
            ..Finding::note("version", &"version", message)
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::library::data_folder;

    fn changes() -> Vec<(Version, Changes)> {
        let text = r#"
source = "assumed"
place = "a test"
same = []
mended = [
    { section = "design", what = "The stroke was too long." },
    { section = "heating", what = "The wall was cold.", where = { key = "heating.wall", values = ["radiative-equilibrium"] } },
]
[[default]]
key = "heating.convective_margin"
was = "1.5"
[[default]]
key = "design.ground"
was = "rigid"
now = "a softer one"
"#;
        vec![(Version::FIRST, toml::from_str(text).unwrap())]
    }

    fn case(text: &str) -> Case {
        Case::from_toml(&format!("schema = 'msape/1'\n{text}")).unwrap()
    }

    #[test]
    fn this_version_is_the_one_of_the_workspace() {
        assert_eq!(
            Version::parse(env!("CARGO_PKG_VERSION")),
            Some(Version::CURRENT)
        );
        assert_eq!(Version::parse("0.2").unwrap().to_string(), "0.2");
        assert_eq!(Version::parse("two"), None);
        assert!(EARLIER.iter().all(|(of, ..)| *of < Version::CURRENT));
    }

    #[test]
    fn an_old_file_is_told_what_changed_under_it_and_a_new_one_is_not() {
        let old = case("[design]\nmsr_mode = true\n");
        let told = note(&old, &changes()).unwrap().message;
        assert!(
            told.contains("heating.convective_margin was 1.5 by default in version 0.1, now 1"),
            "{told}"
        );
        assert!(
            told.contains("design.ground was rigid by default in version 0.1, now a softer one"),
            "{told}"
        );
        // a flight has no ground to choose, and who gives the value is not concerned
        let flight = case("[vehicle]\nmass_kg = 1\n[heating]\nconvective_margin = 2\n");
        assert_eq!(note(&flight, &changes()), None);
        let new = case("version = '0.2'\n[design]\nmsr_mode = true\n");
        assert_eq!(new.version_note(), None);
        assert_eq!(Case::run_page().version_note(), None);
    }

    #[test]
    fn an_old_record_keeps_the_old_defaults_as_its_own() {
        let BroughtUp { case, remarks } =
            brought_up(case("[design]\nmsr_mode = true\n"), &changes());
        assert_eq!(
            case.text("heating.convective_margin").as_deref(),
            Some("1.5")
        );
        assert_eq!(case.text("design.ground").as_deref(), Some("rigid"));
        assert_eq!(case.version, Version::CURRENT);
        assert_eq!(remarks.len(), 3, "{remarks:?}");
        assert_eq!(note(&case, &[]), None);
    }

    #[test]
    fn a_mended_fault_is_told_where_it_shows() {
        let told = |wall: &str| {
            let old = case(&format!("[heating]\nwall = '{wall}'\n"));
            let remarks = old.brought_up_from(Version::FIRST).remarks;
            remarks
                .iter()
                .any(|remark| remark.contains("A hot wall has"))
        };
        assert!(told("radiative-equilibrium") && !told("cold"));
    }

    #[test]
    fn the_air_of_the_earth_is_not_kept_on_another_planet() {
        let kept = |planet: &str| {
            let old = case(&format!("[entry]\nplanet = '{planet}'\n"));
            let BroughtUp { case, remarks } = old.brought_up_from(Version::FIRST);
            let of = |remark: &&String| remark.starts_with("entry.atmosphere was us-1976");
            let remark = remarks.iter().find(of).cloned().unwrap();
            (case.text("entry.atmosphere"), remark)
        };
        let (atmosphere, remark) = kept("earth");
        assert_eq!(atmosphere.as_deref(), Some("us-1976"));
        assert!(remark.ends_with("us-1976 is kept."), "{remark}");
        let (atmosphere, remark) = kept("mars");
        assert_eq!(atmosphere, None);
        assert!(
            remark.ends_with("now the planet's own, which is taken."),
            "{remark}"
        );
    }

    #[test]
    fn every_default_that_is_listed_was_changed() {
        for (version, file, folder) in EARLIER {
            let changes: Changes = toml::from_str(case_file(file).unwrap()).unwrap();
            for old in &changes.default {
                let input = input::find(&old.key).unwrap_or_else(|| panic!("{}", old.key));
                let [mut then, mut now] = [Case::default(), Case::default()];
                then.set(&old.key, &old.was);
                now.reset(input);
                assert_ne!(then.values, now.values, "{} in {version}", old.key);
                assert!(
                    old.now.is_some() || input.preset != Preset::Absent,
                    "{}",
                    old.key
                );
            }
            assert!(data_folder(folder).count() > 0);
            for (path, text) in data_folder(folder) {
                let case = Case::from_toml(text).unwrap_or_else(|e| panic!("{path}: {e:?}"));
                assert_eq!(case.version, version, "{path}");
            }
        }
    }
}
