//! Buttons and fields for the pointer actions of the view.

use leptos::prelude::*;
use msape_view3d::camera::Camera;

/// Rotation per key press or button, rad.
pub const TURN_RAD: f32 = 0.2618;
/// Zoom factor per key press or button.
pub const ZOOM: f32 = 1.2;
/// Step of the cut, deg.
pub const CUT_STEP_DEG: f64 = 15.0;
/// Largest cut, deg.
pub const CUT_MAX_DEG: f64 = 270.0;

/// Button: symbol, name, effect on the camera.
type Turn = (&'static str, &'static str, fn(Camera) -> Camera);

const TURNS: [Turn; 6] = [
    ("←", "Turn left", |camera| camera.turned(TURN_RAD, 0.0)),
    ("→", "Turn right", |camera| camera.turned(-TURN_RAD, 0.0)),
    ("↑", "Tilt up", |camera| camera.turned(0.0, -TURN_RAD)),
    ("↓", "Tilt down", |camera| camera.turned(0.0, TURN_RAD)),
    ("+", "Zoom in", |camera| camera.zoomed(ZOOM)),
    ("−", "Zoom out", |camera| camera.zoomed(1.0 / ZOOM)),
];

/// Buttons for rotation, zoom and position of the camera; the cut as slider and field.
#[component]
pub fn Controls(
    camera: RwSignal<Camera>,
    cut_deg: RwSignal<f64>,
    /// Initial position of the camera.
    home: Camera,
    /// Suffix of identifiers.
    id: &'static str,
    /// Sets the camera so that the vehicle fills the view.
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
                        // restore the current angle if the text is not an angle
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
