//! Alternative inputs: one is given, the others follow from it.

use crate::components::number::NumberField;
use crate::state::State;
use leptos::prelude::*;
use msape::answer::output;
use msape::quantity::input::{Alternatives, Input, Kind, Preset};

/// The inputs of which a case must give one, where this is one of them.
pub fn group_of(input: &Input) -> Option<&'static Alternatives> {
    input.alternatives.filter(|group| group.asked_as.is_some())
}

/// A choice of the given input, and its field.
#[component]
pub fn OneOf(group: &'static Alternatives) -> impl IntoView {
    let state = State::expect();
    let title = format!("{} given by", group.asked_as.unwrap_or_default());
    let inputs: Vec<&'static Input> = group.inputs().collect();
    let first = inputs.first().map_or("", |input| input.key);
    let given = Memo::new(move |_| {
        state.case.with(|case| {
            let mut inputs = group.inputs();
            let given = inputs.find(|input| case.values.contains_key(input.key));
            given.map_or(first, |input| input.key)
        })
    });
    let step = StoredValue::new(title.clone());
    let choose = move |input: &'static Input| {
        let value = solved_value(state, input);
        state.edit(&step.get_value(), None, |document| {
            document.with_case(|case| {
                for other in group.inputs() {
                    case.values.remove(other.key);
                }
                case.set(input.key, &msape_kit::display::input_number(value));
            })
        });
    };
    view! {
        <fieldset class="alternatives">
            <legend>{title}</legend>
            <div class="segments">
                {inputs.iter().map(|input| {
                    let input = *input;
                    view! {
                        <label>
                            <input
                                type="radio"
                                name=first
                                prop:checked=move || given.get() == input.key
                                on:change=move |_| choose(input)
                            />
                            <span>{input.label}</span>
                        </label>
                    }
                }).collect_view()}
            </div>
            {inputs.into_iter().map(|input| view! {
                <Show when=move || given.get() == input.key fallback=|| ()>
                    <NumberField input />
                </Show>
            }).collect_view()}
        </fieldset>
    }
}

/// Value of an input in the newest answer, rounded; else its default or the middle of its usual range.
fn solved_value(state: State, input: &Input) -> f64 {
    let name = input.key.rsplit('.').next().unwrap_or_default();
    let solved = state.latest.with_untracked(|latest| {
        let get = output::find(name)?.get;
        get(&latest.as_ref()?.answer)
    });
    let rounded = |value: f64| format!("{value:.3e}").parse().unwrap_or(value);
    match (solved, input.preset, input.kind) {
        (Some(value), _, _) => rounded(value),
        (None, Preset::Number(value), _) => value,
        (
            None,
            _,
            Kind::Number {
                usual: Some((min, max)),
                ..
            },
        ) => rounded(0.5 * (min + max)),
        (None, _, Kind::Number { allowed, .. }) => rounded(allowed.min.max(1.0)),
        _ => 0.0,
    }
}
