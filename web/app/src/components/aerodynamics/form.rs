//! Form: conditions of the curves and choices of the database.

use super::{AeroView, PlacesText};
use crate::components::outline::flight::FlightField;
use crate::state::State;
use leptos::prelude::*;
use msape::quantity::input::{self, Input};
use msape_kit::segments::Segments;
use msape_worker::questions::curves::Family;

/// Inputs of a computed database; general ones first.
const FIELDS: [&Input; 6] = [
    &input::vehicle::AERODYNAMICS,
    &input::vehicle::AERODYNAMICS_DAMPING,
    &input::vehicle::AERODYNAMICS_BRIDGING,
    &input::vehicle::AERODYNAMICS_WALL_TEMPERATURE_RATIO,
    &input::vehicle::AERODYNAMICS_ACCOMMODATION,
    &input::vehicle::AERODYNAMICS_EXTRAPOLATION,
];

/// Fields for the conditions.
#[component]
pub fn PlacesForm() -> impl IntoView {
    let view = AeroView::expect();
    let faults = Memo::new(move |_| view.typed.with(PlacesText::faults));
    let family = Signal::derive(move || view.typed.with(|typed| typed.family));
    view! {
        <div class="flight-form">
            <PlaceField id="aero-mach" label="Mach numbers" fault=Signal::derive(move || faults.get()[0].clone())
                get=|typed| &typed.mach put=|typed, text| typed.mach = text />
            <PlaceField id="aero-knudsen" label="Knudsen numbers (0: continuum)" fault=Signal::derive(move || faults.get()[1].clone())
                get=|typed| &typed.knudsen put=|typed, text| typed.knudsen = text />
            <PlaceField id="aero-alpha" label="Angles of attack (deg)" fault=Signal::derive(move || faults.get()[2].clone())
                get=|typed| &typed.alpha_deg put=|typed, text| typed.alpha_deg = text />
            <PlaceField id="aero-cg" label="CG (diameters aft of the apex)" fault=Signal::derive(move || faults.get()[3].clone())
                get=|typed| &typed.cg put=|typed, text| typed.cg = text
                hint=Signal::derive(move || match view.cg_text() {
                    Some(cg) => cg,
                    None => "not known".to_string(),
                }) />
        </div>
        <div class="inline">
            <span>"Over the angle of attack, one curve for each"</span>
            <Segments legend="Curves for each" choices=vec![(Family::Mach, "Mach number"), (Family::Knudsen, "Knudsen number")]
                now=family choose=move |family| view.typed.update(|typed| typed.family = family) />
        </div>
        <p class="quiet">"The first number of a list holds where another varies."</p>
    }
}

#[component]
fn PlaceField(
    id: &'static str,
    label: &'static str,
    #[prop(into)] fault: Signal<Option<String>>,
    get: fn(&PlacesText) -> &String,
    put: fn(&mut PlacesText, String),
    #[prop(optional, into)] hint: Signal<String>,
) -> impl IntoView {
    let view = AeroView::expect();
    let fault_id = format!("{id}-fault");
    view! {
        <div class="field" class:field-fault=move || fault.with(Option::is_some)>
            <label for=id>{label}</label>
            <input id=id type="text" autocomplete="off" spellcheck="false" aria-describedby=fault_id.clone()
                aria-invalid=move || fault.with(Option::is_some).to_string()
                placeholder=hint
                prop:value=move || view.typed.with(|typed| get(typed).clone())
                on:input:target=move |event| view.typed.update(|typed| put(typed, event.target().value())) />
            <p class="field-error" id=fault_id>{fault}</p>
        </div>
    }
}

/// Choices of the database.
#[component]
pub fn DatabaseForm() -> impl IntoView {
    let state = State::expect();
    let view = AeroView::expect();
    let typed = RwSignal::new(false);
    let tables = move || {
        state
            .document
            .with(|document| document.tables.keys().cloned().collect::<Vec<_>>())
    };
    let others = move || {
        view.faults.with(|faults| {
            faults
                .iter()
                .filter(|fault| FIELDS.iter().all(|input| input.key != fault.key))
                .map(|fault| view! { <li class="note-outside"><code>{fault.key.clone()}</code> " " {fault.message.clone()}</li> })
                .collect_view()
        })
    };
    view! {
        <div class="flight-form">
            <div class="field">
                <label for="aero-table">"Static coefficients"</label>
                <select id="aero-table" on:change:target=move |event| {
                    let name = event.target().value();
                    view.table.set((!name.is_empty()).then_some(name));
                }>
                    <option value="" prop:selected=move || view.table.with(Option::is_none)>"computed over the outline"</option>
                    {move || tables().into_iter().map(|name| {
                        let this = name.clone();
                        view! { <option value=name.clone() prop:selected=move || view.table.get().as_ref() == Some(&this)>{format!("table {name}")}</option> }
                    }).collect_view()}
                </select>
            </div>
            {FIELDS.into_iter().map(|input| view! {
                <FlightField input fields=view.fields faults=view.faults typed />
            }).collect_view()}
        </div>
        <div role="status"><ul class="notes">{others}</ul></div>
    }
}
