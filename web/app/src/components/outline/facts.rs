//! Dimensions of an outline with their sources, and derived properties.

use super::Entry;
use crate::state::State;
use leptos::prelude::*;
use msape::units::{Dimension, canonical};
use msape::vehicle::body::RigidBody;
use msape_kit::display::{UnitSystem, input_number, number, symbol};

/// Significant digits of properties.
const DIGITS: usize = 5;

fn shown(value: f64, dimension: Dimension, units: UnitSystem) -> String {
    let unit = units.unit(dimension, canonical(dimension));
    let text = number(unit.from_canonical(value), DIGITS);
    format!("{text} {}", symbol(unit))
}

/// A number of a source, with no more digits than the source has.
fn as_given(value: f64, dimension: Dimension, units: UnitSystem) -> String {
    let unit = units.unit(dimension, canonical(dimension));
    let text = input_number(unit.from_canonical(value));
    format!("{text} {}", symbol(unit))
}

/// A key of a data file in words, and the dimension of its value.
fn words(key: &str) -> (String, Option<Dimension>) {
    let (stem, dimension) = match key.rsplit_once('_') {
        Some((stem, "m")) => (stem, Some(Dimension::Length)),
        Some((stem, "deg")) => (stem, None),
        _ => (key, None),
    };
    let mut words = stem.replace('_', " ");
    if let Some(first) = words.get_mut(..1) {
        first.make_ascii_uppercase();
    }
    (words, dimension)
}

/// The tables.
#[component]
pub fn Facts(
    #[prop(into)] entry: Signal<Option<Entry>>,
    #[prop(into)] body: Signal<Option<RigidBody>>,
) -> impl IntoView {
    let state = State::expect();
    let units = move || state.document.with(|document| document.units);
    let given = move || {
        let units = units();
        entry.with(|entry| match entry {
            Some(Entry::Preset(_, data)) => {
                let rows = data.dimension.iter().map(|(key, datum)| {
                    let (words, dimension) = words(key);
                    let value = dimension.map_or_else(
                        || format!("{} deg", input_number(datum.value)),
                        |dimension| as_given(datum.value, dimension, units),
                    );
                    let is_assumed = datum.source == "assumed";
                    view! {
                        <tr>
                            <th scope="row">{words}</th>
                            <td class="value">{value}</td>
                            <td class="words">
                                {if is_assumed {
                                    view! { <span class="mark mark-extrapolated">"assumed"</span> }.into_any()
                                } else {
                                    view! { <code>{datum.source.clone()}</code> }.into_any()
                                }}
                                " " {datum.place.clone()}
                            </td>
                        </tr>
                    }
                });
                view! {
                    <table class="facts">
                        <caption>"Dimensions and their sources"</caption>
                        <tbody>{rows.collect_view()}</tbody>
                    </table>
                    <p class="quiet">{data.note.clone()} " Source of the shape: " <code>{data.source.clone()}</code> ", " {data.place.clone()} "."</p>
                }
                .into_any()
            }
            Some(Entry::Own(..)) => view! { <p class="quiet">"Imported; kept in this browser."</p> }.into_any(),
            None => ().into_any(),
        })
    };
    let computed = move || {
        let units = units();
        body.with(|body| {
            body.as_ref().map(|body| {
                let facts = body.facts();
                let length = |meters: f64| shown(meters, Dimension::Length, units);
                let area = |area: f64| shown(area, Dimension::Area, units);
                let place = |x: Option<f64>, r: Option<f64>| Some(format!("{}, r {}", length(x?), length(r?)));
                let rows = [
                    ("Diameter", Some(length(facts.diameter_m))),
                    ("Length", Some(length(facts.length_m))),
                    ("Nose radius", facts.nose_radius_m.map(length)),
                    ("Shoulder radius", facts.shoulder_radius_m.map(length)),
                    (
                        "Cone half-angle",
                        facts.cone_half_angle_deg.map(|deg| format!("{} deg", number(deg, DIGITS))),
                    ),
                    ("Virtual apex ahead of the nose", facts.virtual_apex_ahead_of_nose_m.map(length)),
                    ("Nose meets cone behind the nose", place(facts.nose_tangent_from_nose_m, facts.nose_tangent_r_m)),
                    (
                        "Cone meets shoulder behind the nose",
                        place(facts.shoulder_tangent_from_nose_m, facts.shoulder_tangent_r_m),
                    ),
                    ("Reference area", Some(area(facts.reference_area_m2))),
                    ("Surface up to the largest diameter", Some(area(facts.forebody_area_m2))),
                    ("Surface", Some(area(facts.wetted_area_m2))),
                    ("Volume", Some(shown(facts.volume_m3, Dimension::Volume, units))),
                    ("Centroid from nose", Some(length(facts.centroid_from_nose_m))),
                ];
                let rows = rows.into_iter().filter_map(|(name, text)| Some((name, text?)));
                view! {
                    <table class="facts">
                        <caption>"What follows from the outline"</caption>
                        <tbody>
                            {rows.map(|(name, text)| view! { <tr><th scope="row">{name}</th><td class="value">{text}</td></tr> }).collect_view()}
                        </tbody>
                    </table>
                    <ul class="quiet">{body.notes.iter().map(|note| view! { <li>{note.clone()}</li> }).collect_view()}</ul>
                }
            })
        })
    };
    view! {
        <div class="facts-pair">
            <div>{given}</div>
            <div>{computed}</div>
        </div>
    }
}

/// Choices of the unit of length for files that do not name it.
pub fn length_units() -> [&'static str; 5] {
    ["m", "cm", "mm", "in", "ft"]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_become_words() {
        assert_eq!(
            words("nose_radius_m"),
            ("Nose radius".to_string(), Some(Dimension::Length))
        );
        assert_eq!(
            words("aft_cone_1_half_angle_deg"),
            ("Aft cone 1 half angle".to_string(), None)
        );
    }

    #[test]
    fn units_of_files_are_known() {
        for symbol in length_units() {
            assert!(cad::outline::unit_of(symbol).is_some());
            assert!(msape::units::Unit::find(symbol).is_some());
        }
    }
}
