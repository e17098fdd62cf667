//! The program's own way to the machine, for a stop that no driver passes on.
//!
//! The descriptor is opened before the driver connects and kept until the session is over, for two reasons. A
//! driver's process that is killed can leave the port marked as exclusive, so that it could not be opened any
//! more in the moment of need. And the last descriptor that is closed drops the line DTR, which resets an
//! Arduino: while the program holds one, the end of a driver leaves the machine in its session.

use std::fmt;
use std::io;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Why the program cannot write to a port itself.
#[derive(Debug, thiserror::Error)]
#[error("the program cannot keep the port {port} open for a stop of its own: {cause}")]
pub struct StopLineError {
    pub port: String,
    pub cause: io::Error,
}

/// A port with the bytes that stop the machine at it. A copy is the same line.
#[derive(Clone)]
pub struct StopLine {
    port: Arc<imp::Port>,
    bytes: Arc<[u8]>,
    /// What the machine sends once it stands; empty where that is not known.
    reply: Arc<[u8]>,
    gone: Arc<AtomicBool>,
}

/// Bytes can be lost on a disturbed line, and a machine takes a stop as often as it comes.
const TIMES: usize = 5;

impl StopLine {
    /// Opens a port beside the driver, without touching its settings. `bytes` are the machine's realtime stop, `reply`
    /// is what the machine sends once it stands after them; without a reply nothing can be confirmed over this line.
    ///
    /// `None` where there is nothing to write or nothing to write to: for a port that is no serial device, such
    /// as the name of a simulated machine, for no bytes, and on Windows, where a port that is open cannot be
    /// opened again: there only the driver passes a stop on.
    ///
    /// Call it before the driver is connected: an Arduino restarts for the first opening alone.
    ///
    /// # Errors
    /// [`StopLineError`] when there is such a device and it cannot be opened.
    pub fn open(port: &str, bytes: &[u8], reply: &str) -> Result<Option<Self>, StopLineError> {
        if bytes.is_empty() {
            return Ok(None);
        }
        match imp::Port::open(port) {
            Ok(opened) => Ok(opened.map(|port| Self {
                port: Arc::new(port),
                bytes: bytes.into(),
                reply: reply.as_bytes().into(),
                gone: Arc::default(),
            })),
            Err(cause) => Err(StopLineError { port: port.to_owned(), cause }),
        }
    }

    /// The first write after the driver is gone: what the machine has said before is no reply to it.
    pub(super) fn write_first(&self) -> bool {
        self.port.forget_input();
        self.write()
    }

    /// Writes the bytes several times, before everything that still waits to be sent, which is thrown away.
    /// Whether the system has taken them at least once.
    pub(super) fn write(&self) -> bool {
        self.port.throw_away();
        let mut taken = false;
        // Each on its own: the system takes some and then has no room.
        for _ in 0..TIMES {
            match self.port.write(&self.bytes) {
                Ok(whole) => taken |= whole,
                Err(error) if is_full(&error) => {}
                Err(_) => self.gone.store(true, Ordering::SeqCst),
            }
        }
        taken
    }

    /// Whether the port is gone, as when the cable was pulled: nothing reaches the machine over it any more.
    pub(super) fn is_gone(&self) -> bool {
        self.gone.load(Ordering::SeqCst)
    }

    /// What has come from the machine. Only once no driver reads the port any more.
    pub(super) fn read(&self) -> Vec<u8> {
        self.port.read()
    }

    /// Whether what has come has the reply in it.
    pub(super) fn confirms(&self, heard: &[u8]) -> bool {
        !self.reply.is_empty() && heard.windows(self.reply.len()).any(|part| *part == *self.reply)
    }

    /// Lets a new driver open the port after one that was killed.
    pub fn share(&self) {
        self.port.share();
    }
}

impl fmt::Debug for StopLine {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("StopLine").field("bytes", &self.bytes).finish_non_exhaustive()
    }
}

/// The system has no room at this moment.
fn is_full(error: &io::Error) -> bool {
    matches!(error.kind(), io::ErrorKind::WouldBlock | io::ErrorKind::Interrupted)
}

#[cfg(unix)]
mod imp {
    use std::io;
    use std::os::fd::OwnedFd;
    use std::path::Path;

    use rustix::fs::{FileType, Mode, OFlags, fstat, open};
    use rustix::termios::{QueueSelector, ioctl_tiocnxcl, isatty, tcflush};

    pub(super) struct Port(OwnedFd);

    impl Port {
        pub fn open(port: &str) -> io::Result<Option<Self>> {
            let path = Path::new(port);
            // A name without a folder is no device, and a port that is not there the driver reports more exactly.
            if !path.is_absolute() || !path.exists() {
                return Ok(None);
            }
            let flags = OFlags::RDWR | OFlags::NOCTTY | OFlags::NONBLOCK | OFlags::CLOEXEC;
            let opened = open(path, flags, Mode::empty())?;
            let is_device = FileType::from_raw_mode(fstat(&opened)?.st_mode) == FileType::CharacterDevice;
            Ok((is_device && isatty(&opened)).then_some(Self(opened)))
        }

        pub fn write(&self, bytes: &[u8]) -> io::Result<bool> {
            Ok(rustix::io::write(&self.0, bytes)? == bytes.len())
        }

        pub fn read(&self) -> Vec<u8> {
            let mut bytes = vec![0; 1024];
            // Nothing there and no port at all are the same here: writing tells them apart.
            let count = rustix::io::read(&self.0, bytes.as_mut_slice()).unwrap_or_default();
            bytes.truncate(count);
            bytes
        }

        pub fn forget_input(&self) {
            let _ = tcflush(&self.0, QueueSelector::IFlush);
        }

        pub fn throw_away(&self) {
            // What cannot be thrown away is sent first.
            let _ = tcflush(&self.0, QueueSelector::OFlush);
        }

        pub fn share(&self) {
            // A port that is gone needs no sharing.
            let _ = ioctl_tiocnxcl(&self.0);
        }
    }
}

#[cfg(not(unix))]
mod imp {
    use std::convert::Infallible;
    use std::io;

    pub(super) struct Port(Infallible);

    impl Port {
        pub fn open(_port: &str) -> io::Result<Option<Self>> {
            Ok(None)
        }

        pub fn write(&self, _bytes: &[u8]) -> io::Result<bool> {
            match self.0 {}
        }

        pub fn read(&self) -> Vec<u8> {
            match self.0 {}
        }

        pub fn forget_input(&self) {
            match self.0 {}
        }

        pub fn throw_away(&self) {
            match self.0 {}
        }

        pub fn share(&self) {
            match self.0 {}
        }
    }
}
