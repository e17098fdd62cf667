//! From the bytes of a journal to what happened.

use super::entry::{Entry, VERSION, What};
use super::line::Chain;
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
    pub(super) chain: Chain,
    /// How many bytes the whole lines have.
    pub(super) length: usize,
}

/// Why it cannot be read: the line, from 1, and what is wrong. `None` when there is not one whole line.
pub(super) type Unreadable = Option<(usize, String)>;

pub(super) fn read(bytes: &[u8]) -> Result<Written, Unreadable> {
    let mut chain = Chain::default();
    let mut entries: Vec<Entry> = Vec::new();
    let mut account = None;
    let mut length = 0;
    let mut rest = bytes;
    while let Some(end) = rest.iter().position(|byte| *byte == b'\n') {
        let (line, number) = (&rest[..end], entries.len() + 1);
        // Where a file was made longer and not filled any more, a power cut leaves zeros; only at its end.
        if line.contains(&0) && !rest[end + 1..].contains(&b'\n') {
            break;
        }
        let (entry, next) = entry_of(&chain, line).map_err(|what| Some((number, what)))?;
        account = Some(counted(account, &entry.what).map_err(|what| Some((number, what)))?);
        entries.push(entry);
        chain = next;
        length += end + 1;
        rest = &rest[end + 1..];
    }
    let account = account.ok_or(None)?;
    Ok(Written { entries, account, torn: !rest.is_empty(), chain, length })
}

fn entry_of(chain: &Chain, line: &[u8]) -> Result<(Entry, Chain), String> {
    let text = std::str::from_utf8(line).map_err(|_| "it is no text".to_owned())?;
    let (body, next) = chain.body(text)?;
    let entry = serde_json::from_str(body).map_err(|error| format!("its entry cannot be read: {error}"))?;
    Ok((entry, next))
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
