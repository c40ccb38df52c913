//! Undo and redo over immutable documents.

use super::document::Document;
use std::sync::Arc;

/// Largest number of undo steps.
const STEPS_MAX: usize = 500;

/// Document with its past and its undone future.
#[derive(Clone, Debug)]
pub struct History {
    past: Vec<Step>,
    present: Arc<Document>,
    future: Vec<Step>,
    /// Tag of edits that still extend the last step.
    open: Option<String>,
}

/// Named change with the document on its other side.
#[derive(Clone, Debug)]
struct Step {
    label: String,
    document: Arc<Document>,
}

impl History {
    /// A history with only a document.
    pub fn new(document: Document) -> History {
        History {
            past: Vec::new(),
            present: Arc::new(document),
            future: Vec::new(),
            open: None,
        }
    }

    /// Current document.
    pub fn present(&self) -> &Arc<Document> {
        &self.present
    }

    /// Whether nothing has been changed.
    pub fn is_pristine(&self) -> bool {
        self.past.is_empty() && self.future.is_empty()
    }

    /// Name of the change that undo reverts.
    pub fn undo_label(&self) -> Option<&str> {
        self.past.last().map(|step| step.label.as_str())
    }

    /// Name of the change that redo repeats.
    pub fn redo_label(&self) -> Option<&str> {
        self.future.last().map(|step| step.label.as_str())
    }

    /// Replaces the document. Consecutive edits with the same `tag` are one step until [`History::close`].
    pub fn edit(&mut self, label: &str, tag: Option<&str>, document: Document) {
        if document == *self.present {
            return;
        }
        let goes_on = tag.is_some() && self.open.as_deref() == tag && !self.past.is_empty();
        let before = std::mem::replace(&mut self.present, Arc::new(document));
        if goes_on {
            // back at the beginning of the step: nothing to undo
            if self
                .past
                .last()
                .is_some_and(|step| step.document == self.present)
            {
                self.past.pop();
                self.open = None;
            }
        } else {
            self.past.push(Step {
                label: label.to_string(),
                document: before,
            });
            if self.past.len() > STEPS_MAX {
                self.past.remove(0);
            }
            self.open = tag.map(str::to_string);
        }
        self.future.clear();
    }

    /// Changes every document, including past and future; those for which `change` returns `None` stay.
    pub fn change_all(&mut self, change: impl Fn(&Document) -> Option<Document>) {
        let steps = self.past.iter_mut().chain(&mut self.future);
        let documents = steps.map(|step| &mut step.document);
        for document in documents.chain([&mut self.present]) {
            if let Some(changed) = change(document) {
                *document = Arc::new(changed);
            }
        }
    }

    /// Ends a sequence of edits: the next edit is a new step.
    pub fn close(&mut self) {
        self.open = None;
    }

    /// Undoes the last change.
    pub fn undo(&mut self) {
        self.open = None;
        if let Some(Step { label, document }) = self.past.pop() {
            let document = std::mem::replace(&mut self.present, document);
            self.future.push(Step { label, document });
        }
    }

    /// Repeats the last undone change.
    pub fn redo(&mut self) {
        self.open = None;
        if let Some(Step { label, document }) = self.future.pop() {
            let document = std::mem::replace(&mut self.present, document);
            self.past.push(Step { label, document });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use msape::Case;

    fn with_speed(document: &Document, text: &str) -> Document {
        document.with_case(|case| case.set("entry.speed_m_s", text))
    }

    fn speed(history: &History) -> Option<String> {
        history.present().case.text("entry.speed_m_s")
    }

    #[test]
    fn a_drag_is_one_step() {
        let mut history = History::new(Document::new(Case::run_page()));
        for text in ["12100", "12200", "12300"] {
            let next = with_speed(history.present(), text);
            history.edit("Entry Velocity", Some("speed"), next);
        }
        history.undo();
        assert_eq!(speed(&history).as_deref(), Some("12000"));
        history.redo();
        assert_eq!(speed(&history).as_deref(), Some("12300"));
        assert_eq!(history.undo_label(), Some("Entry Velocity"));
    }

    #[test]
    fn a_new_edit_forgets_the_undone_ones() {
        let mut history = History::new(Document::new(Case::run_page()));
        let next = with_speed(history.present(), "13000");
        history.edit("a", None, next);
        history.undo();
        let next = with_speed(history.present(), "14000");
        history.edit("b", None, next);
        assert_eq!(history.redo_label(), None);
        assert_eq!(speed(&history).as_deref(), Some("14000"));
    }

    #[test]
    fn past_and_future_are_changed_too() {
        let mut history = History::new(Document::new(Case::run_page()));
        for text in ["13000", "14000"] {
            let next = with_speed(history.present(), text);
            history.edit(text, None, next);
        }
        history.undo();
        let name = |case: &mut Case| case.name = "all".to_string();
        history.change_all(|document| Some(document.with_case(name)));
        history.redo();
        for text in ["14000", "13000", "12000"] {
            assert_eq!(speed(&history).as_deref(), Some(text));
            assert_eq!(history.present().case.name, "all");
            history.undo();
        }
    }

    #[test]
    fn an_edit_that_changes_nothing_is_no_step() {
        let mut history = History::new(Document::new(Case::run_page()));
        let same = with_speed(history.present(), "12000");
        history.edit("a", None, same);
        assert!(history.is_pristine());
    }
}
