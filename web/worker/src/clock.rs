//! Clock for the page and the workers.

use js_sys::{Function, Reflect};
use wasm_bindgen::{JsCast, JsValue};

/// Time since navigation to the page or start of the worker, ms; NaN if there is no such clock.
pub fn now_ms() -> f64 {
    read().unwrap_or(f64::NAN)
}

fn read() -> Option<f64> {
    let clock = Reflect::get(&js_sys::global(), &JsValue::from_str("performance")).ok()?;
    let now = Reflect::get(&clock, &JsValue::from_str("now")).ok()?;
    now.dyn_into::<Function>()
        .ok()?
        .call0(&clock)
        .ok()?
        .as_f64()
}
