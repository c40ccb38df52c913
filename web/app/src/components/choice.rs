//! Choices of the case: names, and yes or no.

use crate::components::field::{Field, control_id, described_by};
use crate::state::State;
use leptos::prelude::*;
use msape::case::Value;
use msape::quantity::input::{Input, Preset};
use msape_kit::choice::Select;
use msape_worker::catalog::Names;

/// Field for one of several names.
#[component]
pub fn ChoiceField(input: &'static Input) -> impl IntoView {
    let state = State::expect();
    let choices = Signal::derive(move || state.names(input));
    view! { <SelectField input choices to_value=|name: &str| Value::Text(name.to_string()) /> }
}

/// Field for yes or no.
#[component]
pub fn FlagField(input: &'static Input) -> impl IntoView {
    let choices = vec![
        ("true".to_string(), "Yes".to_string()),
        ("false".to_string(), "No".to_string()),
    ];
    view! { <SelectField input choices=Signal::stored(choices) to_value=|name: &str| Value::Flag(name == "true") /> }
}

#[component]
fn SelectField(
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
    let check = state.check(input.key);
    let invalid = Signal::derive(move || check.with(|check| !check.faults.is_empty()));
    let choose = move |name: String| {
        state.edit(input.label, None, |document| {
            document.with_case(|case| {
                case.values.insert(input.key.to_string(), to_value(&name));
            })
        });
    };
    let label = input.label;
    view! {
        <Field input caption=Signal::derive(move || label.to_string()) echo=Signal::derive(move || Some(now.get()))>
            <Select now choices invalid id=control_id(input.key) described_by=described_by(input.key) on_choose=choose />
        </Field>
    }
}
