//! How things end: stopped, alarmed, lost, and how far the step was that an end has met in its middle.

use std::time::Duration;

use wirebend_driver_api::{DriverError, Event, Step};

use super::fault;
use super::machine::{Doing, Ending, Halt, Homing, Machine, session_id};
use super::wire::Wire;
use crate::protocol::{Alarm, Status};

/// How long an end may wait for where the axes stand: an answer takes 20 ms on a line that is not disturbed, and longer where
/// the computer is busy. Without it a person has to measure.
const STANDS_WITHIN: Duration = Duration::from_millis(1500);

impl Machine {
    pub(super) fn alarmed(&mut self, alarm: Alarm, now: Duration) {
        if matches!(alarm, Alarm::HostLost | Alarm::HoldInput) {
            return; // the status tells of the hold
        }
        match self.doing {
            Doing::Homing(Homing::Stopping) => {
                self.renew(session_id(self.link.session()), now);
                self.doing = Doing::Homing(Homing::Opening);
                return;
            }
            // Of before it took the line that leaves the alarm.
            Doing::Homing(Homing::Opening | Homing::Placing | Homing::Searching { accepted: false, .. })
                if self.halt != Halt::Asked =>
            {
                return;
            }
            Doing::Connecting | Doing::Over => return,
            _ => {}
        }
        let asked = self.halt == Halt::Asked;
        if std::mem::replace(&mut self.halt, Halt::Told(alarm)) == Halt::Told(alarm) {
            return;
        }
        let in_doubt = self.in_doubt();
        let (wire, exact) = (self.wire.take(), self.held);
        self.give_up();
        let mut events = Vec::new();
        if alarm == Alarm::Stop {
            if !asked {
                events.push(Event::Warning(fault::stopped_unasked()));
            }
            events.push(Event::Stopped { homed: false });
        } else {
            events.push(Event::Fault { error: fault::alarm(alarm), in_doubt, disconnected: false });
        }
        self.link.query();
        // A switch that is hit, and power that is cut, may have moved what the controller has not.
        let counted = alarm == Alarm::Stop;
        self.ending = Some(Ending { events, wire, exact, counted, until: now + STANDS_WITHIN });
    }

    /// Which step an end has met in its middle, and how far it was.
    pub(super) fn tell_part(&mut self, status: Status) {
        let per = [self.settings.feed_steps_per_mm, self.rotate_steps_per_deg()];
        let stands = self.in_units(status.position);
        let Some(Ending { wire: Some(wire), exact, counted, .. }) = &mut self.ending else { return };
        let done = wire.made(status.done).map(|n| Event::Done { n });
        let part = wire.part_made([status.position[0], status.position[1]], per).filter(|_| *counted);
        let (step, exact) = (wire.in_doubt(), *exact);
        let made = part.map(|[feed_mm, rotate_deg]| Step { feed_mm, rotate_deg, ..stands });
        self.events.extend(done);
        self.events.extend(step.map(|step| Event::PartMade { step, made, exact }));
    }

    pub(super) fn in_units(&self, steps: [i32; 3]) -> Step {
        let [feed, rotate, bend] = steps.map(f64::from);
        Step {
            feed_mm: feed / self.settings.feed_steps_per_mm,
            rotate_deg: rotate / self.rotate_steps_per_deg(),
            bend_deg: bend * 360.0 / f64::from(self.settings.bend_steps_per_turn),
        }
    }

    /// Tells of an end that waited for where the axes stand.
    pub(super) fn tell_end(&mut self) {
        self.events.extend(self.ending.take().into_iter().flat_map(|ending| ending.events));
    }

    pub(super) fn in_doubt(&self) -> Option<u32> {
        self.wire.as_ref().and_then(Wire::in_doubt)
    }

    /// What was begun is over; the machine has to be homed.
    pub(super) fn give_up(&mut self) {
        (self.doing, self.homed, self.wire, self.token) = (Doing::Nothing, false, None, None);
    }

    pub(super) fn lose(&mut self, error: DriverError) {
        if self.doing == Doing::Over {
            return;
        }
        self.tell_end();
        self.give_up();
        self.doing = Doing::Over;
        // It makes on what it has, until it misses whoever has sent it.
        self.report(Event::Fault { error, in_doubt: None, disconnected: true });
    }

    /// The port is gone.
    pub fn unplugged(&mut self) {
        self.lose(fault::unplugged());
    }
}
