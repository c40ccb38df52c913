//! The page's connection to a worker: the solver or the toolbox. Only the newest job counts: one is active, at most one
//! waits, and a worker that keeps it waiting is terminated. Questions are answered one after the other, and only the
//! newest of each asker counts ([`queue`]). A worker that fails or is silent ([`watch`]) is restarted if something
//! waits for it, with increasing delay, until the user asks again.

mod questions;
mod queue;
mod start;
mod watch;

use crate::clock::now_ms;
use crate::protocol::{self, Ask, BEGUN, Job, Told, decode, encode};
use js_sys::{Function, Promise};
use leptos::prelude::set_interval_with_handle;
use msape::Case;
pub use questions::Asker;
use queue::{Question, Queue};
use start::Listening;
use std::{cell::RefCell, rc::Rc, time::Duration};
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::JsFuture;
use watch::{Phase, Verdict, Watch};
use web_sys::{MessageEvent, Worker};

/// News from a connection.
pub enum News {
    /// Message of the solver.
    Told(protocol::News),
    /// The work takes long; message.
    Long(String),
    /// The worker failed; message.
    Failed(String),
}

/// Interval between checks of the worker.
const LOOK: Duration = Duration::from_millis(250);

/// Error text after the user ended a run.
const STOPPED: &str = "stopped";
/// Error text for a question replaced by a newer one of its asker; nobody reads it.
const OUTDATED: &str = "a newer question came";

/// Connection to a worker, with its pending work.
#[derive(Clone)]
pub struct WorkerLink(Rc<RefCell<Line>>);

/// Role of the worker.
#[derive(Clone, Copy, PartialEq)]
pub enum Role {
    /// Solves jobs.
    Solver,
    /// Answers questions.
    Toolbox,
}

impl Role {
    /// Name of the worker.
    fn name(self) -> &'static str {
        match self {
            Role::Solver => "the solver",
            Role::Toolbox => "the toolbox",
        }
    }
}

struct Line {
    role: Role,
    worker: Option<Worker>,
    listening: Option<Listening>,
    /// Number of the worker: messages of an older, terminated one are ignored.
    number: u32,
    on_news: Rc<dyn Fn(News)>,
    watch: Watch,
    waiting: Option<Job>,
    /// Job sent last; `at_job` is true while it is active.
    job: Option<Job>,
    at_job: bool,
    /// Whether the active work was already sent to a worker that has disappeared.
    again: bool,
    /// Reason of the last failure.
    reason: String,
    /// Waiting questions with the functions that resolve their promises.
    questions: Queue<Ask, Asker, Function>,
}

impl Line {
    /// Whether something waits for the worker.
    fn is_needed(&self) -> bool {
        self.waiting.is_some() || !self.questions.is_empty()
    }

    /// Whether the first question has been sent.
    fn is_at_question(&self) -> bool {
        !self.at_job && matches!(self.watch.phase, Phase::Sent(_) | Phase::Busy(_))
    }
}

impl WorkerLink {
    /// Starts the worker; `on_news` is called with each message of the solver and with each failure.
    pub fn start(role: Role, on_news: impl Fn(News) + 'static) -> WorkerLink {
        let link = WorkerLink(Rc::new(RefCell::new(Line {
            role,
            worker: None,
            listening: None,
            number: 0,
            on_news: Rc::new(on_news),
            watch: Watch::new(now_ms()),
            waiting: None,
            job: None,
            at_job: false,
            again: false,
            reason: String::new(),
            questions: Queue::default(),
        })));
        link.start_worker();
        let watched = link.clone();
        // the timer lives as long as the page; a browser without timers only lacks the watchdog
        let _ = set_interval_with_handle(move || watched.look(), LOOK);
        link
    }

    /// Requests the solution of a case; a waiting job is dropped.
    pub fn solve(&self, id: u64, case: Case) {
        let mut line = self.0.borrow_mut();
        line.waiting = Some(Job { id, case });
        line.watch.edit_waits.get_or_insert(now_ms());
        drop(line);
        self.start_if_due();
        self.send_next();
    }

