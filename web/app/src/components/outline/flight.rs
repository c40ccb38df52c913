//! Flight of an outline as a rigid body through the mission of the current design.

use super::Entry;
use crate::charts::{ChartSpec, Span};
use crate::components::chart::Chart;
use crate::components::export::save;
use crate::state::State;
use crate::state::asker::Asker;
use leptos::prelude::*;
use msape::answer::output;
use msape::quantity::Task;
use msape::quantity::input::{self, Input, Kind, Preset, inputs};
use msape::{Answer, Case};
use msape_kit::display::{number, symbol};
use msape_kit::files::{self, file_name};
use msape_worker::protocol::Fault;
use msape_worker::questions::Fly;
use std::sync::Arc;
use wasm_bindgen_futures::spawn_local;

/// Inputs of the form; the mission comes from the design.
const FIELDS: [&Input; 4] = [
    &input::vehicle::MASS_KG,
    &input::vehicle::DRAG_COEFFICIENT,
    &input::vehicle::AERODYNAMICS,
    &input::vehicle::NOSE_RADIUS_M,
];

/// Outputs shown for a flight.
const SHOWN: [&str; 8] = [
    "peak_deceleration_earth_g",
    "peak_total_heat_flux_w_m2",
    "convective_heat_load_j_m2",
    "radiative_heat_load_j_m2",
    "peak_dynamic_pressure_pa",
    "ballistic_coefficient_kg_m2",
    "time_of_flight_s",
    "final_speed_m_s",
];

/// A case that flies an outline through the mission of a design.
fn flight_case(design: &Case, entry: &Entry, fields: &Case) -> Case {
    let mut case = Case {
        name: entry.title(),
        ..Case::default()
    };
    // omit inputs that only a design uses
    let of_mission = |input: &&Input| Task::ALL.iter().all(|task| input.is_of(*task));
    for input in inputs().filter(of_mission) {
        if let Some(value) = design.values.get(input.key) {
            case.values.insert(input.to_string(), value.clone());
        }
    }
    for (key, value) in &fields.values {
        case.values.insert(key.clone(), value.clone());
    }
    entry.put(&mut case);
    case
}

/// The form and the results.
#[component]
pub fn OutlineFlight(#[prop(into)] entry: Signal<Option<Entry>>) -> impl IntoView {
    let state = State::expect();
    let fields = RwSignal::new(first_fields(state));
    // until the user enters one, the mass is that of the current design
    let typed = RwSignal::new(false);
    Effect::new(move |_| {
        let mass_kg = state.latest.with(|latest| {
            let design = latest.as_ref()?.answer.design.as_ref()?;
            Some(design.vehicle.mass.mass_kg)
        });
        if let Some(mass_kg) = mass_kg.filter(|_| !typed.get_untracked()) {
            fields
                .update(|fields| fields.set(input::vehicle::MASS_KG.key, &format!("{mass_kg:.1}")));
        }
    });
    let flown = RwSignal::new(None::<(Arc<Answer>, String)>);
    let faults = RwSignal::new(Vec::<Fault>::new());
    let asker = Asker::default();
    let case = Memo::new(move |_| {
        let entry = entry.get()?;
        let design = state.case.get();
        Some(fields.with(|fields| flight_case(&design, &entry, fields)))
    });
    // flown at each change; only the newest answer counts
    Effect::new(move |_| {
        let Some(case) = case.get() else {
            return asker.wants_nothing();
        };
        spawn_local(async move {
            let name = case.name.clone();
            match state.ask(asker, Fly(case)).await {
                Some(Ok(answer)) => {
                    faults.set(Vec::new());
                    flown.set(Some((Arc::new(answer), name)));
                }
                Some(Err(list)) => faults.set(list),
                None => {}
            }
        });
    });
    let others = move || {
        faults.with(|faults| {
            let other = faults
                .iter()
                .filter(|fault| FIELDS.iter().all(|input| input.key != fault.key));
            other
                .map(|fault| view! { <li class="note-outside"><code>{fault.key.clone()}</code> " " {fault.message.clone()}</li> })
                .collect_view()
        })
    };
    let download = move |_| {
        if let Some(case) = case.get_untracked() {
            let name = file_name(&case.name, "toml");
            save(
                state,
                files::download(&name, "application/toml", &case.to_toml()),
            );
        }
    };
    view! {
        <p class="quiet">"Entry, atmosphere and heating models are those of the present design, and so is the mass until another is given. The vehicle flies as it is, without ablation or parachute."</p>
        <div class="flight-form">
            {FIELDS.into_iter().map(|input| view! { <FlightField input fields faults typed /> }).collect_view()}
        </div>
        <div role="status"><ul class="notes">{others}</ul></div>
        <div class:old=move || faults.with(|faults| !faults.is_empty())>
            {move || flown.get().map(|(answer, name)| view! { <Results answer name /> })}
        </div>
        <div class="tools">
            <button type="button" class="small" on:click=download>"Case file (TOML)"</button>
        </div>
    }
}

/// Initial fields: the coefficients handed over by the Aerodynamics page, else the drag of a blunt body at high speed.
fn first_fields(state: State) -> Case {
    let handed_over = state.flight_fields.try_update_value(Option::take).flatten();
    handed_over.unwrap_or_else(|| {
        let mut fields = Case::default();
        fields.set(input::vehicle::DRAG_COEFFICIENT.key, "1.5");
        fields
    })
}

