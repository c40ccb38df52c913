//! The page's connection to a worker. Questions are answered one after the other, and only the newest of each asker counts
//! ([`queue`]); a worker that keeps a newer one waiting is ended. A worker that fails or is silent ([`watch`]) is
//! restarted if something waits for it, with increasing delay, until the user asks again.

mod queue;
mod start;
mod unanswered;
mod watch;

use crate::clock::now_ms;
use crate::protocol::{BEGUN, Question, Role, decode, encode};
use gloo::timers::callback::Interval;
use js_sys::{Function, Promise};
use queue::{Queue, Waiting};
use start::Listening;
use std::cell::RefCell;
use std::rc::Rc;
use unanswered::{OUTDATED, STOPPED};
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::JsFuture;
use watch::{Phase, Verdict, Watch};
use web_sys::{MessageEvent, Worker};

pub use unanswered::Unanswered;

/// News of a connection, apart from answers.
pub enum News {
    /// The work takes long; message.
    Long(String),
    /// The worker failed; message.
    Failed(String),
}

/// Receiver of the fraction done.
pub type OnProgress = Rc<dyn Fn(f64)>;

/// Interval between checks of the worker, ms.
const LOOK_MS: u32 = 250;

/// Connection to a worker, with its pending work.
#[derive(Clone)]
pub struct WorkerLink(Rc<RefCell<Line>>);

/// Resolves the promise of a question; told of its progress.
struct Destination {
    resolve: Function,
    on_progress: Option<OnProgress>,
}

struct Line {
    role: Role,
    worker: Option<Worker>,
    listening: Option<Listening>,
    /// Number of the worker: messages of an older, ended one are ignored.
    number: u32,
    on_news: Rc<dyn Fn(News)>,
    watch: Watch,
    /// Checks the worker as long as the connection is used.
    look: Option<Interval>,
    /// Whether the active question was already sent to a worker that has disappeared.
    again: bool,
    /// Reason of the last failure.
    reason: String,
    /// Fraction of the active question that is done, once the worker has told it.
    done: Option<f64>,
    /// Questions, of which the first may be active.
    questions: Queue<Vec<u8>, u32, Destination>,
}

impl Line {
    /// Whether something waits for the worker.
    fn is_needed(&self) -> bool {
        !self.questions.is_empty()
    }

    /// Whether the first question has been sent.
    fn is_under_way(&self) -> bool {
        matches!(self.watch.phase, Phase::Sent(_) | Phase::Busy(_))
    }
}

impl WorkerLink {
    /// Starts the worker; `on_news` is called while work takes long and with each failure.
    pub fn start(role: Role, on_news: impl Fn(News) + 'static) -> WorkerLink {
        let link = WorkerLink(Rc::new(RefCell::new(Line {
            role,
            worker: None,
            listening: None,
            number: 0,
            on_news: Rc::new(on_news),
            watch: Watch::new(now_ms()),
            look: None,
            again: false,
            reason: String::new(),
            done: None,
            questions: Queue::default(),
        })));
        link.start_worker();
        let watched = link.clone();
        let look = Interval::new(LOOK_MS, move || watched.look());
        link.0.borrow_mut().look = Some(look);
        link
    }

    /// Answer to a question; of the questions of one `asker` that wait, only the newest is answered.
    ///
    /// # Errors
    /// The refusal of the question, or the reason for which there is no answer.
    pub async fn ask<Q: Question>(
        &self,
        asker: Option<u32>,
        question: &Q,
    ) -> Result<Result<Q::Answer, Q::Refusal>, Unanswered> {
        self.ask_watched(asker, question, None).await
    }

    /// Answer to a question as from [`WorkerLink::ask`]; `on_progress` gets the fraction done of work that takes long.
    ///
    /// # Errors
    /// Those of [`WorkerLink::ask`].
    pub async fn ask_watched<Q: Question>(
        &self,
        asker: Option<u32>,
        question: &Q,
        on_progress: Option<OnProgress>,
    ) -> Result<Result<Q::Answer, Q::Refusal>, Unanswered> {
        let failed = |error: postcard::Error| Unanswered::Failed(error.to_string());
        let message = encode(question).map_err(failed)?;
        let told = self.tell(asker, message, on_progress).await?;
        decode::<Q>(&told).map_err(failed)
    }

