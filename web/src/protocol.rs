//! Messages between the page and its two workers, as postcard bytes; both sides are always of the same build.
//!
//! The solver gets a [`Job`] and sends [`News`]; the toolbox, which is started with the first question, gets an [`Ask`]
//! and sends a [`Told`].

use crate::aerodynamics::{Curves, Question};
use crate::catalog::Catalog;
use cad::export::{Format, Model};
use msape::flight::six_dof::turning::Turn;
use msape::{Answer, Case, InputError};
use serde::{Deserialize, Serialize};

/// Text that a worker sends when it has received a question, before it works on it.
pub const BEGUN: &str = "begun";

/// Message of the solver.
#[derive(Debug, Serialize, Deserialize)]
pub enum News {
    /// The solver is ready and has read the library.
    Ready(Box<Catalog>),
    /// Result of a job.
    Solved(Box<Reply>),
}

/// Question to the toolbox.
#[derive(Debug, Serialize, Deserialize)]
pub enum Ask {
    /// Time a batch.
    Measure(Batch),
    /// Fly a vehicle as it is.
    Fly(Case),
    /// Compute curves of coefficients.
    Aerodynamics(Box<Question>),
    /// Fly a design with attitude.
    Attitude(Box<Designed>),
    /// Fly one entry of a design from a set of attitudes and rates, by its index in the set.
    Turn(Box<Designed>, u32),
    /// Read the rows of a file, in bytes.
    Read(FileKind, Vec<u8>),
    /// Write a model as a file.
    Write(Format, Box<Model>),
}

/// Answer of the toolbox.
#[derive(Debug, Serialize, Deserialize)]
pub enum Told {
    /// Time of a batch, ms, or the reason why it could not be measured.
    Measured(Result<f64, String>),
    /// A flight, or all faults of its case.
    Flown(Box<Result<Answer, Vec<Fault>>>),
    /// Curves of coefficients, or all faults of their case.
    Aerodynamics(Box<Result<Curves, Vec<Fault>>>),
    /// An entry of the set, or all faults of its case.
    Turned(Box<Result<Turn, Vec<Fault>>>),
    /// The rows of a file, or all of its faults.
    Read(Result<ReadRows, Vec<String>>),
    /// A file, in bytes.
    Written(Vec<u8>),
}

/// Case and its design from the solver.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Designed {
    /// The case.
    pub case: Case,
    /// Design, with the flight of its point mass.
    pub answer: Answer,
}

/// Kind of file to read.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum FileKind {
    /// Rows for a table of a case.
    Table {
        /// Key of the table.
        table: String,
        /// The case to which it belongs.
        case: Box<Case>,
    },
    /// Coefficients with angles of attack.
    Coefficients,
    /// Outline: name of the file, and symbol of its unit if given.
    Outline(String, Option<String>),
}

/// Rows read from a file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ReadRows {
    /// Key of the input that takes them.
    pub key: String,
    /// Rows in the form of a case.
    pub rows: Vec<Vec<f64>>,
    /// Messages of the reader.
    pub remarks: Vec<String>,
}

/// Repetitions of a job of [`benchmark::JOBS`].
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct Batch {
    /// Index of the job.
    pub job: u32,
    /// Number of repetitions.
    pub repetitions: u32,
}

/// Case to be solved.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Job {
    /// Number of the job; a greater one is newer.
    pub id: u64,
    /// Case.
    pub case: Case,
}

/// Result of a job.
#[derive(Debug, Serialize, Deserialize)]
pub struct Reply {
    /// Number of the job.
    pub id: u64,
    /// Answer, or all faults of the case.
    pub result: Result<Answer, Vec<Fault>>,
    /// Solution time, ms.
    pub duration_ms: f64,
}

/// Fault of the input.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Fault {
    /// Dotted key; empty for a fault of the whole case.
    pub key: String,
    /// Value received and requirement.
    pub message: String,
}

impl From<InputError> for Fault {
    fn from(error: InputError) -> Fault {
        Fault {
            key: error.key,
            message: error.message,
        }
    }
}

/// Encodes a message.
///
/// # Errors
/// Errors of postcard.
pub fn encode<T: Serialize>(message: &T) -> Result<Vec<u8>, postcard::Error> {
    postcard::to_allocvec(message)
}

/// Decodes a message.
///
/// # Errors
/// Bytes of another build.
pub fn decode<T: for<'de> Deserialize<'de>>(bytes: &[u8]) -> Result<T, postcard::Error> {
    postcard::from_bytes(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_job_survives_the_way_to_the_worker() {
        let job = Job {
            id: 7,
            case: Case::run_page(),
        };
        let back: Job = decode(&encode(&job).unwrap()).unwrap();
        assert_eq!((back.id, back.case), (7, Case::run_page()));
    }
}
