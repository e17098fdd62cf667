//! Letters of the fonts that every PDF viewer has: which there are, and how wide they are.

use std::collections::BTreeSet;

/// Widths of the printable ASCII letters, from the space on, in thousandths of the size: the metrics of Helvetica,
/// which every font that stands in for it keeps.
const WIDTHS: [u16; 95] = [
    278, 278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333, 278, 278, // to the slash
    556, 556, 556, 556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556, // digits
    1015, 667, 667, 722, 722, 667, 611, 778, 722, 278, 500, 667, 556, 833, 722, 778, // @ to O
    667, 778, 722, 667, 611, 722, 667, 944, 667, 667, 611, 278, 278, 278, 469,
    556, // P to the underscore
    333, 556, 556, 500, 556, 556, 278, 556, 556, 222, 222, 500, 222, 833, 556, 556, // grave accent to o
    556, 556, 333, 500, 278, 556, 500, 722, 500, 500, 500, 334, 260, 334, 584, // p to the tilde
];
/// Words in bold are wider by about this: its narrow letters by a quarter, its wide ones hardly, its digits not at all.
const BOLD: f64 = 1.12;

/// Text in the encoding of the fonts (Windows-1252). What they do not have becomes a question mark and is kept
/// in `missing`; a few signs have another spelling.
pub(crate) fn encoded(text: &str, missing: &mut BTreeSet<char>) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(text.len());
    for c in text.chars() {
        match c {
            ' '..='~' => bytes.push(c as u8),
            '\t' | '\n' | '\r' | '\u{a0}' | '\u{2009}' | '\u{202f}' => bytes.push(b' '),
            // Latin-1 has the same numbers.
            '\u{a1}'..='\u{ff}' => bytes.push(u8::try_from(u32::from(c)).unwrap_or(b'?')),
            '−' | '‐' | '\u{2011}' => bytes.push(b'-'),
            '≤' => bytes.extend(b"<="),
            '≥' => bytes.extend(b">="),
            '→' => bytes.extend(b"->"),
            '⌀' => bytes.push(0xd8),
            '€' => bytes.push(0x80),
            '…' => bytes.push(0x85),
            '‘' => bytes.push(0x91),
            '’' => bytes.push(0x92),
            '“' => bytes.push(0x93),
            '”' => bytes.push(0x94),
            '•' => bytes.push(0x95),
            '–' => bytes.push(0x96),
            '—' => bytes.push(0x97),
            _ => {
                missing.insert(c);
                bytes.push(b'?');
            }
        }
    }
    bytes
}

/// How wide a text is in the unit of `size`; of bold text and of accented letters a little more than it is.
pub(crate) fn width(text: &str, size: f64, bold: bool) -> f64 {
    let letter = |byte: u8| match byte {
        b' '..=b'~' => f64::from(WIDTHS[usize::from(byte - b' ')]),
        0xb0 => 400.0,                       // degree
        0xb7 => 278.0,                       // middle dot
        0xb1 | 0xd7 => 584.0,                // plus-minus, times
        0x85 | 0x97 | 0xc6 | 0xe6 => 1000.0, // …, —, Æ, æ
        0xc0..=0xde => 778.0,
        _ => 611.0,
    };
    let bytes = encoded(text, &mut BTreeSet::new());
    let sum: f64 = bytes
        .into_iter()
        .map(|byte| if bold && !byte.is_ascii_digit() { letter(byte) * BOLD } else { letter(byte) })
        .sum();
    sum * size / 1000.0
}

/// The text, cut so that it fits.
pub(crate) fn cut(text: &str, size: f64, bold: bool, room: f64) -> String {
    if width(text, size, bold) <= room {
        return text.to_owned();
    }
    let mut short = text.to_owned();
    while !short.is_empty() && width(&short, size, bold) + size > room {
        short.pop();
    }
    format!("{}…", short.trim_end())
}

/// The text in lines that fit; a word that is longer than a line is broken. However narrow a line is, it has a letter.
pub(crate) fn lines(text: &str, size: f64, bold: bool, room: f64) -> Vec<String> {
    let fits = |text: &str| width(text, size, bold) <= room;
    let (mut lines, mut line) = (Vec::new(), String::new());
    for word in text.split_whitespace() {
        let longer = if line.is_empty() { word.to_owned() } else { format!("{line} {word}") };
        if fits(&longer) {
            line = longer;
            continue;
        }
        if !line.is_empty() {
            lines.push(std::mem::take(&mut line));
        }
        for c in word.chars() {
            if !line.is_empty() && !fits(&format!("{line}{c}")) {
                lines.push(std::mem::take(&mut line));
            }
            line.push(c);
        }
    }
    lines.push(line);
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_the_fonts_do_not_have_is_told() {
        let mut missing = BTreeSet::new();
        assert_eq!(encoded("Ø 3 mm, 90° × 2 − …", &mut missing), b"\xd8 3 mm, 90\xb0 \xd7 2 - \x85");
        assert!(missing.is_empty());
        assert_eq!(encoded("針金 a", &mut missing), b"?? a");
        assert_eq!(missing.into_iter().collect::<String>(), "金針");
    }

    #[test]
    fn lines_are_no_wider_than_their_room_and_nothing_is_lost() {
        let text = "the machine cannot feed less than 25.0 mm aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa é";
        for room in [12.0, 30.0, 100.0] {
            let lines = lines(text, 3.0, false, room);
            assert!(lines.iter().all(|line| width(line, 3.0, false) <= room), "{room}: {lines:?}");
            let bare = |text: &str| text.replace(' ', "");
            assert_eq!(bare(&lines.concat()), bare(text));
        }
        assert_eq!(lines("", 3.0, false, 10.0), [""]);
        assert_eq!(lines("ab", 3.0, false, 0.1), ["a", "b"]);
    }

    #[test]
    fn digits_are_as_wide_as_a_space_twice() {
        assert!((width("0123456789", 10.0, true) - 55.6).abs() < 1e-9);
        assert!((width("  ", 10.0, false) - 5.56).abs() < 1e-9);
        let short = cut("a title that is too long for its line", 4.0, true, 30.0);
        assert!(short.ends_with('…') && width(&short, 4.0, true) <= 30.0);
    }
}
