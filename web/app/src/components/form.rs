//! Form with all inputs of the list, by group.

use crate::components::alternatives::{OneOf, group_of};
use crate::components::choice::{ChoiceField, FlagField};
use crate::components::number::NumberField;
use crate::components::rows::RowsField;
use crate::state::State;
use leptos::prelude::*;
use msape::quantity::Task;
use msape::quantity::input::{Group, Input, Kind, Level, inputs};

/// Whether an input belongs in this form: not those of a vehicle flown as it is, not those of the attitude, which have
/// a card of their own, and not files that only the command line can read.
fn is_of_design(input: &Input) -> bool {
    input.is_of(Task::Design) && input.kind != Kind::Text
}

/// Groups in the order of the form.
const GROUPS: [Group; 9] = [
    Group::Mission,
    Group::Vehicle,
    Group::Payload,
    Group::HeatShield,
    Group::Impact,
    Group::Margins,
    Group::Models,
    Group::Densities,
    Group::Solver,
];

/// Identifier of a group on the page.
pub fn group_id(group: Group) -> String {
    format!("group-{}", group.label().to_lowercase().replace(' ', "-"))
}

/// The form.
#[component]
pub fn Form() -> impl IntoView {
    view! {
        <form class="form" autocomplete="off" on:submit=|event| event.prevent_default()>
            {GROUPS.into_iter().map(|group| view! { <GroupOfInputs group /> }).collect_view()}
        </form>
    }
}

#[component]
fn GroupOfInputs(group: Group) -> impl IntoView {
    let state = State::expect();
    let expert = state.preferences.expert;
    let of_group: Vec<&'static Input> = inputs()
        .filter(|input| input.group == group && is_of_design(input))
        .collect();
    let opens_at_first = matches!(group, Group::Mission | Group::Vehicle) || is_wide();
    let has_basic = of_group.iter().any(|input| input.level == Level::Basic);
    let mut fields = Vec::new();
    for input in of_group {
        let alternatives = group_of(input);
        let is_first = alternatives.is_none_or(|group| group.inputs().next() == Some(input));
        if is_first {
            fields.push((input, alternatives));
        }
    }
    view! {
        <details class="group" id=group_id(group) open=has_basic && opens_at_first hidden=move || !has_basic && !expert.get()>
            <summary><h3>{group.label()}</h3></summary>
            <div class="fields">
                {fields.into_iter().map(|(input, alternatives)| {
                    // a changed or faulty field is never hidden
                    let check = state.check(input.key);
                    let is_basic = input.level == Level::Basic;
                    let shown = Memo::new(move |_| {
                        is_basic || expert.get() || check.with(|check| !check.faults.is_empty())
                    });
                    view! {
                        <Show when=move || shown.get() fallback=|| ()>
                            {match alternatives {
                                Some(group) => view! { <OneOf group /> }.into_any(),
                                None => any_field(input),
                            }}
                        </Show>
                    }
                }).collect_view()}
            </div>
        </details>
    }
}

/// Whether the window is wide enough for more than one column.
fn is_wide() -> bool {
    let query = window().match_media("(min-width: 42rem)");
    query.ok().flatten().is_none_or(|query| query.matches())
}

fn any_field(input: &'static Input) -> AnyView {
    match input.kind {
        Kind::Number { .. } => view! { <NumberField input /> }.into_any(),
        Kind::Choice(_) => view! { <ChoiceField input /> }.into_any(),
        Kind::Flag => view! { <FlagField input /> }.into_any(),
        Kind::Rows(columns) => view! { <RowsField input columns /> }.into_any(),
        Kind::Text => ().into_any(),
    }
}
