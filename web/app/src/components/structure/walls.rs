//! The three walls: properties, sizing rule, and results of both levels.

use super::{StructureView, margin};
use crate::state::State;
use leptos::prelude::*;
use msape::design::structural::Structural;
use msape::shell::analysis::CaseStress;
use msape::vehicle::WallPlace;
use msape::vehicle::{ComponentKind, Vehicle};
use msape_kit::display::{UnitSystem, number, symbol, with_unit};
use msape_worker::catalog::WallMaterial;

/// Component of a wall.
fn component(wall: WallPlace) -> ComponentKind {
    match wall {
        WallPlace::Forebody => ComponentKind::ForebodyCarrier,
        WallPlace::Aftbody => ComponentKind::AftbodyCarrier,
        WallPlace::Primary => ComponentKind::PrimaryStructure,
    }
}

/// Walls side by side: rules, and shell model.
#[component]
pub fn WallTable() -> impl IntoView {
    let view = StructureView::expect();
    let rows = move || {
        let units = view.card.units.get();
        view.card.vehicle.with(|vehicle| {
            view.structural.with(|structural| {
                let (vehicle, structural) = (vehicle.as_ref()?, structural.as_ref()?);
                let rows = WallPlace::ALL.map(|wall| row(vehicle, structural, wall, units));
                Some(rows.into_iter().collect_view())
            })
        })
    };
    let thickness = move || format!("Thickness, {}", symbol(view.card.units.get().named("mm")));
    view! {
        <div class="mass-tree" tabindex="0" role="region" aria-label="Walls">
            <table class="tree walls">
                <thead>
                    <tr>
                        <th scope="col" rowspan="2">"Wall and material"</th>
                        <th scope="col" rowspan="2">{thickness}</th>
                        <th scope="col" rowspan="2" class="words">"What sized it"</th>
                        <th scope="col" class="level">"Structural rules"</th>
                        <th scope="colgroup" colspan="2" class="level">"Shell model"</th>
                    </tr>
                    <tr>
                        <th scope="col">"Least margin"</th>
                        <th scope="col">"Margin at entry"</th>
                        <th scope="col">"Margin at launch"</th>
                    </tr>
                </thead>
                <tbody>{rows}</tbody>
            </table>
        </div>
    }
}

fn row(
    vehicle: &Vehicle,
    structural: &Structural,
    wall: WallPlace,
    units: UnitSystem,
) -> impl IntoView + use<> {
    let built = *vehicle.structure.wall(wall);
    let material = vehicle
        .component(component(wall))
        .map(|c| c.material.clone());
    let millimeter = units.named("mm");
    let shown = |m: f64| number(millimeter.from_canonical(m), 3);
    let faces = (built.face_thickness_m > 0.0)
        .then(|| format!("faces of {}", shown(built.face_thickness_m)));
    let critical = structural.critical(wall).map(|check| {
        let place = format!("{}; {}", check.rule.label(), check.load_case.label());
        cell(check.margin, place)
    });
    let shell = |case: fn(&msape::shell::analysis::CarrierAnalysis) -> &CaseStress| {
        structural.shell.as_ref().and_then(|shell| {
            let part = case(shell).weakest(wall)?;
            let core = part.core_margin.is_some_and(|core| core < part.margin);
            let (what, at) = if core {
                ("core shear", part.shear_at)
            } else {
                ("stress", part.at)
            };
            let place = format!("{what}; {} from the axis", with_unit(at.r_m, 3, millimeter));
            Some(cell(part.least_margin(), place))
        })
    };
    view! {
        <tr data-wall=wall.label()>
            <th scope="row">{wall.label()}{material.map(|name| view! { <span class="basis">{name}</span> })}</th>
            <td><span class="value">{shown(built.thickness_m)}</span>{faces.map(|faces| view! { <span class="basis">{faces}</span> })}</td>
            <td class="words">{built.governs.label()}</td>
            <td>{critical}</td>
            <td>{shell(|shell| &shell.entry)}</td>
            <td>{shell(|shell| &shell.launch)}</td>
        </tr>
    }
}

/// A margin and its location.
fn cell(value: f64, place: String) -> impl IntoView + use<> {
    view! {
        <span class="value" class:short=value < -1e-6>{margin(value)}</span>
        <span class="basis">{place}</span>
    }
}

/// Assumptions on the materials of the walls, and loads of the shell model.
#[component]
pub fn Basis() -> impl IntoView {
    let view = StructureView::expect();
    let state = State::expect();
    let material = move || {
        view.card.vehicle.with(|vehicle| {
            let name = &vehicle
                .as_ref()?
                .component(ComponentKind::ForebodyCarrier)?
                .material;
            state.catalog.with(|catalog| {
                let mut walls = catalog.as_ref()?.walls.iter();
                walls.find(|wall| wall.name == *name).cloned()
            })
        })
    };
    let lines = move || {
        let units = view.card.units.get();
        material().map(|material| {
            let figures = figures(&material, units);
            view! {
                <p class="quiet"><span class="mark mark-extrapolated">"assumed"</span> " " {figures} ". " {material.note}</p>
            }
        })
    };
    let loads = move || {
        view.shell(|shell| {
            let raised = (shell.pressure_factor > 1.0)
                .then(|| format!(", Newtonian pressure raised by {} to the deceleration of the flight", number(shell.pressure_factor, 4)));
            format!(
                "Shell model: {} elements of three nodes; entry at {} Earth g{}; launch with the largest of all corners round the circle. Fillings are mass only. Margins of both levels include the factor of safety.",
                shell.elements,
                number(shell.deceleration_earth_g, 4),
                raised.unwrap_or_default()
            )
        })
    };
    view! {
        {lines}
        <p class="quiet">{loads}</p>
    }
}

fn figures(material: &WallMaterial, units: UnitSystem) -> String {
    let stress = |pa: f64, symbol: &str| with_unit(pa, 4, units.named(symbol));
    let core = material.core_shear_strength_pa.map_or(String::new(), |pa| {
        format!(", shear strength of the core {}", stress(pa, "MPa"))
    });
    format!(
        "{}: modulus {}, strength {}{core}",
        material.name,
        stress(material.elastic_modulus_pa, "GPa"),
        stress(material.strength_pa, "MPa")
    )
}
