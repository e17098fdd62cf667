//! The driver on a real serial port: a pair of terminals with a model of the controller at the other end.

#![cfg(unix)]

mod interrupted;
mod line;
#[allow(dead_code)] // tests of the command line use the rest
mod model;

use std::time::{Duration, Instant};

use model::{Build, Model, Record};
use serde_json::{Value, json};
use serialport::{SerialPort, TTYPort};
use wirebend_driver_api::{
    Axis, AxisRate, Batch, DoneBy, Event, HeadBy, Limits, MachineDriver, MachineSession, Motion,
    NumberedStep, ReferenceBy, Run, Step,
};
use wirebend_driver_grbl::Grbl;

/// A slow machine may take long; nothing waits for it when it is fast.
const DEADLINE: Duration = Duration::from_mins(1);

/// A corner in three dimensions. All of it is whole steps of the model.
const WIRE: [Step; 4] = [
    Step { feed_mm: 60.0, rotate_deg: 90.0, bend_deg: 90.0, approach_deg: None },
    Step { feed_mm: 40.5, rotate_deg: -45.0, bend_deg: -60.25, approach_deg: None },
    Step { feed_mm: 0.0, rotate_deg: 10.0, bend_deg: 30.0, approach_deg: None },
    Step { feed_mm: 70.0, rotate_deg: 0.0, bend_deg: 0.0, approach_deg: None },
];

/// A feed that takes the model seconds: whatever is asked for comes while it moves.
const LONG: [Step; 1] = [Step { feed_mm: 5000.0, rotate_deg: 0.0, bend_deg: 0.0, approach_deg: None }];

struct Bench {
    session: Box<dyn MachineSession>,
    model: Model,
    /// The driver's end. While it is open, nothing is lost of what either side says before the other listens.
    cable: TTYPort,
}

fn bench(mut settings: Value) -> Bench {
    settings["homing"] = json!("switches");
    built(settings, Build::default())
}

fn built(settings: Value, build: Build) -> Bench {
    let (mut machine, cable) = TTYPort::pair().expect("a pair of terminals");
    machine.set_timeout(Duration::from_millis(1)).expect("a timeout");
    let name = cable.name().expect("its name");
    let model = Model::run(machine, build);
    let driver = Grbl::open(serde_json::from_value(settings).unwrap()).unwrap();
    Bench { session: driver.connect(&name, None).unwrap(), model, cable }
}

/// The events until one is what is waited for, that one included; what only informs is left out.
fn until(session: &mut dyn MachineSession, wanted: impl Fn(&Event) -> bool) -> Vec<Event> {
    let begin = Instant::now();
    let mut events = Vec::new();
    while begin.elapsed() < DEADLINE {
        match session.poll().expect("a session that can be polled") {
            None | Some(Event::Console { .. } | Event::Position(_)) => {}
            Some(event) => {
                let over = wanted(&event);
                events.push(event);
                if over {
                    return events;
                }
            }
        }
    }
    panic!("it did not come: {events:?}");
}

/// All events until one is what is waited for.
fn until_told(session: &mut dyn MachineSession, wanted: impl Fn(&Event) -> bool) -> Vec<Event> {
    let begin = Instant::now();
    let mut events = Vec::new();
    while begin.elapsed() < DEADLINE {
        let Some(event) = session.poll().expect("a session that can be polled") else { continue };
        let over = wanted(&event);
        events.push(event);
        if over {
            return events;
        }
    }
    panic!("it did not come: {events:?}");
}

/// No axis is faster than a board lets it be.
fn rates(per_s: f64) -> Vec<AxisRate> {
    let axes = [(Axis::Feed, "$110"), (Axis::Rotate, "$111"), (Axis::Bend, "$112")];
    axes.map(|(axis, setting)| AxisRate::new(axis, per_s, &[setting])).into()
}

