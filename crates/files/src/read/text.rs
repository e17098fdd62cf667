//! Text as people's programs write it: lines, words and numbers, with errors that name the line.

use wirebend_error::ErrorRemedy;

use super::error::{Location, ReadError};
use super::note::Notes;
pub(crate) use crate::encoding::{decode, utf8};
pub(crate) use crate::limit::LIMIT;

/// The most parts that blocks, uses and components may bring in: a few lines of a file can ask for any number.
const LIMIT_WITHIN: usize = 250_000;

/// Beyond this power of ten nothing is a length or an angle.
const MOST_POWER: i32 = 100;

/// What the last digit of a number stands for: 0.01 where it has two decimals, behind a point or a comma.
pub(crate) fn last_place(number: &str) -> f64 {
    let (figure, power) = number.split_once(['e', 'E']).unwrap_or((number, "0"));
    let behind = figure.split_once(['.', ',']).map_or("", |(_, behind)| behind);
    let decimals = behind.bytes().take_while(u8::is_ascii_digit).count();
    let power = power.parse().unwrap_or(0_i32).clamp(-MOST_POWER, MOST_POWER);
    10.0_f64.powi(power - i32::try_from(decimals).unwrap_or(0).min(MOST_POWER))
}

/// A file's name, for errors, and the errors that readers have in common.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Source<'a> {
    pub(crate) name: &'a str,
}

impl Source<'_> {
    fn file(self) -> String {
        self.name.to_owned()
    }

    pub(crate) fn syntax(
        self,
        place: Location,
        found: &str,
        expected: impl Into<String>,
        remedy: ErrorRemedy,
    ) -> ReadError {
        let expected = expected.into().into_boxed_str();
        ReadError::Syntax {
            file: self.file(),
            place,
            found: excerpt(found),
            expected,
            remedy: Box::new(remedy),
        }
    }

    /// What a parser says of a text, as it says it.
    pub(crate) fn refused(
        self,
        place: Location,
        message: &impl ToString,
        expected: &'static str,
        remedy: ErrorRemedy,
    ) -> ReadError {
        let (found, expected) = (message.to_string(), expected.into());
        ReadError::Syntax { file: self.file(), place, found, expected, remedy: Box::new(remedy) }
    }

    /// Nothing remained; the notes say what was there.
    pub(crate) fn empty(self, expected: &'static str, notes: &Notes) -> ReadError {
        ReadError::Empty { file: self.file(), expected, but: notes.but() }
    }

    pub(crate) fn truncated(self, place: Location, announced: String, available: String) -> ReadError {
        ReadError::Truncated { file: self.file(), place, announced, available }
    }

    pub(crate) fn library(self, library: &'static str, message: &impl ToString) -> ReadError {
        ReadError::Library { file: self.file(), library, message: message.to_string() }
    }

    /// Refuses the one that is too many.
    pub(crate) fn room(self, place: Location, count: usize, what: &'static str) -> Result<(), ReadError> {
        self.room_of(LIMIT, place, count, what)
    }

    /// Refuses the one that is too many of the parts that parts hold.
    pub(crate) fn room_within(
        self,
        place: Location,
        count: usize,
        what: &'static str,
    ) -> Result<(), ReadError> {
        self.room_of(LIMIT_WITHIN, place, count, what)
    }

    fn room_of(
        self,
        limit: usize,
        place: Location,
        count: usize,
        what: &'static str,
    ) -> Result<(), ReadError> {
        if count < limit {
            return Ok(());
        }
        Err(ReadError::TooMany { file: self.file(), place, what, limit })
    }

    pub(crate) fn number(self, line: usize, word: &str) -> Result<f64, ReadError> {
        word.parse().ok().filter(|value: &f64| value.is_finite()).ok_or_else(|| ReadError::Number {
            file: self.file(),
            place: Location::Line(line),
            found: excerpt(word),
            expected: "finite number",
        })
    }

    pub(crate) fn whole(self, line: usize, word: &str) -> Result<i64, ReadError> {
        word.parse().map_err(|_| ReadError::Number {
            file: self.file(),
            place: Location::Line(line),
            found: excerpt(word),
            expected: "whole number",
        })
    }

    /// An index that counts `have` things from 1, or from the last one backwards where `relative`
    /// says that negative ones do; from 0 in the result.
    pub(crate) fn index(
        self,
        line: usize,
        word: &str,
        what: &'static str,
        have: usize,
        relative: bool,
    ) -> Result<u32, ReadError> {
        let index = self.whole(line, word)?;
        let count = i64::try_from(have).unwrap_or(i64::MAX);
        let from_zero = if relative && index < 0 { count + index.max(-count - 1) } else { index.max(0) - 1 };
        u32::try_from(from_zero).ok().filter(|_| from_zero < count).ok_or_else(|| {
            let have = if have == 0 {
                format!("there is no {what} yet")
            } else {
                format!("they go from 1 to {have}")
            };
            ReadError::Index {
                file: self.file(),
                place: Location::Line(line),
                found: excerpt(word),
                what,
                have,
            }
        })
    }
}

