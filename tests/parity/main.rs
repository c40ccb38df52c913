//! The same bits natively and in the browser: the same tests run in both, against the same recorded bits.
//!
//! Shipped cases are compared natively by `snapshots`, with the same files.

#[cfg(target_arch = "wasm32")]
mod cases;
mod elementary;

#[cfg(target_arch = "wasm32")]
wasm_bindgen_test::wasm_bindgen_test_configure!(run_in_browser);
