//! A line of a journal: a number, a hash over it and all lines before, and the entry as JSON.
//!
//! The hash tells a line that was not written to its end, as in a power cut, from one that was changed later,
//! and shows when one is missing. It is no signature: anyone can write another journal.

use std::fmt::Write as _;

use sha2::{Digest, Sha256};

/// Half of a SHA-256 in hexadecimal: far more than accidents need.
const HEX: usize = 32;

/// The number and the hash of the last line; of none at the start.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) struct Chain {
    pub number: u64,
    hash: String,
}

impl Chain {
    fn next(&self, body: &str) -> Self {
        let number = self.number + 1;
        let mut digest = Sha256::new();
        digest.update(format!("{}\n{number}\n{body}", self.hash));
        let mut hash = String::new();
        for byte in digest.finalize().iter().take(HEX / 2) {
            // A text takes what is written to it.
            let _ = write!(hash, "{byte:02x}");
        }
        Self { number, hash }
    }

    /// The next line with its end, and the chain after it. `body` is JSON without an end of line in it.
    pub fn line(&self, body: &str) -> (String, Self) {
        let next = self.next(body);
        (format!("{}{body}}}\n", next.head()), next)
    }

    fn head(&self) -> String {
        format!("{{\"line\":{},\"chain\":\"{}\",\"entry\":", self.number, self.hash)
    }

    /// The body of the next line, without its end, and the chain after it; or what is wrong with it.
    pub fn body<'a>(&self, line: &'a str) -> Result<(&'a str, Self), String> {
        const ENTRY: &str = ",\"entry\":";
        let body =
            line.find(ENTRY).map(|at| &line[at + ENTRY.len()..]).and_then(|rest| rest.strip_suffix('}'));
        let body = body.ok_or_else(|| "it is not a line of a journal".to_owned())?;
        let next = self.next(body);
        if line.starts_with(&next.head()) {
            return Ok((body, next));
        }
        Err("its hash does not fit: it was changed, or a line before it is missing".to_owned())
    }
}
