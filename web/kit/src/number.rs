//! Number as a text field with unit and, where it has a usual range, a slider.

use crate::display::{input_number, symbol};
use leptos::ev::KeyboardEvent;
use leptos::prelude::*;
use msape::case::Value;
use msape::quantity::input::{Input, Kind, Preset};
use msape::units::{Unit, canonical, parse_number, units_of};

/// Control for a number of a case. Its text is kept while it is edited; `value` holds its meaning.
#[component]
pub fn NumberInput(
    /// Input of which it is the value.
    input: &'static Input,
    /// Value; `None` where it is not given.
    #[prop(into)]
    value: Signal<Option<Value>>,
    /// Unit in which it is shown.
    #[prop(into)]
    unit: Signal<&'static Unit>,
    /// Text that is being typed is dropped when this number changes, as it does with undo.
    #[prop(into)]
    turn: Signal<u32>,
    /// Whether the value has faults.
    #[prop(into)]
    invalid: Signal<bool>,
    /// Identifier of the text field.
    id: String,
    /// Identifiers of the elements that describe it.
    described_by: String,
    /// Gets the value at each edit.
    #[prop(into)]
    on_edit: Callback<Option<Value>>,
    /// Is called when a sequence of edits ends.
    #[prop(into)]
    on_settle: Callback<()>,
    /// Gets the unit when another is chosen.
    #[prop(into)]
    on_unit: Callback<&'static Unit>,
) -> impl IntoView {
    let dimension = input.dimension();
    let usual = match input.kind {
        Kind::Number { usual, .. } => usual,
        _ => None,
    };
    let canonical_value =
        Memo::new(move |_| value.with(|value| canonical_number(input, value.as_ref())));
    // text while the field has the focus; the case holds its meaning
    let draft = RwSignal::new(None::<(u32, String)>);
    let typing = move || {
        draft
            .get()
            .filter(|(at, _)| *at == turn.get())
            .map(|(_, text)| text)
    };
    let at_focus = StoredValue::new(None::<Option<Value>>);
    let text =
        Memo::new(move |_| typing().unwrap_or_else(|| field_text(input, value.get(), unit.get())));
    let put = move |value: Option<Value>| on_edit.run(value);
    let typed = move |text: String| {
        put(meaning(input, &text, unit.get_untracked()));
        draft.set(Some((turn.get_untracked(), text)));
    };
    let settle = move || {
        draft.set(None);
        on_settle.run(());
    };
    let step = move |up: bool, event: &KeyboardEvent| {
        let Some(now) = canonical_value.get_untracked() else {
            return;
        };
        let unit = unit.get_untracked();
        let shown = unit.from_canonical(now);
        let size = step_size(input, shown, unit)
            * if event.shift_key() { 10.0 } else { 1.0 }
            * if event.alt_key() && !whole(input) {
                0.1
            } else {
                1.0
            };
        let next = ((shown / size).round() + if up { 1.0 } else { -1.0 }) * size;
        let Ok(next) = input_number(next).parse::<f64>() else {
            return;
        };
        draft.set(None);
        put(Some(Value::Number(within(input, unit.to_canonical(next)))));
    };
    let on_key = move |event: KeyboardEvent| match event.key().as_str() {
        "ArrowUp" | "ArrowDown" => {
            event.prevent_default();
            step(event.key() == "ArrowUp", &event);
        }
        "Enter" => settle(),
        "Escape" => {
            if let Some(before) = at_focus.get_value() {
                draft.set(None);
                put(before);
            }
        }
        _ => {}
    };
    let slide = move |text: String| {
        if let Ok(shown) = text.parse::<f64>() {
            let shown: f64 = format!("{shown:.3e}").parse().unwrap_or(shown);
            let shown = if whole(input) { shown.round() } else { shown };
            put(Some(Value::Number(within(
                input,
                unit.get_untracked().to_canonical(shown),
            ))));
        }
    };
    let units: Vec<&'static Unit> = units_of(dimension).collect();

    view! {
            <div class="field-controls">
                <div class="entry">
                    <input
                        type="text"
                        inputmode="decimal"
                        autocomplete="off"
                        spellcheck="false"
                        id=id
                        aria-describedby=described_by
                        aria-invalid=move || invalid.get().to_string()
                        placeholder=move || placeholder(input, unit.get())
                        prop:value=text
                        on:focus=move |_| at_focus.set_value(Some(value.get_untracked()))
                        on:input:target=move |event| typed(event.target().value())
                        on:keydown=on_key
                        on:blur=move |_| settle()
                    />
                    {(units.len() > 1 && !symbol(input.shown_unit()).is_empty()).then(|| view! {
                        <select
                            aria-label=format!("Unit of {}", input.label)
                            on:change:target=move |event| {
                                if let Some(unit) = Unit::find(&event.target().value()) {
                                    on_unit.run(unit);
                                }
                            }
                        >
                            {units.into_iter().map(|choice| view! {
                                <option value=choice.symbol selected=move || unit.get().symbol == choice.symbol>
                                    {symbol(choice)}
                                </option>
                            }).collect_view()}
                        </select>
                    })}
                </div>
                {usual.map(|(min, max)| view! {
                    <div class="slide">
                        <input
                            type="range"
                            step="any"
                            aria-label=format!("{}, slider", input.label)
                            aria-valuetext=caption_value(canonical_value, unit)
                            min=move || unit.get().from_canonical(min).to_string()
                            max=move || unit.get().from_canonical(max).to_string()
                            prop:value=move || {
                                let value = canonical_value.get().unwrap_or(min);
                                unit.get().from_canonical(value).to_string()
                            }
                            on:input:target=move |event| slide(event.target().value())
                            on:change=move |_| on_settle.run(())
                        />
                        <span class="range">
                            <span>{move || input_number(short(unit.get().from_canonical(min)))}</span>
                            <span>{move || input_number(short(unit.get().from_canonical(max)))}</span>
                        </span>
                    </div>
                })}
            </div>
    }
}

