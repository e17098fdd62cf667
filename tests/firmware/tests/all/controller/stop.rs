//! STOP at any moment: nothing moves after it, and nothing moves again before the machine was homed.

use wirebend_driver_wirebend_kit::protocol::{Alarm, State};

use crate::controller::talk::{ANSWER_MS, Talk};
use wirebend_tests_firmware::board::{Avr, Board, Host, MS, What};

/// The last pulse must come this much after the byte is over at the latest.
const LATEST: u64 = 20 * MS;
/// A servo that was commanded before the STOP begins its next frame of 20.48 ms with that, and shows it at
/// the end of a pulse of 2 ms.
const SERVO_LATEST: u64 = 23 * MS;
/// A byte on the wire.
const BYTE: u64 = 1360;

/// What came of a STOP.
struct Stopped {
    /// How late the last pulse was, in cycles after the end of the byte.
    late: u64,
    /// Whether something moved when it came: a pulse of the slowest homing move comes every 10 ms.
    moved: bool,
}

/// Runs a feed, a turn, and a bend; STOP comes so many cycles after the line was sent.
fn stopped_in_line<B: Board>(after: u64) -> Stopped {
    let mut talk = Talk::<B>::homed();
    talk.say("M2,1500,400,700");
    talk.say("M3,1500,0,0");
    talk.wait_cycles(after);
    stop_now(&mut talk, 4)
}

fn stop_now<B: Board>(talk: &mut Talk<B>, next: u32) -> Stopped {
    talk.heard.clear();
    let counted = talk.table.seen.len();
    talk.stop();
    let at = talk.table.board.now() + BYTE;
    let last = talk.table.seen.iter().rev().find(|seen| matches!(seen.what, What::Pulse { .. })).unwrap();
    let moved = at - last.at < 15 * MS;
    talk.wait(3000);
    let mut late = 0;
    for seen in &talk.table.seen[counted..] {
        let after = seen.at.saturating_sub(at);
        match seen.what {
            What::Pulse { .. } => late = late.max(after),
            What::Servo { .. } => {
                assert!(after < SERVO_LATEST, "{}: the peg moves {after} cycles after", B::NAME);
            }
            _ => {}
        }
    }
    let place = format!("{} at {counted}", B::NAME);
    assert!(late < LATEST, "{place}: a pulse {late} cycles after the STOP");
    assert_eq!(talk.heard.iter().filter(|heard| *heard == "x1").count(), 1, "{place}: {:?}", talk.heard);
    let status = talk.status();
    assert_eq!((status.state, status.alarm, status.homed), (State::Alarm, Alarm::Stop, false), "{place}");
    assert_eq!(status.position.map(i64::from)[..2], talk.table.counted[..2], "{place}: reported and counted");
    let n = status.last + 1;
    assert!(n <= next, "{place}");
    assert_eq!(talk.asked(&format!("M{n},100,0,0")), [format!("e3,{n},77")], "{place}: 77 is M, 3 an alarm");
    assert_eq!(talk.asked("G"), [format!("e3,{n},71")], "{place}: no go-on leaves it");
    Stopped { late, moved }
}

fn worst<B: Board>(what: &str, moments: impl Iterator<Item = u64>, stopped: fn(u64) -> Stopped) {
    let ends: Vec<_> = moments.map(stopped).collect();
    let (count, moving) = (ends.len(), ends.iter().filter(|end| end.moved).count());
    let late = ends.iter().map(|end| end.late).max().unwrap();
    println!(
        "STOP, {}, {what}: {count} moments, {moving} in motion; last pulse {late} cycles after it",
        B::NAME
    );
    assert!(moving * 3 > count, "most moments are at rest: {moving} of {count} are not");
}

/// The line takes about 6 s: from the feed to the peg's way in.
#[test]
fn stop_in_a_line() {
    worst::<Avr>("a line", (0..40).map(|i| MS * (1 + i * 151)), stopped_in_line::<Avr>);
    worst::<Host>("a line", (0..400).map(|i| MS * (1 + i * 15)), stopped_in_line::<Host>);
}

