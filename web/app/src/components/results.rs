//! All results by module, with search and copy.

use crate::state::{Phase, State};
use leptos::prelude::*;
use msape::Answer;
use msape::answer::output::{Output, outputs};
use msape::finding::Severity;
use msape::quantity::{Job, Module};
use msape_kit::display::{number, symbol};
use msape_kit::files;
use wasm_bindgen_futures::spawn_local;

/// Validity of a result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Validity {
    /// Within the range of its models.
    InRange,
    /// Outside the range in which its model was validated.
    Extrapolated,
    /// Beyond a limit.
    Outside,
}

impl Validity {
    /// Text of the mark.
    pub fn words(self) -> &'static str {
        match self {
            Validity::InRange => "in range",
            Validity::Extrapolated => "◇ extrapolated",
            Validity::Outside => "◆ outside: do not use",
        }
    }

    /// Style class of the mark.
    pub fn class(self) -> &'static str {
        match self {
            Validity::InRange => "mark mark-good",
            Validity::Extrapolated => "mark mark-extrapolated",
            Validity::Outside => "mark mark-outside",
        }
    }
}

/// Validity of a result, from the findings for its key.
pub fn validity(answer: &Answer, key: &str) -> Validity {
    let worst = answer
        .findings
        .iter()
        .filter(|finding| finding.key == key)
        .map(|finding| finding.severity)
        .max();
    match worst {
        Some(Severity::Exceeded) => Validity::Outside,
        Some(Severity::Extrapolated) => Validity::Extrapolated,
        _ => Validity::InRange,
    }
}

/// Modules in the order of the table.
const MODULES: [Module; 10] = [
    Module::Coupling,
    Module::Geometry,
    Module::Mass,
    Module::Impact,
    Module::Structure,
    Module::Flight,
    Module::Aerodynamics,
    Module::Heating,
    Module::HeatShield,
    Module::ThermalSoak,
];

fn matches(output: &Output, wanted: &str) -> bool {
    wanted.split_whitespace().all(|word| {
        output.label.to_lowercase().contains(word)
            || output.key.contains(word)
            || output.module.label().to_lowercase().contains(word)
    })
}

/// The table of all results.
#[component]
pub fn Results() -> impl IntoView {
    let state = State::expect();
    let search = RwSignal::new(String::new());
    let wanted = Memo::new(move |_| search.with(|text| text.trim().to_lowercase()));
    let count = Memo::new(move |_| {
        wanted.with(|wanted| {
            outputs(Job::Design)
                .filter(|output| matches(output, wanted))
                .count()
        })
    });
    let copy = move |_| {
        let text = tsv(state, &wanted.get_untracked());
        spawn_local(async move {
            state.notice.set(match files::copy(text).await {
                Ok(()) => "Results copied: paste them into a spreadsheet.".to_string(),
                Err(error) => format!("The browser refused to copy: {error:?}"),
            });
        });
    };
    view! {
        <section class="card results" aria-labelledby="results-title">
            <header>
                <h2 id="results-title">"All results"</h2>
                <button type="button" class="small" on:click=copy>"Copy"</button>
            </header>
            <label class="search">
                <span class="hidden-visually">"Search results"</span>
                <input type="search" placeholder="Search results" prop:value=search
                    on:input:target=move |event| search.set(event.target().value()) />
            </label>
            <p class="count" role="status">{move || format!("{} of {} results", count.get(), outputs(Job::Design).count())}</p>
            <div class:stale=move || state.phase.get() != Phase::Fresh>
                {MODULES.into_iter().map(|module| view! { <ModuleTable module wanted /> }).collect_view()}
            </div>
        </section>
    }
}

#[component]
fn ModuleTable(module: Module, wanted: Memo<String>) -> impl IntoView {
    let of_module: Vec<&'static Output> = outputs(Job::Design)
        .filter(|output| output.module == module)
        .collect();
    let any = of_module.clone();
    let is_empty =
        Memo::new(move |_| wanted.with(|wanted| !any.iter().any(|output| matches(output, wanted))));
    view! {
        <table class="outputs" hidden=move || is_empty.get()>
            <caption>{module.label()}</caption>
            <thead class="hidden-visually">
                <tr><th scope="col">"Quantity"</th><th scope="col">"Value"</th><th scope="col">"Unit"</th></tr>
            </thead>
            <tbody>
                {of_module.into_iter().map(|output| view! { <OutputRow output wanted /> }).collect_view()}
            </tbody>
        </table>
    }
}

#[component]
fn OutputRow(output: &'static Output, wanted: Memo<String>) -> impl IntoView {
    let state = State::expect();
    let value = state.of_answer(move |answer| (output.get)(answer));
    let mark = state.of_answer(move |answer| validity(answer, output.key));
    let unit = Memo::new(move |_| {
        state
            .document
            .with(|document| document.units.of_output(output))
    });
    let open = RwSignal::new(false);
    let id = format!("out-{}", output.key);
    let help_id = format!("{id}-source");
    view! {
        <tr hidden=move || !wanted.with(|wanted| matches(output, wanted)) id=id>
            <th scope="row">
                <button type="button" class="term" aria-expanded=move || open.get().to_string()
                    aria-controls=help_id.clone() on:click=move |_| open.update(|open| *open = !*open)>
                    {output.label}
                </button>
                {move || mark.get().filter(|mark| *mark != Validity::InRange)
                    .map(|mark| view! { " " <span class=mark.class()>{mark.words()}</span> })}
                <div class="source" id=help_id hidden=move || !open.get()>
                    {output.help} <br /> "Source: " {output.source} ". In files: " <code>{output.key}</code> ". "
                    {move || mark.get().map(|mark| format!("Validity: {}.", mark.words().trim_start_matches(['◇', '◆', ' '])))}
                </div>
            </th>
            <td class="value">{move || value.get().flatten().map_or("–".to_string(), |value| number(unit.get().from_canonical(value), 5))}</td>
            <td class="unit">{move || symbol(unit.get())}</td>
        </tr>
    }
}

/// Displayed results with full precision, separated by tabs.
fn tsv(state: State, wanted: &str) -> String {
    let units = state.document.with_untracked(|document| document.units);
    let rows = state.latest.with_untracked(|latest| {
        let answer = latest.as_ref().map(|solved| &solved.answer);
        outputs(Job::Design)
            .filter(|output| matches(output, wanted))
            .map(|output| {
                let unit = units.of_output(output);
                let value = answer.and_then(|answer| (output.get)(answer));
                let value = value.map(|value| unit.from_canonical(value).to_string());
                format!(
                    "{}\t{}\t{}",
                    output.label,
                    value.unwrap_or_default(),
                    unit.symbol
                )
            })
            .collect::<Vec<_>>()
    });
    format!("Quantity\tValue\tUnit\n{}\n", rows.join("\n"))
}
