//! What happens when the page is closed or loaded anew: what is not committed is handed to the browser, and the tab remembers
//! which record it worked on.

use super::Saver;
use crate::app::leave_link;
use crate::state::document::Place;
use crate::state::history::History;
use crate::state::keeping::SaveState;
use crate::storage::record::{Change, Found, Key, Written};
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
        let newest = (inner.waiting.borrow().clone()).or_else(|| inner.under_way.borrow().clone());
        let ledger = inner.ledger.borrow();
        let (Some(document), Some(ledger)) = (newest, ledger.as_ref()) else {
            return;
        };
        if document.is_view() || ledger.changes(&document, 0.0).is_empty() {
            return;
        }
        let (id, text) = ledger.last(&document, &inner.last, js_sys::Date::now());
        if let Place::Apart(apart) = &document.place {
            remember_own(Some(&apart.id));
            leave_link();
        }
        if let Some(storage) = small() {
            // One that refuses leaves the question whether to go.
            let _ = storage.set_item(&format!("{LAST}{id}"), &text);
        }
        inner.last_written.replace(Some(id));
    }

    /// What was handed over is committed by now.
    pub(super) fn forget_last(&self) {
        if let Some(id) = self.0.last_written.take() {
            forget(&id);
        }
    }

    /// Makes records of what pages handed over that were closed.
    ///
    /// # Errors
    /// Why the browser refuses, in words.
    pub(super) async fn take_last(&self) -> Result<(), String> {
        for (id, text) in handed_over() {
            let mut change = Change {
                key: Key::apart(&id),
                expected: None,
                text: Some(text),
            };
            // What the page itself had written there is older.
            while let Written::Nothing(clashes) = self.0.store.write(&[change.clone()]).await? {
                let found = clashes.into_iter().next().and_then(|(_, found)| found);
                match found {
                    Some(Found::Text(text)) => change.expected = Some(text),
                    None => change.expected = None,
                    Some(Found::Other(_)) => break,
                }
            }
            forget(&id);
        }
        Ok(())
    }
}

/// Storage that takes texts at once, shared by all tabs.
fn small() -> Option<web_sys::Storage> {
    window().local_storage().ok().flatten()
}

/// Identifiers and texts of what pages handed over.
fn handed_over() -> Vec<(String, String)> {
    let Some(storage) = small() else {
        return Vec::new();
    };
    let keys = (0..storage.length().unwrap_or(0)).filter_map(|i| storage.key(i).ok().flatten());
    keys.filter_map(|key| {
        let id = key.strip_prefix(LAST)?.to_string();
        Some((id, storage.get_item(&key).ok().flatten()?))
    })
    .collect()
}

fn forget(id: &str) {
    if let Some(storage) = small() {
        // What stays is found equal to what is stored, and dropped.
        let _ = storage.remove_item(&format!("{LAST}{id}"));
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
