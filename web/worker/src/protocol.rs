//! Questions to the workers and their bytes; both ends are always of the same build.
//!
//! A message to a worker is the name of a question and the question; a worker sends [`BEGUN`], fractions done, and the
//! answer or refusal.

use crate::desk::Desk;
use msape::InputError;
use msape::progress::Progress;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

/// Text that a worker sends when it has received a question, before it works on it.
pub const BEGUN: &str = "begun";

/// Question to a worker, with its answer.
pub trait Question: Listed + Serialize + DeserializeOwned {
    /// Answer.
    type Answer: Serialize + DeserializeOwned;
    /// Reason for which there is no answer.
    type Refusal: Refusal + Serialize + DeserializeOwned;

    /// Answers the question, in the worker. Work that takes long reports its progress; the page ends it by ending the
    /// worker.
    ///
    /// # Errors
    /// The reason for which there is no answer.
    fn answer(
        self,
        desk: &Desk,
        progress: &mut dyn Progress,
    ) -> Result<Self::Answer, Self::Refusal>;
}

/// Place of a question in the list of [`crate::questions`].
pub trait Listed {
    /// Name in messages.
    const NAME: &'static str;
    /// Worker that answers.
    const ROLE: Role;
}

/// Role of a worker.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// Solves designs; started with the page.
    Solver,
    /// Does everything else; started with its first question.
    Toolbox,
}

impl Role {
    /// Name for the user.
    pub fn name(self) -> &'static str {
        match self {
            Role::Solver => "the solver",
            Role::Toolbox => "the toolbox",
        }
    }
}

/// Reason for which there is no answer, of which a failure of the worker is one.
pub trait Refusal {
    /// The refusal with these words.
    fn of_worker(words: String) -> Self;
}

impl Refusal for String {
    fn of_worker(words: String) -> Self {
        words
    }
}

impl Refusal for Vec<String> {
    fn of_worker(words: String) -> Self {
        vec![words]
    }
}

impl Refusal for Vec<Fault> {
    fn of_worker(message: String) -> Self {
        let key = String::new();
        vec![Fault { key, message }]
    }
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

/// Faults as the page receives them.
pub fn faults(faults: Vec<InputError>) -> Vec<Fault> {
    faults.into_iter().map(Fault::from).collect()
}

/// Message that asks a question.
///
/// # Errors
/// Errors of postcard.
pub fn encode<Q: Question>(question: &Q) -> Result<Vec<u8>, postcard::Error> {
    postcard::to_allocvec(&(Q::NAME, question))
}

/// Answer or refusal from the message of a worker.
///
/// # Errors
/// Bytes of another build.
pub fn decode<Q: Question>(bytes: &[u8]) -> Result<Result<Q::Answer, Q::Refusal>, postcard::Error> {
    postcard::from_bytes(bytes)
}

/// One kind of question as a worker knows it.
pub struct Kind {
    name: &'static str,
    answer: Answering,
}

/// Bytes of the answer or refusal to the bytes of a question.
type Answering = fn(&[u8], &Desk, &mut dyn Progress) -> Result<Vec<u8>, postcard::Error>;

impl Kind {
    /// Kind of a question.
    pub const fn of<Q: Question>() -> Kind {
        Kind {
            name: Q::NAME,
            answer: |bytes, desk, progress| {
                let question: Q = postcard::from_bytes(bytes)?;
                postcard::to_allocvec(&question.answer(desk, progress))
            },
        }
    }
}

/// Answers a message, by its kind.
///
/// # Errors
/// A kind that is not among these, or bytes of another build.
pub fn answer(
    kinds: &[Kind],
    message: &[u8],
    desk: &Desk,
    progress: &mut dyn Progress,
) -> Result<Vec<u8>, postcard::Error> {
    let (name, question): (&str, &[u8]) = postcard::take_from_bytes(message)?;
    let kind = kinds.iter().find(|kind| kind.name == name);
    let kind = kind.ok_or(postcard::Error::SerdeDeCustom)?;
    (kind.answer)(question, desk, progress)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::questions::{Fly, SOLVER, TOOLBOX};
    use msape::progress::Unwatched;
    use msape::{Case, Library};

    #[test]
    fn a_question_is_answered_by_the_worker_of_its_role_and_by_no_other() {
        let desk = Desk::new(Library::builtin().unwrap());
        let mut case = Case::run_page();
        case.set("entry.speed_m_s", "-1");
        let message = encode(&Fly(case)).unwrap();
        let told = answer(TOOLBOX, &message, &desk, &mut Unwatched).unwrap();
        let faults = decode::<Fly>(&told).unwrap().err().unwrap();
        assert!(faults.iter().any(|fault| fault.key == "entry.speed_m_s"));
        assert!(answer(SOLVER, &message, &desk, &mut Unwatched).is_err());
        assert!(
            answer(
                TOOLBOX,
                &message[..message.len() / 2],
                &desk,
                &mut Unwatched
            )
            .is_err()
        );
    }

    #[test]
    fn names_of_questions_are_unique() {
        let mut names: Vec<&str> = SOLVER.iter().chain(TOOLBOX).map(|kind| kind.name).collect();
        let count = names.len();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), count);
    }
}
