//! `web-bindgen FOLDER MODULE.wasm...`: for each module the JavaScript that loads it and lets it call the browser, and the
//! module fitted to it, as `FOLDER/MODULE.js` and `FOLDER/MODULE_bg.wasm`.

use anyhow::{Context, Result};
use wasm_bindgen_cli_support::Bindgen;

fn main() -> Result<()> {
    let mut arguments = std::env::args().skip(1);
    let folder = arguments
        .next()
        .context("usage: web-bindgen FOLDER MODULE.wasm...")?;
    for module in arguments {
        Bindgen::new()
            .web(true)?
            .typescript(false)
            .remove_name_section(true)
            .remove_producers_section(true)
            .input_path(&module)
            .generate(&folder)
            .with_context(|| format!("cannot make JavaScript for {module}"))?;
    }
    Ok(())
}
