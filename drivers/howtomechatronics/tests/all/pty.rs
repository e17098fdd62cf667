//! The driver on a real serial port, with another machine at the other end, or none.

#![cfg(unix)]

use std::io::{Read, Write};
use std::time::{Duration, Instant};

use serde_json::json;
use serialport::{SerialPort, TTYPort};
use wirebend_driver_api::{Batch, Event, MachineDriver, MachineSession, NumberedStep, Run, Step};
use wirebend_driver_howtomechatronics::HowToMechatronics;

const DEADLINE: Duration = Duration::from_secs(30);

/// A board: what it says when it is switched on, and to the first line.
struct Board {
    session: Box<dyn MachineSession>,
    machine: TTYPort,
    _cable: TTYPort,
    answer: &'static str,
    received: Vec<u8>,
}

impl Board {
    fn new(greeting: &str, answer: &'static str) -> Self {
        let (mut machine, cable) = TTYPort::pair().expect("a pair of terminals");
        machine.set_timeout(Duration::from_millis(1)).expect("a timeout");
        // Waits are as short as can be.
        let settings = json!({"boot_s": 0.3, "command_s": 0.1, "bend_extra_s": 0, "margin_percent": 0,
            "feed_rate_mm_per_s": 1000, "bend_rate_deg_per_s": 1000, "bend_return_rate_deg_per_s": 1000});
        let driver = HowToMechatronics::open(serde_json::from_value(settings).unwrap()).unwrap();
        let session = driver.connect(&cable.name().expect("its name"), None).unwrap();
        machine.write_all(greeting.as_bytes()).unwrap();
        Self { session, machine, _cable: cable, answer, received: Vec::new() }
    }

    /// Events until one of the wanted kind.
    fn until(&mut self, wanted: impl Fn(&Event) -> bool) -> Vec<Event> {
        let (begun, mut events) = (Instant::now(), Vec::new());
        while begun.elapsed() < DEADLINE {
            let mut bytes = [0; 64];
            let count = self.machine.read(&mut bytes).unwrap_or_default();
            if count > 0 && self.received.is_empty() {
                self.machine.write_all(self.answer.as_bytes()).unwrap();
            }
            self.received.extend_from_slice(&bytes[..count]);
            while let Some(event) = self.session.poll().unwrap() {
                let over = wanted(&event);
                events.push(event);
                if over {
                    return events;
                }
            }
        }
        panic!("it did not come: {events:?}");
    }

    fn makes(&mut self) -> Vec<Event> {
        let run = Run { job_hash: "0".repeat(64), name: "sample".to_owned(), steps: 2, ..Run::default() };
        self.session.arm(&run).unwrap();
        let step = |n| NumberedStep {
            n,
            step: Step { feed_mm: 30.0, rotate_deg: 0.0, bend_deg: 45.0, approach_deg: None },
        };
        self.session.send(&Batch { steps: vec![step(1), step(2)], last: true }).unwrap();
        self.until(|event| matches!(event, Event::Finished | Event::Fault { .. }))
    }
}

fn warned(events: &[Event], code: &str) -> bool {
    events.iter().any(|event| matches!(event, Event::Warning(error) if error.code == code))
}

fn is_connected(event: &Event) -> bool {
    matches!(event, Event::Connected { .. })
}

fn is_homed_by_hand(event: &Event) -> bool {
    matches!(event, Event::Warning(error) if error.code == "homed-by-hand")
}

#[test]
fn a_board_that_greets_as_another_is_not_connected() {
    for greeting in ["\r\nGrbl 1.1h ['$' for help]\r\n", "\no0,0,0,1,100,1,1*51A7\n"] {
        let mut board = Board::new(greeting, "");
        let events = board.until(|event| matches!(event, Event::Fault { .. }));
        let Some(Event::Fault { error, .. }) = events.last() else { panic!("{events:?}") };
        assert_eq!(error.code, "other-machine", "{greeting}");
        assert!(!events.iter().any(is_connected), "{events:?}");
    }
}

/// Such a job ended as done, all steps.
#[test]
fn a_board_that_answers_otherwise_ends_the_wire() {
    for (answer, code) in [
        ("error:1\r\n", "other-machine"),
        ("\ne2,1,109*0FF3\n", "other-machine"),
        ("what is manual?\r\n", "not-understood"),
    ] {
        let mut board = Board::new("", answer);
        board.until(is_homed_by_hand);
        let events = board.makes();
        let Some(Event::Fault { error, in_doubt: None, .. }) = events.last() else { panic!("{events:?}") };
        assert_eq!(error.code, code);
        assert!(error.message.contains(answer.trim()), "{error}");
        assert!(!events.iter().any(|event| matches!(event, Event::Done { .. })), "{events:?}");
        assert_eq!(board.received, b"manual\n", "nothing more is sent");
    }
}

/// Nothing distinguishes a silent board from a machine that bends the wire: a person is warned before.
#[test]
fn a_person_is_told_that_nothing_is_acknowledged() {
    let mut board = Board::new("", "");
    let events = board.until(is_homed_by_hand);
    assert!(warned(&events, "no-acknowledgement"), "{events:?}");
    assert!(matches!(board.makes().last(), Some(Event::Finished)));
    assert!(HowToMechatronics::describe().description.contains("acknowledges nothing"));
}
