//! The newest case is always being solved, or is solved.

use super::asker::Asker;
use super::{Phase, Solved, State};
use leptos::prelude::*;
use msape::Case;
use msape_worker::client::{News, Unanswered, WorkerLink};
use msape_worker::clock::now_ms;
use msape_worker::protocol::{Fault, Role};
use msape_worker::questions::{ReadCatalog, Solution, Solve};
use std::sync::Arc;
use wasm_bindgen_futures::spawn_local;

/// Answer that waits for its frame.
struct Reply {
    id: u64,
    case: Arc<Case>,
    result: Result<Solution, Vec<Fault>>,
}

/// Cases on their way to the solver and back.
#[derive(Clone, Copy)]
pub struct Solving {
    asker: Asker,
    /// Number of the newest case.
    newest: StoredValue<u64>,
    reply: StoredValue<Option<Reply>>,
}

impl Default for Solving {
    fn default() -> Solving {
        Solving {
            asker: Asker::default(),
            newest: StoredValue::new(0),
            reply: StoredValue::new(None),
        }
    }
}

impl State {
    /// Starts the solver, and solves the case at each change.
    pub(super) fn solve_on_change(self) {
        let link = WorkerLink::start(Role::Solver, move |news| {
            let phase = match news {
                News::Failed(message) => Phase::Failed(message),
                News::Long(words) => Phase::Long(words),
            };
            // the same news arrives several times a second
            if self.phase.with_untracked(|said| *said != phase) {
                self.phase.set(phase);
            }
        });
        self.solver.set_value(Some(link));
        self.read_catalog();
        Effect::new(move |_| self.solve(self.case.get()));
    }

    fn solve(self, case: Arc<Case>) {
        let Some(link) = self.solver.get_value() else {
            return;
        };
        let Solving {
            asker,
            newest,
            reply,
        } = self.solving;
        newest.update_value(|id| *id += 1);
        let id = newest.get_value();
        self.phase.set(Phase::Updating);
        spawn_local(async move {
            let question = Solve((*case).clone());
            match link.ask(Some(asker.id()), &question).await {
                // the screen shows one answer per frame, the newest
                Ok(result) => {
                    let waits = reply.with_value(Option::is_some);
                    reply.set_value(Some(Reply { id, case, result }));
                    if !waits {
                        request_animation_frame(move || self.take());
                    }
                }
                Err(Unanswered::Failed(reason)) if id == newest.get_value() => {
                    self.phase.set(Phase::Failed(reason));
                }
                Err(_) => {}
            }
        });
    }

    /// Shows the answer that waits.
    fn take(self) {
        let reply = self.solving.reply.try_update_value(Option::take).flatten();
        let Some(Reply { id, case, result }) = reply else {
            return;
        };
        let is_newest = id == self.solving.newest.get_value();
        match result {
            Ok(Solution {
                answer,
                duration_ms,
            }) => {
                if self.first_answer_ms.get_untracked().is_none() {
                    self.first_answer_ms.set(Some(now_ms()));
                }
                self.latest.set(Some(Arc::new(Solved {
                    id,
                    case,
                    answer,
                    duration_ms,
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

    /// Asks for the catalog, unless it is here.
    fn read_catalog(self) {
        let Some(link) = self.solver.get_value() else {
            return;
        };
        if self.catalog.with_untracked(Option::is_none) {
            spawn_local(async move {
                if let Ok(catalog) = link.ask_once(&ReadCatalog).await {
                    self.catalog.set(Some(Arc::new(catalog)));
                }
            });
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
        if let Some(link) = self.solver.get_value() {
            link.start_anew();
            self.read_catalog();
            self.solve(self.case.get_untracked());
        }
    }
}
