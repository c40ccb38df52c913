//! Use of a database: in the current design, in a flight of the outline, or as a file.

use super::{AeroView, Body, TABLE};
use crate::components::export::save;
use crate::pages::library;
use crate::state::State;
use leptos::prelude::*;
use msape::Case;
use msape::quantity::input::{self, OWN_OUTLINE};
use msape_kit::files::{self, file_name};

/// Whether a key of a case belongs to the coefficients.
fn is_aerodynamic(key: &str) -> bool {
    let section = input::vehicle::AERODYNAMICS.key;
    let rest = key.strip_prefix(section);
    rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
}

/// Replaces the coefficients of a case by those of another.
pub fn put(from: &Case, into: &mut Case) {
    into.values.retain(|key, _| !is_aerodynamic(key));
    for (key, value) in from.values.iter().filter(|(key, _)| is_aerodynamic(key)) {
        into.values.insert(key.clone(), value.clone());
    }
}

/// The buttons.
#[component]
pub fn Usage() -> impl IntoView {
    let state = State::expect();
    let view = AeroView::expect();
    let of = |get: fn(&Body) -> bool| move || view.body.with(|body| body.as_ref().is_some_and(get));
    let has_outline = of(|body| body.outline.is_some());
    let in_design = move |_| {
        let Some(case) = view.case.get_untracked() else {
            return;
        };
        state.edit("Aerodynamics of the design", None, |document| {
            document.with_case(|design| {
                put(&case, design);
                // the point mass of the design takes the axial force by name
                let name = case.text(input::vehicle::AERODYNAMICS.key);
                design.set(
                    input::design::AERODYNAMICS.key,
                    name.as_deref().unwrap_or(OWN_OUTLINE),
                );
            })
        });
        state.notice.set(if case.gives_any(&[TABLE]) {
            "The design flies its attitude with this table; undo takes it back.".to_string()
        } else {
            "The design uses these coefficients; undo takes it back.".to_string()
        });
    };
    let in_flight = move |_| {
        let (Some(case), Some(body)) = (view.case.get_untracked(), view.body.get_untracked())
        else {
            return;
        };
        let Some(entry) = body.outline else {
            return;
        };
        let mut fields = Case::default();
        put(&case, &mut fields);
        // a point mass needs an axial force: a named one, that of a table, or else that of a blunt body at high speed
        if !fields.gives_any(&[&input::vehicle::AERODYNAMICS, TABLE]) {
            fields.set(input::vehicle::DRAG_COEFFICIENT.key, "1.5");
        }
        state.flight_fields.set_value(Some(fields));
        library::go_to(&entry.id());
    };
    let download = move |_| {
        if let Some(case) = view.case.get_untracked() {
            let name = file_name(&format!("{} aerodynamics", case.name), "toml");
            save(
                state,
                files::download(&name, "application/toml", &case.to_toml()),
            );
        }
    };
    view! {
        <div class="tools">
            <button type="button" class="small" on:click=in_design>"Use in the design"</button>
            <button type="button" class="small" disabled=move || !has_outline() on:click=in_flight>"Use in a flight"</button>
            <button type="button" class="small" on:click=download>"Case file (TOML)"</button>
        </div>
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coefficients_replace_coefficients_and_nothing_else() {
        let mut from = Case::default();
        from.set("vehicle.aerodynamics.damping", "none");
        from.set("outline.preset", "stardust");
        let mut into = Case::default();
        into.set("vehicle.aerodynamics", "mmeev-60");
        into.set("vehicle.mass_kg", "46");
        put(&from, &mut into);
        let keys: Vec<&str> = into.values.keys().map(String::as_str).collect();
        assert_eq!(keys, ["vehicle.aerodynamics.damping", "vehicle.mass_kg"]);
    }
}
