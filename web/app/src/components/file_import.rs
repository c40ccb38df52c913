//! Import from a file that is chosen or dropped, or from pasted text. Faults are shown with their lines, and a faulty
//! file replaces nothing.

use crate::state::State;
use leptos::ev::DragEvent;
use leptos::prelude::*;
use msape_kit::file_input::FileInput;
use msape_kit::files;
use wasm_bindgen_futures::spawn_local;

/// Texts of an import.
#[derive(Clone, Copy)]
pub struct Wording {
    /// Label of the file, such as "Import a table (CSV)".
    pub file: &'static str,
    /// File name extensions and media types.
    pub accept: &'static str,
    /// Identifier of the text field.
    pub id: &'static str,
    /// Label of the text field.
    pub paste: &'static str,
    /// Placeholder: first line of a possible text.
    pub placeholder: &'static str,
    /// Label of the button below it.
    pub button: &'static str,
    /// Name for pasted text, with the extension of its format.
    pub pasted: &'static str,
}

/// Rejected file.
#[derive(Clone, Debug, PartialEq)]
struct Refused {
    name: String,
    faults: Vec<String>,
    /// Faulty lines with their numbers.
    lines: Vec<(usize, String)>,
}

/// Outcome of an import, shown to the user.
#[derive(Clone, Copy)]
pub struct Verdict {
    state: State,
    refused: RwSignal<Option<Refused>>,
}

impl Verdict {
    /// Reports that the file was accepted.
    pub fn taken(self, notice: String) {
        self.refused.set(None);
        self.state.notice.set(notice);
    }

    /// Reports that the file was rejected, with all of its faults.
    pub fn refused(self, name: String, text: &str, faults: Vec<String>) {
        let notice = format!("{name} was not imported; nothing has changed.");
        self.state.notice.set(notice);
        self.refused.set(Some(Refused {
            lines: lines_at_fault(text, &faults),
            name,
            faults,
        }));
    }
}

/// Choose, drop or paste; `import` gets name and bytes and reports its verdict.
#[component]
pub fn FileImport(
    wording: Wording,
    import: impl Fn(String, Vec<u8>, Verdict) + Copy + Send + Sync + 'static,
    /// Notes for the user on the file.
    children: Children,
) -> impl IntoView {
    let pasted = RwSignal::new(String::new());
    let over = RwSignal::new(false);
    let refused = RwSignal::new(None);
    let verdict = Verdict {
        state: State::expect(),
        refused,
    };
    let open = move |file: web_sys::File| {
        let name = file.name();
        spawn_local(async move {
            match files::bytes(file).await {
                Ok(bytes) => import(name, bytes, verdict),
                Err(message) => verdict.refused(name, "", vec![message]),
            }
        });
    };
    let on_drop = move |event: DragEvent| {
        event.prevent_default();
        // otherwise the page opens the dropped file as a case
        event.stop_propagation();
        over.set(false);
        let dropped = event.data_transfer().and_then(|data| data.files());
        if let Some(file) = dropped.and_then(|files| files.get(0)) {
            open(file);
        }
    };
    view! {
        <div class="open drop" class:over=over
            on:dragover=move |event: DragEvent| { event.prevent_default(); over.set(true); }
            on:dragleave=move |_| over.set(false)
            on:drop=on_drop>
            <FileInput label=wording.file accept=wording.accept open=open />
            {children()}
            <label for=wording.id>{wording.paste}</label>
            <textarea id=wording.id rows="4" spellcheck="false" placeholder=wording.placeholder prop:value=pasted
                on:input:target=move |event| pasted.set(event.target().value())></textarea>
            <button type="button" class="small" disabled=move || pasted.with(|text| text.trim().is_empty())
                on:click=move |_| import(wording.pasted.to_string(), pasted.get_untracked().into_bytes(), verdict)>{wording.button}</button>
            <div role="alert">
                {move || refused.get().map(|Refused { name, faults, lines }| view! {
                    <h3 class="note-outside">{format!("{name} has {} fault{}", faults.len(), if faults.len() == 1 { "" } else { "s" })}</h3>
                    <ul class="notes">{faults.into_iter().map(|fault| view! { <li class="note-outside">{fault}</li> }).collect_view()}</ul>
                    {(!lines.is_empty()).then(|| view! {
                        <pre class="fault-lines">{lines.into_iter().map(|(number, line)| view! { <span><b>{number}</b> "  " {line} "\n"</span> }).collect_view()}</pre>
                    })}
                    <button type="button" class="small" on:click=move |_| refused.set(None)>"Dismiss"</button>
                })}
            </div>
        </div>
    }
}

/// Messages of the file reader, to be appended to another sentence.
pub fn notes(remarks: &[String]) -> String {
    remarks
        .iter()
        .map(|remark| format!(" Note: {remark}."))
        .collect()
}

/// File name without extension.
pub fn stem(name: &str) -> String {
    let stem = name.rsplit_once('.').map_or(name, |(stem, _)| stem);
    stem.to_string()
}

/// Lines that faults refer to: "line 12: …".
fn lines_at_fault(text: &str, faults: &[String]) -> Vec<(usize, String)> {
    let mut numbers: Vec<usize> = faults
        .iter()
        .filter_map(|fault| {
            let after = fault.strip_prefix("line ")?;
            after
                .split(|c: char| !c.is_ascii_digit())
                .next()?
                .parse()
                .ok()
        })
        .collect();
    numbers.sort_unstable();
    numbers.dedup();
    numbers
        .into_iter()
        .filter_map(|number| {
            let line = text.lines().nth(number.checked_sub(1)?)?;
            Some((number, line.chars().take(120).collect()))
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_lines_at_fault_are_shown_once_each_in_order() {
        let faults = [
            "line 3: got \"x\", must be a number".to_string(),
            "line 2: too short".to_string(),
            "line 3: again".to_string(),
            "segment 2 crosses segment 5".to_string(),
        ];
        let shown = lines_at_fault("a\nb\nc", &faults);
        assert_eq!(shown, [(2, "b".to_string()), (3, "c".to_string())]);
    }
}
