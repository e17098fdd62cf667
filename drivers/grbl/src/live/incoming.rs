//! From bytes to lines.

/// The longest line that is kept. grbl's longest, a status report with everything, has about 150 bytes.
const MAX_LINE: usize = 256;

/// A line from the machine.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Line {
    /// ASCII that can be printed.
    Text(String),
    /// Anything else, or more than any line has: escaped, and cut where it is long.
    Garbled(String),
}

/// What has come of a line so far.
#[derive(Debug, Default)]
pub(crate) struct Incoming {
    bytes: Vec<u8>,
    /// The rest of an overlong line is thrown away.
    overlong: bool,
}

impl Incoming {
    /// The lines that these bytes complete. Empty lines are left out.
    pub fn lines(&mut self, bytes: &[u8]) -> Vec<Line> {
        let mut lines = Vec::new();
        for &byte in bytes {
            if byte == b'\n' || byte == b'\r' {
                let line = std::mem::take(&mut self.bytes);
                let overlong = std::mem::take(&mut self.overlong);
                if !line.is_empty() && !overlong {
                    lines.push(read(line));
                }
            } else if !self.overlong {
                self.bytes.push(byte);
                if self.bytes.len() > MAX_LINE {
                    self.overlong = true;
                    lines.push(Line::Garbled(self.bytes[..64].escape_ascii().to_string()));
                    self.bytes.clear();
                }
            }
        }
        lines
    }
}

fn read(line: Vec<u8>) -> Line {
    if line.iter().all(|byte| (b' '..=b'~').contains(byte)) {
        // ASCII is UTF-8.
        return Line::Text(String::from_utf8(line).unwrap_or_default());
    }
    Line::Garbled(line.escape_ascii().to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_come_whole_however_they_are_cut() {
        let mut incoming = Incoming::default();
        assert_eq!(incoming.lines(b"o"), []);
        assert_eq!(incoming.lines(b"k\r"), [Line::Text("ok".into())]);
        assert_eq!(incoming.lines(b"\n\r\nerror:9\n"), [Line::Text("error:9".into())]);
    }

    #[test]
    fn noise_is_told_from_lines() {
        let mut incoming = Incoming::default();
        assert_eq!(incoming.lines(b"\xf8ok\n"), [Line::Garbled("\\xf8ok".into())]);
        let long = incoming.lines(&[b'x'; 1000]);
        assert_eq!(long, [Line::Garbled("x".repeat(64))]);
        assert_eq!(incoming.lines(b"xx\nok\n"), [Line::Text("ok".into())]);
    }
}
