//! Texts of cases: nothing panics, a case that was read reads back as written, and answers are consistent.

use super::edits::{after, edits};
use super::samples::cases;
use super::truths::{finite, repeated};
use super::{Tally, hold};
use crate::designs::LIBRARY;
use msape::case::Value;
use msape::problem::{DesignProblem, FlightProblem};
use msape::quantity::Job;
use msape::{Case, InputError, Request};
use proptest::prelude::*;
use proptest::sample::Index;

/// Requires faults with messages, shortened.
fn told(faults: &[InputError]) -> Result<(), TestCaseError> {
    prop_assert!(!faults.is_empty(), "refused without a word");
    for fault in faults {
        let text = fault.to_string();
        prop_assert!(!text.is_empty() && text.len() < 2_000, "{}", text);
    }
    Ok(())
}

/// TOML and JSON give the case back; dates and non-finite numbers, which JSON does not have, from TOML only.
fn reads_back(case: &Case) -> Result<(), TestCaseError> {
    // compared as text, in which NaN equals itself
    let shown = |case: Result<&Case, &Vec<InputError>>| format!("{case:?}");
    let toml = case.to_toml();
    let read = Case::from_text(&toml);
    // unknown values keep their spelling, with the keys of a table in their own or in alphabetical order
    let odd = |value: &Value| matches!(value, Value::Other(_));
    if case.values.values().any(odd) {
        let keys = |case: &Case| case.values.keys().cloned().collect::<Vec<_>>();
        let Ok(read) = read else {
            return Err(TestCaseError::fail(format!("{read:?}\n{toml}")));
        };
        prop_assert_eq!(keys(&read), keys(case), "{}", toml);
        let twice = read.to_toml();
        prop_assert_eq!(shown(Case::from_text(&twice).as_ref()), shown(Ok(&read)));
    } else {
        prop_assert_eq!(shown(read.as_ref()), shown(Ok(case)), "{}", toml);
    }
    let beyond_json = |value: &Value| match value {
        Value::Number(number) => !number.is_finite(),
        Value::Rows(rows) => !rows.iter().flatten().all(|cell| cell.is_finite()),
        Value::Other(_) => true,
        Value::Text(_) | Value::Flag(_) => false,
    };
    if !case.values.values().any(beyond_json) {
        let json = case.to_json();
        let read = Case::from_text(&json);
        prop_assert_eq!(shown(read.as_ref()), shown(Ok(case)), "{}", json);
    }
    Ok(())
}

fn check(text: &str, solved: bool, tally: &Tally) -> Result<(), TestCaseError> {
    let case = match Case::from_text(text) {
        Ok(case) => case,
        Err(faults) => return told(&faults),
    };
    tally.one("read as a case");
    reads_back(&case)?;
    let asked = [
        (Job::Fly, FlightProblem::check(&case, &LIBRARY).err()),
        (Job::Design, DesignProblem::check(&case, &LIBRARY).err()),
    ];
    for (job, faults) in asked {
        if let Some(faults) = faults {
            told(&faults)?;
            continue;
        }
        tally.one("accepted");
        if solved {
            let answer = repeated(&case, job, Request::Nothing)?.unwrap();
            tally.one("answers");
            finite(&answer, job)?;
        }
    }
    Ok(())
}

#[test]
fn changed_texts_of_cases() {
    let cases = cases();
    let drawn = (any::<Index>(), any::<Index>(), edits(), 0..40_u8);
    hold(
        "texts of cases",
        1_500,
        &drawn,
        |(one, other, edits, n), tally| {
            let file = |index: &Index| cases[index.index(cases.len())].as_bytes();
            let bytes = after(file(one), edits, file(other));
            check(&String::from_utf8_lossy(&bytes), *n == 0, tally)
        },
    );
}
