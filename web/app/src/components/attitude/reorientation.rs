//! Reorientation of the design: its trim angles, and entries from a set of attitudes and rates, flown side by side.

use crate::components::export::save;
use crate::state::{Solved, State};
use leptos::prelude::*;
use msape::answer::turning::{COLUMNS, Cell, sentence};
use msape::flight::six_dof::turning::{self, ENTRIES, Turn};
use msape::table;
use msape_kit::display::number;
use msape_kit::files::{self, file_name};
use msape_worker::pool::Run;
use msape_worker::questions::Turning;
use std::sync::Arc;

/// Entries flown for a design.
#[derive(Clone)]
struct Flown {
    solved: Arc<Solved>,
    turning: turning::Turning,
}

/// State of the card.
#[derive(Clone, Copy)]
struct View {
    flown: RwSignal<Option<Flown>>,
    running: RwSignal<bool>,
    run: StoredValue<Option<Run>, LocalStorage>,
    /// Fraction done of each entry.
    done: RwSignal<[f64; ENTRIES]>,
    fault: RwSignal<Option<String>>,
}

impl View {
    /// Flies the set for the displayed design, one entry per question, until it is complete or stopped.
    fn start(self, state: State) {
        let Some(solved) = state.latest.get_untracked() else {
            return;
        };
        if solved.answer.design.is_none() {
            return;
        }
        self.stop();
        self.running.set(true);
        self.fault.set(None);
        self.done.set([0.0; ENTRIES]);
        let turning = turning::Turning::default();
        self.flown.set(Some(Flown {
            solved: solved.clone(),
            turning,
        }));
        let questions = (0..ENTRIES as u32).map(|entry| Turning(solved.designed(), entry));
        // the entries in their order, whichever is flown first
        let entries = StoredValue::new(vec![None; ENTRIES]);
        let on_progress = move |entry: usize, done| {
            self.done.try_update(|all| all[entry] = done);
        };
        let run = state.ask_each(
            questions.collect(),
            on_progress,
            move |entry, told| match told {
                Ok(turn) => {
                    on_progress(entry, 1.0);
                    let known = entries.try_update_value(|entries| {
                        entries[entry] = Some(turn);
                        entries.iter().flatten().cloned().collect::<Vec<Turn>>()
                    });
                    // nothing is to be shown if the card is gone
                    let Some(known) = known else { return };
                    if known.len() == ENTRIES {
                        self.running.set(false);
                    }
                    self.flown.update(|flown| {
                        if let Some(flown) = flown {
                            flown.turning.entries = known;
                        }
                    });
                }
                Err(faults) => {
                    let said = faults.first().map(|f| format!("{} {}", f.key, f.message));
                    if self.fault.try_set(said).is_none() {
                        self.stop();
                    }
                }
            },
        );
        self.run.set_value(Some(run));
    }

    /// Stops the run; the entries being flown are dropped.
    fn stop(self) {
        if let Some(run) = self.run.try_update_value(Option::take).flatten() {
            run.stop();
        }
        self.running.set(false);
    }
}

/// Reorientation part of the card.
#[component]
pub fn Reorientation() -> impl IntoView {
    let state = State::expect();
    let view = View {
        flown: RwSignal::new(None),
        running: RwSignal::new(false),
        run: StoredValue::new_local(None),
        done: RwSignal::new([0.0; ENTRIES]),
        fault: RwSignal::new(None),
    };
    on_cleanup(move || view.stop());
    // a new design invalidates the entries
    Effect::new(move |_| {
        let newest = state.latest.with(|latest| latest.as_ref().map(|s| s.id));
        let flown = view
            .flown
            .with_untracked(|flown| flown.as_ref().map(|flown| flown.solved.id));
        if view.running.get_untracked() && newest != flown {
            view.stop();
        }
    });
    let count = move || {
        let flown = view.flown.get();
        flown.map_or(0, |flown| flown.turning.entries.len())
    };
    let stale = move || {
        let newest = state.latest.with(|latest| latest.as_ref().map(|s| s.id));
        let flown = view
            .flown
            .with(|flown| flown.as_ref().map(|flown| flown.solved.id));
        newest != flown
    };
    let said = move || match (view.fault.get(), view.running.get(), count()) {
        (Some(fault), ..) => fault,
        // read aloud at each change: the share done is in the bar
        (None, true, flown) => format!("{flown} of {ENTRIES} entries are flown."),
        (None, false, 0) => String::new(),
        (None, false, flown) => {
            let stopped = match flown == ENTRIES {
                true => String::new(),
                false => format!(" Stopped after {flown} of {ENTRIES}."),
            };
            let of_old = if stale() {
                " Flown with an earlier design."
            } else {
                ""
            };
            let sentence = view
                .flown
                .with(|flown| flown.as_ref().map(|flown| sentence(&flown.turning)));
            format!("{}{stopped}{of_old}", sentence.unwrap_or_default())
        }
    };
    let share_done = move || view.done.get().iter().sum::<f64>().to_string();
    let press = move |_| match view.running.get_untracked() {
        true => view.stop(),
        false => view.start(state),
    };
    let has_design = Memo::new(move |_| {
        let latest = state.latest.get();
        latest.is_some_and(|latest| latest.answer.design.is_some())
    });
    view! {
        <section class="reorientation" aria-labelledby="reorientation-title">
            <h3 id="reorientation-title">"Does it turn nose first?"</h3>
            <Trims />
            <p class="quiet">"Nine entries as a rigid body: from 175, 145 and 120 deg against the velocity, each with −2, 0 and 2 deg/s of pitch. A set of corners, not a probability."</p>
            <div class="stage-foot">
                <button type="button" class="small" disabled=move || !has_design.get() on:click=press>
                    {move || if view.running.get() { "Stop" } else { "Fly the nine entries" }}
                </button>
                <Show when=move || view.running.get()>
                    <progress max=ENTRIES.to_string() prop:value=share_done aria-label="Share of the entries that is flown"></progress>
                </Show>
                <p role="status">{said}</p>
            </div>
            <Show when=move || { count() > 0 }>
                <div class:stale-figure=stale><Entries view /></div>
            </Show>
        </section>
    }
}

