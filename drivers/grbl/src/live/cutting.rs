//! A piece cut off: the wire is fed to the cutter, cut, and brought back.

use std::time::Duration;

use wirebend_driver_api::{Axis, DriverError, Event, Motion};

use super::jog_row::JogRow;
use super::phase::Phase;
use super::protocol::Protocol;
use crate::program::pin_in_lines;

impl Protocol {
    /// The wire comes back as far as it went, so that the zero of the feed stays.
    pub fn cut(&mut self, now: Duration) -> Result<(), DriverError> {
        self.now = now;
        self.ready()?;
        if self.settings.cut.is_empty() {
            let help = "write the lines that cut the wire into 'cut'";
            return Err(DriverError::new("no-cutter", "the settings have no lines that cut the wire", help));
        }
        self.at_rest()?;
        self.has_axes()?;
        if !self.machine.homed {
            return Err(not_homed());
        }
        let s = &self.settings;
        let mut row = JogRow::new(self.machine.reported(s));
        let (there, end) = self.jog_line(Motion::new(Axis::Feed, s.cutter_mm))?;
        let (back, _) = self.jog_line(Motion::new(Axis::Feed, -s.cutter_mm))?;
        row.push(pin_in_lines(s).collect(), [0.0; 3]);
        row.push(there.into_iter().collect(), end);
        row.push(s.cut.clone(), end);
        row.push(back.into_iter().collect(), [0.0; 3]);
        self.phase = Phase::Cutting(row);
        self.row_on();
        Ok(())
    }

    /// The machine rests with every line answered.
    pub(super) fn cut_rests(&mut self) {
        let Phase::Cutting(row) = &mut self.phase else { return };
        if let Err(error) = row.arrived(&self.machine, &self.settings) {
            // A report may have been damaged itself: wait for the next one.
            if std::mem::replace(&mut row.displaced, true) {
                self.machine.homed = false;
                self.fail(error);
            }
            return;
        }
        if !self.row_on() {
            self.phase = Phase::Ready;
            self.event(Event::Cut);
        }
    }
}

pub(super) fn not_homed() -> DriverError {
    DriverError::new("not-homed", "it is not known where the axes are", "home the machine first")
}
