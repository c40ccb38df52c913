//! Structure: walls sized by the rules, and the shell model beside them.

mod checks;
mod figures;
mod shell;
mod walls;

use crate::components::figure_panel::FigurePanel;
use crate::components::notes::Remarks;
use crate::components::vehicle::VehicleView;
use checks::Checks;
use figures::{Along, figure};
use leptos::prelude::*;
use msape::design::structural::Structural;
use msape::shell::analysis::CarrierAnalysis;
use msape::vehicle::WallPlace;
use msape_kit::segments::Segments;
use shell::{Frequencies, PartTable};
use walls::{Basis, WallTable};

/// Models whose findings are shown here.
const MODELS: &[&str] = &["structural rules", "shell model"];

/// State shared by the parts of the tab.
#[derive(Clone, Copy)]
struct StructureView {
    card: VehicleView,
    structural: Memo<Option<Structural>>,
    wall: RwSignal<WallPlace>,
}

impl StructureView {
    fn expect() -> StructureView {
        expect_context::<StructureView>()
    }

    /// Part of the shell model's result.
    fn shell<T>(self, get: impl Fn(&CarrierAnalysis) -> T) -> Option<T> {
        self.structural
            .with(|structural| Some(get(structural.as_ref()?.shell.as_ref()?)))
    }

    /// Axial position of the nose, m.
    fn nose_x_m(self) -> f64 {
        self.card.vehicle.with(|vehicle| {
            vehicle
                .as_ref()
                .map_or(0.0, |vehicle| vehicle.dimensions.virtual_apex_ahead_m)
        })
    }
}

/// A margin of safety with its sign, rounded to its accuracy.
fn margin(value: f64) -> String {
    // a wall sized by a rule has a zero margin, except for rounding
    let value = if value.abs() < 1e-6 { 0.0 } else { value };
    let text = match value.abs() {
        small if small < 10.0 => format!("{value:+.2}"),
        large if large < 1e4 => format!("{value:+.0}"),
        _ => format!("{value:+.0e}"),
    };
    text.replace('-', "\u{2212}")
}

/// The tab.
#[component]
pub fn StructureTab() -> impl IntoView {
    let card = VehicleView::expect();
    let view = StructureView {
        card,
        structural: card.of_answer(|solved| solved.answer.design.as_ref()?.structural.clone()),
        wall: RwSignal::new(WallPlace::Forebody),
    };
    provide_context(view);
    let findings = card.of_answer(|solved| Some(solved.answer.findings.clone()));
    let name = card.of_answer(|solved| Some(solved.case.name.clone()));
    let stem = Signal::derive(move || name.get().unwrap_or_default());
    let has_shell = Memo::new(move |_| view.shell(|_| ()).is_some());
    let drawn = move |what: Along| {
        Memo::new(move |_| {
            let (wall, units) = (view.wall.get(), card.units.get());
            let nose_x_m = view.nose_x_m();
            view.shell(|shell| figure(shell, wall, what, nose_x_m, units))
                .unwrap_or_default()
        })
    };
    let walls = WallPlace::ALL.map(|wall| (wall, wall.label()));
    view! {
        <h3>"Walls"</h3>
        <WallTable />
        <Basis />
        <div class="panel-head">
            <h3>{move || format!("{}: every rule", view.wall.get().label())}</h3>
            <Segments legend="Wall" choices=walls.to_vec() now=view.wall choose=move |wall| view.wall.set(wall) />
        </div>
        <Checks />
        <h3 class="spaced">{move || format!("{}: shell model", view.wall.get().label())}</h3>
        <Show when=move || has_shell.get()
            fallback=|| view! { <p class="quiet">"There is no shell model of this vehicle: a wall has no thickness, or the walls do not meet."</p> }>
            <PartTable />
            <div class="charts">
                {[Along::Stress, Along::Displacement].map(|what| {
                    let title = move || format!("{} of the {}", what.label(), view.wall.get().label().to_lowercase());
                    view! { <FigurePanel title=Signal::derive(title) figure=drawn(what) stem /> }
                })}
            </div>
            <p class="quiet">"Curves run through the Gauss points; the peaks of the table are also sought at the ends of elements, where walls meet. Launch is the largest of all corners, round the circle."</p>
            <h3 class="spaced">"First natural frequencies, held at the foot of the lid"</h3>
            <Frequencies />
        </Show>
        <h3 class="spaced">"Remarks"</h3>
        <Remarks findings models=MODELS />
    }
}

#[cfg(test)]
mod tests {
    use super::margin;

    #[test]
    fn margins_have_a_sign_and_no_more_digits_than_they_are_worth() {
        assert_eq!(margin(-1e-9), "+0.00");
        assert_eq!(margin(-0.254), "\u{2212}0.25");
        assert_eq!(margin(35.4), "+35");
        assert_eq!(margin(123_456.0), "+1e5");
    }
}
