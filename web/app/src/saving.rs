//! Automatic saving of every document, and restoring of stored work.
//!
//! At most one transaction is active; of the documents that arrive meanwhile only the newest of each place is written.
//! A failed write is repeated with increasing delay. Changes of another tab are never overwritten: see
//! [`crate::storage::ledger`].

pub mod choices;
mod closing;
mod waiting;

use crate::app::leave_link;
use crate::state::State;
use crate::state::document::{Apart, Document, Place, Why};
use crate::state::history::History;
use crate::state::keeping::{SaveState, Stored};
use crate::storage::ledger::{Ledger, Verdict, place_key};
use crate::storage::record::{Found, Key, Sheet, Sort, Written, read};
use crate::storage::stock::{Stock, StoredWork};
use crate::storage::{self, Store};
use closing::{handed_over, own_record, remember_own};
use leptos::prelude::*;
use std::cell::{Cell, RefCell};
use std::rc::Rc;
use std::sync::Arc;
use std::time::Duration;
use waiting::Waiting;
use wasm_bindgen_futures::spawn_local;

/// Delay before the first repetition, ms; it doubles each time.
const RETRY_MS: u64 = 500;
/// Longest delay before a repetition, ms.
const RETRY_MAX_MS: u64 = 30_000;

/// Automatic saver of documents.
#[derive(Clone)]
pub struct Saver(Rc<Inner>);

struct Inner {
    state: State,
    store: Store,
    /// `None` before the records have been read; until then nothing is written.
    ledger: RefCell<Option<Ledger>>,
    /// Documents not yet committed.
    waiting: RefCell<Waiting>,
    /// Document of the active transaction.
    under_way: RefCell<Option<Arc<Document>>>,
    failures: Cell<u32>,
    retry: Cell<Option<TimeoutHandle>>,
    /// Identifier of the record for unsaved work when the page is closed.
    last: String,
    /// Identifiers under which unsaved work was handed over.
    last_written: RefCell<Vec<String>>,
}

impl Saver {
    /// Restores stored work and from then on saves every document. `linked`: the document comes from a link.
    pub fn start(state: State, linked: bool) -> Saver {
        let last = match Apart::place(Why::Closed, None) {
            Place::Apart(apart) => apart.id.clone(),
            Place::Stored => String::new(),
        };
        let saver = Saver(Rc::new(Inner {
            state,
            store: Store::default(),
            ledger: RefCell::default(),
            waiting: RefCell::default(),
            under_way: RefCell::default(),
            failures: Cell::new(0),
            retry: Cell::default(),
            last,
            last_written: RefCell::default(),
        }));
        saver.open(linked);
        Effect::new({
            let saver = saver.clone();
            move |_| {
                let document = state.document.get();
                if let Some(ledger) = saver.0.ledger.borrow_mut().as_mut() {
                    ledger.spares(&place_key(&document.place));
                }
                saver.0.waiting.borrow_mut().put(document);
                state.keeping.save_state.set(SaveState::Saving);
                saver.write_next();
            }
        });
        saver.write_before_the_page_goes();
        saver
    }

    fn open(&self, linked: bool) {
        let saver = self.clone();
        spawn_local(async move {
            match saver.take_stock().await {
                Ok(stock) => {
                    saver.0.failures.set(0);
                    let has_runs = !stock.runs.is_empty();
                    saver.restore(stock, linked);
                    if has_runs {
                        let protected = saver.0.state.keeping.protected;
                        protected.set(Some(storage::is_protected().await));
                    }
                }
                Err(reason) => {
                    let again = saver.clone();
                    saver.refused(&reason, move || again.open(linked));
                }
            }
        });
    }

    /// Reads all records. Unsaved work of closed pages becomes records, and stored work that cannot be read is moved
    /// aside; if the browser refuses that, the user is told and the stored work is opened nevertheless.
    async fn take_stock(&self) -> Result<Stock, String> {
        let mut refused = Vec::new();
        if let Err(reason) = self.take_last().await {
            refused.push(format!("Work of a page that was closed is not stored yet: {reason}. It stays where it is, and is tried again when the page is loaded."));
        }
        let mut stock = self.load().await?;
        let mut unread = stock.unreadable.iter();
        if unread.any(|record| record.key == Key::current()) {
            let aside = Key::aside(js_sys::Date::now());
            match self.0.store.set_aside(&Key::current(), &aside).await {
                Ok(()) => stock = self.load().await?,
                Err(reason) => refused.push(format!("The stored work, which cannot be read, could not be moved: {reason}. It stays as it is, and what you change is kept apart.")),
            }
        }
        stock.go_on();
        self.0.state.keeping.refused.set(refused);
        Ok(stock)
    }

