//! Section of an outline, to scale, with its main dimensions.

use crate::drawing::{Silhouette, silhouette};
use crate::state::State;
use leptos::prelude::*;
use msape::units::{Dimension, canonical};
use msape::vehicle::body::RigidBody;
use msape_kit::display::{UnitSystem, number, symbol};

fn length(meters: f64, units: UnitSystem) -> String {
    let unit = units.unit(Dimension::Length, canonical(Dimension::Length));
    let shown = number(unit.from_canonical(meters), 4);
    format!("{shown} {}", symbol(unit))
}

/// Description of the drawing in a sentence.
pub fn describe(body: &RigidBody, units: UnitSystem) -> String {
    let nose = body.nose_radius_m.map_or(String::new(), |radius| {
        format!(", nose radius {}", length(radius, units))
    });
    let cone = body.cone_half_angle_rad.map_or(String::new(), |angle| {
        format!(", cone half-angle {} deg", number(angle.to_degrees(), 3))
    });
    format!(
        "{}: diameter {}, length {}{nose}{cone}.",
        body.name,
        length(body.diameter_m, units),
        length(body.length_m(), units)
    )
}

/// The drawing.
#[component]
pub fn OutlineDrawing(#[prop(into)] body: Signal<Option<RigidBody>>) -> impl IntoView {
    let state = State::expect();
    move || {
        let units = state.document.with(|document| document.units);
        body.with(|body| body.as_ref().map(|body| sheet(body, units)))
    }
}

fn sheet(body: &RigidBody, units: UnitSystem) -> impl IntoView + use<> {
    let Silhouette {
        path,
        radius_mm: r,
        top_mm: top,
        bottom_mm: bottom,
        widest_mm: widest,
    } = silhouette(body);
    let font = 0.09 * r;
    let a = 0.35 * font;
    let (x, y) = (1.16 * r, bottom + 0.24 * r);
    let (left, right) = (-1.2 * r, 1.75 * r);
    let (view_top, view_bottom) = (top - 0.12 * r, y + 1.8 * font);
    let nose = body.nose_radius_m.map(|nose_m| {
        let nose = 1e3 * nose_m;
        let (nx, ny) = (-0.17 * nose.min(r), bottom - nose + (nose * nose - 0.0289 * nose.min(r) * nose.min(r)).sqrt());
        view! {
            <path class="leader" d=format!("M{nx} {ny}L{} {}", nx - 0.1 * r, bottom + 0.06 * r)></path>
            <text x=nx - 0.12 * r y=bottom + 0.12 * r text-anchor="end">{format!("nose R {}", length(nose_m, units))}</text>
        }
    });
    let cone = body.cone_half_angle_rad.map(|angle| {
        let text = format!("cone {} deg", number(angle.to_degrees(), 3));
        view! { <text x=right - 0.5 * font y=bottom + 0.12 * r text-anchor="end">{text}</text> }
    });
    view! {
        <svg class="section" role="img" aria-label=format!("Section of {}", describe(body, units))
            viewBox=format!("{left:.1} {view_top:.1} {:.1} {:.1}", right - left, view_bottom - view_top)>
            <path class="part part-aftbody-carrier" d=path.clone()></path>
            <path class="outline" d=path></path>
            <path class="axis" d=format!("M0 {:.1}V{:.1}", top - 0.08 * r, bottom + 0.08 * r)></path>
            <g font-size=font>
                <path class="dimension" d=format!("M{} {}V{}M{r} {}V{}M{} {y}H{r}", -r, widest + 0.03 * r, y + a, widest + 0.03 * r, y + a, -r)></path>
                <path class="arrow" d=format!("M{} {y}l{} {}v{}ZM{r} {y}l{} {}v{}Z", -r, 2.0 * a, -0.5 * a, a, -2.0 * a, -0.5 * a, a)></path>
                <text x="0" y=y + 1.15 * font text-anchor="middle">{format!("⌀ {}", length(body.diameter_m, units))}</text>
                <path class="dimension" d=format!("M{} {top}H{}M{} {bottom}H{}M{x} {top}V{bottom}", 0.05 * r, x + a, 0.05 * r, x + a)></path>
                <path class="arrow" d=format!("M{x} {top}l{} {}h{}ZM{x} {bottom}l{} {}h{}Z", -0.5 * a, 2.0 * a, a, -0.5 * a, -2.0 * a, a)></path>
                <text x=x + 0.4 * font y=0.5 * (top + bottom) text-anchor="start" dominant-baseline="central">{length(body.length_m(), units)}</text>
                {nose}
                {cone}
            </g>
        </svg>
    }
}
