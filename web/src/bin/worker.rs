//! The worker: solves one case after the other, so that the page stays alive.

use msape_web::protocol::BEGUN;
use msape_web::solver::Solver;
use wasm_bindgen::{JsCast, JsValue, closure::Closure};
use web_sys::{DedicatedWorkerGlobalScope, MessageEvent};

fn main() -> Result<(), JsValue> {
    console_error_panic_hook::set_once();
    let scope: DedicatedWorkerGlobalScope = js_sys::global().unchecked_into();
    let solver = Solver::new().map_err(|error| JsValue::from_str(&error.to_string()))?;
    let on_message = Closure::<dyn Fn(MessageEvent) -> Result<(), JsValue>>::new({
        let scope = scope.clone();
        move |event: MessageEvent| {
            scope.post_message(&BEGUN.into())?;
            let job = js_sys::Uint8Array::new(&event.data()).to_vec();
            let reply = solver
                .answer(&job)
                .map_err(|error| JsValue::from_str(&error.to_string()))?;
            scope.post_message(&js_sys::Uint8Array::from(reply.as_slice()))
        }
    });
    scope.set_onmessage(Some(on_message.as_ref().unchecked_ref()));
    on_message.forget();
    scope.post_message(&"ready".into())
}
