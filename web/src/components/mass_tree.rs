//! The components of the vehicle with their masses: the drawing's legend, and the detail of one of them.

use crate::display::{UnitSystem, number, symbol};
use crate::drawing::class;
use leptos::prelude::*;
use msape::units::{Dimension, canonical};
use msape::vehicle::{Component, ComponentKind, Vehicle};

fn drawn(vehicle: &Vehicle) -> Vec<Component> {
    vehicle
        .components
        .iter()
        .filter(|component| component.volume_m3 > 0.0)
        .cloned()
        .collect()
}

/// The legend: number, colour, name and mass of each component; a press shows its detail.
#[component]
pub fn Legend(
    vehicle: Memo<Option<Vehicle>>,
    lit: RwSignal<Option<ComponentKind>>,
    chosen: RwSignal<Option<ComponentKind>>,
) -> impl IntoView {
    let kinds = Memo::new(move |_| {
        vehicle.with(|vehicle| {
            vehicle
                .as_ref()
                .map(|vehicle| {
                    drawn(vehicle)
                        .iter()
                        .map(|component| component.kind)
                        .collect::<Vec<_>>()
                })
                .unwrap_or_default()
        })
    });
    let mass = move |kind| {
        vehicle.with(|vehicle| {
            vehicle
                .as_ref()
                .and_then(|vehicle| {
                    vehicle
                        .components
                        .iter()
                        .find(|component| component.kind == kind)
                })
                .map(|component| component.mass_with_margin_kg)
        })
    };
    let total =
        move || vehicle.with(|vehicle| vehicle.as_ref().map(|vehicle| vehicle.mass.mass_kg));
    let shown = |value: Option<f64>| value.map_or("–".to_string(), |value| number(value, 3));
    view! {
        <table class="legend">
            <caption>"Mass with margin, kg"</caption>
            <tbody>
                {move || kinds.get().into_iter().enumerate().map(|(i, kind)| view! {
                    <tr class:lit=move || lit.get() == Some(kind) || chosen.get() == Some(kind)
                        on:pointerenter=move |_| lit.set(Some(kind)) on:pointerleave=move |_| lit.set(None)>
                        <th scope="row">
                            <button type="button" aria-expanded=move || (chosen.get() == Some(kind)).to_string()
                                on:focus=move |_| lit.set(Some(kind)) on:blur=move |_| lit.set(None)
                                on:click=move |_| chosen.update(|chosen| *chosen = if *chosen == Some(kind) { None } else { Some(kind) })>
                                <svg viewBox="0 0 10 10" aria-hidden="true"><rect width="10" height="10" rx="2" class=class(kind)></rect></svg>
                                <span>{i + 1} " " {kind.label()}</span>
                            </button>
                        </th>
                        <td class="value">{move || shown(mass(kind))}</td>
                    </tr>
                }).collect_view()}
            </tbody>
            <tfoot><tr><th scope="row">"Total"</th><td>{move || shown(total())}</td></tr></tfoot>
        </table>
    }
}

/// Mass, share, density, volume and centre of gravity of the chosen component.
#[component]
pub fn Detail(
    vehicle: Memo<Option<Vehicle>>,
    chosen: RwSignal<Option<ComponentKind>>,
    units: Memo<UnitSystem>,
) -> impl IntoView {
    let found = Memo::new(move |_| {
        let kind = chosen.get()?;
        vehicle.with(|vehicle| {
            let vehicle = vehicle.as_ref()?;
            let component = vehicle
                .components
                .iter()
                .find(|component| component.kind == kind)?;
            Some((
                component.clone(),
                vehicle.mass.mass_kg,
                vehicle.dimensions.virtual_apex_ahead_m,
            ))
        })
    });
    view! {
        {move || found.get().map(|(component, total_kg, apex_m)| {
            let shown = |value: f64, dimension: Dimension| {
                let unit = units.get().unit(dimension, canonical(dimension));
                format!("{} {}", number(unit.from_canonical(value), 4), symbol(unit))
            };
            let items = [
                ("Mass with margin", shown(component.mass_with_margin_kg, Dimension::Mass)),
                ("without", shown(component.mass_kg, Dimension::Mass)),
                ("Share", format!("{} %", number(100.0 * component.mass_with_margin_kg / total_kg, 3))),
                ("Density", shown(component.density_kg_m3, Dimension::Density)),
                ("Volume", shown(component.volume_m3, Dimension::Volume)),
                ("CG from nose", shown(component.cg_x_m - apex_m, Dimension::Length)),
            ];
            view! {
                <div class="part-detail">
                    <h3>{component.kind.label()}</h3>
                    <dl>{items.into_iter().map(|(name, text)| view! { <div><dt>{name}</dt><dd>{text}</dd></div> }).collect_view()}</dl>
                </div>
            }
        })}
    }
}