    /// Starts a worker for waiting work, if there is none and a start is allowed now.
    fn start_if_due(&self) {
        let line = self.0.borrow();
        let due = line.is_needed() && line.watch.may_start(now_ms());
        drop(line);
        if due {
            self.start_worker();
        }
    }

    fn ask_job_again(&self) {
        let line = &mut *self.0.borrow_mut();
        if line.waiting.is_none() {
            line.waiting.clone_from(&line.job);
        }
    }

    /// Ends the active work; [`WorkerLink::try_again`] requests it again.
    pub fn stop(&self) {
        self.give_up();
        while self.settle(&STOPPED.into()) {}
        self.0.borrow_mut().watch.phase = Phase::Stopped;
        self.news(News::Failed(STOPPED.to_string()));
    }

    /// Restarts the worker immediately and requests the newest case again.
    pub fn try_again(&self) {
        self.give_up();
        let mut line = self.0.borrow_mut();
        (line.watch.failures, line.again) = (0, false);
        drop(line);
        self.ask_job_again();
        self.start_worker();
    }

    /// Answer to a question, or the reason why there is none.
    async fn ask(&self, asker: Option<Asker>, ask: Ask) -> Result<Told, String> {
        let mut ask = Some(ask);
        let promise = Promise::new(&mut |answer, _| {
            if let Some(ask) = ask.take() {
                self.put(Question { ask, asker, answer });
            }
        });
        self.start_if_due();
        self.send_next();
        let told = JsFuture::from(promise).await.unwrap_or_else(|error| error);
        match told.dyn_into::<js_sys::Uint8Array>() {
            Ok(bytes) => decode(&bytes.to_vec()).map_err(|error| error.to_string()),
            Err(reason) => Err(reason.as_string().unwrap_or_default()),
        }
    }

    fn put(&self, question: Question<Ask, Asker, Function>) {
        let mut line = self.0.borrow_mut();
        let under_way = line.is_at_question();
        let dropped = line.questions.push(question, under_way);
        if under_way && line.questions.first_is_outdated() {
            line.watch.edit_waits.get_or_insert(now_ms());
        }
        drop(line);
        dropped
            .iter()
            .for_each(|answer| resolve(answer, &OUTDATED.into()));
    }

    /// Resolves the first question with the bytes of its answer or with a reason; returns whether there was one.
    fn settle(&self, told: &JsValue) -> bool {
        let first = self.0.borrow_mut().questions.pop();
        first.inspect(|answer| resolve(answer, told)).is_some()
    }

    fn send_next(&self) {
        let mut line = self.0.borrow_mut();
        if line.watch.phase != Phase::Idle {
            return;
        }
        let Some(worker) = line.worker.clone() else {
            return;
        };
        let bytes = match line.waiting.take() {
            Some(job) => {
                line.at_job = true;
                line.job = Some(job.clone());
                encode(&job)
            }
            None => match line.questions.first() {
                Some(ask) => encode(ask),
                None => return,
            },
        };
        line.watch.edit_waits = None;
        line.watch.phase = Phase::Sent(now_ms());
        drop(line);
        let sent = bytes.map_err(|error| error.to_string()).and_then(|bytes| {
            worker
                .post_message(&js_sys::Uint8Array::from(bytes.as_slice()))
                .map_err(|error| format!("{error:?}"))
        });
        if let Err(error) = sent {
            self.fail(&format!("cannot be asked: {error}"));
        }
    }

