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
    status: ShownStatus,
}

/// What of the next question for the status and its answer is shown.
#[derive(Debug, Default, Clone, Copy, PartialEq, Eq)]
enum ShownStatus {
    #[default]
    Nothing,
    /// A person asked, and the question is not sent yet: an answer that arrives before it belongs to an earlier one.
    Question,
    Answer,
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
            let shown = self.status == ShownStatus::Answer;
            if tell(Direction::FromMachine, &line, Reply::Status as u8, shown, events) {
                self.status = ShownStatus::Nothing;
            }
        }
    }

    /// The next question for the status and its answer are a person's.
    pub const fn show_status(&mut self, shown: bool) {
        self.status = if shown { ShownStatus::Question } else { ShownStatus::Nothing };
    }

    /// What is sent: whole frames, and STOP between them.
    pub fn say(&mut self, bytes: &[u8], events: &mut VecDeque<Event>) {
        let frames: Vec<u8> = bytes.iter().copied().filter(|&byte| byte != STOP).collect();
        for line in frames.split(|&byte| byte == b'\n') {
            let shown = self.status == ShownStatus::Question;
            if tell(Direction::ToMachine, line, Command::Query as u8, shown, events) {
                self.status = ShownStatus::Answer;
            }
        }
        // Repeated until it is answered.
        if bytes.contains(&STOP) {
            events.push_back(Event::Console { direction: Direction::ToMachine, text: "STOP".to_owned() });
        }
    }
}

/// Whether the line is one of the status that is shown.
fn tell(direction: Direction, line: &[u8], status: u8, shown: bool, events: &mut VecDeque<Event>) -> bool {
    let line = line.trim_ascii();
    let payload = match line.iter().rposition(|&byte| byte == b'*') {
        Some(seal) if line.len() - seal == 5 => &line[..seal],
        _ => line,
    };
    let Some(&letter) = payload.first() else { return false };
    if letter != status || shown {
        events.push_back(Event::Console { direction, text: payload.escape_ascii().to_string() });
    }
    letter == status && shown
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

    /// The link asks for itself several times a second: the answer to such a question may arrive after a person has asked.
    #[test]
    fn an_answer_to_an_earlier_question_is_not_shown_before_the_question_of_a_person() {
        let (mut console, mut events) = (Console::default(), VecDeque::new());
        let (asks, answers) = (sealed("Q", 7), sealed("t0,0,0,0,0,3,3,0,0,1", 7));
        console.say(&asks, &mut events);
        console.show_status(true);
        for _ in 0..2 {
            console.hear(&answers, &mut events);
            console.say(&asks, &mut events);
        }
        let told: Vec<Direction> = told(events).into_iter().map(|(direction, _)| direction).collect();
        assert_eq!(told, [Direction::ToMachine, Direction::FromMachine]);
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
