//! Attitude of the design in flight: inputs, numbers, charts, and an animated view of the vehicle.

mod inputs;
mod player;
mod reorientation;
mod scene;

use crate::charts::{ATTITUDE_PLOTS, ChartSpec, Span};
use crate::components::chart_panel::ChartPanel;
use crate::state::asker::Asker;
use crate::state::{Phase, Solved, State};
use inputs::Inputs;
use leptos::prelude::*;
use msape::Answer;
use msape::answer::output;
use msape::problem::asks_for_attitude;
use msape::quantity::input;
use msape_kit::display::{number, symbol};
use msape_kit::segments::Segments;
use msape_view3d::attitude::Course;
use msape_worker::protocol::Fault;
use msape_worker::questions::Attitude;
use player::Player;
use reorientation::Reorientation;
use scene::Scene;
use std::sync::Arc;
use wasm_bindgen_futures::spawn_local;

/// Outputs shown for a flight with attitude.
const SHOWN: [&str; 8] = [
    "initial_total_alpha_deg",
    "first_below_10_deg_time_s",
    "first_below_10_deg_knudsen",
    "total_alpha_at_peak_heating_deg",
    "total_alpha_at_peak_deceleration_deg",
    "maximum_total_alpha_after_peak_heating_deg",
    "last_hemisphere_change_time_s",
    "final_total_alpha_amplitude_deg",
];

/// State shared by the parts of the card.
#[derive(Clone, Copy)]
pub struct AttitudeView {
    /// The newest flight with attitude, and the design that flew it.
    pub flown: RwSignal<Option<Arc<Flown>>>,
    /// Answer of that flight.
    pub answer: Signal<Option<Arc<Answer>>>,
    /// Attitude and velocity along that flight.
    pub course: Memo<Option<Arc<Course>>>,
    /// Row of its time history at the cursor.
    pub cursor: RwSignal<Option<usize>>,
    /// Displayed time, s.
    pub time_s: RwSignal<f64>,
    /// Row at which the cursor was last set from a time.
    placed: StoredValue<Option<usize>>,
    /// Whether the animation runs.
    pub playing: RwSignal<bool>,
    /// Faults of the newest question.
    pub faults: RwSignal<Vec<Fault>>,
}

/// Flight with attitude and the design that flew it.
#[derive(Debug)]
pub struct Flown {
    /// The design.
    pub solved: Arc<Solved>,
    /// The flight.
    pub answer: Arc<Answer>,
}

impl PartialEq for Flown {
    fn eq(&self, other: &Flown) -> bool {
        Arc::ptr_eq(&self.answer, &other.answer)
    }
}

impl AttitudeView {
    fn new(state: State) -> AttitudeView {
        let flown = RwSignal::new(None::<Arc<Flown>>);
        let course = Memo::new(move |_| {
            flown.with(|flown| {
                let flight = flown.as_ref()?.answer.flight.as_ref()?;
                Course::of(flight.trajectory.as_ref()?).map(Arc::new)
            })
        });
        let view = AttitudeView {
            flown,
            answer: Signal::derive(move || {
                flown.with(|flown| flown.as_ref().map(|flown| flown.answer.clone()))
            }),
            course,
            cursor: RwSignal::new(None),
            time_s: RwSignal::new(0.0),
            placed: StoredValue::new(None),
            playing: RwSignal::new(false),
            faults: RwSignal::new(Vec::new()),
        };
        view.fly_on_change(state);
        view.link(state);
        view
    }

    /// View provided by an ancestor of this component.
    pub fn expect() -> AttitudeView {
        expect_context::<AttitudeView>()
    }

    /// Flies each solved design that asks for it; only the newest answer counts.
    fn fly_on_change(self, state: State) {
        let asker = Asker::default();
        Effect::new(move |_| {
            let solved = state.latest.get();
            let wanted = solved
                .filter(|solved| asks_for_attitude(&solved.case) && solved.answer.design.is_some());
            let Some(solved) = wanted else {
                return asker.wants_nothing();
            };
            spawn_local(async move {
                match state.ask(asker, Attitude(solved.designed())).await {
                    Some(Ok(answer)) => {
                        self.faults.set(Vec::new());
                        let answer = Arc::new(answer);
                        self.flown.set(Some(Arc::new(Flown { solved, answer })));
                    }
                    Some(Err(faults)) => self.faults.set(faults),
                    None => {}
                }
            });
        });
    }

