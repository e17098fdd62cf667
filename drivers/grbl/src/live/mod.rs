//! Live on grbl 1.1: a protocol without a port and a clock, and the session that gives it both.

mod calls;
#[cfg(test)]
mod changed;
mod connecting;
mod console;
mod cutting;
mod displacement;
mod ending;
mod incoming;
mod interrupted;
mod jog_row;
mod machine;
mod phase;
mod polling;
mod protocol;
mod reply;
mod running;
mod speed;
mod speeds;
mod status;
mod stream;
#[cfg(test)]
mod tests;
mod wire_run;

use std::io;
use std::rc::Rc;
use std::time::{Duration, Instant};

use wirebend_driver_api::serial::{self, Line};
use wirebend_driver_api::{
    ArmedReply, Batch, ConsoleLine, DriverError, Event, MachineSession, Motion, Run, Sent,
};

use crate::settings::Settings;
use protocol::Protocol;

const RESET: u8 = 0x18;

/// A connection: the protocol with a port and a clock.
pub(crate) struct Session {
    /// Nothing once the port is gone or of no use.
    line: Option<Box<dyn Line>>,
    protocol: Protocol,
    opened: Instant,
}

impl Session {
    pub fn open(port: &str, settings: Rc<Settings>) -> Result<Self, DriverError> {
        let line = serial::open(port, settings.baud)?;
        Ok(Self { line: Some(line), protocol: Protocol::new(settings), opened: Instant::now() })
    }

    fn now(&self) -> Duration {
        self.opened.elapsed()
    }

    /// Hands over what the protocol has to say. A port that does not take it is gone, which is reported as a
    /// fault besides.
    fn flush(&mut self) -> io::Result<()> {
        let output = self.protocol.take_output();
        let Some(line) = &mut self.line else { return Ok(()) };
        let written = if output.is_empty() { Ok(()) } else { line.write(&output) };
        if written.is_err() {
            self.gone();
        }
        if self.protocol.is_closed() {
            self.line = None;
        }
        written
    }

    fn gone(&mut self) {
        self.line = None;
        self.protocol.unplugged(self.opened.elapsed());
    }

    fn listen(&mut self) {
        let Some(line) = &mut self.line else { return };
        match line.read() {
            Ok(bytes) => {
                let now = self.now();
                self.protocol.receive(&bytes, now);
                self.protocol.tick(now);
                // The fault that it reports is enough.
                let _ = self.flush();
            }
            Err(_) => self.gone(),
        }
    }

    /// A call, and what it sends. What could not be sent becomes a fault.
    fn call<T>(
        &mut self,
        work: impl FnOnce(&mut Protocol, Duration) -> Result<T, DriverError>,
    ) -> Result<T, DriverError> {
        let now = self.now();
        let answer = work(&mut self.protocol, now);
        let _ = self.flush();
        answer
    }
}

impl MachineSession for Session {
    fn home(&mut self) -> Result<(), DriverError> {
        self.call(Protocol::home)
    }

    fn arm(&mut self, run: &Run) -> Result<ArmedReply, DriverError> {
        // The controller has no sessions of its own: after a reset it knows nothing.
        self.call(|protocol, now| protocol.arm(run, now)).map(|()| ArmedReply::default())
    }

    fn send(&mut self, batch: &Batch) -> Result<Sent, DriverError> {
        self.call(|protocol, now| protocol.send(batch, now))
    }

    fn jog(&mut self, motion: Motion) -> Result<(), DriverError> {
        self.call(|protocol, now| protocol.jog(motion, now))
    }

    fn pause(&mut self) -> Result<(), DriverError> {
        self.call(Protocol::pause)
    }

    fn set_speed(&mut self, percent: u8) -> Result<(), DriverError> {
        self.call(|protocol, now| protocol.set_speed(percent, now))
    }

    fn console(&mut self, line: &ConsoleLine, may_change: bool) -> Result<(), DriverError> {
        self.call(|protocol, now| protocol.console(line, may_change, now))
    }

    fn cut(&mut self) -> Result<(), DriverError> {
        self.call(Protocol::cut)
    }

    fn resume(&mut self) -> Result<(), DriverError> {
        self.call(Protocol::resume)
    }

    fn stop(&mut self) -> Result<(), DriverError> {
        let now = self.now();
        self.protocol.stop(now)?;
        // A user who reads that the stop was passed on lets go of the power switch: a fault later is too late.
        self.flush().map_err(|error| {
            let what = format!("the stop could not be sent to the machine: {error}");
            DriverError::new("stop-not-sent", what, "cut the machine's power")
        })
    }

    fn poll(&mut self) -> Result<Option<Event>, DriverError> {
        // What has been said already comes first, so that a talkative machine cannot pile it up.
        let event = self.protocol.next_event();
        if event.is_some() {
            return Ok(event);
        }
        self.listen();
        Ok(self.protocol.next_event())
    }
}

impl Drop for Session {
    /// No driver would be left to stop what still moves.
    fn drop(&mut self) {
        if let Some(line) = self.line.as_mut().filter(|_| self.protocol.is_moving()) {
            // A port that does not take it cannot be helped here.
            let _ = line.write(&[RESET]);
        }
    }
}
