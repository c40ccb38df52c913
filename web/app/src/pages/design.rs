//! Design page: inputs, vehicle, flight, results, notes and coupling of one design.

use crate::charts::{ChartSpec, REPORT_PLOTS, Span};
use crate::components::attitude::AttitudeCard;
use crate::components::chart_panel::ChartPanel;
use crate::components::coupling::Coupling;
use crate::components::export::Export;
use crate::components::form::Form;
use crate::components::headline::{Headline, Strip};
use crate::components::notes::Notes;
use crate::components::open::{Open, StartFrom};
use crate::components::results::Results;
use crate::components::runs::Runs;
use crate::components::vehicle::VehicleCard;
use crate::state::{Phase, State};
use leptos::prelude::*;
use msape_kit::segments::Segments;

/// The page.
#[component]
pub fn Design() -> impl IntoView {
    let state = State::expect();
    let stale = move || state.phase.get() != Phase::Fresh;
    let spec = |(y, x): (&str, &str)| {
        RwSignal::new(ChartSpec {
            x: x.to_string(),
            y: y.to_string(),
        })
    };
    let span = RwSignal::new(Span::Entry);
    let free = spec(("mach", "time_s"));
    view! {
        <Strip />
        <main id="main" class="design" tabindex="-1">
            <section class="column-inputs" aria-labelledby="inputs-title">
                <h2 id="inputs-title">"Inputs"</h2>
                <StartFrom />
                <Form />
            </section>
            <div class="column-main">
                <VehicleCard />
                <section class="card" aria-labelledby="flight-title">
                    <header>
                        <h2 id="flight-title">"Flight"</h2>
                        <Segments
                            legend="Time shown"
                            choices=vec![(Span::Entry, "Entry"), (Span::Whole, "Whole flight")]
                            now=span
                            choose=move |choice| span.set(choice)
                        />
                    </header>
                    <div class="charts" class:stale-figure=stale>
                        {REPORT_PLOTS.into_iter().map(|plot| view! { <ChartPanel spec=spec(plot) span /> }).collect_view()}
                        <ChartPanel spec=free span free=true />
                    </div>
                </section>
                <AttitudeCard />
                <Coupling />
            </div>
            <div class="column-results">
                <Headline />
            </div>
            <div class="column-side">
                <Notes />
                <Results />
                <Runs />
                <section class="card" aria-labelledby="files-title">
                    <h2 id="files-title">"Files"</h2>
                    <h3>"Export"</h3>
                    <Export />
                    <h3>"Open"</h3>
                    <Open />
                </section>
            </div>
        </main>
    }
}
