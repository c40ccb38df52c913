//! Checks a request for the coefficients of a body: a case with an outline, or a design.

use super::DesignProblem;
use super::aerodynamics::{Coefficients, Medium, named_drag};
use super::forms::one_row;
use super::outline::rigid_body;
use crate::aero::database::Database;
use crate::aero::standard::AeroBody;
use crate::case::{Case, InputError, Reader};
use crate::finding::Finding;
use crate::flight::Request;
use crate::library::Library;
use crate::quantity::input;

/// A body and the database of its coefficients.
pub type BodyCoefficients = (AeroBody, Database);

/// A checked request for coefficients.
#[derive(Clone, Debug)]
pub struct AeroProblem {
    body: Body,
    /// Center of gravity that the case gives, m, in the place of that of a design.
    cg_m: Option<[f64; 3]>,
    coefficients: Coefficients,
    /// Findings of the check.
    pub findings: Vec<Finding>,
}

/// Body whose coefficients are requested.
#[derive(Clone, Debug)]
enum Body {
    /// An outline.
    Known(Box<AeroBody>),
    /// The vehicle of a design of this name.
    Designed(String, Box<DesignProblem>),
}

impl Body {
    /// Largest diameter, m; for a design the requested one.
    fn diameter_m(&self) -> f64 {
        match self {
            Body::Known(body) => body.surface.diameter_m(),
            Body::Designed(_, problem) => problem.input.vehicle.diameter_m,
        }
    }
}

impl AeroProblem {
    /// Checks a case for `aero`.
    ///
    /// # Errors
    /// Every fault of the case at once.
    pub fn check(case: &Case, library: &Library) -> Result<AeroProblem, Vec<InputError>> {
        let mut reader = Reader::new(case);
        let cg_m = one_row::<3>(&mut reader, &input::vehicle::CG_M).flatten();
        let body = match rigid_body(case, library) {
            Ok(Some(body)) => Some(Body::Known(Box::new(AeroBody::of_rigid(&body, cg_m)))),
            Ok(None) => designed(case, library, &mut reader),
            Err(faults) => {
                reader.faults.retain(|fault| !faults.contains(fault));
                reader.faults.extend(faults);
                None
            }
        };
        // the check of the design has already reported the faults of the planet
        let medium = match reader.faults.is_empty() {
            true => Medium::of_case(&mut reader, library),
            false => None,
        };
        let gamma = medium.as_ref().map(|medium| medium.heat_capacity_ratio);
        let drag = named_drag(&mut reader, library, gamma);
        let coefficients = body.as_ref().zip(medium).and_then(|(body, medium)| {
            let diameter_m = body.diameter_m();
            Coefficients::read(&mut reader, library, &medium, diameter_m, drag.as_ref())
        });
        match body.zip(coefficients) {
            Some((body, coefficients)) if reader.faults.is_empty() => Ok(AeroProblem {
                body,
                cg_m,
                coefficients,
                findings: reader.into_findings(),
            }),
            _ => Err(reader.into_faults()),
        }
    }

    /// Ratio of the heat capacities of the gas for which the coefficients are computed; that of air where they are a table.
    pub fn heat_capacity_ratio(&self) -> f64 {
        self.coefficients.heat_capacity_ratio()
    }

    /// Designs the vehicle where there is one to design, and makes its database.
    ///
    /// # Errors
    /// Reason why there is no vehicle, or no table at its diameter.
    pub fn solve(&self) -> Result<BodyCoefficients, Vec<InputError>> {
        let body = match &self.body {
            Body::Known(body) => body.as_ref().clone(),
            Body::Designed(name, problem) => {
                let answer = problem.solve(name, Request::Nothing);
                let reason = answer.reason.unwrap_or_default();
                let design = answer.design.ok_or_else(|| {
                    vec![InputError {
                        key: "design".to_string(),
                        message: format!("the vehicle does not close: {reason}"),
                    }]
                })?;
                AeroBody::of_vehicle(&answer.name, &design.vehicle).with_cg(self.cg_m)
            }
        };
        let fault = |message: String| InputError {
            key: input::vehicle::AERODYNAMICS_TABLE.to_string(),
            message,
        };
        match self.coefficients.of(&body) {
            Ok(database) => Ok((body, database)),
            Err(faults) => Err(faults.into_iter().map(fault).collect()),
        }
    }
}

