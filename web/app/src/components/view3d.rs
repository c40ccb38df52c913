//! Vehicle in three dimensions: cut open, colored by component, material or heat flux.

mod controls;
mod scale;
pub mod stage;

use crate::components::mass_tree::{Detail, Legend};
use crate::components::vehicle::VehicleView;
use crate::drawing::variable;
use crate::state::State;
use leptos::prelude::*;
use msape::answer::surface::SurfaceHeating;
use msape::vehicle::{Component, ComponentKind, Vehicle};
use msape_kit::display::{UnitSystem, number, symbol};
use msape_kit::files::file_name;
use msape_kit::segments::Segments;
use msape_view3d::paint::{self, Color};
use scale::Scale;
use stage::{Paint, PaintedPart, Stage, Subject};

/// Meaning of the colors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Colors {
    /// One color for each component.
    Component,
    /// One color for each material.
    Material,
    /// Color scale of heat flux on the outer surface.
    HeatFlux,
}

/// Color of surfaces that are not heated.
const UNHEATED: Color = [0.62, 0.65, 0.69];

/// The tab.
#[component]
pub fn View3d() -> impl IntoView {
    let state = State::expect();
    let view = VehicleView::expect();
    let colors = RwSignal::new(Colors::Component);
    let subject = Signal::derive(move || view.solved.get().map(Subject::Design));
    let parts = Memo::new(move |_| {
        let (lit, chosen) = (view.lit.get(), view.chosen.get());
        view.vehicle.with(|vehicle| {
            let vehicle = vehicle.as_ref()?;
            let materials = materials(vehicle);
            let part = |component: &Component| PaintedPart {
                paint: match colors.get() {
                    Colors::Component => Paint::Variable(variable(component.kind)),
                    Colors::Material => Paint::Fixed(material_color(&materials, component)),
                    Colors::HeatFlux => Paint::Fixed(UNHEATED),
                },
                shown: view.shows(component.kind),
                lit: lit == Some(component.kind) || chosen == Some(component.kind),
            };
            Some(drawn(vehicle).map(part).collect::<Vec<_>>())
        })
    });
    let parts = Signal::derive(move || parts.get().unwrap_or_default());
    let by_scale = Signal::derive(move || colors.get() == Colors::HeatFlux);
    let pick = move |place: usize| {
        let kind = view
            .vehicle
            .with_untracked(|vehicle| Some(drawn(vehicle.as_ref()?).nth(place)?.kind));
        if let Some(kind) = kind {
            view.choose(kind);
        }
    };
    // swatches have the colors of the view
    let fill = move |kind: ComponentKind| {
        view.vehicle.with(|vehicle| {
            let vehicle = vehicle.as_ref()?;
            let component = vehicle.component(kind)?;
            match colors.get() {
                Colors::Component => None,
                Colors::Material => {
                    let color = material_color(&materials(vehicle), component);
                    Some(paint::css(color))
                }
                Colors::HeatFlux if component.wetted_area_m2 > 0.0 => {
                    Some(format!("url(#{})", scale::GRADIENT))
                }
                Colors::HeatFlux => Some(paint::css(UNHEATED)),
            }
        })
    };
    let summary = Signal::derive(move || {
        view.vehicle.with(|vehicle| {
            let Some(vehicle) = vehicle.as_ref() else {
                return String::new();
            };
            let shown = drawn(vehicle).filter(|c| view.shows(c.kind)).count();
            format!(
                "Vehicle in three dimensions. {} {shown} of {} components are shown.",
                crate::components::drawing::dimensions(&vehicle.dimensions, view.units.get()),
                drawn(vehicle).count()
            )
        })
    });
    let name = Signal::derive(move || {
        let name = state.case.with(|case| case.name.clone());
        file_name(&format!("{name}-3d"), "png")
    });
    view! {
        <div class="vehicle">
            <div class="tools" role="group" aria-label="Colors">
                <Segments
                    legend="Colored by"
                    choices=vec![
                        (Colors::Component, "Component"),
                        (Colors::Material, "Material"),
                        (Colors::HeatFlux, "Heat flux"),
                    ]
                    now=colors
                    choose=move |choice| colors.set(choice)
                />
            </div>
            <Stage subject parts by_scale summary name pick=Callback::new(pick) />
            <div class="beside">
                <Legend fill=Callback::new(fill) />
                {move || match colors.get() {
                    Colors::Component => ().into_any(),
                    Colors::Material => view! { <Materials /> }.into_any(),
                    Colors::HeatFlux => view! { <HeatScale /> }.into_any(),
                }}
            </div>
            <Detail />
        </div>
    }
}

/// Components that have a body, in the order of the mass tree.
fn drawn(vehicle: &Vehicle) -> impl Iterator<Item = &Component> {
    vehicle.components.iter().filter(|c| c.volume_m3 > 0.0)
}

/// Materials of a vehicle, without duplicates.
fn materials(vehicle: &Vehicle) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for component in drawn(vehicle) {
        if !names.contains(&component.material) {
            names.push(component.material.clone());
        }
    }
    names
}

fn material_color(materials: &[String], component: &Component) -> Color {
    let place = materials.iter().position(|m| *m == component.material);
    paint::of_material(place.unwrap_or_default())
}

/// Legend of materials.
#[component]
fn Materials() -> impl IntoView {
    let view = VehicleView::expect();
    let names = Memo::new(move |_| {
        view.vehicle
            .with(|vehicle| vehicle.as_ref().map(materials).unwrap_or_default())
    });
    view! {
        <h3>"Materials"</h3>
        <ul class="materials" aria-label="Colors of materials">
            {move || names.get().into_iter().enumerate().map(|(place, name)| view! {
                <li>
                    <svg viewBox="0 0 10 10" aria-hidden="true"><rect width="10" height="10" rx="2" fill=paint::css(paint::of_material(place))></rect></svg>
                    <span>{name}</span>
                </li>
            }).collect_view()}
        </ul>
    }
}

/// Legend of heat flux.
#[component]
fn HeatScale() -> impl IntoView {
    let view = VehicleView::expect();
    let heating = Memo::new(move |_| {
        view.solved
            .with(|solved| SurfaceHeating::of(&solved.as_ref()?.answer))
    });
    view! {
        {move || heating.get().map(|heating| {
            let unit = heat_unit(view.units.get());
            let shown = |flux: f64| format!("{} {}", number(unit.from_canonical(flux), 3), symbol(unit));
            view! {
                <h3>"Largest heat flux, with margins"</h3>
                <Scale largest=unit.from_canonical(heating.largest_w_m2()) unit=symbol(unit) />
                <dl class="numbers">
                    <div><dt>"Stagnation point"</dt><dd>{shown(heating.stagnation_w_m2)}</dd></div>
                    <div><dt>"Shoulder"</dt><dd>{shown(heating.shoulder_w_m2)}</dd></div>
                    <div><dt>"Aftbody"</dt><dd>{shown(heating.aftbody_w_m2)}</dd></div>
                </dl>
                <p class="quiet">"Nose and cone after Lees (1956), a lower bound on cones steeper than 55 deg; the shoulder and the aftbody as their heat shields are sized: one value each."</p>
            }
        })}
    }
}

fn heat_unit(units: UnitSystem) -> &'static msape::units::Unit {
    use msape::answer::output;
    use msape::units::{Dimension, canonical};
    let printed = output::find("peak_total_margined_heat_flux_w_m2")
        .map_or(canonical(Dimension::HeatFlux), |output| output.shown_unit());
    units.unit(Dimension::HeatFlux, printed)
}
