//! Aerodynamics of a body: choice of the database, conditions, and resulting curves.

pub mod figures;
pub mod form;
pub mod import;
pub mod plots;
pub mod sources;
pub mod trim;
pub mod usage;

use crate::components::outline::{Entry, entries};
use crate::state::State;
use crate::state::asker::Asker;
use leptos::prelude::*;
use msape::Case;
use msape::case::Value;
use msape::quantity::input::{self, Input, OWN_OUTLINE, Preset};
use msape_kit::display::input_number;
use msape_worker::protocol::Fault;
use msape_worker::questions::curves::{AskCurves, CURVES_MAX, Curves, Family, Places};
use std::sync::Arc;
use wasm_bindgen_futures::spawn_local;

/// Identifier of the vehicle of the current design.
pub const DESIGN: &str = "design";
/// Key of a user's table in a case.
pub const TABLE: &Input = &input::vehicle::AERODYNAMICS_TABLE;

/// Entry in the list of bodies.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// Identifier in links.
    pub id: String,
    /// Displayed name.
    pub title: String,
    /// Outline; `None` for the design.
    pub outline: Option<Entry>,
    /// Named axial force preset for the body.
    pub axial_force: Option<String>,
}

/// Name of the built-in database, of its shape and of its axial force.
const BUILT_IN: &str = "mmeev-60";

/// All bodies: built-in database, current design, outlines of the library.
pub fn bodies(state: State) -> Vec<Body> {
    let is_built_in = |entry: &Entry| entry.id() == BUILT_IN;
    let (built_in, outlines): (Vec<Entry>, Vec<Entry>) =
        entries(state).into_iter().partition(is_built_in);
    let named = state.case.with(|case| axial_force_of_design(case));
    let mut bodies = vec![
        Body {
            id: BUILT_IN.to_string(),
            title: "MMEEV, 60 deg (built-in database)".to_string(),
            outline: built_in.into_iter().next(),
            axial_force: Some(BUILT_IN.to_string()),
        },
        Body {
            id: DESIGN.to_string(),
            title: "Present design".to_string(),
            outline: None,
            axial_force: named,
        },
    ];
    bodies.extend(outlines.into_iter().map(|entry| Body {
        id: entry.id(),
        title: entry.title(),
        outline: Some(entry),
        axial_force: None,
    }));
    bodies
}

/// Axial force that a design names or takes by default; `None` where it is computed from the design's outline.
fn axial_force_of_design(case: &Case) -> Option<String> {
    let input = &input::design::AERODYNAMICS;
    let named = case.text(input.key).or(match input.preset {
        Preset::Name(name) => Some(name.to_string()),
        _ => None,
    });
    named.filter(|name| name != OWN_OUTLINE)
}

/// Text of the fields for conditions.
#[derive(Clone, Debug, PartialEq)]
pub struct PlacesText {
    /// Mach numbers.
    pub mach: String,
    /// Knudsen numbers.
    pub knudsen: String,
    /// Angles of attack, deg.
    pub alpha_deg: String,
    /// Center of gravity in diameters; empty for the body's own.
    pub cg: String,
    /// Parameter of the curves over the angle of attack.
    pub family: Family,
}

impl Default for PlacesText {
    fn default() -> PlacesText {
        PlacesText {
            mach: "20, 3, 1, 0.3".to_string(),
            knudsen: "0, 0.01, 0.1, 1, 100".to_string(),
            alpha_deg: "0, 10, 30".to_string(),
            cg: String::new(),
            family: Family::Mach,
        }
    }
}

/// Numbers of a list such as `20, 5; 0.3`, each within a range; at most as many as a figure has curves.
pub fn numbers(text: &str, low: f64, high: f64) -> Result<Vec<f64>, String> {
    let parts = text.split([',', ';', ' ']).filter(|part| !part.is_empty());
    let mut numbers = Vec::new();
    for part in parts {
        match part.parse::<f64>() {
            Ok(number) if (low..=high).contains(&number) => numbers.push(number),
            _ => return Err(format!("got {part}, must be numbers from {low} to {high}")),
        }
    }
    match numbers.len() {
        0 => Err("must be one number or more, such as 20, 3, 0.3".to_string()),
        n if n > CURVES_MAX => Err(format!("got {n} numbers, must be at most {CURVES_MAX}")),
        _ => Ok(numbers),
    }
}

impl PlacesText {
    /// Faults of the four fields.
    pub fn faults(&self) -> [Option<String>; 4] {
        let cg = match self.cg.trim() {
            "" => None,
            text => numbers(text, -1.0, 2.0)
                .and_then(|cg| match cg.len() {
                    1 => Ok(()),
                    n => Err(format!("got {n} numbers, must be one")),
                })
                .err(),
        };
        [
            numbers(&self.mach, 0.0, 100.0).err(),
            numbers(&self.knudsen, 0.0, 1e6).err(),
            numbers(&self.alpha_deg, 0.0, 180.0).err(),
            cg,
        ]
    }

    /// The places; `None` when a field is at fault.
    pub fn places(&self) -> Option<Places> {
        if self.faults().iter().any(Option::is_some) {
            return None;
        }
        Some(Places {
            mach: numbers(&self.mach, 0.0, 100.0).ok()?,
            knudsen: numbers(&self.knudsen, 0.0, 1e6).ok()?,
            alpha_deg: numbers(&self.alpha_deg, 0.0, 180.0).ok()?,
            family: self.family,
            cg_over_diameter: self.cg.trim().parse().ok(),
        })
    }
}

