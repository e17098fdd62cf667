//! Just enough of Rust's lexical rules to search code without comments, strings and tests.

use std::ops::Range;

/// The source with comments and the insides of strings and characters replaced by spaces; lines stay where they were.
pub(super) fn code_only(source: &str) -> String {
    let bytes = source.as_bytes();
    let mut code = bytes.to_vec();
    let mut at = 0;
    while at < bytes.len() {
        let end = skip_text(bytes, at);
        blank(&mut code[at..end]);
        at = end.max(at + 1);
    }
    String::from_utf8_lossy(&code).into_owned()
}

/// `code` (from [`code_only`]) with every item under `#[cfg(test)]` replaced by spaces.
pub(super) fn without_tests(code: &str) -> String {
    let mut kept = code.as_bytes().to_vec();
    for item in test_items(code) {
        blank(&mut kept[item]);
    }
    String::from_utf8_lossy(&kept).into_owned()
}

/// Where the items under `#[cfg(test)]` of `code` (from [`code_only`]) stand, with that attribute.
pub(super) fn test_items(code: &str) -> Vec<Range<usize>> {
    let (mut items, mut from) = (Vec::new(), 0);
    while let Some(found) = code[from..].find("#[cfg(test)]") {
        let start = from + found;
        let end = item_end(code.as_bytes(), start + "#[cfg(test)]".len());
        items.push(start..end);
        from = end;
    }
    items
}

/// Where the attributes of `code` (from [`code_only`]) stand.
pub(super) fn attributes(code: &str) -> Vec<Range<usize>> {
    let bytes = code.as_bytes();
    let starts = code.match_indices('#').map(|(at, _)| at);
    let opened = starts.filter(|&at| {
        let inner = at + 1 + usize::from(bytes.get(at + 1) == Some(&b'!'));
        bytes.get(inner) == Some(&b'[')
    });
    let closed = |at: usize| {
        let mut depth = 0_usize;
        for (offset, byte) in bytes[at..].iter().enumerate() {
            match byte {
                b'[' => depth += 1,
                b']' if depth == 1 => return at + offset + 1,
                b']' => depth -= 1,
                _ => {}
            }
        }
        bytes.len()
    };
    opened.map(|at| at..closed(at)).collect()
}

/// Where the strings of `source` stand, with their quotes; comments are skipped.
pub(super) fn strings(source: &str) -> Vec<Range<usize>> {
    let bytes = source.as_bytes();
    let (mut found, mut at) = (Vec::new(), 0);
    while at < bytes.len() {
        let end = skip_text(bytes, at);
        if end > at && !source[at..].starts_with(['/', '\'']) {
            found.push(at..end);
        }
        at = end.max(at + 1);
    }
    found
}

/// Line from 1 of a byte offset.
pub(super) fn line_at(text: &str, offset: usize) -> usize {
    1 + text[..offset].matches('\n').count()
}

/// Offsets where `word` stands alone, not as a part of a longer name.
pub(super) fn words<'t>(text: &'t str, word: &'t str) -> impl Iterator<Item = usize> + 't {
    let is_name = |byte: Option<&u8>| byte.is_some_and(|b| b.is_ascii_alphanumeric() || *b == b'_');
    let bytes = text.as_bytes();
    text.match_indices(word).map(|(at, _)| at).filter(move |&at| {
        let before = at.checked_sub(1).and_then(|i| bytes.get(i));
        let goes_on = is_name(word.as_bytes().last()) && is_name(bytes.get(at + word.len()));
        !is_name(before) && !goes_on
    })
}

fn blank(bytes: &mut [u8]) {
    bytes.iter_mut().filter(|byte| **byte != b'\n').for_each(|byte| *byte = b' ');
}

/// End of the comment, string or character that starts at `at`; `at` itself where code continues.
fn skip_text(bytes: &[u8], at: usize) -> usize {
    let rest = &bytes[at..];
    let after_name = at > 0 && (bytes[at - 1].is_ascii_alphanumeric() || bytes[at - 1] == b'_');
    if rest.starts_with(b"//") {
        at + rest.iter().position(|byte| *byte == b'\n').unwrap_or(rest.len())
    } else if rest.starts_with(b"/*") {
        at + block_comment(rest)
    } else if rest[0] == b'"' {
        at + quoted(rest, b'"')
    } else if rest[0] == b'\'' && is_character(rest) {
        at + quoted(rest, b'\'')
    } else if !after_name && matches!(rest[0], b'r' | b'b' | b'c') {
        at + raw_string(rest)
    } else {
        at
    }
}

