//! Tabs that share records, and failures of the browser. The browser's own behavior is tested in
//! `tests/e2e/storage.mjs`.

mod closed;
mod unreadable;

use super::ledger::{Ledger, Verdict, place_key};
use super::record::{Change, Found, Key, Sort, Written, read, written};
use super::stock::Stock;
use crate::state::document::{Apart, Document, Place, Run, Why};
use msape::Case;
use std::collections::BTreeMap;
use std::sync::Arc;

/// Simulated database.
#[derive(Default)]
struct Browser {
    records: BTreeMap<Key, Found>,
    /// Number of writes to abort before one succeeds.
    aborts: u32,
}

impl Browser {
    fn write(&mut self, changes: &[Change]) -> Result<Written, String> {
        let clash = |change: &&Change| {
            let expected = change.expected.clone().map(Found::Text);
            self.records.get(&change.key) != expected.as_ref()
        };
        let clashes: Vec<_> = changes.iter().filter(clash).collect();
        if !clashes.is_empty() {
            let found =
                |change: &Change| (change.key.clone(), self.records.get(&change.key).cloned());
            return Ok(Written::Nothing(clashes.into_iter().map(found).collect()));
        }
        if self.aborts > 0 {
            self.aborts -= 1;
            return Err("given up".to_string());
        }
        for Change { key, text, .. } in changes {
            match text {
                Some(text) => self.put(key.clone(), text),
                None => drop(self.records.remove(key)),
            }
        }
        Ok(Written::All)
    }

    fn put(&mut self, key: Key, text: &str) {
        self.records.insert(key, Found::Text(text.to_string()));
    }

    fn stock(&self) -> Stock {
        let mut stock = Stock::take(self.records.clone().into_iter().collect());
        stock.go_on();
        stock
    }
}

/// Simulated tab.
struct Tab {
    ledger: Ledger,
    document: Document,
    verdicts: Vec<Verdict>,
}

impl Tab {
    fn open(browser: &Browser) -> Tab {
        let stock = browser.stock();
        let document = stock.work.map(|work| work.document);
        let items = Document {
            runs: Arc::new(stock.runs),
            outlines: Arc::new(stock.outlines),
            tables: Arc::new(stock.tables),
            ..Document::new(Case::run_page())
        };
        Tab {
            ledger: stock.ledger,
            document: document
                .unwrap_or_else(|| items.clone())
                .with_items_of(&items),
            verdicts: Vec::new(),
        }
    }

    fn set_speed(&mut self, text: &str) {
        self.document = (self.document).with_case(|case| case.set("entry.speed_m_s", text));
    }

    fn import(&mut self, name: &str, radius_m: f64) {
        let rows = vec![vec![0.0, 0.0], vec![1.0, radius_m], vec![1.0, 0.0]];
        self.document =
            (self.document).with_outlines(|outlines| drop(outlines.insert(name.to_string(), rows)));
    }

    fn remove(&mut self, name: &str) {
        self.document = (self.document).with_outlines(|outlines| drop(outlines.remove(name)));
    }

    fn save(&mut self, browser: &mut Browser) -> Result<(), String> {
        for _ in 0..10 {
            let changes = self.ledger.changes(&self.document, 1.0);
            match browser.write(&changes)? {
                Written::All => {
                    self.ledger.committed(&self.document, &changes);
                    assert_eq!(self.ledger.changes(&self.document, 2.0), []);
                    return Ok(());
                }
                Written::Nothing(clashes) => {
                    for (key, found) in clashes {
                        let verdict = self.ledger.resolve(&self.document, &key, found);
                        self.settle(&verdict);
                        self.verdicts.push(verdict);
                    }
                }
            }
        }
        panic!("the tab never gets to an end: {:?}", self.verdicts);
    }

