//! Outlines from files: chosen, dropped or pasted. What is faulty is told at its place, and replaces nothing.

use super::facts::length_units;
use crate::files;
use crate::state::State;
use leptos::ev::DragEvent;
use leptos::prelude::*;
use msape::vehicle::body::from_rows;
use msape::vehicle::body::import::{LengthUnit, read};
use wasm_bindgen_futures::spawn_local;

/// What became of the last file.
#[derive(Clone, Debug, PartialEq)]
struct Refused {
    name: String,
    faults: Vec<String>,
    lines: Vec<(usize, String)>,
}

/// Choose, drop or paste; `take` gets the identifier of what was imported.
#[component]
pub fn Import(take: impl Fn(String) + Copy + Send + Sync + 'static) -> impl IntoView {
    let state = State::expect();
    let unit = RwSignal::new(String::new());
    let pasted = RwSignal::new(String::new());
    let refused = RwSignal::new(None::<Refused>);
    let over = RwSignal::new(false);
    let import = move |name: String, text: String| {
        let symbol = unit.get_untracked();
        match checked(&name, &text, LengthUnit::of(&symbol)) {
            Ok(rows) => {
                refused.set(None);
                let stem = name
                    .rsplit_once('.')
                    .map_or(name.as_str(), |(stem, _)| stem);
                let stem = stem.to_string();
                state.edit(&format!("Import {stem}"), None, |document| {
                    document.with_outlines(|outlines| {
                        outlines.insert(stem.clone(), rows);
                    })
                });
                state
                    .notice
                    .set(format!("{stem} is imported; undo takes it out again."));
                take(format!("own:{stem}"));
            }
            Err(faults) => {
                state
                    .notice
                    .set(format!("{name} was not imported; nothing has changed."));
                refused.set(Some(Refused {
                    lines: lines_at_fault(&text, &faults),
                    name,
                    faults,
                }));
            }
        }
    };
    let open = move |file: web_sys::File| {
        let name = file.name();
        spawn_local(async move {
            match files::read(file).await {
                Ok(text) => import(name, text),
                Err(message) => refused.set(Some(Refused {
                    name,
                    faults: vec![message],
                    lines: Vec::new(),
                })),
            }
        });
    };
    let on_drop = move |event: DragEvent| {
        event.prevent_default();
        // The page opens what is dropped elsewhere as a case.
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
            <label class="file">
                <span>"Import an outline (CSV or DXF)"</span>
                <input type="file" accept=".csv,.txt,.dxf,text/csv,image/vnd.dxf"
                    on:change:target=move |event| {
                        let element = event.target();
                        if let Some(file) = element.files().and_then(|files| files.get(0)) {
                            open(file);
                        }
                        // The same file can be chosen again.
                        element.set_value("");
                    } />
            </label>
            <label class="inline">
                <span>"Its unit"</span>
                <select on:change:target=move |event| unit.set(event.target().value())>
                    <option value="">"as the file says"</option>
                    {length_units().map(|symbol| view! { <option value=symbol>{symbol}</option> })}
                </select>
            </label>
            <p class="quiet">"Or drop a file here. A CSV has points x, r from the nose on the axis to the aft end on the axis and names its unit in the header, such as "<code>"x (mm), r (mm)"</code>". A DXF has lines, arcs and polylines."</p>
            <label for="paste-outline">"Or paste points (CSV)"</label>
            <textarea id="paste-outline" rows="4" spellcheck="false" placeholder="x (m), r (m)" prop:value=pasted
                on:input:target=move |event| pasted.set(event.target().value())></textarea>
            <button type="button" class="small" disabled=move || pasted.with(|text| text.trim().is_empty())
                on:click=move |_| import("Pasted outline.csv".to_string(), pasted.get_untracked())>"Import pasted points"</button>
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

/// The rows of a file, or every fault of the file or of the outline in it.
fn checked(name: &str, text: &str, unit: Option<LengthUnit>) -> Result<Vec<Vec<f64>>, Vec<String>> {
    let rows = read(name, text, unit).map_err(|faults| words(&faults))?;
    from_rows(name, &rows).map_err(|faults| words(&faults))?;
    Ok(rows)
}

fn words<T: ToString>(faults: &[T]) -> Vec<String> {
    faults.iter().map(ToString::to_string).collect()
}

/// The lines that faults speak of: "line 12: …".
pub fn lines_at_fault(text: &str, faults: &[String]) -> Vec<(usize, String)> {
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

    #[test]
    fn an_outline_that_crosses_the_axis_is_refused() {
        let faults = checked("x.csv", "x (m), r (m)\n0, 0\n1, 1\n2, -1\n3, 0\n", None).unwrap_err();
        assert!(faults[0].contains("axis"), "{faults:?}");
        assert!(checked("x.csv", "x (m), r (m)\n0, 0\n1, 1\n2, 0\n", None).is_ok());
    }
}
