//! Warnings as values: remarks on a result, returned with it and never instead of it.

use serde::{Deserialize, Serialize};
use std::fmt;

pub mod range;

/// Severity of a finding.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Severity {
    /// An assumption, or a choice made where data are missing.
    Note,
    /// The model is used outside the range in which it was checked.
    Extrapolated,
    /// A limit of a material or of the design is exceeded: the design should not be used as it is.
    Exceeded,
}

/// A remark on a result: model, quantity, value, and the range in which the model is valid.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Finding {
    /// Severity.
    pub severity: Severity,
    /// Model that the finding is about, such as `tauber-sutton` or `mer pica`.
    pub model: String,
    /// Key of the quantity, as in [`crate::quantity`]; empty if there is none.
    pub key: String,
    /// Value of that quantity in its SI unit (angles in degrees).
    pub value: Option<f64>,
    /// Range in which the model is valid, in the same unit; an open end is `None`.
    pub valid: (Option<f64>, Option<f64>),
    /// Message in one sentence, with the numbers in the units of the source.
    pub message: String,
    /// Source of the limit, such as `NASA/TM-2014-218507, Table 7`.
    pub source: String,
    /// Key of the input that removes the cause, such as `design.forebody_tps`, if there is one.
    pub field: Option<String>,
}

impl Finding {
    /// A note about an input.
    pub fn note(model: &str, input: &dyn fmt::Display, message: impl Into<String>) -> Finding {
        Finding {
            severity: Severity::Note,
            model: model.to_string(),
            key: input.to_string(),
            value: None,
            valid: (None, None),
            message: message.into(),
            source: "convention of this program".to_string(),
            field: Some(input.to_string()),
        }
    }
}

/// Change that the closing rules made to an input.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Adjustment {
    /// Key of the input changed, such as `design.diameter_m`.
    pub key: String,
    /// Requested value, in the unit of the key.
    pub from: f64,
    /// Value used.
    pub to: f64,
    /// The rule and its reason, one sentence.
    pub reason: String,
    /// Source of the rule, such as `NASA/TM-2014-218507, section 3.1.2`.
    pub source: String,
}
