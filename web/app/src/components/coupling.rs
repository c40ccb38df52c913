//! Coupling of the modules and the values exchanged between them: an interactive version of the report's Figure 4.

use crate::components::notes::GoTo;
use crate::components::residuals::Residuals;
use crate::state::State;
use leptos::prelude::*;
use msape::design::crossings::{CROSSINGS, Crossing, MODULES};
use msape::quantity::Module;
use msape::quantity::input::{self, Input, Preset};
use msape::units::{Unit, canonical};
use msape_kit::display::{number, symbol};

/// Inputs that control when the passes end.
const SOLVER: [&Input; 3] = [
    &input::design::MASS_CRITERION_KG,
    &input::design::MAX_ITERATIONS,
    &input::design::RELAXATION,
];

/// The coupling view.
#[component]
pub fn Coupling() -> impl IntoView {
    let state = State::expect();
    let chosen = RwSignal::new(None::<(Module, Module)>);
    view! {
        <section class="card" aria-labelledby="coupling-title">
            <h2 id="coupling-title">"Coupling"</h2>
            <p class="quiet">"A module gives along its row and takes along its column. Choose a cell to see what crosses there, pass by pass."</p>
            <div class="matrix-frame" tabindex="0" role="region" aria-label="Matrix of modules">
                <table class="matrix">
                    <caption class="hidden-visually">"What each module (row) gives to each other (column)"</caption>
                    <tbody>
                        {MODULES.into_iter().map(|from| view! {
                            <tr>{MODULES.into_iter().map(|to| cell(from, to, chosen)).collect_view()}</tr>
                        }).collect_view()}
                    </tbody>
                </table>
            </div>
            <Values chosen />
            <h3 class="spaced">"Convergence"</h3>
            <ul class="solver">
                {SOLVER.into_iter().map(|input| {
                    let value = move || state.case.with(|case| case.text(input.key)).unwrap_or_else(|| match input.preset {
                        Preset::Number(value) => value.to_string(),
                        _ => "–".to_string(),
                    });
                    view! { <li><span class="unit">{input.header()}</span> <strong>{value}</strong> <GoTo key=input.key.to_string() label="Change" /></li> }
                }).collect_view()}
            </ul>
            <Residuals />
        </section>
    }
}

/// Values passed from one module to another, with their positions in the record of a pass.
fn crossing(from: Module, to: Module) -> Vec<(usize, &'static Crossing)> {
    CROSSINGS
        .iter()
        .enumerate()
        .filter(|(_, crossing)| crossing.from == from && crossing.to.contains(&to))
        .collect()
}

fn cell(from: Module, to: Module, chosen: RwSignal<Option<(Module, Module)>>) -> AnyView {
    if from == to {
        return view! { <td class="module">{from.label()}</td> }.into_any();
    }
    let count = crossing(from, to).len();
    if count == 0 {
        return view! { <td></td> }.into_any();
    }
    let here = Some((from, to));
    let values = if count == 1 { "value" } else { "values" };
    view! {
        <td>
            <button type="button" aria-pressed=move || (chosen.get() == here).to_string()
                aria-label=format!("{} to {}: {count} {values}", from.label(), to.label())
                title=format!("{} → {}", from.label(), to.label())
                on:click=move |_| chosen.update(|chosen| *chosen = if *chosen == here { None } else { here })>
                {count}
            </button>
        </td>
    }
    .into_any()
}

/// Values of the selected cell, by pass.
#[component]
fn Values(chosen: RwSignal<Option<(Module, Module)>>) -> impl IntoView {
    let state = State::expect();
    let passes = state.of_answer(|answer| answer.passes.clone());
    let unit = move |crossing: &'static Crossing| {
        let printed = Unit::find(crossing.unit).unwrap_or_else(|| canonical(crossing.dimension));
        state
            .document
            .with(|document| document.units.unit(crossing.dimension, printed))
    };
    view! {
        {move || chosen.get().map(|(from, to)| {
            let found = crossing(from, to);
            let passes = passes.get().unwrap_or_default();
            view! {
                <div class="matrix-frame" tabindex="0" role="region" aria-label="Values of the chosen cell">
                <table class="outputs crossings">
                    <caption>{format!("{} → {}", from.label(), to.label())}</caption>
                    <thead><tr>
                        <th scope="col">"Quantity"</th>
                        {passes.iter().map(|pass| view! { <th scope="col" class="value">{format!("Pass {}", pass.number)}</th> }).collect_view()}
                        <th scope="col">"Unit"</th>
                    </tr></thead>
                    <tbody>
                        {found.into_iter().map(|(place, crossing)| {
                            let unit = unit(crossing);
                            view! {
                                <tr>
                                    <th scope="row">{crossing.label}</th>
                                    {passes.iter().map(|pass| {
                                        let text = pass.crossings.get(place).map_or("–".to_string(), |value| number(unit.from_canonical(*value), 5));
                                        view! { <td>{text}</td> }
                                    }).collect_view()}
                                    <td class="unit">{symbol(unit)}</td>
                                </tr>
                            }
                        }).collect_view()}
                    </tbody>
                </table>
                </div>
            }
        })}
    }
}
