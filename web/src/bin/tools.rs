//! Toolbox: a second worker for occasional questions, loaded on first use.

use msape_web::serve;
use msape_web::tools::Toolbox;
use wasm_bindgen::JsValue;

fn main() -> Result<(), JsValue> {
    console_error_panic_hook::set_once();
    let toolbox = Toolbox::new().map_err(serve::said)?;
    serve::until_closed("ready".into(), move |ask| {
        toolbox.answer(ask).map_err(serve::said)
    })
}
