//! The machine's own settings.

use super::event::QuestionKind;
use super::order::OrderName;
use super::post::Post;
use crate::AppError;
use crate::machine_settings::{QUESTION, lines};

impl Post<'_> {
    /// Sets the machine as its profile says. Its axes count otherwise afterwards: what was said before does not hold
    /// any more.
    pub fn write_settings(&mut self) -> Result<(), AppError> {
        let lines = lines(self.connected(OrderName::WriteSettings)?);
        let yes = self.ask(QuestionKind::Settings, lines, QUESTION)?;
        (self.leave, self.armed, self.at_reference) = (None, None, false);
        let machine = self.machine.profile.id.clone();
        let connection = self.connected(OrderName::WriteSettings)?;
        connection.write_settings(&yes)?;
        // What a machine does not take it bends by all the same.
        Ok(connection.require_settings(&machine, false)?)
    }
}
