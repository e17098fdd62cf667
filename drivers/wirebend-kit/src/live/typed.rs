//! Lines that a person types: requests of the protocol, which the driver frames, numbers and repeats as its own.

use wirebend_driver_api::{ConsoleLine, DriverError, Event};

use super::machine::{Activity, Machine, Typed};
use crate::link::Request;
use crate::protocol::SETTINGS;

/// No request of the protocol is so long.
const LONGEST: usize = 60;

/// What a line asks of the controller.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Asked {
    typed: Typed,
    requests: Vec<Request>,
}

impl Asked {
    /// `session`: the one that is open.
    fn of(line: &str, session: u16) -> Result<Self, DriverError> {
        let question = |requests| Ok(Self { typed: Typed::Question, requests });
        let stores = |request| Ok(Self { typed: Typed::Stores, requests: vec![request] });
        match line.to_ascii_lowercase().as_str() {
            "status" | "q" => return question(vec![Request::Status]),
            "version" | "s" => return question(vec![Request::Version(session)]),
            "speed" | "u" => return question(vec![Request::Speed(0)]),
            "settings" | "c" => return question(SETTINGS.iter().map(|one| Request::Read(one.id)).collect()),
            "l" => return stores(Request::LoadDefaults),
            "r" => return Ok(Self { typed: Typed::Releases, requests: vec![Request::Release] }),
            _ => {}
        }
        let (letter, rest) = line.split_at_checked(1).unwrap_or((line, ""));
        match letter {
            "C" | "c" => question(vec![Request::Read(number(rest, "C", "a setting, such as C4")?)]),
            "W" | "w" => {
                let wanted = "a setting and its value, such as W4,1500";
                let (id, value) = rest.split_once(',').ok_or_else(|| refused("W without a value", wanted))?;
                stores(Request::Write(number(id, "W", wanted)?, number(value, "W", wanted)?))
            }
            "M" | "Y" | "H" | "K" => Err(refused(
                "the program numbers the lines that move the machine",
                "use Home, move an axis by hand, or do a dry run",
            )),
            "P" | "G" | "U" | "Z" | "S" => {
                Err(refused("the program has to know of it", "use the button for it in its place"))
            }
            _ => Err(refused(
                "the protocol has no such request",
                "type status, version, settings, speed, C and a number, W and two, L, or R",
            )),
        }
    }
}

fn number<T: std::str::FromStr>(text: &str, letter: &str, wanted: &str) -> Result<T, DriverError> {
    let what = format!("'{text}' after {letter} is no number of the protocol");
    text.trim().parse().map_err(|_| refused(&what, &format!("type {wanted}")))
}

fn refused(why: &str, help: &str) -> DriverError {
    DriverError::new("console-line", format!("the line is not passed on: {why}"), help)
}

impl Machine {
    pub fn typed(&mut self, line: &ConsoleLine, may_change: bool) -> Result<(), DriverError> {
        self.require_rest("take a typed line")?;
        let asked = Asked::of(line.ascii(LONGEST)?, self.link.session().unwrap_or_default())?;
        if asked.typed != Typed::Question {
            if !may_change {
                return Err(DriverError::not_a_question(line.as_str()));
            }
            self.homed = false;
        }
        self.console.show_status(asked.requests.contains(&Request::Status));
        asked.requests.into_iter().for_each(|request| self.link.request(request));
        if asked.typed == Typed::Stores {
            self.unwritten.clear();
            self.read_settings();
        }
        self.activity = Activity::Typing(asked.typed);
        Ok(())
    }

    /// The line has its answer.
    pub(super) fn answered(&mut self, typed: Typed) {
        self.console.show_status(false);
        self.activity = Activity::Idle;
        if typed == Typed::Stores {
            self.report_stored();
        }
        self.report(Event::ConsoleDone { homed: self.homed, moved: typed == Typed::Releases });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn asked(line: &str) -> Result<(Typed, Vec<Request>), String> {
        Asked::of(line, 7).map(|asked| (asked.typed, asked.requests)).map_err(|error| error.message)
    }

    #[test]
    fn a_line_is_a_request_of_the_protocol() {
        for (line, typed, request) in [
            ("status", Typed::Question, Request::Status),
            ("Q", Typed::Question, Request::Status),
            ("Version", Typed::Question, Request::Version(7)),
            ("C4", Typed::Question, Request::Read(4)),
            ("c 4", Typed::Question, Request::Read(4)),
            ("W4,1500", Typed::Stores, Request::Write(4, 1500)),
            ("w18, -300", Typed::Stores, Request::Write(18, -300)),
            ("L", Typed::Stores, Request::LoadDefaults),
            ("R", Typed::Releases, Request::Release),
        ] {
            assert_eq!(asked(line), Ok((typed, vec![request])), "{line}");
        }
        assert_eq!(asked("settings").unwrap().1.len(), SETTINGS.len());
    }

    /// A line that moves has a number that only the link gives, and a session opened anew would forget the wire.
    #[test]
    fn what_the_program_does_itself_is_not_passed_on() {
        for line in [
            "M1,100,0,0",
            "H1",
            "K1,1",
            "Y1,0,0,0",
            "P",
            "G",
            "U50",
            "Z0",
            "S9",
            "X",
            "W4",
            "W4,x",
            "C999",
            "Cx",
        ] {
            let said = asked(line).expect_err(line);
            assert!(said.starts_with("the line is not passed on"), "{line}: {said}");
        }
    }
}
