//! Every digit of every motion line as another one: grbl has no checksum, and answers `ok` to what still makes sense. The
//! protocol talks to the model of the controller without a cable and a clock.

use std::cell::RefCell;
use std::collections::{BTreeSet, VecDeque};
use std::io::{self, Read, Write};
use std::rc::Rc;
use std::sync::Arc;
use std::time::Duration;

use serde_json::{Value, json};
use wirebend_driver_api::conformance::sample_job;
use wirebend_driver_api::{Batch, Event, MachineDriver, NumberedStep, Run, Step};

use super::protocol::Protocol;
use crate::Grbl;
use model::{Build, Change, Controller, Record};

#[path = "../../tests/all/pty/model/mod.rs"]
#[allow(dead_code, unreachable_pub)] // tests over a cable use the rest
mod model;

/// A step of the model, and a last digit of its reports: what is nearer cannot be distinguished from what was meant.
const TELLABLE: f64 = 1.0 / model::STEPS_PER_UNIT + 0.001;
/// Half a step: what is nearer to that than this may be rounded either way.
const ROUNDED: f64 = 0.5 / model::STEPS_PER_UNIT;
/// No wire here takes so long.
const MAX_MS: u64 = 60_000;

/// Of whole steps of the model.
const BEND_DEG: f64 = 92.35;
const WIRE: [Step; 2] = [
    Step { feed_mm: 20.5, rotate_deg: -30.0, bend_deg: BEND_DEG, approach_deg: None },
    Step { feed_mm: 10.0, rotate_deg: 0.0, bend_deg: 0.0, approach_deg: None },
];

/// What is on its way to the controller and from it.
#[derive(Default)]
struct Line {
    to: VecDeque<u8>,
    from: Vec<u8>,
}

struct End(Rc<RefCell<Line>>);

impl Read for End {
    fn read(&mut self, bytes: &mut [u8]) -> io::Result<usize> {
        self.0.borrow_mut().to.read(bytes)
    }
}

impl Write for End {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.borrow_mut().from.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// What is reported of the wire until it is over, and what the machine has bent, with one byte changed.
fn made(settings: &Value, change: Option<Change>) -> (Vec<Event>, Record) {
    let line = Rc::new(RefCell::new(Line::default()));
    let build = Build { steps_a_turn: 400, change, ..Build::default() };
    let mut controller = Controller::new(End(Rc::clone(&line)), build, Arc::default());
    let mut protocol = Protocol::new(Rc::new(serde_json::from_value(settings.clone()).unwrap()));
    let mut told = Vec::new();
    controller.begin();
    for ms in 0..MAX_MS {
        let now = Duration::from_millis(ms);
        controller.turn();
        let bytes = std::mem::take(&mut line.borrow_mut().from);
        protocol.receive(&bytes, now);
        protocol.tick(now);
        while let Some(event) = protocol.next_event() {
            match event {
                Event::Connected { .. } => protocol.home(now).unwrap(),
                Event::Homed => {
                    let run = Run { job_hash: "5a".into(), name: "x".into(), steps: 2, ..Run::default() };
                    protocol.arm(&run, now).unwrap();
                    let steps = (1..).zip(WIRE).map(|(n, step)| NumberedStep { n, step }).collect();
                    protocol.send(&Batch { steps, last: true }, now).unwrap();
                }
                Event::Console { .. } | Event::Position(_) => {}
                event => told.push(event),
            }
        }
        line.borrow_mut().to.extend(protocol.take_output());
        if matches!(told.last(), Some(Event::Finished | Event::Fault { .. })) {
            return (told, controller.record);
        }
    }
    panic!("nothing comes of it: {told:?}");
}

/// The motion lines of a file of the same wire, which are those that are sent.
fn motion_lines(settings: &Value) -> BTreeSet<String> {
    let mut job = sample_job();
    job.wires[0].machine = Some(WIRE.to_vec());
    let driver = Grbl::open(serde_json::from_value(settings.clone()).unwrap()).unwrap();
    let text = driver.encode("gcode", &job).unwrap().files[0].text.clone();
    text.lines().filter(|line| line.starts_with("G1 ")).map(str::to_owned).collect()
}

/// How far the value of the axis is changed; nothing where another word is.
fn displacement(change: &Change) -> Option<f64> {
    let begin = change.line.find(['X', 'Y', 'Z'])? + 1;
    let end = begin + change.line[begin..].find(' ')?;
    if !(begin..end).contains(&change.at) {
        return None;
    }
    let mut bytes = change.line.clone().into_bytes();
    bytes[change.at] = change.to;
    let changed = String::from_utf8(bytes).unwrap();
    let value = |line: &str| line[begin..end].parse::<f64>().unwrap();
    Some((value(&changed) - value(&change.line)).abs())
}

/// No wire that differs from its program is reported as finished, and none is given up for a difference that cannot be seen.
fn wrong(settings: &Value, change: &Change) -> Option<String> {
    let (events, record) = made(settings, Some(change.clone()));
    let finished = events.last() == Some(&Event::Finished);
    let found = match events.last() {
        Some(Event::Fault { error, in_doubt: Some(n), .. }) => {
            let told = error.code == "displaced" || error.code.starts_with("grbl-error");
            told && !events.contains(&Event::Done { n: *n })
        }
        _ => false,
    };
    let right = match displacement(change) {
        Some(by) if by > TELLABLE + ROUNDED => found,
        Some(by) if by < TELLABLE - ROUNDED => finished,
        Some(_) => found || finished,
        // Another rate, or another word for the same motion.
        None => found || (finished && (record.bends[0][2] - BEND_DEG).abs() < TELLABLE),
    };
    (!right).then(|| format!("{change:?}: {events:?}, {record:?}"))
}

fn every_changed_digit_is_found(settings: &Value) {
    let (events, record) = made(settings, None);
    assert_eq!(events, [Event::Done { n: 1 }, Event::Done { n: 2 }, Event::Finished]);
    assert_eq!(record.bends, [[20.5, -30.0, BEND_DEG]]);
    let (mut tried, mut wrongs) = (0, Vec::new());
    for line in motion_lines(settings) {
        for (at, byte) in line.bytes().enumerate().filter(|(_, byte)| byte.is_ascii_digit()) {
            for to in (b'0'..=b'9').filter(|to| *to != byte) {
                tried += 1;
                wrongs.extend(wrong(settings, &Change { line: line.clone(), at, to }));
            }
        }
    }
    assert!(tried > 300, "five lines of eight digits and more: {tried}");
    assert!(wrongs.is_empty(), "{} of {tried}: {wrongs:#?}", wrongs.len());
}

#[test]
fn every_changed_digit_of_a_distance_is_found() {
    every_changed_digit_is_found(&json!({"homing": "switches", "pin_dwell_s": 0}));
}

/// A position sets right what the one before has moved: a bend that went too far would not show at the end of its step.
#[test]
fn every_changed_digit_of_a_position_is_found() {
    let settings = json!({"homing": "switches", "pin_dwell_s": 0, "mode": "absolute", "arc_step_deg": 60});
    every_changed_digit_is_found(&settings);
}
