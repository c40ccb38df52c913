//! The answer of the program: outcome, numbers, adjustments, findings, the record of the passes.

mod json;
pub mod landing;
pub mod output;
#[cfg(test)]
pub(crate) mod sample;
pub mod surface;
pub mod turning;

pub use json::{json, text, write};
pub use output::{Output, outputs};

use crate::design::{Design, Pass};
use crate::finding::{Adjustment, Finding};
use crate::flight::Flight;
use crate::outcome::Outcome;
use crate::planet::Planet;
use crate::quantity::Job;
use serde::{Deserialize, Serialize};

/// The planet of an answer, by its names.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct PlanetNames {
    /// Name for people.
    pub title: String,
    /// Name in KML, where viewers know the body.
    pub kml_target: Option<String>,
}

impl PlanetNames {
    /// The names of a planet.
    pub fn of(planet: &Planet) -> Self {
        Self {
            title: planet.title.clone(),
            kml_target: planet.kml_target.clone(),
        }
    }
}

/// The answer to a case.
///
/// ```
/// use msape::answer::output;
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
    /// The planet.
    pub planet: PlanetNames,
    /// Outcome: how the computation ended.
    pub outcome: Outcome,
    /// Reason for the outcome in one sentence, where it needs one.
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

impl Answer {
    /// This answer, with the outcome [`Outcome::GaveUp`] if one of its results is not a finite number.
    pub(crate) fn of_finite_results(mut self, job: Job) -> Self {
        let wild = outputs(job)
            .find(|output| (output.get)(&self).is_some_and(|number| !number.is_finite()));
        if let Some(output) = wild
            && self.outcome != Outcome::GaveUp
        {
            self.outcome = Outcome::GaveUp;
            self.reason = Some(format!("{} is not a finite number", output.key));
        }
        self
    }
}
