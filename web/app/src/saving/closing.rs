//! Closing and reloading of the page: uncommitted work is handed to the browser, and the tab remembers the record that
//! it worked on.

use super::Saver;
use super::waiting::Waiting;
use crate::app::leave_link;
use crate::state::document::Place;
use crate::state::history::History;
use crate::state::keeping::SaveState;
use crate::storage::record::{Change, Found, Key, Sort, Written};
use leptos::prelude::*;

/// Key in sessionStorage for the separate record that this tab works on.
const OWN: &str = "msape-apart";
/// Prefix of localStorage keys for unsaved work of closing pages.
const LAST: &str = "msape-last ";

impl Saver {
    /// Hands uncommitted work to the browser before the page is closed or suspended, and asks the user to stay.
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

    /// Writes to localStorage: IndexedDB answers too late for a closing page, localStorage is synchronous.
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
                    // if the browser refuses, the user is still asked whether to leave
                    let _ = storage.set_item(&format!("{LAST}{id}"), &text);
                }
                inner.last_written.borrow_mut().push(id);
            }
        }
    }

    /// Removes handed-over work that has been committed meanwhile.
    pub(super) fn forget_last(&self) {
        for id in self.0.last_written.take() {
            if let Some(storage) = small() {
                // an item that remains is later found equal to the stored work and dropped
                let _ = storage.remove_item(&format!("{LAST}{id}"));
            }
        }
    }

    /// Makes records of the unsaved work of closed pages. Items that cannot become a record stay.
    ///
    /// # Errors
    /// The browser's reason for refusing one of them.
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

    /// Writes an item as a record; a text that the page itself had written there is older and is replaced.
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

/// localStorage: synchronous, shared by all tabs.
fn small() -> Option<web_sys::Storage> {
    window().local_storage().ok().flatten()
}

/// Unsaved work of closed pages, with keys for the records that are to hold it.
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

/// Removes an item that has become a record. It stays if its page has written it again since.
fn forget(key: &Key, text: &str) {
    if let (Some(storage), Sort::Apart(id)) = (small(), key.sort()) {
        let name = format!("{LAST}{id}");
        if storage.get_item(&name).ok().flatten().as_deref() == Some(text) {
            // an item that remains is later found equal to the stored work and dropped
            let _ = storage.remove_item(&name);
        }
    }
}

fn session() -> Option<web_sys::Storage> {
    window().session_storage().ok().flatten()
}

/// Separate record that this tab worked on before it was reloaded.
pub(super) fn own_record() -> Option<String> {
    session()?.get_item(OWN).ok().flatten()
}

pub(super) fn remember_own(id: Option<&str>) {
    if let Some(session) = session() {
        // if the browser refuses, only the link to the record is lost; the record is kept
        let _ = match id {
            Some(id) => session.set_item(OWN, id),
            None => session.remove_item(OWN),
        };
    }
}
