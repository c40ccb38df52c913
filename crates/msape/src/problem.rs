//! A checked case, with types that exclude invalid values.
//!
//! Checking reports every fault at once; after it, physics cannot fail.

mod aero;
mod aerodynamics;
mod attitude;
mod attitude_of_design;
mod center;
mod design;
mod entering;
mod fitted_in_air;
mod flight;
mod forms;
mod freedom;
mod heating;
#[cfg(feature = "ablation")]
pub mod in_depth;
mod materials;
mod outline;
mod phases;
mod planet;

use crate::answer::{Answer, PlanetNames};
use crate::case::{Case, InputError, Reader};
use crate::design::coupling;
use crate::design::inputs::DesignInput;
use crate::design::stability;
use crate::design::structural::Structural;
use crate::finding::Finding;
use crate::flight::Request;
use crate::flight::freedom::Freedom;
use crate::flight::mission::{Body, Mission, Model};
use crate::library::Library;
use crate::progress::{Progress, Unwatched};
use crate::quantity::Job;
use crate::quantity::input;
use crate::vehicle::body::RigidBody;
use phases::Flown;

pub use aero::{AeroProblem, BodyCoefficients};
pub use attitude_of_design::{
    add_turning, asks_for_attitude, attitude_of_design, fly_designed, leaves_vehicle_to_design,
};
pub use outline::rigid_body;

/// A flight that was checked.
#[derive(Clone, Debug)]
pub struct FlightProblem {
    /// Everything but the vehicle.
    pub mission: Mission,
    /// The vehicle.
    pub body: Body,
    /// Outline of the vehicle, if the case has one.
    pub outline: Option<RigidBody>,
    /// Findings of the check.
    pub findings: Vec<Finding>,
}

/// A design that was checked.
#[derive(Clone, Debug)]
pub struct DesignProblem {
    /// Everything that determines the design.
    pub input: DesignInput,
    /// Findings of the check.
    pub findings: Vec<Finding>,
}

impl FlightProblem {
    /// Checks a case for `fly`.
    ///
    /// # Errors
    /// Every fault of the case at once.
    pub fn check(case: &Case, library: &Library) -> Result<FlightProblem, Vec<InputError>> {
        let mut reader = Reader::new(case);
        let mission = flight::mission(&mut reader, library, flight::Angle::Any);
        let outline = outline::outline(&mut reader, library);
        let body = flight::body(&mut reader, library, mission.as_ref(), &outline);
        let flown = match &body {
            Some(body) if matches!(body.freedom, Freedom::Rigid(_)) => Flown::Rigid,
            _ => Flown::Point,
        };
        let phases = phases::phases(&mut reader, flown);
        match mission.zip(body).zip(phases) {
            Some(((mut mission, body), phases)) if reader.faults.is_empty() => {
                if mission.solver.model == Model::AllenEggers {
                    phases::not_flown(&mut reader, "the closed form");
                }
                mission.phases = match mission.solver.model {
                    Model::AllenEggers => Vec::new(),
                    _ => phases,
                };
                if let Freedom::Rigid(rigid) = &body.freedom {
                    freedom::solver(&reader, rigid, &mut mission.solver);
                }
                Ok(FlightProblem {
                    mission,
                    body,
                    outline: outline.body(),
                    findings: reader.into_findings(),
                })
            }
            _ => Err(reader.into_faults()),
        }
    }

    /// Computes the flight.
    pub fn solve(&self, name: &str, request: Request) -> Answer {
        let FlightProblem {
            mission,
            body,
            findings,
            ..
        } = self;
        let (flight, outcome, reason) = crate::flight::fly(mission, body, request);
        let mut findings = findings.clone();
        findings.extend(crate::flight::findings(mission, body, &flight));
        Answer {
            name: name.to_string(),
            planet: PlanetNames::of(&mission.planet),
            outcome,
            reason,
            flight: Some(flight),
            design: None,
            adjustments: Vec::new(),
            findings,
            passes: Vec::new(),
        }
        .of_finite_results(Job::Fly)
    }
}

impl DesignProblem {
    /// Checks a case for `design`.
    ///
    /// # Errors
    /// Every fault of the case at once.
    pub fn check(case: &Case, library: &Library) -> Result<DesignProblem, Vec<InputError>> {
        let mut reader = Reader::new(case);
        phases::not_flown(&mut reader, "a design");
        match design::design(&mut reader, library) {
            Some(input) if reader.faults.is_empty() => Ok(DesignProblem {
                input,
                findings: reader.into_findings(),
            }),
            _ => Err(reader.into_faults()),
        }
    }

