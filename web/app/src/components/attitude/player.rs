//! Controls of the animation time: run, stop, move.

use super::AttitudeView;
use leptos::prelude::*;
use msape_kit::display::number;
use msape_worker::clock::now_ms;

/// Animation speeds, s of flight per s.
const SPEEDS: [f64; 6] = [0.1, 0.25, 1.0, 4.0, 16.0, 64.0];
/// Longest interval between two frames that counts, s: after a longer one the page was hidden.
const LONGEST_FRAME_S: f64 = 0.25;

/// The controls.
#[component]
pub fn Player() -> impl IntoView {
    let view = AttitudeView::expect();
    let speed = RwSignal::new(4.0_f64);
    let started = StoredValue::new(0_u32);
    let ends = Memo::new(move |_| {
        let ends = view
            .course
            .with(|course| course.as_ref().map(|c| c.ends_s()));
        ends.unwrap_or_default()
    });
    let play = move || {
        if view.playing.get_untracked() {
            view.playing.set(false);
            return;
        }
        let (start_s, end_s) = ends.get_untracked();
        if view.time_s.get_untracked() >= end_s {
            view.time_s.set(start_s);
        }
        view.playing.set(true);
        started.update_value(|count| *count += 1);
        let this = Run {
            view,
            speed,
            started,
            number: started.get_value(),
        };
        let last_ms = now_ms();
        request_animation_frame(move || this.picture(last_ms));
    };
    // the page may be left while the animation runs
    on_cleanup(move || {
        let _ = view.playing.try_set(false);
    });
    let step = move |seconds: f64| {
        view.playing.set(false);
        let (start_s, end_s) = ends.get_untracked();
        view.go_to((view.time_s.get_untracked() + seconds).clamp(start_s, end_s));
    };
    let words = move || format!("{} s", number((10.0 * view.time_s.get()).round() / 10.0, 5));
    view! {
        <div class="player" role="group" aria-label="Time of the flight">
            <button type="button" class="small play" aria-pressed=move || view.playing.get().to_string()
                on:click=move |_| play()>{move || if view.playing.get() { "Pause" } else { "Play" }}</button>
            <button type="button" class="small" aria-label="Back by a second" on:click=move |_| step(-1.0)>"−1 s"</button>
            <input type="range" aria-label="Time of the flight" step="0.05"
                min=move || ends.get().0.to_string() max=move || ends.get().1.to_string()
                aria-valuetext=words
                prop:value=move || view.time_s.get().to_string()
                on:input:target=move |event| {
                    view.playing.set(false);
                    if let Ok(time_s) = event.target().value().parse::<f64>() {
                        view.go_to(time_s);
                    }
                } />
            <button type="button" class="small" aria-label="Forward by a second" on:click=move |_| step(1.0)>"+1 s"</button>
            <output class="value">{words}</output>
            <label class="inline">
                <span>"Speed"</span>
                <select on:change:target=move |event| {
                    if let Ok(chosen) = event.target().value().parse() {
                        speed.set(chosen);
                    }
                }>
                    {SPEEDS.map(|choice| view! {
                        <option value=choice.to_string() prop:selected=move || speed.get() == choice>{format!("{choice} ×")}</option>
                    })}
                </select>
            </label>
        </div>
    }
}

/// A run of the animation, started by a press of the button.
#[derive(Clone, Copy)]
struct Run {
    view: AttitudeView,
    speed: RwSignal<f64>,
    /// Number of starts so far, shared by all runs; `number` is that of this run.
    started: StoredValue<u32>,
    number: u32,
}

impl Run {
    /// Draws one frame and requests the next while the animation runs.
    fn picture(self, last_ms: f64) {
        let Run {
            view,
            speed,
            started,
            number,
        } = self;
        // stop if the card is gone, or if the animation was stopped or restarted
        if view.playing.try_get_untracked() != Some(true) || started.get_value() != number {
            return;
        }
        let now = now_ms();
        let passed_s = (1e-3 * (now - last_ms)).clamp(0.0, LONGEST_FRAME_S);
        let end_s = view
            .course
            .with_untracked(|course| course.as_ref().map(|course| course.ends_s().1));
        let Some(end_s) = end_s else {
            return;
        };
        let time_s = view.time_s.get_untracked() + speed.get_untracked() * passed_s;
        view.go_to(time_s.min(end_s));
        if time_s >= end_s {
            view.playing.set(false);
            return;
        }
        request_animation_frame(move || self.picture(now));
    }
}
