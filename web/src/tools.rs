//! What the toolbox does: what the page asks for now and then, in a worker that is fetched on first use.

mod read;

use crate::aerodynamics::{self, Kept};
use crate::clock::now_ms;
use crate::protocol::{Ask, Batch, Fault, Told, decode, encode};
use benchmark::{Bench, JOBS};
use cad::export::Info;
use msape::design::Design;
use msape::flight::Flight;
use msape::flight::six_dof::turning::{Start, Turn, turn};
use msape::library::DataError;
use msape::problem::{FlightProblem, attitude_of_design, fly_designed};
use msape::progress::Unwatched;
use msape::{Answer, Case, InputError, Library, Request, design, fly};
use std::cell::{OnceCell, RefCell};

/// Rows of a history of attitude: it turns several times a second for minutes.
const ATTITUDE_ROWS: f64 = 8000.0;

/// Answers questions with the library that ships with the program.
pub struct Toolbox {
    library: Library,
    /// Made when it is first asked for.
    bench: OnceCell<Result<Bench, DataError>>,
    /// The answer to the last case of a design.
    designed: RefCell<Option<(Case, Answer)>>,
    /// The database that was last asked for.
    aerodynamics: Kept,
}

impl Toolbox {
    /// A toolbox.
    ///
    /// # Errors
    /// A data file that cannot be read.
    pub fn new() -> Result<Toolbox, DataError> {
        Ok(Toolbox {
            library: Library::builtin()?,
            bench: OnceCell::new(),
            designed: RefCell::default(),
            aerodynamics: Kept::default(),
        })
    }

    /// The answer to a question, both as bytes.
    ///
    /// # Errors
    /// Bytes that are no question.
    pub fn answer(&self, ask: &[u8]) -> Result<Vec<u8>, postcard::Error> {
        encode(&match decode(ask)? {
            Ask::Measure(batch) => Told::Measured(self.measure(batch)),
            Ask::Fly(case) => Told::Flown(Box::new(self.fly(&case))),
            Ask::Aerodynamics(question) => Told::Aerodynamics(Box::new(aerodynamics::curves(
                &question,
                &self.library,
                &self.aerodynamics,
            ))),
            Ask::Attitude(case) => Told::Flown(Box::new(self.attitude(&case))),
            Ask::Turn(case, number) => Told::Turned(Box::new(self.turn(&case, number))),
            Ask::Read(kind, bytes) => Told::Read(read::read(&kind, &bytes, &self.library)),
            Ask::Write(format, model) => Told::Written(format.write(&model, &Info::default())),
        })
    }

    /// What is wanted of a design that has a vehicle, which is solved anew only for another case.
    fn with_designed<T>(
        &self,
        case: &Case,
        wanted: impl FnOnce(&Answer, &Design, &Flight) -> Result<T, Vec<InputError>>,
    ) -> Result<T, Vec<Fault>> {
        let faults =
            |faults: Vec<InputError>| faults.into_iter().map(Fault::from).collect::<Vec<_>>();
        let mut designed = self.designed.borrow_mut();
        if designed.as_ref().is_none_or(|(of, _)| of != case) {
            let answer = design(case, &self.library, Request::Steps).map_err(faults)?;
            *designed = Some((case.clone(), answer));
        }
        let vehicle = designed.as_ref().and_then(|(_, answer)| {
            Some((answer, answer.design.as_ref()?, answer.flight.as_ref()?))
        });
        match vehicle {
            Some((answer, vehicle, flight)) => wanted(answer, vehicle, flight).map_err(faults),
            None => Err(vec![Fault {
                key: "vehicle.dof".to_string(),
                message: "the design has no vehicle that could fly".to_string(),
            }]),
        }
    }

    /// The flight of a design with its attitude.
    fn attitude(&self, case: &Case) -> Result<Answer, Vec<Fault>> {
        self.with_designed(case, |answer, _, flight| {
            let step_s = (flight.time_of_flight_s / ATTITUDE_ROWS).clamp(0.01, 10.0);
            fly_designed(case, &self.library, answer, Request::Uniform(step_s))
        })
    }

    /// One entry of a design from a set of attitudes and rates.
    fn turn(&self, case: &Case, number: u32) -> Result<Turn, Vec<Fault>> {
        let turned = self.with_designed(case, |_, vehicle, _| {
            let FlightProblem { mission, body, .. } =
                attitude_of_design(case, &self.library, vehicle)?;
            let start = Start::all().get(number as usize).copied();
            Ok(start.and_then(|start| turn(&mission, &body, start, &mut Unwatched)))
        })?;
        turned.ok_or_else(|| {
            vec![Fault {
                key: String::new(),
                message: format!("there is no entry {number}"),
            }]
        })
    }

    fn fly(&self, case: &Case) -> Result<msape::Answer, Vec<Fault>> {
        fly(case, &self.library, Request::Steps)
            .map_err(|faults| faults.into_iter().map(Fault::from).collect())
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
