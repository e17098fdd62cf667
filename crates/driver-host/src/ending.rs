//! How the process of a driver came to its end.

use std::process::ExitStatus;

/// The most that is kept of what a driver printed.
const MAX_SAID: usize = 8 << 10;
/// The most of it that a message shows.
const SHOWN: usize = 600;

/// Why a process is no longer there.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Ending {
    /// It ended by itself.
    Died(String),
    /// It wrote something that is no frame.
    Garbage,
    /// It wrote a frame beyond all measure.
    TooLarge(usize),
    /// It was ended because it took too long, or because it is not needed any more.
    Killed,
}

pub(crate) fn in_words(status: ExitStatus) -> String {
    #[cfg(unix)]
    {
        use std::os::unix::process::ExitStatusExt;
        if let Some(signal) = status.signal() {
            let name = match signal {
                4 => " (illegal instruction)",
                6 => " (aborted, as after running out of memory)",
                7 => " (bus error)",
                8 => " (arithmetic error)",
                9 => " (killed)",
                11 => " (segmentation fault)",
                _ => "",
            };
            return format!("was ended by signal {signal}{name}");
        }
    }
    match status.code() {
        Some(code) => format!("ended by itself with status {code}"),
        None => "ended by itself".to_owned(),
    }
}

/// The last of what a process printed.
#[derive(Debug, Default)]
pub(crate) struct LastWords(Vec<u8>);

impl LastWords {
    pub fn add(&mut self, bytes: &[u8]) {
        self.0.extend_from_slice(bytes);
        if self.0.len() > MAX_SAID {
            self.0.drain(..self.0.len() - MAX_SAID);
        }
    }

    /// Its end as a text for a message, on lines of its own; empty when nothing was printed.
    pub fn shown(&self) -> String {
        let text = String::from_utf8_lossy(&self.0);
        let printable: String =
            text.chars().map(|c| if c.is_control() && c != '\n' { '\u{fffd}' } else { c }).collect();
        let text = printable.trim();
        let skipped = text.chars().count().saturating_sub(SHOWN);
        let end: String = text.chars().skip(skipped).collect();
        if end.is_empty() { end } else { format!("; it said last:\n{end}") }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_end_of_what_was_said_is_kept() {
        let mut words = LastWords::default();
        assert_eq!(words.shown(), "");
        (0..10_000).for_each(|k| words.add(format!("line {k}\n").as_bytes()));
        words.add(b"\x1b[31mred\xff");
        let shown = words.shown();
        assert!(words.0.len() <= MAX_SAID && shown.len() < 2 * SHOWN);
        assert!(
            shown.contains("line 9999") && shown.ends_with("[31mred\u{fffd}") && !shown.contains('\x1b'),
            "{shown}"
        );
    }
}
