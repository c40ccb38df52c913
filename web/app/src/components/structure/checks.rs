//! Every rule for a wall, in every load case.

use super::{StructureView, margin};
use leptos::prelude::*;
use msape::units::{Dimension, Unit};
use msape::vehicle::structure::{Check, Rule};
use msape_kit::display::{UnitSystem, number, symbol};

/// Table of checks of the selected wall.
#[component]
pub fn Checks() -> impl IntoView {
    let view = StructureView::expect();
    let rows = move || {
        let (wall, units) = (view.wall.get(), view.card.units.get());
        view.structural.with(|structural| {
            let structural = structural.as_ref()?;
            let least = structural.critical(wall);
            let checks = structural.checks.iter().filter(|check| check.wall == wall);
            let mut checks: Vec<&Check> = checks.collect();
            // minimum gauge first, then by increasing margin
            checks.sort_by(|a, b| {
                let gauge = |check: &Check| check.rule != Rule::MinimumGauge;
                (gauge(a).cmp(&gauge(b))).then(a.margin.total_cmp(&b.margin))
            });
            let rows = checks
                .into_iter()
                .map(|check| row(check, least.is_some_and(|l| l == check), units));
            Some(rows.collect_view())
        })
    };
    let thickness = move || format!("Asks for, {}", symbol(view.card.units.get().named("mm")));
    let label = move || format!("Checks of the {}", view.wall.get().label().to_lowercase());
    view! {
        <div class="mass-tree checks" tabindex="0" role="region" aria-label=label>
            <table class="tree">
                <thead>
                    <tr>
                        <th scope="col">"Rule"</th>
                        <th scope="col" class="words">"Load case"</th>
                        <th scope="col">"Demand"</th>
                        <th scope="col">"Capacity"</th>
                        <th scope="col" class="words">"Unit"</th>
                        <th scope="col">"Margin"</th>
                        <th scope="col">{thickness}</th>
                        <th scope="col" class="words">"Source"</th>
                    </tr>
                </thead>
                <tbody>{rows}</tbody>
            </table>
        </div>
        <p class="quiet">"Demand includes the factor of safety; margin is capacity over demand less one. “Asks for” is the thickness that the rule alone needs, of a rule for faces that of both together; empty where a thicker wall does not help."</p>
    }
}

/// Displayed unit of demand and capacity, and the unit to convert to.
fn unit_of(check: &Check, units: UnitSystem) -> (String, Option<&'static Unit>) {
    let found = Unit::find(&check.unit).map(|unit| match unit.dimension {
        Dimension::Pressure => units.named("MPa"),
        Dimension::Length => units.named("mm"),
        dimension => units.unit(dimension, unit),
    });
    (found.map_or_else(|| check.unit.clone(), symbol), found)
}

fn row(check: &Check, is_least: bool, units: UnitSystem) -> impl IntoView + use<> {
    let (unit_text, unit) = unit_of(check, units);
    let shown = |value: f64| number(unit.map_or(value, |unit| unit.from_canonical(value)), 4);
    let thickness = check
        .required_thickness_m
        .map(|m| number(units.named("mm").from_canonical(m), 3));
    let is_short = check.margin < -1e-6;
    let is_gauge = check.rule == Rule::MinimumGauge;
    view! {
        <tr class:least=is_least>
            <th scope="row">{check.rule.label()} {is_least.then(|| view! { " " <span class="mark mark-least">"least margin"</span> })}</th>
            <td class="words">{check.load_case.label()}</td>
            <td>{shown(check.demand)}</td>
            <td>{shown(check.capacity)}</td>
            <td class="unit">{unit_text}</td>
            <td class="value" class:short=is_short class:unit=is_gauge>{margin(check.margin)}</td>
            <td>{thickness}</td>
            <td class="words source">{check.source.clone()}</td>
        </tr>
    }
}