/// State shared by the parts of the page.
#[derive(Clone, Copy)]
pub struct AeroView {
    /// Identifier of the body.
    pub chosen: RwSignal<String>,
    /// The body.
    pub body: Memo<Option<Body>>,
    /// Inputs of the database, as in a case.
    pub fields: RwSignal<Case>,
    /// Name of the user's table that replaces computed coefficients.
    pub table: RwSignal<Option<String>>,
    /// Text of the fields for conditions.
    pub typed: RwSignal<PlacesText>,
    /// Complete case.
    pub case: Memo<Option<Case>>,
    /// The newest curves.
    pub curves: RwSignal<Option<Arc<Curves>>>,
    /// Faults of the newest question.
    pub faults: RwSignal<Vec<Fault>>,
}

impl AeroView {
    /// View of a body; the question follows the choices and the fields.
    pub fn new(state: State, chosen: String) -> AeroView {
        let chosen = RwSignal::new(chosen);
        let list = Memo::new(move |_| bodies(state));
        let body = Memo::new(move |_| {
            let id = chosen.get();
            list.with(|list| {
                let named = list.iter().find(|body| body.id == id);
                named.or_else(|| list.first()).cloned()
            })
        });
        let fields = RwSignal::new(Case::default());
        let table = RwSignal::new(None::<String>);
        // a new body starts with its own axial force
        Effect::new(move |before: Option<Option<String>>| {
            let (id, force) = body.with(|body| {
                let body = body.as_ref();
                let force = body.and_then(|body| body.axial_force.clone());
                (body.map(|body| body.id.clone()), force)
            });
            if before.as_ref() != Some(&id) {
                fields.update(|fields| {
                    fields.set(
                        input::vehicle::AERODYNAMICS.key,
                        force.as_deref().unwrap_or_default(),
                    );
                });
            }
            id
        });
        let case = Memo::new(move |_| {
            let rows = table.get().and_then(|name| {
                state
                    .document
                    .with(|document| document.tables.get(&name).cloned())
            });
            let mut case = fields.get();
            body.with(|body| match &body.as_ref()?.outline {
                Some(entry) => {
                    case.name = entry.title();
                    entry.put(&mut case);
                    Some(())
                }
                None => {
                    let own = state.case.get();
                    case.name.clone_from(&own.name);
                    for (key, value) in &own.values {
                        let kept = case.values.entry(key.clone());
                        kept.or_insert_with(|| value.clone());
                    }
                    Some(())
                }
            })?;
            if let Some(rows) = rows {
                case.values.remove(input::vehicle::AERODYNAMICS.key);
                case.values.insert(TABLE.to_string(), Value::Rows(rows));
            }
            Some(case)
        });
        let view = AeroView {
            chosen,
            body,
            fields,
            table,
            typed: RwSignal::new(PlacesText::default()),
            case,
            curves: RwSignal::new(None),
            faults: RwSignal::new(Vec::new()),
        };
        view.ask_on_change(state);
        view
    }

    /// View provided by an ancestor of this component.
    pub fn expect() -> AeroView {
        expect_context::<AeroView>()
    }

    fn ask_on_change(self, state: State) {
        let asker = Asker::default();
        let places = Memo::new(move |_| self.typed.with(PlacesText::places));
        Effect::new(move |_| {
            let (Some(case), Some(places)) = (self.case.get(), places.get()) else {
                return asker.wants_nothing();
            };
            spawn_local(async move {
                let question = AskCurves { case, places };
                // only the newest answer counts
                match state.ask(asker, question).await {
                    Some(Ok(curves)) => {
                        self.faults.set(Vec::new());
                        self.curves.set(Some(Arc::new(curves)));
                    }
                    Some(Err(faults)) => self.faults.set(faults),
                    None => {}
                }
            });
        });
    }

    /// Center of gravity as text.
    pub fn cg_text(self) -> Option<String> {
        self.curves
            .with(|curves| Some(input_number(curves.as_ref()?.cg_over_diameter?)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_design_has_the_axial_force_that_it_names_or_that_of_its_outline() {
        let mut case = Case::default();
        assert_eq!(axial_force_of_design(&case), None);
        case.set("design.aerodynamics", "sphere-cone-45");
        assert_eq!(
            axial_force_of_design(&case).as_deref(),
            Some("sphere-cone-45")
        );
    }

    #[test]
    fn lists_are_read_and_what_is_no_number_is_named() {
        assert_eq!(numbers("20, 3;0.3", 0.0, 100.0), Ok(vec![20.0, 3.0, 0.3]));
        assert_eq!(
            numbers("20, x", 0.0, 100.0),
            Err("got x, must be numbers from 0 to 100".to_string())
        );
        assert!(numbers(" ", 0.0, 1.0).is_err() && numbers("-1", 0.0, 1.0).is_err());
        assert!(
            numbers("1 2 3 4 5 6 7", 0.0, 10.0)
                .unwrap_err()
                .contains("at most 6")
        );
        let mut typed = PlacesText::default();
        assert!(
            typed
                .places()
                .is_some_and(|places| places.cg_over_diameter.is_none())
        );
        typed.cg = "0.2".to_string();
        assert_eq!(typed.places().unwrap().cg_over_diameter, Some(0.2));
        typed.cg = "0.2 0.3".to_string();
        assert!(typed.places().is_none());
    }
}
