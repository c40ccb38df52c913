//! Parts of the page that ask the workers at each change.

use super::State;
use leptos::prelude::{GetValue, StoredValue, UpdateValue, WithValue};
use msape_worker::client::{Unanswered, WorkerLink};
use msape_worker::pool::Run;
use msape_worker::protocol::{Question, Refusal, Role};
use std::cell::Cell;

thread_local! {
    static ASKERS: Cell<u32> = const { Cell::new(0) };
}

/// Part of the page that asks at each change and needs only the newest answer. Askers do not affect each other.
#[derive(Clone, Copy)]
pub struct Asker {
    id: u32,
    count: StoredValue<u32>,
}

impl Default for Asker {
    /// A new asker, which ends with the component that creates it.
    fn default() -> Asker {
        Asker {
            id: ASKERS.replace(ASKERS.get() + 1),
            count: StoredValue::new(0),
        }
    }
}

impl Asker {
    /// Number that no other asker has.
    pub fn id(self) -> u32 {
        self.id
    }

    /// Ignores the answers to all earlier questions.
    pub fn wants_nothing(self) {
        self.next();
    }

    /// Number of the next question; `None` if the component is gone.
    fn next(self) -> Option<u32> {
        self.count.try_update_value(|count| {
            *count += 1;
            *count
        })
    }
}

impl State {
    /// Connection to the worker of a question.
    fn link(self, role: Role) -> Option<WorkerLink> {
        match role {
            Role::Solver => self.solver.get_value(),
            Role::Toolbox => self.toolbox.with_value(|pool| pool.links(1).pop()),
        }
    }

    /// Answer to a question, or its refusal; `None` if the asker has a newer question or is gone.
    pub async fn ask<Q: Question>(
        self,
        asker: Asker,
        question: Q,
    ) -> Option<Result<Q::Answer, Q::Refusal>> {
        let this = asker.next()?;
        let told = self.link(Q::ROLE)?.ask(Some(asker.id), &question).await;
        let told = told.unwrap_or_else(Unanswered::refuse::<Q>);
        (asker.count.try_get_value() == Some(this)).then_some(told)
    }

    /// Answer to a question that no other replaces.
    ///
    /// # Errors
    /// The refusal of the question.
    pub async fn ask_once<Q: Question>(self, question: Q) -> Result<Q::Answer, Q::Refusal> {
        match self.link(Q::ROLE) {
            Some(link) => link.ask_once(&question).await,
            None => Err(Q::Refusal::of_worker("there is no worker".to_string())),
        }
    }

    /// Asks the toolbox many questions, side by side; `on_progress` gets the index and the fraction done of each under way,
    /// `on_answer` the index and the answer of each.
    pub fn ask_each<Q: Question + 'static>(
        self,
        questions: Vec<Q>,
        on_progress: impl Fn(usize, f64) + 'static,
        on_answer: impl Fn(usize, Result<Q::Answer, Q::Refusal>) + 'static,
    ) -> Run {
        let pool = self.toolbox.get_value();
        pool.ask_each(questions, on_progress, on_answer)
    }
}
