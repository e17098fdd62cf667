//! Frames: `PAYLOAD*HHHH` and a newline.

/// Seals what belongs to no session.
pub const NO_SESSION: u16 = 0xFFFF;
/// The byte that stops the machine at once.
pub const STOP: u8 = 0x80;
/// Nothing of the controller is longer.
const MAX_LINE: usize = 128;

/// CRC-16 of polynomial 0x8408, least significant bit first, starting from the seed.
fn checksum(seed: u16, payload: &[u8]) -> u16 {
    payload.iter().fold(seed, |crc, &byte| {
        (0..8).fold(crc ^ u16::from(byte), |crc, _| (crc >> 1) ^ if crc & 1 == 1 { 0x8408 } else { 0 })
    })
}

/// A frame on its way, sealed for a session. It begins with a newline, which ends whatever noise came
/// before it.
///
/// ```
/// use wirebend_driver_wirebend_kit::protocol::{NO_SESSION, sealed};
/// assert_eq!(sealed("S4660", NO_SESSION), b"\nS4660*E5BE\n");
/// ```
#[must_use]
pub fn sealed(payload: &str, session: u16) -> Vec<u8> {
    format!("\n{payload}*{:04X}\n", checksum(session, payload.as_bytes())).into_bytes()
}

/// Bytes in, lines out.
#[derive(Debug, Clone, Default)]
pub struct Lines {
    text: Vec<u8>,
    poisoned: bool,
}

/// A line of the controller whose form is that of a frame.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Line {
    pub payload: String,
    checksum: u16,
}

impl Line {
    /// Whether it was sealed with this.
    #[must_use]
    pub fn is_sealed_with(&self, seed: u16) -> bool {
        checksum(seed, self.payload.as_bytes()) == self.checksum
    }
}

impl Lines {
    /// Takes a byte; a line when it ends one. What is no frame is passed over.
    pub fn feed(&mut self, byte: u8) -> Option<Line> {
        if byte != b'\n' {
            self.poisoned |= !byte.is_ascii_graphic() || self.text.len() == MAX_LINE;
            if !self.poisoned {
                self.text.push(byte);
            }
            return None;
        }
        let text = std::mem::take(&mut self.text);
        if std::mem::take(&mut self.poisoned) {
            return None;
        }
        let text = String::from_utf8(text).ok()?;
        let (payload, seal) = text.rsplit_once('*')?;
        let upper_hex = seal.len() == 4 && seal.bytes().all(|b| matches!(b, b'0'..=b'9' | b'A'..=b'F'));
        let checksum = upper_hex.then(|| u16::from_str_radix(seal, 16).ok())??;
        Some(Line { payload: payload.to_owned(), checksum })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The check value of this checksum in the catalogue of CRCs, where it is CRC-16/MCRF4XX.
    #[test]
    fn the_checksum_is_the_known_one() {
        assert_eq!(checksum(0xFFFF, b"123456789"), 0x6F91);
    }

    /// A STOP must not come of a bit or two that flip in a frame.
    #[test]
    fn no_byte_of_a_frame_is_close_to_stop() {
        for byte in
            (0_u8..=255).filter(|byte| byte.is_ascii_digit() || b"\n*,-ABCDEFGHKLMPQSWZC".contains(byte))
        {
            assert!((byte ^ STOP).count_ones() >= 3, "{byte:#x}");
        }
    }

    #[test]
    fn what_is_no_frame_is_passed_over() {
        let mut lines = Lines::default();
        let mut feed = |text: &[u8]| text.iter().filter_map(|&byte| lines.feed(byte)).count();
        for bad in
            [&b"\n"[..], b"a*12\n", b"a*12345\n", b"a*12e4\n", b"a*+123\n", b"a 1*1234\n", &[200, b'\n']]
        {
            assert_eq!(feed(bad), 0, "{}", String::from_utf8_lossy(bad));
        }
        assert_eq!(feed(&[&[b'a'; 300][..], b"*1234\n"].concat()), 0);
        assert_eq!(feed(b"a1,8*1234\n"), 1);
    }
}
