//! The letters of a drawing: UTF-8 since release 2007, before it those of the code page that its header names.

use std::borrow::Cow;

use encoding_rs::{Encoding, WINDOWS_1252};

use super::super::text::{decode, utf8};

/// The header's variable. Its values are `ANSI_` and a number, in either case.
const CODE_PAGE: &[u8] = b"$DWGCODEPAGE";
/// The header's variable with the release, whose values are `AC` and a number; from this on a text is UTF-8.
const RELEASE: &[u8] = b"$ACADVER";
const UTF8_SINCE: u32 = 1021;
/// The value is not farther behind its variable than this.
const VALUE_WITHIN: usize = 32;
/// How the letters are written that a code page lacks, before the four digits of their number.
const ESCAPE: &str = "\\U+";

/// How the text of a file is to be read that is not UTF-8: by its code page, without one by Windows-1252, the most common. None where the
/// page is not known: what is not ASCII is replaced then.
#[derive(Debug, Clone, Copy)]
pub(super) struct Letters(Option<&'static Encoding>);

impl Letters {
    pub(super) fn of(bytes: &[u8]) -> Self {
        if release(bytes).is_some_and(|release| release >= UTF8_SINCE) {
            return Self(None);
        }
        let Some(page) = value(bytes, CODE_PAGE, b"_") else { return Self(Some(WINDOWS_1252)) };
        let label = match page.as_str() {
            "932" => "shift_jis".to_owned(),
            "936" => "gbk".to_owned(),
            "949" => "euc-kr".to_owned(),
            "950" => "big5".to_owned(),
            page => format!("windows-{page}"),
        };
        Self(Encoding::for_label(label.as_bytes()))
    }

    /// Some of the bytes as text.
    pub(super) fn text(self, bytes: &[u8]) -> Cow<'_, str> {
        match self.0 {
            Some(encoding) if std::str::from_utf8(&utf8(bytes)).is_err() => {
                encoding.decode_without_bom_handling(bytes).0
            }
            _ => decode(bytes),
        }
    }
}

/// A text with the letters that the code page lacks.
pub(super) fn unescaped(text: &str) -> String {
    let mut parts = text.split(ESCAPE);
    let mut whole = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let digits = part.get(..4).filter(|digits| digits.bytes().all(|byte| byte.is_ascii_hexdigit()));
        let letter = digits.and_then(|digits| u32::from_str_radix(digits, 16).ok());
        if let Some(letter) = letter.and_then(char::from_u32) {
            whole.push(letter);
            whole.push_str(&part[4..]);
        } else {
            whole.push_str(ESCAPE);
            whole.push_str(part);
        }
    }
    whole
}

fn release(bytes: &[u8]) -> Option<u32> {
    value(bytes, RELEASE, b"AC")?.parse().ok()
}

/// The digits of a variable's value behind what it begins with; none where there is no such variable.
fn value(bytes: &[u8], variable: &[u8], begin: &[u8]) -> Option<String> {
    let behind = &bytes[find(bytes, variable)? + variable.len()..];
    let behind = &behind[..behind.len().min(VALUE_WITHIN)];
    let digits = find(behind, begin).map(|at| &behind[at + begin.len()..]).unwrap_or_default();
    Some(digits.iter().take_while(|byte| byte.is_ascii_digit()).copied().map(char::from).collect())
}

fn find(bytes: &[u8], what: &[u8]) -> Option<usize> {
    bytes.windows(what.len()).position(|window| window == what)
}
