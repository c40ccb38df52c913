//! Card of the vehicle: one file per tab.

use crate::components::cad::CadMenu;
use crate::components::drawing::Drawing;
use crate::components::landing::LandingTab;
use crate::components::mass_tree::MassTree;
use crate::components::structure::StructureTab;
use crate::components::view3d::View3d;
use crate::state::{Phase, Solved, State};
use cad::export::Model;
use leptos::prelude::*;
use msape::vehicle::{ComponentKind, Vehicle};
use msape_kit::display::UnitSystem;
use msape_kit::tabs::{Tab, Tabs};
use std::sync::Arc;

/// Tabs in order.
const TABS: &[Tab] = &[
    Tab {
        id: "section",
        label: "Section",
        view: || view! { <Drawing /> }.into_any(),
    },
    Tab {
        id: "view-3d",
        label: "3-D",
        view: || view! { <View3d /> }.into_any(),
    },
    Tab {
        id: "mass-tree",
        label: "Mass tree",
        view: || view! { <MassTree /> }.into_any(),
    },
    Tab {
        id: "structure",
        label: "Structure",
        view: || view! { <StructureTab /> }.into_any(),
    },
    Tab {
        id: "landing",
        label: "Landing",
        view: || view! { <LandingTab /> }.into_any(),
    },
];

/// State shared by the tabs: the vehicle, and which of its components are hidden, highlighted, selected.
#[derive(Clone, Copy)]
pub struct VehicleView {
    /// Newest answer with a vehicle: it stays displayed when a later design does not close.
    pub solved: Memo<Option<Arc<Solved>>>,
    /// Vehicle of that answer.
    pub vehicle: Memo<Option<Vehicle>>,
    /// Whether it belongs to the newest answer.
    pub is_present: Memo<bool>,
    /// Displayed units.
    pub units: Memo<UnitSystem>,
    /// Components that are hidden.
    pub hidden: RwSignal<Vec<ComponentKind>>,
    /// The component under the pointer.
    pub lit: RwSignal<Option<ComponentKind>>,
    /// Component whose detail is open.
    pub chosen: RwSignal<Option<ComponentKind>>,
}

impl VehicleView {
    fn new(state: State) -> VehicleView {
        let solved = Memo::new(move |before: Option<&Option<Arc<Solved>>>| {
            let newest = state.latest.get();
            newest
                .filter(|solved| solved.answer.design.is_some())
                .or_else(|| before.cloned().flatten())
        });
        let vehicle = Memo::new(move |_| {
            solved.with(|solved| Some(solved.as_ref()?.answer.design.as_ref()?.vehicle.clone()))
        });
        let is_present = Memo::new(move |_| {
            let newest = state.latest.with(|latest| latest.as_ref().map(|s| s.id));
            newest.is_none() || newest == solved.with(|solved| solved.as_ref().map(|s| s.id))
        });
        VehicleView {
            solved,
            vehicle,
            is_present,
            units: Memo::new(move |_| state.document.with(|document| document.units)),
            hidden: RwSignal::new(Vec::new()),
            lit: RwSignal::new(None),
            chosen: RwSignal::new(None),
        }
    }

    /// Part of the displayed answer.
    pub fn of_answer<T>(
        self,
        get: impl Fn(&Solved) -> Option<T> + Send + Sync + 'static,
    ) -> Memo<Option<T>>
    where
        T: PartialEq + Send + Sync + 'static,
    {
        Memo::new(move |_| self.solved.with(|solved| get(solved.as_ref()?)))
    }

    /// View provided by an ancestor of this component.
    pub fn expect() -> VehicleView {
        expect_context::<VehicleView>()
    }

    /// Whether a component is shown.
    pub fn shows(self, kind: ComponentKind) -> bool {
        self.hidden.with(|hidden| !hidden.contains(&kind))
    }

    /// Opens or closes the detail of a component.
    pub fn choose(self, kind: ComponentKind) {
        self.chosen.update(|chosen| {
            *chosen = (*chosen != Some(kind)).then_some(kind);
        });
    }
}

/// The card.
#[component]
pub fn VehicleCard() -> impl IntoView {
    let state = State::expect();
    let view = VehicleView::new(state);
    provide_context(view);
    let stale = move || state.phase.get() != Phase::Fresh;
    let model = Signal::derive(move || {
        view.solved.with(|solved| {
            let solved = solved.as_ref()?;
            let design = solved.answer.design.as_ref()?;
            Some(Model::of_vehicle(&solved.case.name, &design.vehicle))
        })
    });
    let has_vehicle = move || view.vehicle.with(Option::is_some);
    view! {
        <section class="card panel-vehicle" aria-labelledby="vehicle-title">
            <header>
                <h2 id="vehicle-title">"Vehicle"</h2>
                <CadMenu model />
            </header>
            <Show when=has_vehicle fallback=|| view! { <p class="quiet">"There is no vehicle to draw yet."</p> }>
                <p class="reason" role="status" hidden=move || view.is_present.get()>
                    {move || not_closed(state)}
                </p>
                <div class:stale-figure=stale class:old=move || !view.is_present.get()>
                    <Tabs name="Views of the vehicle" tabs=TABS now=state.preferences.vehicle_tab />
                </div>
            </Show>
        </section>
    }
}

/// Reason why the newest answer has no vehicle.
fn not_closed(state: State) -> String {
    let reason = state.latest.with(|latest| {
        latest
            .as_ref()
            .and_then(|solved| solved.answer.reason.clone())
    });
    format!(
        "This is the last vehicle that closed. {}",
        reason.unwrap_or_else(|| "There is none for the present inputs.".to_string())
    )
}
