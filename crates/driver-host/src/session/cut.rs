//! What was bent is cut off.

use wirebend_driver_api::{Call, Capability};

use super::phase::Act;
use super::{Permit, PermitKind, Session, SessionError};

impl Session {
    /// Cuts off what was bent; `cut` reports that it is. The tip of the wire is where the next one begins then.
    ///
    /// # Errors
    /// [`SessionError`].
    pub fn cut(&mut self, row: &Permit) -> Result<(), SessionError> {
        self.require(Capability::Cut)?;
        let next = self.may(Act::Cut)?;
        self.permits(row, "cutting the wire off", &[PermitKind::Row])?;
        self.guard.forget();
        let called = self.motion("cutting the wire off", &Call::Cut);
        self.faulting(called)?;
        self.phase = next;
        Ok(())
    }
}
