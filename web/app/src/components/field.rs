//! Frame of an input around its control: label, state, help, reset, faults.

use crate::state::State;
use crate::state::check::Check;
use leptos::prelude::*;
use msape::Outcome;
use msape::quantity::input::{Input, Kind, Preset};
use msape::units::canonical;

/// State of an input, shown as symbol and word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Standing {
    /// At its default.
    Default,
    /// Changed by the user.
    Changed,
    /// Replaced by another value by a closing rule.
    Adjusted,
    /// Outside its usual range.
    Unusual,
    /// Part of a set of inputs that do not fit each other.
    Unfit,
    /// Faulty.
    Fault,
}

impl Standing {
    fn new(check: &Check, adjusted: bool, unfit: bool) -> Standing {
        if !check.faults.is_empty() {
            Standing::Fault
        } else if unfit {
            Standing::Unfit
        } else if adjusted {
            Standing::Adjusted
        } else if !check.remarks.is_empty() {
            Standing::Unusual
        } else if check.changed {
            Standing::Changed
        } else {
            Standing::Default
        }
    }

    fn word(self) -> &'static str {
        match self {
            Standing::Default => "default",
            Standing::Changed => "changed",
            Standing::Adjusted => "adjusted",
            Standing::Unusual => "unusual",
            Standing::Unfit => "does not fit",
            Standing::Fault => "at fault",
        }
    }

    fn class(self) -> &'static str {
        match self {
            Standing::Default => "standing standing-default",
            Standing::Changed => "standing standing-changed",
            Standing::Adjusted => "standing standing-adjusted",
            Standing::Unusual => "standing standing-unusual",
            Standing::Unfit | Standing::Fault => "standing standing-fault",
        }
    }
}

/// Identifier of the control of an input.
pub fn control_id(key: &str) -> String {
    format!("in-{}", key.replace('.', "-"))
}

/// Identifiers of the elements that describe the control.
pub fn described_by(key: &str) -> String {
    let id = control_id(key);
    format!("{id}-fault {id}-state")
}

/// Frame of an input. `caption` is the label with its unit, `children` the control.
#[component]
pub fn Field(
    input: &'static Input,
    #[prop(into)] caption: Signal<String>,
    /// Value in the canonical unit, shown with the help.
    #[prop(into)]
    echo: Signal<Option<String>>,
    children: Children,
) -> impl IntoView {
    let state = State::expect();
    let id = control_id(input.key);
    let check = state.check(input.key);
    let adjustment = state.of_answer(move |answer| {
        let of_key = answer.adjustments.iter().find(|a| a.key == input.key);
        of_key.map(|a| (a.to, a.reason.clone()))
    });
    let unfit = state.of_answer(move |answer| {
        let told = answer.findings.iter().filter(|finding| {
            answer.outcome == Outcome::NotClosed && finding.field.as_deref() == Some(input.key)
        });
        let messages: Vec<String> = told.map(|finding| finding.message.clone()).collect();
        messages.join(" ")
    });
    let unfit = Memo::new(move |_| unfit.get().unwrap_or_default());
    let standing = Memo::new(move |_| {
        let adjusted = adjustment.with(|a| a.as_ref().is_some_and(Option::is_some));
        let unfit = unfit.with(|unfit| !unfit.is_empty());
        check.with(|check| Standing::new(check, adjusted, unfit))
    });
    let remark = move || {
        let used = adjustment.get().flatten().map(|(to, reason)| {
            let unit = canonical(input.dimension());
            format!(
                "Used: {}. {reason}",
                msape_kit::display::with_unit(to, 5, unit)
            )
        });
        used.or_else(|| check.with(|check| check.remarks.first().cloned()))
    };
    let help_open = RwSignal::new(false);
    let help_id = format!("{id}-help");
    let reset = move |_| {
        state.edit(&format!("Reset {}", input.label), None, |document| {
            document.with_case(|case| case.reset(input))
        });
    };
    let can_reset =
        Memo::new(move |_| check.with(|check| check.changed) && input.preset != Preset::Absent);

    view! {
        <div class="field" class:field-fault=move || matches!(standing.get(), Standing::Fault | Standing::Unfit) data-key=input.key>
            <div class="field-head">
                <label for=id.clone()>{caption}</label>
                <span class=move || standing.get().class() id=format!("{id}-state")>
                    {move || standing.get().word()}
                </span>
                <button
                    type="button"
                    class="icon"
                    class:gone=move || !can_reset.get()
                    disabled=move || !can_reset.get()
                    aria-label=format!("Reset {}", input.label)
                    title="Back to the default"
                    on:click=reset
                >
                    "↺"
                </button>
                <button
                    type="button"
                    class="icon"
                    aria-label=format!("Help: {}", input.label)
                    aria-expanded=move || help_open.get().to_string()
                    aria-controls=help_id.clone()
                    on:click=move |_| help_open.update(|open| *open = !*open)
                >
                    "?"
                </button>
            </div>
            {children()}
            <p class="field-remark">{remark}</p>
            <p class="field-error" id=format!("{id}-fault")>
                {move || check.with(|check| check.faults.join(" "))}
                {unfit}
            </p>
            <div class="field-help" id=help_id hidden=move || !help_open.get()>
                <p>{input.help}</p>
                <dl>
                    <dt>"Source"</dt>
                    <dd>{input.source}</dd>
                    <dt>"Default"</dt>
                    <dd>{default_text(input)}</dd>
                    <dt>"In files"</dt>
                    <dd>
                        <code>{input.key}</code>
                        {move || echo.get().map(|echo| format!(" = {echo}"))}
                    </dd>
                    {allowed_text(input).map(|text| view! { <dt>"Allowed"</dt><dd>{text}</dd> })}
                </dl>
            </div>
        </div>
    }
}

fn default_text(input: &Input) -> String {
    match input.preset {
        Preset::Absent => "none".to_string(),
        Preset::Number(value) => {
            let unit = input.shown_unit();
            let number = msape_kit::display::input_number(unit.from_canonical(value));
            format!("{number} {}", unit.symbol).trim_end().to_string()
        }
        Preset::Name(name) => name.to_string(),
        Preset::Flag(flag) => if flag { "Yes" } else { "No" }.to_string(),
    }
}

fn allowed_text(input: &Input) -> Option<String> {
    let Kind::Number {
        allowed, dimension, ..
    } = input.kind
    else {
        return None;
    };
    let unit = canonical(dimension).symbol;
    let from = if allowed.min_included {
        "from"
    } else {
        "above"
    };
    let to = if allowed.max < 1e9 {
        format!(" to {}", msape_kit::display::input_number(allowed.max))
    } else {
        String::new()
    };
    let min = msape_kit::display::input_number(allowed.min);
    Some(format!("{from} {min}{to} {unit}").trim_end().to_string())
}
