//! Queue of documents to be written: the newest of each place, oldest first.

use crate::state::document::Document;
use crate::storage::ledger::place_key;
use crate::storage::record::Key;
use std::sync::Arc;

/// Queue of documents.
#[derive(Default)]
pub struct Waiting(Vec<Arc<Document>>);

impl Waiting {
    /// Adds a document; it replaces an older one of the same record.
    pub fn put(&mut self, document: Arc<Document>) {
        self.forget(&place_key(&document.place));
        self.0.push(document);
    }

    /// Adds a document that could not be written, unless there is a newer one of the same record.
    pub fn put_back(&mut self, document: Arc<Document>) {
        if self.0.iter().all(|newer| !is_of_same(newer, &document)) {
            self.0.insert(0, document);
        }
    }

    /// The document to be written next, with the runs, outlines and tables of the displayed one.
    pub fn take(&mut self, shown: &Arc<Document>) -> Option<Arc<Document>> {
        let next = (!self.0.is_empty()).then(|| self.0.remove(0))?;
        if next == *shown {
            return Some(next);
        }
        Some(Arc::new(Document {
            runs: shown.runs.clone(),
            outlines: shown.outlines.clone(),
            tables: shown.tables.clone(),
            ..(*next).clone()
        }))
    }

    /// Removes all documents of a record.
    pub fn forget(&mut self, key: &Key) {
        self.0.retain(|document| place_key(&document.place) != *key);
    }

    /// Changes every document; those for which `change` returns `None` stay.
    pub fn change_all(&mut self, change: impl Fn(&Document) -> Option<Document>) {
        for document in &mut self.0 {
            if let Some(changed) = change(document) {
                *document = Arc::new(changed);
            }
        }
    }

    /// All waiting documents.
    pub fn iter(&self) -> impl Iterator<Item = &Arc<Document>> {
        self.0.iter()
    }

    /// Whether nothing waits.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

fn is_of_same(a: &Document, b: &Document) -> bool {
    place_key(&a.place) == place_key(&b.place)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::state::document::{Apart, Place, Why};
    use msape::Case;

    fn at(id: &str, name: &str) -> Arc<Document> {
        let mut case = Case::run_page();
        case.name = name.to_string();
        let (why, opened) = (Why::Link, None);
        let place = match id {
            "" => Place::Stored,
            id => Place::Apart(Arc::new(Apart {
                id: id.to_string(),
                why,
                opened,
            })),
        };
        Arc::new(Document {
            place,
            ..Document::new(case)
        })
    }

    fn names(waiting: &Waiting) -> Vec<&str> {
        waiting.iter().map(|next| next.case.name.as_str()).collect()
    }

    #[test]
    fn an_edit_of_one_record_does_not_drop_that_of_another() {
        let mut waiting = Waiting::default();
        waiting.put(at("link", "first"));
        waiting.put(at("link", "second"));
        waiting.put(at("", "stored"));
        assert_eq!(names(&waiting), ["second", "stored"]);
        waiting.put(at("link", "third"));
        assert_eq!(names(&waiting), ["stored", "third"]);
        waiting.forget(&Key::current());
        assert_eq!(names(&waiting), ["third"]);
    }

    #[test]
    fn what_was_not_written_comes_first_again_unless_there_is_newer() {
        let mut waiting = Waiting::default();
        waiting.put(at("", "newer"));
        waiting.put_back(at("link", "link"));
        waiting.put_back(at("", "older"));
        assert_eq!(names(&waiting), ["link", "newer"]);
    }

    #[test]
    fn an_older_document_is_written_with_the_runs_of_the_one_that_is_shown() {
        let mut waiting = Waiting::default();
        waiting.put(at("link", "link"));
        let with = |rows: &mut std::collections::BTreeMap<String, Vec<Vec<f64>>>| {
            rows.insert("cone".to_string(), Vec::new());
        };
        let shown = Arc::new(at("", "shown").with_outlines(with));
        waiting.put(shown.clone());
        let first = waiting.take(&shown).unwrap();
        assert_eq!(first.case.name, "link");
        assert!(first.outlines.contains_key("cone"));
        assert_eq!(waiting.take(&shown), Some(shown.clone()));
        assert!(waiting.is_empty() && waiting.take(&shown).is_none());
    }
}
