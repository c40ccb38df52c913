//! Text in, text out.

use crate::config;
use msape::Case;
use msape::case::Value;
use msape::quantity::input::{Input, Kind};
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

/// A value of the kind that a key takes, which need not be allowed.
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
    // A key that stands for that of every phase is one of the second.
    let key = match input.key.strip_prefix("phase.") {
        Some(name) => format!("phase.2.{name}"),
        None => input.key.to_string(),
    };
    value.prop_map(move |value| (key.clone(), value)).boxed()
}

fn any_case() -> impl Strategy<Value = Case> {
    let given = select(inputs().collect::<Vec<_>>()).prop_flat_map(value);
    (any::<String>(), prop::collection::vec(given, 0..20)).prop_map(|(name, given)| Case {
        name,
        values: given.into_iter().collect(),
        ..Case::default()
    })
}

proptest! {
    #![proptest_config(config(500))]

    #[test]
    fn a_case_reads_back_from_toml_and_json(case in any_case()) {
        prop_assert_eq!(&Case::from_text(&case.to_toml()).unwrap(), &case);
        prop_assert_eq!(&Case::from_text(&case.to_json()).unwrap(), &case);
    }

    #[test]
    fn a_number_keeps_its_value_through_a_unit(unit in select(UNITS), x in -1e9..1e9_f64) {
        let back = unit.from_canonical(unit.to_canonical(x));
        // Two roundings of the product; with an offset, of the sum, too.
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
