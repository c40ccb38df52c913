//! The page's end of the line to a worker: to the solver, or to the toolbox. Of jobs the newest wins: one is under way, at most
//! one waits. Questions are answered one after the other.

use crate::aerodynamics::{Curves, Question};
use crate::protocol::{self, Ask, Batch, Fault, FileKind, Job, ReadRows, Told, decode, encode};
use cad::export::{Format, Model};
use js_sys::{Function, Promise};
use leptos::prelude::document;
use msape::flight::six_dof::turning::Turn;
use msape::{Answer, Case};
use std::{cell::RefCell, collections::VecDeque, rc::Rc};
use wasm_bindgen::{JsCast, JsValue, closure::Closure};
use wasm_bindgen_futures::JsFuture;
use web_sys::{Event, MessageEvent, Worker, WorkerOptions, WorkerType};

/// What the page hears of the worker.
pub enum News {
    /// What the solver says.
    Told(protocol::News),
    /// The worker failed; it has been started anew.
    Failed(String),
}

/// What is said of an answer to another question.
const OTHER_ANSWER: &str = "the solver answered something else";

/// A worker and what it has to do.
#[derive(Clone)]
pub struct WorkerLink(Rc<RefCell<Line>>);

/// Which worker a line leads to.
#[derive(Clone, Copy, PartialEq)]
pub enum Role {
    /// The one that solves jobs.
    Solver,
    /// The one that answers questions.
    Toolbox,
}

struct Line {
    role: Role,
    worker: Option<Worker>,
    on_news: Rc<dyn Fn(News)>,
    phase: Phase,
    waiting: Option<Job>,
    /// Questions that wait, and what resolves the promise of each; the first may be under way.
    questions: VecDeque<(Ask, Function)>,
}

#[derive(Clone, Copy, PartialEq)]
enum Phase {
    Starting,
    Idle,
    /// With a job.
    Solving,
    /// With the first question.
    Answering,
}

impl WorkerLink {
    /// Starts the worker; `on_news` is called with what the solver says and with each failure.
    pub fn start(role: Role, on_news: impl Fn(News) + 'static) -> WorkerLink {
        let link = WorkerLink(Rc::new(RefCell::new(Line {
            role,
            worker: None,
            on_news: Rc::new(on_news),
            phase: Phase::Starting,
            waiting: None,
            questions: VecDeque::new(),
        })));
        link.start_worker();
        link
    }

    /// Asks for a case to be solved; a job that still waits is dropped.
    pub fn solve(&self, id: u64, case: Case) {
        self.0.borrow_mut().waiting = Some(Job { id, case });
        self.send_next();
    }

    /// Time that a batch takes in the worker, ms.
    ///
    /// # Errors
    /// Why it could not be measured.
    pub async fn measure(&self, batch: Batch) -> Result<f64, String> {
        match self.ask(Ask::Measure(batch)).await? {
            Told::Measured(measured) => measured,
            _ => Err(OTHER_ANSWER.to_string()),
        }
    }

    /// A flight, or every fault of its case.
    ///
    /// # Errors
    /// Why the worker did not answer.
    pub async fn fly(&self, case: Case) -> Result<Result<Answer, Vec<Fault>>, String> {
        match self.ask(Ask::Fly(case)).await? {
            Told::Flown(flown) => Ok(*flown),
            _ => Err(OTHER_ANSWER.to_string()),
        }
    }

    /// The flight of a design with its attitude, or every fault of its case.
    ///
    /// # Errors
    /// Why the worker did not answer.
    pub async fn attitude(&self, case: Case) -> Result<Result<Answer, Vec<Fault>>, String> {
        match self.ask(Ask::Attitude(Box::new(case))).await? {
            Told::Flown(flown) => Ok(*flown),
            _ => Err(OTHER_ANSWER.to_string()),
        }
    }

    /// One entry of a design from a set of attitudes and rates, or every fault of its case.
    ///
    /// # Errors
    /// Why the worker did not answer.
    pub async fn turn(&self, case: Case, number: u32) -> Result<Result<Turn, Vec<Fault>>, String> {
        match self.ask(Ask::Turn(Box::new(case), number)).await? {
            Told::Turned(turned) => Ok(*turned),
            _ => Err(OTHER_ANSWER.to_string()),
        }
    }

    /// Curves of coefficients, or every fault of their case.
    ///
    /// # Errors
    /// Why the worker did not answer.
    pub async fn aerodynamics(
        &self,
        question: Question,
    ) -> Result<Result<Curves, Vec<Fault>>, String> {
        match self.ask(Ask::Aerodynamics(Box::new(question))).await? {
            Told::Aerodynamics(curves) => Ok(*curves),
            _ => Err(OTHER_ANSWER.to_string()),
        }
    }

