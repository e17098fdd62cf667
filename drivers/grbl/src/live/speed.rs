//! The speed override.
//!
//! grbl has it as steps of ten and of one percent. It notes that a step has come and not how often, so that two of them between two turns
//! of its loop are one (`serial.c`, `protocol.c`). So each waits for the report of the one before.

use std::time::Duration;

use wirebend_driver_api::{DriverError, Event};

use super::phase::Phase;
use super::protocol::Protocol;
use super::speeds::{FEED_FULL, FULL, RAPID_FULL, REPORTS, Speeds};
use crate::settings::Moves;

impl Protocol {
    pub fn set_speed(&mut self, percent: u8, now: Duration) -> Result<(), DriverError> {
        self.now = now;
        if !matches!(&self.phase, Phase::Running(run) if !run.is_armed_only()) {
            return Err(DriverError::new("not-running", "nothing runs whose speed could be changed", ""));
        }
        if !self.speed.reported {
            let what = "the machine does not report its speed override, so that it cannot be followed";
            return Err(DriverError::new("no-override", what, "use a grbl that has 'Ov' in its reports"));
        }
        if self.settings.moves == Moves::Rapid && percent > FULL.rapid {
            let what = "rapid moves go no faster than the board's settings say";
            return Err(DriverError::new("no-faster", what, "raise its rates, $110 to $112"));
        }
        self.speed.wanted = Some(self.speed.now.unwrap_or(FULL).nearest(percent));
        self.steer();
        Ok(())
    }

    /// A wire begins and ends with it. What sets all of it counts however often it comes.
    pub(super) fn restore_full_speed(&mut self) {
        if self.speed.now != Some(FULL) || self.speed.wanted.is_some() || self.speed.awaited > 0 {
            self.send_realtime(FEED_FULL);
            self.send_realtime(RAPID_FULL);
            (self.speed.now, self.speed.wanted, self.speed.awaited) = (Some(FULL), None, 0);
        }
    }

    /// A report, with the speeds where they have changed, and now and then.
    pub(super) fn report_speeds(&mut self, speeds: Option<Speeds>) {
        self.speed.reported |= speeds.is_some();
        // One from before the step that was sent has no effect of it.
        if let Some(speeds) = speeds.filter(|speeds| Some(*speeds) != self.speed.now) {
            (self.speed.now, self.speed.awaited) = (Some(speeds), 0);
        } else if self.speed.awaited == 1 && matches!(self.phase, Phase::Running(_)) {
            self.restore_full_speed();
            self.event(Event::Warning(DriverError::new(
                "speed-not-changed",
                "the machine does not follow its speed override: it has all of its speed again",
                "see which speeds it is built for",
            )));
        } else {
            self.speed.awaited = self.speed.awaited.saturating_sub(1);
        }
        // Also where it was changed at the machine, or has ended with a reset.
        let percent = self.speed.now.map_or(self.speed.told, |speeds| speeds.of_moves(&self.settings));
        if std::mem::replace(&mut self.speed.told, percent) != percent {
            self.event(Event::Speed { percent });
        }
    }

    /// The next step towards the speed that is wanted, once the one before was seen.
    pub(super) fn steer(&mut self) {
        let (Phase::Running(_), Some(now), Some(wanted)) = (&self.phase, self.speed.now, self.speed.wanted)
        else {
            return;
        };
        if self.speed.awaited > 0 {
            return;
        }
        if now == wanted {
            self.speed.wanted = None;
            return;
        }
        for byte in now.towards(wanted) {
            self.send_realtime(byte);
        }
        self.speed.awaited = REPORTS;
    }
}
