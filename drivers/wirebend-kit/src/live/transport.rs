//! The way to a controller: a serial port, or a simulated machine with its own clock.

use std::io;
use std::time::{Duration, Instant};

use wirebend_driver_api::serial::Line;
use wirebend_driver_api::{Bench, DriverError, Event};

/// A line to a controller, with the clock that goes with it.
pub(super) trait Transport {
    /// Time since it was opened.
    fn now(&self) -> Duration;

    /// Received bytes. A simulated machine runs meanwhile.
    fn read(&mut self) -> io::Result<Vec<u8>>;

    fn write(&mut self, bytes: &[u8]) -> io::Result<()>;

    /// Whether another read at once would return more.
    fn has_more(&self) -> bool {
        false
    }

    /// Loads new wire.
    fn load(&mut self, _bench: Option<&Bench>) -> Result<(), DriverError> {
        Ok(())
    }

    /// Violations of the simulated machine since the last call.
    fn warnings(&mut self) -> Vec<DriverError> {
        Vec::new()
    }

    /// The bent wire of a simulated machine.
    fn made(&mut self) -> Option<Event> {
        None
    }
}

/// A real machine.
pub(super) struct Serial {
    pub line: Box<dyn Line>,
    pub opened: Instant,
}

impl Transport for Serial {
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