    /// All records, and the unsaved work that could not be made one.
    async fn load(&self) -> Result<Stock, String> {
        let mut records = self.0.store.load().await?;
        for (key, found) in handed_over() {
            if records.iter().all(|(other, _)| *other != key) {
                records.push((key, found));
            }
        }
        Ok(Stock::take(records))
    }

    fn restore(&self, stock: Stock, linked: bool) {
        let state = self.0.state;
        let keeping = state.keeping;
        let items = Document {
            runs: Arc::new(stock.runs),
            outlines: Arc::new(stock.outlines),
            tables: Arc::new(stock.tables),
            ..(*state.document.get_untracked()).clone()
        };
        let own = (stock.apart.iter()).find(|apart| own_record().as_ref() == Some(&apart.id));
        let own = own.map(|apart| apart.document.clone());
        keeping.unreadable.set(stock.unreadable);
        keeping.apart.set(stock.apart);
        if let Some(work) = &stock.work {
            keeping.stored.set(Some(stored(work)));
        }
        let pristine = state.history.with_untracked(History::is_pristine);
        let work = stock.work.map(|work| {
            if pristine && !linked && own.is_none() {
                state.version_remarks.set(work.remarks);
            }
            work.document
        });
        state.history.update(|history| {
            match (work, own) {
                (_, Some(own)) if pristine && !linked => *history = History::new(own),
                (Some(work), _) if pristine && !linked => *history = History::new(work),
                (Some(work), _) if pristine && work.case == history.present().case => {
                    *history = History::new(work);
                }
                (Some(work), _) => {
                    // stored work is kept and can be reached by undo
                    let opened = linked.then(|| history.present().case.clone());
                    let why = if linked { Why::Link } else { Why::Early };
                    let shown = Document {
                        place: Apart::place(why, opened),
                        units: work.units,
                        unit_of: work.unit_of.clone(),
                        ..(**history.present()).clone()
                    };
                    *history = History::new(work);
                    let label = if linked { "Open link" } else { "Edits before" };
                    history.edit(label, None, shown);
                }
                (None, _) => {}
            }
            history.change_all(|document| Some(document.with_items_of(&items)));
        });
        self.0.ledger.replace(Some(stock.ledger));
        // documents waiting now were shown before the records had been read
        self.0.waiting.replace(Waiting::default());
        self.show_waits();
        self.write_next();
    }

    /// Updates the display that something waits to be written.
    fn show_waits(&self) {
        let shown = self.0.state.document.get_untracked();
        self.0.waiting.borrow_mut().put(shown);
    }

    /// Writes the next document, unless a write is active.
    fn write_next(&self) {
        let inner = &self.0;
        if inner.ledger.borrow().is_none() || inner.under_way.borrow().is_some() {
            return;
        }
        if let Some(handle) = inner.retry.take() {
            handle.clear();
        }
        let shown = inner.state.document.get_untracked();
        let Some(document) = inner.waiting.borrow_mut().take(&shown) else {
            return;
        };
        inner.under_way.replace(Some(document.clone()));
        let saver = self.clone();
        spawn_local(async move {
            let written = saver.write(&document).await;
            saver.0.under_way.replace(None);
            match written {
                Ok(()) => {
                    saver.0.failures.set(0);
                    if saver.0.waiting.borrow().is_empty() {
                        saver.saved();
                    }
                    saver.write_next();
                }
                Err(reason) => {
                    saver.0.waiting.borrow_mut().put_back(document);
                    let again = saver.clone();
                    saver.refused(&reason, move || again.write_next());
                }
            }
        });
    }

