//! Bytes as text, in the encodings that files come in.

use std::borrow::Cow;

/// How many words of a text without a byte order mark tell that it is in UTF-16.
const TELLING: usize = 16;

/// Text in UTF-16 as UTF-8, and UTF-8 without its byte order mark; all else as it is. Half a character becomes a
/// replacement character, which is in no number.
pub(crate) fn utf8(bytes: &[u8]) -> Cow<'_, [u8]> {
    let Some(word) = utf16(bytes) else {
        return Cow::Borrowed(bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes));
    };
    let words = bytes.chunks(2).map(|pair| pair.try_into().map_or(u16::from(b'?'), word));
    let text = char::decode_utf16(words).map(|c| c.unwrap_or(char::REPLACEMENT_CHARACTER));
    let text: String = text.skip_while(|c| *c == '\u{feff}').collect();
    Cow::Owned(text.into_bytes())
}

/// How two bytes are a word, if the bytes are UTF-16: by their mark, else by a beginning in ASCII.
fn utf16(bytes: &[u8]) -> Option<fn([u8; 2]) -> u16> {
    // Four bytes FF FE 0 0 are the mark of UTF-32.
    if bytes.starts_with(b"\xff\xfe") && !bytes.starts_with(b"\xff\xfe\0\0") {
        return Some(u16::from_le_bytes);
    }
    if bytes.starts_with(b"\xfe\xff") {
        return Some(u16::from_be_bytes);
    }
    let begins = |high: usize| {
        let mut words = bytes.chunks_exact(2).take(TELLING);
        let plain = |byte: u8| byte.is_ascii_graphic() || byte.is_ascii_whitespace();
        bytes.len() >= 4 && words.all(|word| word[high] == 0 && plain(word[1 - high]))
    };
    match (begins(1), begins(0)) {
        (true, _) => Some(u16::from_le_bytes),
        (_, true) => Some(u16::from_be_bytes),
        _ => None,
    }
}

/// Bytes as text, see `utf8`. What is not UTF-8 is replaced: it can only be in names and comments, or an error will
/// show it.
#[must_use]
pub fn decode(bytes: &[u8]) -> Cow<'_, str> {
    match utf8(bytes) {
        Cow::Borrowed(bytes) => String::from_utf8_lossy(bytes),
        Cow::Owned(bytes) => Cow::Owned(String::from_utf8_lossy(&bytes).into_owned()),
    }
}
