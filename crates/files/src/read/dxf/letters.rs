//! The letters of a drawing: UTF-8 since release 2007, before it those of the code page that its header names.

use std::borrow::Cow;

use encoding_rs::{Encoding, WINDOWS_1252};

use super::super::text::{decode, utf8};

/// The header's variable. Its values are `ANSI_` and a number, in either case.
const CODE_PAGE: &[u8] = b"$DWGCODEPAGE";
/// The value is not farther behind the variable than this.
const VALUE_WITHIN: usize = 32;
/// How the letters are written that a code page lacks, before the four digits of their number.
const ESCAPE: &str = "\\U+";

/// How the text of a file is to be read that is not UTF-8: by its code page, without one as most have been written. None where the
/// page is not known: what is not ASCII is replaced then.
#[derive(Debug, Clone, Copy)]
pub(super) struct Letters(Option<&'static Encoding>);

impl Letters {
    pub(super) fn of(bytes: &[u8]) -> Self {
        let Some(at) = find(bytes, CODE_PAGE) else { return Self(Some(WINDOWS_1252)) };
        let behind = &bytes[at + CODE_PAGE.len()..];
        let behind = &behind[..behind.len().min(VALUE_WITHIN)];
        let digits = find(behind, b"_").map(|at| &behind[at + 1..]).unwrap_or_default();
        let digits = digits.iter().take_while(|byte| byte.is_ascii_digit()).copied().map(char::from);
        let label = match digits.collect::<String>().as_str() {
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
        let letter = part.get(..4).and_then(|digits| u32::from_str_radix(digits, 16).ok());
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

fn find(bytes: &[u8], what: &[u8]) -> Option<usize> {
    bytes.windows(what.len()).position(|window| window == what)
}
