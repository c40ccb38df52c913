//! Reading and writing of text.

use crate::config;
use msape::Case;
use msape::case::Value;
use msape::quantity::input::{Input, Kind, canonical_key, find};
use msape::quantity::inputs;
use msape::units::{UNITS, parse_number};
use proptest::prelude::*;
use proptest::sample::select;

fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        any::<f64>().prop_filter("finite", |x| x.is_finite()),
        -1e6..1e6_f64,
        (-1000..1000_i32).prop_map(f64::from),
    ]
}

/// A value of the kind that a key takes, not necessarily allowed.
fn value(input: &'static Input) -> BoxedStrategy<(String, Value)> {
    let value = match input.kind {
        Kind::Number { .. } => prop_oneof![
            number().prop_map(Value::Number),
            any::<String>().prop_map(Value::Text),
        ]
        .boxed(),
        Kind::Choice(_) | Kind::Text => any::<String>().prop_map(Value::Text).boxed(),
        Kind::Flag => any::<bool>().prop_map(Value::Flag).boxed(),
        Kind::Rows(_) => {
            let row = prop::collection::vec(number(), 0..5);
            prop::collection::vec(row, 0..5)
                .prop_map(Value::Rows)
                .boxed()
        }
    };
    // a key for every phase or layer becomes one of the second
    let key = canonical_key(input.key).replace(".1.", ".2.");
    value.prop_map(move |value| (key.clone(), value)).boxed()
}

/// A key that no input has: anything, or an existing key extended or shortened.
fn odd_key() -> impl Strategy<Value = String> {
    let known = || select(inputs().map(|input| input.key).collect::<Vec<_>>());
    let part = || prop_oneof![any::<String>(), "[a-z_.\"# -]{0,6}"];
    prop_oneof![
        any::<String>(),
        "[a-c.]{0,5}",
        (known(), part()).prop_map(|(key, part)| format!("{key}.{part}")),
        (known(), part()).prop_map(|(key, part)| format!("{key}{part}")),
        known().prop_map(|key| key.split('.').next().unwrap_or_default().to_string()),
    ]
    .prop_filter("known, or a name of the file itself", |key| {
        find(key).is_none() && !["schema", "version", "name"].contains(&key.as_str())
    })
}

fn odd_value() -> impl Strategy<Value = Value> {
    let spelled = select(vec![
        "[1.0, 'a']",
        "[]",
        "{}",
        "1979-05-27",
        "[[1.0], {a = 2.0}]",
    ]);
    prop_oneof![
        number().prop_map(Value::Number),
        any::<String>().prop_map(Value::Text),
        any::<bool>().prop_map(Value::Flag),
        spelled.prop_map(|spelling| Value::Other(spelling.to_string())),
    ]
}

fn any_case() -> impl Strategy<Value = Case> {
    let given = select(inputs().collect::<Vec<_>>()).prop_flat_map(value);
    let odd = (odd_key(), odd_value());
    (
        any::<String>(),
        prop::collection::vec(given, 0..20),
        prop::collection::vec(odd, 0..4),
    )
        .prop_map(|(name, given, odd)| Case {
            name,
            values: given.into_iter().chain(odd).collect(),
            ..Case::default()
        })
}

/// The case with unknown values spelled as the reader spells them.
fn spelled(mut case: Case) -> Case {
    // the reader converts lists and tables of this name to phases, with numbered keys
    let phases =
        |value: &Value| matches!(value, Value::Other(text) if text.starts_with(['[', '{']));
    case.values
        .retain(|key, value| key != "phase" || !phases(value));
    for value in case.values.values_mut() {
        if let Value::Other(text) = value {
            let alone = format!("schema = 'msape/1'\nx = {text}\n");
            *value = Case::from_toml(&alone).unwrap().values["x"].clone();
        }
    }
    case
}

proptest! {
    #![proptest_config(config(500))]

    #[test]
    fn a_case_reads_back_from_toml_and_json(case in any_case()) {
        let case = spelled(case);
        prop_assert_eq!(&Case::from_text(&case.to_toml()).unwrap(), &case);
        // JSON has no dates
        let dated = |value: &Value| matches!(value, Value::Other(text) if text.starts_with("19"));
        if !case.values.values().any(dated) {
            prop_assert_eq!(&Case::from_text(&case.to_json()).unwrap(), &case);
        }
    }

    #[test]
    fn a_number_keeps_its_value_through_a_unit(unit in select(UNITS), x in -1e9..1e9_f64) {
        let back = unit.from_canonical(unit.to_canonical(x));
        // two roundings of the product; with an offset, also of the sum
        let allowed = 4.0 * f64::EPSILON * (x.abs() + (unit.offset / unit.factor).abs());
        prop_assert!((back - x).abs() <= allowed, "{} {}: {}", x, unit.symbol, back);
    }

    #[test]
    fn a_number_typed_with_its_unit_is_converted(unit in select(UNITS), x in number()) {
        prop_assume!(unit.to_canonical(x).is_finite());
        let typed = format!("{x} {}", unit.symbol);
        let read = parse_number(&typed, unit.dimension, &unit);
        prop_assert_eq!(read, Ok(unit.to_canonical(x)), "{}", typed);
    }
}
