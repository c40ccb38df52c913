//! Solver worker: solves one case after the other, so that the page stays responsive.

use msape_web::serve;
use msape_web::solver::Solver;
use wasm_bindgen::JsValue;

fn main() -> Result<(), JsValue> {
    console_error_panic_hook::set_once();
    let solver = Solver::new().map_err(serve::said)?;
    let ready = solver.ready().map_err(serve::said)?;
    let ready = js_sys::Uint8Array::from(ready.as_slice()).into();
    serve::until_closed(ready, move |job| solver.solve(job).map_err(serve::said))
}