    fn settle(&mut self, verdict: &Verdict) {
        match verdict {
            Verdict::Apart => self.document.place = apart("own", Why::OtherTab, None),
            Verdict::Renamed { key, from, to } => {
                let renamed = self.document.renamed(&self.document, from, to, &key.sort());
                self.document = renamed.unwrap();
            }
            Verdict::Again | Verdict::Stays(_) => {}
        }
    }
}

fn apart(id: &str, why: Why, opened: Option<Arc<Case>>) -> Place {
    let id = id.to_string();
    Place::Apart(Arc::new(Apart { id, why, opened }))
}

fn speed(document: &Document) -> String {
    document.case.text("entry.speed_m_s").unwrap()
}

/// A browser in which one tab has stored 12.5 km/s, and that tab.
fn with_work() -> (Browser, Tab) {
    let mut browser = Browser::default();
    let mut tab = Tab::open(&browser);
    tab.set_speed("12500");
    tab.save(&mut browser).unwrap();
    (browser, tab)
}

#[test]
fn the_second_tab_to_write_is_kept_apart_and_neither_is_lost() {
    let (mut browser, mut a) = with_work();
    let mut b = Tab::open(&browser);
    a.set_speed("13000");
    a.save(&mut browser).unwrap();
    b.set_speed("14000");
    b.save(&mut browser).unwrap();
    assert_eq!(b.verdicts, [Verdict::Apart]);
    a.set_speed("13500");
    a.save(&mut browser).unwrap();
    b.set_speed("14500");
    b.save(&mut browser).unwrap();
    let stock = browser.stock();
    assert_eq!(speed(&stock.work.unwrap().document), "13500");
    assert_eq!(speed(&stock.apart[0].document), "14500");
    assert_eq!(stock.apart[0].why, Why::OtherTab);
}

#[test]
fn two_tabs_that_say_the_same_do_not_part() {
    let mut browser = Browser::default();
    let (mut a, mut b) = (Tab::open(&browser), Tab::open(&browser));
    a.save(&mut browser).unwrap();
    b.save(&mut browser).unwrap();
    assert_eq!(
        (&b.verdicts[..], &b.document.place),
        (&[Verdict::Again][..], &Place::Stored)
    );
    a.set_speed("13000");
    a.save(&mut browser).unwrap();
    b.set_speed("13000");
    b.save(&mut browser).unwrap();
    assert_eq!(b.document.place, Place::Stored);
}

#[test]
fn outlines_tables_and_runs_of_both_tabs_survive() {
    let (mut browser, mut a) = with_work();
    let mut b = Tab::open(&browser);
    a.import("alpha", 1.0);
    a.import("cone", 1.0);
    a.save(&mut browser).unwrap();
    b.import("beta", 2.0);
    b.import("cone", 2.0);
    let run = Run {
        name: "r".to_string(),
        saved_ms: 5.0,
        case: Case::run_page().to_toml(),
        headline: Vec::new(),
        version: None,
    };
    b.document = b
        .document
        .with_runs(|runs| drop(runs.insert("5-0".to_string(), run.clone())));
    b.document = b
        .document
        .with_tables(|tables| drop(tables.insert("t".to_string(), vec![vec![1.0]])));
    b.save(&mut browser).unwrap();
    let stock = browser.stock();
    let radius = |name: &str| stock.outlines[name][1][1];
    assert_eq!(stock.outlines.len(), 4);
    assert_eq!((radius("alpha"), radius("beta")), (1.0, 2.0));
    assert_eq!((radius("cone"), radius("cone (2)")), (1.0, 2.0));
    assert_eq!((stock.runs.len(), stock.tables.len()), (1, 1));
    // the other tab, which has not seen them, continues and removes nothing
    a.set_speed("13000");
    a.save(&mut browser).unwrap();
    assert_eq!(browser.stock().outlines.len(), 4);
}

