//! Questions to the toolbox: each waits for its own answer, or for the newest of its asker.

use super::WorkerLink;
use crate::aerodynamics::{Curves, Question};
use crate::protocol::{Ask, Batch, Designed, Fault, FileKind, ReadRows, Told};
use cad::export::{Format, Model};
use leptos::prelude::{GetValue, StoredValue, UpdateValue};
use msape::flight::six_dof::turning::Turn;
use msape::{Answer, Case};

/// Error text if the answer belongs to another question.
const OTHER_ANSWER: &str = "the toolbox answered something else";

/// Part of the page that asks at each change and needs only the newest answer. Askers do not affect each other.
#[derive(Clone, Copy, PartialEq)]
pub struct Asker(StoredValue<u32>);

impl Default for Asker {
    /// A new asker, which ends with the component that creates it.
    fn default() -> Asker {
        Asker(StoredValue::new(0))
    }
}

impl Asker {
    /// Ignores the answers to all earlier questions.
    pub fn wants_nothing(self) {
        self.next();
    }

    /// Number of the next question; `None` if the component is gone.
    fn next(self) -> Option<u32> {
        self.0.try_update_value(|count| {
            *count += 1;
            *count
        })
    }
}

impl WorkerLink {
    /// Extracts the result from the answer to a question; `None` if the asker has a newer question.
    async fn newest<T>(
        &self,
        asker: Asker,
        ask: Ask,
        take: impl FnOnce(Told) -> Option<T>,
    ) -> Option<Result<T, String>> {
        let this = asker.next()?;
        let told = self.ask(Some(asker), ask).await;
        let taken = told.and_then(|told| take(told).ok_or_else(|| OTHER_ANSWER.to_string()));
        (asker.0.try_get_value() == Some(this)).then_some(taken)
    }

    /// Time of a batch in the worker, ms.
    ///
    /// # Errors
    /// The reason why it could not be measured.
    pub async fn measure(&self, batch: Batch) -> Result<f64, String> {
        match self.ask(None, Ask::Measure(batch)).await? {
            Told::Measured(measured) => measured,
            _ => Err(OTHER_ANSWER.to_string()),
        }
    }

    /// A flight, or all faults of its case; `None` if the asker has a newer question.
    pub async fn fly(&self, asker: Asker, case: Case) -> Option<Result<Answer, Vec<Fault>>> {
        self.newest(asker, Ask::Fly(case), flown).await.map(at_once)
    }

    /// Flight of a design with attitude, or all faults of its case; `None` if the asker has a newer question.
    pub async fn attitude(
        &self,
        asker: Asker,
        designed: Designed,
    ) -> Option<Result<Answer, Vec<Fault>>> {
        let ask = Ask::Attitude(Box::new(designed));
        self.newest(asker, ask, flown).await.map(at_once)
    }

    /// One entry of a design from a set of attitudes and rates, or all faults of its case.
    ///
    /// # Errors
    /// The reason why the worker did not answer.
    pub async fn turn(
        &self,
        designed: Designed,
        number: u32,
    ) -> Result<Result<Turn, Vec<Fault>>, String> {
        let ask = Ask::Turn(Box::new(designed), number);
        match self.ask(None, ask).await? {
            Told::Turned(turned) => Ok(*turned),
            _ => Err(OTHER_ANSWER.to_string()),
        }
    }

    /// Curves of coefficients, or all faults of their case; `None` if the asker has a newer question.
    pub async fn aerodynamics(
        &self,
        asker: Asker,
        question: Question,
    ) -> Option<Result<Curves, Vec<Fault>>> {
        let ask = Ask::Aerodynamics(Box::new(question));
        let curves = |told| match told {
            Told::Aerodynamics(curves) => Some(*curves),
            _ => None,
        };
        self.newest(asker, ask, curves).await.map(at_once)
    }

    /// Rows of a file.
    ///
    /// # Errors
    /// All faults of the file, or the reason why the worker did not answer.
    pub async fn read(&self, kind: FileKind, bytes: Vec<u8>) -> Result<ReadRows, Vec<String>> {
        let told = self.ask(None, Ask::Read(kind, bytes)).await;
        match told.map_err(|message| vec![message])? {
            Told::Read(rows) => rows,
            _ => Err(vec![OTHER_ANSWER.to_string()]),
        }
    }

    /// Rows of a text that is being typed, or all of its faults; `None` if the asker has a newer question.
    pub async fn read_newest(
        &self,
        asker: Asker,
        kind: FileKind,
        bytes: Vec<u8>,
    ) -> Option<Result<ReadRows, Vec<String>>> {
        let rows = |told| match told {
            Told::Read(rows) => Some(rows),
            _ => None,
        };
        let read = self.newest(asker, Ask::Read(kind, bytes), rows).await?;
        Some(read.unwrap_or_else(|message| Err(vec![message])))
    }

    /// A model as a file, in bytes.
    ///
    /// # Errors
    /// The reason why the worker did not answer.
    pub async fn write(&self, format: Format, model: Model) -> Result<Vec<u8>, String> {
        match self.ask(None, Ask::Write(format, Box::new(model))).await? {
            Told::Written(bytes) => Ok(bytes),
            _ => Err(OTHER_ANSWER.to_string()),
        }
    }
}

fn flown(told: Told) -> Option<Result<Answer, Vec<Fault>>> {
    match told {
        Told::Flown(flown) => Some(*flown),
        _ => None,
    }
}

/// Flattens both kinds of error into faults.
fn at_once<T>(answer: Result<Result<T, Vec<Fault>>, String>) -> Result<T, Vec<Fault>> {
    answer.unwrap_or_else(|message| {
        let key = String::new();
        Err(vec![Fault { key, message }])
    })
}
