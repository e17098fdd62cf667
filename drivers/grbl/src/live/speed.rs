//! The speed override.
//!
//! grbl has it as steps of ten and of one percent. It notes that a step has come and not how often, so that two of them between two turns
//! of its loop are one (`serial.c`, `protocol.c`). So each waits for the report of the one before.

use std::time::Duration;

use wirebend_driver_api::{DriverError, Event};

use super::phase::Phase;
use super::protocol::Protocol;
use super::speeds::{FEED_FULL, FULL, RAPID_FULL, REPORTS, Speeds};

impl Protocol {
    pub fn set_speed(&mut self, percent: u8, now: Duration) -> Result<(), DriverError> {
        self.now = now;
        if !matches!(self.phase, Phase::Running(_)) {
            return Err(DriverError::new("not-running", "nothing runs whose speed could be changed", ""));
        }
        if self.speed.now.is_none() {
            self.restore_full_speed();
        }
        self.speed.wanted = Some(Speeds::nearest(percent));
        self.speed.awaited = 0;
        self.steer();
        Ok(())
    }

    /// A wire begins and ends with it. What sets all of it counts however often it comes.
    pub(super) fn restore_full_speed(&mut self) {
        if self.speed.now != Some(FULL) || self.speed.wanted.is_some() {
            self.send_realtime(FEED_FULL);
            self.send_realtime(RAPID_FULL);
            (self.speed.now, self.speed.wanted) = (Some(FULL), None);
        }
    }

    /// A report, with the speeds where they have changed, and now and then.
    pub(super) fn report_speeds(&mut self, speeds: Option<Speeds>) {
        if let Some(speeds) = speeds {
            (self.speed.now, self.speed.awaited) = (Some(speeds), 0);
        } else {
            self.speed.awaited = self.speed.awaited.saturating_sub(1);
        }
        // Also where it was changed at the machine, or has ended with a reset.
        let percent = self.speed.now.map_or(self.speed.told, |speeds| speeds.of_moves(&self.settings));
        if std::mem::replace(&mut self.speed.told, percent) != percent {
            self.event(Event::Speed { percent });
        }
        self.steer();
    }

    /// The next step towards the speed that is wanted.
    fn steer(&mut self) {
        let (Some(now), Some(wanted)) = (self.speed.now, self.speed.wanted) else { return };
        if now == wanted {
            self.speed.wanted = None;
        } else if self.speed.awaited == 0 {
            for byte in now.towards(wanted) {
                self.send_realtime(byte);
            }
            self.speed.awaited = REPORTS;
        }
    }
}