/// What an error shows of a text: its beginning, in quotes.
pub(crate) fn excerpt(text: &str) -> String {
    const SHOWN: usize = 40;
    let text = text.trim();
    if text.is_empty() {
        return "nothing".to_owned();
    }
    let mut shown: String = text.chars().take(SHOWN).map(|c| if c.is_control() { '·' } else { c }).collect();
    if text.chars().nth(SHOWN).is_some() {
        shown.push('…');
    }
    format!("\"{shown}\"")
}

/// Lines with their numbers from 1, whichever of LF, CR LF and CR ends them.
pub(crate) fn lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let end = if text.contains('\n') { '\n' } else { '\r' };
    text.split(end).enumerate().map(|(k, line)| (k + 1, line.strip_suffix('\r').unwrap_or(line)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_line_end_counts_the_same() {
        for text in ["a\nb\nc", "a\r\nb\r\nc", "a\rb\rc"] {
            assert_eq!(lines(text).collect::<Vec<_>>(), [(1, "a"), (2, "b"), (3, "c")]);
        }
    }

    #[test]
    fn indices_count_from_one_and_backwards() {
        let source = Source { name: "x.obj" };
        let index = |word, relative| source.index(1, word, "vertex", 3, relative).ok();
        assert_eq!(
            [index("1", true), index("3", true), index("-1", true), index("-3", true)],
            [Some(0), Some(2), Some(2), Some(0)]
        );
        for bad in ["0", "4", "-4", "1.5", "", "x", "9223372036854775807", "-9223372036854775808"] {
            assert_eq!(index(bad, true), None, "{bad}");
        }
        assert_eq!(index("-1", false), None);
    }

    #[test]
    fn utf_16_is_text() {
        let words: Vec<u16> = "v 1 ä 😀\n".encode_utf16().collect();
        let little: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
        let big: Vec<u8> = words.iter().flat_map(|word| word.to_be_bytes()).collect();
        for bytes in [[b"\xff\xfe", little.as_slice()].concat(), [b"\xfe\xff", big.as_slice()].concat()] {
            assert_eq!(decode(&bytes), "v 1 ä 😀\n");
        }
        // Without a mark the beginning tells.
        let plain: Vec<u8> = "v 0 0 0\nv 1 0 0\n# ä".encode_utf16().flat_map(u16::to_le_bytes).collect();
        assert_eq!(decode(&plain), "v 0 0 0\nv 1 0 0\n# ä");
        assert_eq!(decode(b"\xef\xbb\xbfv 1"), "v 1");
        // Half a character at the end, and half of a pair.
        assert_eq!(decode(b"\xff\xfea\0b"), "a?");
        assert_eq!(decode(b"\xff\xfe\0\xd8a\0"), "\u{fffd}a");
        for other in [b"".as_slice(), b"a", b"a\0", b"\0\0\0\0", b"\xff\xfe\0\0a\0\0\0"] {
            assert_eq!(utf8(other), other);
        }
    }

    #[test]
    fn errors_show_a_short_and_printable_part() {
        assert_eq!(excerpt(" \t"), "nothing");
        assert_eq!(excerpt("a\u{7}b"), "\"a·b\"");
        assert_eq!(excerpt(&"é".repeat(50)).chars().count(), 43);
    }

    #[test]
    fn the_last_digit_of_a_number_stands_for_this() {
        for (number, place) in [
            ("60", 1.0),
            ("-1.250", 0.001),
            ("1,5", 0.1),
            ("1.25e-3", 1e-5),
            ("2E2", 100.0),
            ("1e999", 1e100),
        ] {
            assert!((last_place(number) / place - 1.0).abs() < 1e-9, "{number}");
        }
    }
}
