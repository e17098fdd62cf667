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

/// From one look at the line to the next not more time counts than this.
const MOST_BETWEEN: Duration = Duration::from_millis(100);

/// The time in which a line was looked at. While the whole computer stands still nothing is sent and nothing heard: a machine is not
/// silent for it.
struct Attentive {
    until: Duration,
    looked_at: Instant,
}

impl Attentive {
    fn new() -> Self {
        Self { until: Duration::ZERO, looked_at: Instant::now() }
    }

    fn now(&self) -> Duration {
        self.until + self.looked_at.elapsed().min(MOST_BETWEEN)
    }

    fn look(&mut self) {
        self.until = self.now();
        self.looked_at = Instant::now();
    }
}

/// A real machine.
pub(super) struct Serial {
    line: Box<dyn Line>,
    clock: Attentive,
}

impl Serial {
    pub fn new(line: Box<dyn Line>) -> Self {
        Self { line, clock: Attentive::new() }
    }
}

impl Transport for Serial {
    fn now(&self) -> Duration {
        self.clock.now()
    }

    fn read(&mut self) -> io::Result<Vec<u8>> {
        self.clock.look();
        self.line.read()
    }

    fn write(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.line.write(bytes)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_time_in_which_nobody_looked_does_not_count() {
        let mut clock = Attentive::new();
        clock.looked_at -= Duration::from_secs(3);
        assert_eq!(clock.now(), MOST_BETWEEN);
        clock.look();
        clock.looked_at -= Duration::from_millis(20);
        let now = clock.now();
        assert!(now >= MOST_BETWEEN + Duration::from_millis(20) && now <= 2 * MOST_BETWEEN, "{now:?}");
    }
}
