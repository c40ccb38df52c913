//! Available and used stroke of the foam, and the crush at which it stiffens.

use crate::components::vehicle::VehicleView;
use crate::state::State;
use leptos::prelude::*;
use msape::vehicle::Vehicle;
use msape::vehicle::impact::landing::Landing;
use msape_kit::display::{UnitSystem, number, with_unit};

/// Length of the bar in SVG units.
const BAR: f64 = 200.0;

/// Strokes of one foam: thickness, and crush at which it stiffens and at which it is solid, m.
#[derive(Clone, Copy)]
struct Foam {
    thickness_m: f64,
    plateau_m: f64,
    closed_m: f64,
}

/// Table with bars.
#[component]
pub fn Stroke(ground: Memo<String>) -> impl IntoView {
    let card = VehicleView::expect();
    let table = move || {
        let (units, ground) = (card.units.get(), ground.get());
        card.solved.with(|solved| {
            let design = solved.as_ref()?.answer.design.as_ref()?;
            Some(strokes(&design.vehicle, &design.landing, &ground, units))
        })
    };
    let state = State::expect();
    let law = move || {
        state
            .catalog
            .with(|catalog| Some(catalog.as_ref()?.foam_law.clone()))
    };
    view! {
        <div class="mass-tree" tabindex="0" role="region" aria-label="Stroke in the impact foam">{table}</div>
        <details class="quiet"><summary>"How the foam crushes, and where its numbers come from"</summary><p>{law}</p></details>
    }
}

fn strokes(
    vehicle: &Vehicle,
    landing: &Landing,
    ground: &str,
    units: UnitSystem,
) -> impl IntoView + use<> {
    let absorber = &landing.absorber;
    let [_, plateau_m, closed_m] = absorber.bends_m();
    let foam = Foam {
        thickness_m: absorber.thickness_m,
        plateau_m,
        closed_m,
    };
    let length = |m: f64| with_unit(m, 3, units.named("mm"));
    let rows = [
        (
            "Equation 4, rigid surface".to_string(),
            vehicle.impact.required_stroke_m,
        ),
        (
            "Dynamics, rigid surface".to_string(),
            landing.rigid_surface.stroke_m,
        ),
        (format!("Dynamics, {ground}"), landing.ground.stroke_m),
    ]
    .map(|(name, stroke_m)| row(name, stroke_m, foam, units));
    view! {
        <table class="tree strokes">
            <thead>
                <tr>
                    <th scope="col">"Level and surface"</th>
                    <th scope="col">"Stroke"</th>
                    <th scope="col">"Of the thickness"</th>
                    <th scope="col">"Of the plateau"</th>
                    <th scope="col" class="words">"Foam"</th>
                    <th scope="col" class="words">"Used"</th>
                </tr>
            </thead>
            <tbody>{rows.into_iter().collect_view()}</tbody>
        </table>
        <p class="quiet">{format!(
            "The foam is {} thick; it crushes at {} up to {}, stiffens from there, and is solid at {}.",
            length(foam.thickness_m), with_unit(absorber.law.plateau_pa, 3, units.named("MPa")), length(foam.plateau_m), length(foam.closed_m)
        )}</p>
    }
}

fn row(name: String, stroke_m: f64, foam: Foam, units: UnitSystem) -> impl IntoView + use<> {
    let percent = |whole: f64| format!("{} %", number(100.0 * stroke_m / whole, 3));
    let stiffens = stroke_m > foam.plateau_m * (1.0 + 1e-6);
    let x = |m: f64| (BAR * m / foam.thickness_m).clamp(0.0, BAR);
    view! {
        <tr>
            <th scope="row">{name}</th>
            <td class="value">{with_unit(stroke_m, 3, units.named("mm"))}</td>
            <td>{percent(foam.thickness_m)}</td>
            <td>{percent(foam.plateau_m)}</td>
            <td class="words" class:short=stiffens>{if stiffens { "stiffens" } else { "on its plateau" }}</td>
            <td>
                <svg class="stroke-bar" viewBox="0 0 200 14" aria-hidden="true">
                    <rect class="whole" width=BAR height="14"></rect>
                    <rect class="plateau" width=x(foam.plateau_m) height="14"></rect>
                    <rect class=if stiffens { "used over" } else { "used" } y="4" width=x(stroke_m) height="6"></rect>
                    <path class="tick" d=format!("M{0:.2} 0V14", x(foam.closed_m))></path>
                </svg>
            </td>
        </tr>
    }
}