fn connected_and_homed(session: &mut dyn MachineSession) {
    let events = until(session, |event| matches!(event, Event::Connected { .. }));
    let connected = Event::Connected {
        identity: "Grbl 1.1h, 1.1h.20190830:model".to_owned(),
        settings: Vec::new(),
        homed: false,
        resume: None,
        reference: ReferenceBy::Machine,
        done_by: DoneBy::Machine,
        head: HeadBy::Reference,
        // What the model says of $110 to $112: 40 steps in a millisecond, 80 for each unit.
        limits: Limits { rates: rates(500.0), ..Limits::default() },
    };
    assert_eq!(events, [connected]);
    session.home().unwrap();
    assert_eq!(until(session, |event| *event == Event::Homed), [Event::Homed]);
}

fn arm_and_send(session: &mut dyn MachineSession, wire: &[Step]) {
    let count = u32::try_from(wire.len()).unwrap();
    let run =
        Run { job_hash: "5a".repeat(32), name: "corner".to_owned(), wire: 0, steps: count, ..Run::default() };
    session.arm(&run).unwrap();
    let steps = (1..).zip(wire).map(|(n, &step)| NumberedStep { n, step }).collect();
    assert_eq!(session.send(&Batch { steps, last: true }).unwrap().accepted, count);
}

fn makes_the_wire(settings: Value) {
    let mut bench = bench(settings);
    let session = bench.session.as_mut();
    connected_and_homed(session);
    arm_and_send(session, &WIRE);
    let events = until(session, |event| matches!(event, Event::Finished | Event::Fault { .. }));
    let done = |n| Event::Done { n };
    assert_eq!(events, [done(1), done(2), done(3), done(4), Event::Finished]);
    drop(bench.session);
    let record = bench.model.end();
    // Feeds and rotations of WIRE added up, where each bend was done; nothing was reset, not even on leaving.
    let made = Record {
        bends: vec![[60.0, 90.0, 90.0], [100.5, 45.0, -60.25], [100.5, 55.0, 30.0]],
        cuts: Vec::new(),
        at: [170.5, 55.0, 0.0],
        overflowed: false,
        resets: 0,
    };
    assert_eq!(record, made);
}

/// The blade 12.5 mm beyond the place where a wire begins, and 8 mm within the machine.
#[test]
fn a_wire_is_cut_at_the_cutter_and_its_tip_brought_back() {
    for cutter_mm in [12.5, -8.0, 0.0] {
        let cut = ["M8", "G4 P0.1", "M9"];
        let mut bench = bench(json!({"pin_dwell_s": 0.05, "cut": cut, "cutter_mm": cutter_mm}));
        let session = bench.session.as_mut();
        connected_and_homed(session);
        arm_and_send(session, &WIRE);
        until(session, |event| matches!(event, Event::Finished | Event::Fault { .. }));
        session.cut().unwrap();
        assert_eq!(until(session, |event| !matches!(event, Event::Speed { .. })), [Event::Cut]);
        drop(bench.session);
        let record = bench.model.end();
        assert_eq!((record.cuts, record.at), (vec![170.5 + cutter_mm], [170.5, 55.0, 0.0]));
    }
}

#[test]
fn without_lines_that_cut_there_is_no_cutter() {
    let mut bench = bench(json!({}));
    let session = bench.session.as_mut();
    connected_and_homed(session);
    assert_eq!(session.cut().unwrap_err().code, "no-cutter");
    let limits = |settings: Value| Grbl::open(serde_json::from_value(settings).unwrap()).unwrap().limits();
    assert_eq!(limits(json!({"cutter_mm": 3})).cutter_mm, None);
    assert_eq!(limits(json!({"cutter_mm": 3, "cut": ["M8"]})).cutter_mm, Some(3.0));
}

#[test]
fn a_wire_is_made_one_line_at_a_time() {
    makes_the_wire(json!({"pin_dwell_s": 0.05}));
}

#[test]
fn a_wire_is_made_by_counting_characters() {
    makes_the_wire(json!({"streaming": "character-counting", "mode": "relative", "arc_step_deg": 10}));
}

