//! Alternative inputs: one is given, the others follow from it.

use crate::components::number::NumberField;
use crate::state::State;
use leptos::prelude::*;
use msape::answer::output;
use msape::quantity::input::{Input, Kind, Preset, find};

/// Mutually exclusive inputs: heading and keys. The list of inputs does not contain this yet.
pub const ALTERNATIVES: &[(&str, &[&str])] = &[
    (
        "Payload size given by",
        &[
            "design.payload_density_kg_m3",
            "design.payload_diameter_m",
            "design.payload_diameter_ratio",
        ],
    ),
    ("Start given by", &["entry.altitude_m", "entry.radius_m"]),
];

/// The group of alternatives of which an input is the first.
pub fn group_of(key: &str) -> Option<(&'static str, &'static [&'static str])> {
    ALTERNATIVES
        .iter()
        .find(|(_, keys)| keys.contains(&key))
        .copied()
}

/// A choice of the given input, and its field.
#[component]
pub fn Alternatives(title: &'static str, keys: &'static [&'static str]) -> impl IntoView {
    let state = State::expect();
    let inputs: Vec<&'static Input> = keys.iter().filter_map(|key| find(key)).collect();
    let first = keys.first().copied().unwrap_or_default();
    let given = Memo::new(move |_| {
        state.case.with(|case| {
            let given = keys.iter().find(|key| case.values.contains_key(**key));
            given.copied().unwrap_or(first)
        })
    });
    let choose = move |input: &'static Input| {
        let value = solved_value(state, input);
        state.edit(title, None, |document| {
            document.with_case(|case| {
                for key in keys {
                    case.values.remove(*key);
                }
                case.set(input.key, &crate::display::input_number(value));
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
