//! Mass tree: every component, the margin once, and the sum.

use super::basis;
use crate::components::export::save;
use crate::components::vehicle::VehicleView;
use crate::state::State;
use leptos::prelude::*;
use msape::table;
use msape::units::{Dimension, Unit, canonical};
use msape::vehicle::Vehicle;
use msape::vehicle::mass_tree::{Line, MassTree as Tree};
use msape_kit::display::{UnitSystem, number, symbol};
use msape_kit::files::{self, file_name};

/// Numeric column: heading, quantity, and value for a line.
struct Column {
    heading: &'static str,
    dimension: Dimension,
    of: fn(&Line) -> Option<f64>,
}

const COLUMNS: &[Column] = &[
    Column {
        heading: "CG from nose",
        dimension: Dimension::Length,
        of: |line| Some(line.cg_from_nose_m),
    },
    Column {
        heading: "Ixx",
        dimension: Dimension::Inertia,
        of: |line| Some(line.ixx_kg_m2),
    },
    Column {
        heading: "Iyy = Izz",
        dimension: Dimension::Inertia,
        of: |line| Some(line.iyy_kg_m2),
    },
    Column {
        heading: "Volume",
        dimension: Dimension::Volume,
        of: |line| line.volume_m3,
    },
    Column {
        heading: "Surface",
        dimension: Dimension::Area,
        of: |line| line.surface_area_m2,
    },
    Column {
        heading: "Wetted",
        dimension: Dimension::Area,
        of: |line| line.wetted_area_m2,
    },
];

/// Significant digits of masses and of other numbers.
const DIGITS: (usize, usize) = (5, 4);

fn unit(units: UnitSystem, dimension: Dimension) -> &'static Unit {
    units.unit(dimension, canonical(dimension))
}

/// The tab.
#[component]
pub fn MassTree() -> impl IntoView {
    let state = State::expect();
    let view = VehicleView::expect();
    let table = move || {
        let units = view.units.get();
        let vehicle = view.vehicle;
        vehicle.with(|vehicle| vehicle.as_ref().map(|vehicle| tree(vehicle, units)))
    };
    let csv = move |_| {
        let name = state.case.with_untracked(|case| case.name.clone());
        let text = view
            .vehicle
            .with_untracked(|vehicle| Some(table::mass_tree(vehicle.as_ref()?).to_csv()));
        if let Some(text) = text {
            let name = file_name(&format!("{name}-mass-tree"), "csv");
            save(state, files::download(&name, "text/csv", &text));
        }
    };
    view! {
        <div class="mass-tree" tabindex="0" role="region" aria-label="Mass tree">{table}</div>
        <div class="stage-foot">
            <p class="quiet">"Components are without margin; the margin stands once, below them. Inertia is about the center of gravity of the line."</p>
            <button type="button" class="small" aria-label="CSV of the mass tree" on:click=csv>"CSV"</button>
        </div>
    }
}

fn tree(vehicle: &Vehicle, units: UnitSystem) -> impl IntoView + use<> {
    let Tree {
        components,
        without_margin,
        margin,
        total,
        crushed,
    } = vehicle.mass_tree();
    let total_kg = total.mass_kg;
    let bodies = components
        .iter()
        .filter(|line| line.volume_m3 != Some(0.0))
        .map(|line| row(line, total_kg, units, ""))
        .collect_view();
    let heading = |text: &str, dimension| format!("{text}, {}", symbol(unit(units, dimension)));
    view! {
        <table class="tree">
            <thead>
                <tr>
                    <th scope="col">"Component and material"</th>
                    <th scope="col">{heading("Density", Dimension::Density)}</th>
                    <th scope="col">{heading("Mass", Dimension::Mass)}</th>
                    <th scope="col">"Share, %"</th>
                    {COLUMNS.iter().map(|column| view! { <th scope="col">{heading(column.heading, column.dimension)}</th> }).collect_view()}
                </tr>
            </thead>
            <tbody>{bodies}</tbody>
            <tfoot>
                {row(&without_margin, total_kg, units, "")}
                {row(&margin, total_kg, units, "")}
                {row(&total, total_kg, units, "sum")}
                {row(&crushed, total_kg, units, "")}
            </tfoot>
        </table>
    }
}

fn row(
    line: &Line,
    total_kg: f64,
    units: UnitSystem,
    class: &'static str,
) -> impl IntoView + use<> {
    let shown = |value: Option<f64>, dimension: Dimension, digits: usize| {
        value.map(|value| number(unit(units, dimension).from_canonical(value), digits))
    };
    let numbers = COLUMNS
        .iter()
        .map(|column| view! { <td>{shown((column.of)(line), column.dimension, DIGITS.1)}</td> })
        .collect_view();
    view! {
        <tr class=class>
            <th scope="row">
                {line.name.clone()}
                {line.material.clone().map(|material| view! { <span class="basis">{material}</span> })}
            </th>
            <td>
                {shown(line.density_kg_m3, Dimension::Density, DIGITS.1)}
                {line.density_basis.map(|of| view! { <span class="basis">{basis(of)}</span> })}
            </td>
            <td class="value">{shown(Some(line.mass_kg), Dimension::Mass, DIGITS.0)}</td>
            <td>{format!("{:.1}", 100.0 * line.mass_kg / total_kg)}</td>
            {numbers}
        </tr>
    }
}
