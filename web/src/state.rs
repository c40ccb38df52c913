//! State of the app: signals that components read, and the functions that change them.

pub mod check;
pub mod document;
pub mod history;
pub mod keeping;
pub mod preferences;

use crate::aerodynamics::{Curves, Question};
use crate::catalog::{self, Catalog, Names};
use crate::clock::now_ms;
use crate::protocol::{self, Batch, Designed, Fault, FileKind, ReadRows, Reply};
use crate::saving::Saver;
use crate::worker::{Asker, News, Role, WorkerLink};
use cad::export::{Format, Model};
use check::{Check, Checks, check_inputs};
use document::Document;
use history::History;
use keeping::Keeping;
use leptos::prelude::*;
use msape::flight::six_dof::turning::Turn;
use msape::quantity::input::Input;
use msape::{Answer, Case};
use preferences::Preferences;
use std::collections::BTreeMap;
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
    fn designed(&self) -> Designed {
        Designed {
            case: (*self.case).clone(),
            answer: self.answer.clone(),
        }
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
    /// Connection to the toolbox, started with the first question.
    toolbox: StoredValue<Option<WorkerLink>, LocalStorage>,
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
            toolbox: StoredValue::new_local(None),
            saver: StoredValue::new_local(None),
        };
        state.solve_on_change();
        state
    }

    /// State provided by an ancestor of this component.
    pub fn expect() -> State {
        expect_context::<State>()
    }

    fn solve_on_change(self) {
        let newest = StoredValue::new(0_u64);
        // cases of jobs without a reply so far
        let asked: StoredValue<BTreeMap<u64, Arc<Case>>> = StoredValue::new(BTreeMap::new());
        let replies: StoredValue<Option<Reply>> = StoredValue::new(None);
        let take = move || {
            let Some(reply) = replies.try_update_value(Option::take).flatten() else {
                return;
            };
            let case = asked.try_update_value(|asked| {
                let case = asked.remove(&reply.id);
                asked.retain(|id, _| *id > reply.id);
                case
            });
            if let Some(case) = case.flatten() {
                self.take(reply, newest.get_value(), case);
            }
        };
        // the same phase arrives several times a second
        let say = move |phase: Phase| {
            if self.phase.with_untracked(|said| *said != phase) {
                self.phase.set(phase);
            }
        };
        let link = WorkerLink::start(Role::Solver, move |news| match news {
            News::Failed(message) => say(Phase::Failed(message)),
            News::Long(words) => say(Phase::Long(words)),
            News::Told(protocol::News::Ready(catalog)) => self.learn(*catalog),
            // the screen shows one answer per frame, the newest
            News::Told(protocol::News::Solved(reply)) => {
                let waits = replies.with_value(Option::is_some);
                replies.set_value(Some(*reply));
                if !waits {
                    request_animation_frame(take);
                }
            }
        });
        self.solver.set_value(Some(link.clone()));
        Effect::new(move |_| {
            let case = self.case.get();
            newest.update_value(|id| *id += 1);
            asked.update_value(|asked| drop(asked.insert(newest.get_value(), case.clone())));
            self.phase.set(Phase::Updating);
            link.solve(newest.get_value(), (*case).clone());
        });
    }

    /// Takes the catalog; a restarted worker sends the same one, which must not rebuild the lists on screen.
    fn learn(self, catalog: Catalog) {
        if self.catalog.with_untracked(Option::is_none) {
            self.catalog.set(Some(Arc::new(catalog)));
        }
    }

    /// Allowed values of an input.
    pub fn names(self, input: &Input) -> Names {
        self.catalog
            .with(|catalog| catalog::names(catalog.as_deref(), input))
    }

    /// Connection to the toolbox.
    fn toolbox(self) -> WorkerLink {
        if let Some(link) = self.toolbox.get_value() {
            return link;
        }
        // no news handler: the pending question gets the error if the worker fails
        let link = WorkerLink::start(Role::Toolbox, |_| {});
        self.toolbox.set_value(Some(link.clone()));
        link
    }

    fn take(self, reply: Reply, newest: u64, case: Arc<Case>) {
        let is_newest = reply.id == newest;
        match reply.result {
            Ok(answer) => {
                if self.first_answer_ms.get_untracked().is_none() {
                    self.first_answer_ms.set(Some(now_ms()));
                }
                self.latest.set(Some(Arc::new(Solved {
                    id: reply.id,
                    case,
                    answer,
                    duration_ms: reply.duration_ms,
                })));
                if is_newest {
                    self.faults.set(Arc::default());
                    self.phase.set(Phase::Fresh);
                }
            }
            Err(faults) if is_newest => {
                self.faults.set(Arc::new(faults));
                self.phase.set(Phase::AtFault);
            }
            Err(_) => {}
        }
    }

    /// Ends the active run.
    pub fn stop_solving(self) {
        if let Some(link) = self.solver.get_value() {
            link.stop();
        }
    }

    /// Solves the newest case again, with a new worker.
    pub fn solve_again(self) {
        self.phase.set(Phase::Updating);
        if let Some(link) = self.solver.get_value() {
            link.try_again();
        }
    }

    /// Time of a batch in the worker, ms.
    ///
    /// # Errors
    /// The reason why it could not be measured.
    pub async fn measure(self, batch: Batch) -> Result<f64, String> {
        self.toolbox().measure(batch).await
    }

    /// Flight of a vehicle as it is, or all faults of its case; `None` if the asker has a newer question.
    pub async fn fly(self, asker: Asker, case: Case) -> Option<Result<Answer, Vec<Fault>>> {
        self.toolbox().fly(asker, case).await
    }

    /// Flight of a design with attitude, or all faults of its case; `None` if the asker has a newer question.
    pub async fn attitude(
        self,
        asker: Asker,
        solved: &Solved,
    ) -> Option<Result<Answer, Vec<Fault>>> {
        self.toolbox().attitude(asker, solved.designed()).await
    }

    /// One entry of a design from a set of attitudes and rates, or all faults of its case.
    ///
    /// # Errors
    /// The reason why the worker did not answer.
    pub async fn turn(
        self,
        solved: &Solved,
        number: u32,
    ) -> Result<Result<Turn, Vec<Fault>>, String> {
        self.toolbox().turn(solved.designed(), number).await
    }

    /// Curves of coefficients, or all faults of their case; `None` if the asker has a newer question.
    pub async fn aerodynamics(
        self,
        asker: Asker,
        question: Question,
    ) -> Option<Result<Curves, Vec<Fault>>> {
        self.toolbox().aerodynamics(asker, question).await
    }

    /// The rows of a file.
    ///
    /// # Errors
    /// All faults of the file, or the reason why the worker did not answer.
    pub async fn read(self, kind: FileKind, bytes: Vec<u8>) -> Result<ReadRows, Vec<String>> {
        self.toolbox().read(kind, bytes).await
    }

    /// Rows of a text that is being typed, or all of its faults; `None` if the asker has a newer question.
    pub async fn read_newest(
        self,
        asker: Asker,
        kind: FileKind,
        text: String,
    ) -> Option<Result<ReadRows, Vec<String>>> {
        let bytes = text.into_bytes();
        self.toolbox().read_newest(asker, kind, bytes).await
    }

    /// A model as a file, in bytes.
    ///
    /// # Errors
    /// The reason why the worker did not answer.
    pub async fn write(self, format: Format, model: Model) -> Result<Vec<u8>, String> {
        self.toolbox().write(format, model).await
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
