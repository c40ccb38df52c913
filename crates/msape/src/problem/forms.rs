//! Inputs of forms that several parts of a case have: one row of numbers, a name of the library, the rule beyond the ends of a table.

use super::Reader;
use crate::aero::table::Extrapolation;
use crate::quantity::input::{Input, Key};

/// The numbers of an input of one row; `Some(None)` when it is absent, `None` when it is at fault.
pub(super) fn one_row<const N: usize>(
    reader: &mut Reader,
    key: impl Into<Key>,
) -> Option<Option<[f64; N]>> {
    let key = key.into();
    if !reader.given(key) {
        return Some(None);
    }
    let rows = reader.rows(key)?;
    let row = match rows.as_slice() {
        [row] => <[f64; N]>::try_from(row.as_slice()).ok(),
        _ => None,
    };
    if row.is_none() {
        let message = format!("got {} rows, must be one row of {N} numbers", rows.len());
        reader.fault(&key, message);
    }
    row.map(Some)
}

/// The rule of an input beyond the ends of a table.
pub(super) fn beyond(reader: &mut Reader, input: &'static Input) -> Extrapolation {
    reader.choice(input).unwrap_or_default()
}

/// Fault that an input is given together with another that it replaces.
pub(super) fn together(reader: &mut Reader, input: impl Into<Key>, other: &'static Input) {
    let message = format!("given together with {other}; give one of them");
    reader.fault(&input.into(), message);
}
