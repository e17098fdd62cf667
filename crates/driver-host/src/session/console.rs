//! Lines that a person types for the machine.

use wirebend_driver_api::{Call, Capability, ConsoleLine, DriverError};

use super::phase::Act;
use super::{Permit, PermitKind, Session, SessionError};
use crate::error::HostError;

impl Session {
    /// Passes on a question: the driver takes it only if nothing moves or changes for it. The answer comes by [`Session::poll`], until
    /// `console-done`. Whether it was taken: false for a line that may move or change something, which needs
    /// [`Session::command`].
    ///
    /// # Errors
    /// [`SessionError`], such as for a line that the driver does not pass on at all.
    pub fn question(&mut self, line: &str) -> Result<bool, SessionError> {
        let next = self.may_type(Act::Ask)?;
        let call = self.console_call(line, false)?;
        let called = self.driver.call("a line of the console", &call);
        if let Err(HostError::Refused { error, .. }) = &called
            && error.code == DriverError::NOT_A_QUESTION
        {
            return Ok(false);
        }
        self.faulting(called)?;
        self.phase = next;
        Ok(true)
    }

    /// Passes on a line that may move the machine or change what it has stored. From here on nothing is known of where the axes are:
    /// the machine has to be homed after `console-done`, unless the driver says there that it was a question.
    ///
    /// # Errors
    /// [`SessionError`].
    pub fn command(&mut self, line: &str, permit: Permit) -> Result<(), SessionError> {
        let next = self.may_type(Act::Command)?;
        self.uses_up(permit, "a line of the console", PermitKind::Console)?;
        self.guard.forget();
        let call = self.console_call(line, true)?;
        let place = self.head.may_be_anywhere()?;
        let called = self.motion("a line of the console", &call);
        self.faulting_before(called, place)?;
        // What was done of a wire does not count for one that is looked for in it.
        (self.phase, self.steps) = (next, None);
        Ok(())
    }

    fn may_type(&self, act: Act) -> Result<super::Phase, SessionError> {
        self.require(Capability::Console)?;
        self.may(act)
    }

    /// What no driver is sent is refused here.
    fn console_call(&self, line: &str, may_change: bool) -> Result<Call, SessionError> {
        let driver = || self.driver.description().id.clone();
        let line = ConsoleLine::new(line).map_err(|error| HostError::Refused { driver: driver(), error })?;
        Ok(Call::Console { line: line.as_str().to_owned(), may_change })
    }
}
