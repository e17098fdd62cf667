//! Lines that a person types.

use wirebend_driver_host::{HostError, OrderName, PermitKind, SessionError};
use wirebend_error::ProblemReport;

use super::question::QuestionKind;
use super::thread::OperatorThread;
use crate::console::{QUESTION, ask, command, lines, require};
use crate::{LiveProblem, OperationError};

impl OperatorThread<'_> {
    /// Passes on a line. What may move or change something is asked about each time: it can be anything.
    pub fn console(&mut self, line: &str) -> Result<(), OperationError> {
        let connection = self.connected(OrderName::Console)?;
        require(connection)?;
        match ask(connection, line, &mut |_| {}) {
            Ok(true) => return Ok(()),
            Ok(false) => {}
            // Nothing was sent, and the machine stands as before.
            Err(error @ LiveProblem::Session(SessionError::Host(HostError::Refused { .. }))) => {
                self.shared.problem(ProblemReport::from(&error));
                return Ok(());
            }
            Err(error) => return Err(error.into()),
        }
        let (about, simulation) = (lines(connection, line), connection.session.simulated());
        let permit = match simulation {
            Some(simulation) => simulation.permit(PermitKind::Console),
            None => self.ask(QuestionKind::Console, PermitKind::Console, about, QUESTION)?,
        };
        (self.jog_permit, self.armed, self.at_reference) = (None, None, false);
        Ok(command(self.connected(OrderName::Console)?, line, permit, &mut |_| {})?)
    }
}
