//! What a driver reports, and how far it is believed.

use wirebend_driver_api::{Event, SettingCheck};

use super::axes::OffZero;
use super::{Session, SessionError, Standstill, State};

impl Session {
    /// Takes what the driver reports, and moves the state along.
    ///
    /// # Errors
    /// [`SessionError::Host`] when the driver fails or refuses, [`SessionError::OutOfOrder`] when its account
    /// cannot be true: the state is [`State::Faulted`] then.
    pub fn poll(&mut self) -> Result<Vec<Event>, SessionError> {
        if self.lost && self.guard.standstill() == Some(Standstill::Awaited) {
            // The program itself waits for the machine; there is nobody else to hear.
            return Ok(Vec::new());
        }
        let polled = self.driver.poll();
        // A driver that refuses to report no longer trusts its connection.
        let mut events = polled.inspect_err(|_| self.driver_failed())?;
        self.head.listens();
        for event in &mut events {
            if let Event::Connected { going_on, .. } = event
                && !self.resuming
            {
                // Nobody has told it of which wire.
                *going_on = None;
            }
            self.take_note(event)?;
            self.head.hears(event, self.reference);
            self.state = self.state.after(event);
        }
        self.notice_stop();
        self.see_stop_through();
        Ok(events)
    }

    /// What an event says of the wire and of the axes. A driver that skips a step, reports one that it was not
    /// sent, or a wire as made before its last step is, is not to be believed.
    fn take_note(&mut self, event: &Event) -> Result<(), SessionError> {
        let complete = self.done == self.sent && self.steps == Some(self.done);
        let believed = match event {
            Event::Done { n } | Event::PartMade { step: n, .. } => *n == self.done + 1 && *n <= self.sent,
            Event::Finished => complete || !matches!(self.state, State::Running | State::Paused),
            Event::Connected { going_on: Some(going_on), .. } => going_on.done <= going_on.accepted,
            _ => true,
        };
        match event {
            Event::Done { n } if believed => self.done = *n,
            Event::Homed => {
                self.off = OffZero::default();
                self.guard.rests();
            }
            Event::Jogged => self.guard.rests(),
            Event::Finished if believed => self.guard.rests(),
            Event::Stopped { .. } => self.guard.confirm(),
            // It no longer waits for the stop.
            Event::Fault { .. } if self.guard.standstill() == Some(Standstill::Awaited) => self.lose_driver(),
            Event::Fault { .. } if self.state != State::Disconnected && self.guard.concerns() => self.halt(),
            Event::Connected { settings, going_on, identity, reference, done_by, limits, .. } => {
                (self.reference, self.done_by) = (*reference, *done_by);
                self.limits.clone_from(limits);
                self.identity.clone_from(identity);
                self.off = OffZero::default();
                self.differences = differences(settings);
                self.going_on = *going_on;
                if going_on.is_none() {
                    self.guard.rests();
                }
                if let Some(going_on) = going_on {
                    (self.sent, self.done) = (going_on.accepted, going_on.done);
                }
            }
            Event::SettingsWritten { settings, limits } => {
                self.differences = differences(settings);
                self.limits.clone_from(limits);
            }
            Event::Paused { .. } => self.holds = true,
            Event::Resumed => self.holds = false,
            _ => {}
        }
        if believed {
            return Ok(());
        }
        self.driver_failed();
        let n = if let Event::Done { n } | Event::PartMade { step: n, .. } = event { *n } else { self.done };
        Err(SessionError::OutOfOrder { n, done: self.done, sent: self.sent })
    }
}

/// Those that make wires come out wrong.
fn differences(settings: &[SettingCheck]) -> Vec<SettingCheck> {
    settings.iter().filter(|setting| setting.matters).cloned().collect()
}
