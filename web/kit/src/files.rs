//! Download and upload of files.

use gloo::file::{Blob, File, ObjectUrl};
use leptos::prelude::*;
use std::time::Duration;
use wasm_bindgen::{JsCast, JsValue, closure::Closure};
use wasm_bindgen_futures::JsFuture;
use web_sys::{HtmlAnchorElement, HtmlCanvasElement};

/// Largest file size, bytes.
const BYTES_MAX: f64 = 5e6;

/// Offers text to the user as a file.
///
/// # Errors
/// Errors of the browser.
pub fn download(name: &str, mime: &str, text: &str) -> Result<(), JsValue> {
    hand_over(name, Blob::new_with_options(text, Some(mime)).into())
}

/// Offers bytes to the user as a file.
///
/// # Errors
/// Errors of the browser.
pub fn download_bytes(name: &str, mime: &str, bytes: &[u8]) -> Result<(), JsValue> {
    hand_over(name, Blob::new_with_options(bytes, Some(mime)).into())
}

/// Offers a drawing to the user as a PNG file.
///
/// # Errors
/// Errors of the browser.
pub fn download_png(name: String, canvas: &HtmlCanvasElement) -> Result<(), JsValue> {
    let on_blob = Closure::once_into_js(move |blob: JsValue| {
        if let Ok(blob) = blob.dyn_into::<web_sys::Blob>() {
            // The file is a convenience; a browser that refuses it says so itself.
            let _ = hand_over(&name, Blob::from(blob).into());
        }
    });
    canvas.to_blob(on_blob.unchecked_ref())
}

fn hand_over(name: &str, address: ObjectUrl) -> Result<(), JsValue> {
    let anchor: HtmlAnchorElement = document().create_element("a")?.unchecked_into();
    anchor.set_href(&address);
    anchor.set_download(name);
    anchor.click();
    // The browser reads the address after this call: it is given back later.
    set_timeout(move || drop(address), Duration::from_secs(20));
    Ok(())
}

/// Text of a file chosen by the user.
///
/// # Errors
/// A message for the user.
pub async fn read(file: web_sys::File) -> Result<String, String> {
    let bytes = bytes(file).await?;
    Ok(text_of(&bytes))
}

/// Text in any encoding; undecodable bytes are replaced.
pub fn text_of(bytes: &[u8]) -> String {
    match cad::text::decode(bytes) {
        Ok(decoded) => decoded.text,
        Err(_) => String::from_utf8_lossy(bytes).into_owned(),
    }
}

/// Bytes of a file chosen by the user.
///
/// # Errors
/// A message for the user.
pub async fn bytes(file: web_sys::File) -> Result<Vec<u8>, String> {
    if file.size() > BYTES_MAX {
        return Err(format!(
            "{} has {:.1} MB; a file has at most {:.0} MB.",
            file.name(),
            file.size() / 1e6,
            BYTES_MAX / 1e6
        ));
    }
    let read = gloo::file::futures::read_as_bytes(&File::from(file)).await;
    read.map_err(|error| format!("The file cannot be read: {error}"))
}

/// Copies text to the clipboard.
///
/// # Errors
/// Errors of the browser.
pub async fn copy(text: String) -> Result<(), JsValue> {
    JsFuture::from(window().navigator().clipboard().write_text(&text)).await?;
    Ok(())
}

/// File name from the name of a run.
pub fn file_name(name: &str, extension: &str) -> String {
    let mut plain: String = name
        .trim()
        .chars()
        .map(|c| if c.is_alphanumeric() { c } else { '-' })
        .collect();
    while plain.contains("--") {
        plain = plain.replace("--", "-");
    }
    let plain = plain.trim_matches('-').to_lowercase();
    let stem = if plain.is_empty() { "msape" } else { &plain };
    format!("{stem}.{extension}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_runs_make_names_of_files() {
        assert_eq!(file_name("MSR EEV / CP (v2)", "toml"), "msr-eev-cp-v2.toml");
        assert_eq!(file_name("  ", "csv"), "msape.csv");
    }
}
