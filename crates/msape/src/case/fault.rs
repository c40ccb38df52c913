//! Faults of a check.

use std::fmt;

/// A fault of the input: key, value given, values allowed.
///
/// ```
/// use msape::{Case, Library, Request, fly};
///
/// let library = Library::builtin().unwrap();
/// let mut case = Case::default();
/// case.set("entry.speed_m_s", "-1");
/// let faults = fly(&case, &library, Request::Nothing).unwrap_err();
/// let speed = faults.iter().find(|fault| fault.key == "entry.speed_m_s").unwrap();
/// assert_eq!(speed.to_string(), "entry.speed_m_s: got -1 m/s, must be 0 to 100000 m/s");
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct InputError {
    /// Dotted key; empty when the whole file is at fault.
    pub key: String,
    /// Message: the value given and the values allowed, with range and unit.
    pub message: String,
}

impl fmt::Display for InputError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.key.is_empty() {
            f.write_str(&self.message)
        } else {
            write!(f, "{}: {}", self.key, self.message)
        }
    }
}

impl std::error::Error for InputError {}
