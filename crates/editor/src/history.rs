//! Undo and redo, without limit.

use wirebend_files::document::{Document, DocumentChange, StaleChange};

/// A change with what a menu calls it.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Done {
    pub label: String,
    pub change: DocumentChange,
}

/// What was done and may be undone, and what was undone and may be done again.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct History {
    done: Vec<Numbered>,
    undone: Vec<Numbered>,
    /// How many changes there ever were.
    count: u64,
}

/// No two changes have the same number, those that were undone and replaced included.
#[derive(Debug, Clone, PartialEq)]
struct Numbered {
    number: u64,
    done: Done,
}

impl History {
    /// Makes a change. What was undone before cannot be done again.
    pub fn make(&mut self, document: &mut Document, done: Done) -> Result<(), StaleChange> {
        document.commit(&done.change)?;
        self.count += 1;
        self.done.push(Numbered { number: self.count, done });
        self.undone.clear();
        Ok(())
    }

    /// Undoes the last change; gives the difference that was made, or none where nothing was done.
    pub fn undo(&mut self, document: &mut Document) -> Result<Option<DocumentChange>, StaleChange> {
        let Some(last) = self.done.last() else { return Ok(None) };
        let back = last.done.change.inverse();
        document.commit(&back)?;
        self.undone.extend(self.done.pop());
        Ok(Some(back))
    }

    /// Does again what was undone last; gives the difference that was made.
    pub fn redo(&mut self, document: &mut Document) -> Result<Option<DocumentChange>, StaleChange> {
        let Some(last) = self.undone.last() else { return Ok(None) };
        let change = last.done.change.clone();
        document.commit(&change)?;
        self.done.extend(self.undone.pop());
        Ok(Some(change))
    }

    /// What would be undone.
    pub fn undo_label(&self) -> Option<&str> {
        self.done.last().map(|last| last.done.label.as_str())
    }

    /// What would be done again.
    pub fn redo_label(&self) -> Option<&str> {
        self.undone.last().map(|last| last.done.label.as_str())
    }

    /// Whether there is nothing to undo or to do again.
    pub fn is_empty(&self) -> bool {
        self.done.is_empty() && self.undone.is_empty()
    }

    /// Names the state that the document is in: the same number is the same document.
    pub fn state(&self) -> u64 {
        self.done.last().map_or(0, |last| last.number)
    }
}
