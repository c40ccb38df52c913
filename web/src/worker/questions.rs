//! Questions to the toolbox: each waits for its own answer.

use super::WorkerLink;
use crate::aerodynamics::{Curves, Question};
use crate::protocol::{Ask, Batch, Fault, FileKind, ReadRows, Told};
use cad::export::{Format, Model};
use msape::flight::six_dof::turning::Turn;
use msape::{Answer, Case};

/// What is said of an answer to another question.
const OTHER_ANSWER: &str = "the solver answered something else";

impl WorkerLink {
    /// Time that a batch takes in the worker, ms.
    ///
    /// # Errors
    /// Why it could not be measured.
    pub async fn measure(&self, batch: Batch) -> Result<f64, String> {
        match self.ask(Ask::Measure(batch)).await? {
            Told::Measured(measured) => measured,
            _ => Err(OTHER_ANSWER.to_string()),
        }
    }

    /// A flight, or every fault of its case.
    ///
    /// # Errors
    /// Why the worker did not answer.
    pub async fn fly(&self, case: Case) -> Result<Result<Answer, Vec<Fault>>, String> {
        match self.ask(Ask::Fly(case)).await? {
            Told::Flown(flown) => Ok(*flown),
            _ => Err(OTHER_ANSWER.to_string()),
        }
    }

    /// The flight of a design with its attitude, or every fault of its case.
    ///
    /// # Errors
    /// Why the worker did not answer.
    pub async fn attitude(&self, case: Case) -> Result<Result<Answer, Vec<Fault>>, String> {
        match self.ask(Ask::Attitude(Box::new(case))).await? {
            Told::Flown(flown) => Ok(*flown),
            _ => Err(OTHER_ANSWER.to_string()),
        }
    }

    /// One entry of a design from a set of attitudes and rates, or every fault of its case.
    ///
    /// # Errors
    /// Why the worker did not answer.
    pub async fn turn(&self, case: Case, number: u32) -> Result<Result<Turn, Vec<Fault>>, String> {
        match self.ask(Ask::Turn(Box::new(case), number)).await? {
            Told::Turned(turned) => Ok(*turned),
            _ => Err(OTHER_ANSWER.to_string()),
        }
    }

    /// Curves of coefficients, or every fault of their case.
    ///
    /// # Errors
    /// Why the worker did not answer.
    pub async fn aerodynamics(
        &self,
        question: Question,
    ) -> Result<Result<Curves, Vec<Fault>>, String> {
        match self.ask(Ask::Aerodynamics(Box::new(question))).await? {
            Told::Aerodynamics(curves) => Ok(*curves),
            _ => Err(OTHER_ANSWER.to_string()),
        }
    }

    /// The rows of a file, or every fault of it.
    ///
    /// # Errors
    /// Why the worker did not answer.
    pub async fn read(
        &self,
        kind: FileKind,
        bytes: Vec<u8>,
    ) -> Result<Result<ReadRows, Vec<String>>, String> {
        match self.ask(Ask::Read(kind, bytes)).await? {
            Told::Read(rows) => Ok(rows),
            _ => Err(OTHER_ANSWER.to_string()),
        }
    }

    /// A model as a file, in bytes.
    ///
    /// # Errors
    /// Why the worker did not answer.
    pub async fn write(&self, format: Format, model: Model) -> Result<Vec<u8>, String> {
        match self.ask(Ask::Write(format, Box::new(model))).await? {
            Told::Written(bytes) => Ok(bytes),
            _ => Err(OTHER_ANSWER.to_string()),
        }
    }
}
