//! What the program answers: outcome, numbers, adjustments, findings, the record of the passes.

mod json;
#[cfg(test)]
pub(crate) mod sample;

pub use json::{json, text};

use crate::design::Design;
use crate::finding::{Adjustment, Finding};
use crate::flight::Flight;
use serde::{Deserialize, Serialize};

/// How a flight or a design ended. None of them is an error.
///
/// ```
/// assert_eq!(msape::Outcome::NotClosed.name(), "not-closed");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Outcome {
    /// The design closed and its mass settled.
    Converged,
    /// The flight reached the ground.
    Landed,
    /// The flight was ended at a time or height that the case asks for.
    Stopped,
    /// The vehicle left the atmosphere faster than escape speed.
    SkippedOut,
    /// The vehicle left the atmosphere again on a bound orbit.
    Captured,
    /// The payload fits into no vehicle that the rules allow.
    NotClosed,
    /// The mass had not settled after the last pass.
    NotConverged,
}

impl Outcome {
    /// Name as in files and tables.
    pub fn name(self) -> &'static str {
        match self {
            Outcome::Converged => "converged",
            Outcome::Landed => "landed",
            Outcome::Stopped => "stopped",
            Outcome::SkippedOut => "skipped-out",
            Outcome::Captured => "captured",
            Outcome::NotClosed => "not-closed",
            Outcome::NotConverged => "not-converged",
        }
    }
}

/// One pass of the coupling through the modules.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Pass {
    /// Number of the pass, from 1.
    pub number: u32,
    /// Model of flight used: `allen-eggers` or `three-dof`.
    pub flight_model: String,
    /// Values that cross between the modules, by key of [`crate::design::crossings::CROSSINGS`].
    pub crossings: Vec<f64>,
    /// Entry mass, kg.
    pub mass_kg: f64,
    /// Change of the entry mass since the pass before, kg; absent in the first.
    pub mass_change_kg: Option<f64>,
}

/// The answer to a case.
///
/// ```
/// use msape::quantity::output;
/// use msape::{Case, Library, Request, design};
///
/// let library = Library::builtin().unwrap();
/// let text = msape::library::data_file("cases/galahad.toml").unwrap();
/// let answer = design(&Case::from_text(text).unwrap(), &library, Request::Nothing).unwrap();
/// let mass = output::find("total_entry_mass_kg").unwrap();
/// println!("{}: {:?} {}", mass.label, (mass.get)(&answer), mass.unit);
/// for finding in &answer.findings {
///     println!("{}: {}", finding.model, finding.message);
/// }
/// # assert!((mass.get)(&answer).is_some_and(|kg| kg > 3.0));
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Answer {
    /// Name of the case.
    pub name: String,
    /// How it ended.
    pub outcome: Outcome,
    /// Why, in one sentence, where the outcome needs one.
    pub reason: Option<String>,
    /// The flight, if there was one.
    pub flight: Option<Flight>,
    /// The designed vehicle, if there is one.
    pub design: Option<Design>,
    /// Inputs that the closing rules changed.
    pub adjustments: Vec<Adjustment>,
    /// Remarks on models, limits and assumptions.
    pub findings: Vec<Finding>,
    /// The passes of the coupling.
    pub passes: Vec<Pass>,
}
