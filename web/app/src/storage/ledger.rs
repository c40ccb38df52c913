//! A tab's knowledge of the records, and the changes needed to store a document.
//!
//! Each change contains the text that this tab last saw in the record. If another tab has written in between, the
//! change is a clash: nothing is written, and [`Ledger::resolve`] decides how both versions are kept.

use super::record::{Change, Found, Key, Sheet, Sort, read, written};
use crate::state::document::{Document, Place, Rows, Run, Why};
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::collections::BTreeMap;
use std::sync::Arc;

type Kept<T> = Arc<BTreeMap<String, T>>;

/// Knowledge of a tab about the records.
#[derive(Debug, Default)]
pub struct Ledger {
    /// Texts of the records as last read or written by this tab.
    known: BTreeMap<Key, String>,
    /// Parsed contents of the records of case and units.
    sheets: BTreeMap<Key, Sheet>,
    runs: Kept<Run>,
    outlines: Kept<Rows>,
    tables: Kept<Rows>,
    /// Records that are removed when the stored work is written, which continues them.
    doomed: Vec<Key>,
}

/// Resolution of a clash for the document of this tab.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// Nothing to do: both versions are equal, or the record may be written now.
    Again,
    /// Case and units are stored separately from now on; the stored work belongs to another tab.
    Apart,
    /// The item called `from` is called `to` from now on.
    Renamed {
        /// Record.
        key: Key,
        /// Name or identifier before.
        from: String,
        /// Name or identifier from now on.
        to: String,
    },
    /// The record removed here stays, since another tab changed it.
    Stays(Key),
}

impl Ledger {
    /// Notes the text of a record that was read.
    pub fn knows(&mut self, key: Key, text: String) {
        self.known.insert(key, text);
    }

    /// Notes the content of a record of case and units.
    pub fn says(&mut self, key: Key, sheet: Sheet) {
        self.sheets.insert(key, sheet);
    }

    /// Notes the stored runs, outlines and tables.
    pub fn keeps(
        &mut self,
        runs: &BTreeMap<String, Run>,
        outlines: &BTreeMap<String, Rows>,
        tables: &BTreeMap<String, Rows>,
    ) {
        self.runs = Arc::new(runs.clone());
        self.outlines = Arc::new(outlines.clone());
        self.tables = Arc::new(tables.clone());
    }

    /// Marks a record for removal together with the next write of the stored work: until then it holds the only copy.
    pub fn dooms(&mut self, key: Key) {
        if !self.doomed.contains(&key) {
            self.doomed.push(key);
        }
    }

    /// Revokes the removal of a record, since the displayed work is stored there again.
    pub fn spares(&mut self, key: &Key) {
        self.doomed.retain(|doomed| doomed != key);
    }

    /// Keys of separate work.
    pub fn apart(&self) -> Vec<Key> {
        let keys = self.known.keys();
        keys.filter(|key| matches!(key.sort(), Sort::Apart(_)))
            .cloned()
            .collect()
    }

    /// Text of a record as last seen by this tab.
    pub fn text(&self, key: &Key) -> Option<String> {
        self.known.get(key).cloned()
    }

    /// Content of a record of case and units.
    pub fn sheet(&self, key: &Key) -> Option<&Sheet> {
        self.sheets.get(key)
    }

    /// Forgets a record that has been removed or is to be read again.
    pub fn forgets(&mut self, key: &Key) {
        self.known.remove(key);
        self.sheets.remove(key);
        self.spares(key);
    }

    /// Takes one record's state from a newer reading of the database.
    pub fn learns(&mut self, key: &Key, of: &Ledger) {
        self.forgets(key);
        if let Some(text) = of.known.get(key) {
            self.known.insert(key.clone(), text.clone());
        }
        if let Some(sheet) = of.sheets.get(key) {
            self.sheets.insert(key.clone(), sheet.clone());
        }
        if of.doomed.contains(key) {
            self.dooms(key.clone());
        }
    }

    /// Changes needed for the records to hold a document.
    pub fn changes(&self, document: &Document, now_ms: f64) -> Vec<Change> {
        let mut changes = Vec::new();
        let key = place_key(&document.place);
        if let Some(sheet) = self.unwritten(document, now_ms) {
            changes.push(self.change(key.clone(), Some(written(&sheet))));
        }
        self.compare(&self.runs, &document.runs, Key::run, &mut changes);
        self.compare(
            &self.outlines,
            &document.outlines,
            Key::outline,
            &mut changes,
        );
        self.compare(&self.tables, &document.tables, Key::table, &mut changes);
        if key == Key::current() {
            let doomed = self.doomed.iter();
            changes.extend(doomed.map(|key| self.change(key.clone(), None)));
        }
        changes
    }

    /// Case and units of a document, if its record differs.
    fn unwritten(&self, document: &Document, now_ms: f64) -> Option<Sheet> {
        let key = place_key(&document.place);
        let is_view = document.is_view() && !self.known.contains_key(&key);
        let sheet = self.sheet_of(document, now_ms);
        let kept = self.sheets.get(&key);
        let is_written = kept.is_some_and(|kept| kept.says_as(&sheet));
        (!is_view && !is_written).then_some(sheet)
    }

