//! What the page says of what the browser keeps.

use crate::storage::stock::{KeptApart, Unreadable};
use leptos::prelude::*;

/// Whether what was made is safe.
#[derive(Clone, Debug, PartialEq)]
pub enum SaveState {
    /// Not written yet.
    Saving,
    /// Kept in the browser.
    Saved,
    /// The browser keeps nothing, and why.
    Refused(String),
}

/// The stored work while the page shows something else, as one line of a list.
#[derive(Clone, Debug, PartialEq)]
pub struct Stored {
    /// Name of its case.
    pub name: String,
    /// When it was kept, ms since 1970.
    pub saved_ms: Option<f64>,
}

/// Signals about what is kept.
#[derive(Clone, Copy)]
pub struct Keeping {
    /// Whether what was made is safe.
    pub save_state: RwSignal<SaveState>,
    /// Whether the browser promised not to clear what is kept; `None` when it was not asked.
    pub protected: RwSignal<Option<bool>>,
    /// The stored work that the page does not show.
    pub stored: RwSignal<Option<Stored>>,
    /// Work that is kept apart from the stored work.
    pub apart: RwSignal<Vec<KeptApart>>,
    /// Records that cannot be read.
    pub unreadable: RwSignal<Vec<Unreadable>>,
    /// What the browser refused when the records were read, in sentences.
    pub refused: RwSignal<Vec<String>>,
    /// What must be known of the link that was opened.
    pub link_words: RwSignal<Vec<String>>,
    /// Name of a run of which is to be said whether it is saved.
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
