//! From the entries of a journal to what happened.

use wirebend_journal::Lines;

use super::entry::{Entry, VERSION, What};
use crate::jobs::account::Account;

/// A journal that has been read.
#[derive(Debug, Clone, PartialEq)]
pub struct Written {
    /// What happened, in order.
    pub entries: Vec<Entry>,
    /// What that comes to.
    pub account: Account,
    /// The last line was not written to its end, and counts for nothing: what it says had not happened yet when
    /// it was being written, or was not known to have.
    pub torn: bool,
}

impl Written {
    /// Counts the entries; or gives the line, from 1, and what is wrong with it.
    pub(super) fn of(lines: &Lines) -> Result<Self, (usize, String)> {
        let mut entries: Vec<Entry> = Vec::new();
        let mut account = None;
        for (index, body) in lines.entries.iter().enumerate() {
            let damaged = |what| (index + 1, what);
            let entry: Entry = serde_json::from_str(body)
                .map_err(|error| damaged(format!("its entry cannot be read: {error}")))?;
            account = Some(counted(account, &entry.what).map_err(damaged)?);
            entries.push(entry);
        }
        let account = account.ok_or_else(|| (1, "there is no line".to_owned()))?;
        Ok(Self { entries, account, torn: lines.torn })
    }
}

/// The account after one more entry.
pub(super) fn counted(account: Option<Account>, what: &What) -> Result<Account, String> {
    match (account, what) {
        (None, What::Job(heading)) if heading.version > VERSION => {
            Err(format!("it is of version {}, this program knows {VERSION}: update it", heading.version))
        }
        (None, What::Job(heading)) => Ok(Account::new(heading.clone())),
        (None, _) => Err("a journal begins with its job".to_owned()),
        (Some(mut account), what) => account.count(what).map(|()| account),
    }
}
