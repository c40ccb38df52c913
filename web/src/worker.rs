//! The page's end of the line to the worker. The newest edit wins: one job is under way, at most one waits.

use crate::protocol::{Job, Reply, decode, encode};
use leptos::prelude::document;
use msape::Case;
use std::{cell::RefCell, rc::Rc};
use wasm_bindgen::{JsCast, JsValue, closure::Closure};
use web_sys::{Event, MessageEvent, Worker, WorkerOptions, WorkerType};

/// What the page hears of the worker.
pub enum News {
    /// A job is done.
    Reply(Box<Reply>),
    /// The worker failed; it has been started anew.
    Failed(String),
}

/// A worker and what it has to do.
#[derive(Clone)]
pub struct WorkerLink(Rc<RefCell<Line>>);

struct Line {
    worker: Option<Worker>,
    on_news: Rc<dyn Fn(News)>,
    phase: Phase,
    waiting: Option<Job>,
}

#[derive(Clone, Copy, PartialEq)]
enum Phase {
    Starting,
    Idle,
    Busy,
}

impl WorkerLink {
    /// Starts the worker; `on_news` is called with each of its replies and failures.
    pub fn start(on_news: impl Fn(News) + 'static) -> WorkerLink {
        let link = WorkerLink(Rc::new(RefCell::new(Line {
            worker: None,
            on_news: Rc::new(on_news),
            phase: Phase::Starting,
            waiting: None,
        })));
        link.start_worker();
        link
    }

    /// Asks for a case to be solved; a job that still waits is dropped.
    pub fn solve(&self, id: u64, case: Case) {
        self.0.borrow_mut().waiting = Some(Job { id, case });
        self.send_next();
    }

    fn send_next(&self) {
        let mut line = self.0.borrow_mut();
        if line.phase != Phase::Idle {
            return;
        }
        let (Some(worker), Some(job)) = (line.worker.clone(), line.waiting.take()) else {
            return;
        };
        line.phase = Phase::Busy;
        drop(line);
        let sent = encode(&job)
            .map_err(|error| error.to_string())
            .and_then(|bytes| {
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
        let worker = Worker::new_with_options(&script()?, &options)?;
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
                link.start_worker();
            }
        });
        worker.set_onerror(Some(on_error.as_ref().unchecked_ref()));
        on_error.forget();
        Ok(worker)
    }

    fn receive(&self, event: &MessageEvent) {
        self.0.borrow_mut().phase = Phase::Idle;
        self.send_next();
        if let Ok(bytes) = event.data().dyn_into::<js_sys::Uint8Array>() {
            match decode::<Reply>(&bytes.to_vec()) {
                Ok(reply) => self.news(News::Reply(Box::new(reply))),
                Err(error) => self.news(News::Failed(error.to_string())),
            }
        }
    }

    fn news(&self, news: News) {
        let on_news = self.0.borrow().on_news.clone();
        on_news(news);
    }
}

/// Address of the worker's script, from the page.
fn script() -> Result<String, JsValue> {
    document()
        .get_element_by_id("worker-files")
        .and_then(|files| files.get_attribute("data-script"))
        .ok_or_else(|| "the page names no worker".into())
}
