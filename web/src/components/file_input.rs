//! A file to choose.

use leptos::prelude::*;
use web_sys::File;

/// A labelled field that opens the file that is chosen.
#[component]
pub fn FileInput(
    /// Its label.
    #[prop(into)]
    label: String,
    /// Endings and media types.
    accept: &'static str,
    /// Takes the file.
    open: impl Fn(File) + 'static,
) -> impl IntoView {
    view! {
        <label class="file">
            <span>{label}</span>
            <input type="file" accept=accept
                on:change:target=move |event| {
                    let element = event.target();
                    if let Some(file) = element.files().and_then(|files| files.get(0)) {
                        open(file);
                    }
                    // The same file can be chosen again.
                    element.set_value("");
                } />
        </label>
    }
}
