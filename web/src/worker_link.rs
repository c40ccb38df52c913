//! The page's end of the line to the worker.

use std::{cell::RefCell, rc::Rc};

use leptos::prelude::document;
use wasm_bindgen::{JsCast, JsValue, closure::Closure};
use web_sys::{MessageEvent, Worker, WorkerOptions, WorkerType};

/// A worker, and the last message that waits until it listens.
pub struct WorkerLink {
    worker: Worker,
    state: Rc<RefCell<State>>,
}

enum State {
    Starting { newest: Option<f64> },
    Listening,
}

/// Starts the worker; `on_answer` is called with each of its answers.
pub fn start(on_answer: impl Fn(f64) + 'static) -> Result<WorkerLink, JsValue> {
    let options = WorkerOptions::new();
    options.set_type(WorkerType::Module);
    let worker = Worker::new_with_options(&script()?, &options)?;
    let state = Rc::new(RefCell::new(State::Starting { newest: None }));
    let on_message = Closure::<dyn Fn(MessageEvent)>::new({
        let (worker, state) = (worker.clone(), state.clone());
        move |event: MessageEvent| match event.data().as_f64() {
            Some(value) => on_answer(value),
            None => {
                if let State::Starting {
                    newest: Some(value),
                } = state.replace(State::Listening)
                {
                    send(&worker, value);
                }
            }
        }
    });
    worker.set_onmessage(Some(on_message.as_ref().unchecked_ref()));
    on_message.forget();
    Ok(WorkerLink { worker, state })
}

impl WorkerLink {
    /// Sends a number, at once or, of several, the newest as soon as the worker listens.
    pub fn post(&self, value: f64) {
        match &mut *self.state.borrow_mut() {
            State::Starting { newest } => *newest = Some(value),
            State::Listening => send(&self.worker, value),
        }
    }
}

fn send(worker: &Worker, value: f64) {
    if let Err(error) = worker.post_message(&value.into()) {
        leptos::logging::error!("the worker takes no message: {error:?}");
    }
}

/// Address of the worker's script, from the page.
fn script() -> Result<String, JsValue> {
    document()
        .get_element_by_id("worker-files")
        .and_then(|files| files.get_attribute("data-script"))
        .ok_or_else(|| "the page names no worker".into())
}