/// Static margin and trims in both regimes.
#[component]
fn Trims() -> impl IntoView {
    let state = State::expect();
    let rows = move || {
        let latest = state.latest.get();
        let stability = latest
            .as_ref()
            .and_then(|latest| latest.answer.design.as_ref()?.stability.as_ref());
        stability.map(|stability| {
            [("Free-molecular", &stability.free_molecular), ("Hypersonic", &stability.hypersonic)].map(|(name, regime)| {
                let margin = regime.static_margin.map_or("–".to_string(), |m| number(m, 4));
                let trims = regime.trims.iter().map(|trim| {
                    let good = trim.is_stable() == (trim.alpha_deg == 0.0);
                    let class = if good { "mark mark-good" } else { "mark mark-extrapolated" };
                    view! { <span class="trim-point">{format!("{} deg ", number(trim.alpha_deg, 4))}<span class=class>{trim.word()}</span></span> " " }
                });
                view! {
                    <tr>
                        <th scope="row">{name}</th>
                        <td class="value">{margin}</td>
                        <td class="words">{trims.collect_view()}</td>
                    </tr>
                }
            }).collect_view()
        })
    };
    view! {
        <div class="wide-table" tabindex="0" role="region" aria-label="Static stability of the design">
            <table class="facts">
                <caption>"Static stability of the design about its own center of gravity"</caption>
                <thead>
                    <tr>
                        <th scope="col">"Flow"</th>
                        <th scope="col">"Static margin (D)"</th>
                        <th scope="col">"Trim angles"</th>
                    </tr>
                </thead>
                <tbody>{rows}</tbody>
            </table>
        </div>
    }
}

/// Table of entries and its export.
#[component]
fn Entries(view: View) -> impl IntoView {
    let state = State::expect();
    let turning = move || {
        view.flown
            .get()
            .map(|flown| flown.turning)
            .unwrap_or_default()
    };
    let rows = move || {
        let rows = turning().entries.into_iter().map(|entry| {
            let cells = COLUMNS.map(|column| {
                let text = match (column.cell)(&entry) {
                    Cell::Number(x) => x.map_or("–".to_string(), |x| number(x, 4)),
                    Cell::Word(word) => word.to_string(),
                };
                view! { <td class="value">{text}</td> }
            });
            view! { <tr>{cells.collect_view()}</tr> }
        });
        rows.collect_view()
    };
    let heads = COLUMNS.map(|column| view! { <th scope="col">{column.label}</th> });
    let hand_over = move |_| {
        let name = state.case.with_untracked(|case| case.name.clone());
        let name = file_name(&format!("{name}-reorientation"), "csv");
        let text = untrack(turning);
        save(
            state,
            files::download(&name, "text/csv", &table::turning(&text).to_csv()),
        );
    };
    view! {
        <div class="wide-table" tabindex="0" role="region" aria-label="Entries from nine attitudes and rates">
            <table class="facts entries">
                <caption>"Entries from nine attitudes and rates"</caption>
                <thead><tr>{heads.collect_view()}</tr></thead>
                <tbody>{rows}</tbody>
            </table>
        </div>
        <div class="stage-foot">
            <p class="quiet">"Backward: the aft end meets the largest heat rate. Unsteady: nose first then, beyond 90 deg later. Flown to Mach 5 of the point mass."</p>
            <button type="button" class="small" on:click=hand_over>"Entries as CSV"</button>
        </div>
    }
}
