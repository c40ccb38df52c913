//! Worker side of the connection to the page.

use crate::protocol::BEGUN;
use wasm_bindgen::{JsCast, JsValue, closure::Closure};
use web_sys::{DedicatedWorkerGlobalScope, MessageEvent};

/// An error as sent to the page.
pub fn said(error: impl ToString) -> JsValue {
    JsValue::from_str(&error.to_string())
}

/// Posts that the worker is ready, that it has received a message, and the answer to it.
///
/// # Errors
/// Errors of the browser.
pub fn until_closed(
    ready: JsValue,
    answer: impl Fn(&[u8]) -> Result<Vec<u8>, JsValue> + 'static,
) -> Result<(), JsValue> {
    let scope: DedicatedWorkerGlobalScope = js_sys::global().unchecked_into();
    let on_message = Closure::<dyn Fn(MessageEvent) -> Result<(), JsValue>>::new({
        let scope = scope.clone();
        move |event: MessageEvent| {
            scope.post_message(&BEGUN.into())?;
            let message = js_sys::Uint8Array::new(&event.data()).to_vec();
            let reply = answer(&message)?;
            scope.post_message(&js_sys::Uint8Array::from(reply.as_slice()))
        }
    });
    scope.set_onmessage(Some(on_message.as_ref().unchecked_ref()));
    // the worker listens as long as it lives
    on_message.forget();
    scope.post_message(&ready)
}