    async fn write(&self, document: &Arc<Document>) -> Result<(), String> {
        let inner = &self.0;
        let with_ledger = |act: &mut dyn FnMut(&mut Ledger)| {
            if let Some(ledger) = inner.ledger.borrow_mut().as_mut() {
                act(ledger);
            }
        };
        let mut changes = Vec::new();
        with_ledger(&mut |ledger| {
            changes = ledger.changes(document, js_sys::Date::now());
        });
        match inner.store.write(&changes).await? {
            Written::All => with_ledger(&mut |ledger| ledger.committed(document, &changes)),
            Written::Nothing(clashes) => {
                // written again after the clash is resolved, unless that makes a newer document
                inner.waiting.borrow_mut().put_back(document.clone());
                for (key, found) in clashes {
                    let mut verdict = Verdict::Again;
                    with_ledger(&mut |ledger| {
                        verdict = ledger.resolve(document, &key, found.clone());
                    });
                    self.settle(&key, found.as_ref(), verdict);
                }
            }
        }
        Ok(())
    }

    /// Changes the document so that it can be stored beside the changes of another tab.
    fn settle(&self, key: &Key, found: Option<&Found>, verdict: Verdict) {
        let state = self.0.state;
        let notice = |text: String| state.notice.set(text);
        match verdict {
            Verdict::Again => {}
            Verdict::Apart => {
                if let Some(stored) = found.and_then(stored_in)
                    && *key == Key::current()
                {
                    state.keeping.stored.set(Some(stored));
                }
                self.part(key, Why::OtherTab);
            }
            Verdict::Renamed { key, from, to } => {
                if !matches!(key.sort(), Sort::Run(_)) {
                    notice(format!(
                        "Another tab has imported another {from}; this one is called {to}."
                    ));
                }
                let document = state.document.get_untracked();
                state.history.update(|history| {
                    history.change_all(|step| step.renamed(&document, &from, &to, &key.sort()));
                });
            }
            Verdict::Stays(key) => notice(format!(
                "Another tab has changed {}; it is not removed.",
                key.words()
            )),
        }
        self.show_waits();
    }

    /// From now on, documents of this record are stored separately.
    fn part(&self, key: &Key, why: Why) {
        let place = Apart::place(why, None);
        let parted = |document: &Document| {
            let here = place_key(&document.place) == *key;
            here.then(|| Document {
                place: place.clone(),
                ..document.clone()
            })
        };
        self.0.waiting.borrow_mut().change_all(parted);
        let history = self.0.state.history;
        history.update(|history| history.change_all(parted));
    }

    fn saved(&self) {
        self.forget_last();
        let state = self.0.state;
        let document = state.document.get_untracked();
        match &document.place {
            Place::Apart(apart) if !document.is_view() => {
                remember_own(Some(&apart.id));
                // a reload continues with the record, not with the link
                leave_link();
            }
            Place::Apart(_) => {}
            Place::Stored => {
                remember_own(None);
                let (name, saved_ms) = (document.case.name.clone(), Some(js_sys::Date::now()));
                state.keeping.stored.set(Some(Stored { name, saved_ms }));
                leave_link();
            }
        }
        state.keeping.save_state.set(SaveState::Saved);
        self.announce(|name| format!("Run {name} is saved in this browser."));
    }

    fn refused(&self, reason: &str, again: impl Fn() + 'static) {
        let failures = self.0.failures.get();
        self.0.failures.set(failures + 1);
        let wait = RETRY_MAX_MS.min(RETRY_MS << failures.min(10));
        let handle = set_timeout_with_handle(again, Duration::from_millis(wait));
        if let Some(before) = self.0.retry.replace(handle.ok()) {
            before.clear();
        }
        let refused = SaveState::Refused(reason.to_string());
        self.0.state.keeping.save_state.set(refused);
        self.announce(|name| {
            format!("Run {name} is not saved yet: {reason}. It is tried again; until then it is lost with this page.")
        });
    }

    fn announce(&self, words: impl Fn(&str) -> String) {
        let announced = self.0.state.keeping.announced;
        if let Some(name) = announced.try_update_value(Option::take).flatten() {
            self.0.state.notice.set(words(&name));
        }
    }
}

fn stored(work: &StoredWork) -> Stored {
    Stored {
        name: work.document.case.name.clone(),
        saved_ms: work.saved_ms,
    }
}

fn stored_in(found: &Found) -> Option<Stored> {
    let sheet: Sheet = read(found).ok()?;
    let name = msape::Case::from_text(&sheet.case).map_or_else(|_| String::new(), |case| case.name);
    let saved_ms = sheet.saved_ms;
    Some(Stored { name, saved_ms })
}
