//! From the entries of a journal to what happened.

use wirebend_journal::Lines;

use super::super::entry::{Entry, EntryKind, VERSION};
use super::super::journal_state::JournalState;

/// A journal that has been read.
#[derive(Debug, Clone, PartialEq)]
pub struct Written {
    /// What happened, in order.
    pub entries: Vec<Entry>,
    /// What that comes to.
    pub state: JournalState,
    /// The last line was not written to its end, and counts for nothing: what it says had not happened yet when
    /// it was being written, or was not known to have.
    pub torn: bool,
}

/// What is wrong with a journal.
#[derive(Debug)]
pub(super) struct Wrong {
    /// The line, from 1.
    pub line: usize,
    pub what: String,
    /// A later program has written it.
    pub newer: bool,
}

impl Written {
    /// Counts the entries.
    pub(super) fn of(lines: &Lines) -> Result<Self, Wrong> {
        let mut entries: Vec<Entry> = Vec::new();
        let mut state = None;
        for (index, body) in lines.entries.iter().enumerate() {
            let damaged = |what| Wrong { line: index + 1, what, newer: false };
            let entry: Entry = serde_json::from_str(body)
                .map_err(|error| damaged(format!("its entry cannot be read: {error}")))?;
            if let (None, EntryKind::Job(heading)) = (&state, &entry.what)
                && heading.version > VERSION
            {
                let what = format!("it is of version {}, this program knows {VERSION}", heading.version);
                return Err(Wrong { line: index + 1, what, newer: true });
            }
            state = Some(counted(state, &entry.what).map_err(damaged)?);
            entries.push(entry);
        }
        let state =
            state.ok_or_else(|| Wrong { line: 1, what: "there is no line".to_owned(), newer: false })?;
        Ok(Self { entries, state, torn: lines.torn })
    }
}

/// The state after one more entry.
pub(super) fn counted(state: Option<JournalState>, what: &EntryKind) -> Result<JournalState, String> {
    match (state, what) {
        (None, EntryKind::Job(heading)) => Ok(JournalState::new(heading.clone())),
        (None, _) => Err("a journal begins with its job".to_owned()),
        (Some(mut state), what) => state.count(what).map(|()| state),
    }
}
