//! Benchmark page: times of the solver in this browser, as ratios to a bare kernel measured in the same run.

use crate::state::{Phase, State};
use crate::timing::{Measured, Timing};
use benchmark::NAMES;
use leptos::prelude::*;
use msape_kit::display::number;
use msape_kit::files;
use msape_worker::clock::now_ms;
use msape_worker::questions::Measure;
use wasm_bindgen_futures::spawn_local;

/// Progress of the measurement.
#[derive(Clone, Debug, PartialEq)]
enum Progress {
    Waiting,
    Measuring(usize),
    Done { seconds: f64 },
    Cancelled,
    Failed(String),
}

impl Progress {
    fn text(&self) -> String {
        match self {
            Progress::Waiting => "Waiting for the first design.".to_string(),
            Progress::Measuring(row) => format!("Measuring {} of {}.", row + 1, NAMES.len()),
            Progress::Done { seconds } => format!("Done, in {} s.", number(*seconds, 2)),
            Progress::Cancelled => "Cancelled.".to_string(),
            Progress::Failed(message) => format!("Failed: {message}."),
        }
    }
}

/// State of the page.
#[derive(Clone, Copy)]
struct Shown {
    progress: RwSignal<Progress>,
    /// Finished jobs.
    done: RwSignal<Vec<Measured>>,
    /// Number of the newest run: an older one stops at its next batch.
    run: StoredValue<u32>,
}

impl Shown {
    fn start(self, state: State) {
        self.run.update_value(|run| *run += 1);
        let run = self.run.get_value();
        self.done.set(Vec::new());
        self.progress.set(Progress::Measuring(0));
        spawn_local(async move {
            let start_ms = now_ms();
            let mut reference = None;
            for row in 0..NAMES.len() {
                let measured = self.measure(state, run, row, &mut reference).await;
                // the page may have been left meanwhile
                if self.run.try_get_value() != Some(run) {
                    return;
                }
                match measured {
                    Ok(measured) => self.done.update(|done| done.push(measured)),
                    Err(message) => return self.progress.set(Progress::Failed(message)),
                }
                if row + 1 < NAMES.len() {
                    self.progress.set(Progress::Measuring(row + 1));
                }
            }
            let seconds = (now_ms() - start_ms) / 1000.0;
            self.progress.set(Progress::Done { seconds });
        });
    }

    /// Time of a job; the result of a stopped run is not used. The first job is the reference.
    async fn measure(
        self,
        state: State,
        run: u32,
        row: usize,
        reference: &mut Option<Measure>,
    ) -> Result<Measured, String> {
        let mut timing = Timing::default();
        while !timing.is_done() && self.run.try_get_value() == Some(run) {
            let batch = Measure {
                job: row as u32,
                repetitions: timing.repetitions,
            };
            let batch_ms = state.ask_once(batch).await?;
            if timing.is_short(batch_ms) {
                continue;
            }
            let reference = *reference.get_or_insert(batch);
            let reference_ms = match row {
                0 => batch_ms,
                _ => state.ask_once(reference).await?,
            };
            timing.take(batch_ms, reference_ms / f64::from(reference.repetitions));
        }
        timing.median().ok_or_else(|| "no time was taken".into())
    }

    fn cancel(self) {
        self.run.update_value(|run| *run += 1);
        self.progress.set(Progress::Cancelled);
    }

    fn is_measuring(self) -> bool {
        self.progress
            .with(|progress| matches!(progress, Progress::Measuring(_)))
    }

    /// Time and ratio of a row, as shown.
    fn cells(self, row: usize) -> Option<[String; 2]> {
        self.done.with(|done| {
            let Measured { time_ms, ratio } = *done.get(row)?;
            Some([duration(time_ms), number(ratio, 3)])
        })
    }
}

fn duration(time_ms: f64) -> String {
    if time_ms < 1.0 {
        format!("{} µs", number(1000.0 * time_ms, 3))
    } else {
        format!("{} ms", number(time_ms, 3))
    }
}

