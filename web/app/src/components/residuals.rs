//! Convergence of the mass over the passes.

use crate::charts::ChartSpec;
use crate::components::chart::Chart;
use crate::state::State;
use leptos::prelude::*;
use msape::quantity::input;
use msape_kit::display::number;
use msape_plot::{Axis, Figure, LimitLine, Marker, Scale, Series};

/// Residual of each pass as a chart and a table.
#[component]
pub fn Residuals() -> impl IntoView {
    let state = State::expect();
    let passes = state.of_answer(|answer| answer.passes.clone());
    let criterion_kg = Memo::new(move |_| {
        state.latest.with(|latest| {
            let case = &latest.as_ref()?.case;
            msape::case::Reader::new(case).number(&input::design::MASS_CRITERION_KG)
        })
    });
    let figure = Memo::new(move |_| {
        let points: Vec<(f64, f64)> = passes
            .get()
            .unwrap_or_default()
            .iter()
            .filter_map(|pass| Some((f64::from(pass.number), pass.mass_change_kg?.abs())))
            .collect();
        let mut series = Series::line("Mass change", points, 0);
        series.style.marker = Some(Marker::Circle);
        Figure {
            x: Axis::new("Pass", ""),
            y: Axis::new("Change of entry mass", "kg").with_scale(Scale::Log),
            series: vec![series],
            limits: criterion_kg
                .get()
                .map(|y| LimitLine {
                    y,
                    label: "criterion".to_string(),
                })
                .into_iter()
                .collect(),
            ..Figure::default()
        }
    });
    let points = Memo::new(move |_| {
        figure.with(|figure| {
            figure
                .series
                .first()
                .map(|series| series.points.clone())
                .unwrap_or_default()
        })
    });
    let title = Signal::derive(|| "Change of the entry mass by pass".to_string());
    let spec = Signal::derive(|| ChartSpec {
        x: String::new(),
        y: String::new(),
    });
    view! {
        <div class="residuals">
            <Chart title spec figure points focused=RwSignal::new(false) still=true />
            <div tabindex="0" role="region" aria-label="Passes">
            <table class="outputs">
                <caption class="hidden-visually">"Passes"</caption>
                <thead><tr><th scope="col">"Pass"</th><th scope="col">"Flight model"</th><th scope="col">"Entry mass (kg)"</th><th scope="col">"Change (kg)"</th></tr></thead>
                <tbody>
                    {move || passes.get().unwrap_or_default().into_iter().map(|pass| view! {
                        <tr>
                            <th scope="row">{pass.number}</th>
                            <td>{pass.flight_model.name()}</td>
                            <td class="value">{number(pass.mass_kg, 6)}</td>
                            <td class="value">{pass.mass_change_kg.map_or("–".to_string(), |change| number(change, 3))}</td>
                        </tr>
                    }).collect_view()}
                </tbody>
            </table>
            </div>
        </div>
    }
}
