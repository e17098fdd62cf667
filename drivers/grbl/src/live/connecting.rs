//! From an open port to a machine whose version, settings and state are known.

use std::time::Duration;

use wirebend_driver_api::{DoneBy, DriverError, Event, HeadBy, ReferenceBy};

use super::phase::{Attempt, Greeting, Phase, Reading};
use super::protocol::Protocol;
use super::status::State;
use crate::limits;
use crate::settings::Homing;

/// Opening the port resets most boards; their loader takes up to two seconds.
const NUDGE_AFTER: Duration = Duration::from_millis(2500);
/// A controller that is awake has answered by then.
const RESET_AFTER: Duration = Duration::from_millis(3500);
const GIVE_UP_AFTER: Duration = Duration::from_secs(6);
/// All settings are about 600 bytes: a twentieth of a second.
const ANSWER_WITHIN: Duration = Duration::from_secs(2);
const RESET: u8 = 0x18;

/// What a greeting says of what can be expected.
#[derive(Debug, PartialEq, Eq)]
enum Version {
    Stock,
    Old,
    Other,
}

/// `Grbl 1.1h` or, of `$I`, `1.1h.20190825`.
fn version(text: &str) -> Version {
    let (words, named) = text.strip_prefix("Grbl ").map_or((text, false), |rest| (rest, true));
    let number = words.trim_start_matches('v');
    let mut parts = number.splitn(2, '.');
    let major: Option<u32> = parts.next().and_then(|part| part.parse().ok());
    let minor = parts.next().and_then(|part| part.chars().next()).and_then(|c| c.to_digit(10));
    match (major, minor) {
        (Some(0), _) | (Some(1), Some(0)) => Version::Old,
        // More than a number is another program that calls itself by the same name.
        (Some(1), Some(1)) if !named || !number.contains(' ') => Version::Stock,
        _ => Version::Other,
    }
}

impl Protocol {
    pub(super) fn greeting_late(&mut self) {
        let Phase::Greeting(greeting) = &mut self.phase else { return };
        let waited = self.now.saturating_sub(greeting.since);
        if waited >= GIVE_UP_AFTER {
            self.close(DriverError::new(
                "no-greeting",
                "the machine has not answered as grbl does",
                "see that it is the right port, that the machine has power, and that 'baud' is right (115200 \
                 for grbl); another firmware needs another driver",
            ));
        } else if waited >= RESET_AFTER && greeting.attempt < Attempt::Reset {
            greeting.attempt = Attempt::Reset;
            self.send_realtime(RESET);
        } else if waited >= NUDGE_AFTER && greeting.attempt < Attempt::EmptyLine {
            greeting.attempt = Attempt::EmptyLine;
            self.send_raw(b"\n?");
        }
    }

    /// A sign of a running controller: the answer to an empty line, or a status report.
    pub(super) fn found(&mut self) {
        let Phase::Greeting(greeting) = &mut self.phase else { return };
        match self.machine.state {
            Some(State::Idle | State::Alarm) if greeting.line_answered => {
                let stop = greeting.stop;
                self.read(stop);
            }
            // It moves, holds or sleeps on behalf of an earlier program.
            Some(state)
                if !matches!(state, State::Idle | State::Alarm) && greeting.attempt < Attempt::Reset =>
            {
                greeting.attempt = Attempt::Reset;
                self.send_realtime(RESET);
            }
            _ => {}
        }
    }

    /// A greeting while the machine is not known yet; a board that starts twice greets twice.
    pub(super) fn greeted_first(&mut self, name: &str) {
        let stop = match &self.phase {
            Phase::Greeting(greeting) => greeting.stop,
            Phase::Reading(reading) => reading.parts().1,
            _ => false,
        };
        let found = version(name);
        self.machine.greeting = Some(name.to_owned());
        match found {
            Version::Old => return self.close(old(name)),
            Version::Other if matches!(self.phase, Phase::Greeting(_)) => {
                self.event(Event::Warning(other(name)));
            }
            _ => {}
        }
        self.read(stop);
    }