    /// The rows of a file, or every fault of it.
    ///
    /// # Errors
    /// Why the worker did not answer.
    pub async fn read(
        &self,
        kind: FileKind,
        bytes: Vec<u8>,
    ) -> Result<Result<ReadRows, Vec<String>>, String> {
        match self.ask(Ask::Read(kind, bytes)).await? {
            Told::Read(rows) => Ok(rows),
            _ => Err(OTHER_ANSWER.to_string()),
        }
    }

    /// A model as a file, in bytes.
    ///
    /// # Errors
    /// Why the worker did not answer.
    pub async fn write(&self, format: Format, model: Model) -> Result<Vec<u8>, String> {
        match self.ask(Ask::Write(format, Box::new(model))).await? {
            Told::Written(bytes) => Ok(bytes),
            _ => Err(OTHER_ANSWER.to_string()),
        }
    }

    async fn ask(&self, ask: Ask) -> Result<Told, String> {
        let mut ask = Some(ask);
        let promise = Promise::new(&mut |resolve, _| {
            if let Some(ask) = ask.take() {
                self.0.borrow_mut().questions.push_back((ask, resolve));
            }
        });
        self.send_next();
        let told = JsFuture::from(promise).await.unwrap_or_else(|error| error);
        match told.dyn_into::<js_sys::Uint8Array>() {
            Ok(bytes) => decode(&bytes.to_vec()).map_err(|error| error.to_string()),
            Err(reason) => Err(reason.as_string().unwrap_or_default()),
        }
    }

    /// Ends the first question with the bytes of its answer or a reason.
    fn settle(&self, told: &JsValue) {
        let first = self.0.borrow_mut().questions.pop_front();
        if let Some((_, resolve)) = first {
            // Resolving a promise throws nothing.
            let _ = resolve.call1(&JsValue::UNDEFINED, told);
        }
    }

    fn send_next(&self) {
        let mut line = self.0.borrow_mut();
        if line.phase != Phase::Idle {
            return;
        }
        let Some(worker) = line.worker.clone() else {
            return;
        };
        let (phase, bytes) = match line.waiting.take() {
            Some(job) => (Phase::Solving, encode(&job)),
            None => match line.questions.front() {
                Some((ask, _)) => (Phase::Answering, encode(ask)),
                None => return,
            },
        };
        line.phase = phase;
        drop(line);
        let sent = bytes.map_err(|error| error.to_string()).and_then(|bytes| {
            worker
                .post_message(&js_sys::Uint8Array::from(bytes.as_slice()))
                .map_err(|error| format!("{error:?}"))
        });
        if let Err(error) = sent {
            self.news(News::Failed(error));
        }
    }

    fn start_worker(&self) {
        self.0.borrow_mut().phase = Phase::Starting;
        match self.try_start() {
            Ok(worker) => self.0.borrow_mut().worker = Some(worker),
            Err(error) => self.news(News::Failed(format!("{error:?}"))),
        }
    }

    fn try_start(&self) -> Result<Worker, JsValue> {
        let options = WorkerOptions::new();
        options.set_type(WorkerType::Module);
        let worker = Worker::new_with_options(&script(self.0.borrow().role)?, &options)?;
        let on_message = Closure::<dyn Fn(MessageEvent)>::new({
            let link = self.clone();
            move |event: MessageEvent| link.receive(&event)
        });
        worker.set_onmessage(Some(on_message.as_ref().unchecked_ref()));
        on_message.forget();
        let on_error = Closure::<dyn Fn(Event)>::new({
            let link = self.clone();
            move |_: Event| {
                link.news(News::Failed("the solver stopped".to_string()));
                if let Some(worker) = link.0.borrow_mut().worker.take() {
                    worker.terminate();
                }
                while !link.0.borrow().questions.is_empty() {
                    link.settle(&"the solver stopped".into());
                }
                link.start_worker();
            }
        });
        worker.set_onerror(Some(on_error.as_ref().unchecked_ref()));
        on_error.forget();
        Ok(worker)
    }

    fn receive(&self, event: &MessageEvent) {
        let (phase, role) = {
            let mut line = self.0.borrow_mut();
            (std::mem::replace(&mut line.phase, Phase::Idle), line.role)
        };
        let data = event.data();
        if phase == Phase::Answering {
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

/// Address of a worker's script, from the page.
fn script(role: Role) -> Result<String, JsValue> {
    let attribute = match role {
        Role::Solver => "data-solver",
        Role::Toolbox => "data-tools",
    };
    document()
        .get_element_by_id("worker-files")
        .and_then(|files| files.get_attribute(attribute))
        .ok_or_else(|| "the page names no worker".into())
}
