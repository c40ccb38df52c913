//! Shipped cases: all quantities, including time histories.

use msape::Library;
use msape_tests::shipped;
use msape_tests::snapshot::{self, RECORDED};

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

#[test]
fn every_shipped_case_gives_the_recorded_bits() {
    let library = Library::builtin().unwrap();
    let cases = shipped::cases().unwrap();
    assert_eq!(
        cases.iter().map(|case| case.name).collect::<Vec<_>>(),
        RECORDED.iter().map(|(name, _)| *name).collect::<Vec<_>>()
    );
    let mut differences = Vec::new();
    for (case, (name, text)) in cases.iter().zip(RECORDED) {
        let recorded = serde_json::from_str(text).unwrap();
        let now = snapshot::take(case, &library).unwrap();
        let lines = snapshot::differences(&recorded, &now);
        differences.extend(lines.into_iter().map(|line| format!("{name}: {line}")));
    }
    assert!(differences.is_empty(), "{}", differences.join("\n"));
}