fn caption_value(
    value: Memo<Option<f64>>,
    unit: Signal<&'static Unit>,
) -> impl Fn() -> String + Send + Sync {
    move || {
        value.get().map_or_else(
            || "not set".to_string(),
            |value| {
                let unit = unit.get();
                format!(
                    "{} {}",
                    input_number(unit.from_canonical(value)),
                    unit.symbol
                )
            },
        )
    }
}

/// Number of a value, in the canonical unit.
pub fn canonical_number(input: &Input, value: Option<&Value>) -> Option<f64> {
    match value {
        Some(Value::Number(number)) => Some(*number),
        Some(Value::Text(text)) => {
            parse_number(text, input.dimension(), canonical(input.dimension())).ok()
        }
        Some(_) => None,
        None => match input.preset {
            Preset::Number(number) => Some(number),
            _ => None,
        },
    }
}

/// Text of the field while it is not being edited.
fn field_text(input: &Input, value: Option<Value>, unit: &Unit) -> String {
    match (canonical_number(input, value.as_ref()), value) {
        (_, None) => String::new(),
        (Some(number), Some(_)) => input_number(unit.from_canonical(number)),
        (None, Some(Value::Text(text) | Value::Other(text))) => text,
        (None, Some(other)) => format!("{other:?}"),
    }
}

/// Meaning of typed text: nothing, a number, or text whose faults are shown.
fn meaning(input: &Input, text: &str, unit: &Unit) -> Option<Value> {
    if text.trim().is_empty() {
        return None;
    }
    Some(match parse_number(text, input.dimension(), unit) {
        Ok(number) => Value::Number(number),
        Err(_) => Value::Text(text.to_string()),
    })
}

fn placeholder(input: &Input, unit: &Unit) -> String {
    match input.preset {
        Preset::Number(number) => input_number(unit.from_canonical(number)),
        _ => "not given".to_string(),
    }
}

fn whole(input: &Input) -> bool {
    matches!(input.kind, Kind::Number { whole: true, .. })
}

/// Step: a hundredth of the usual range, or of the value, rounded down to a power of ten.
fn step_size(input: &Input, shown: f64, unit: &Unit) -> f64 {
    let span = match input.kind {
        Kind::Number {
            usual: Some((min, max)),
            ..
        } => unit.from_canonical(max) - unit.from_canonical(min),
        _ => shown.abs().max(1e-9) * 10.0,
    };
    if whole(input) {
        return 1.0;
    }
    let power = format!("{:e}", span / 50.0);
    power
        .split_once('e')
        .and_then(|(_, exponent)| format!("1e{exponent}").parse().ok())
        .unwrap_or(1.0)
}

/// Nearest allowed value.
fn within(input: &Input, value: f64) -> f64 {
    match input.kind {
        Kind::Number { allowed, .. } if allowed.contains(value) => value,
        Kind::Number { allowed, .. } if value > allowed.max => allowed.max,
        Kind::Number { allowed, .. } if allowed.min_included => allowed.min,
        Kind::Number { .. } => canonical_number(input, None).unwrap_or(value),
        _ => value,
    }
}

fn short(value: f64) -> f64 {
    format!("{value:.2e}").parse().unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::*;
    use msape::quantity::input::find;

    fn input(key: &str) -> &'static Input {
        find(key).unwrap()
    }

    #[test]
    fn text_means_a_number_or_stays_as_typed() {
        let speed = input("entry.speed_m_s");
        let unit = Unit::find("km/s").unwrap();
        assert_eq!(meaning(speed, "11,5", unit), Some(Value::Number(11_500.0)));
        assert_eq!(
            meaning(speed, "fast", unit),
            Some(Value::Text("fast".into()))
        );
        assert_eq!(meaning(speed, " ", unit), None);
    }

    #[test]
    fn steps_are_powers_of_ten() {
        let diameter = input("design.diameter_m");
        let step = |symbol| step_size(diameter, 1.0, Unit::find(symbol).unwrap());
        assert!((step("m") - 0.01).abs() < 1e-12);
        assert!((step("mm") - 10.0).abs() < 1e-9);
    }
}
