//! A wire while it is bent: the next lines, and what the status reports say of those that were sent.

use wirebend_driver_api::{DriverError, Event, PausedBy, Step};

use super::interrupted::{InterruptedStep, StoppedBy};
use super::phase::Phase;
use super::protocol::Protocol;
use super::status::State;
use super::stream::dwell_of;
use super::wire_run::{Hold, Stage};

/// How long a machine may stand idle with a line that it has not answered, besides what a dwell takes.
const ANSWER_WITHIN_S: u64 = 10;

impl Protocol {
    /// Sends the next part of the wire, if it is time for one.
    pub(super) fn send_next(&mut self) {
        let Phase::Running(run) = &mut self.phase else { return };
        if let Some(lines) = run.next_lines() {
            self.stream.take(lines);
            self.poller.outdated();
            self.feed();
        }
    }

    /// A status report during a wire. `rests`: every line was answered before the report was requested, and the machine is
    /// idle, so everything sent is done.
    pub(super) fn wire_reported(&mut self, state: State, before: Option<State>, rests: bool) {
        if matches!(state, State::Door { .. }) && !matches!(before, Some(State::Door { .. })) {
            self.event(Event::Warning(DriverError::new(
                "door",
                "the safety door is open; the machine holds and its pin output is off",
                "close the door, see whether the pin is where it was, then resume",
            )));
        }
        self.follow_hold(state);
        let Phase::Running(run) = &mut self.phase else { return };
        if run.hold != Hold::No {
            return;
        }
        if !rests {
            return self.watch_answer(state);
        }
        match run.stage {
            Stage::Start => {
                run.began = self.machine.reported(&self.settings);
                run.began_at = self.machine.position(&self.settings);
                run.stage = Stage::Between;
            }
            Stage::Turn | Stage::Step(_) => {
                if let Err(error) = run.arrived(&self.machine, &self.settings) {
                    // A report may have been damaged itself: wait for the next one.
                    if std::mem::replace(&mut run.displaced, true) {
                        self.fail(error);
                    }
                    return;
                }
                run.displaced = false;
                if run.rest.is_empty() {
                    let made = std::mem::replace(&mut run.stage, Stage::Between);
                    if let Stage::Step(n) = made {
                        self.event(Event::Done { n });
                    }
                }
            }
            Stage::End => {
                self.phase = Phase::Ready;
                self.restore_full_speed();
                return self.event(Event::Finished);
            }
            Stage::Armed | Stage::Between => {}
        }
        if let Phase::Running(run) = &mut self.phase {
            run.busy = false;
        }
        self.send_next();
    }

    /// The machine holds and resumes on request of the program, of a button on it, or of its door.
    fn follow_hold(&mut self, state: State) {
        let Phase::Running(run) = &mut self.phase else { return };
        match (state, run.hold) {
            (State::Hold { at_rest: true } | State::Door { at_rest: true }, Hold::No | Hold::Asked) => {
                let asked = run.hold == Hold::Asked;
                run.hold = Hold::Held;
                self.event(Event::Paused { by: if asked { PausedBy::Program } else { PausedBy::Machine } });
            }
            (State::Idle | State::Run, Hold::Held | Hold::Resuming) => {
                run.hold = Hold::No;
                // What is under way was asked while it held.
                self.poller.outdated();
                self.event(Event::Resumed);
            }
            _ => {}
        }
    }

    /// An answer that was lost would never come. Where nothing moves, no answer takes long.
    pub(super) fn watch_answer(&mut self, state: State) {
        let Some((line, since)) = self.stream.awaited() else { return };
        let patience = std::time::Duration::from_secs(ANSWER_WITHIN_S) + dwell_of(line);
        let stands = matches!(state, State::Idle | State::Alarm | State::Check | State::Sleep);
        if stands && self.now.saturating_sub(since) > patience {
            let what = format!("the machine stands and has not answered the line '{line}'");
            let help = "an answer was lost: see whether the USB cable is sound and away from motor cables";
            self.fail(DriverError::new("unanswered", what, help));
        }
    }

    /// The wire ends now, in the middle of a step.
    pub(super) fn interrupt(&mut self, by: StoppedBy) {
        if let Phase::Running(run) = &self.phase {
            self.interrupted = InterruptedStep::of(run, &self.settings, by);
        }
    }

    /// At rest: reports how much of the interrupted step is done.
    pub(super) fn report_interrupted(&mut self) {
        let Some(InterruptedStep { step, from, whole, tolerance, exact }) = self.interrupted.take() else {
            return;
        };
        let now = self.machine.position(&self.settings);
        // Motors move in whole steps: within the tolerance the step is complete.
        let made = |axis: usize, made: f64| {
            if (made - whole[axis]).abs() <= tolerance[axis] { whole[axis] } else { made }
        };
        let made = from.zip(now).map(|(from, now)| Step {
            feed_mm: made(0, now.feed_mm - from.feed_mm),
            rotate_deg: made(1, now.rotate_deg - from.rotate_deg),
            bend_deg: now.bend_deg - from.bend_deg,
            approach_deg: None,
        });
        self.event(Event::PartMade { step, made, exact });
    }
}