/// A character literal, as opposed to a lifetime.
fn is_character(rest: &[u8]) -> bool {
    match rest.get(1) {
        Some(b'\\') => true,
        Some(first) if first.is_ascii() => rest.get(2) == Some(&b'\''),
        Some(_) => rest.iter().skip(2).take(4).any(|byte| *byte == b'\''),
        None => false,
    }
}

fn quoted(rest: &[u8], quote: u8) -> usize {
    let mut at = 1;
    while at < rest.len() && rest[at] != quote {
        at += if rest[at] == b'\\' { 2 } else { 1 };
    }
    (at + 1).min(rest.len())
}

fn block_comment(rest: &[u8]) -> usize {
    let (mut depth, mut at) = (0_usize, 0);
    while at < rest.len() {
        if rest[at..].starts_with(b"/*") {
            (depth, at) = (depth + 1, at + 2);
        } else if rest[at..].starts_with(b"*/") {
            (depth, at) = (depth - 1, at + 2);
            if depth == 0 {
                return at;
            }
        } else {
            at += 1;
        }
    }
    rest.len()
}

/// Length of `r"…"`, `br#"…"#` and so on; 0 when `rest` does not start one.
fn raw_string(rest: &[u8]) -> usize {
    let prefix = usize::from(matches!(rest[0], b'b' | b'c'));
    if rest.get(prefix) != Some(&b'r') {
        return 0;
    }
    let hashes = rest[prefix + 1..].iter().take_while(|byte| **byte == b'#').count();
    let open = prefix + 1 + hashes;
    if rest.get(open) != Some(&b'"') {
        return 0;
    }
    let closing: Vec<u8> = std::iter::once(b'"').chain(std::iter::repeat_n(b'#', hashes)).collect();
    let body = &rest[open + 1..];
    let end = body.windows(closing.len()).position(|window| window == closing);
    end.map_or(rest.len(), |end| open + 1 + end + closing.len())
}

/// End of the item after an attribute: its closing brace, or its semicolon.
pub(super) fn item_end(code: &[u8], from: usize) -> usize {
    let mut depth = 0_usize;
    for (offset, byte) in code[from..].iter().enumerate() {
        match byte {
            b'{' => depth += 1,
            b'}' if depth <= 1 => return from + offset + 1,
            b'}' => depth -= 1,
            b';' if depth == 0 => return from + offset + 1,
            _ => {}
        }
    }
    code.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_strings_and_characters_are_blank_and_lines_stay() {
        let source = "let a = \"x // {\\\"\"; // c {\n/* a /* b */ c */ let q = '\"'; let l: &'static str = r#\"{\"#;\nend";
        let code = code_only(source);
        assert_eq!(code.len(), source.len());
        assert!(!code.contains(['{', '"']), "{code}");
        assert!(
            code.contains("let q =") && code.contains("&'static str") && code.ends_with("\nend"),
            "{code}"
        );
    }

    #[test]
    fn tests_are_blank_and_what_follows_is_kept() {
        let code =
            "fn a() {}\n#[cfg(test)]\nmod tests { fn b() {} }\nfn c() {}\n#[cfg(test)]\nmod d;\nfn e() {}";
        let kept = without_tests(code);
        assert!(kept.contains("fn a") && kept.contains("fn c") && kept.contains("fn e"));
        assert!(!kept.contains("fn b") && !kept.contains("mod d"));
    }

    #[test]
    fn strings_and_attributes_are_found_where_they_stand() {
        let source = "#[error(\"a [b\")]\nfn f() { /* \"no\" */ g(\"c\", r#\"d\"#, '\"', v[0]) } // \"no\"\n#![allow(x)]";
        let texts: Vec<&str> = strings(source).into_iter().map(|range| &source[range]).collect();
        assert_eq!(texts, ["\"a [b\"", "\"c\"", "r#\"d\"#"]);
        let found: Vec<&str> =
            attributes(&code_only(source)).into_iter().map(|range| &source[range]).collect();
        assert_eq!(found, ["#[error(\"a [b\")]", "#![allow(x)]"]);
    }

    #[test]
    fn words_stand_alone() {
        assert_eq!(words("println! eprintln! println!", "println!").count(), 2);
        assert_eq!(words("serde_json serde_jsonx my_serde_json", "serde_json").count(), 1);
        assert_eq!(line_at("a\nb\nc", 4), 3);
    }
}
