//! A bender on grbl at a terminal: the model of the controller that the driver's own tests have.

use std::fs::File;
use std::io::{Read, Write};
use std::os::fd::OwnedFd;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use rustix::event::{PollFd, PollFlags, Timespec, poll};
use rustix::termios::{OptionalActions, tcgetattr, tcsetattr};

use super::board::terminal;
use crate::grbl_model::{Build, Model};

/// The byte that stops grbl.
const RESET: u8 = 0x18;

/// A bender that is switched on.
pub struct Bender {
    pub model: Model,
    /// A link in a folder of its own: the name of a terminal that has ended is at once that of another test's.
    pub port: String,
    _folder: tempfile::TempDir,
    line: Arc<Mutex<Line>>,
    /// What is written before anybody reads is kept as long as one side is open.
    _cable: OwnedFd,
}

impl Bender {
    pub fn new(build: Build) -> Self {
        let (machine, cable, terminal) = terminal();
        let folder = tempfile::tempdir().unwrap();
        let link = folder.path().join("port");
        std::os::unix::fs::symlink(terminal, &link).unwrap();
        let port = link.into_os_string().into_string().unwrap();
        let mut raw = tcgetattr(&cable).unwrap();
        raw.make_raw();
        tcsetattr(&cable, OptionalActions::Now, &raw).unwrap();
        let line = Arc::new(Mutex::new(Line::default()));
        let end = FarEnd { cable: File::from(machine), line: Arc::clone(&line) };
        Self { model: Model::run(end, build), port, _folder: folder, line, _cable: cable }
    }

    /// One without switches, so slow that a bend can be stopped on its way.
    pub fn without_switches() -> Self {
        Self::new(Build { switches: false, steps_a_turn: 8, ..Build::default() })
    }

    /// One whose bend axis needs seconds for a bend.
    pub fn slow() -> Self {
        Self::new(Build { switches: false, steps_a_turn: 2, ..Build::default() })
    }

    /// Whatever is sent to the machine from now on is lost, for a time.
    pub fn deafen(&self, time: Duration) {
        let now = Instant::now();
        let mut line = self.line();
        (line.deaf_since, line.deaf_until) = (Some(now), now.checked_add(time));
    }

    /// How many bytes have arrived so far.
    pub fn heard(&self) -> usize {
        self.line().heard
    }

    /// When the first reset has arrived, lost or not.
    pub fn first_reset(&self) -> Option<Instant> {
        self.line().first_reset
    }

    fn line(&self) -> MutexGuard<'_, Line> {
        self.line.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Where the axes stand: feed, rotation, bend.
    pub fn stands(&self) -> String {
        format!("{:.3?}", self.model.now().at)
    }
}

/// What happens on the way to the machine.
#[derive(Default)]
struct Line {
    deaf_since: Option<Instant>,
    deaf_until: Option<Instant>,
    first_reset: Option<Instant>,
    heard: usize,
}

/// The far end of a cable: a read waits for a millisecond.
struct FarEnd {
    cable: File,
    line: Arc<Mutex<Line>>,
}

impl Read for FarEnd {
    fn read(&mut self, bytes: &mut [u8]) -> std::io::Result<usize> {
        let millisecond = Timespec { tv_sec: 0, tv_nsec: 1_000_000 };
        let count = match poll(&mut [PollFd::new(&self.cable, PollFlags::IN)], Some(&millisecond))? {
            0 => 0,
            _ => self.cable.read(bytes)?,
        };
        let now = Instant::now();
        let mut line = self.line.lock().unwrap_or_else(PoisonError::into_inner);
        line.heard += count;
        if bytes[..count].contains(&RESET) {
            line.first_reset.get_or_insert(now);
        }
        // A time that is longer than the clock counts never ends.
        let deaf = line.deaf_since.is_some() && line.deaf_until.is_none_or(|until| now < until);
        Ok(if deaf { 0 } else { count })
    }
}

impl Write for FarEnd {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        self.cable.write(bytes)
    }

    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}
