//! Landing: equations and dynamics side by side, on a rigid surface and on the chosen ground.

mod figures;
mod ground;
mod levels;
mod stroke;

use crate::components::figure_panel::FigurePanel;
use crate::components::notes::{GoTo, Remarks};
use crate::components::vehicle::VehicleView;
use figures::{Curves, Histories, figure};
use ground::{GroundChoice, ground_name};
use leptos::prelude::*;
use levels::Levels;
use msape::quantity::input::{self, Input};
use stroke::Stroke;

/// Models whose findings are shown here.
const MODELS: &[&str] = &[
    "crush dynamics",
    "impact",
    "ground penetration",
    "impact foam",
];

/// Inputs that affect the landing, besides the ground.
const INPUTS: [&Input; 4] = [
    &input::design::CRUSH_LOAD_LIMIT_EARTH_G,
    &input::design::FOAM_STRENGTH,
    &input::design::STROKE_EFFICIENCY,
    &input::design::CRUSHING_MASS,
];

/// The tab.
#[component]
pub fn LandingTab() -> impl IntoView {
    let card = VehicleView::expect();
    let findings = card.of_answer(|solved| Some(solved.answer.findings.clone()));
    let name = card.of_answer(|solved| Some(solved.case.name.clone()));
    let stem = Signal::derive(move || name.get().unwrap_or_default());
    let ground = ground_name(card);
    let histories = card.of_answer(|solved| {
        let design = solved.answer.design.as_ref()?;
        Some(Histories::of(&design.vehicle, &design.landing))
    });
    let drawn = move |what: Curves| {
        Memo::new(move |_| {
            let units = card.units.get();
            histories.with(|found| {
                found
                    .as_ref()
                    .map(|found| figure(found, what, units))
                    .unwrap_or_default()
            })
        })
    };
    view! {
        <GroundChoice />
        <ul class="solver">
            {INPUTS.map(|input| view! { <li><GoTo key=input.to_string() /></li> }).into_iter().collect_view()}
        </ul>
        <h3 class="spaced">"Equations and dynamics"</h3>
        <Levels ground />
        <h3 class="spaced">"Stroke in the impact foam"</h3>
        <Stroke ground />
        <div class="charts spaced">
            {[Curves::Rigid, Curves::Ground, Curves::Force].map(|what| view! {
                <FigurePanel title=Signal::derive(move || ground.with(|ground| what.title(ground))) figure=drawn(what) stem />
            })}
        </div>
        <h3 class="spaced">"Remarks"</h3>
        <Remarks findings models=MODELS />
    }
}
