//! Lines that a person types: which are passed on, and when their answer is complete.

use std::time::Duration;

use wirebend_driver_api::{ConsoleLine, Direction, DriverError, Event, PausedBy};

use super::calls::not_idle;
use super::phase::{Phase, Typed};
use super::protocol::Protocol;
use super::status::State;
use crate::codes;
use crate::limits;

/// `LINE_BUFFER_SIZE` of grbl's `protocol.h`, without the end of the line.
const LONGEST: usize = 79;
/// What can be asked without a change of anything (`system_execute_line` in `system.c`).
const QUESTIONS: [&str; 6] = ["$", "$$", "$#", "$G", "$I", "$N"];

/// What a line does to the machine.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// `?`, which is no line: it is answered at once by a report.
    Status,
    Question,
    /// It changes something, and may move the axes.
    Command {
        moves: bool,
    },
}

impl Kind {
    fn of(line: &str) -> Result<Self, DriverError> {
        if line == "?" {
            return Ok(Self::Status);
        }
        if let Some(byte) = line.chars().find(|one| matches!(one, '?' | '!' | '~')) {
            let what = format!("'{byte}' is a real-time command of grbl, which takes it out of any line");
            return Err(refused(
                &what,
                "ask for the state with ? alone; use Pause, Resume and STOP for the others",
            ));
        }
        let code = as_taken(line);
        if code.is_empty() || QUESTIONS.contains(&code.as_str()) {
            return Ok(Self::Question);
        }
        let Some(system) = code.strip_prefix('$') else {
            return if pauses(&code) {
                Err(refused("M0 holds the machine until a cycle start", "leave it out"))
            } else {
                Ok(Self::Command { moves: true })
            };
        };
        match system.as_bytes() {
            [b'H', ..] => Err(refused("the program has to know of homing", "use Home")),
            [b'J', ..] => Err(refused("the program has to know of jogs", "move the axis by hand instead")),
            [b'C', ..] => {
                Err(refused("in check mode nothing moves, whatever is sent", "do a dry run instead"))
            }
            [b'S', b'L', b'P', ..] => Err(refused(
                "a machine that sleeps answers nothing before its reset",
                "cut its power instead",
            )),
            [b'R', b'S', b'T', ..] => Err(refused(
                "$RST resets the controller",
                "set each setting, or disconnect and use another program",
            )),
            [b'N', ..] => Err(refused(
                "a startup line would run unseen at every reset",
                "use 'start_block' of the profile",
            )),
            [b'X'] | [b'I', b'=', ..] | [b'0'..=b'9', ..] => Ok(Self::Command { moves: false }),
            // Such as `$SD/Run=` of other firmware, which begins a job of its own.
            _ => Err(refused(
                "grbl 1.1 has no such command, and the driver would not know what it has begun",
                "disconnect, and send it with another program",
            )),
        }
    }
}

fn refused(why: &str, help: &str) -> DriverError {
    DriverError::new("console-line", format!("the line is not passed on: {why}"), help)
}

/// A line as grbl takes it: without blanks, comments and `/`, in capitals (`protocol_main_loop` in `protocol.c`).
fn as_taken(line: &str) -> String {
    let mut comment = false;
    let mut taken = String::new();
    for one in line.chars() {
        match one {
            ';' if !comment => break,
            '(' => comment = true,
            ')' => comment = false,
            _ if comment || one == ' ' || one == '/' => {}
            _ => taken.push(one.to_ascii_uppercase()),
        }
    }
    taken
}

/// Whether a line of G-code has the word M0, however its number is written.
fn pauses(code: &str) -> bool {
    code.match_indices('M').any(|(at, _)| {
        let rest = &code[at + 1..];
        let end = rest.find(|one: char| !matches!(one, '0'..='9' | '.' | '-' | '+')).unwrap_or(rest.len());
        rest[..end].parse::<f64>().is_ok_and(|number| number.abs() < 0.5)
    })
}

impl Protocol {
    pub fn console(
        &mut self,
        line: &ConsoleLine,
        may_change: bool,
        now: Duration,
    ) -> Result<(), DriverError> {
        self.now = now;
        let text = line.ascii(LONGEST)?.to_owned();
        let kind = Kind::of(&text)?;
        self.ready()?;
        self.interrupted = None;
        match kind {
            Kind::Status => {
                self.phase = Phase::Console(Typed::Report);
                self.show(Direction::ToMachine, &text);
                // The next report answers it, also one that was asked for already.
                self.poller.restart();
            }
            Kind::Question => {
                self.phase = Phase::Console(Typed::Answer);
                self.stream.take([text]);
            }
            Kind::Command { .. } if !may_change => return Err(DriverError::not_a_question(line.as_str())),
            Kind::Command { moves } => {
                self.machine.homed = false;
                self.phase = Phase::Console(Typed::Rest { moves, held: false });
                self.stream.take([text]);
            }
        }
        self.feed();
        Ok(())
    }

