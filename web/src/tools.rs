//! Toolbox: occasional tasks of the page, in a worker that is loaded on first use.

mod read;

use crate::aerodynamics::{self, Kept};
use crate::clock::now_ms;
use crate::protocol::{Ask, Batch, Designed, Fault, Told, decode, encode};
use benchmark::{Bench, JOBS};
use cad::export::Info;
use msape::design::Design;
use msape::flight::Flight;
use msape::flight::six_dof::turning::{Start, Turn, turn};
use msape::library::DataError;
use msape::problem::{FlightProblem, attitude_of_design, fly_designed};
use msape::progress::Unwatched;
use msape::quantity::input;
use msape::{Answer, Case, InputError, Library, Request, fly};
use std::cell::OnceCell;

/// Number of rows of an attitude history: oscillations of several Hz over minutes.
const ATTITUDE_ROWS: f64 = 8000.0;

/// Answers questions with the built-in library.
pub struct Toolbox {
    library: Library,
    /// Benchmark jobs, created on first use.
    bench: OnceCell<Result<Bench, DataError>>,
    /// Cache of the last aerodynamic database.
    aerodynamics: Kept,
}

impl Toolbox {
    /// A new toolbox.
    ///
    /// # Errors
    /// A data file that cannot be read.
    pub fn new() -> Result<Toolbox, DataError> {
        Ok(Toolbox {
            library: Library::builtin()?,
            bench: OnceCell::new(),
            aerodynamics: Kept::default(),
        })
    }

    /// Answer to a question, both as bytes.
    ///
    /// # Errors
    /// Bytes that are not a question.
    pub fn answer(&self, ask: &[u8]) -> Result<Vec<u8>, postcard::Error> {
        encode(&match decode(ask)? {
            Ask::Measure(batch) => Told::Measured(self.measure(batch)),
            Ask::Fly(case) => Told::Flown(Box::new(self.fly(&case))),
            Ask::Aerodynamics(question) => Told::Aerodynamics(Box::new(aerodynamics::curves(
                &question,
                &self.library,
                &self.aerodynamics,
            ))),
            Ask::Attitude(designed) => Told::Flown(Box::new(self.attitude(&designed))),
            Ask::Turn(designed, number) => Told::Turned(Box::new(self.turn(&designed, number))),
            Ask::Read(kind, bytes) => Told::Read(read::read(&kind, &bytes, &self.library)),
            Ask::Write(format, model) => Told::Written(format.write(&model, &Info::default())),
        })
    }

    /// Flight of a design with attitude.
    fn attitude(&self, designed: &Designed) -> Result<Answer, Vec<Fault>> {
        let (_, flight) = vehicle(designed)?;
        let step_s = (flight.time_of_flight_s / ATTITUDE_ROWS).clamp(0.01, 10.0);
        let Designed { case, answer } = designed;
        fly_designed(case, &self.library, answer, Request::Uniform(step_s)).map_err(faults)
    }

    /// One entry of a design from a set of attitudes and rates.
    fn turn(&self, designed: &Designed, number: u32) -> Result<Turn, Vec<Fault>> {
        let (design, _) = vehicle(designed)?;
        let FlightProblem { mission, body, .. } =
            attitude_of_design(&designed.case, &self.library, design).map_err(faults)?;
        let start = Start::all().get(number as usize).copied();
        let turned = start.and_then(|start| turn(&mission, &body, start, &mut Unwatched));
        turned.ok_or_else(|| {
            vec![Fault {
                key: String::new(),
                message: format!("there is no entry {number}"),
            }]
        })
    }

    fn fly(&self, case: &Case) -> Result<msape::Answer, Vec<Fault>> {
        fly(case, &self.library, Request::Steps).map_err(faults)
    }

    fn measure(&self, Batch { job, repetitions }: Batch) -> Result<f64, String> {
        let bench = self.bench.get_or_init(Bench::new);
        let bench = bench.as_ref().map_err(DataError::to_string)?;
        let job = JOBS.get(job as usize).ok_or("there is no such job")?;
        let start_ms = now_ms();
        (0..repetitions).for_each(|_| job(bench));
        Ok(now_ms() - start_ms)
    }
}

/// Vehicle of a design and the flight of its point mass.
fn vehicle(designed: &Designed) -> Result<(&Design, &Flight), Vec<Fault>> {
    let answer = &designed.answer;
    let vehicle = answer.design.as_ref().zip(answer.flight.as_ref());
    vehicle.ok_or_else(|| {
        vec![Fault {
            key: input::vehicle::DOF.to_string(),
            message: "the design has no vehicle that could fly".to_string(),
        }]
    })
}

fn faults(faults: Vec<InputError>) -> Vec<Fault> {
    faults.into_iter().map(Fault::from).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use msape::design;

    /// A design that flies with six degrees of freedom.
    fn designed(library: &Library) -> Designed {
        let mut case = Case::run_page();
        case.set("vehicle.dof", "6");
        let answer = design(&case, library, Request::Steps).unwrap();
        Designed { case, answer }
    }

    #[test]
    fn the_vehicle_that_flies_is_the_one_that_the_solver_designed() {
        let toolbox = Toolbox::new().unwrap();
        let mut designed = designed(&toolbox.library);
        let flown = toolbox.attitude(&designed).unwrap();
        let own = fly(&designed.case, &toolbox.library, Request::Nothing).unwrap();
        let peak = |answer: &Answer| answer.flight.as_ref().unwrap().peak_deceleration_earth_g;
        assert_eq!(peak(&flown).value, peak(&own).value);
        // a changed mass, which no design has, changes the flight: the vehicle is not designed again
        designed
            .answer
            .design
            .as_mut()
            .unwrap()
            .vehicle
            .mass
            .mass_kg *= 2.0;
        let heavier = toolbox.attitude(&designed).unwrap();
        assert_ne!(peak(&heavier).value, peak(&own).value);
        let said = &heavier.findings.last().unwrap().message;
        let mass_kg = designed
            .answer
            .design
            .as_ref()
            .unwrap()
            .vehicle
            .mass
            .mass_kg;
        assert!(said.contains(&format!("{mass_kg:.3} kg")), "{said}");
        let turned = toolbox.turn(&designed, 0).unwrap();
        assert_eq!(turned.start, Start::all()[0]);
    }

    #[test]
    fn a_design_without_a_vehicle_and_an_entry_that_is_not_there_are_told() {
        let toolbox = Toolbox::new().unwrap();
        let mut designed = designed(&toolbox.library);
        let none = toolbox.turn(&designed, 999).unwrap_err();
        assert_eq!(none[0].message, "there is no entry 999");
        designed.answer.design = None;
        let faults = toolbox.attitude(&designed).unwrap_err();
        assert!(faults[0].message.contains("no vehicle"), "{faults:?}");
    }
}