#[test]
fn what_another_tab_changed_is_not_removed_and_what_it_removed_is_kept_if_it_changed_here() {
    let (mut browser, mut a) = with_work();
    a.import("cone", 1.0);
    a.save(&mut browser).unwrap();
    let mut b = Tab::open(&browser);
    a.import("cone", 3.0);
    a.save(&mut browser).unwrap();
    b.remove("cone");
    b.save(&mut browser).unwrap();
    assert_eq!(b.verdicts, [Verdict::Stays(Key::outline("cone"))]);
    assert_eq!(browser.stock().outlines["cone"][1][1], 3.0);

    let mut c = Tab::open(&browser);
    a.remove("cone");
    a.save(&mut browser).unwrap();
    c.import("cone", 4.0);
    c.save(&mut browser).unwrap();
    assert_eq!(browser.stock().outlines["cone"][1][1], 4.0);
}

#[test]
fn what_was_given_up_is_written_by_the_next_trial() {
    let (mut browser, mut tab) = with_work();
    browser.aborts = 2;
    tab.set_speed("13000");
    tab.import("cone", 1.0);
    assert!(tab.save(&mut browser).is_err());
    assert_eq!(speed(&browser.stock().work.unwrap().document), "12500");
    tab.set_speed("14000");
    assert!(tab.save(&mut browser).is_err());
    tab.save(&mut browser).unwrap();
    let stock = browser.stock();
    assert_eq!(speed(&stock.work.unwrap().document), "14000");
    assert_eq!(stock.outlines.len(), 1);
}

#[test]
fn what_was_cleared_elsewhere_is_written_again_as_far_as_the_tab_has_it() {
    let (mut browser, mut tab) = with_work();
    tab.import("cone", 1.0);
    tab.save(&mut browser).unwrap();
    browser.records.clear();
    tab.set_speed("13000");
    tab.save(&mut browser).unwrap();
    let stock = browser.stock();
    assert_eq!(speed(&stock.work.unwrap().document), "13000");
    assert_eq!(stock.outlines.len(), 1);
    // only the stored work is gone, as when another tab moved it aside
    browser.records.remove(&Key::current());
    tab.set_speed("14000");
    tab.save(&mut browser).unwrap();
    assert_eq!(browser.stock().outlines.len(), 1);
}

#[test]
fn a_link_writes_nothing_until_it_is_changed_and_then_beside_the_work() {
    let (mut browser, mut tab) = with_work();
    let before = browser.records.clone();
    let mut case = Case::run_page();
    case.set("entry.speed_m_s", "16000");
    let case = Arc::new(case);
    tab.document.place = apart("link", Why::Link, Some(case.clone()));
    tab.document.case = case;
    tab.save(&mut browser).unwrap();
    assert_eq!(browser.records, before);
    tab.set_speed("17000");
    tab.save(&mut browser).unwrap();
    let stock = browser.stock();
    assert_eq!(speed(&stock.work.unwrap().document), "12500");
    assert_eq!(speed(&stock.apart[0].document), "17000");
    // it replaces the stored work, so its record is removed in the same transaction
    tab.ledger.dooms(place_key(&tab.document.place));
    tab.document.place = Place::Stored;
    tab.save(&mut browser).unwrap();
    let stock = browser.stock();
    assert_eq!(
        (speed(&stock.work.unwrap().document), stock.apart.len()),
        ("17000".to_string(), 0)
    );
}

#[test]
fn keys_tell_what_they_are() {
    for (key, sort) in [
        (Key::current(), Sort::Current),
        (Key::apart("1"), Sort::Apart("1".to_string())),
        (Key::outline("a b"), Sort::Outline("a b".to_string())),
        (Key::table("current"), Sort::Table("current".to_string())),
        (Key::run("current"), Sort::Run("current".to_string())),
    ] {
        assert_eq!(key.sort(), sort);
    }
    let text: String = read(&Found::Text(written(&"ü\u{0}\u{fffe}"))).unwrap();
    assert_eq!(text, "ü\u{0}\u{fffe}");
}
