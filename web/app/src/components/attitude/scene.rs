//! Animated view of the vehicle, with its flight direction.

use super::AttitudeView;
use crate::components::view3d::stage::{Paint, PaintedPart, Stage, Subject};
use crate::drawing::variable;
use crate::state::State;
use leptos::prelude::*;
use msape_kit::display::number;
use msape_kit::files::file_name;
use msape_view3d::attitude::{Attitude, on_screen};
use msape_view3d::camera::Camera;

/// Start and end of arrows, from the center of the view; its half-width is 100.
const ARROW: (f64, f64) = (62.0, 92.0);

/// The view.
#[component]
pub fn Scene() -> impl IntoView {
    let state = State::expect();
    let view = AttitudeView::expect();
    let camera = RwSignal::new(Camera::SIDE);
    let subject = Signal::derive(move || {
        view.flown
            .with(|flown| Some(Subject::Design(flown.as_ref()?.solved.clone())))
    });
    let parts = Memo::new(move |_| {
        view.flown.with(|flown| {
            let design = flown.as_ref()?.solved.answer.design.as_ref()?;
            let solid = design
                .vehicle
                .components
                .iter()
                .filter(|c| c.volume_m3 > 0.0);
            let part = |component: &msape::vehicle::Component| PaintedPart {
                paint: Paint::Variable(variable(component.kind)),
                shown: true,
                lit: false,
            };
            Some(solid.map(part).collect::<Vec<_>>())
        })
    });
    let parts = Signal::derive(move || parts.get().unwrap_or_default());
    let attitude = Signal::derive(move || {
        let time_s = view.time_s.get();
        view.course.with(|course| {
            let course = course.as_ref();
            course.map_or(Attitude::upright(), |course| course.attitude(time_s))
        })
    });
    let at = move |key: &str| {
        let row = view
            .course
            .with(|course| Some(course.as_ref()?.row(view.time_s.get())))?;
        view.answer.with(|answer| {
            let history = answer.as_ref()?.flight.as_ref()?.trajectory.as_ref()?;
            history.column(key)?.get(row).copied()
        })
    };
    let reading = move || {
        let shown = |key: &str, factor: f64, digits| {
            at(key).map_or("–".to_string(), |value| number(factor * value, digits))
        };
        format!(
            "{} s: total angle of attack {} deg, altitude {} km, Mach {}, Knudsen number {}",
            number((10.0 * view.time_s.get()).round() / 10.0, 5),
            shown("total_alpha_deg", 1.0, 3),
            shown("altitude_m", 1e-3, 4),
            shown("mach", 1.0, 3),
            shown("knudsen", 1.0, 2),
        )
    };
    // the accessible description does not change with time
    let summary = Signal::derive(move || {
        "Vehicle as it turns in flight, seen from the right of its track: downrange to the right, up upwards.".to_string()
    });
    let name = Signal::derive(move || {
        let name = state.case.with(|case| case.name.clone());
        file_name(&format!("{name}-attitude"), "png")
    });
    let overlay = move || {
        view! {
            <svg class="flight-overlay" viewBox="-100 -100 200 200" aria-hidden="true" focusable="false">
                {move || {
                    let time_s = view.time_s.get();
                    let direction = view.course.with(|course| course.as_ref().map(|course| course.direction(time_s)));
                    arrow(on_screen(&camera.get(), direction.unwrap_or_default()), "velocity", "velocity")
                }}
                {move || arrow(on_screen(&camera.get(), [0.0, 1.0, 0.0]), "up", "up")}
            </svg>
        }
    };
    view! {
        <p class="reading" aria-live=move || if view.playing.get() { "off" } else { "polite" }>{reading}</p>
        <Stage subject parts by_scale=Signal::stored(false) summary name id="attitude" attitude camera overlay />
    }
}

/// Arrow in a direction on the screen; `None` where it points at the viewer.
fn arrow([x, y, _]: [f64; 3], class: &'static str, label: &'static str) -> Option<impl IntoView> {
    let length = x.hypot(y);
    if length < 0.1 {
        return None;
    }
    let (x, y) = (x / length, -y / length);
    let (from, to) = ARROW;
    let to = from + (to - from) * length.min(1.0);
    let (tip_x, tip_y) = (to * x, to * y);
    let (back_x, back_y) = (tip_x - 7.0 * x, tip_y - 7.0 * y);
    // the label is to the right of a vertical arrow, below a horizontal one
    let (aside_x, aside_y) = if y > 0.0 { (y, -x) } else { (-y, x) };
    let anchor = if aside_x > 0.3 { "start" } else { "middle" };
    let middle = 0.5 * (from + to);
    Some(view! {
        <g class=class>
            <path d=format!("M{:.1} {:.1}L{back_x:.1} {back_y:.1}", from * x, from * y)></path>
            <path class="head" d=format!("M{tip_x:.1} {tip_y:.1}L{:.1} {:.1}L{:.1} {:.1}Z",
                back_x - 3.5 * y, back_y + 3.5 * x, back_x + 3.5 * y, back_y - 3.5 * x)></path>
            <text x=format!("{:.1}", middle * x + 5.0 * aside_x) y=format!("{:.1}", middle * y + 9.0 * aside_y.max(0.0) + 2.0) text-anchor=anchor>{label}</text>
        </g>
    })
}