    /// Links the time of the animation with the cursors of the attitude charts and the design's charts.
    fn link(self, state: State) {
        Effect::new(move |_| {
            let row = self.cursor.get();
            // the exact time stays where it was set
            if row.is_none() || row == self.placed.get_value() {
                return;
            }
            self.placed.set_value(row);
            self.playing.set(false);
            let time_s = self
                .course
                .with_untracked(|course| course.as_ref()?.time_s(row?));
            if let Some(time_s) = time_s {
                self.time_s.set(time_s);
            }
        });
        // a new flight may be shorter
        Effect::new(move |_| {
            let ends = self
                .course
                .with(|course| course.as_ref().map(|c| c.ends_s()));
            if let Some((start_s, end_s)) = ends {
                let now = self.time_s.get_untracked();
                if !(start_s..=end_s).contains(&now) {
                    self.time_s.set(now.clamp(start_s, end_s));
                }
            }
        });
        let mark = move |time_s: f64| {
            state.latest.with_untracked(|latest| {
                let flight = latest.as_ref()?.answer.flight.as_ref()?;
                let times = flight.trajectory.as_ref()?.column("time_s")?;
                let after = times.partition_point(|t| *t < time_s);
                Some(after.min(times.len().checked_sub(1)?))
            })
        };
        Effect::new(move |before: Option<f64>| {
            let time_s = self.time_s.get();
            if before.is_some_and(|before| before != time_s) {
                state.cursor.set(mark(time_s));
            }
            time_s
        });
    }

    /// Sets the time; vehicle and charts follow.
    pub fn go_to(self, time_s: f64) {
        let row = self
            .course
            .with_untracked(|course| course.as_ref().map(|course| course.row(time_s)));
        self.placed.set_value(row);
        self.time_s.set(time_s);
        if self.cursor.get_untracked() != row {
            self.cursor.set(row);
        }
    }
}

/// The card.
#[component]
pub fn AttitudeCard() -> impl IntoView {
    let state = State::expect();
    let rigid = Memo::new(move |_| state.case.with(|case| asks_for_attitude(case)));
    let choose = move |rigid: bool| {
        state.edit("Degrees of freedom", None, |document| {
            document
                .with_case(|case| case.set(input::vehicle::DOF.key, if rigid { "6" } else { "" }))
        });
    };
    view! {
        <section class="card panel-attitude" aria-labelledby="attitude-title">
            <header>
                <h2 id="attitude-title">"Attitude"</h2>
                <Segments legend="Degrees of freedom" choices=vec![(false, "3: point mass"), (true, "6: rigid body")]
                    now=rigid choose />
            </header>
            <Show when=move || rigid.get() fallback=|| view! {
                <p class="quiet">"With six degrees of freedom the vehicle of the design flies its mission once more as a rigid body, with its own inertia, center of gravity and aerodynamics."</p>
            }>
                <RigidFlight />
            </Show>
            <Reorientation />
        </section>
    }
}

#[component]
fn RigidFlight() -> impl IntoView {
    let state = State::expect();
    let view = AttitudeView::new(state);
    provide_context(view);
    let stale = move || {
        let newest = state.latest.with(|latest| latest.as_ref().map(|s| s.id));
        let shown = view
            .flown
            .with(|flown| flown.as_ref().map(|flown| flown.solved.id));
        state.phase.get() != Phase::Fresh || newest != shown
    };
    let faults = move || {
        view.faults.with(|faults| {
            let said = faults.iter().map(|fault| view! {
                <li class="note-outside"><code>{fault.key.clone()}</code> " " {fault.message.clone()}</li>
            });
            said.collect_view()
        })
    };
    let is_flown = Memo::new(move |_| view.flown.with(Option::is_some));
    let span = RwSignal::new(Span::Entry);
    view! {
        <Inputs />
        <div role="status"><ul class="notes">{faults}</ul></div>
        <Show when=move || is_flown.get() fallback=|| view! { <p class="quiet" role="status">"The rigid body has not flown yet."</p> }>
            <div class:stale-figure=stale>
                <Numbers />
                <div class="attitude-pair">
                    <div>
                        <Player />
                        <Scene />
                    </div>
                    <div>
                        <Segments legend="Time of the attitude shown" choices=vec![(Span::Entry, "Entry"), (Span::Whole, "Whole flight")]
                            now=span choose=move |choice| span.set(choice) />
                        <div class="charts">
                            {ATTITUDE_PLOTS.map(|(y, x)| {
                                let spec = RwSignal::new(ChartSpec { x: x.to_string(), y: y.to_string() });
                                view! { <ChartPanel spec span answer=view.answer cursor=view.cursor /> }
                            })}
                        </div>
                    </div>
                </div>
            </div>
        </Show>
    }
}

#[component]
fn Numbers() -> impl IntoView {
    let state = State::expect();
    let view = AttitudeView::expect();
    let shown = move || {
        let units = state.document.with(|document| document.units);
        view.answer.with(|answer| {
            let answer = answer.as_ref()?;
            let numbers = SHOWN.into_iter().filter_map(output::find).map(|output| {
                let unit = units.of_output(output);
                let (value, symbol) = match (output.get)(answer) {
                    Some(value) => (number(unit.from_canonical(value), 4), symbol(unit)),
                    None => ("never".to_string(), String::new()),
                };
                view! {
                    <div data-attitude=output.key><dt>{output.label}</dt><dd><span class="value">{value}</span> " " <span class="unit">{symbol}</span></dd></div>
                }
            });
            Some(numbers.collect_view())
        })
    };
    view! { <dl class="numbers flown">{shown}</dl> }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_numbers_are_outputs() {
        for key in SHOWN {
            assert!(output::find(key).is_some(), "{key}");
        }
    }
}
