//! Choice among a few options.

use leptos::prelude::*;

/// Choice among a few options, all of them visible.
#[component]
pub fn Segments<T: Copy + PartialEq + Send + Sync + 'static>(
    /// Name of the choice.
    legend: &'static str,
    /// Options and their labels.
    choices: Vec<(T, &'static str)>,
    /// The chosen option.
    #[prop(into)]
    now: Signal<T>,
    /// Gets an option when it is chosen.
    choose: impl Fn(T) + Copy + 'static,
) -> impl IntoView {
    view! {
        <fieldset class="segments">
            <legend class="hidden-visually">{legend}</legend>
            {choices.into_iter().map(|(choice, label)| view! {
                <label>
                    <input type="radio" name=legend prop:checked=move || now.get() == choice on:change=move |_| choose(choice) />
                    <span>{label}</span>
                </label>
            }).collect_view()}
        </fieldset>
    }
}