    /// Key and text of the separate record that holds case and units of a document whose page is being closed. It
    /// becomes the stored work on the next start if that is unchanged since. `None` if they are already written.
    pub fn last(&self, document: &Document, id: &str, now_ms: f64) -> Option<(String, String)> {
        let mut sheet = self.unwritten(document, now_ms)?;
        let id = match &document.place {
            Place::Stored => {
                sheet.why = Some(Why::Closed);
                sheet.continues = Some(self.text(&Key::current()).unwrap_or_default());
                id
            }
            Place::Apart(apart) => &apart.id,
        };
        Some((id.to_string(), written(&sheet)))
    }

    fn sheet_of(&self, document: &Document, now_ms: f64) -> Sheet {
        let why = match &document.place {
            Place::Stored => None,
            Place::Apart(apart) => Some(apart.why),
        };
        Sheet {
            why,
            ..Sheet::of(document, now_ms)
        }
    }

    fn change(&self, key: Key, text: Option<String>) -> Change {
        let expected = self.known.get(&key).cloned();
        Change {
            key,
            expected,
            text,
        }
    }

    fn compare<T: PartialEq + Serialize>(
        &self,
        kept: &Kept<T>,
        now: &Kept<T>,
        key: fn(&str) -> Key,
        changes: &mut Vec<Change>,
    ) {
        if Arc::ptr_eq(kept, now) {
            return;
        }
        for (name, value) in now.iter() {
            if kept.get(name) != Some(value) {
                changes.push(self.change(key(name), Some(written(value))));
            }
        }
        for name in kept.keys().filter(|name| !now.contains_key(*name)) {
            changes.push(self.change(key(name), None));
        }
    }

    /// Notes that the changes are committed.
    pub fn committed(&mut self, document: &Document, changes: &[Change]) {
        for Change { key, text, .. } in changes {
            match text {
                Some(text) => drop(self.known.insert(key.clone(), text.clone())),
                None => self.forgets(key),
            }
        }
        let key = place_key(&document.place);
        if let Some(text) = changes.iter().find(|change| change.key == key)
            && let Some(text) = &text.text
            && let Ok(sheet) = read(&Found::Text(text.clone()))
        {
            self.sheets.insert(key, sheet);
        }
        self.runs = document.runs.clone();
        self.outlines = document.outlines.clone();
        self.tables = document.tables.clone();
    }

    /// Resolves a clash; `found` is the current content of the record.
    pub fn resolve(&mut self, document: &Document, key: &Key, found: Option<Found>) -> Verdict {
        match key.sort() {
            Sort::Current | Sort::Apart(_) => self.resolve_sheet(document, key, found),
            Sort::Run(id) => resolve_item(
                &mut self.known,
                &mut self.runs,
                &document.runs,
                key,
                &id,
                found,
            ),
            Sort::Outline(name) => resolve_item(
                &mut self.known,
                &mut self.outlines,
                &document.outlines,
                key,
                &name,
                found,
            ),
            Sort::Table(name) => resolve_item(
                &mut self.known,
                &mut self.tables,
                &document.tables,
                key,
                &name,
                found,
            ),
            Sort::Unknown => Verdict::Again,
        }
    }

    fn resolve_sheet(&mut self, document: &Document, key: &Key, found: Option<Found>) -> Verdict {
        let Some(found) = found else {
            if *key == Key::current() {
                // the browser's data were cleared: write everything again; a record that exists after all causes a
                // clash
                *self = Ledger::default();
            }
            self.forgets(key);
            return Verdict::Again;
        };
        if self.doomed.contains(key) {
            // another tab works on it
            self.spares(key);
            return Verdict::Again;
        }
        let sheet: Option<Sheet> = read(&found).ok();
        let wanted = Sheet::of(document, 0.0);
        if let (Some(sheet), Found::Text(text)) = (sheet, found) {
            let known = self.sheets.get(key);
            if sheet.says_as(&wanted) || known.is_some_and(|known| sheet.says_as(known)) {
                self.known.insert(key.clone(), text);
                self.sheets.insert(key.clone(), sheet);
                return Verdict::Again;
            }
        }
        Verdict::Apart
    }
}

/// Key of a place.
pub fn place_key(place: &Place) -> Key {
    match place {
        Place::Stored => Key::current(),
        Place::Apart(apart) => Key::apart(&apart.id),
    }
}

fn resolve_item<T: Clone + PartialEq + DeserializeOwned>(
    known: &mut BTreeMap<Key, String>,
    kept: &mut Kept<T>,
    now: &Kept<T>,
    key: &Key,
    name: &str,
    found: Option<Found>,
) -> Verdict {
    let mut items = (**kept).clone();
    known.remove(key);
    items.remove(name);
    let mut verdict = Verdict::Again;
    if let Some(found) = found {
        let theirs: Option<T> = read(&found).ok();
        match now.get(name) {
            // both tabs made the same change
            Some(ours) if theirs.as_ref() == Some(ours) => {
                items.insert(name.to_string(), ours.clone());
                if let Found::Text(text) = found {
                    known.insert(key.clone(), text);
                }
            }
            Some(_) => {
                let taken = |name: &String| now.contains_key(name) || items.contains_key(name);
                let mut names = (2..).map(|number: u32| format!("{name} ({number})"));
                let to = names.find(|name| !taken(name)).unwrap_or_default();
                verdict = Verdict::Renamed {
                    key: key.clone(),
                    from: name.to_string(),
                    to,
                };
            }
            None => verdict = Verdict::Stays(key.clone()),
        }
    }
    *kept = Arc::new(items);
    verdict
}