    fn read(&mut self, stop: bool) {
        self.phase = Phase::Reading(Reading::Build { since: self.now, stop });
        self.stream.clear();
        self.stream.take(["$I".to_owned()]);
    }

    /// The answer to a question is complete.
    pub(super) fn read_on(&mut self) {
        let Phase::Reading(reading) = self.phase else { return };
        let (since, (_, stop)) = (self.now, reading.parts());
        self.phase = Phase::Reading(match reading {
            Reading::Build { .. } => {
                self.stream.take(["$$".to_owned()]);
                Reading::Settings { since, stop }
            }
            Reading::Settings { .. } | Reading::State { .. } => {
                self.poller.restart();
                Reading::State { since, stop }
            }
        });
    }

    pub(super) fn reading_late(&mut self) {
        let Phase::Reading(reading) = self.phase else { return };
        if self.now.saturating_sub(reading.parts().0) >= ANSWER_WITHIN {
            let question = match reading {
                Reading::Build { .. } => "$I",
                Reading::Settings { .. } => "$$",
                Reading::State { .. } => "?",
            };
            self.close(DriverError::new(
                "no-answer",
                format!("the machine greets and does not answer '{question}'"),
                "press its reset button and connect again",
            ));
        }
    }

    /// A question was refused. Without its build the machine is known well enough, not without its settings.
    pub(super) fn question_refused(&mut self, error: DriverError) {
        match self.phase {
            Phase::Reading(Reading::Build { .. }) => self.read_on(),
            _ => self.close(error),
        }
    }

    /// The machine is known.
    pub(super) fn connected(&mut self) {
        let Phase::Reading(reading) = self.phase else { return };
        if self.machine.greeting.is_none() {
            let build = self.machine.build.clone().unwrap_or_default();
            match version(&build) {
                Version::Stock => {}
                Version::Old => return self.close(old(&build)),
                Version::Other => self.event(Event::Warning(other(&build))),
            }
        }
        self.phase = Phase::Ready;
        let settings = self.machine.differences(&self.settings);
        // A board that lost power counts from where it is, and an alarm may have been cleared by hand: only homing in this
        // connection counts.
        self.machine.homed = false;
        self.event(Event::Connected {
            identity: self.machine.identity(),
            settings,
            homed: false,
            resume: None,
            reference: match self.settings.homing {
                Homing::Switches => ReferenceBy::Machine,
                Homing::None => ReferenceBy::Person,
            },
            done_by: DoneBy::Machine,
            head: HeadBy::Reference,
            limits: limits::of_board(&self.settings, |key| self.machine.setting(key)),
        });
        if reading.parts().1 {
            self.event(Event::Stopped { homed: false });
        }
    }

    /// A stop before the machine is known.
    pub(super) fn stop_first(&mut self) {
        self.stream.clear();
        self.discard_output();
        self.send_realtime(RESET);
        let greeting = Greeting { attempt: Attempt::Reset, stop: true, ..Greeting::at(self.now) };
        self.phase = Phase::Greeting(greeting);
    }
}

fn old(name: &str) -> DriverError {
    DriverError::new(
        "old-version",
        format!("the machine runs '{name}'; this driver speaks grbl 1.1"),
        "put grbl 1.1 on the board; before it there were no jogging and no error numbers",
    )
}

fn other(name: &str) -> DriverError {
    DriverError::new(
        "other-firmware",
        format!("the machine says '{name}', which is not grbl 1.1 itself"),
        "bend a short wire first and watch it: this driver was written for grbl 1.1",
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn versions_are_told_apart() {
        for stock in ["Grbl 1.1h", "Grbl 1.1f", "1.1h.20190825", "v1.1d.20161014:Bender"] {
            assert_eq!(version(stock), Version::Stock, "{stock}");
        }
        for old in ["Grbl 0.9j", "Grbl 0.8c", "Grbl 1.0c"] {
            assert_eq!(version(old), Version::Old, "{old}");
        }
        for other in
            ["GrblHAL 1.1f", "Grbl 3.7 [FluidNC v3.7.8 (wifi) '$' for help]", "Grbl 1.1 [ESP32]", "Grbl", ""]
        {
            assert_eq!(version(other), Version::Other, "{other}");
        }
    }
}
