//! What can be behind a port.

use crate::error::UnoError;
use crate::uno::{Ram, ResetCause, Uno};

/// A controller with a clock of its own and a serial line: what a port can lead to.
pub trait Behind: Send + 'static {
    /// Its time, in cycles of [`HZ`](crate::HZ).
    fn cycle(&self) -> u64;

    /// Lets so many cycles pass.
    ///
    /// # Errors
    /// When it cannot continue; the port closes then.
    fn run_for(&mut self, cycles: u64) -> Result<(), UnoError>;

    /// Puts bytes on the wire to it, as soon as those before are over.
    fn send(&mut self, bytes: &[u8]);

    /// Bytes that are on their way to it.
    fn on_wire(&self) -> u64;

    /// What it has sent since the last call.
    fn take_sent(&mut self) -> Vec<u8>;

    /// A program has opened its port, which resets a board as the Uno.
    fn reset_by_port(&mut self);
}

impl Behind for Uno {
    fn cycle(&self) -> u64 {
        Self::cycle(self)
    }

    fn run_for(&mut self, cycles: u64) -> Result<(), UnoError> {
        Self::run_for(self, cycles)
    }

    fn send(&mut self, bytes: &[u8]) {
        Self::send(self, bytes);
    }

    fn on_wire(&self) -> u64 {
        Self::on_wire(self)
    }

    fn take_sent(&mut self) -> Vec<u8> {
        self.received().into_iter().map(|(_, byte)| byte).collect()
    }

    fn reset_by_port(&mut self) {
        self.reset(ResetCause::External, Ram::Kept);
    }
}
