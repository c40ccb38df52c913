//! Components of the vehicle with their masses: legend of drawings, detail of one component, complete table.

mod table;

pub use table::MassTree;

use crate::components::vehicle::VehicleView;
use crate::drawing::class;
use leptos::prelude::*;
use msape::units::{Dimension, Unit, canonical};
use msape::vehicle::layout::Depths;
use msape::vehicle::material::DensityBasis;
use msape::vehicle::{Component, ComponentKind, Vehicle};
use msape_kit::display::{number, symbol};

/// Components that have a body.
fn drawn(vehicle: &Vehicle) -> impl Iterator<Item = &Component> {
    vehicle.components.iter().filter(|c| c.volume_m3 > 0.0)
}

/// Legend: number, color, name and mass of each component; clicking shows its detail, a check box hides it.
#[component]
pub fn Legend(
    /// Fill of a component's swatch instead of its own color.
    #[prop(optional)]
    fill: Option<Callback<ComponentKind, Option<String>>>,
) -> impl IntoView {
    let view = VehicleView::expect();
    let (lit, chosen) = (view.lit, view.chosen);
    let kinds = Memo::new(move |_| {
        view.vehicle.with(|vehicle| {
            let vehicle = vehicle.as_ref();
            vehicle.map_or(Vec::new(), |v| drawn(v).map(|c| c.kind).collect::<Vec<_>>())
        })
    });
    let mass = move |kind| {
        view.vehicle.with(|vehicle| {
            let component = vehicle.as_ref()?.component(kind)?;
            Some(component.mass_with_margin_kg)
        })
    };
    let total = move || {
        view.vehicle
            .with(|vehicle| vehicle.as_ref().map(|vehicle| vehicle.mass.mass_kg))
    };
    let shown = |value: Option<f64>| value.map_or("–".to_string(), |value| number(value, 3));
    let toggle = move |kind| {
        view.hidden.update(|hidden| {
            match hidden.iter().position(|other| *other == kind) {
                Some(place) => drop(hidden.remove(place)),
                None => hidden.push(kind),
            };
        });
    };
    view! {
        <table class="legend">
            <caption>"Mass with margin, kg"</caption>
            <tbody>
                {move || kinds.get().into_iter().enumerate().map(|(i, kind)| view! {
                    <tr class:lit=move || lit.get() == Some(kind) || chosen.get() == Some(kind)
                        on:pointerenter=move |_| lit.set(Some(kind)) on:pointerleave=move |_| lit.set(None)>
                        <td class="show">
                            <input type="checkbox" aria-label=format!("Show {}", kind.label()) title="Show"
                                prop:checked=move || view.shows(kind) on:change=move |_| toggle(kind) />
                        </td>
                        <th scope="row">
                            <button type="button" aria-expanded=move || (chosen.get() == Some(kind)).to_string()
                                on:focus=move |_| lit.set(Some(kind)) on:blur=move |_| lit.set(None)
                                on:click=move |_| view.choose(kind)>
                                <svg viewBox="0 0 10 10" aria-hidden="true">
                                    {move || match fill.and_then(|fill| fill.run(kind)) {
                                        Some(fill) => view! { <rect width="10" height="10" rx="2" fill=fill></rect> }.into_any(),
                                        None => view! { <rect width="10" height="10" rx="2" class=class(kind)></rect> }.into_any(),
                                    }}
                                </svg>
                                <span>{i + 1} " " {kind.label()}</span>
                            </button>
                        </th>
                        <td class="value">{move || shown(mass(kind))}</td>
                    </tr>
                }).collect_view()}
            </tbody>
            <tfoot><tr><td></td><th scope="row">"Total"</th><td>{move || shown(total())}</td></tr></tfoot>
        </table>
    }
}

/// Thickness of a component that is a layer or a wall, m.
fn thickness_m(kind: ComponentKind, vehicle: &Vehicle) -> Option<f64> {
    let Depths {
        forebody_tps_m,
        bond_m,
        forebody_carrier_m,
        aftbody_tps_m,
        aftbody_carrier_m,
        primary_m,
    } = vehicle.layout.depths;
    Some(match kind {
        ComponentKind::ForebodyTps => forebody_tps_m,
        ComponentKind::Bond => bond_m,
        ComponentKind::ForebodyCarrier => forebody_carrier_m,
        ComponentKind::AftbodyTps => aftbody_tps_m,
        ComponentKind::AftbodyCarrier => aftbody_carrier_m,
        ComponentKind::PrimaryStructure => primary_m,
        ComponentKind::ImpactShell => vehicle.layout.impact_shell_thickness_m,
        ComponentKind::ImpactFoam => vehicle.layout.foam_thickness_m,
        ComponentKind::BodyFoam => vehicle.layout.body_foam_thickness_m,
        ComponentKind::LidInsulation => vehicle.layout.lid_insulation_thickness_m,
        ComponentKind::WingInsulation | ComponentKind::Payload => return None,
    })
    .filter(|thickness| *thickness > 0.0)
}

/// Origin of a density, in words.
fn basis(basis: DensityBasis) -> &'static str {
    match basis {
        DensityBasis::Published => "published",
        DensityBasis::Assumed => "assumed",
        DensityBasis::Given => "given",
        DensityBasis::DerivedFromAssumed => "from assumed numbers",
    }
}

/// Material, mass, thickness, density, volume and center of gravity of the selected component.
#[component]
pub fn Detail() -> impl IntoView {
    let view = VehicleView::expect();
    let found = Memo::new(move |_| {
        let kind = view.chosen.get()?;
        view.vehicle.with(|vehicle| {
            let vehicle = vehicle.as_ref()?;
            let component = vehicle.component(kind)?;
            Some((
                component.clone(),
                thickness_m(kind, vehicle),
                vehicle.mass.mass_kg,
                vehicle.dimensions.virtual_apex_ahead_m,
            ))
        })
    });
    let units = view.units;
    view! {
        {move || found.get().map(|(component, thickness_m, total_kg, apex_m)| {
            let shown = |value: f64, dimension: Dimension| {
                let unit = units.get().unit(dimension, canonical(dimension));
                format!("{} {}", number(unit.from_canonical(value), 4), symbol(unit))
            };
            let thin = |value: f64| {
                let centimeter = Unit::find("cm").unwrap_or_else(|| canonical(Dimension::Length));
                let unit = units.get().unit(Dimension::Length, centimeter);
                format!("{} {}", number(unit.from_canonical(value), 4), symbol(unit))
            };
            let density = format!("{} ({})", shown(component.density_kg_m3, Dimension::Density), basis(component.density_basis));
            let items = [
                ("Material", Some(component.material.clone())),
                ("Thickness", thickness_m.map(thin)),
                ("Mass with margin", Some(shown(component.mass_with_margin_kg, Dimension::Mass))),
                ("without", Some(shown(component.mass_kg, Dimension::Mass))),
                ("Share", Some(format!("{} %", number(100.0 * component.mass_with_margin_kg / total_kg, 3)))),
                ("Density", Some(density)),
                ("Volume", Some(shown(component.volume_m3, Dimension::Volume))),
                ("CG from nose", Some(shown(component.cg_x_m - apex_m, Dimension::Length))),
            ];
            let items = items.into_iter().filter_map(|(name, text)| Some((name, text?)));
            view! {
                <div class="part-detail">
                    <h3>{component.kind.label()}</h3>
                    <dl>{items.map(|(name, text)| view! { <div><dt>{name}</dt><dd>{text}</dd></div> }).collect_view()}</dl>
                </div>
            }
        })}
    }
}
