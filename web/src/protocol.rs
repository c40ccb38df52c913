//! Messages between the page and its two workers, as postcard bytes: all of them are of one build.
//!
//! The solver gets a [`Job`] and says [`News`]; the toolbox, which starts when it is first asked, gets an [`Ask`] and says what
//! was [`Told`].

use crate::aerodynamics::{Curves, Question};
use crate::catalog::Catalog;
use cad::export::{Format, Model};
use msape::flight::six_dof::turning::Turn;
use msape::{Answer, Case, InputError};
use serde::{Deserialize, Serialize};

/// What a worker says, as a text, when it has got a question and before it works on it.
pub const BEGUN: &str = "begun";

/// What the solver says.
#[derive(Debug, Serialize, Deserialize)]
pub enum News {
    /// It is ready, and has read the library.
    Ready(Box<Catalog>),
    /// What became of a job.
    Solved(Box<Reply>),
}

/// What the page asks of the toolbox.
#[derive(Debug, Serialize, Deserialize)]
pub enum Ask {
    /// To measure a batch.
    Measure(Batch),
    /// To fly a vehicle as it is.
    Fly(Case),
    /// For curves of coefficients.
    Aerodynamics(Box<Question>),
    /// For the flight of a design with its attitude.
    Attitude(Box<Designed>),
    /// For one entry of a design from a set of attitudes and rates, by its number in the set.
    Turn(Box<Designed>, u32),
    /// To read the rows of a file, in bytes.
    Read(FileKind, Vec<u8>),
    /// To write a model as a file.
    Write(Format, Box<Model>),
}

/// What the toolbox replies.
#[derive(Debug, Serialize, Deserialize)]
pub enum Told {
    /// Time that a batch took, ms, or why it could not be measured.
    Measured(Result<f64, String>),
    /// A flight, or every fault of its case.
    Flown(Box<Result<Answer, Vec<Fault>>>),
    /// Curves of coefficients, or every fault of their case.
    Aerodynamics(Box<Result<Curves, Vec<Fault>>>),
    /// An entry of the set, or every fault of its case.
    Turned(Box<Result<Turn, Vec<Fault>>>),
    /// The rows of a file, or every fault of it.
    Read(Result<ReadRows, Vec<String>>),
    /// A file, in bytes.
    Written(Vec<u8>),
}

/// A case and its design, as the solver found it.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Designed {
    /// The case.
    pub case: Case,
    /// The design, with the flight of its point mass.
    pub answer: Answer,
}

/// What is read from a file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum FileKind {
    /// Rows for a table of a case.
    Table {
        /// Key of the table.
        table: String,
        /// The case that it is for.
        case: Box<Case>,
    },
    /// Coefficients with angles of attack.
    Coefficients,
    /// An outline: the name of its file, and the symbol of its unit where one is given.
    Outline(String, Option<String>),
}

/// Rows of a file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ReadRows {
    /// Key of the input that takes them.
    pub key: String,
    /// Rows as a case takes them.
    pub rows: Vec<Vec<f64>>,
    /// What the reader decided.
    pub remarks: Vec<String>,
}

/// Repetitions of a job of [`benchmark::JOBS`].
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct Batch {
    /// Index of the job.
    pub job: u32,
    /// How often it is done.
    pub repetitions: u32,
}

/// A case to be solved.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Job {
    /// Number of the job; a greater one is newer.
    pub id: u64,
    /// What is asked for.
    pub case: Case,
}

/// What became of a job.
#[derive(Debug, Serialize, Deserialize)]
pub struct Reply {
    /// Number of the job.
    pub id: u64,
    /// The answer, or every fault of the case.
    pub result: Result<Answer, Vec<Fault>>,
    /// Time that solving took, ms.
    pub duration_ms: f64,
}

/// A fault of the input.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Fault {
    /// Dotted key; empty when the whole case is at fault.
    pub key: String,
    /// What was got and what must be.
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

/// The bytes of a message.
///
/// # Errors
/// What postcard cannot write.
pub fn encode<T: Serialize>(message: &T) -> Result<Vec<u8>, postcard::Error> {
    postcard::to_allocvec(message)
}

/// The message in some bytes.
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