    /// Checks whether the worker is alive.
    fn look(&self) {
        let mut line = self.0.borrow_mut();
        let needed = line.is_needed();
        let verdict = line.watch.look(now_ms(), needed);
        let (at_job, name) = (line.at_job, line.role.name());
        let starts = matches!(line.watch.phase, Phase::Starting(_));
        let reason = line.reason.clone();
        drop(line);
        match verdict {
            Verdict::Wait => {}
            Verdict::Long(so_far_ms) if starts => {
                let so_far_s = so_far_ms / 1e3;
                self.news(News::Long(format!(
                    "{name} is loading, {so_far_s:.0} s so far"
                )));
            }
            Verdict::Long(so_far_ms) if at_job => {
                let so_far_s = so_far_ms / 1e3;
                self.news(News::Long(format!(
                    "solving, {so_far_s:.0} s so far; a change of an input ends it"
                )));
            }
            Verdict::Long(_) => {}
            Verdict::Down(wait_ms) => self.news(News::Failed(starts_in(&reason, wait_ms))),
            Verdict::Start => self.start_worker(),
            Verdict::NotLoaded => self.fail("does not load"),
            Verdict::Gone => {
                let again = std::mem::replace(&mut self.0.borrow_mut().again, true);
                if again {
                    self.0.borrow_mut().again = false;
                    return self.fail("does not answer");
                }
                if at_job {
                    self.ask_job_again();
                }
                self.give_up();
                self.start_worker();
            }
            Verdict::Silent => self.fail("gave no answer for two minutes and was ended"),
            Verdict::Outdated => {
                // an active question stays first and is repeated after the edit, unless its asker has a newer one
                if !at_job && self.0.borrow().questions.first_is_outdated() {
                    self.settle(&OUTDATED.into());
                }
                self.give_up();
                self.start_worker();
            }
        }
    }

    /// Terminates the worker, with `did` as the description of the failure, and schedules a restart if something waits;
    /// active work is not repeated automatically.
    fn fail(&self, did: &str) {
        let line = self.0.borrow();
        let reason = format!("{} {did}", line.role.name());
        let (at_job, at_question) = (line.at_job, line.is_at_question());
        let loads = matches!(line.watch.phase, Phase::Starting(_));
        drop(line);
        self.give_up();
        if loads {
            // no question can be answered now; a job stays, since a later worker may load
            while self.settle(&reason.as_str().into()) {}
        } else if at_question {
            self.settle(&reason.as_str().into());
        }
        let mut line = self.0.borrow_mut();
        let wait_ms = line.watch.fail(now_ms());
        let job_waits = line.waiting.is_some();
        let words = match wait_ms {
            Some(wait_ms) if job_waits => starts_in(&reason, wait_ms),
            _ => reason.clone(),
        };
        line.reason = reason;
        drop(line);
        if at_job || job_waits {
            self.news(News::Failed(words));
        }
        if wait_ms.is_some() {
            self.start_if_due();
        }
    }

    fn give_up(&self) {
        let mut line = self.0.borrow_mut();
        line.number += 1;
        line.at_job = false;
        if let Some(worker) = line.worker.take() {
            // the handlers are dropped with the next start
            worker.set_onmessage(None);
            worker.set_onerror(None);
            worker.terminate();
        }
    }

    fn receive(&self, event: &MessageEvent) {
        let data = event.data();
        if data.as_string().as_deref() == Some(BEGUN) {
            self.0.borrow_mut().watch.phase = Phase::Busy(now_ms());
            return;
        }
        let mut line = self.0.borrow_mut();
        let role = line.role;
        let answers = matches!(line.watch.phase, Phase::Sent(_) | Phase::Busy(_));
        line.watch.phase = Phase::Idle;
        line.at_job = false;
        if answers {
            (line.watch.failures, line.again) = (0, false);
        }
        drop(line);
        if role == Role::Toolbox && answers {
            self.settle(&data);
        }
        self.send_next();
        if role == Role::Solver
            && let Some(bytes) = data.dyn_ref::<js_sys::Uint8Array>()
        {
            self.news(match decode(&bytes.to_vec()) {
                Ok(news) => News::Told(news),
                Err(error) => News::Failed(error.to_string()),
            });
        }
    }

    fn news(&self, news: News) {
        let on_news = self.0.borrow().on_news.clone();
        on_news(news);
    }
}

/// Resolves the promise of a question.
fn resolve(answer: &Function, told: &JsValue) {
    // resolving a promise does not throw
    let _ = answer.call1(&JsValue::UNDEFINED, told);
}

fn starts_in(reason: &str, wait_ms: f64) -> String {
    if wait_ms == 0.0 {
        return reason.to_string();
    }
    format!(
        "{reason}; it is started again in {:.0} s",
        (wait_ms / 1e3).ceil()
    )
}
