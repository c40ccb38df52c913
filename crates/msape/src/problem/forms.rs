//! Inputs of forms that several parts of a case have: a fixed choice, one row of numbers, the rule beyond the ends of a table.

use super::Reader;
use crate::aero::table::Extrapolation;
use crate::quantity::input::{self, Choices, Kind};

/// The numbers of an input of one row; `Some(None)` when it is absent, `None` when it is at fault.
pub(super) fn one_row<const N: usize>(reader: &mut Reader, key: &str) -> Option<Option<[f64; N]>> {
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
        reader.fault(key, message);
    }
    row.map(Some)
}

/// One of the fixed choices of an input.
pub(super) fn choice(reader: &mut Reader, key: &str) -> Option<&'static str> {
    let Some(Kind::Choice(Choices::Fixed(fixed))) = input::find(key).map(|input| input.kind) else {
        return None;
    };
    let names: Vec<&'static str> = fixed.iter().map(|(name, _)| *name).collect();
    reader.choice(key, &names)
}

/// The rule of a key beyond the ends of a table.
pub(super) fn beyond(reader: &mut Reader, key: &str) -> Extrapolation {
    match choice(reader, key) {
        Some("extend") => Extrapolation::Extend,
        Some("refuse") => Extrapolation::Refuse,
        _ => Extrapolation::Hold,
    }
}

/// What holds beyond the ends of the tables of coefficients.
pub(super) fn extrapolation(reader: &mut Reader) -> Extrapolation {
    beyond(reader, "vehicle.aerodynamics.extrapolation")
}
