//! Canvas of a 3-D view: content, camera, and handling of pointer and keys.

mod stored;

use super::controls::{CUT_MAX_DEG, CUT_STEP_DEG, Controls, TURN_RAD, ZOOM};
use crate::components::export::save;
use crate::state::State;
use leptos::ev::{Event, KeyboardEvent, PointerEvent, WheelEvent};
use leptos::html::{Canvas, Div};
use leptos::prelude::*;
use msape_kit::files;
use msape_kit::observe;
use msape_view3d::attitude::Attitude;
use msape_view3d::camera::Camera;
use msape_view3d::paint::{self, Color};
use msape_view3d::pick;
use msape_view3d::renderer::{Frame, Look, Renderer};
use msape_worker::clock::now_ms;
pub use stored::Subject;
use stored::{Moved, Stored, place};

/// Source of a color.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Paint {
    /// A variable of the style sheet, which depends on the theme.
    Variable(&'static str),
    /// A constant color.
    Fixed(Color),
}

/// Appearance of a part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PaintedPart {
    /// Color.
    pub paint: Paint,
    /// Whether the part is drawn.
    pub shown: bool,
    /// Whether the part is highlighted.
    pub lit: bool,
}

/// Rotation per CSS px of pointer movement, rad.
const TURN_RAD_PER_PX: f32 = 0.009;
/// Largest movement of a press that counts as a click, CSS px.
const CLICK_PX: f64 = 4.0;

