//! One pseudo-terminal for one connection: raw, watched for being opened and closed, with a link to its name.

use std::ffi::OsStr;
use std::mem::MaybeUninit;
use std::os::fd::OwnedFd;
use std::os::unix::ffi::OsStrExt;
use std::path::{Path, PathBuf};

use rustix::event::{PollFd, PollFlags, Timespec, poll};
use rustix::fs::inotify::{self, CreateFlags, ReadFlags, WatchFlags};
use rustix::fs::{OFlags, fcntl_getfl, fcntl_setfl};
use rustix::io::Errno;
use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
use rustix::termios::{OptionalActions, tcgetattr, tcsetattr};

use crate::error::UnoError;

/// What the other side has done.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Happened {
    Opened,
    Closed,
}

/// What a look at a terminal shows.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Seen {
    /// It was opened or closed.
    pub(super) happened: bool,
    /// Everybody has closed it who had opened it.
    pub(super) left: bool,
    /// There are bytes to read.
    pub(super) bytes: bool,
}

/// The controller's end of a pseudo-terminal.
pub(super) struct Terminal {
    master: OwnedFd,
    watch: OwnedFd,
    /// The name of the other end.
    name: PathBuf,
}

fn failed(doing: &'static str) -> impl Fn(Errno) -> UnoError {
    move |why| UnoError::Terminal { doing, why: why.into() }
}

impl Terminal {
    /// A terminal that was not opened, with `link` leading to it in place of an older one.
    pub(super) fn new(link: &Path) -> Result<Self, UnoError> {
        let making = failed("making a pseudo-terminal");
        let master =
            openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY | OpenptFlags::CLOEXEC).map_err(&making)?;
        grantpt(&master).map_err(&making)?;
        unlockpt(&master).map_err(&making)?;
        let flags = fcntl_getfl(&master).map_err(&making)?;
        fcntl_setfl(&master, flags | OFlags::NONBLOCK).map_err(&making)?;
        // Raw before anybody opens it, or the terminal answers what comes in before the other side has set it up.
        let mut modes = tcgetattr(&master).map_err(&making)?;
        modes.make_raw();
        tcsetattr(&master, OptionalActions::Now, &modes).map_err(&making)?;
        let name = ptsname(&master, Vec::new()).map_err(&making)?;
        let name = PathBuf::from(OsStr::from_bytes(name.as_bytes()));

        let watching = failed("watching a pseudo-terminal");
        let watch = inotify::init(CreateFlags::NONBLOCK | CreateFlags::CLOEXEC).map_err(&watching)?;
        let events = WatchFlags::OPEN | WatchFlags::CLOSE_WRITE | WatchFlags::CLOSE_NOWRITE;
        inotify::add_watch(&watch, &name, events).map_err(&watching)?;

        let terminal = Self { master, watch, name };
        terminal.link(link)?;
        Ok(terminal)
    }

    /// Makes `link` lead here from one moment to the next.
    pub(super) fn link(&self, link: &Path) -> Result<(), UnoError> {
        let linking = |why| UnoError::Terminal { doing: "linking the port", why };
        let fresh = link.with_extension("fresh");
        std::os::unix::fs::symlink(&self.name, &fresh).map_err(linking)?;
        std::fs::rename(&fresh, link).map_err(linking)
    }

    /// What has happened since the last call, in its order.
    pub(super) fn happened(&self) -> Result<Vec<Happened>, UnoError> {
        let mut happened = Vec::new();
        let mut room = [MaybeUninit::uninit(); 1024];
        let mut reader = inotify::Reader::new(&self.watch, &mut room);
        loop {
            match reader.next().map(|event| event.events()) {
                Ok(flags) if flags.contains(ReadFlags::OPEN) => happened.push(Happened::Opened),
                Ok(flags) if flags.intersects(ReadFlags::CLOSE_WRITE | ReadFlags::CLOSE_NOWRITE) => {
                    happened.push(Happened::Closed);
                }
                Ok(_) | Err(Errno::INTR) => {}
                Err(Errno::AGAIN) => return Ok(happened),
                Err(why) => return Err(failed("watching a pseudo-terminal")(why)),
            }
        }
    }

    pub(super) fn look(&self) -> Result<Seen, UnoError> {
        let mut wanted = [PollFd::new(&self.master, PollFlags::IN), PollFd::new(&self.watch, PollFlags::IN)];
        match poll(&mut wanted, Some(&Timespec::default())) {
            Ok(_) | Err(Errno::INTR) => {}
            Err(why) => return Err(failed("watching a pseudo-terminal")(why)),
        }
        let [terminal, watch] = wanted.map(|one| one.revents());
        Ok(Seen {
            happened: watch.contains(PollFlags::IN),
            left: terminal.contains(PollFlags::HUP),
            bytes: terminal.contains(PollFlags::IN),
        })
    }

    /// Bytes that are there, at most as many as fit; none at all when it is not open.
    pub(super) fn read(&self, room: &mut [u8]) -> Result<usize, UnoError> {
        match rustix::io::read(&self.master, room) {
            Ok(count) => Ok(count),
            Err(Errno::AGAIN | Errno::INTR | Errno::IO) => Ok(0),
            Err(why) => Err(failed("reading a pseudo-terminal")(why)),
        }
    }

    /// How many of the bytes it took.
    pub(super) fn write(&self, bytes: &[u8]) -> Result<usize, UnoError> {
        match rustix::io::write(&self.master, bytes) {
            Ok(count) => Ok(count),
            Err(Errno::AGAIN | Errno::INTR | Errno::IO) => Ok(0),
            Err(why) => Err(failed("writing a pseudo-terminal")(why)),
        }
    }
}