/// The feed at full speed, 5988 steps/s: a pulse every 2672 cycles.
#[test]
fn stop_at_every_place_between_two_pulses() {
    worst::<Avr>("full speed", (0..60).map(|i| 400 * MS + i * 47), stopped_in_line::<Avr>);
}

/// While the line is looked at, its ramp reckoned and its timer started.
#[test]
fn stop_while_a_line_begins() {
    let bytes = u64::try_from("\nM2,1500,0,0*0000\n".len()).unwrap();
    let ends = (0..80).map(|i| {
        let mut talk = Talk::<Avr>::homed();
        let pulses = talk.table.pulses();
        talk.say("M2,1500,0,0");
        talk.wait_cycles((bytes - 1) * BYTE + i * 101);
        let late = stop_now(&mut talk, 3).late;
        (late, talk.table.pulses() - pulses)
    });
    let (late, pulses) = ends.fold((0, 0), |most, end| (most.0.max(end.0), most.1.max(end.1)));
    println!(
        "STOP as a line begins: 80 moments, {pulses} pulses done at most, the last {late} cycles after it"
    );
    assert!(pulses <= 1);
}

fn stopped_in_homing<B: Board>(after: u64) -> Stopped {
    let mut talk = Talk::<B>::homed();
    talk.say("H2");
    talk.wait_cycles(after);
    stop_now(&mut talk, 3)
}

/// Homing takes about 4 s, and the way to zero 2 s.
#[test]
fn stop_in_homing() {
    worst::<Avr>("homing", (0..15).map(|i| MS * (600 + i * 411)), stopped_in_homing::<Avr>);
    worst::<Host>("homing", (0..150).map(|i| MS * (600 + i * 41)), stopped_in_homing::<Host>);
}

fn stopped_in_hold<B: Board>(after: u64) -> Stopped {
    let mut talk = Talk::<B>::homed();
    talk.say("M2,6000,0,0");
    talk.wait(300);
    talk.say("P");
    talk.wait_cycles(after);
    stop_now(&mut talk, 3)
}

/// A feed at 6000 steps/s with 30000 steps/s² holds within 200 ms.
#[test]
fn stop_while_it_slows_down_and_holds() {
    worst::<Avr>("holding", (0..12).map(|i| MS * (1 + i * 23)), stopped_in_hold::<Avr>);
    worst::<Host>("holding", (0..120).map(|i| MS * (1 + i * 2)), stopped_in_hold::<Host>);
}

fn answered_each_time<B: Board>() {
    let mut talk = Talk::<B>::homed();
    talk.say("M2,6000,0,0");
    talk.wait(100);
    for _ in 0..5 {
        talk.heard.clear();
        talk.stop();
        talk.wait(ANSWER_MS);
        assert_eq!(talk.taken(), ["x1"], "{}", B::NAME);
    }
    talk.home(3);
    let status = talk.status();
    assert_eq!((status.state, status.alarm, status.homed), (State::Idle, Alarm::None, true));
    let feed = talk.table.counted[0];
    assert_eq!(talk.asked("M4,100,0,0"), ["a4,7"]);
    talk.wait(500);
    assert_eq!(talk.table.counted[0], feed + 100, "the line of before is forgotten, the new one is run");
}

#[test]
fn every_stop_is_answered_and_homing_leaves_it() {
    answered_each_time::<Avr>();
    answered_each_time::<Host>();
}

/// A byte with a framing error, and bytes one flip away from a STOP: the first stops, the others do not.
#[test]
fn a_stop_with_a_framing_error_stops_too() {
    let mut talk = Talk::<Avr>::homed();
    talk.say("M2,6000,0,0");
    talk.wait(100);
    for bit in 0..7 {
        talk.table.board.send(&[0x80 ^ 1 << bit]);
    }
    talk.wait(5);
    assert_eq!(talk.status().state, State::Run);
    talk.table.board.uno.send_broken(0x80);
    talk.wait(ANSWER_MS);
    assert_eq!(talk.status().alarm, Alarm::Stop);
}
