//! State of storage, as shown to the user.

use crate::storage::stock::{KeptApart, Unreadable};
use leptos::prelude::*;

/// State of saving.
#[derive(Clone, Debug, PartialEq)]
pub enum SaveState {
    /// Not written yet.
    Saving,
    /// Stored in the browser.
    Saved,
    /// The browser stores nothing; its reason.
    Refused(String),
}

/// Stored work that is not displayed, as an entry of a list.
#[derive(Clone, Debug, PartialEq)]
pub struct Stored {
    /// Name of the case.
    pub name: String,
    /// Time of saving, ms since 1970.
    pub saved_ms: Option<f64>,
}

/// Signals on storage.
#[derive(Clone, Copy)]
pub struct Keeping {
    /// State of saving.
    pub save_state: RwSignal<SaveState>,
    /// Whether the browser promised not to clear the storage; `None` if it was not asked.
    pub protected: RwSignal<Option<bool>>,
    /// Stored work that is not displayed.
    pub stored: RwSignal<Option<Stored>>,
    /// Separately stored work.
    pub apart: RwSignal<Vec<KeptApart>>,
    /// Records that cannot be read.
    pub unreadable: RwSignal<Vec<Unreadable>>,
    /// Refusals of the browser when the records were read, as sentences.
    pub refused: RwSignal<Vec<String>>,
    /// Messages on the opened link.
    pub link_words: RwSignal<Vec<String>>,
    /// Name of a run whose saving is to be announced.
    pub announced: StoredValue<Option<String>>,
}

impl Default for Keeping {
    fn default() -> Keeping {
        Keeping {
            save_state: RwSignal::new(SaveState::Saving),
            protected: RwSignal::new(None),
            stored: RwSignal::new(None),
            apart: RwSignal::new(Vec::new()),
            unreadable: RwSignal::new(Vec::new()),
            refused: RwSignal::new(Vec::new()),
            link_words: RwSignal::new(Vec::new()),
            announced: StoredValue::new(None),
        }
    }
}