    /// Answer to a question that no other replaces; a failure of the worker is a refusal.
    ///
    /// # Errors
    /// The refusal of the question.
    pub async fn ask_once<Q: Question>(&self, question: &Q) -> Result<Q::Answer, Q::Refusal> {
        let told = self.ask(None, question).await;
        told.unwrap_or_else(Unanswered::refuse::<Q>)
    }

    /// Ends the active work and refuses all that waits.
    pub fn stop(&self) {
        self.give_up();
        self.settle_all(&STOPPED.into());
        self.0.borrow_mut().watch.phase = Phase::Stopped;
        self.news(News::Failed(STOPPED.to_string()));
    }

    /// Starts a worker at once, whatever failed before.
    pub fn start_anew(&self) {
        self.give_up();
        let mut line = self.0.borrow_mut();
        (line.watch.failures, line.again) = (0, false);
        drop(line);
        self.start_worker();
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

    /// Bytes of the answer to a message.
    async fn tell(
        &self,
        asker: Option<u32>,
        message: Vec<u8>,
        on_progress: Option<OnProgress>,
    ) -> Result<Vec<u8>, Unanswered> {
        let mut waiting = Some((message, on_progress));
        let promise = Promise::new(&mut |resolve, _| {
            if let Some((ask, on_progress)) = waiting.take() {
                let answer = Destination {
                    resolve,
                    on_progress,
                };
                self.put(Waiting { ask, asker, answer });
            }
        });
        self.start_if_due();
        self.send_next();
        let told = JsFuture::from(promise).await.unwrap_or_else(|error| error);
        match told.dyn_into::<js_sys::Uint8Array>() {
            Ok(bytes) => Ok(bytes.to_vec()),
            Err(reason) => Err(Unanswered::of(reason.as_string().unwrap_or_default())),
        }
    }

    fn put(&self, question: Waiting<Vec<u8>, u32, Destination>) {
        let mut line = self.0.borrow_mut();
        let under_way = line.is_under_way();
        let dropped = line.questions.push(question, under_way);
        if line.questions.first_is_outdated() {
            line.watch.edit_waits.get_or_insert(now_ms());
        }
        drop(line);
        dropped
            .iter()
            .for_each(|answer| resolve(answer, &OUTDATED.into()));
    }

    /// Resolves the first question with the bytes of its answer or with a reason; returns whether there was one.
    fn settle(&self, told: &JsValue) -> bool {
        let mut line = self.0.borrow_mut();
        line.done = None;
        let first = line.questions.pop();
        drop(line);
        first.inspect(|answer| resolve(answer, told)).is_some()
    }

    fn settle_all(&self, reason: &JsValue) {
        while self.settle(reason) {}
    }

    fn send_next(&self) {
        let mut line = self.0.borrow_mut();
        if line.watch.phase != Phase::Idle {
            return;
        }
        let Some(worker) = line.worker.clone() else {
            return;
        };
        let Some(message) = line.questions.first() else {
            return;
        };
        let message = js_sys::Uint8Array::from(message.as_slice());
        line.watch.edit_waits = None;
        line.watch.phase = Phase::Sent(now_ms());
        drop(line);
        if let Err(error) = worker.post_message(&message) {
            self.fail(&format!("cannot be asked: {error:?}"));
        }
    }

    /// Checks whether the worker is alive.
    fn look(&self) {
        let mut line = self.0.borrow_mut();
        let needed = line.is_needed();
        let verdict = line.watch.look(now_ms(), needed);
        let (name, done) = (line.role.name(), line.done);
        let starts = matches!(line.watch.phase, Phase::Starting(_));
        let reason = line.reason.clone();
        drop(line);
        match verdict {
            Verdict::Wait => {}
            Verdict::Long(so_far_ms) => {
                let so_far_s = so_far_ms / 1e3;
                self.news(News::Long(match (starts, done) {
                    (true, _) => format!("{name} is loading, {so_far_s:.0} s so far"),
                    (false, Some(done)) => format!(
                        "solving, {so_far_s:.0} s so far, {:.0} % done; a change of an input ends it",
                        100.0 * done
                    ),
                    (false, None) => {
                        format!("solving, {so_far_s:.0} s so far; a change of an input ends it")
                    }
                }));
            }
            Verdict::Down(wait_ms) => self.news(News::Failed(starts_in(&reason, wait_ms))),
            Verdict::Start => self.start_worker(),
            Verdict::NotLoaded => self.fail("does not load"),
            Verdict::Gone => {
                let again = std::mem::replace(&mut self.0.borrow_mut().again, true);
                if again {
                    self.0.borrow_mut().again = false;
                    return self.fail("does not answer");
                }
                self.restart();
            }
            Verdict::Silent => self.fail("gave no answer for two minutes and was ended"),
            Verdict::Outdated => self.restart(),
        }
    }

    /// Ends the worker and starts another one, which gets the active question again unless its asker has a newer one.
    fn restart(&self) {
        let outdated = self.0.borrow().questions.first_is_outdated();
        if outdated {
            self.settle(&OUTDATED.into());
        }
        self.give_up();
        self.start_worker();
    }

    /// Ends the worker, with `did` as the description of the failure, and schedules a restart if something waits; the
    /// active question is not repeated. A solver that does not load keeps its questions for a later one that may.
    fn fail(&self, did: &str) {
        let line = self.0.borrow();
        let reason = format!("{} {did}", line.role.name());
        let under_way = line.is_under_way();
        let loads = matches!(line.watch.phase, Phase::Starting(_));
        let keeps = line.role == Role::Solver;
        drop(line);
        self.give_up();
        let mut line = self.0.borrow_mut();
        let wait_ms = line.watch.fail(now_ms());
        line.reason.clone_from(&reason);
        drop(line);
        if loads && (!keeps || wait_ms.is_none()) {
            self.settle_all(&reason.as_str().into());
        } else if under_way {
            self.settle(&reason.as_str().into());
        }
        if self.0.borrow().is_needed() {
            self.news(News::Failed(starts_in(
                &reason,
                wait_ms.unwrap_or_default(),
            )));
        }
        if wait_ms.is_some() {
            self.start_if_due();
        }
    }

    fn give_up(&self) {
        let mut line = self.0.borrow_mut();
        line.number += 1;
        line.done = None;
        if let Some(worker) = line.worker.take() {
            // the handlers are dropped with the next start
            worker.set_onmessage(None);
            worker.set_onerror(None);
            worker.terminate();
        }
    }

    fn receive(&self, event: &MessageEvent) {
        let data = event.data();
        let mut line = self.0.borrow_mut();
        if data.as_string().as_deref() == Some(BEGUN) {
            line.watch.phase = Phase::Busy(now_ms());
            return;
        }
        if let Some(done) = data.as_f64() {
            line.done = Some(done);
            let destination = line.questions.destination();
            let on_progress = destination.and_then(|first| first.on_progress.clone());
            drop(line);
            if let Some(on_progress) = on_progress {
                on_progress(done);
            }
            return;
        }
        let answers = line.is_under_way();
        line.watch.phase = Phase::Idle;
        if answers {
            (line.watch.failures, line.again) = (0, false);
        }
        drop(line);
        if answers {
            self.settle(&data);
        }
        self.send_next();
    }

    fn news(&self, news: News) {
        let on_news = self.0.borrow().on_news.clone();
        on_news(news);
    }
}

/// Resolves the promise of a question.
fn resolve(answer: &Destination, told: &JsValue) {
    // resolving a promise does not throw
    let _ = answer.resolve.call1(&JsValue::UNDEFINED, told);
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
