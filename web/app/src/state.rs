//! State of the app: signals that components read, and the functions that change them.

pub mod asker;
pub mod check;
pub mod document;
pub mod history;
pub mod keeping;
pub mod preferences;
mod solving;

use crate::saving::Saver;
use check::{Check, Checks, check_inputs};
use document::Document;
use history::History;
use keeping::Keeping;
use leptos::prelude::*;
use msape::quantity::input::Input;
use msape::{Answer, Case};
use msape_worker::catalog::{self, Catalog, Names};
use msape_worker::client::WorkerLink;
use msape_worker::pool::Pool;
use msape_worker::protocol::{Fault, Role};
use msape_worker::questions::Designed;
use preferences::Preferences;
use solving::Solving;
use std::sync::Arc;

/// Answer with its case.
#[derive(Clone, Debug)]
pub struct Solved {
    /// Number of the job.
    pub id: u64,
    /// Case of the job.
    pub case: Arc<Case>,
    /// Answer.
    pub answer: Answer,
    /// Solution time, ms.
    pub duration_ms: f64,
}

impl Solved {
    /// Case and design, for questions to the toolbox.
    pub fn designed(&self) -> Box<Designed> {
        Box::new(Designed {
            case: (*self.case).clone(),
            answer: self.answer.clone(),
        })
    }
}

impl PartialEq for Solved {
    fn eq(&self, other: &Solved) -> bool {
        self.id == other.id
    }
}

/// Relation of the newest answer to the input.
#[derive(Clone, Debug, PartialEq)]
pub enum Phase {
    /// Up to date.
    Fresh,
    /// A newer answer is being computed.
    Updating,
    /// A newer answer is being computed and takes long; message.
    Long(String),
    /// The input has faults; the answer belongs to the last valid input.
    AtFault,
    /// The solver failed; message.
    Failed(String),
}

/// All signals of the app.
#[derive(Clone, Copy)]
pub struct State {
    /// The undo stack.
    pub history: RwSignal<History>,
    /// Number of undos and redos: fields discard text being typed when it changes.
    pub turns: RwSignal<u32>,
    /// Current document of the stack.
    pub document: Memo<Arc<Document>>,
    /// The case of the document.
    pub case: Memo<Arc<Case>>,
    /// State of each input.
    pub checks: Memo<Arc<Checks>>,
    /// The newest answer.
    pub latest: RwSignal<Option<Arc<Solved>>>,
    /// Faults of the newest input, from the solver.
    pub faults: RwSignal<Arc<Vec<Fault>>>,
    /// Relation of the newest answer to the input.
    pub phase: RwSignal<Phase>,
    /// Row of the time history at the cursor shared by all charts.
    pub cursor: RwSignal<Option<usize>>,
    /// State of storage.
    pub keeping: Keeping,
    /// Result of the last action, for the status line.
    pub notice: RwSignal<String>,
    /// Faults of the last opened file.
    pub file_faults: RwSignal<Vec<String>>,
    /// Changes since the version that made the last opened case.
    pub version_remarks: RwSignal<Vec<String>>,
    /// Display preferences.
    pub preferences: Preferences,
    /// Library data; `None` until the worker is ready.
    pub catalog: RwSignal<Option<Arc<Catalog>>>,
    /// Inputs with which the next flight of an outline starts.
    pub flight_fields: StoredValue<Option<Case>>,
    /// Time from navigation to the first answer, ms.
    pub first_answer_ms: RwSignal<Option<f64>>,
    solver: StoredValue<Option<WorkerLink>, LocalStorage>,
    solving: Solving,
    /// Workers of the toolbox, started with the first question.
    toolbox: StoredValue<Pool, LocalStorage>,
    /// Automatic saver.
    pub saver: StoredValue<Option<Saver>, LocalStorage>,
}

impl State {
    /// State with a first document; solving starts at once.
    pub fn new(document: Document, preferences: Preferences) -> State {
        let history = RwSignal::new(History::new(document));
        let document = Memo::new(move |_| history.with(|history| history.present().clone()));
        let case = Memo::new(move |_| document.with(|document| document.case.clone()));
        let catalog = RwSignal::new(None::<Arc<Catalog>>);
        let checks = Memo::new(move |_| {
            Arc::new(catalog.with(|catalog| check_inputs(&case.get(), catalog.as_deref())))
        });
        let state = State {
            history,
            turns: RwSignal::new(0),
            document,
            case,
            checks,
            latest: RwSignal::new(None),
            faults: RwSignal::new(Arc::default()),
            phase: RwSignal::new(Phase::Updating),
            cursor: RwSignal::new(None),
            keeping: Keeping::default(),
            notice: RwSignal::new(String::new()),
            file_faults: RwSignal::new(Vec::new()),
            version_remarks: RwSignal::new(Vec::new()),
            preferences,
            catalog,
            flight_fields: StoredValue::new(None),
            first_answer_ms: RwSignal::new(None),
            solver: StoredValue::new_local(None),
            solving: Solving::default(),
            toolbox: StoredValue::new_local(Pool::new(Role::Toolbox)),
            saver: StoredValue::new_local(None),
        };
        state.solve_on_change();
        state
    }

    /// State provided by an ancestor of this component.
    pub fn expect() -> State {
        expect_context::<State>()
    }

    /// Allowed values of an input.
    pub fn names(self, input: &Input) -> Names {
        self.catalog
            .with(|catalog| catalog::names(catalog.as_deref(), input))
    }

    /// Undoes the last change.
    pub fn undo(self) {
        self.turns.update(|turns| *turns += 1);
        self.history.update(History::undo);
    }

    /// Repeats the last undone change.
    pub fn redo(self) {
        self.turns.update(|turns| *turns += 1);
        self.history.update(History::redo);
    }

    /// Replaces the document; consecutive edits with the same `tag` are one undo step.
    pub fn edit(self, label: &str, tag: Option<&str>, change: impl FnOnce(&Document) -> Document) {
        let document = self
            .history
            .with_untracked(|history| change(history.present()));
        self.history
            .update(|history| history.edit(label, tag, document));
    }

    /// Ends a sequence of edits.
    pub fn close_step(self) {
        self.history.update_untracked(History::close);
    }

    /// State of one input.
    pub fn check(self, key: &'static str) -> Memo<Check> {
        Memo::new(move |_| {
            let mut check = self
                .checks
                .with(|checks| checks.get(key).cloned())
                .unwrap_or_default();
            self.faults.with(|faults| {
                for fault in faults.iter().filter(|fault| fault.key == key) {
                    if !check.faults.contains(&fault.message) && self.phase.get() == Phase::AtFault
                    {
                        check.faults.push(fault.message.clone());
                    }
                }
            });
            check
        })
    }

    /// Part of the newest answer.
    pub fn of_answer<T>(self, get: impl Fn(&Answer) -> T + Send + Sync + 'static) -> Memo<Option<T>>
    where
        T: PartialEq + Send + Sync + 'static,
    {
        Memo::new(move |_| {
            self.latest
                .with(|latest| latest.as_ref().map(|solved| get(&solved.answer)))
        })
    }
}
