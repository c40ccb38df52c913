//! The words of a fault: ranges, values and names as a person reads them.

use super::Value;
use super::node::described;
use crate::quantity::input::{self, Input, Kind, Range, inputs};
use crate::units::{SHOWN_MAX, canonical, cut, told};

pub(super) fn column_names(input: &Input) -> String {
    match input.kind {
        Kind::Rows(columns) => columns
            .iter()
            .map(|column| {
                if column.required {
                    column.name.to_string()
                } else {
                    format!("[{}]", column.name)
                }
            })
            .collect::<Vec<_>>()
            .join(", "),
        _ => String::new(),
    }
}

pub(super) fn with_unit(value: f64, unit: &str) -> String {
    format!("{} {unit}", told(value)).trim_end().to_string()
}

pub(super) fn must_be(range: &Range, unit: &str) -> String {
    let max_matters = range.max < 1e9;
    match (range.min_included, max_matters) {
        (true, _) => format!("must be {} to {}", range.min, with_unit(range.max, unit)),
        (false, true) => {
            format!(
                "must be above {} and at most {}",
                with_unit(range.min, unit),
                with_unit(range.max, unit)
            )
        }
        (false, false) => format!("must be above {}", with_unit(range.min, unit)),
    }
}

pub(super) fn shown(value: &Value, rows_expected: bool) -> String {
    match value {
        Value::Number(number) => number.to_string(),
        Value::Text(text) => format!("\"{}\"", cut(text)),
        Value::Flag(flag) => flag.to_string(),
        Value::Rows(_) => "rows of numbers".to_string(),
        Value::Other(spelling) => described(spelling, rows_expected),
    }
}

pub(super) fn squeezed(name: &str) -> String {
    name.chars()
        .filter(|c| c.is_alphanumeric())
        .flat_map(char::to_lowercase)
        .collect()
}

pub(super) fn unknown_key(key: &str) -> String {
    let section = key.rsplit_once('.').map_or("", |(section, _)| section);
    let of_section = |input: &&Input| {
        input
            .key
            .rsplit_once('.')
            .map_or("", |(section, _)| section)
            == section
    };
    let near = nearest(key, inputs().filter(of_section).map(|input| input.key))
        .or_else(|| nearest(key, inputs().map(|input| input.key)));
    match near.and_then(input::find) {
        Some(input) => {
            let unit = canonical(input.dimension()).symbol;
            let unit = if unit.is_empty() {
                String::new()
            } else {
                format!(", in {unit}")
            };
            format!("unknown key; the nearest known key is {}{unit}", input.key)
        }
        None => "unknown key".to_string(),
    }
}

/// Name with the smallest edit distance, if that is below half of its length; none for a text that is too long.
pub(super) fn nearest<'n>(wanted: &str, names: impl Iterator<Item = &'n str>) -> Option<&'n str> {
    if wanted.len() > SHOWN_MAX {
        return None;
    }
    names
        .map(|name| {
            (
                strsim::damerau_levenshtein(&wanted.to_lowercase(), &name.to_lowercase()),
                name,
            )
        })
        .filter(|(distance, name)| *distance * 2 <= name.len().max(wanted.len()))
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, name)| name)
}
