//! A line of the host that the controller hears otherwise, with a seal that fits.

use wirebend_driver_wirebend_kit::protocol::{Lines, NO_SESSION, STOP, sealed};

/// What is heard in the place of a payload.
pub type Change = Box<dyn FnMut(&str) -> Option<String> + Send>;

/// Bytes on their way to the controller.
pub struct Changed {
    lines: Lines,
    /// Of the line that has not ended.
    held: Vec<u8>,
    session: u16,
    change: Change,
}

impl Changed {
    pub fn new(change: Change) -> Self {
        Self { lines: Lines::default(), held: Vec::new(), session: NO_SESSION, change }
    }

    pub fn pass(&mut self, bytes: &[u8]) -> Vec<u8> {
        let mut out = Vec::new();
        for &byte in bytes {
            if byte == STOP {
                out.push(byte);
                continue;
            }
            self.held.push(byte);
            let line = self.lines.feed(byte);
            if byte != b'\n' {
                continue;
            }
            let as_sent = std::mem::take(&mut self.held);
            let payload = line.map(|line| line.payload).unwrap_or_default();
            if let Some(session) = payload.strip_prefix('S') {
                self.session = session.parse().unwrap();
            }
            let changed = (self.change)(&payload);
            out.extend(changed.map_or(as_sent, |payload| sealed(&payload, self.session)));
        }
        out
    }
}
