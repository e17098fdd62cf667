//! Live: the machine without a port, the ports, and the session that joins them.

mod calls;
mod console;
mod ending;
mod fault;
mod head_target;
mod incoming;
mod machine;
mod ports;
mod simulated;
mod transport;
mod typed;
mod wire_progress;

use std::rc::Rc;
use std::time::{Duration, Instant};

use wirebend_driver_api::{
    ArmedReply, Batch, ConsoleLine, DriverError, Event, MachineSession, Motion, Run, Sent, serial,
};

use crate::settings::Settings;
use machine::Machine;
pub(crate) use ports::ports;
use simulated::{Simulated, SimulationSpeed};
use transport::{Serial, Transport};

/// What the firmware speaks.
const BAUD: u32 = 115_200;
/// The simulated machine's port.
const SIMULATED: &str = "sim";
/// How long a STOP is repeated when the port is to be closed. Less than [`wirebend_driver_api::deadline::CLOSE`].
const LAST_STOP: Duration = Duration::from_millis(300);
/// How long one poll may let a simulated machine run on.
const POLL: Duration = Duration::from_millis(20);

pub(crate) struct Session {
    /// None once the port is gone.
    port: Option<Box<dyn Transport>>,
    machine: Machine,
}

impl Session {
    pub fn open(name: &str, resume: Option<&str>, settings: &Rc<Settings>) -> Result<Self, DriverError> {
        let pace = pace(name)?;
        let port: Box<dyn Transport> = match pace {
            Some(pace) => Box::new(Simulated::new(pace, settings)?),
            None => Box::new(Serial::new(serial::open(name, BAUD)?)),
        };
        let mut machine = Machine::new(Rc::clone(settings), resume, port.now());
        if pace.is_some() {
            // It has no pins, so any machine will do.
            machine.built_for = simulated::FIRMWARE_MACHINE;
        }
        Ok(Self { port: Some(port), machine })
    }

    /// Runs a call and sends its bytes.
    fn call<T>(
        &mut self,
        work: impl FnOnce(&mut Machine, Duration) -> Result<T, DriverError>,
    ) -> Result<T, DriverError> {
        let Some(port) = &self.port else { return Err(gone()) };
        let answer = work(&mut self.machine, port.now());
        self.flush();
        answer
    }

    fn flush(&mut self) {
        let bytes = self.machine.take_bytes();
        let Some(port) = &mut self.port else { return };
        if !bytes.is_empty() && port.write(&bytes).is_err() {
            self.lost();
        }
    }

    fn lost(&mut self) {
        self.port = None;
        self.machine.unplugged();
    }

    /// Reads bytes and handles them.
    fn listen(&mut self) {
        let Some(port) = &mut self.port else { return };
        let Ok(bytes) = port.read() else { return self.lost() };
        let now = port.now();
        self.machine.advance(&bytes, now);
        for warning in port.warnings() {
            self.machine.report(Event::Warning(warning));
        }
        if self.machine.has_finished()
            && let Some(made) = port.made()
        {
            self.machine.report(made);
        }
        self.machine.settle();
        self.flush();
        if self.machine.is_closed() {
            self.port = None;
        }
    }
}

fn gone() -> DriverError {
    DriverError::new("disconnected", "the connection to the machine is gone", "connect it again")
}

/// `sim`, `sim:10` or `sim:max`; `None` for another port.
fn pace(name: &str) -> Result<Option<SimulationSpeed>, DriverError> {
    let Some(rest) = name.strip_prefix(SIMULATED) else { return Ok(None) };
    match rest.strip_prefix(':') {
        None if rest.is_empty() => Ok(Some(SimulationSpeed::Times(1.0))),
        None => Ok(None),
        Some("max") => Ok(Some(SimulationSpeed::Unlimited)),
        Some(times) => match times.parse::<f64>() {
            Ok(times) if (0.01..=10_000.0).contains(&times) => Ok(Some(SimulationSpeed::Times(times))),
            _ => Err(DriverError::new(
                "no-port",
                format!("'{name}' is no simulated machine"),
                "use sim for one in real time, sim:10 for ten times as fast, sim:max for as fast as it goes",
            )),
        },
    }
}

impl MachineSession for Session {
    fn home(&mut self) -> Result<(), DriverError> {
        self.call(|machine, now| machine.home(None, now))
    }

    fn home_from(&mut self, head_at_deg: f64) -> Result<(), DriverError> {
        self.call(|machine, now| machine.home(Some(head_at_deg), now))
    }

    fn arm(&mut self, run: &Run) -> Result<ArmedReply, DriverError> {
        let port = self.port.as_mut().ok_or_else(gone)?;
        // The rest of a wire stays in the simulated machine; of one of which nothing is fed there is none, however its head is to stand.
        if run.after == 0 && run.fed_mm == 0.0 {
            port.load(run.bench.as_deref())?;
        }
        self.call(|machine, now| machine.arm(run, now))
    }

    fn send(&mut self, batch: &Batch) -> Result<Sent, DriverError> {
        self.call(|machine, now| machine.send(batch, now))
    }

    fn jog(&mut self, motion: Motion) -> Result<(), DriverError> {
        self.call(|machine, _| machine.jog(motion))
    }

    fn pause(&mut self) -> Result<(), DriverError> {
        self.call(|machine, _| {
            machine.pause();
            Ok(())
        })
    }

    fn resume(&mut self) -> Result<(), DriverError> {
        self.call(|machine, _| {
            machine.resume();
            Ok(())
        })
    }

    fn set_speed(&mut self, percent: u8) -> Result<(), DriverError> {
        self.call(|machine, _| machine.set_speed(percent))
    }

    fn console(&mut self, line: &ConsoleLine, may_change: bool) -> Result<(), DriverError> {
        self.call(|machine, _| machine.typed(line, may_change))
    }

    fn write_settings(&mut self) -> Result<(), DriverError> {
        self.call(|machine, _| machine.write_settings())
    }

    fn stop(&mut self) -> Result<(), DriverError> {
        self.call(|machine, now| {
            machine.stop(now);
            Ok(())
        })
    }

    fn poll(&mut self) -> Result<Option<Event>, DriverError> {
        let begun = Instant::now();
        loop {
            if let Some(event) = self.machine.take_event() {
                return Ok(Some(event));
            }
            self.listen();
            // A simulated machine runs until something happens, or it has caught up with the clock.
            let more = self.port.as_ref().is_some_and(|port| port.has_more());
            if !more || begun.elapsed() >= POLL {
                return Ok(self.machine.take_event());
            }
        }
    }
}

impl Session {
    /// A STOP is repeated until it is answered, for as long as closing a port may take.
    fn see_stop_through(&mut self) {
        let begun = Instant::now();
        while self.port.is_some() && self.machine.is_stopping() && begun.elapsed() < LAST_STOP {
            self.listen();
        }
    }
}

impl Drop for Session {
    /// Nothing moves after the port is closed: the machine decelerates and holds, so that the job can be resumed. If the
    /// command does not arrive, the machine holds by itself after its step.
    fn drop(&mut self) {
        self.see_stop_through();
        if let Some(port) = &mut self.port
            && self.machine.is_moving()
        {
            let _ = port.write(&self.machine.last_hold());
        }
    }
}
