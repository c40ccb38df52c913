//! Reasons for which a question has no answer.

use crate::protocol::{Question, Refusal};

/// Reason for which a question that the user ended has no answer.
pub(super) const STOPPED: &str = "stopped";
/// Reason for which a question has no answer that was replaced by a newer one of its asker.
pub(super) const OUTDATED: &str = "a newer question came";

/// Reason for which there is no answer.
#[derive(Clone, Debug, PartialEq)]
pub enum Unanswered {
    /// A newer question of the same asker came.
    Outdated,
    /// The worker failed or was stopped; words for the user.
    Failed(String),
}

impl Unanswered {
    /// The reason with these words.
    pub(super) fn of(words: String) -> Unanswered {
        match words == OUTDATED {
            true => Unanswered::Outdated,
            false => Unanswered::Failed(words),
        }
    }

    /// The same as a refusal of a question.
    ///
    /// # Errors
    /// Always: the refusal.
    pub fn refuse<Q: Question>(self) -> Result<Q::Answer, Q::Refusal> {
        Err(Q::Refusal::of_worker(match self {
            Unanswered::Outdated => OUTDATED.to_string(),
            Unanswered::Failed(words) => words,
        }))
    }
}
