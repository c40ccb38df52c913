//! What the worker does with a question.

use crate::clock::now_ms;
use crate::protocol::{Ask, Batch, Fault, Job, Reply, Told, decode, encode};
use msape::benchmark::{Bench, JOBS};
use msape::library::DataError;
use msape::{Case, Library, Request, design, fly};
use std::cell::OnceCell;

/// Solves jobs with the library that ships with the program.
pub struct Solver {
    library: Library,
    /// Made when it is first asked for.
    bench: OnceCell<Result<Bench, DataError>>,
}

impl Solver {
    /// A solver.
    ///
    /// # Errors
    /// A data file that cannot be read.
    pub fn new() -> Result<Solver, DataError> {
        let library = Library::builtin()?;
        let bench = OnceCell::new();
        Ok(Solver { library, bench })
    }

    /// The reply to a question, both as bytes.
    ///
    /// # Errors
    /// Bytes that are no question.
    pub fn answer(&self, ask: &[u8]) -> Result<Vec<u8>, postcard::Error> {
        encode(&match decode(ask)? {
            Ask::Solve(job) => Told::Solved(Box::new(self.solve(job))),
            Ask::Measure(batch) => Told::Measured(self.measure(batch)),
            Ask::Fly(case) => Told::Flown(Box::new(self.fly(&case))),
        })
    }

    fn solve(&self, Job { id, case }: Job) -> Reply {
        let start_ms = now_ms();
        let result = design(&case, &self.library, Request::Steps)
            .map_err(|faults| faults.into_iter().map(Fault::from).collect());
        let duration_ms = now_ms() - start_ms;
        Reply {
            id,
            result,
            duration_ms,
        }
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
        (0..repetitions).for_each(|_| (job.run)(bench));
        Ok(now_ms() - start_ms)
    }
}