    /// Solves the design.
    pub fn solve(&self, name: &str, request: Request) -> Answer {
        self.solve_watched(name, request, &mut Unwatched)
    }

    /// Solves the design; the observer may stop it after a pass, and the vehicle of that pass is the answer.
    pub fn solve_watched(
        &self,
        name: &str,
        request: Request,
        progress: &mut dyn Progress,
    ) -> Answer {
        let mut solution = coupling::solve(&self.input, None, progress).solution(request);
        if let (Some(design), Some(flight)) = (&mut solution.design, &solution.flight) {
            let structural = Structural::new(&self.input, design, flight);
            let findings = structural.findings(&design.vehicle.structure, flight);
            solution.findings.extend(findings);
            design.structural = Some(structural);
            design.stability =
                stability::of_vehicle(&design.vehicle, self.input.mission.heat_capacity_ratio());
            let stable = design.stability.as_ref().map(stability::findings);
            solution.findings.extend(stable.into_iter().flatten());
        }
        solution.findings.extend(self.findings.iter().cloned());
        Answer {
            name: name.to_string(),
            planet: PlanetNames::of(&self.input.mission.planet),
            outcome: solution.outcome,
            reason: solution.reason,
            flight: solution.flight,
            design: solution.design,
            adjustments: solution.adjustments,
            findings: solution.findings,
            passes: solution.passes,
        }
        .of_finite_results(Job::Design)
    }
}

/// Flies a vehicle as it is, or with six degrees of freedom the vehicle of a design.
///
/// # Errors
/// Every fault of the case at once.
///
/// ```
/// use msape::{Answer, Case, Library, Outcome, Request, fly};
///
/// let library = Library::builtin().unwrap();
/// let text = msape::library::data_file("cases/stardust.toml").unwrap();
/// let answer: Answer = fly(&Case::from_text(text).unwrap(), &library, Request::Nothing).unwrap();
/// assert_eq!(answer.outcome, Outcome::Landed);
/// // 32.07 g: data/validation/stardust.toml
/// let peak = answer.flight.unwrap().peak_deceleration_earth_g;
/// assert!((peak.value - 32.07).abs() < 0.15);
/// ```
pub fn fly(case: &Case, library: &Library, request: Request) -> Result<Answer, Vec<InputError>> {
    check_request(request)?;
    if attitude_of_design::flies_design(case) {
        let designed = design(case, library, Request::Nothing)?;
        return fly_designed(case, library, &designed, request);
    }
    let mut problem = FlightProblem::check(case, library);
    if let Err(faults) = &mut problem
        && leaves_vehicle_to_design(case)
    {
        let mass = faults
            .iter_mut()
            .find(|fault| fault.key == input::vehicle::MASS_KG.key);
        if let Some(fault) = mass {
            let dof = &input::vehicle::DOF;
            fault.message.push_str(&format!(
                "; the vehicle of [design] is flown with {dof} = 6"
            ));
        }
    }
    Ok(problem?.solve(&case.name, request))
}

/// Designs a vehicle: geometry, mass, flight, heating, heat shield, soak, structure and impact, coupled.
///
/// # Errors
/// Every fault of the case at once.
///
/// ```
/// use msape::{Case, InputError, Library, Outcome, Request, design};
///
/// let library = Library::builtin().unwrap();
/// let text = msape::library::data_file("cases/galahad.toml").unwrap();
/// let answer = design(&Case::from_text(text).unwrap(), &library, Request::Nothing).unwrap();
/// assert_eq!(answer.outcome, Outcome::Converged);
/// // Margin is on everything but the payload of 3 kg.
/// let mass = answer.design.unwrap().vehicle.mass;
/// assert!(mass.mass_kg > 3.0);
///
/// let mut upwards = Case::run_page();
/// upwards.set("entry.flight_path_angle_deg", "5");
/// let faults: Vec<InputError> = design(&upwards, &library, Request::Nothing).unwrap_err();
/// assert_eq!(faults[0].key, "entry.flight_path_angle_deg");
/// ```
pub fn design(case: &Case, library: &Library, request: Request) -> Result<Answer, Vec<InputError>> {
    design_watched(case, library, request, &mut Unwatched)
}

/// Checks and solves a design like [`design`]; the observer may stop it after a pass, and the vehicle of that pass is the answer.
///
/// # Errors
/// Every fault of the case at once.
pub fn design_watched(
    case: &Case,
    library: &Library,
    request: Request,
    progress: &mut dyn Progress,
) -> Result<Answer, Vec<InputError>> {
    check_request(request)?;
    Ok(DesignProblem::check(case, library)?.solve_watched(&case.name, request, progress))
}

