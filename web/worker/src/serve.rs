//! The workers' side of the connection.

use crate::clock::now_ms;
use crate::desk::Desk;
use crate::protocol::{BEGUN, Kind, answer};
use msape::Library;
use std::ops::ControlFlow;
use wasm_bindgen::{JsCast, JsValue, closure::Closure};
use web_sys::{DedicatedWorkerGlobalScope, MessageEvent};

/// Least time between two messages of progress, ms: more often than anybody reads.
const PROGRESS_MS: f64 = 100.0;

/// An error as sent to the page.
fn said(error: impl ToString) -> JsValue {
    JsValue::from_str(&error.to_string())
}

/// Reads the library, tells the page that the worker is ready, and answers questions of these kinds until it is ended.
///
/// # Errors
/// Errors of the browser, or a data file that cannot be read.
pub fn serve(kinds: &'static [Kind]) -> Result<(), JsValue> {
    console_error_panic_hook::set_once();
    let desk = Desk::new(Library::builtin().map_err(said)?);
    let scope: DedicatedWorkerGlobalScope = js_sys::global().unchecked_into();
    let on_message = Closure::<dyn Fn(MessageEvent) -> Result<(), JsValue>>::new({
        let scope = scope.clone();
        move |event: MessageEvent| {
            scope.post_message(&BEGUN.into())?;
            let message = js_sys::Uint8Array::new(&event.data()).to_vec();
            let mut told_ms = now_ms();
            let mut progress = |done: f64| {
                if now_ms() - told_ms > PROGRESS_MS {
                    told_ms = now_ms();
                    // a message that cannot be sent is only one that nobody sees
                    let _ = scope.post_message(&done.into());
                }
                ControlFlow::Continue(())
            };
            let told = answer(kinds, &message, &desk, &mut progress).map_err(said)?;
            scope.post_message(&js_sys::Uint8Array::from(told.as_slice()))
        }
    });
    scope.set_onmessage(Some(on_message.as_ref().unchecked_ref()));
    // the worker listens as long as it lives
    on_message.forget();
    scope.post_message(&JsValue::TRUE)
}
