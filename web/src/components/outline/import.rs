//! Outlines from files.

use super::facts::length_units;
use crate::components::file_import::{FileImport, Verdict, Wording, notes, stem};
use crate::files;
use crate::state::State;
use cad::outline::{Imported, LengthUnit, read};
use leptos::prelude::*;
use msape::vehicle::body::from_rows;

const WORDING: Wording = Wording {
    file: "Import an outline (CSV or DXF)",
    accept: ".csv,.txt,.dxf,text/csv,image/vnd.dxf",
    id: "paste-outline",
    paste: "Or paste points (CSV)",
    placeholder: "x (m), r (m)",
    button: "Import pasted points",
    pasted: "Pasted outline.csv",
};

/// Choose, drop or paste; `take` gets the identifier of what was imported.
#[component]
pub fn Import(take: impl Fn(String) + Copy + Send + Sync + 'static) -> impl IntoView {
    let state = State::expect();
    let unit = RwSignal::new(String::new());
    let import = move |name: String, bytes: Vec<u8>, verdict: Verdict| {
        let symbol = unit.get_untracked();
        match checked(&name, &bytes, LengthUnit::of(&symbol)) {
            Ok(Imported { rows, remarks }) => {
                let stem = stem(&name);
                state.edit(&format!("Import {stem}"), None, |document| {
                    document.with_outlines(|outlines| {
                        outlines.insert(stem.clone(), rows);
                    })
                });
                verdict.taken(format!(
                    "{stem} is imported; undo takes it out again.{}",
                    notes(&remarks)
                ));
                take(format!("own:{stem}"));
            }
            Err(faults) => verdict.refused(name, &files::text_of(&bytes), faults),
        }
    };
    view! {
        <FileImport wording=WORDING import>
            <label class="inline">
                <span>"Its unit"</span>
                <select on:change:target=move |event| unit.set(event.target().value())>
                    <option value="">"as the file says"</option>
                    {length_units().map(|symbol| view! { <option value=symbol>{symbol}</option> })}
                </select>
            </label>
            <p class="quiet">"Or drop a file here. A CSV has points x, r from the nose on the axis to the aft end on the axis and names its unit in the header, such as "<code>"x (mm), r (mm)"</code>". Of a DXF, text or binary, what is drawn counts: lines, arcs, circles, polylines, ellipses, splines and blocks of them, one half of the section or both, the axis at y = 0. A unit chosen here stands above the one in the file."</p>
        </FileImport>
    }
}

/// The outline of a file, or every fault of the file or of the outline in it.
fn checked(name: &str, bytes: &[u8], unit: Option<LengthUnit>) -> Result<Imported, Vec<String>> {
    let imported = read(name, bytes, unit).map_err(|faults| words(&faults))?;
    from_rows(name, &imported.rows).map_err(|faults| words(&faults))?;
    Ok(imported)
}

fn words<T: ToString>(faults: &[T]) -> Vec<String> {
    faults.iter().map(ToString::to_string).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_outline_that_crosses_the_axis_is_refused() {
        let faults =
            checked("x.csv", b"x (m), r (m)\n0, 0\n1, 1\n2, -1\n3, 0\n", None).unwrap_err();
        assert!(faults[0].contains("axis"), "{faults:?}");
        assert!(checked("x.csv", b"x (m), r (m)\n0, 0\n1, 1\n2, 0\n", None).is_ok());
    }
}
