//! The machine's own settings.

use wirebend_driver_host::{OrderName, PermitKind};

use super::question::QuestionKind;
use super::thread::OperatorThread;
use crate::OperationError;
use crate::machine_settings::{QUESTION, lines};

impl OperatorThread<'_> {
    /// Sets the machine as its profile says. Its axes count otherwise afterwards: what was said before does not hold
    /// any more.
    pub fn write_settings(&mut self) -> Result<(), OperationError> {
        let lines = lines(self.connected(OrderName::WriteSettings)?);
        let permit = self.ask(QuestionKind::Settings, PermitKind::Settings, lines, QUESTION)?;
        (self.jog_permit, self.armed, self.at_reference) = (None, None, false);
        let machine = self.machine.profile.id.clone();
        let connection = self.connected(OrderName::WriteSettings)?;
        connection.write_settings(permit)?;
        // What a machine does not take it bends by anyway.
        Ok(connection.require_settings(&machine, false)?)
    }
}
