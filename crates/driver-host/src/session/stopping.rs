//! What a session does about stops and about the loss of its driver.

use wirebend_driver_api::Capability;

use super::standstill::{DRIVER_CONFIRMS_WITHIN, GIVE_UP_AFTER, Standstill};
use super::stop::{StopHandle, StopOutcome};
use super::{Contact, Phase, Session};

impl Session {
    /// Stops the machine; see [`StopHandle::stop`].
    pub fn stop(&mut self) -> StopOutcome {
        let outcome = self.stop_handle().stop();
        self.notice_stop();
        if outcome.driver_ended {
            self.driver_failed();
        }
        outcome
    }

    /// Whether the machine stands after the last stop, after its driver was lost, or after a fault while it might move;
    /// `None` when there was none of them since. While it is awaited, [`Session::poll`] follows it.
    #[must_use]
    pub fn standstill(&self) -> Option<Standstill> {
        self.guard.standstill()
    }

    /// How the last stop through this session or one of its handles went.
    #[must_use]
    pub fn last_stop(&self) -> Option<StopOutcome> {
        self.arming.stopped()
    }

    /// The same, and forgets it: a caller that continues with the session has heard of it. What it ended stays ended.
    #[must_use]
    pub fn take_stop(&mut self) -> Option<StopOutcome> {
        self.notice_stop();
        self.guard.forget();
        let outcome = self.arming.take_stopped();
        if outcome.is_some_and(|outcome| outcome.driver_ended) {
            self.is_out_of_contact(Contact::Gone);
        }
        outcome
    }

    /// What stops the machine from any thread, whatever this one is doing.
    #[must_use]
    pub fn stop_handle(&self) -> StopHandle {
        let can_stop = self.driver.description().can(Capability::Stop);
        StopHandle::new(self.driver.handle(), self.arming.clone(), can_stop, self.guard.copy())
    }

    /// Learns of a stop through a handle, whether or not the driver reports it.
    pub(super) fn notice_stop(&mut self) {
        // Before the arming: a stop in between is noticed once more.
        self.known_stops = self.arming.stops();
        let now = self.arming.now();
        if now != self.known {
            self.known = now;
            if !matches!(self.phase, Phase::Connecting | Phase::Failed) {
                let awaited = self.guard.standstill() == Some(Standstill::Awaited);
                self.phase = if awaited { Phase::Stopping } else { Phase::Stopped };
            }
        }
    }

    /// A driver that does not bring the machine's confirmation in time is ended: the program asks for it itself.
    pub(super) fn see_stop_through(&mut self) {
        let Some(awaited) = self.guard.awaited_for() else { return };
        if awaited > DRIVER_CONFIRMS_WITHIN
            && self.contact != Contact::Ended
            && self.guard.settles_without_driver()
        {
            self.lose_driver();
        } else if awaited > GIVE_UP_AFTER && !self.guard.settles_without_driver() {
            self.guard.give_up();
            self.phase = Phase::Failed;
        }
    }

    /// The driver has reported a fault while the machine may move. Whether that has ended the motion the driver need not
    /// know, and what the machine was sent before it may still run: it is stopped as by a person, and says that it stands.
    pub(super) fn halt(&mut self) {
        if self.stop_handle().halt().driver_ended {
            self.driver_failed();
        }
    }

    /// What it was asked it did not do, and it may be gone. Where the machine may move, nothing more is left to it.
    pub(super) fn driver_failed(&mut self) {
        if self.guard.concerns() {
            self.lose_driver();
        }
        self.is_out_of_contact(Contact::Gone);
    }

    /// It is not asked for anything any more: that would only fail once more.
    fn is_out_of_contact(&mut self, contact: Contact) {
        (self.phase, self.contact) = (Phase::Failed, self.contact.max(contact));
        self.share_port();
    }

    /// Ends the driver: the guard then stops the machine.
    pub(super) fn lose_driver(&mut self) {
        self.driver.handle().kill();
        // One that had ended before was noticed then.
        self.guard.driver_is_lost();
        self.is_out_of_contact(Contact::Ended);
    }

    /// Lets a new driver open the port although this program keeps it.
    pub(super) fn share_port(&self) {
        if let Some(line) = self.guard.line() {
            line.share();
        }
    }
}
