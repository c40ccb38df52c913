//! The figures of a database.

use super::AeroView;
use super::figures::{Over, figure};
use super::sources::OriginMarks;
use super::trim::TrimTable;
use crate::components::figure_panel::FigurePanel;
use leptos::prelude::*;
use msape::aero::coefficient::Coefficient;
use msape_plot::Figure;

/// Static coefficients.
const STATIC: [Coefficient; 6] = [
    Coefficient::Ca,
    Coefficient::Cn,
    Coefficient::CmCg,
    Coefficient::CmApex,
    Coefficient::Cd,
    Coefficient::Cl,
];

/// One figure.
#[component]
fn Plot(coefficient: Coefficient, over: Over) -> impl IntoView {
    let view = AeroView::expect();
    let drawn = Memo::new(move |_| {
        view.curves.with(|curves| {
            let curves = curves.as_ref();
            curves
                .map(|curves| figure(curves, coefficient, over))
                .unwrap_or_default()
        })
    });
    let stem = Signal::derive(move || {
        view.curves
            .with(|curves| curves.as_ref().map(|curves| curves.name.clone()))
            .unwrap_or_default()
    });
    // without a center of gravity there is no moment about it
    let has_points = Memo::new(move |_| drawn.with(has_points));
    let is_moment = coefficient == Coefficient::CmCg;
    view! {
        <Show when=move || has_points.get() || !is_moment
            fallback=|| view! {
                <div class="chart-panel empty">
                    <h3>{Coefficient::CmCg.label()}</h3>
                    <p class="quiet">"The center of gravity of this outline is not known. Give it, in diameters aft of the virtual apex, and the moment and its trim points are drawn."</p>
                </div>
            }>
            <FigurePanel title=over.title(coefficient) figure=drawn stem
                note=move || view! { <OriginMarks coefficient over /> } />
        </Show>
    }
}

fn has_points(figure: &Figure) -> bool {
    let mut points = figure.series.iter().flat_map(|series| &series.points);
    points.any(|(_, y)| y.is_finite())
}

/// All figures.
#[component]
pub fn Plots() -> impl IntoView {
    let view = AeroView::expect();
    let old = move || view.faults.with(|faults| !faults.is_empty());
    let card = |id: &'static str,
                title: &'static str,
                coefficients: &'static [Coefficient],
                over: Over| {
        view! {
            <section class="card" aria-labelledby=id>
                <h2 id=id>{title}</h2>
                <div class="charts" class:old=old>
                    {coefficients.iter().map(|coefficient| view! { <Plot coefficient=*coefficient over /> }).collect_view()}
                </div>
                {(over == Over::Alpha).then(|| view! { <TrimTable /> })}
            </section>
        }
    };
    view! {
        {card("over-alpha-title", "Over the angle of attack", &STATIC, Over::Alpha)}
        {card("over-mach-title", "Over the Mach number", &STATIC, Over::Mach)}
        {card("over-knudsen-title", "Over the Knudsen number", &STATIC, Over::Knudsen)}
        <section class="card" aria-labelledby="damping-title">
            <h2 id="damping-title">"Pitch damping"</h2>
            <p class="quiet">{move || view.curves.with(|curves| curves.as_ref().and_then(|curves| curves.placeholder.clone())).map(|note| view! {
                <span class="mark mark-extrapolated">"assumed"</span> " The Viking data of the report's Figure 30 are not public; above Mach 0.5 a placeholder stands in their place. " {note}
            })}</p>
            <div class="charts" class:old=old>
                {[Over::Alpha, Over::Mach, Over::Knudsen].map(|over| view! { <Plot coefficient=Coefficient::Cmq over /> })}
            </div>
        </section>
    }
}
