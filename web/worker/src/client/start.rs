//! Start of a worker, and its message handlers.

use super::WorkerLink;
use super::watch::Phase;
use crate::clock::now_ms;
use crate::protocol::Role;
use wasm_bindgen::{JsCast, JsValue, closure::Closure};
use web_sys::{Event, MessageEvent, Worker, WorkerOptions, WorkerType};

/// Message and error handlers of a worker; they live until the next one is started.
pub(super) type Listening = (Closure<dyn Fn(MessageEvent)>, Closure<dyn Fn(Event)>);

impl WorkerLink {
    /// Starts a worker; waiting work is sent as soon as it listens.
    pub(super) fn start_worker(&self) {
        self.0.borrow_mut().watch.phase = Phase::Starting(now_ms());
        match self.try_start() {
            Ok((worker, listening)) => {
                let line = &mut *self.0.borrow_mut();
                (line.worker, line.listening) = (Some(worker), Some(listening));
            }
            Err(error) => self.fail(&format!("cannot be started: {error:?}")),
        }
    }

    fn try_start(&self) -> Result<(Worker, Listening), JsValue> {
        let options = WorkerOptions::new();
        options.set_type(WorkerType::Module);
        let worker = Worker::new_with_options(&script(self.0.borrow().role)?, &options)?;
        let number = self.0.borrow().number;
        let on_message = Closure::<dyn Fn(MessageEvent)>::new({
            let link = self.clone();
            move |event: MessageEvent| {
                if link.0.borrow().number == number {
                    link.receive(&event);
                }
            }
        });
        worker.set_onmessage(Some(on_message.as_ref().unchecked_ref()));
        let on_error = Closure::<dyn Fn(Event)>::new({
            let link = self.clone();
            move |_: Event| {
                if link.0.borrow().number == number {
                    let loads = matches!(link.0.borrow().watch.phase, Phase::Starting(_));
                    link.fail(if loads { "cannot be loaded" } else { "stopped" });
                }
            }
        });
        worker.set_onerror(Some(on_error.as_ref().unchecked_ref()));
        Ok((worker, (on_message, on_error)))
    }
}

/// Address of a worker's script, from the page.
fn script(role: Role) -> Result<String, JsValue> {
    let attribute = match role {
        Role::Solver => "data-solver",
        Role::Toolbox => "data-tools",
    };
    let document = web_sys::window().and_then(|window| window.document());
    document
        .and_then(|document| document.get_element_by_id("worker-files"))
        .and_then(|files| files.get_attribute(attribute))
        .ok_or_else(|| "the page names no worker".into())
}
