//! Unsaved work handed over by a closed page, and its use by the next page.

use super::*;

#[test]
fn a_page_that_closes_hands_over_what_waits_and_the_next_goes_on() {
    let closed = |between: &dyn Fn(&mut Browser)| {
        let (mut browser, mut tab) = with_work();
        tab.set_speed("13000");
        let (id, text) = tab.ledger.last(&tab.document, "last", 3.0).unwrap();
        between(&mut browser);
        browser.put(Key::apart(&id), &text);
        browser
    };
    // nobody has written since: it becomes the stored work
    let mut browser = closed(&|_| {});
    let mut next = Tab::open(&browser);
    assert_eq!(speed(&next.document), "13000");
    next.save(&mut browser).unwrap();
    let stock = browser.stock();
    assert_eq!(
        (speed(&stock.work.unwrap().document), stock.apart.len()),
        ("13000".to_string(), 0)
    );
    // another tab has written since: both are kept
    let browser = closed(&|browser| {
        let mut other = Tab::open(browser);
        other.set_speed("15000");
        other.save(browser).unwrap();
    });
    let stock = browser.stock();
    assert_eq!(speed(&stock.work.unwrap().document), "15000");
    assert_eq!(speed(&stock.apart[0].document), "13000");
    // it was written after all: no message
    let browser = closed(&|browser| {
        let mut same = Tab::open(browser);
        same.set_speed("13000");
        same.save(browser).unwrap();
    });
    assert_eq!(browser.stock().apart, []);
}

#[test]
fn what_a_closed_page_handed_over_stays_until_the_stored_work_goes_on_from_it() {
    let (opened, edited) = (|_: &mut Tab| {}, |tab: &mut Tab| tab.set_speed("9000"));
    for (change, label) in [(&opened as &dyn Fn(&mut Tab), "view"), (&edited, "edit")] {
        // with stored work and without
        for (mut browser, mut tab) in [
            with_work(),
            (Browser::default(), Tab::open(&Browser::default())),
        ] {
            tab.set_speed("13000");
            let (id, text) = tab.ledger.last(&tab.document, "last", 3.0).unwrap();
            browser.put(Key::apart(&id), &text);
            // the next page shows a link
            let mut linked = Tab::open(&browser);
            let case = Arc::new(Case::run_page());
            linked.document = Document {
                place: apart("link", Why::Link, Some(case.clone())),
                case,
                ..linked.document
            };
            change(&mut linked);
            linked.save(&mut browser).unwrap();
            let next = browser.stock();
            assert_eq!(speed(&next.work.unwrap().document), "13000", "{label}");
            // the stored work continues, and then is the only copy of the handed-over work
            linked.document = Document {
                place: Place::Stored,
                ..linked.document
            };
            linked.set_speed("14000");
            linked.save(&mut browser).unwrap();
            assert!(!browser.records.contains_key(&Key::apart("last")));
            assert_eq!(speed(&browser.stock().work.unwrap().document), "14000");
        }
    }
}

#[test]
fn another_look_at_the_records_goes_on_as_the_first_one_does() {
    let (mut browser, mut tab) = with_work();
    tab.set_speed("13000");
    let (id, text) = tab.ledger.last(&tab.document, "last", 3.0).unwrap();
    browser.put(Key::apart(&id), &text);
    let stock = browser.stock();
    let mut ledger = Ledger::default();
    let last = Key::apart("last");
    assert!(stock.ledger.apart().contains(&last));
    for key in [Key::current(), last.clone()] {
        ledger.learns(&key, &stock.ledger);
    }
    let work = stock.work.unwrap().document;
    let gone = |ledger: &Ledger| {
        let changes = ledger.changes(&work, 4.0);
        changes.iter().any(|change| change.key == last)
    };
    assert!(gone(&ledger));
    ledger.spares(&last);
    assert!(!gone(&ledger));
}

#[test]
fn a_closing_page_hands_over_only_what_is_not_written() {
    let (_, mut tab) = with_work();
    assert_eq!(tab.ledger.last(&tab.document, "last", 3.0), None);
    // neither an outline nor a removed record is a change of case and units
    tab.import("cone", 1.0);
    tab.ledger.dooms(Key::apart("old"));
    assert!(!tab.ledger.changes(&tab.document, 3.0).is_empty());
    assert_eq!(tab.ledger.last(&tab.document, "last", 3.0), None);
    let case = tab.document.case.clone();
    tab.document.place = apart("link", Why::Link, Some(case));
    assert_eq!(tab.ledger.last(&tab.document, "last", 3.0), None);
    tab.set_speed("13000");
    let handed = tab.ledger.last(&tab.document, "last", 3.0);
    assert_eq!(handed.unwrap().0, "link");
}

#[test]
fn what_was_handed_over_becomes_a_record_whatever_its_own_holds() {
    let text = |text: &str| Found::Text(text.to_string());
    for found in [
        None,
        Some(text("older")),
        Some(Found::Other("7".to_string())),
    ] {
        let mut browser = Browser::default();
        let key = Key::apart("1");
        browser
            .records
            .extend(found.clone().map(|found| (key.clone(), found)));
        let mut change = Change {
            key: key.clone(),
            expected: None,
            text: Some("handed over".to_string()),
        };
        while let Written::Nothing(clashes) = browser.write(&[change.clone()]).unwrap() {
            change = change.over(clashes.into_iter().next().unwrap().1);
        }
        let records = &browser.records;
        assert!(records.values().any(|found| *found == text("handed over")));
        // a record that is not a text is not overwritten
        if let Some(Found::Other(_)) = found {
            assert_eq!(records.get(&key), found.as_ref());
        }
    }
}
