//! A bender on grbl at a terminal: the model of the controller that the driver's own tests have.

use std::fs::File;
use std::io::{Read, Write};
use std::os::fd::OwnedFd;

use rustix::event::{PollFd, PollFlags, Timespec, poll};
use rustix::termios::{OptionalActions, tcgetattr, tcsetattr};

use crate::board::terminal;
use crate::grbl_model::{Build, Model};

/// A bender that is switched on.
pub struct Bender {
    pub model: Model,
    pub port: String,
    /// What is written before anybody reads is kept as long as one side is open.
    _cable: OwnedFd,
}

impl Bender {
    pub fn new(build: Build) -> Self {
        let (machine, cable, port) = terminal();
        let mut raw = tcgetattr(&cable).unwrap();
        raw.make_raw();
        tcsetattr(&cable, OptionalActions::Now, &raw).unwrap();
        Self { model: Model::run(FarEnd(File::from(machine)), build), port, _cable: cable }
    }

    /// One without switches, so slow that a bend can be stopped on its way.
    pub fn without_switches() -> Self {
        Self::new(Build { switches: false, steps_a_turn: 8, change: None })
    }

    /// Where the axes stand: feed, rotation, bend.
    pub fn stands(&self) -> String {
        format!("{:.3?}", self.model.now().at)
    }
}

/// The far end of a cable: a read waits for a millisecond.
struct FarEnd(File);

impl Read for FarEnd {
    fn read(&mut self, bytes: &mut [u8]) -> std::io::Result<usize> {
        let millisecond = Timespec { tv_sec: 0, tv_nsec: 1_000_000 };
        match poll(&mut [PollFd::new(&self.0, PollFlags::IN)], Some(&millisecond))? {
            0 => Ok(0),
            _ => self.0.read(bytes),
        }
    }
}

impl Write for FarEnd {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        self.0.write(bytes)
    }

    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}
