//! Several workers of one role for many questions: each takes the next one as soon as it is free.

use crate::client::{OnProgress, Unanswered, WorkerLink};
use crate::protocol::{Question, Role};
use std::cell::{Cell, RefCell};
use std::rc::Rc;
use wasm_bindgen_futures::spawn_local;

/// Largest number of workers. Assumed: each holds a library and its program, some 20 MB.
const WORKERS_MAX: usize = 4;

/// Workers of one role, started as they are needed.
#[derive(Clone)]
pub struct Pool {
    role: Role,
    links: Rc<RefCell<Vec<WorkerLink>>>,
}

/// Run of many questions, until all are answered or it is stopped.
#[derive(Clone)]
pub struct Run(Rc<Cell<bool>>);

impl Run {
    /// Asks no further question; answers of questions under way are dropped.
    pub fn stop(&self) {
        self.0.set(true);
    }

    fn is_stopped(&self) -> bool {
        self.0.get()
    }
}

impl Pool {
    /// A pool without workers.
    pub fn new(role: Role) -> Pool {
        let links = Rc::default();
        Pool { role, links }
    }

    /// A number of workers, started if they do not exist: at most `count`, one less than the processors, and
    /// [`WORKERS_MAX`], and at least one.
    pub fn links(&self, count: usize) -> Vec<WorkerLink> {
        let navigator = web_sys::window().map(|window| window.navigator());
        let processors = navigator.map_or(1.0, |navigator| navigator.hardware_concurrency());
        let count = count.min(processors as usize).clamp(1, WORKERS_MAX);
        let mut links = self.links.borrow_mut();
        while links.len() < count {
            // no news: the question gets the reason if the worker fails
            links.push(WorkerLink::start(self.role, |_| {}));
        }
        links[..count].to_vec()
    }

    /// Asks all questions; `on_progress` gets the index and the fraction done of each under way, `on_answer` the index and
    /// the answer of each, in the order in which they are answered.
    pub fn ask_each<Q: Question + 'static>(
        &self,
        questions: Vec<Q>,
        on_progress: impl Fn(usize, f64) + 'static,
        on_answer: impl Fn(usize, Result<Q::Answer, Q::Refusal>) + 'static,
    ) -> Run {
        let run = Run(Rc::default());
        let links = self.links(questions.len());
        let questions = Rc::new(RefCell::new(questions.into_iter().enumerate()));
        let (on_progress, on_answer) = (Rc::new(on_progress), Rc::new(on_answer));
        for link in links {
            let (run, questions) = (run.clone(), questions.clone());
            let (on_progress, on_answer) = (on_progress.clone(), on_answer.clone());
            spawn_local(async move {
                let next = || questions.borrow_mut().next();
                while let Some((index, question)) = next().filter(|_| !run.is_stopped()) {
                    let (watched, on_progress) = (run.clone(), on_progress.clone());
                    let on_progress: OnProgress = Rc::new(move |done| {
                        if !watched.is_stopped() {
                            on_progress(index, done);
                        }
                    });
                    let told = link.ask_watched(None, &question, Some(on_progress)).await;
                    if !run.is_stopped() {
                        on_answer(index, told.unwrap_or_else(Unanswered::refuse::<Q>));
                    }
                }
            });
        }
        run
    }
}
