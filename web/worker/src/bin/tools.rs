//! Toolbox: a second worker for everything else, fetched on first use.

use msape_worker::questions::TOOLBOX;
use msape_worker::serve::serve;
use wasm_bindgen::JsValue;

fn main() -> Result<(), JsValue> {
    serve(TOOLBOX)
}
