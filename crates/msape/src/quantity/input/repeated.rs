//! Sections that a case may hold several times: `[[phase]]`, `[[tps.layer]]`.
//!
//! A key of the list, such as `phase.altitude_m`, stands for that of every one: `phase.1.altitude_m`, `phase.2.altitude_m`.

use super::{Input, phase, tps};
use std::borrow::Cow;
use std::fmt;

/// A section that may be repeated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Section {
    /// Name.
    pub name: &'static str,
    /// Most of them in a case.
    pub most: usize,
    /// Meaning of one.
    pub help: &'static str,
    /// Meaning of the list.
    pub list_help: &'static str,
    /// Keys that each of them has.
    pub required: &'static [&'static str],
}

/// All sections that may be repeated.
pub static SECTIONS: [Section; 2] = [phase::SECTION, tps::layer::SECTION];

impl Section {
    /// The section to which a key of the list, or of one of them, belongs.
    pub fn of(key: &str) -> Option<&'static Section> {
        SECTIONS.iter().find(|section| section.after(key).is_some())
    }

    /// The section of this name.
    pub fn named(name: &str) -> Option<&'static Section> {
        SECTIONS.iter().find(|section| section.name == name)
    }

    /// The rest of a key after the name of the section and its point.
    pub fn after<'k>(&self, key: &'k str) -> Option<&'k str> {
        key.strip_prefix(self.name)?.strip_prefix('.')
    }

    /// A number as keys spell it; `None` where it is none, or too large.
    pub fn number(&self, text: &str) -> Option<usize> {
        let index: usize = text.parse().ok()?;
        let plain = (1..=self.most).contains(&index) && text == index.to_string();
        plain.then_some(index)
    }
}

/// Key of an input in a case: that of the list, or that of one of a repeated section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Key {
    /// The input.
    pub input: &'static Input,
    number: Option<usize>,
}

impl From<&'static Input> for Key {
    fn from(input: &'static Input) -> Key {
        Key {
            input,
            number: None,
        }
    }
}

impl Key {
    /// The key as a case has it.
    pub fn text(self) -> Cow<'static, str> {
        let key = self.input.key;
        let section = Section::of(key).and_then(|section| Some((section, section.after(key)?)));
        match (self.number, section) {
            (Some(number), Some((section, name))) => {
                Cow::Owned(format!("{}.{number}.{name}", section.name))
            }
            _ => Cow::Borrowed(key),
        }
    }
}

impl fmt::Display for Key {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text())
    }
}

impl Input {
    /// The key in one of a repeated section, counted from 1.
    pub fn of_number(&'static self, number: usize) -> Key {
        Key {
            input: self,
            number: Some(number),
        }
    }
}

/// The number in a key of a repeated section, and the key that stands for it in the list; `None` where the key has none.
pub(super) fn numbered(key: &str) -> Option<(usize, String)> {
    let section = Section::of(key)?;
    let (number, name) = section.after(key)?.split_once('.')?;
    Some((section.number(number)?, format!("{}.{name}", section.name)))
}

/// Key of an input within its section, such as `altitude_m`.
pub fn name(input: &Input) -> &'static str {
    input.key.rsplit('.').next().unwrap_or_default()
}

/// Whether a key of the list stands for that of every one of a repeated section.
pub fn is_repeated(key: &str) -> bool {
    Section::of(key).is_some() && numbered(key).is_none()
}
