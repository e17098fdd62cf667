//! From the bytes of a log to its entries.

use crate::chain::Chain;

/// A log that has been read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Lines {
    /// The entries of the whole lines, in order; there is one at least.
    pub entries: Vec<String>,
    /// The last line was not written to its end, and counts for nothing: its writer had not continued yet.
    pub torn: bool,
    pub(crate) chain: Chain,
    /// How many bytes the whole lines have.
    pub(crate) length: usize,
}

impl Lines {
    /// Reads the bytes of a log.
    ///
    /// # Errors
    /// The line, from 1, and what is wrong with it; `None` when there is not one whole line.
    pub fn of(bytes: &[u8]) -> Result<Self, Option<(usize, String)>> {
        let mut lines = Self { entries: Vec::new(), torn: false, chain: Chain::default(), length: 0 };
        let mut rest = bytes;
        while let Some(end) = rest.iter().position(|byte| *byte == b'\n') {
            let (line, after) = (&rest[..end], &rest[end + 1..]);
            // Where a file was made longer and not filled any more, a power cut leaves zeros; only at its end.
            if line.contains(&0) && !after.contains(&b'\n') {
                break;
            }
            lines.add(line).map_err(|what| Some((lines.entries.len() + 1, what)))?;
            lines.length += end + 1;
            rest = after;
        }
        lines.torn = !rest.is_empty();
        if lines.entries.is_empty() { Err(None) } else { Ok(lines) }
    }

    fn add(&mut self, line: &[u8]) -> Result<(), String> {
        let text = std::str::from_utf8(line).map_err(|_| "it is no text".to_owned())?;
        let (body, next) = self.chain.body(text)?;
        self.entries.push(body.to_owned());
        self.chain = next;
        Ok(())
    }
}
