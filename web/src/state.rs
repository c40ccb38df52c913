//! The app's state: signals that components read, and the few ways to change them.

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

/// An answer together with the case that it belongs to.
#[derive(Clone, Debug)]
pub struct Solved {
    /// Number of the job.
    pub id: u64,
    /// What was asked.
    pub case: Arc<Case>,
    /// What came out.
    pub answer: Answer,
    /// Time that solving took, ms.
    pub duration_ms: f64,
}

impl Solved {
    /// What the toolbox is asked about.
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

/// How the newest answer stands to the input.
#[derive(Clone, Debug, PartialEq)]
pub enum Phase {
    /// It belongs to the input.
    Fresh,
    /// A newer one is being computed.
    Updating,
    /// The same, and it takes long, in words.
    Long(String),
    /// The input has faults; the answer is of the last input that had none.
    AtFault,
    /// The solver failed.
    Failed(String),
}

/// All signals of the app.
#[derive(Clone, Copy)]
pub struct State {
    /// The undo stack.
    pub history: RwSignal<History>,
    /// Count of undos and redos: what was being typed before one is forgotten.
    pub turns: RwSignal<u32>,
    /// Its present document.
    pub document: Memo<Arc<Document>>,
    /// The case of the document.
    pub case: Memo<Arc<Case>>,
    /// How each input stands.
    pub checks: Memo<Arc<Checks>>,
    /// The newest answer.
    pub latest: RwSignal<Option<Arc<Solved>>>,
    /// Faults of the newest input, as the solver found them.
    pub faults: RwSignal<Arc<Vec<Fault>>>,
    /// How the newest answer stands to the input.
    pub phase: RwSignal<Phase>,
    /// Row of the time history under the cursor that all charts share.
    pub cursor: RwSignal<Option<usize>>,
    /// What the browser keeps.
    pub keeping: Keeping,
    /// Result of the last action, for the status line.
    pub notice: RwSignal<String>,
    /// Faults of the last file that was opened.
    pub file_faults: RwSignal<Vec<String>>,
    /// What changed since the last case that was opened was made by an earlier version.
    pub version_remarks: RwSignal<Vec<String>>,
    /// Look and depth of the page.
    pub preferences: Preferences,
    /// What a case may name; absent until the worker is ready.
    pub catalog: RwSignal<Option<Arc<Catalog>>>,
    /// Inputs that the next flight of an outline begins with.
    pub flight_fields: StoredValue<Option<Case>>,
    /// Time from navigation to the first answer, ms.
    pub first_answer_ms: RwSignal<Option<f64>>,
    solver: StoredValue<Option<WorkerLink>, LocalStorage>,
    /// Started when it is first asked.
    toolbox: StoredValue<Option<WorkerLink>, LocalStorage>,
    /// What keeps documents.
    pub saver: StoredValue<Option<Saver>, LocalStorage>,
}

impl State {
    /// The state around a first document; solving starts at once.
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

    /// The state of the app around this component.
    pub fn expect() -> State {
        expect_context::<State>()
    }

    fn solve_on_change(self) {
        let newest = StoredValue::new(0_u64);
        // The cases of jobs that have no reply yet.
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
        // Several times a second the same.
        let say = move |phase: Phase| {
            if self.phase.with_untracked(|said| *said != phase) {
                self.phase.set(phase);
            }
        };
        let link = WorkerLink::start(Role::Solver, move |news| match news {
            News::Failed(message) => say(Phase::Failed(message)),
            News::Long(words) => say(Phase::Long(words)),
            News::Told(protocol::News::Ready(catalog)) => self.learn(*catalog),
            // The screen shows one answer a frame; of several, the newest.
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

    /// A worker that is started anew says the same again: the lists on the screen stay.
    fn learn(self, catalog: Catalog) {
        if self.catalog.with_untracked(Option::is_none) {
            self.catalog.set(Some(Arc::new(catalog)));
        }
    }

    /// What an input may be.
    pub fn names(self, input: &Input) -> Names {
        self.catalog
            .with(|catalog| catalog::names(catalog.as_deref(), input))
    }

    /// The line to the toolbox.
    fn toolbox(self) -> WorkerLink {
        if let Some(link) = self.toolbox.get_value() {
            return link;
        }
        // A question that is under way when it fails is told so.
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

    /// Ends the run that is under way.
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

    /// Time that a batch takes in the worker, ms.
    ///
    /// # Errors
    /// Why it could not be measured.
    pub async fn measure(self, batch: Batch) -> Result<f64, String> {
        self.toolbox().measure(batch).await
    }

    /// A flight of a vehicle as it is, or every fault of its case; nothing if the asker asks anew.
    pub async fn fly(self, asker: Asker, case: Case) -> Option<Result<Answer, Vec<Fault>>> {
        self.toolbox().fly(asker, case).await
    }

    /// The flight of a design with its attitude, or every fault of its case; nothing if the asker asks anew.
    pub async fn attitude(
        self,
        asker: Asker,
        solved: &Solved,
    ) -> Option<Result<Answer, Vec<Fault>>> {
        self.toolbox().attitude(asker, solved.designed()).await
    }

    /// One entry of a design from a set of attitudes and rates, or every fault of its case.
    ///
    /// # Errors
    /// Why the worker did not answer.
    pub async fn turn(
        self,
        solved: &Solved,
        number: u32,
    ) -> Result<Result<Turn, Vec<Fault>>, String> {
        self.toolbox().turn(solved.designed(), number).await
    }

    /// Curves of coefficients, or every fault of their case; nothing if the asker asks anew.
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
    /// Every fault of it, or why the worker did not answer.
    pub async fn read(self, kind: FileKind, bytes: Vec<u8>) -> Result<ReadRows, Vec<String>> {
        self.toolbox().read(kind, bytes).await
    }

    /// The rows of a text that is being typed, or every fault of it; nothing if the asker asks anew.
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
    /// Why the worker did not answer.
    pub async fn write(self, format: Format, model: Model) -> Result<Vec<u8>, String> {
        self.toolbox().write(format, model).await
    }

    /// Takes the last change back.
    pub fn undo(self) {
        self.turns.update(|turns| *turns += 1);
        self.history.update(History::undo);
    }

    /// Repeats the change last taken back.
    pub fn redo(self) {
        self.turns.update(|turns| *turns += 1);
        self.history.update(History::redo);
    }

    /// Replaces the document; edits with one `tag` in a row are one step to undo.
    pub fn edit(self, label: &str, tag: Option<&str>, change: impl FnOnce(&Document) -> Document) {
        let document = self
            .history
            .with_untracked(|history| change(history.present()));
        self.history
            .update(|history| history.edit(label, tag, document));
    }

    /// Ends a row of edits.
    pub fn close_step(self) {
        self.history.update_untracked(History::close);
    }

    /// How one input stands.
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

    /// A slice of the newest answer.
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
