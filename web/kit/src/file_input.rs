//! File input.

use leptos::prelude::*;
use web_sys::File;

/// Labeled field that opens the chosen file.
#[component]
pub fn FileInput(
    /// Label.
    #[prop(into)]
    label: String,
    /// File name extensions and media types.
    accept: &'static str,
    /// Handler of the file.
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
                    // allows choosing the same file again
                    element.set_value("");
                } />
        </label>
    }
}
