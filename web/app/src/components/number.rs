//! Number of the case as a text field with unit and, where it has a usual range, a slider.

use crate::components::field::{Field, control_id, described_by};
use crate::state::State;
use crate::state::document::Document;
use leptos::prelude::*;
use msape::case::Value;
use msape::quantity::input::Input;
use msape::units::{Unit, canonical};
use msape_kit::display::{input_number, symbol};
use msape_kit::number::{NumberInput, canonical_number};

/// Field for a number.
#[component]
pub fn NumberField(input: &'static Input) -> impl IntoView {
    let state = State::expect();
    let unit = Memo::new(move |_| state.document.with(|document| shown_unit(input, document)));
    let value = Memo::new(move |_| state.case.with(|case| case.values.get(input.key).cloned()));
    let tag = format!("number {}", input.key);
    let put = move |value: Option<Value>| {
        state.edit(input.label, Some(&tag), |document| {
            document.with_case(|case| {
                match value {
                    Some(value) => case.values.insert(input.key.to_string(), value),
                    None => case.values.remove(input.key),
                };
            })
        });
    };
    let in_unit = move |unit: &'static Unit| {
        state.edit(&format!("Unit of {}", input.label), None, |document| {
            document.with_unit_of(input.key, unit.symbol)
        });
    };
    let caption = move || {
        let symbol = symbol(unit.get());
        if symbol.is_empty() {
            input.label.to_string()
        } else {
            // the report writes its units in ASCII
            format!("{} ({})", input.label, unit.get().symbol)
        }
    };
    let echo = move || {
        let symbol = canonical(input.dimension()).symbol;
        let number = value.with(|value| canonical_number(input, value.as_ref()))?;
        let text = format!("{} {symbol}", input_number(number));
        Some(text.trim_end().to_string())
    };
    let check = state.check(input.key);
    let invalid = Signal::derive(move || check.with(|check| !check.faults.is_empty()));
    view! {
        <Field input caption=Signal::derive(caption) echo=Signal::derive(echo)>
            <NumberInput input value unit turn=state.turns invalid id=control_id(input.key) described_by=described_by(input.key)
                on_edit=put on_settle=move |()| state.close_step() on_unit=in_unit />
        </Field>
    }
}

/// Unit in which a document displays an input.
fn shown_unit(input: &'static Input, document: &Document) -> &'static Unit {
    document
        .unit_of
        .get(input.key)
        .and_then(|symbol| Unit::find(symbol))
        .filter(|unit| unit.dimension == input.dimension())
        .unwrap_or_else(|| document.units.of_input(input))
}
