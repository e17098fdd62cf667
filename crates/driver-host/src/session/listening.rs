//! What a driver reports, and how far it is believed.

use wirebend_driver_api::{Event, SettingCheck};

use super::axes::AxisOffsets;
use super::{Contact, Phase, Session, SessionError, Standstill};

impl Session {
    /// Takes what the driver reports, and moves the state along.
    ///
    /// # Errors
    /// [`SessionError::Host`] when the driver fails or refuses, [`SessionError::OutOfOrder`] when its account
    /// cannot be true: the state is [`Phase::Failed`] then.
    pub fn poll(&mut self) -> Result<Vec<Event>, SessionError> {
        if self.contact == Contact::Ended && self.guard.standstill() == Some(Standstill::Awaited) {
            // The program itself waits for the machine; nothing else hears it.
            return Ok(Vec::new());
        }
        let polled = self.driver.poll();
        // A driver that refuses to report no longer trusts its connection.
        let mut events = polled.inspect_err(|_| self.driver_failed())?;
        self.head.listens();
        for event in &mut events {
            if let Event::Connected { resume, .. } = event
                && !self.resuming
            {
                // It does not know of which wire.
                *resume = None;
            }
            self.count_own_stop(event);
            if let Event::Fault { disconnected: true, .. } = event {
                self.contact = self.contact.max(Contact::Gone);
            }
            self.take_note(event)?;
            self.head.hears(event, self.reference);
            self.phase = self.phase.after(event);
        }
        self.notice_stop();
        self.see_stop_through();
        Ok(events)
    }

    /// A stop at the machine itself ends what was confirmed before it, too.
    fn count_own_stop(&self, event: &Event) {
        let at_rest = matches!(self.phase, Phase::Connecting | Phase::Stopped | Phase::Failed);
        let own = self.guard.standstill() != Some(Standstill::Awaited) && !at_rest;
        if own && matches!(event, Event::Stopped { .. }) {
            self.arming.count_stop();
        }
    }

    /// What an event says of the wire and of the axes. A driver that skips a step, reports one that it was not
    /// sent, or a wire as finished before its last step is done, is not to be believed.
    fn take_note(&mut self, event: &Event) -> Result<(), SessionError> {
        let complete = self.done == self.sent && self.steps == Some(self.done);
        let believed = match event {
            Event::Done { n } | Event::PartMade { step: n, .. } => *n == self.done + 1 && *n <= self.sent,
            Event::Finished => complete || !matches!(self.phase, Phase::Making | Phase::Holding),
            Event::Connected { resume: Some(resume), .. } => resume.done <= resume.accepted,
            _ => true,
        };
        match event {
            Event::Done { n } if believed => self.done = *n,
            Event::Homed => {
                self.off = AxisOffsets::default();
                self.guard.rests();
            }
            Event::Position(position) => self.position = Some(*position),
            Event::Speed { percent } => self.speed_percent = *percent,
            Event::Jogged => self.guard.rests(),
            Event::Cut if self.phase == Phase::Cutting => self.guard.rests(),
            // One that comes late says nothing of what moves now.
            Event::ConsoleDone { .. } if self.phase == Phase::Commanded => self.guard.rests(),
            Event::Finished if believed => self.guard.rests(),
            Event::Stopped { .. } => self.guard.confirm(),
            // It no longer waits for the stop.
            Event::Fault { .. } if self.guard.standstill() == Some(Standstill::Awaited) => self.lose_driver(),
            Event::Fault { .. } if self.phase != Phase::Connecting && self.guard.concerns() => self.halt(),
            Event::Connected { settings, resume, identity, reference, done_by, limits, .. } => {
                (self.reference, self.done_by) = (*reference, *done_by);
                self.limits.clone_from(limits);
                self.identity.clone_from(identity);
                self.off = AxisOffsets::default();
                self.differences = differences(settings);
                self.resume = *resume;
                if resume.is_none() {
                    self.guard.rests();
                }
                if let Some(resume) = resume {
                    (self.sent, self.done) = (resume.accepted, resume.done);
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

/// Those with which wires come out wrong.
fn differences(settings: &[SettingCheck]) -> Vec<SettingCheck> {
    settings.iter().filter(|setting| setting.matters).cloned().collect()
}
