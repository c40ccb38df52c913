//! The ten most important results.

use crate::components::results::{Validity, validity};
use crate::state::{Phase, State};
use leptos::prelude::*;
use msape::Outcome;
use msape::answer::{Output, output};
use msape_kit::display::{number, symbol};

/// Keys of the headline results with short names.
pub const HEADLINE: &[(&str, &str)] = &[
    ("total_entry_mass_kg", "Entry mass"),
    ("peak_total_margined_heat_flux_w_m2", "Peak heating"),
    ("total_margined_heat_load_j_m2", "Heat load"),
    ("peak_deceleration_earth_g", "Peak deceleration"),
    ("forebody_tps_thickness_m", "TPS thickness"),
    ("terminal_speed_m_s", "Terminal velocity"),
    ("estimated_impact_load_earth_g", "Impact load"),
    ("required_stroke_m", "Stroke"),
    ("max_payload_temperature_k", "Payload max T"),
];

/// Number of results in the strip that stays visible on a small screen.
pub const STRIP: usize = 4;

/// Symbol and words of an outcome.
pub fn outcome_words(outcome: Outcome) -> (&'static str, &'static str) {
    match outcome {
        Outcome::Converged => ("✔", "Converged"),
        Outcome::Landed => ("✔", "Landed"),
        Outcome::Stopped => ("■", "Stopped"),
        Outcome::SkippedOut => ("✖", "Skipped out"),
        Outcome::Captured => ("✖", "Captured into orbit"),
        Outcome::NotClosed => ("✖", "Did not close"),
        Outcome::NotConverged => ("▲", "Not converged"),
        Outcome::GaveUp => ("✖", "Given up"),
    }
}

/// Line on whether the numbers are up to date.
#[component]
pub fn Freshness() -> impl IntoView {
    let state = State::expect();
    let text = move || match state.phase.get() {
        Phase::Fresh => state.latest.with(|latest| {
            latest.as_ref().map_or_else(String::new, |solved| {
                format!(
                    "up to date, solved in {} ms",
                    number(solved.duration_ms.max(1.0), 2)
                )
            })
        }),
        Phase::Updating => "updating".to_string(),
        Phase::AtFault => state.latest.with(|latest| match latest {
            Some(_) => "input at fault; these are the results of the last good input".to_string(),
            None => "input at fault; it is solved as soon as it is mended".to_string(),
        }),
        Phase::Long(words) => words,
        Phase::Failed(message) => format!("not solved: {message}."),
    };
    let button = move || match state.phase.get() {
        Phase::Long(_) => Some(("Stop", State::stop_solving as fn(State))),
        Phase::Failed(_) => Some(("Try again", State::solve_again as fn(State))),
        _ => None,
    };
    let button = Memo::new_with_compare(
        move |_| button(),
        |a, b| a.flatten().map(|(words, _)| words) != b.flatten().map(|(words, _)| words),
    );
    view! {
        <p class="freshness" role="status">{text}</p>
        {move || button.get().map(|(words, act)| view! {
            <button type="button" class="small" on:click=move |_| act(state)>{words}</button>
        })}
    }
}

/// The card.
#[component]
pub fn Headline() -> impl IntoView {
    let state = State::expect();
    let outcome =
        state.of_answer(|answer| (answer.outcome, answer.reason.clone(), answer.passes.len()));
    let units = Memo::new(move |_| state.document.with(|document| document.units));
    view! {
        <section class="card headline" aria-labelledby="headline-title">
            <h2 id="headline-title">"Results"</h2>
            <div class="outcome">
                {move || outcome.get().map(|(outcome, reason, passes)| {
                    let (sign, words) = outcome_words(outcome);
                    let is_good = matches!(outcome, Outcome::Converged);
                    view! {
                        <p class="verdict" class:good=is_good class:bad=!is_good>
                            <span aria-hidden="true">{sign}</span>
                            <strong>{words}</strong>
                            {(passes > 0).then(|| format!("{passes} passes"))}
                        </p>
                        {reason.map(|reason| view! { <p class="reason">{reason}</p> })}
                    }
                })}
                <Freshness />
            </div>
            <dl class="numbers" class:stale=move || state.phase.get() != Phase::Fresh>
                {HEADLINE.iter().filter_map(|(key, name)| {
                    let output = output::find(key)?;
                    Some(view! { <Number output name units /> })
                }).collect_view()}
            </dl>
        </section>
    }
}

#[component]
fn Number(
    output: &'static Output,
    name: &'static str,
    units: Memo<msape_kit::display::UnitSystem>,
) -> impl IntoView {
    let state = State::expect();
    let value = state.of_answer(move |answer| (output.get)(answer));
    let deviation = state
        .of_answer(move |answer| deviation_of(output.key).and_then(|output| (output.get)(answer)));
    let mark = state.of_answer(move |answer| validity(answer, output.key));
    view! {
        <div>
            <dt title=output.header()>{name}</dt>
            <dd data-output=output.key>
                {move || {
                    let unit = units.get().of_output(output);
                    let text = value.get().flatten().map_or("–".to_string(), |value| number(unit.from_canonical(value), 4));
                    view! { <span class="value">{text}</span> " " <span class="unit">{symbol(unit)}</span> }
                }}
                {move || deviation.get().flatten().map(|deviation| {
                    let unit = units.get().of_output(output);
                    let width = unit.from_canonical(deviation) - unit.from_canonical(0.0);
                    view! { <span class="unit">{format!(" ± {}", number(width, 2))}</span> }
                })}
            </dd>
            <dd class="mark">{move || mark.get().filter(|mark| *mark != Validity::InRange).map(|mark| view! { <span class=mark.class()>{mark.words()}</span> })}</dd>
        </div>
    }
}

/// Output with the standard deviation of a thickness.
fn deviation_of(key: &str) -> Option<&'static Output> {
    output::find(&key.replace("_thickness_", "_standard_deviation_"))
        .filter(|output| output.key != key)
}

/// First headline results in one line, which stays visible on a small screen.
#[component]
pub fn Strip() -> impl IntoView {
    let state = State::expect();
    let units = Memo::new(move |_| state.document.with(|document| document.units));
    view! {
        <div class="strip" class:stale=move || state.phase.get() != Phase::Fresh aria-hidden="true">
            {HEADLINE.iter().take(STRIP).filter_map(|(key, name)| {
                let output = output::find(key)?;
                let value = state.of_answer(move |answer| (output.get)(answer));
                Some(view! {
                    <div>
                        <span class="unit">{*name}</span>
                        <span class="value">{move || {
                            let unit = units.get().of_output(output);
                            value.get().flatten().map_or("–".to_string(), |value| {
                                format!("{} {}", number(unit.from_canonical(value), 3), symbol(unit))
                            })
                        }}</span>
                    </div>
                })
            }).collect_view()}
        </div>
    }
}
