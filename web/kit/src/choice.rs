//! Choice of a name from a list.

use leptos::prelude::*;

/// Control for one of several names.
#[component]
pub fn Select(
    /// Names and their titles.
    #[prop(into)]
    choices: Signal<Vec<(String, String)>>,
    /// The chosen name; one that is not in the list stays visible.
    #[prop(into)]
    now: Signal<String>,
    /// Whether the choice has faults.
    #[prop(into)]
    invalid: Signal<bool>,
    /// Identifier of the control.
    id: String,
    /// Identifiers of the elements that describe it.
    described_by: String,
    /// Gets a name when it is chosen.
    #[prop(into)]
    on_choose: Callback<String>,
) -> impl IntoView {
    // none is foreign before the list has arrived
    let foreign = Memo::new(move |_| {
        let now = now.get();
        let is_foreign = choices.with(|known| {
            let mut names = known.iter().map(|(name, _)| squeezed(name));
            !known.is_empty() && !now.is_empty() && names.all(|name| name != squeezed(&now))
        });
        is_foreign.then_some(now)
    });
    view! {
        <div class="field-controls">
            <select
                class="wide"
                id=id
                aria-describedby=described_by
                aria-invalid=move || invalid.get().to_string()
                on:change:target=move |event| on_choose.run(event.target().value())
            >
                {move || foreign.get().map(|name| view! { <option value=name.clone() selected=true>{name.clone()}</option> })}
                {move || choices.get().into_iter().map(|(name, title)| {
                    let wanted = squeezed(&name);
                    view! {
                        <option value=name prop:selected=move || squeezed(&now.get()) == wanted>{title}</option>
                    }
                }).collect_view()}
            </select>
        </div>
    }
}

/// Normalized name: `SuttonGraves` and `sutton-graves` are equal.
fn squeezed(name: &str) -> String {
    name.chars()
        .filter(|c| c.is_alphanumeric())
        .collect::<String>()
        .to_lowercase()
}
