//! Select fields for names and for yes or no.

use crate::catalog::Names;
use crate::components::field::{Field, control_id, described_by};
use crate::state::State;
use leptos::prelude::*;
use msape::case::Value;
use msape::quantity::input::{Input, Preset};

/// Field for one of several names.
#[component]
pub fn ChoiceField(input: &'static Input) -> impl IntoView {
    let state = State::expect();
    let choices = Signal::derive(move || state.names(input));
    view! { <Select input choices to_value=|name: &str| Value::Text(name.to_string()) /> }
}

/// Field for yes or no.
#[component]
pub fn FlagField(input: &'static Input) -> impl IntoView {
    let choices = vec![
        ("true".to_string(), "Yes".to_string()),
        ("false".to_string(), "No".to_string()),
    ];
    view! { <Select input choices=Signal::stored(choices) to_value=|name: &str| Value::Flag(name == "true") /> }
}

#[component]
fn Select(
    input: &'static Input,
    choices: Signal<Names>,
    to_value: fn(&str) -> Value,
) -> impl IntoView {
    let state = State::expect();
    let now = Memo::new(move |_| {
        let given = state.case.with(|case| case.text(input.key));
        given.unwrap_or_else(|| match input.preset {
            Preset::Name(name) => name.to_string(),
            Preset::Flag(flag) => flag.to_string(),
            _ => String::new(),
        })
    });
    // a name that is not in the list stays visible, with its fault; none is foreign before the list has arrived
    let foreign = Memo::new(move |_| {
        let now = now.get();
        let is_foreign = choices.with(|known| {
            let mut names = known.iter().map(|(name, _)| squeezed(name));
            !known.is_empty() && !now.is_empty() && names.all(|name| name != squeezed(&now))
        });
        is_foreign.then_some(now)
    });
    let check = state.check(input.key);
    let label = input.label;
    view! {
        <Field input caption=Signal::derive(move || label.to_string()) echo=Signal::derive(move || Some(now.get()))>
            <div class="field-controls">
                <select
                    class="wide"
                    id=control_id(input.key)
                    aria-describedby=described_by(input.key)
                    aria-invalid=move || check.with(|check| (!check.faults.is_empty()).to_string())
                    on:change:target=move |event| {
                        let value = to_value(&event.target().value());
                        state.edit(input.label, None, |document| {
                            document.with_case(|case| {
                                case.values.insert(input.key.to_string(), value);
                            })
                        });
                    }
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
        </Field>
    }
}

/// Normalized name: `SuttonGraves` and `sutton-graves` are equal.
fn squeezed(name: &str) -> String {
    name.chars()
        .filter(|c| c.is_alphanumeric())
        .collect::<String>()
        .to_lowercase()
}
