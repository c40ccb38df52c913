//! What the worker does with a job.

use crate::protocol::{Fault, Job, Reply, decode, encode};
use msape::library::DataError;
use msape::{Library, Request, design};

/// Solves jobs with the library that ships with the program.
pub struct Solver {
    library: Library,
}

impl Solver {
    /// A solver.
    ///
    /// # Errors
    /// A data file that cannot be read.
    pub fn new() -> Result<Solver, DataError> {
        let library = Library::builtin()?;
        Ok(Solver { library })
    }

    /// The reply to a job, both as bytes.
    ///
    /// # Errors
    /// Bytes that are no job.
    pub fn answer(&self, job: &[u8]) -> Result<Vec<u8>, postcard::Error> {
        let Job { id, case } = decode(job)?;
        let start_ms = js_sys::Date::now();
        let result = design(&case, &self.library, Request::Steps)
            .map_err(|faults| faults.into_iter().map(Fault::from).collect());
        let duration_ms = js_sys::Date::now() - start_ms;
        encode(&Reply {
            id,
            result,
            duration_ms,
        })
    }
}