/// Field of an input in a small case.
#[component]
pub fn FlightField(
    input: &'static Input,
    fields: RwSignal<Case>,
    faults: RwSignal<Vec<Fault>>,
    typed: RwSignal<bool>,
) -> impl IntoView {
    let state = State::expect();
    let id = format!("flight-{}", input.key.replace(['.', '_'], "-"));
    let fault_id = format!("{id}-fault");
    let text = move || fields.with(|fields| fields.text(input.key).unwrap_or_default());
    let put = move |text: String| {
        typed.set(true);
        fields.update(|fields| fields.set(input.key, &text));
    };
    let said = move || {
        faults.with(|faults| {
            let own = faults.iter().filter(|fault| fault.key == input.key);
            own.map(|fault| fault.message.clone())
                .collect::<Vec<_>>()
                .join(" ")
        })
    };
    let unit = match input.kind {
        Kind::Number { .. } => symbol(input.shown_unit()),
        _ => String::new(),
    };
    let caption = match unit.as_str() {
        "" => input.label.to_string(),
        unit => format!("{} ({unit})", input.label),
    };
    let control = match input.kind {
        Kind::Choice(_) => {
            // label of the empty choice: its preset value; an input without preset has none
            let preset = match input.preset {
                Preset::Name(name) => name,
                _ => "",
            };
            let now = move || {
                let text = text();
                if text.is_empty() { preset.to_string() } else { text }
            };
            view! {
                <select id=id.clone() aria-describedby=fault_id.clone() on:change:target=move |event| put(event.target().value())>
                    {preset.is_empty().then(|| view! { <option value="" prop:selected=move || now().is_empty()>"none"</option> })}
                    {move || state.names(input).into_iter().map(|(name, title)| {
                        let this = name.clone();
                        view! { <option value=name prop:selected=move || now() == this>{title}</option> }
                    }).collect_view()}
                </select>
            }
            .into_any()
        }
        _ => view! {
            <input id=id.clone() type="text" inputmode="decimal" autocomplete="off" aria-describedby=fault_id.clone()
                aria-invalid=move || (!said().is_empty()).to_string() prop:value=text
                on:input:target=move |event| put(event.target().value()) />
        }
        .into_any(),
    };
    view! {
        <div class="field" class:field-fault=move || !said().is_empty()>
            <label for=id>{caption}</label>
            {control}
            <p class="field-error" id=fault_id>{said}</p>
        </div>
    }
}

#[component]
fn Results(answer: Arc<Answer>, name: String) -> impl IntoView {
    let state = State::expect();
    let units = Memo::new(move |_| state.document.with(|document| document.units));
    let ended = {
        let reason = answer
            .reason
            .clone()
            .map_or(String::new(), |r| format!(": {r}"));
        format!("{name}: {}{reason}", answer.outcome.name())
    };
    let numbers = {
        let answer = answer.clone();
        move || {
            SHOWN
                .into_iter()
                .filter_map(output::find)
                .filter_map(|output| Some((output, (output.get)(&answer)?)))
                .map(|(output, value)| {
                    let unit = units.get().of_output(output);
                    let shown = number(unit.from_canonical(value), 4);
                    view! {
                        <div data-flown=output.key><dt>{output.label}</dt><dd><span class="value">{shown}</span> " " <span class="unit">{symbol(unit)}</span></dd></div>
                    }
                })
                .collect_view()
        }
    };
    let charts = [
        ("altitude_m", "speed_m_s"),
        ("deceleration_earth_g", "time_s"),
        ("total_heat_flux_w_m2", "time_s"),
    ]
    .map(|(y, x)| {
        let spec = ChartSpec {
            x: x.to_string(),
            y: y.to_string(),
        };
        let title = spec.title();
        let answer = answer.clone();
        let of_figure = spec.clone();
        let figure = Memo::new(move |_| {
            let flight = answer.flight.as_ref();
            flight
                .map(|flight| of_figure.figure(flight, units.get(), Span::Entry))
                .unwrap_or_default()
        });
        let points = Memo::new(|_| Vec::new());
        view! {
            <figure class="chart-panel">
                <figcaption><h3>{title.clone()}</h3></figcaption>
                <Chart title=Signal::stored(title) spec=Signal::stored(spec) figure points focused=RwSignal::new(false) still=true />
            </figure>
        }
    });
    view! {
        <p class="verdict" role="status">{ended}</p>
        <dl class="numbers flown">{numbers}</dl>
        <div class="charts">{charts.into_iter().collect_view()}</div>
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use msape::{Library, Request, fly};

    #[test]
    fn a_design_s_mission_flies_every_outline_of_the_library() {
        let library = Library::builtin().unwrap();
        for (name, data) in &library.outlines {
            let entry = Entry::Preset(name.clone(), data.clone());
            let mut fields = Case::default();
            fields.set("vehicle.mass_kg", "46");
            fields.set("vehicle.drag_coefficient", "1.5");
            let case = flight_case(&Case::run_page(), &entry, &fields);
            let answer = fly(&case, &library, Request::Nothing);
            assert!(answer.is_ok(), "{name}: {:?}", answer.err());
        }
        for key in SHOWN {
            assert!(output::find(key).is_some(), "{key}");
        }
    }
}
