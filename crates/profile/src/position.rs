//! On which line of a JSON text a key stands.

/// Line, from 1, of the deepest key of `path` that the text has. `None` when it has not even the
/// first, or for an empty path. The text must be JSON; on anything else the answer is only a guess.
pub(crate) fn line_of(text: &str, path: &[&str]) -> Option<usize> {
    let mut scan = Scan { bytes: text.as_bytes(), at: 0, line: 1 };
    let mut deepest = None;
    for wanted in path {
        match scan.enter(wanted) {
            Some(line) => deepest = Some(line),
            None => break,
        }
    }
    deepest
}

struct Scan<'a> {
    bytes: &'a [u8],
    at: usize,
    line: usize,
}

impl Scan<'_> {
    /// From before an object to after the colon of its key `wanted`; the line of that key.
    fn enter(&mut self, wanted: &str) -> Option<usize> {
        if self.skip_space()? != b'{' {
            return None;
        }
        self.bump();
        loop {
            if self.skip_space()? != b'"' {
                return None;
            }
            let line = self.line;
            let quoted = self.string()?;
            let key: String = serde_json::from_slice(quoted).ok()?;
            if self.skip_space()? != b':' {
                return None;
            }
            self.bump();
            if key == wanted {
                return Some(line);
            }
            self.skip_value();
            if self.skip_space()? != b',' {
                return None;
            }
            self.bump();
        }
    }

    /// To the comma or bracket after a value.
    fn skip_value(&mut self) {
        let mut depth = 0_usize;
        while let Some(byte) = self.peek() {
            match byte {
                b'"' => {
                    self.string();
                    continue;
                }
                b'{' | b'[' => depth += 1,
                b'}' | b']' | b',' if depth == 0 => return,
                b'}' | b']' => depth -= 1,
                _ => {}
            }
            self.bump();
        }
    }

    /// From an opening quote to after the closing one; the text with its quotes.
    fn string(&mut self) -> Option<&[u8]> {
        let start = self.at;
        self.bump();
        loop {
            match self.peek()? {
                b'\\' => {
                    self.bump();
                    self.bump();
                }
                b'"' => {
                    self.bump();
                    return self.bytes.get(start..self.at);
                }
                _ => self.bump(),
            }
        }
    }

    /// To the next byte that is not space, and that byte.
    fn skip_space(&mut self) -> Option<u8> {
        while self.peek()?.is_ascii_whitespace() {
            self.bump();
        }
        self.peek()
    }

    fn peek(&self) -> Option<u8> {
        self.bytes.get(self.at).copied()
    }

    fn bump(&mut self) {
        if self.peek() == Some(b'\n') {
            self.line += 1;
        }
        self.at += 1;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const TEXT: &str = "{\n \"a\": {\"x\": [1, {\"b\": 2}],\n  \"b\": \"}\\\"\"},\n \"b\"\n : {\n \"c\": 3}}";

    #[test]
    fn a_person_is_sent_to_the_line_of_the_key_and_not_of_a_namesake() {
        assert_eq!(line_of(TEXT, &["a", "b"]), Some(3));
        assert_eq!(line_of(TEXT, &["b"]), Some(4));
        assert_eq!(line_of(TEXT, &["b", "c"]), Some(6));
    }

    #[test]
    fn the_nearest_parent_stands_in_for_an_absent_key() {
        assert_eq!(line_of(TEXT, &["b", "z", "y"]), Some(4));
        assert_eq!(line_of(TEXT, &["z"]), None);
        assert_eq!(line_of(TEXT, &[]), None);
    }

    proptest! {
        #[test]
        fn any_text_ends(text in ".*", key in "[a-z]{0,2}") {
            line_of(&text, &[&key, &key]);
        }
    }
}
