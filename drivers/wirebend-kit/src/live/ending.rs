//! Stops, alarms and lost connections, and how much of the interrupted step is done.

use std::time::Duration;

use wirebend_driver_api::{DriverError, Event, Step};

use super::fault;
use super::machine::{Activity, Ending, Halt, Homing, Machine, session_id};
use super::wire_progress::WireProgress;
use crate::protocol::{Alarm, Status};

/// How long to wait for the position of the axes: an answer takes 20 ms on a good line, longer on a busy computer. Without it a
/// person has to measure.
const STANDS_WITHIN: Duration = Duration::from_millis(1500);

impl Machine {
    pub(super) fn alarmed(&mut self, alarm: Alarm, now: Duration) {
        if matches!(alarm, Alarm::HostLost | Alarm::HoldInput) {
            return; // the status reports the hold
        }
        match self.activity {
            // Unless a person has stopped it meanwhile: both may have this one answer.
            Activity::Homing(Homing::Stopping) if self.halt != Halt::Requested => {
                self.renew(session_id(self.link.session()), now);
                self.activity = Activity::Homing(Homing::Opening);
                return;
            }
            // From before it accepted the homing line, which clears the alarm.
            Activity::Homing(
                Homing::Opening | Homing::SettingHead | Homing::Searching { accepted: false, .. },
            ) if self.halt != Halt::Requested => {
                return;
            }
            Activity::Connecting | Activity::Closed => return,
            _ => {}
        }
        let asked = self.halt == Halt::Requested;
        if std::mem::replace(&mut self.halt, Halt::Reported(alarm)) == Halt::Reported(alarm) {
            return;
        }
        if let (Alarm::Stop, Some(ending)) = (alarm, &mut self.ending) {
            // What ended first is not reported yet, and this stop has cancelled the query for the position.
            if !ending.events.iter().any(|event| matches!(event, Event::Stopped { .. })) {
                ending.events.push(Event::Stopped { homed: false });
            }
            self.link.query();
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
        // After a limit switch or a power cut the axes may not be where the controller counts.
        let counted = alarm == Alarm::Stop;
        self.ending = Some(Ending { events, wire, exact, counted, until: now + STANDS_WITHIN });
    }

    /// The interrupted step, and how much of it is done.
    pub(super) fn report_part(&mut self, status: Status) {
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
            approach_deg: None,
        }
    }

    /// Reports an end that waited for the position of the axes.
    pub(super) fn report_ending(&mut self) {
        self.events.extend(self.ending.take().into_iter().flat_map(|ending| ending.events));
    }

    pub(super) fn in_doubt(&self) -> Option<u32> {
        self.wire.as_ref().and_then(WireProgress::in_doubt)
    }

    /// Drops the wire; the machine has to be homed.
    pub(super) fn give_up(&mut self) {
        (self.activity, self.homed, self.wire, self.token) = (Activity::Idle, false, None, None);
    }

    pub(super) fn lose(&mut self, error: DriverError) {
        if self.activity == Activity::Closed {
            return;
        }
        self.report_ending();
        self.give_up();
        self.activity = Activity::Closed;
        // It still runs its lines until it notices that the host is gone.
        self.report(Event::Fault { error, in_doubt: None, disconnected: true });
    }

    /// The port is gone.
    pub fn unplugged(&mut self) {
        self.lose(fault::unplugged());
    }
}
