//! What goes over the line, as text for a person.

use std::collections::VecDeque;

use wirebend_driver_api::{Direction, Event};

use crate::protocol::{Command, Reply, STOP};

/// Of a longer line the beginning is shown.
const MAX_LINE: usize = 128;

/// Both directions of a line. Questions for the status and their answers are left out: there are several a second, and what
/// they report is reported otherwise.
#[derive(Debug, Default)]
pub(super) struct Console {
    heard: Vec<u8>,
    /// A person has asked for the status: the question and the answer are shown once.
    shows_status: [bool; 2],
}

impl Console {
    /// What was heard, line by line: frames without their seal, and whatever else a board says.
    pub fn hear(&mut self, bytes: &[u8], events: &mut VecDeque<Event>) {
        for &byte in bytes {
            if byte != b'\n' {
                self.heard.push(byte);
                self.heard.truncate(MAX_LINE);
                continue;
            }
            let line = std::mem::take(&mut self.heard);
            let shown = &mut self.shows_status[1];
            tell(Direction::FromMachine, &line, Reply::Status as u8, shown, events);
        }
    }

    /// The next question for the status and its answer are a person's.
    pub const fn show_status(&mut self, shown: bool) {
        self.shows_status = [shown; 2];
    }

    /// What is sent: whole frames, and STOP between them.
    pub fn say(&mut self, bytes: &[u8], events: &mut VecDeque<Event>) {
        let frames: Vec<u8> = bytes.iter().copied().filter(|&byte| byte != STOP).collect();
        for line in frames.split(|&byte| byte == b'\n') {
            let shown = &mut self.shows_status[0];
            tell(Direction::ToMachine, line, Command::Query as u8, shown, events);
        }
        // Repeated until it is answered.
        if bytes.contains(&STOP) {
            events.push_back(Event::Console { direction: Direction::ToMachine, text: "STOP".to_owned() });
        }
    }
}

fn tell(direction: Direction, line: &[u8], left_out: u8, shown: &mut bool, events: &mut VecDeque<Event>) {
    let line = line.trim_ascii();
    let payload = match line.iter().rposition(|&byte| byte == b'*') {
        Some(seal) if line.len() - seal == 5 => &line[..seal],
        _ => line,
    };
    if payload.first().is_some_and(|&letter| letter != left_out || std::mem::take(shown)) {
        events.push_back(Event::Console { direction, text: payload.escape_ascii().to_string() });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::protocol::{NO_SESSION, sealed};

    fn told(events: VecDeque<Event>) -> Vec<(Direction, String)> {
        let told = events.into_iter().map(|event| match event {
            Event::Console { direction, text } => (direction, text),
            other => panic!("{other:?} is nothing that was said"),
        });
        told.collect()
    }

    #[test]
    fn a_line_is_told_without_its_seal_and_the_status_not_at_all() {
        let (mut console, mut events) = (Console::default(), VecDeque::new());
        let heard =
            [&sealed("a3,12", 7)[..], &sealed("t0,0,0,0,0,3,3,0,0,1", 7), b"Grbl 1.1h ['$' for help]\r\n"];
        // As a port gives it: in pieces.
        for piece in heard.concat().chunks(5) {
            console.hear(piece, &mut events);
        }
        let heard = told(std::mem::take(&mut events));
        assert_eq!(heard.len(), 2, "{heard:?}");
        assert_eq!(heard[0], (Direction::FromMachine, "a3,12".to_owned()));
        assert!(heard[1].1.starts_with("Grbl 1.1h"), "{heard:?}");

        let sent = [&sealed("S7", NO_SESSION)[..], &sealed("Q", 7), &[STOP], &sealed("M1,8,0,-3", 7)];
        Console::default().say(&sent.concat(), &mut events);
        let said: Vec<String> = told(events).into_iter().map(|(_, text)| text).collect();
        assert_eq!(said, ["S7", "M1,8,0,-3", "STOP"]);
    }

    /// A board that never ends its line takes no more memory for it.
    #[test]
    fn a_line_without_an_end_is_cut() {
        let (mut console, mut events) = (Console::default(), VecDeque::new());
        console.hear(&vec![b'x'; 100_000], &mut events);
        console.hear(b"\n", &mut events);
        assert_eq!(told(events)[0].1.len(), MAX_LINE);
    }
}