/// Checks the step of a time history.
fn check_request(request: Request) -> Result<(), Vec<InputError>> {
    match request {
        Request::Uniform(step_s) if !(step_s > 0.0 && step_s.is_finite()) => {
            Err(vec![InputError {
                key: "trajectory step".to_string(),
                message: format!("got {step_s} s, must be above 0 s"),
            }])
        }
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::Value;
    use crate::quantity::input::{self, Input, inputs};

    fn shipped(name: &str) -> Case {
        let text = crate::library::data_file(&format!("cases/{name}.toml")).unwrap();
        Case::from_text(text).unwrap()
    }

    /// Whether a check passes, or each of its faults names a key and a reason.
    fn says_why<T>(checked: Result<T, Vec<InputError>>) -> bool {
        let Err(faults) = checked else {
            return true;
        };
        let has_reason = |fault: &InputError| !fault.message.contains("without a reason");
        !faults.is_empty() && faults.iter().all(has_reason)
    }

    /// A case with each input in turn at fault, in four ways.
    fn at_fault(case: &Case) -> impl Iterator<Item = (&'static Input, Case)> {
        let values = [
            Value::Other("{}".to_string()),
            Value::Number(f64::NAN),
            Value::Text("no such thing".to_string()),
            Value::Rows(vec![vec![0.0]]),
        ];
        inputs().flat_map(move |input| {
            values.clone().map(|value| {
                let mut case = case.clone();
                case.values.insert(input::canonical_key(input.key), value);
                (input, case)
            })
        })
    }

    #[test]
    fn a_refusal_says_why_whatever_input_is_at_fault() {
        let library = Library::builtin().unwrap();
        let phased = "stardust-parachutes";
        for case in [phased, "backward-entry", "galahad", "msr-eev-cp"].map(shipped) {
            for (input, case) in at_fault(&case) {
                assert!(says_why(FlightProblem::check(&case, &library)), "{input}");
                assert!(says_why(DesignProblem::check(&case, &library)), "{input}");
                assert!(says_why(AeroProblem::check(&case, &library)), "{input}");
            }
        }
        let key = input::canonical_key(input::phase::ALTITUDE_M.key);
        let mut phased = shipped(phased);
        phased.values.insert(key.clone(), Value::Number(f64::NAN));
        let faults = FlightProblem::check(&phased, &library).unwrap_err();
        assert!(faults.iter().any(|fault| fault.key == key), "{faults:?}");
    }

    #[test]
    fn a_refusal_of_the_attitude_of_a_design_says_why_whatever_input_is_at_fault() {
        let library = Library::builtin().unwrap();
        let mut case = shipped("msr-eev-cp");
        let answer = design(&case, &library, Request::Nothing).unwrap();
        let designed = answer.design.unwrap();
        case.set(input::vehicle::DOF.key, "6");
        for (input, case) in at_fault(&case) {
            let checked = attitude_of_design(&case, &library, &designed);
            assert!(says_why(checked), "{input}");
        }
    }

    #[test]
    fn a_name_that_is_made_up_is_refused_with_those_that_are_there() {
        let library = Library::builtin().unwrap();
        let said = |case: &str, input: &Input, name: &str| -> String {
            let mut case = shipped(case);
            case.set(input.key, name);
            let faults: Vec<String> = match case.gives_any(input::design::INPUTS) {
                true => DesignProblem::check(&case, &library).unwrap_err(),
                false => FlightProblem::check(&case, &library).unwrap_err(),
            }
            .iter()
            .map(ToString::to_string)
            .collect();
            faults.join("\n")
        };
        let heating = said("stardust", &input::heating::CONVECTIVE, "fay-riddell");
        assert_eq!(
            heating,
            "heating.convective: got \"fay-riddell\", must be one of sutton-graves, brandis-johnston"
        );
        let concept = said("galahad", &input::design::FOREBODY_TPS, "unobtainium");
        let known = "design.forebody_tps: got \"unobtainium\", must be one of ";
        assert!(
            concept.starts_with(known) && concept.contains("pica-al-5056"),
            "{concept}"
        );
    }

    #[test]
    fn the_check_of_a_question_for_coefficients_designs_nothing() {
        let library = Library::builtin().unwrap();
        // no vehicle closes about this payload: the design finds it, the check does not
        let mut case = Case::run_page();
        case.set(input::design::PAYLOAD_DIAMETER_RATIO.key, "0.95");
        let problem = AeroProblem::check(&case, &library).unwrap();
        let faults = problem.solve().map(|_| ()).unwrap_err();
        assert!(faults[0].message.contains("does not close"), "{faults:?}");
    }
}
