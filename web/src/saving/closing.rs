//! What happens when the page is closed or loaded anew: what is not committed is handed to the browser, and the tab remembers
//! which record it worked on.

use super::Saver;
use crate::state::document::Place;
use crate::state::history::History;
use crate::state::keeping::SaveState;
use leptos::prelude::*;

/// Item of the tab's own storage that names the record that it works on, when it is apart.
const OWN: &str = "msape-apart";

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

    fn write_last(&self) {
        let inner = &self.0;
        let newest = (inner.waiting.borrow().clone()).or_else(|| inner.under_way.borrow().clone());
        let mut ledger = inner.ledger.borrow_mut();
        let (Some(document), Some(ledger)) = (newest, ledger.as_mut()) else {
            return;
        };
        if document.is_view() || ledger.changes(&document, 0.0).is_empty() {
            return;
        }
        let change = ledger.last_change(&document, &inner.last, js_sys::Date::now());
        inner.store.hand_over(&change);
        if document.place == Place::Stored
            && let Some(text) = change.text
        {
            inner.has_last.set(true);
            ledger.knows(change.key, text);
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
