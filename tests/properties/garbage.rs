//! Any input gives an answer or a list of faults; nothing panics.

use crate::config;
use msape::quantity::input::{Choices, Kind};
use msape::quantity::{Job, inputs};
use msape::{Answer, Case, InputError, Library, Request, answer};
use msape_tests::shipped;
use proptest::prelude::*;
use proptest::sample::select;
use std::sync::LazyLock;

static LIBRARY: LazyLock<Library> = LazyLock::new(|| Library::builtin().unwrap());

/// Requires an answer that can be written and read, or faults with messages.
fn answered(result: Result<Answer, Vec<InputError>>, job: Job) -> Result<(), TestCaseError> {
    match result {
        Ok(found) => {
            let text = answer::text(&found, job);
            prop_assert!(serde_json::from_str::<serde_json::Value>(&text).is_ok());
        }
        Err(faults) => {
            prop_assert!(!faults.is_empty());
            for fault in faults {
                let text = fault.to_string();
                prop_assert!(!text.is_empty() && text.len() < 2_000, "{}", text);
            }
        }
    }
    Ok(())
}

fn solve(case: &Case) -> Result<(), TestCaseError> {
    answered(msape::fly(case, &LIBRARY, Request::Nothing), Job::Fly)?;
    answered(msape::design(case, &LIBRARY, Request::Nothing), Job::Design)
}

fn read(text: &str) -> Result<(), TestCaseError> {
    match Case::from_text(text) {
        Ok(case) => solve(&case),
        Err(faults) => answered(Err(faults), Job::Fly),
    }
}

/// Numbers of all kinds, as text.
fn any_number() -> impl Strategy<Value = String> {
    prop_oneof![
        any::<f64>().prop_map(|x| format!("{x:?}")),
        (-12.0..12.0_f64).prop_map(|power| format!("{:?}", 10.0_f64.powf(power))),
        (-12.0..12.0_f64).prop_map(|power| format!("{:?}", -(10.0_f64.powf(power)))),
        (-1000..1000_i32).prop_map(|x| x.to_string()),
        select(vec![
            "0", "-0", "nan", "inf", "-inf", "1e308", "5e-324", "90", "-90", "360"
        ])
        .prop_map(str::to_string),
    ]
}

/// Text that people may type into a field.
fn typed(kind: Kind) -> BoxedStrategy<String> {
    let sensible = match kind {
        Kind::Choice(choices) => {
            let names: Vec<String> = match choices {
                Choices::Fixed(fixed) => fixed.iter().map(|(name, _)| name.to_string()).collect(),
                other => LIBRARY
                    .choices(other)
                    .into_iter()
                    .map(|(name, _)| name)
                    .collect(),
            };
            select::<String>(names).boxed()
        }
        Kind::Flag => select(vec!["true", "false"])
            .prop_map(str::to_string)
            .boxed(),
        _ => any_number().boxed(),
    };
    prop_oneof![
        6 => sensible,
        2 => any_number(),
        1 => any::<String>(),
        1 => (any_number(), select(vec!["m", "km/s", "ft", "W/cm^2", "furlong"]))
            .prop_map(|(number, unit)| format!("{number} {unit}")),
        1 => Just(String::new()),
    ]
    .boxed()
}

/// One to four keys of a case with typed values. The three keys that only set how long a run takes stay unchanged.
fn edits() -> impl Strategy<Value = Vec<(&'static str, String)>> {
    let slow = ["solver.step_s", "solver.tolerance", "design.max_iterations"];
    let open: Vec<_> = inputs()
        .filter(|input| !slow.contains(&input.key))
        .collect();
    let edit = select(open)
        .prop_flat_map(|input| typed(input.kind).prop_map(move |text| (input.key, text)));
    prop::collection::vec(edit, 1..5)
}

proptest! {
    #![proptest_config(config(300))]

    #[test]
    fn bytes_without_sense(bytes in prop::collection::vec(any::<u8>(), 0..2_000)) {
        read(&String::from_utf8_lossy(&bytes))?;
    }

    #[test]
    fn text_without_sense_after_a_good_beginning(text in any::<String>()) {
        read(&format!("schema = \"msape/1\"\n{text}"))?;
        read(&format!("{{\"schema\": \"msape/1\", {text}"))?;
    }

    #[test]
    fn a_shipped_case_cut_short_or_with_a_wrong_letter(
        which in any::<prop::sample::Index>(),
        place in any::<prop::sample::Index>(),
        letter in any::<char>(),
    ) {
        let cases = shipped::cases().unwrap();
        let text = cases[which.index(cases.len())].text;
        let letters: Vec<char> = text.chars().collect();
        let place = place.index(letters.len());
        read(&letters[..place].iter().collect::<String>())?;
        let mut wrong = letters;
        wrong[place] = letter;
        read(&wrong.iter().collect::<String>())?;
    }
}

proptest! {
    #![proptest_config(config(400))]

    #[test]
    fn shipped_cases_with_anything_typed_into_their_fields(
        which in any::<prop::sample::Index>(),
        edits in edits(),
    ) {
        let cases = shipped::cases().unwrap();
        let mut case = cases[which.index(cases.len())].case.clone();
        for (key, text) in edits {
            case.set(key, &text);
        }
        solve(&case)?;
    }
}