/// The design of the case, checked.
fn designed(case: &Case, library: &Library, reader: &mut Reader) -> Option<Body> {
    if !case.gives_any(input::design::INPUTS) {
        reader.fault(
            &"outline",
            "missing; give [outline], as a preset, by dimensions or by points, or the case of a design",
        );
        return None;
    }
    if !reader.faults.is_empty() {
        return None;
    }
    match DesignProblem::check(case, library) {
        Ok(problem) => Some(Body::Designed(case.name.clone(), Box::new(problem))),
        Err(faults) => {
            reader.faults.extend(faults);
            None
        }
    }
}

#[cfg(test)]
mod tests {
    use super::AeroProblem;
    use crate::finding::Finding;
    use crate::problem::{DesignProblem, FlightProblem};
    use crate::quantity::input::inputs;
    use crate::{Case, Library};

    fn case(name: &str, changes: &[(&str, &str)]) -> Case {
        let text = crate::library::data_file(name).unwrap();
        let mut case = Case::from_text(text).unwrap();
        for (key, value) in changes {
            case.set(key, value);
        }
        case
    }

    #[test]
    fn the_center_of_gravity_is_that_of_the_design_unless_the_case_gives_one() {
        let library = Library::builtin().unwrap();
        let cg_m = |changes: &[(&str, &str)]| {
            let case = case("cases/galahad.toml", changes);
            let problem = AeroProblem::check(&case, &library).unwrap();
            problem.solve().unwrap().0.cg_m.unwrap()
        };
        let [x_m, y_m, z_m] = cg_m(&[]);
        assert!(x_m > 0.05 && (y_m, z_m) == (0.0, 0.0), "{x_m}");
        let given = [("vehicle.cg_m", "[0.04, 0.0, 0.01]")];
        assert_eq!(cg_m(&given), [0.04, 0.0, 0.01]);
    }

    #[test]
    fn a_file_that_nobody_read_is_no_file_passed_over() {
        let library = Library::builtin().unwrap();
        let files = inputs().filter(|input| !input.tables.is_empty());
        for file in files {
            let case = case("cases/galahad.toml", &[(file.key, "mine.csv")]);
            let faults = [
                DesignProblem::check(&case, &library).err(),
                AeroProblem::check(&case, &library).err(),
            ];
            for faults in faults {
                let mut faults = faults.into_iter().flatten();
                let told = faults.any(|f| f.key == file.key && f.message.contains("was not read"));
                assert!(told, "{file}");
            }
        }
    }

    fn of_air(findings: &[Finding]) -> Option<&str> {
        let mut findings = findings.iter();
        let found = findings.find(|finding| finding.key == "heat_capacity_ratio")?;
        Some(&found.model)
    }

    #[test]
    fn what_was_fitted_in_air_is_told_in_another_gas() {
        let library = Library::builtin().unwrap();
        let stardust = "cases/stardust.toml";
        for planet in ["mars", "earth"] {
            let there = [
                ("entry.planet", planet),
                ("entry.atmosphere", "planet"),
                ("entry.radius_m", ""),
                ("entry.altitude_m", "120000"),
                ("heating.radiative", "none"),
                ("vehicle.drag_coefficient", ""),
            ];
            let told = |model: &'static str| (planet == "mars").then_some(model);
            for (key, value, model) in [
                (
                    "vehicle.aerodynamics",
                    "sphere-cone-70",
                    "axial force by name",
                ),
                ("outline.preset", "stardust", "axial force of the outline"),
            ] {
                let case = case(stardust, &[&there[..], &[(key, value)]].concat());
                let problem = FlightProblem::check(&case, &library).unwrap();
                assert_eq!(of_air(&problem.findings), told(model), "{planet} {key}");
            }
            for (name, model) in [
                ("mmeev-60", "axial force by name"),
                ("outline", "axial force of the outline"),
            ] {
                let of_design = [("design.aerodynamics", name)];
                let case = case(
                    "cases/galahad.toml",
                    &[&there[..5], &of_design[..]].concat(),
                );
                let problem = DesignProblem::check(&case, &library).unwrap();
                assert_eq!(of_air(&problem.findings), told(model), "{planet} {name}");
            }
            for (name, model) in [
                ("sphere-cone-70", "axial force by name"),
                ("", "axial force of the outline"),
            ] {
                let more = [
                    ("outline.preset", "stardust"),
                    ("vehicle.aerodynamics", name),
                ];
                let case = case(stardust, &[&there[..], &more[..]].concat());
                let findings = AeroProblem::check(&case, &library).unwrap().findings;
                assert_eq!(of_air(&findings), told(model), "{planet} aero {name}");
            }
        }
    }
}
