//! What a driver written in Rust implements.

use schemars::JsonSchema;
use serde::de::DeserializeOwned;

use crate::{
    ArmedReply, Batch, ConsoleLine, Description, DriverError, Encoded, Event, Job, Limits, Motion, Port, Run,
    Sent,
};

/// A driver: settings turned into something that writes jobs and, where it can, moves a machine.
///
/// A panic in any method becomes an error of that call, and ends the instance.
pub trait MachineDriver: Sized + 'static {
    /// Its settings. `#[serde(default, deny_unknown_fields)]`, so that `{}` is enough and a misspelt key
    /// is refused by name; every field documented with its unit, since people see that text in a form.
    type Settings: DeserializeOwned + JsonSchema + Default;

    /// What it is and can do. The settings' schema is filled in from [`MachineDriver::Settings`].
    fn describe() -> Description;

    /// Takes settings that have the right shape.
    ///
    /// # Errors
    /// [`DriverError`] that names the key whose value makes no sense.
    fn open(settings: Self::Settings) -> Result<Self, DriverError>;

    /// Writes a job. The same job gives the same bytes.
    ///
    /// # Errors
    /// [`DriverError`] that names the wire and the step that the format cannot hold.
    fn encode(&self, format: &str, job: &Job) -> Result<Encoded, DriverError>;

    /// How far the axes go and how fast, with these settings and whatever else the driver knows of its machine: what
    /// [`MachineDriver::encode`] and [`MachineSession::send`] would refuse is here, so that no wire is begun that
    /// cannot be ended.
    fn limits(&self) -> Limits {
        Limits::default()
    }

    /// The ports that a machine can be at. With the feature `serial`, `serial::ports` lists those of the
    /// computer.
    ///
    /// # Errors
    /// [`DriverError`] when the system does not report it.
    fn ports(&self) -> Result<Vec<Port>, DriverError> {
        Err(DriverError::unsupported("list ports"))
    }

    /// Opens a port. Does not wait for the machine: its greeting is reported by `poll`. With the token of an
    /// earlier arming in `resume` it tries to resume the machine's own session, and `connected` reports
    /// whether the machine still is in it; a driver without such sessions passes over it.
    ///
    /// # Errors
    /// [`DriverError`] that names the port and says how to get at it.
    fn connect(&self, _port: &str, _resume: Option<&str>) -> Result<Box<dyn MachineSession>, DriverError> {
        Err(DriverError::unsupported("move a machine: it writes files"))
    }
}

/// A connection to a machine. Dropping it closes the port.
///
/// Every method starts something and returns within [`deadline::CALL`](crate::deadline::CALL); what
/// becomes of it is reported by [`MachineSession::poll`]. The program calls `home`, `arm`, `send` and
/// `jog` only when the state of the session allows it; a driver refuses what it knows to be wrong all
/// the same.
pub trait MachineSession {
    /// Finds the machine's reference. Where a person brings the axes there, as `connected` has reported
    /// ([`ReferenceBy::Person`](crate::ReferenceBy::Person)), nothing moves: they stand there now.
    ///
    /// # Errors
    /// [`DriverError`].
    fn home(&mut self) -> Result<(), DriverError> {
        Err(DriverError::unsupported("home the machine"))
    }

    /// The same for a machine that has reported [`HeadBy::Program`](crate::HeadBy::Program): the head stands so many degrees
    /// from its zero, in the machine's signs, and is turned back there.
    ///
    /// # Errors
    /// [`DriverError`].
    fn home_from(&mut self, _head_at_deg: f64) -> Result<(), DriverError> {
        self.home()
    }

    /// Makes ready for a wire, or for the rest of one: steps come from the one after [`Run::after`] on. Nothing
    /// moves. While the machine resumes the session of an earlier token, the run is that of the token, and
    /// what the machine has taken already it keeps.
    ///
    /// # Errors
    /// [`DriverError`].
    fn arm(&mut self, run: &Run) -> Result<ArmedReply, DriverError>;

    /// Takes as many steps as it has room for, from the first.
    ///
    /// # Errors
    /// [`DriverError`], such as for a gap in the numbers; then no step was taken.
    fn send(&mut self, batch: &Batch) -> Result<Sent, DriverError>;

    /// Moves one axis. What it means for the bend axis of a machine with a peg: see
    /// [`Call::Jog`](crate::Call::Jog).
    ///
    /// # Errors
    /// [`DriverError`].
    fn jog(&mut self, _motion: Motion) -> Result<(), DriverError> {
        Err(DriverError::unsupported("move a single axis"))
    }

    /// Holds the machine.
    ///
    /// # Errors
    /// [`DriverError`].
    fn pause(&mut self) -> Result<(), DriverError> {
        Err(DriverError::unsupported("hold the machine"))
    }

    /// Resumes after a pause.
    ///
    /// # Errors
    /// [`DriverError`].
    fn resume(&mut self) -> Result<(), DriverError> {
        Err(DriverError::unsupported("hold the machine"))
    }

    /// Stops the machine at once and forgets what was not begun. A machine that cannot be stopped says
    /// so here, and whatever it has not been sent yet is not sent.
    ///
    /// # Errors
    /// [`DriverError`].
    fn stop(&mut self) -> Result<(), DriverError>;

    /// [`Call::Speed`](crate::Call::Speed).
    ///
    /// # Errors
    /// What the machine cannot do.
    fn set_speed(&mut self, _percent: u8) -> Result<(), DriverError> {
        Err(DriverError::unsupported("change the speed"))
    }

    /// [`Call::Console`](crate::Call::Console). What the driver does by itself, and what would leave the machine in a state that the
    /// driver does not follow, it refuses.
    ///
    /// # Errors
    /// [`DriverError`] that says why the line is not passed on; [`DriverError::not_a_question`] where it needs `may_change`.
    fn console(&mut self, _line: &ConsoleLine, _may_change: bool) -> Result<(), DriverError> {
        Err(DriverError::unsupported("take typed lines"))
    }

    /// [`Call::Cut`](crate::Call::Cut).
    ///
    /// # Errors
    /// [`DriverError`], such as where the settings have no cutter.
    fn cut(&mut self) -> Result<(), DriverError> {
        Err(DriverError::unsupported("cut the wire"))
    }

    /// Writes the driver's settings to the machine, for good. Nothing moves.
    ///
    /// # Errors
    /// [`DriverError`], such as while a wire is bent.
    fn write_settings(&mut self) -> Result<(), DriverError> {
        Err(DriverError::unsupported("write settings to the machine"))
    }

    /// The next event, if there is one. Does not wait.
    ///
    /// # Errors
    /// [`DriverError`] where the connection is no longer to be trusted.
    fn poll(&mut self) -> Result<Option<Event>, DriverError>;
}
