//! The mass tree: every component, the margin once, and their sum.

use super::{basis, drawn};
use crate::components::vehicle::VehicleView;
use crate::display::{UnitSystem, number, symbol};
use crate::drawing::class;
use leptos::prelude::*;
use msape::units::{Dimension, Unit, canonical};
use msape::vehicle::{Component, Vehicle};

/// A column of numbers: heading, quantity, and its value for a component and for the whole.
struct Column {
    heading: &'static str,
    dimension: Dimension,
    digits: usize,
    of: fn(&Component, &Vehicle) -> f64,
    total: fn(&Vehicle) -> f64,
}

const COLUMNS: &[Column] = &[
    Column {
        heading: "CG from nose",
        dimension: Dimension::Length,
        digits: 4,
        of: |c, v| c.cg_x_m - v.dimensions.virtual_apex_ahead_m,
        total: |v| v.dimensions.cg_from_nose_m,
    },
    Column {
        heading: "Ixx",
        dimension: Dimension::Inertia,
        digits: 4,
        of: |c, _| c.ixx_kg_m2,
        total: |v| v.mass.ixx_kg_m2,
    },
    Column {
        heading: "Iyy = Izz",
        dimension: Dimension::Inertia,
        digits: 4,
        of: |c, _| c.iyy_kg_m2,
        total: |v| v.mass.iyy_kg_m2,
    },
    Column {
        heading: "Volume",
        dimension: Dimension::Volume,
        digits: 4,
        of: |c, _| c.volume_m3,
        total: |v| v.mass.volume_m3,
    },
    Column {
        heading: "Surface",
        dimension: Dimension::Area,
        digits: 4,
        of: |c, _| c.surface_area_m2,
        total: |v| v.components.iter().map(|c| c.surface_area_m2).sum(),
    },
    Column {
        heading: "Wetted",
        dimension: Dimension::Area,
        digits: 4,
        of: |c, _| c.wetted_area_m2,
        total: |v| v.dimensions.wetted_area_m2,
    },
];

fn unit(units: UnitSystem, dimension: Dimension) -> &'static Unit {
    units.unit(dimension, canonical(dimension))
}

/// The tab.
#[component]
pub fn MassTree() -> impl IntoView {
    let view = VehicleView::expect();
    let table = move || {
        let units = view.units.get();
        view.vehicle
            .with(|vehicle| vehicle.as_ref().map(|vehicle| tree(vehicle, units)))
    };
    view! {
        <div class="mass-tree" tabindex="0" role="region" aria-label="Mass tree">{table}</div>
        <p class="quiet">"Masses of components are without margin; the margin stands once, below them. Inertia is with margin: of a component about its own centre of gravity, of the whole about the whole's."</p>
    }
}

fn tree(vehicle: &Vehicle, units: UnitSystem) -> impl IntoView + use<> {
    let mass_unit = unit(units, Dimension::Mass);
    let density_unit = unit(units, Dimension::Density);
    let total = vehicle.mass;
    let margin_kg = total.mass_kg - total.mass_without_margin_kg;
    let mass = move |kg: f64| number(mass_unit.from_canonical(kg), 5);
    let share = move |kg: f64| format!("{:.1}", 100.0 * kg / total.mass_kg);
    let heading = |text: &str, unit: &Unit| format!("{text}, {}", symbol(unit));
    let head = COLUMNS
        .iter()
        .map(|column| {
            let text = heading(column.heading, unit(units, column.dimension));
            view! { <th scope="col">{text}</th> }
        })
        .collect_view();
    let numbers = |value: &dyn Fn(&Column) -> f64| {
        COLUMNS
            .iter()
            .map(|column| {
                let unit = unit(units, column.dimension);
                let shown = number(unit.from_canonical(value(column)), column.digits);
                view! { <td>{shown}</td> }
            })
            .collect_view()
    };
    let rows = drawn(vehicle)
        .map(|component| {
            let density = number(density_unit.from_canonical(component.density_kg_m3), 4);
            view! {
                <tr>
                    <th scope="row">
                        <svg viewBox="0 0 10 10" aria-hidden="true"><rect width="10" height="10" rx="2" class=class(component.kind)></rect></svg>
                        {component.kind.label()}
                    </th>
                    <td class="words">{component.material.clone()}</td>
                    <td>{density}<span class="basis">{basis(component.density_basis)}</span></td>
                    <td class="value">{mass(component.mass_kg)}</td>
                    <td>{share(component.mass_kg)}</td>
                    {numbers(&|column| (column.of)(component, vehicle))}
                </tr>
            }
        })
        .collect_view();
    view! {
        <table class="tree">
            <thead>
                <tr>
                    <th scope="col">"Component"</th>
                    <th scope="col" class="words">"Material"</th>
                    <th scope="col">{heading("Density", density_unit)}</th>
                    <th scope="col">{heading("Mass", mass_unit)}</th>
                    <th scope="col">"Share, %"</th>
                    {head}
                </tr>
            </thead>
            <tbody>{rows}</tbody>
            <tfoot>
                <tr>
                    <th scope="row">"Margin"</th>
                    <td class="words">"on all but the payload"</td>
                    <td></td>
                    <td class="value">{mass(margin_kg)}</td>
                    <td>{share(margin_kg)}</td>
                    {COLUMNS.iter().map(|_| view! { <td></td> }).collect_view()}
                </tr>
                <tr class="sum">
                    <th scope="row">"Entry mass"</th>
                    <td></td>
                    <td></td>
                    <td class="value" data-mass-kg=total.mass_kg.to_string()>{mass(total.mass_kg)}</td>
                    <td>"100.0"</td>
                    {numbers(&|column| (column.total)(vehicle))}
                </tr>
            </tfoot>
        </table>
    }
}
