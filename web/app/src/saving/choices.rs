//! Actions on separately stored work: return to the stored work, replace it, open or discard separate work.

use super::closing::remember_own;
use super::{Saver, stored};
use crate::state::document::{Apart, Document, Place, Run, Why};
use crate::storage::ledger::place_key;
use crate::storage::record::Key;
use crate::storage::stock::{KeptApart, Stock, Unreadable};
use leptos::prelude::*;
use msape::case::Version;
use std::sync::Arc;
use wasm_bindgen_futures::spawn_local;

impl Saver {
    /// Shows the stored work in its current state; the displayed work stays stored separately.
    pub fn return_to_stored(&self) {
        self.with_stock(|saver, stock| {
            let state = saver.0.state;
            saver.learn(&stock, &Key::current());
            let Some(work) = stock.work else {
                return state.notice.set("There is no stored work.".to_string());
            };
            state.keeping.stored.set(Some(stored(&work)));
            state.version_remarks.set(work.remarks);
            let label = format!("Return to {}", work.document.case.name);
            state.edit(&label, None, |now| work.document.with_items_of(now));
            state.keeping.link_words.set(Vec::new());
            remember_own(None);
        });
    }

    /// Makes the displayed work the stored work. The previous stored work becomes a named run.
    pub fn keep_this(&self) {
        self.with_stock(|saver, stock| {
            let state = saver.0.state;
            let shown = state.document.get_untracked();
            if shown.place == Place::Stored {
                return;
            }
            saver.learn(&stock, &Key::current());
            if let Some(work) = stock.work {
                let name = work.document.case.name.clone();
                let saved_ms = work.saved_ms.unwrap_or_else(js_sys::Date::now);
                let run = Run {
                    name: name.clone(),
                    saved_ms,
                    case: work.document.case.to_toml(),
                    headline: Vec::new(),
                    version: Some(Version::CURRENT),
                };
                let known = (shown.runs.values()).any(|other| other.case == run.case);
                if !known {
                    let id = format!("{saved_ms:.0}-stored");
                    state.history.update(|history| {
                        history.change_all(|document| {
                            Some(
                                document
                                    .with_runs(|runs| drop(runs.insert(id.clone(), run.clone()))),
                            )
                        });
                    });
                }
                state
                    .notice
                    .set(format!("{name}, stored before, is a run now."));
            }
            if let Some(ledger) = saver.0.ledger.borrow_mut().as_mut() {
                ledger.dooms(place_key(&shown.place));
            }
            state.edit("Keep this instead", None, |now| Document {
                place: Place::Stored,
                ..now.clone()
            });
        });
    }

    /// Shows separately stored work; the displayed work stays stored where it is.
    pub fn open_apart(&self, apart: &KeptApart) {
        let state = self.0.state;
        let label = format!("Open {}", apart.document.case.name);
        let document = apart.document.clone();
        state.edit(&label, None, |now| document.with_items_of(now));
    }

    /// Removes separately stored work.
    pub fn discard_apart(&self, id: &str) {
        self.remove(Key::apart(id));
        let apart = self.0.state.keeping.apart;
        apart.update(|list| list.retain(|apart| apart.id != id));
    }

    /// Removes a record that cannot be read.
    pub fn discard_unreadable(&self, record: &Unreadable) {
        self.remove(record.key.clone());
        let unreadable = self.0.state.keeping.unreadable;
        unreadable.update(|list| list.retain(|other| other.key != record.key));
    }

    fn remove(&self, key: Key) {
        let saver = self.clone();
        saver.0.waiting.borrow_mut().forget(&key);
        spawn_local(async move {
            match saver.0.store.remove(&key).await {
                Ok(()) => {
                    if let Some(ledger) = saver.0.ledger.borrow_mut().as_mut() {
                        ledger.forgets(&key);
                    }
                }
                Err(reason) => {
                    let notice = format!("{} could not be removed: {reason}.", key.words());
                    saver.0.state.notice.set(notice);
                }
            }
        });
    }

    /// Reads the records again.
    fn with_stock(&self, act: impl FnOnce(&Saver, Stock) + 'static) {
        let saver = self.clone();
        spawn_local(async move {
            match saver.take_stock().await {
                Ok(stock) => {
                    let keeping = saver.0.state.keeping;
                    keeping.unreadable.set(stock.unreadable.clone());
                    // this tab's own writes are newer than the records
                    let own = place_key(&saver.0.state.document.get_untracked().place);
                    for key in stock.ledger.apart().iter().filter(|key| **key != own) {
                        saver.learn(&stock, key);
                    }
                    keeping.apart.set(stock.apart.clone());
                    act(&saver, stock);
                }
                Err(reason) => {
                    let notice = format!("What is stored cannot be read now: {reason}.");
                    saver.0.state.notice.set(notice);
                }
            }
        });
    }

    fn learn(&self, stock: &Stock, key: &Key) {
        if let Some(ledger) = self.0.ledger.borrow_mut().as_mut() {
            ledger.learns(key, &stock.ledger);
        }
    }
}

/// Document for a link that is opened beside the work of this tab.
pub fn of_link(now: &Document, case: msape::Case) -> Document {
    let case = Arc::new(case);
    let place = if *case == *now.case {
        now.place.clone()
    } else {
        Apart::place(Why::Link, Some(case.clone()))
    };
    Document {
        case,
        place,
        ..now.clone()
    }
}
