//! Solver: solves one design after the other, so that the page stays responsive.

use msape_worker::questions::SOLVER;
use msape_worker::serve::serve;
use wasm_bindgen::JsValue;

fn main() -> Result<(), JsValue> {
    serve(SOLVER)
}