/// Canvas with its controls.
#[component]
pub fn Stage(
    #[prop(into)] subject: Signal<Option<Subject>>,
    #[prop(into)] parts: Signal<Vec<PaintedPart>>,
    #[prop(into)] by_scale: Signal<bool>,
    /// Description of the picture in words.
    #[prop(into)]
    summary: Signal<String>,
    /// File name of a saved image.
    #[prop(into)]
    name: Signal<String>,
    /// Called with the index of the clicked part.
    #[prop(optional)]
    pick: Option<Callback<usize>>,
    /// Suffix of identifiers, where a page has more than one view.
    #[prop(default = "3d")]
    id: &'static str,
    /// Attitude of the vehicle, if it moves.
    #[prop(optional)]
    attitude: Option<Signal<Attitude>>,
    /// Camera, if other components need it.
    #[prop(optional)]
    camera: Option<RwSignal<Camera>>,
    /// Overlay on the canvas.
    #[prop(optional, into)]
    overlay: ViewFn,
) -> impl IntoView {
    let state = State::expect();
    let frame_ref = NodeRef::<Div>::new();
    let canvas_ref = NodeRef::<Canvas>::new();
    let home = camera.map_or(Camera::START, |camera| camera.get_untracked());
    let camera = camera.unwrap_or_else(|| RwSignal::new(Camera::START));
    let cut_deg = RwSignal::new(90.0);
    let size = RwSignal::new((0.0, 0.0));
    let fault = RwSignal::new(None::<String>);
    let focused = RwSignal::new(false);
    // the graphics context may be lost and restored
    let restored = RwSignal::new(0_u32);
    let ready = RwSignal::new(0_u32);
    let stored = StoredValue::new_local(Stored::default());

    let draw = move |ground: Option<Color>| {
        let Some(canvas) = canvas_ref.get_untracked() else {
            return;
        };
        let (width, height) = size.get_untracked();
        let ratio = window().device_pixel_ratio().min(3.0);
        let [width, height] = [width, height].map(|px: f64| (px * ratio).round() as u32);
        if width == 0 || height == 0 {
            return;
        }
        if (canvas.width(), canvas.height()) != (width, height) {
            canvas.set_width(width);
            canvas.set_height(height);
        }
        let ink = paint::ink(&canvas);
        let look = |part: &PaintedPart| {
            let color = match part.paint {
                Paint::Fixed(color) => color,
                Paint::Variable(name) => paint::variable(&canvas, name),
            };
            let color = match part.lit {
                true => [0, 1, 2].map(|i| 0.6 * color[i] + 0.4 * LIT[i]),
                false => color,
            };
            Look {
                color,
                shown: part.shown,
            }
        };
        let looks = parts.with_untracked(|parts| parts.iter().map(look).collect());
        stored.with_value(|stored| {
            let Some(renderer) = &stored.renderer else {
                return;
            };
            renderer.draw(&Frame {
                camera: camera.get_untracked(),
                attitude: attitude.map_or(Attitude::upright(), |attitude| attitude.get_untracked()),
                ball: stored.ball,
                cut_rad: (cut_deg.get_untracked() as f32).to_radians(),
                looks,
                by_scale: by_scale.get_untracked(),
                line: ink,
                ground,
            });
        });
    };
    // several changes cause one drawing, in the next frame
    let draw_soon = move || {
        let waits =
            stored.try_update_value(|stored| std::mem::replace(&mut stored.draws_soon, true));
        if waits == Some(false) {
            request_animation_frame(move || {
                let there = stored.try_update_value(|stored| stored.draws_soon = false);
                if there.is_some() {
                    draw(None);
                }
            });
        }
    };

    Effect::new(move |_| {
        restored.track();
        let Some(canvas) = canvas_ref.get() else {
            return;
        };
        match Renderer::new(&canvas) {
            Ok(renderer) => {
                stored.update_value(|stored| stored.renderer = Some(renderer));
                fault.set(None);
                ready.update(|count| *count += 1);
            }
            Err(message) => fault.set(Some(message)),
        }
    });
    Effect::new(move |_| {
        let Some(canvas) = canvas_ref.get().filter(|_| ready.get() > 0) else {
            return;
        };
        subject.with(|subject| {
            let start_ms = now_ms();
            stored.update_value(|stored| stored.load(subject.as_ref()));
            // drawing time, for tests and diagnostics
            let took = format!("{:.2}", now_ms() - start_ms);
            let loads = stored.with_value(|stored| stored.loads.to_string());
            let _ = canvas.set_attribute("data-load-ms", &took);
            let _ = canvas.set_attribute("data-loads", &loads);
        });
        draw_soon();
    });
    Effect::new(move |_| {
        parts.track();
        by_scale.track();
        camera.track();
        if let Some(attitude) = attitude {
            attitude.track();
        }
        cut_deg.track();
        size.track();
        state.preferences.dark.track();
        draw_soon();
    });
    observe::size(frame_ref, size);
    on_cleanup(move || {
        stored.try_with_value(|stored| stored.renderer.as_ref().map(Renderer::release));
    });

    let stand = move |place: Camera| {
        stored.update_value(|stored| stored.ball = stored.scene.ball);
        camera.set(place);
        draw_soon();
    };
    let on_key = move |event: KeyboardEvent| {
        if event.ctrl_key() || event.meta_key() || event.alt_key() {
            return;
        }
        let turn = if event.shift_key() { 0.2 } else { 1.0 } * TURN_RAD;
        let turned = |azimuth: f32, elevation: f32| {
            camera.update(|camera| *camera = camera.turned(azimuth, elevation));
        };
        let zoomed = |factor| camera.update(|camera| *camera = camera.zoomed(factor));
        let cut = |step: f64| {
            cut_deg.update(|cut| *cut = (*cut + step).clamp(0.0, CUT_MAX_DEG));
        };
        match event.key().as_str() {
            "ArrowLeft" => turned(turn, 0.0),
            "ArrowRight" => turned(-turn, 0.0),
            "ArrowUp" => turned(0.0, -turn),
            "ArrowDown" => turned(0.0, turn),
            "+" | "=" => zoomed(ZOOM),
            "-" | "_" => zoomed(1.0 / ZOOM),
            "PageUp" => cut(CUT_STEP_DEG),
            "PageDown" => cut(-CUT_STEP_DEG),
            "Home" => stand(home),
            _ => return,
        }
        event.prevent_default();
    };
    // without the focus the wheel scrolls the page
    let on_wheel = move |event: WheelEvent| {
        if focused.get_untracked() || event.ctrl_key() {
            event.prevent_default();
            let steps = event.delta_y().clamp(-240.0, 240.0) / 120.0;
            camera.update(|camera| *camera = camera.zoomed(ZOOM.powf(-steps as f32)));
        }
    };
    let on_down = move |event: PointerEvent| {
        if event.button() != 0 {
            return;
        }
        if let Some(frame) = frame_ref.get_untracked() {
            // if the pointer cannot be captured, dragging ends at the edge
            let _ = frame.set_pointer_capture(event.pointer_id());
        }
        stored.update_value(|stored| {
            if stored.pointers.is_empty() {
                stored.moved_px = 0.0;
            }
            stored.pointers.push(place(&event));
        });
    };
    let on_move = move |event: PointerEvent| {
        let moved = stored.try_update_value(|stored| stored.moved(place(&event)));
        match moved.flatten() {
            Some(Moved::Turned { x_px, y_px }) => camera.update(|camera| {
                *camera = camera.turned(
                    -TURN_RAD_PER_PX * x_px as f32,
                    TURN_RAD_PER_PX * y_px as f32,
                );
            }),
            Some(Moved::Pinched { factor, y_px }) => camera.update(|camera| {
                *camera = camera
                    .zoomed(factor as f32)
                    .turned(0.0, TURN_RAD_PER_PX * y_px as f32);
            }),
            None => {}
        }
    };
    let on_up = move |event: PointerEvent| {
        let clicked = stored.try_update_value(|stored| {
            let was_down = stored.lifted(event.pointer_id());
            was_down && stored.pointers.is_empty() && stored.moved_px < CLICK_PX
        });
        let (width, height) = size.get_untracked();
        if clicked != Some(true) || width <= 0.0 || height <= 0.0 {
            return;
        }
        let at = [
            2.0 * f64::from(event.offset_x()) / width - 1.0,
            1.0 - 2.0 * f64::from(event.offset_y()) / height,
        ];
        let found = stored.with_value(|stored| {
            let aspect = (width / height) as f32;
            let sight =
                camera
                    .get_untracked()
                    .sight(stored.ball, aspect, at.map(|part| part as f32));
            let shown = |part: usize| {
                parts.with_untracked(|parts| parts.get(part).is_some_and(|part| part.shown))
            };
            let cut_rad = cut_deg.get_untracked().to_radians();
            pick::part(&stored.scene.parts, shown, &sight, cut_rad)
        });
        if let (Some(found), Some(pick)) = (found, pick) {
            pick.run(found);
        }
    };
    let on_cancel = move |event: PointerEvent| {
        stored.update_value(|stored| {
            stored.lifted(event.pointer_id());
        });
    };
    let save_image = move |_| {
        let Some(canvas) = canvas_ref.get_untracked() else {
            return;
        };
        draw(Some(paint::ground(&canvas)));
        save(state, files::download_png(name.get_untracked(), &canvas));
        draw_soon();
    };
    let reading = move || {
        let camera = camera.get();
        let deg = |angle: f32| format!("{:.0}", angle.to_degrees() + 0.0).replace('-', "\u{2212}");
        format!(
            "Turned {} deg, tilted {} deg, magnified {:.1} times, cut open {:.0} deg",
            deg(camera.azimuth_rad),
            deg(camera.elevation_rad),
            camera.zoom,
            cut_deg.get()
        )
    };
    view! {
        <div class="stage">
            {move || fault.get().map(|message| view! {
                <p class="reason" role="status">{format!("Nothing can be shown in three dimensions: {message}. The section and the mass tree need no graphics processor.")}</p>
            })}
            <div
                class="frame-3d"
                hidden=move || fault.with(Option::is_some)
                node_ref=frame_ref
                role="application"
                aria-roledescription="3-D view"
                aria-describedby=format!("help-{id}")
                tabindex="0"
                aria-label=summary
                on:keydown=on_key
                on:wheel=on_wheel
                on:focus=move |_| focused.set(true)
                on:blur=move |_| focused.set(false)
                on:pointerdown=on_down
                on:pointermove=on_move
                on:pointerup=on_up
                on:pointercancel=on_cancel
            >
                <canvas
                    node_ref=canvas_ref
                    aria-hidden="true"
                    // allows the context to be restored
                    on:webglcontextlost=|event: Event| event.prevent_default()
                    on:webglcontextrestored=move |_: Event| restored.update(|count| *count += 1)
                ></canvas>
                {overlay.run()}
            </div>
            <Controls camera cut_deg home id stand=Callback::new(stand) />
            <p class="reading" aria-live=move || if focused.get() { "polite" } else { "off" }>{reading}</p>
            <div class="stage-foot">
                <p class="quiet" id=format!("help-{id}")>"Drag or press the arrow keys to turn. Once it has the focus, the wheel, + and − zoom. Page Up and Page Down cut, Home resets."{pick.map(|_| " A click names a component.")}</p>
                <button type="button" class="small" on:click=save_image>"PNG"</button>
            </div>
        </div>
    }
}

/// Color mixed into a highlighted part.
const LIT: Color = [1.0, 0.35, 0.75];