/// Properties of this browser: terms and descriptions.
fn circumstances(state: State) -> [(&'static str, String); 3] {
    let navigator = window().navigator();
    let first = state.first_answer_ms.get();
    let cores = navigator.hardware_concurrency();
    [
        (
            "From navigation to the first solved design",
            first.map_or("–".to_string(), |ms| {
                format!("{} ms", number(ms.round(), 3))
            }),
        ),
        ("Logical processors", number(cores, 3)),
        (
            "Browser",
            navigator.user_agent().unwrap_or_else(|_| "–".to_string()),
        ),
    ]
}

/// All results as text: rows of cells separated by tabs.
fn text(state: State, shown: Shown) -> String {
    let head = format!("M-SAPE {} benchmark", env!("CARGO_PKG_VERSION"));
    let known = circumstances(state).map(|(term, value)| format!("{term}\t{value}"));
    let rows = NAMES.iter().enumerate().map(|(row, name)| {
        let [time, ratio] = shown.cells(row).unwrap_or_default();
        format!("{name}\t{time}\t{ratio}")
    });
    [head]
        .into_iter()
        .chain(known)
        .chain(["Job\tTime\tRatio".to_string()])
        .chain(rows)
        .collect::<Vec<_>>()
        .join("\n")
}

/// The page.
#[component]
pub fn Benchmark() -> impl IntoView {
    let state = State::expect();
    let shown = Shown {
        progress: RwSignal::new(Progress::Waiting),
        done: RwSignal::new(Vec::new()),
        run: StoredValue::new(0),
    };
    // the first design comes first, and must not disturb the measurement
    Effect::new(move |_| {
        let ready = matches!(state.phase.get(), Phase::Fresh | Phase::AtFault);
        if ready && shown.progress.get_untracked() == Progress::Waiting {
            shown.start(state);
        }
    });
    let copy = move |_| {
        let text = untrack(|| text(state, shown));
        spawn_local(async move {
            let copied = files::copy(text).await;
            state.notice.set(match copied {
                Ok(()) => "The table is copied.".to_string(),
                Err(_) => "The browser refused to copy.".to_string(),
            });
        });
    };
    let row = move |row: usize, name: &'static str| {
        let cell = move |column: usize| {
            move || {
                shown
                    .cells(row)
                    .map_or("–".to_string(), |cells| cells[column].clone())
            }
        };
        let is_now = move || shown.progress.get() == Progress::Measuring(row);
        view! {
            <tr class:measuring=is_now>
                <th scope="row">{name}</th>
                <td class="value">{cell(0)}</td>
                <td class="value ratio">{cell(1)}</td>
            </tr>
        }
    };
    view! {
        <main id="main" class="benchmark" tabindex="-1">
            <p><a href="#/design">"Back to the design"</a></p>
            <section class="card" aria-labelledby="benchmark-title">
                <h2 id="benchmark-title">"Benchmark"</h2>
                <p class="quiet">"How long the solver takes in this browser, in the worker that also solves the design. Each time is the median of batches of at least 20 ms. Each ratio is the median over the same batches, each to a batch of the bare kernel of the first row beside it. On the command line, cargo bench measures the same jobs."</p>
                <div class="actions">
                    // a single button, so that the focus stays when its label changes
                    <button type="button" class="primary" on:click=move |_| {
                        if untrack(move || shown.is_measuring()) { shown.cancel() } else { shown.start(state) }
                    }>
                        {move || if shown.is_measuring() { "Cancel" } else { "Run again" }}
                    </button>
                    <button type="button" on:click=copy>"Copy as text"</button>
                    <p class="progress" role="status">{move || shown.progress.with(Progress::text)}</p>
                </div>
                <table class="outputs" aria-labelledby="benchmark-title">
                    <thead><tr><th scope="col">"Job"</th><th scope="col">"Time"</th><th scope="col">"Ratio"</th></tr></thead>
                    <tbody>
                        {NAMES.iter().enumerate().map(|(index, name)| row(index, name)).collect_view()}
                    </tbody>
                </table>
            </section>
            <section class="card" aria-labelledby="browser-title">
                <h2 id="browser-title">"This browser"</h2>
                <dl class="circumstances">
                    {move || circumstances(state).map(|(term, value)| view! {
                        <div><dt>{term}</dt><dd>{value}</dd></div>
                    }).collect_view()}
                </dl>
            </section>
        </main>
    }
}