    /// A line was answered.
    pub(super) fn console_answered(&mut self) {
        match self.phase {
            Phase::Console(Typed::Answer) => self.console_done(false),
            Phase::Console(Typed::Settings { moves }) => {
                self.event(Event::SettingsWritten {
                    settings: self.machine.differences(&self.settings),
                    limits: limits::of_board(&self.settings, |key| self.machine.setting(key)),
                });
                self.console_done(moves);
            }
            _ => {}
        }
    }

    /// A line was refused: that is its answer, with what it means.
    pub(super) fn console_refused(&mut self, code: u32, line: &str) {
        let (meaning, help) = codes::error(code);
        let what = format!("the machine does not take '{line}': {meaning}");
        self.event(Event::Warning(DriverError::new(&format!("grbl-error-{code}"), what, help)));
        self.console_answered();
    }

    /// A report while a line is awaited. `rests`: every line was answered before it was asked for.
    pub(super) fn console_reported(&mut self, typed: Typed, state: State, answered: bool) {
        match typed {
            Typed::Report => self.console_done(false),
            Typed::Answer | Typed::Settings { .. } => self.watch_answer(state),
            // Settings are not told while something moves (error 8).
            Typed::Rest { moves, .. } if answered && matches!(state, State::Idle | State::Alarm) => {
                self.phase = Phase::Console(Typed::Settings { moves });
                self.stream.take(["$$".to_owned()]);
                self.feed();
            }
            // Nothing that is sent moves it then, and only a reset leads out of it.
            Typed::Rest { .. } if answered && matches!(state, State::Check | State::Sleep) => {
                self.fail(not_idle(Some(state)));
            }
            Typed::Rest { moves, held } => {
                let holds = matches!(state, State::Hold { at_rest: true } | State::Door { at_rest: true });
                if holds && !held {
                    self.phase = Phase::Console(Typed::Rest { moves, held: true });
                    self.event(Event::Paused { by: PausedBy::Machine });
                }
                self.watch_answer(state);
            }
        }
    }

    fn console_done(&mut self, moved: bool) {
        self.phase = Phase::Ready;
        self.event(Event::ConsoleDone { homed: self.machine.homed, moved });
    }

    /// The answer to what a person has asked is shown, whatever it says.
    pub(super) fn shows_report(&mut self, text: &str) {
        if matches!(self.phase, Phase::Console(Typed::Report)) {
            self.event(Event::Console { direction: Direction::FromMachine, text: text.to_owned() });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_grbl_takes_decides_what_a_line_is() {
        let changes = |moves| Kind::Command { moves };
        for (line, kind) in [
            ("?", Kind::Status),
            ("$$", Kind::Question),
            (" $ # ", Kind::Question),
            ("$i", Kind::Question),
            ("(nothing)", Kind::Question),
            ("$100=250", changes(false)),
            ("$x", changes(false)),
            ("$I=my bender", changes(false)),
            ("G1 X10 F100", changes(true)),
            ("M30", changes(true)),
            ("G4 P1 (M0)", changes(true)),
        ] {
            assert_eq!(Kind::of(line), Ok(kind), "{line}");
        }
    }

    /// Each of them would leave the machine where the driver does not follow it.
    #[test]
    fn what_the_driver_would_not_follow_is_not_passed_on() {
        for line in [
            "!",
            "~",
            "G1 X1 ! F9",
            "??",
            "(?)",
            "$H",
            "$ h",
            "$(x)H",
            "$/H",
            "$C",
            "$SLP",
            "$RST=*",
            "$SD/Run=a.nc",
            "$settings/list",
            "$N0=G91",
            "$J=G91 X1 F9",
            "M0",
            "m 00",
            "G1 X1 M0.0",
            "M0(x)",
        ] {
            let error = Kind::of(line).expect_err(line);
            assert_eq!(error.code, "console-line", "{line}");
            assert!(!error.help.is_empty(), "{line}");
        }
    }
}
