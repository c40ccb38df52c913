//! Flights of a design with six degrees of freedom.

use crate::desk::Desk;
use crate::protocol::{Fault, Question, Refusal, faults};
use msape::design::Design;
use msape::flight::Flight;
use msape::flight::six_dof::turning::{Start, Turn, turn};
use msape::problem::{FlightProblem, attitude_of_design, fly_designed};
use msape::progress::Progress;
use msape::quantity::input;
use msape::{Answer, Case, Request};
use serde::{Deserialize, Serialize};

/// Number of rows of an attitude history: oscillations of several Hz over minutes.
const ATTITUDE_ROWS: f64 = 8000.0;

/// Case and its design from the solver.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Designed {
    /// The case.
    pub case: Case,
    /// Design, with the flight of its point mass.
    pub answer: Answer,
}

impl Designed {
    /// Vehicle of the design and the flight of its point mass.
    fn vehicle(&self) -> Result<(&Design, &Flight), Vec<Fault>> {
        let vehicle = self.answer.design.as_ref().zip(self.answer.flight.as_ref());
        vehicle.ok_or_else(|| {
            vec![Fault {
                key: input::vehicle::DOF.to_string(),
                message: "the design has no vehicle that could fly".to_string(),
            }]
        })
    }
}

/// Asks for the flight of a design with attitude.
#[derive(Debug, Serialize, Deserialize)]
pub struct Attitude(pub Box<Designed>);

impl Question for Attitude {
    type Answer = Answer;
    type Refusal = Vec<Fault>;

    fn answer(self, desk: &Desk, _: &mut dyn Progress) -> Result<Answer, Vec<Fault>> {
        let (_, flight) = self.0.vehicle()?;
        let step_s = (flight.time_of_flight_s / ATTITUDE_ROWS).clamp(0.01, 10.0);
        let Designed { case, answer } = &*self.0;
        fly_designed(case, &desk.library, answer, Request::Uniform(step_s)).map_err(faults)
    }
}

/// Asks for one entry of a design from a set of attitudes and rates, by its index in the set.
#[derive(Debug, Serialize, Deserialize)]
pub struct Turning(pub Box<Designed>, pub u32);

impl Question for Turning {
    type Answer = Turn;
    type Refusal = Vec<Fault>;

    fn answer(self, desk: &Desk, progress: &mut dyn Progress) -> Result<Turn, Vec<Fault>> {
        let Turning(designed, number) = self;
        let (design, _) = designed.vehicle()?;
        let FlightProblem { mission, body, .. } =
            attitude_of_design(&designed.case, &desk.library, design).map_err(faults)?;
        let start = Start::all().get(number as usize).copied();
        let turned = start.and_then(|start| turn(&mission, &body, start, progress));
        turned.ok_or_else(|| Refusal::of_worker(format!("there is no entry {number}")))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use msape::progress::Unwatched;
    use msape::{Library, design, fly};

    /// A design that flies with six degrees of freedom.
    fn designed(library: &Library) -> Designed {
        let mut case = Case::run_page();
        case.set("vehicle.dof", "6");
        let answer = design(&case, library, Request::Steps).unwrap();
        Designed { case, answer }
    }

    fn attitude(designed: &Designed, desk: &Desk) -> Result<Answer, Vec<Fault>> {
        Attitude(Box::new(designed.clone())).answer(desk, &mut Unwatched)
    }

    fn turned(designed: &Designed, number: u32, desk: &Desk) -> Result<Turn, Vec<Fault>> {
        Turning(Box::new(designed.clone()), number).answer(desk, &mut Unwatched)
    }

    #[test]
    fn the_vehicle_that_flies_is_the_one_that_the_solver_designed() {
        let desk = Desk::new(Library::builtin().unwrap());
        let mut designed = designed(&desk.library);
        let flown = attitude(&designed, &desk).unwrap();
        let own = fly(&designed.case, &desk.library, Request::Nothing).unwrap();
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
        let heavier = attitude(&designed, &desk).unwrap();
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
        let first = turned(&designed, 0, &desk).unwrap();
        assert_eq!(first.start, Start::all()[0]);
    }

    #[test]
    fn a_design_without_a_vehicle_and_an_entry_that_is_not_there_are_told() {
        let desk = Desk::new(Library::builtin().unwrap());
        let mut designed = designed(&desk.library);
        let none = turned(&designed, 999, &desk).unwrap_err();
        assert_eq!(none[0].message, "there is no entry 999");
        designed.answer.design = None;
        let faults = attitude(&designed, &desk).unwrap_err();
        assert!(faults[0].message.contains("no vehicle"), "{faults:?}");
    }
}
