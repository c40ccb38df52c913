//! What the pointer does to the view, as buttons and fields.

use crate::view3d::camera::Camera;
use leptos::prelude::*;

/// A turn by a key or a button, rad.
pub const TURN_RAD: f32 = 0.2618;
/// A zoom by a key or a button.
pub const ZOOM: f32 = 1.2;
/// A step of the cut, degrees.
pub const CUT_STEP_DEG: f64 = 15.0;
/// The widest cut, degrees.
pub const CUT_MAX_DEG: f64 = 270.0;

/// A button: sign, name, what it does to the camera.
type Turn = (&'static str, &'static str, fn(Camera) -> Camera);

const TURNS: [Turn; 6] = [
    ("←", "Turn left", |camera| camera.turned(TURN_RAD, 0.0)),
    ("→", "Turn right", |camera| camera.turned(-TURN_RAD, 0.0)),
    ("↑", "Tilt up", |camera| camera.turned(0.0, -TURN_RAD)),
    ("↓", "Tilt down", |camera| camera.turned(0.0, TURN_RAD)),
    ("+", "Zoom in", |camera| camera.zoomed(ZOOM)),
    ("−", "Zoom out", |camera| camera.zoomed(1.0 / ZOOM)),
];

/// Buttons that turn, zoom and stand the camera, and the cut as slider and field.
#[component]
pub fn Controls(
    camera: RwSignal<Camera>,
    cut_deg: RwSignal<f64>,
    /// Where the camera stands at first.
    home: Camera,
    /// Ends identifiers.
    id: &'static str,
    /// Stands the camera anew so that the vehicle fills the view.
    stand: Callback<Camera>,
) -> impl IntoView {
    let places = [
        ("Reset", home),
        ("Side", Camera::SIDE),
        ("Front", Camera::FRONT),
        ("Back", Camera::BACK),
    ];
    view! {
        <div class="controls-3d">
            <div class="tools" role="group" aria-label="Turn and zoom">
                {TURNS.into_iter().map(|(sign, name, turn)| view! {
                    <button type="button" class="small" aria-label=name title=name
                        on:click=move |_| camera.update(|camera| *camera = turn(*camera))>{sign}</button>
                }).collect_view()}
            </div>
            <div class="tools" role="group" aria-label="Stand of the camera">
                {places.into_iter().map(|(name, place)| view! {
                    <button type="button" class="small" on:click=move |_| stand.run(place)>{name}</button>
                }).collect_view()}
                <button type="button" class="small" on:click=move |_| stand.run(Camera { zoom: 1.0, ..camera.get_untracked() })>"Fit"</button>
            </div>
            <div class="cut">
                <label for=format!("cut-{id}")>"Cut open"</label>
                <input id=format!("cut-{id}") type="range" min="0" max=CUT_MAX_DEG step="5" prop:value=move || cut_deg.get().to_string()
                    aria-valuetext=move || format!("{} degrees", cut_deg.get())
                    on:input:target=move |event| set_cut(cut_deg, &event.target().value()) />
                <input type="text" inputmode="decimal" class="cut-field" aria-label="Cut open, degrees" prop:value=move || cut_deg.get().to_string()
                    on:change:target=move |event| {
                        set_cut(cut_deg, &event.target().value());
                        // What is no angle gives way to the one that holds.
                        event.target().set_value(&cut_deg.get_untracked().to_string());
                    } />
                <span class="unit" aria-hidden="true">"deg"</span>
            </div>
        </div>
    }
}

fn set_cut(cut_deg: RwSignal<f64>, text: &str) {
    if let Ok(angle) = text.trim().replace(',', ".").parse::<f64>()
        && angle.is_finite()
    {
        cut_deg.set(angle.clamp(0.0, CUT_MAX_DEG));
    }
}