#[test]
fn a_step_is_done_when_it_has_been_made_and_not_when_it_was_taken() {
    let mut bench = bench(json!({}));
    let session = bench.session.as_mut();
    connected_and_homed(session);
    arm_and_send(session, &WIRE);
    let mut last = Step::default();
    let begin = Instant::now();
    let mut done = 0;
    while done < 4 && begin.elapsed() < DEADLINE {
        match session.poll().unwrap() {
            Some(Event::Position(position)) => last = position,
            Some(Event::Done { n }) => {
                done = n;
                let fed: f64 = WIRE[..n as usize].iter().map(|step| step.feed_mm).sum();
                let turned: f64 = WIRE[..n as usize].iter().map(|step| step.rotate_deg).sum();
                // Whole steps of the model, written with three decimals.
                assert!((last.feed_mm - fed).abs() < 1e-3, "step {n} is done at {last:?}");
                assert!((last.rotate_deg - turned).abs() < 1e-3, "step {n} is done at {last:?}");
                assert!(last.bend_deg.abs() < 1e-3, "step {n} is done at {last:?}");
            }
            _ => {}
        }
    }
    assert_eq!(done, 4);
    drop(bench.session);
    bench.model.end();
}

#[test]
fn a_stop_halts_what_moves() {
    let mut bench = bench(json!({}));
    let session = bench.session.as_mut();
    connected_and_homed(session);
    session.jog(Motion::new(Axis::Feed, 5.0)).unwrap();
    assert_eq!(until(session, |event| *event == Event::Jogged), [Event::Jogged]);
    arm_and_send(session, &LONG);
    until_moved(session, 10.0);
    session.stop().unwrap();
    let events = until(session, |event| matches!(event, Event::Stopped { .. }));
    let [Event::PartMade { step: 1, made: Some(made), exact: false }, Event::Stopped { homed: false }] =
        events.as_slice()
    else {
        panic!("{events:?}")
    };
    let told = made.feed_mm;
    drop(bench.session);
    let record = bench.model.end();
    assert_eq!((record.resets, record.bends.len()), (1, 0));
    assert!((10.0..5005.0).contains(&record.at[0]), "it was stopped on its way: {:?}", record.at);
    // The jog before the wire is none of its step.
    assert!((told - (record.at[0] - 5.0)).abs() < 0.01, "told {told}, made {:?}", record.at);
}

/// Two bytes that come between two turns of its loop count once: were they not sent one after the other, it would stand at 90 %.
#[test]
fn a_wire_has_the_speed_that_is_asked_for() {
    let mut bench = bench(json!({}));
    let session = bench.session.as_mut();
    connected_and_homed(session);
    arm_and_send(session, &LONG);
    until_moved(session, 10.0);
    for percent in [72, 100, 130] {
        session.set_speed(percent).unwrap();
        until(session, |event| *event == Event::Speed { percent });
    }
    session.stop().unwrap();
    until(session, |event| matches!(event, Event::Stopped { .. }));
    drop(bench.session);
    bench.model.end();
}

/// Polls until the wire has been fed so far.
fn until_moved(session: &mut dyn MachineSession, least_mm: f64) {
    let begin = Instant::now();
    while begin.elapsed() < DEADLINE {
        if let Some(Event::Position(position)) = session.poll().unwrap()
            && position.feed_mm >= least_mm
        {
            return;
        }
    }
    panic!("it did not move");
}

#[test]
fn leaving_a_machine_that_moves_resets_it() {
    let mut bench = bench(json!({}));
    connected_and_homed(bench.session.as_mut());
    arm_and_send(bench.session.as_mut(), &LONG);
    until_moved(bench.session.as_mut(), 10.0);
    drop(bench.session);
    let begin = Instant::now();
    while bench.model.resets() == 0 && begin.elapsed() < DEADLINE {
        std::thread::sleep(Duration::from_millis(1));
    }
    assert_eq!(bench.model.end().resets, 1);
    drop(bench.cable);
}

#[test]
fn a_cable_that_is_pulled_is_told_with_the_step_in_doubt() {
    let mut bench = bench(json!({}));
    let session = bench.session.as_mut();
    connected_and_homed(session);
    arm_and_send(session, &LONG);
    until_moved(session, 1.0);
    bench.model.end();
    let events = until(session, |event| matches!(event, Event::Fault { .. }));
    let [Event::Fault { error, in_doubt: Some(1), disconnected: true }] = events.as_slice() else {
        panic!("{events:?}");
    };
    assert_eq!(error.code, "unplugged");
    assert_eq!(session.stop().expect_err("there is no machine to stop").code, "disconnected");
}
