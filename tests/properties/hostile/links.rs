//! Links to a design: they arrive as sent, and a link changed in transit says so.

use super::edits::{after, edits};
use super::samples::cases;
use super::{Tally, hold};
use msape::Case;
use msape::case::{Value, Version};
use msape_app::link::{fragment, read};
use msape_app::presets::{Start, starts};
use proptest::prelude::*;
use proptest::sample::Index;

/// A case as the page holds it, of the current version, from a changed file; keys that are not inputs are left out, as
/// in links.
fn case_of(text: &str) -> Option<Case> {
    let mut case = Case::from_text(text).ok()?;
    let known = |key: &str| msape::quantity::input::find(key).is_some();
    // on the page a table without rows does not exist
    let is_empty = |value: &Value| matches!(value, Value::Rows(rows) if rows.is_empty());
    case.values
        .retain(|key, value| known(key) && !is_empty(value));
    case.version = Version::CURRENT;
    // as if typed: the value is the number or word that it stands for, or nothing if it is empty
    for (key, value) in case.values.clone() {
        if let Value::Text(text) | Value::Other(text) = value {
            case.set(&key, &text);
        }
    }
    Some(case)
}

/// Equality as text, in which NaN equals itself, or as numbers, in which 0 equals −0.
fn is_same(a: &Case, b: &Case) -> bool {
    a == b || format!("{a:?}") == format!("{b:?}")
}

fn arrives(case: &Case, starts: &[Start], tally: &Tally) -> Result<String, TestCaseError> {
    let link = fragment(case, starts);
    let linked = read(&link, starts);
    prop_assert!(linked.is_some(), "{}", link);
    let linked = linked.unwrap_or_default();
    prop_assert!(linked.words.is_empty(), "{:?}\n{}", linked.words, link);
    let got = linked.case.map(|brought| brought.case);
    let same = got.as_ref().is_some_and(|got| is_same(got, case));
    prop_assert!(same, "{got:?}\n{case:?}\n{link}");
    tally.one("arrived");
    Ok(link)
}

#[test]
fn links_as_sent_and_changed_on_their_way() {
    let (cases, starts) = (cases(), starts());
    let drawn = (any::<Index>(), any::<Index>(), edits(), edits());
    hold(
        "links",
        1_500,
        &drawn,
        |(one, other, of_case, of_link), tally| {
            let file = |index: &Index| cases[index.index(cases.len())].as_bytes();
            let bytes = after(file(one), of_case, file(other));
            let Some(case) = case_of(&String::from_utf8_lossy(&bytes)) else {
                return Ok(());
            };
            let link = arrives(&case, &starts, tally)?;
            let changed = after(link.as_bytes(), of_link, file(other));
            let changed = String::from_utf8_lossy(&changed);
            let Some(linked) = read(&changed, &starts) else {
                tally.one("no link any more");
                return Ok(());
            };
            let same = linked
                .case
                .is_some_and(|brought| is_same(&brought.case, &case));
            let has_sum = changed.contains("?k=");
            prop_assert!(
                same || !linked.words.is_empty() || !has_sum,
                "changed without a word:\n{}\n{}",
                link,
                changed
            );
            tally.one(if same { "the same" } else { "told" });
            Ok(())
        },
    );
}
