//! Frames on the pipes between the program and a driver's process.
//!
//! A frame is the length of the rest (4 bytes, little-endian), an id (4 bytes), a mark (1 byte) and the
//! body. A reply has the id of its request.

use std::io::{self, Read, Write};

/// The largest body, in bytes: a job of a hundred thousand steps, several times over.
pub(crate) const MAX_BYTES: usize = 80 << 20;
const HEAD: usize = 5;

/// What a request asks for, or what became of it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub(crate) enum Mark {
    /// Request: settings.
    Open = 1,
    /// Request: a call.
    Call = 2,
    /// Request: events.
    Poll = 3,
    /// Request: close the instance.
    Close = 4,
    /// Request: the description once more.
    Describe = 5,
    /// Reply: the driver's result.
    Ok = 16,
    /// Reply: the driver's refusal.
    Refused = 17,
    /// Reply: the driver broke a rule of the boundary, or could not be loaded.
    Broken = 18,
}

impl Mark {
    const ALL: [Self; 8] = [
        Self::Open,
        Self::Call,
        Self::Poll,
        Self::Close,
        Self::Describe,
        Self::Ok,
        Self::Refused,
        Self::Broken,
    ];
}

#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Frame {
    pub id: u32,
    pub mark: Mark,
    pub body: Vec<u8>,
}

/// Why no frame could be read.
#[derive(Debug, thiserror::Error)]
pub(crate) enum FrameError {
    #[error("the pipe is closed")]
    Closed,
    #[error("{0} bytes are more than a frame holds")]
    TooLarge(usize),
    #[error("what came is no frame")]
    Garbage,
    #[error(transparent)]
    Io(io::Error),
}

impl Frame {
    pub fn write(&self, to: &mut impl Write) -> io::Result<()> {
        let length = u32::try_from(self.body.len() + HEAD).map_err(|_| io::ErrorKind::InvalidInput)?;
        let mut head = [0; 4 + HEAD];
        head[..4].copy_from_slice(&length.to_le_bytes());
        head[4..8].copy_from_slice(&self.id.to_le_bytes());
        head[8] = self.mark as u8;
        to.write_all(&head)?;
        to.write_all(&self.body)?;
        to.flush()
    }

    pub fn read(from: &mut impl Read) -> Result<Self, FrameError> {
        let mut head = [0; 4 + HEAD];
        let mut filled = 0;
        while filled < head.len() {
            match from.read(&mut head[filled..]) {
                Ok(0) if filled == 0 => return Err(FrameError::Closed),
                Ok(0) => return Err(FrameError::Garbage),
                Ok(count) => filled += count,
                Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
                Err(error) => return Err(FrameError::Io(error)),
            }
        }
        let [a, b, c, d, i, j, k, l, mark] = head;
        let length = u32::from_le_bytes([a, b, c, d]) as usize;
        // The mark first: what a driver prints by accident has none, whatever length its letters give.
        let mark = Mark::ALL.into_iter().find(|known| *known as u8 == mark).ok_or(FrameError::Garbage)?;
        let size = length.checked_sub(HEAD).ok_or(FrameError::Garbage)?;
        if size > MAX_BYTES {
            return Err(FrameError::TooLarge(size));
        }
        let mut body = vec![0; size];
        from.read_exact(&mut body).map_err(|error| match error.kind() {
            io::ErrorKind::UnexpectedEof => FrameError::Garbage,
            _ => FrameError::Io(error),
        })?;
        Ok(Self { id: u32::from_le_bytes([i, j, k, l]), mark, body })
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn read(bytes: &[u8]) -> Result<Frame, FrameError> {
        Frame::read(&mut &bytes[..])
    }

    proptest! {
        #[test]
        fn what_is_written_is_read(id: u32, body: Vec<u8>, mark in 0_usize..8) {
            let frame = Frame { id, mark: Mark::ALL[mark], body };
            let mut bytes = Vec::new();
            frame.write(&mut bytes).unwrap();
            prop_assert_eq!(read(&bytes).unwrap(), frame);
            // Every frame that is cut off is noticed.
            for end in 1..bytes.len() {
                prop_assert!(matches!(read(&bytes[..end]), Err(FrameError::Garbage)));
            }
        }

        #[test]
        fn any_bytes_are_a_frame_or_an_error(bytes: Vec<u8>) {
            let _ = read(&bytes);
        }
    }

    #[test]
    fn what_is_no_frame_is_told_apart() {
        assert!(matches!(read(b""), Err(FrameError::Closed)));
        assert!(matches!(read(b"hello from a driver\n"), Err(FrameError::Garbage)));
        assert!(matches!(read(&[0xff, 0xff, 0xff, 0x7f, 0, 0, 0, 0, 16]), Err(FrameError::TooLarge(_))));
        assert!(matches!(read(&[2, 0, 0, 0, 0, 0, 0, 0, 16]), Err(FrameError::Garbage)));
    }
}
