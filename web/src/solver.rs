//! Solver of cases, run in the worker.

use crate::catalog::Catalog;
use crate::clock::now_ms;
use crate::protocol::{Fault, Job, News, Reply, decode, encode};
use msape::library::DataError;
use msape::{Library, Request, design};

/// Solver with the built-in library.
pub struct Solver {
    library: Library,
}

impl Solver {
    /// A new solver.
    ///
    /// # Errors
    /// A data file that cannot be read.
    pub fn new() -> Result<Solver, DataError> {
        let library = Library::builtin()?;
        Ok(Solver { library })
    }

    /// The first message, as bytes.
    ///
    /// # Errors
    /// Errors of postcard.
    pub fn ready(&self) -> Result<Vec<u8>, postcard::Error> {
        encode(&News::Ready(Box::new(Catalog::of(&self.library))))
    }

    /// Result of a job, both as bytes.
    ///
    /// # Errors
    /// Bytes that are not a job.
    pub fn solve(&self, job: &[u8]) -> Result<Vec<u8>, postcard::Error> {
        let Job { id, case } = decode(job)?;
        let start_ms = now_ms();
        let result = design(&case, &self.library, Request::Steps)
            .map_err(|faults| faults.into_iter().map(Fault::from).collect());
        encode(&News::Solved(Box::new(Reply {
            id,
            result,
            duration_ms: now_ms() - start_ms,
        })))
    }
}
