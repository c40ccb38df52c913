//! Notes on the results: adjustments and findings, each with a link to its field.

use crate::components::field::control_id;
use crate::components::form::group_id;
use crate::state::State;
use leptos::prelude::*;
use msape::answer::output;
use msape::finding::{Adjustment, Finding, Severity};
use msape::quantity::input::{self, Level};
use msape::units::canonical;
use msape_kit::display::with_unit;
use wasm_bindgen::JsCast;
use web_sys::HtmlElement;

/// Notes, most severe first.
#[component]
pub fn Notes() -> impl IntoView {
    let state = State::expect();
    let adjustments = state.of_answer(|answer| answer.adjustments.clone());
    let findings = state.of_answer(|answer| answer.findings.clone());
    let faults = Memo::new(move |_| state.faults.get());
    let of = move |severity: Severity| {
        findings
            .get()
            .unwrap_or_default()
            .into_iter()
            .filter(|finding| finding.severity == severity)
            .collect::<Vec<_>>()
    };
    let group = move |severity, title: &'static str, class: &'static str| {
        move || {
            let found = of(severity);
            (!found.is_empty()).then(|| {
                view! {
                    <h3 class=class>{format!("{title} ({})", found.len())}</h3>
                    <ul class="notes">{found.into_iter().map(|finding| view! { <Remark finding class /> }).collect_view()}</ul>
                }
            })
        }
    };
    let nothing = move || {
        let none = |list: Option<usize>| list.unwrap_or(0) == 0;
        none(findings.get().map(|f| f.len()))
            && none(adjustments.get().map(|a| a.len()))
            && faults.with(|f| f.is_empty())
    };
    view! {
        <section class="card" aria-labelledby="notes-title" id="notes">
            <h2 id="notes-title">"Notes"</h2>
            {move || (!faults.get().is_empty()).then(|| view! {
                <h3 class="note-outside">{format!("Input at fault ({})", faults.get().len())}</h3>
                <ul class="notes">
                    {faults.get().iter().map(|fault| {
                        let label = input::find(&fault.key).map_or(fault.key.clone(), |input| input.label.to_string());
                        view! {
                            <li>
                                <p><strong>{label}</strong> ": " {fault.message.clone()}</p>
                                <GoTo key=fault.key.clone() />
                            </li>
                        }
                    }).collect_view()}
                </ul>
            })}
            {group(Severity::Exceeded, "◆ Limits exceeded", "note-outside")}
            {move || adjustments.get().filter(|list| !list.is_empty()).map(|list| view! {
                <h3 class="note-adjusted">{format!("⚑ Adjusted so that the vehicle closes ({})", list.len())}</h3>
                <ul class="notes">{list.into_iter().map(|adjustment| view! { <Adjusted adjustment /> }).collect_view()}</ul>
            })}
            {group(Severity::Extrapolated, "◇ Outside the range of a model", "note-extrapolated")}
            {group(Severity::Note, "Assumptions and remarks", "note-remark")}
            {move || nothing().then(|| view! { <p class="quiet">"Nothing was adjusted, no limit is exceeded, every model is inside its range."</p> })}
        </section>
    }
}

/// Findings of some models, most severe first.
#[component]
pub fn Remarks(
    /// All findings.
    findings: Memo<Option<Vec<Finding>>>,
    /// Models whose findings are shown.
    models: &'static [&'static str],
) -> impl IntoView {
    let class = |severity| match severity {
        Severity::Exceeded => "note-outside",
        Severity::Extrapolated => "note-extrapolated",
        Severity::Note => "note-remark",
    };
    let found = move || {
        let list = findings.get().unwrap_or_default();
        let of = |severity| {
            list.iter()
                .filter(move |f| f.severity == severity && models.contains(&f.model.as_str()))
        };
        [Severity::Exceeded, Severity::Extrapolated, Severity::Note]
            .into_iter()
            .flat_map(of)
            .cloned()
            .map(|finding| {
                let class = class(finding.severity);
                view! { <Remark finding class /> }
            })
            .collect_view()
    };
    view! { <ul class="notes">{found}</ul> }
}

#[component]
fn Remark(finding: Finding, class: &'static str) -> impl IntoView {
    let range = range_text(&finding);
    view! {
        <li class=class>
            <p>{finding.message.clone()}</p>
            <p class="note-source">
                {finding.model.clone()} {range.map(|range| format!(", good {range}"))}
                {(!finding.source.is_empty()).then(|| format!(". {}", finding.source))}
            </p>
            {finding.field.clone().map(|key| view! { <GoTo key /> })}
        </li>
    }
}

#[component]
fn Adjusted(adjustment: Adjustment) -> impl IntoView {
    let label = input::find(&adjustment.key)
        .map_or(adjustment.key.clone(), |input| input.label.to_string());
    let shown = |value| {
        input::find(&adjustment.key).map_or_else(
            || value_text(value),
            |input| with_unit(value, 4, input.shown_unit()),
        )
    };
    view! {
        <li class="note-adjusted">
            <p><strong>{label}</strong> " " {shown(adjustment.from)} " → " {shown(adjustment.to)} ". " {adjustment.reason.clone()}</p>
            <p class="note-source">{adjustment.source.clone()}</p>
            <GoTo key=adjustment.key.clone() />
        </li>
    }
}

fn value_text(value: f64) -> String {
    msape_kit::display::number(value, 4)
}

fn range_text(finding: &Finding) -> Option<String> {
    let unit = output::find(&finding.key)
        .map(|output| output.shown_unit())
        .or_else(|| input::find(&finding.key).map(|input| canonical(input.dimension())));
    let shown =
        |value: f64| unit.map_or_else(|| value_text(value), |unit| with_unit(value, 4, unit));
    match finding.valid {
        (Some(min), Some(max)) => Some(format!("from {} to {}", shown(min), shown(max))),
        (Some(min), None) => Some(format!("from {}", shown(min))),
        (None, Some(max)) => Some(format!("up to {}", shown(max))),
        (None, None) => None,
    }
}

/// Button that goes to the field of an input.
#[component]
pub fn GoTo(
    key: String,
    /// Label of the button, instead of the input's own.
    #[prop(optional)]
    label: Option<&'static str>,
) -> impl IntoView {
    let state = State::expect();
    input::find(&key).map(|input| {
        let go = move |_| {
            if input.level == Level::Expert {
                state.preferences.expert.set(true);
            }
            // the field exists only after the page has been updated
            request_animation_frame(move || show_field(input));
        };
        let words = label.map_or_else(|| format!("Go to {}", input.label), str::to_string);
        let name = label.map(|label| format!("{label} {}", input.label));
        view! { <button type="button" class="small" aria-label=name on:click=go>{words}</button> }
    })
}

fn show_field(input: &'static input::Input) {
    let document = document();
    if let Some(group) = document.get_element_by_id(&group_id(input.group)) {
        // setting an attribute of an existing element cannot fail
        let _ = group.set_attribute("open", "");
    }
    let element = document
        .get_element_by_id(&control_id(input.key))
        .and_then(|element| element.dyn_into::<HtmlElement>().ok());
    if let Some(element) = element {
        element.scroll_into_view_with_bool(false);
        let _ = element.focus();
    }
}
