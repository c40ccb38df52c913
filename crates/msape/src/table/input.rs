//! Inputs of a case as cells: what was given, else the default that holds.

use super::Manner;
use crate::case::{Case, Value};
use crate::quantity::input::{Choices, Input, Kind, Level, Preset};
use crate::quantity::{Job, Task};
use crate::units::number::shortest;
use crate::units::{canonical, parse_number};

/// Whether a job asks for an input.
pub(super) fn belongs(input: &Input, job: Job) -> bool {
    match job {
        Job::Fly => input.is_of(Task::PointMass) || input.is_of(Task::RigidBody),
        Job::Design => input.is_of(Task::Design),
    }
}

/// The cell of an input; `None` when it is absent, is a table, or gives way to another input.
pub(super) fn cell(case: &Case, input: &Input, manner: Manner) -> Option<String> {
    match case.values.get(input.key) {
        Some(Value::Number(number)) => Some(number_cell(*number, input, manner)),
        Some(Value::Text(text)) => Some(match parsed(text, input) {
            Some(number) => number_cell(number, input, manner),
            None => name_cell(text, input, manner),
        }),
        Some(Value::Flag(flag)) => Some(flag_cell(*flag, manner)),
        Some(Value::Rows(_) | Value::Other(_)) => None,
        None if replaced(case, input) => None,
        None => match input.preset {
            Preset::Absent => None,
            Preset::Number(number) => Some(number_cell(number, input, manner)),
            Preset::Name(name) => Some(name_cell(name, input, manner)),
            Preset::Flag(flag) => Some(flag_cell(flag, manner)),
        },
    }
}

/// Whether another input that is given takes the place of the default of this one.
fn replaced(case: &Case, input: &Input) -> bool {
    let given = |start: &str| case.values.keys().any(|key| key.starts_with(start));
    input.default_gives_way_to.is_some_and(given)
        || input
            .rivals()
            .any(|rival| case.values.contains_key(rival.key))
}

fn parsed(text: &str, input: &Input) -> Option<f64> {
    let Kind::Number { dimension, .. } = input.kind else {
        return None;
    };
    parse_number(text, dimension, canonical(dimension)).ok()
}

fn number_cell(number: f64, input: &Input, manner: Manner) -> String {
    match manner {
        Manner::Report => shortest(input.shown_unit().from_canonical(number)),
        Manner::Si => shortest(number),
    }
}

fn flag_cell(flag: bool, manner: Manner) -> String {
    let text = match (manner, flag) {
        (Manner::Report, true) => "Yes",
        (Manner::Report, false) => "No",
        (Manner::Si, true) => "true",
        (Manner::Si, false) => "false",
    };
    text.to_string()
}

/// A name; the run page's own nominal inputs are spelled as in the report, `SuttonGraves`, `PICA-AL-5056`.
fn name_cell(name: &str, input: &Input, manner: Manner) -> String {
    if manner == Manner::Si || input.level != Level::Basic {
        return name.to_string();
    }
    match input.kind {
        Kind::Choice(Choices::Fixed(fixed)) => fixed
            .iter()
            .find(|(choice, _)| *choice == name)
            .map_or(name, |(_, label)| label)
            .to_string(),
        Kind::Choice(Choices::ForebodyConcepts | Choices::AftbodyMaterials) => {
            name.to_ascii_uppercase()
        }
        _ => name.to_string(),
    }
}
