//! What the machine is behind: a serial port, or a simulated machine with its own time.

use std::io;
use std::time::{Duration, Instant};

use wirebend_driver_api::serial::Line;
use wirebend_driver_api::{Bench, DriverError, Event};

/// A line to a controller, with the clock that goes with it.
pub(super) trait Port {
    /// Time since it was opened.
    fn now(&self) -> Duration;

    /// What has come. A simulated machine goes on meanwhile.
    fn read(&mut self) -> io::Result<Vec<u8>>;

    fn write(&mut self, bytes: &[u8]) -> io::Result<()>;

    /// Whether another reading at once would find that more has happened.
    fn has_more(&self) -> bool {
        false
    }

    /// New wire is put in.
    fn load(&mut self, _bench: Option<&Bench>) -> Result<(), DriverError> {
        Ok(())
    }

    /// What the machine was seen to do that it should not have done.
    fn warnings(&mut self) -> Vec<DriverError> {
        Vec::new()
    }

    /// The wire that it has made, where that is known.
    fn made(&mut self) -> Option<Event> {
        None
    }
}

/// A real machine.
pub(super) struct Serial {
    pub line: Box<dyn Line>,
    pub opened: Instant,
}

impl Port for Serial {
    fn now(&self) -> Duration {
        self.opened.elapsed()
    }

    fn read(&mut self) -> io::Result<Vec<u8>> {
        self.line.read()
    }

    fn write(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.line.write(bytes)
    }
}
