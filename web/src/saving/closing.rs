//! What happens when the page is closed or loaded anew: what is not committed is handed to the browser, and the tab remembers
//! which record it worked on.

use super::Saver;
use super::waiting::Waiting;
use crate::app::leave_link;
use crate::state::document::Place;
use crate::state::history::History;
use crate::state::keeping::SaveState;
use crate::storage::record::{Change, Found, Key, Sort, Written};
use leptos::prelude::*;

/// Item of the tab's own storage that names the record that it works on, when it is apart.
const OWN: &str = "msape-apart";
/// What the names of items begin with that hold what a closing page had not written.
const LAST: &str = "msape-last ";

impl Saver {
    /// Hands what is not committed to the browser before the page is closed or put to sleep, and asks the user to stay.
    pub(super) fn write_before_the_page_goes(&self) {
        let saver = self.clone();
        let leave = window_event_listener(leptos::ev::beforeunload, move |event| {
            let saved = saver.0.state.keeping.save_state.get_untracked() == SaveState::Saved;
            let pristine = (saver.0.state.history).with_untracked(History::is_pristine);
            if !saved && !pristine {
                saver.write_last();
                event.prevent_default();
            }
        });
        let saver = self.clone();
        let hide = window_event_listener(leptos::ev::pagehide, move |_| saver.write_last());
        let saver = self.clone();
        let change = window_event_listener(leptos::ev::visibilitychange, move |_| {
            if document().hidden() {
                saver.write_last();
            }
        });
        on_cleanup(move || {
            leave.remove();
            hide.remove();
            change.remove();
        });
    }

    /// The browser's database answers too late for a page that goes; its small storage takes a text at once.
    fn write_last(&self) {
        let inner = &self.0;
        let ledger = inner.ledger.borrow();
        let Some(ledger) = ledger.as_ref() else {
            return;
        };
        let shown = inner.state.document.get_untracked();
        match &shown.place {
            Place::Apart(_) if shown.is_view() => {}
            Place::Apart(apart) => {
                remember_own(Some(&apart.id));
                leave_link();
            }
            Place::Stored => remember_own(None),
        }
        let mut unwritten = Waiting::default();
        let under_way = inner.under_way.borrow();
        for document in under_way.iter().chain(inner.waiting.borrow().iter()) {
            unwritten.put(document.clone());
        }
        for document in unwritten.iter() {
            let last = ledger.last(document, &inner.last, js_sys::Date::now());
            if let Some((id, text)) = last {
                if let Some(storage) = small() {
                    // One that refuses leaves the question whether to go.
                    let _ = storage.set_item(&format!("{LAST}{id}"), &text);
                }
                inner.last_written.borrow_mut().push(id);
            }
        }
    }

    /// What was handed over is committed by now.
    pub(super) fn forget_last(&self) {
        for id in self.0.last_written.take() {
            if let Some(storage) = small() {
                // What stays is found equal to what is stored, and dropped.
                let _ = storage.remove_item(&format!("{LAST}{id}"));
            }
        }
    }

    /// Makes records of what pages handed over that were closed. What cannot be made one stays.
    ///
    /// # Errors
    /// Why the browser refuses one of them, in words.
    pub(super) async fn take_last(&self) -> Result<(), String> {
        let mut taken = Ok(());
        for (key, found) in handed_over() {
            let text = found.spelled().to_string();
            match self.take_one(key.clone(), text.clone()).await {
                Ok(()) => forget(&key, &text),
                Err(reason) => taken = Err(reason),
            }
        }
        taken
    }

    /// What the page itself had written there is older.
    async fn take_one(&self, key: Key, text: String) -> Result<(), String> {
        let (expected, text) = (None, Some(text));
        let mut change = Change {
            key,
            expected,
            text,
        };
        while let Written::Nothing(clashes) = self.0.store.write(&[change.clone()]).await? {
            change = change.over(clashes.into_iter().next().and_then(|(_, found)| found));
        }
        Ok(())
    }
}

/// Storage that takes texts at once, shared by all tabs.
fn small() -> Option<web_sys::Storage> {
    window().local_storage().ok().flatten()
}

/// What pages handed over, with the records that are to hold it.
pub(super) fn handed_over() -> Vec<(Key, Found)> {
    let Some(storage) = small() else {
        return Vec::new();
    };
    let names = (0..storage.length().unwrap_or(0)).filter_map(|i| storage.key(i).ok().flatten());
    names
        .filter_map(|name| {
            let key = Key::apart(name.strip_prefix(LAST)?);
            Some((key, Found::Text(storage.get_item(&name).ok().flatten()?)))
        })
        .collect()
}

/// Takes away what is a record by now. What its page has handed over anew since then stays.
fn forget(key: &Key, text: &str) {
    if let (Some(storage), Sort::Apart(id)) = (small(), key.sort()) {
        let name = format!("{LAST}{id}");
        if storage.get_item(&name).ok().flatten().as_deref() == Some(text) {
            // What stays is found equal to what is stored, and dropped.
            let _ = storage.remove_item(&name);
        }
    }
}

fn session() -> Option<web_sys::Storage> {
    window().session_storage().ok().flatten()
}

/// The record that this tab worked on before it was loaded anew, when that is apart.
pub(super) fn own_record() -> Option<String> {
    session()?.get_item(OWN).ok().flatten()
}

pub(super) fn remember_own(id: Option<&str>) {
    if let Some(session) = session() {
        // A storage that refuses only forgets which record the tab worked on; the record is kept.
        let _ = match id {
            Some(id) => session.set_item(OWN, id),
            None => session.remove_item(OWN),
        };
    }
}
