//! Choice of the ground, and the sources of its properties.

use crate::components::field::control_id;
use crate::components::vehicle::VehicleView;
use crate::state::State;
use leptos::prelude::*;
use msape::Case;
use msape::case::Value;
use msape::quantity::input::{self, Input, Preset};
use msape::vehicle::impact::Ground;
use msape_kit::display::number;

/// Key of the input.
const GROUND: &Input = &input::design::GROUND;

/// Library name of the ground of a case.
fn key_of(case: &Case) -> String {
    case.text(GROUND.key)
        .unwrap_or_else(|| match GROUND.preset {
            Preset::Name(name) => name.to_string(),
            _ => String::new(),
        })
}

fn found(key: &str) -> Option<Ground> {
    State::expect().catalog.with(|catalog| {
        let mut grounds = catalog.as_ref()?.grounds.iter();
        let (_, ground) = grounds.find(|(name, _)| name == key)?;
        Some(ground.clone())
    })
}

/// Name of the ground of the displayed answer.
pub fn ground_name(card: VehicleView) -> Memo<String> {
    let key = card.of_answer(|solved| Some(key_of(&solved.case)));
    Memo::new(move |_| {
        let name = key.get().and_then(|key| Some(found(&key)?.name));
        name.unwrap_or_else(|| "ground".to_string())
    })
}

/// List of grounds with the properties of the chosen one.
#[component]
pub fn GroundChoice() -> impl IntoView {
    view! { <Choice input=GROUND /> }
}

#[component]
fn Choice(input: &'static Input) -> impl IntoView {
    let state = State::expect();
    let now = Memo::new(move |_| state.case.with(|case| key_of(case)));
    let id = format!("landing-{}", control_id(input.key));
    let choose = move |name: String| {
        // typing on the list passes through several grounds: one undo step
        state.edit(input.label, Some(input.key), |document| {
            document.with_case(|case| {
                case.values.insert(input.to_string(), Value::Text(name));
            })
        });
    };
    let origin = move || {
        found(&now.get()).map(|ground| {
            let constant = match (ground.penetration, ground.young) {
                (Some(p), _) => Some((
                    "α of equation 1",
                    [p.alpha, p.alpha_min, p.alpha_max],
                )),
                (_, Some(y)) => Some((
                    "S of Young's equation",
                    [y.s_number, y.s_number_min, y.s_number_max],
                )),
                _ => None,
            };
            let constant = constant.map(|(name, values)| {
                let [value, least, most] = values.map(|value| number(value, 4));
                format!("{name}: {value}, range {least} to {most}. ")
            });
            view! {
                <p class="quiet">{constant} {ground.note.clone()}</p>
                <p class="note-source">{ground.law_source()} {format!(". {} ({})", ground.place, ground.source)}</p>
            }
        })
    };
    view! {
        <div class="ground">
            <label for=id.clone()>{input.label}</label>
            <select id=id title=input.help on:change:target=move |event| choose(event.target().value())
                on:blur=move |_| state.close_step()>
                {move || state.names(input).into_iter().map(|(name, title)| {
                    let this = name.clone();
                    view! { <option value=name prop:selected=move || now.get() == this>{title}</option> }
                }).collect_view()}
            </select>
            <div class="origin">{origin}</div>
        </div>
    }
}
