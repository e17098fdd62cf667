//! Homing after a bend that was ended in its middle: the peg goes off the wire, then in, then the axis is homed.

use wirebend_driver_wirebend_kit::protocol::Alarm;
use wirebend_tests_firmware::board::{Avr, BEND, Board, Host, Reset, What};

use crate::controller::talk::Talk;

/// Settings that the core was built with, steps: the peg comes out so far before zero, and goes so far back.
const NEAR_SIDE: i64 = 1089;
const BACK_OFF: i64 = 1193;
/// Positions of the servo, µs.
const IN: &str = "peg 1000";
const OUT: &str = "peg 2000";

/// What was done, in order: how far the bend axis went each way, and what was sent to the servo.
fn done<B: Board>(talk: &Talk<B>, from: usize) -> Vec<String> {
    let mut done: Vec<(String, i64)> = Vec::new();
    for seen in &talk.table.seen[from..] {
        let (what, by) = match seen.what {
            What::Pulse { axis: BEND, forward } => (String::new(), if forward { 1 } else { -1 }),
            What::Pulse { axis, .. } => (format!("axis {axis}"), 0),
            What::Servo { width_us } => (format!("peg {width_us}"), 0),
            What::Motors(_) | What::Byte(_) => continue,
        };
        match done.last_mut() {
            Some((last, way)) if *last == what && way.signum() == by => *way += by,
            _ => done.push((what, by)),
        }
    }
    done.into_iter().map(|(what, way)| if what.is_empty() { way.to_string() } else { what }).collect()
}

/// In a bend of 1400 steps to one side, with the peg pressing on the wire.
fn in_a_bend<B: Board>(side: i64) -> Talk<B> {
    let mut talk = Talk::<B>::homed();
    talk.say(&format!("M2,0,0,{}", 1400 * side));
    for _ in 0..200 {
        let status = talk.status();
        if status.peg_out == Some(true) && i64::from(status.position[BEND]) * side > 300 {
            return talk;
        }
        talk.wait(50);
    }
    panic!("{}: it does not bend", B::NAME);
}

/// The way off the wire comes first, against the bend; the peg goes in after it and before anything else.
#[track_caller]
fn goes_off_first<B: Board>(talk: &mut Talk<B>, n: u32, side: i64, way: i64, what: &str) {
    let from = talk.table.seen.len();
    talk.home(n);
    let done = done(talk, from);
    let expected = [(-side * way).to_string(), IN.to_owned()];
    assert_eq!(done[..2], expected, "{}, {what}: {done:?}", B::NAME);
    assert!(!done[2..].iter().any(|what| what.starts_with("peg")), "{}, {what}: {done:?}", B::NAME);
    assert!(talk.status().homed);
    // And it is bent again as ever: nothing of before is left.
    let from = talk.table.seen.len();
    talk.home(n + 1);
    let again = self::done(talk, from);
    assert!(again.iter().all(|what| !what.starts_with("peg")), "{}, {what}: {again:?}", B::NAME);
    let towards = again[0].parse::<i64>().unwrap();
    assert!(towards < -NEAR_SIDE, "{}, {what}: to the switch at once, not {towards}", B::NAME);
}

fn after_a_stop<B: Board>() {
    for side in [1, -1] {
        let mut talk = in_a_bend::<B>(side);
        talk.stop();
        talk.wait(1000);
        assert_eq!(talk.status().alarm, Alarm::Stop);
        let stands = i64::from(talk.status().position[BEND]);
        // Less than from where it stands to where the peg came out, which is clear of the wire.
        assert!(stands * side - BACK_OFF > -NEAR_SIDE, "{stands}");
        goes_off_first(&mut talk, 3, side, BACK_OFF, &format!("stopped at {stands}"));
    }
}

#[test]
fn after_a_stop_in_a_bend_the_peg_leaves_the_wire_before_it_goes_in() {
    after_a_stop::<Avr>();
    after_a_stop::<Host>();
}

/// Opening a port resets the board; a supply that fails takes the RAM with it.
fn after_a_reset<B: Board>() {
    for (cause, side) in
        [(Reset::External, 1), (Reset::External, -1), (Reset::PowerOn, -1), (Reset::Watchdog, 1)]
    {
        let mut talk = in_a_bend::<B>(side);
        talk.reset(cause);
        talk.begin_session(7);
        // By hand the peg must not be drawn in either; 75 is K and 5 wants homing.
        let refused = if cause == Reset::Watchdog { "e3,1,75" } else { "e5,1,75" };
        assert_eq!(talk.asked("K1,0"), [refused], "{}: {cause:?}", B::NAME);
        goes_off_first(&mut talk, 1, side, BACK_OFF, &format!("{cause:?}"));
    }
}

#[test]
fn after_a_reset_in_a_bend_the_peg_leaves_the_wire_before_it_goes_in() {
    after_a_reset::<Avr>();
    after_a_reset::<Host>();
}

/// A switch that reads as pressed on the way off the wire: its wire is broken. The peg stays where it is.
fn with_a_broken_switch<B: Board>() {
    let mut talk = in_a_bend::<B>(1);
    talk.stop();
    talk.wait(1000);
    talk.table.set_switch(Box::new(|_| true));
    let from = talk.table.seen.len();
    talk.say("H3");
    talk.wait(3000);
    let status = talk.status();
    assert_eq!((status.alarm, status.peg_out), (Alarm::Homing, Some(true)), "{}", B::NAME);
    assert!(!done(&talk, from).contains(&IN.to_owned()), "{}: under load", B::NAME);
    // Repaired, it continues from there.
    talk.table.set_switch(Box::new(|bend| bend <= wirebend_tests_firmware::table::EDGE));
    let from = talk.table.seen.len();
    talk.home(4);
    assert_eq!(done(&talk, from)[1], IN, "{}", B::NAME);
}

#[test]
fn with_a_broken_switch_the_peg_is_not_drawn_in_under_load() {
    with_a_broken_switch::<Avr>();
    with_a_broken_switch::<Host>();
}

/// Stopped anywhere in a bend, and in the homing after it: the peg is sent in only where it is clear, which
/// is a whole way back from the farthest that it was pressed to, or where it had come out.
fn anywhere<B: Board>(side: i64, moments: impl Iterator<Item = u64>) {
    let mut pressed_ones = 0;
    for ms in moments {
        let mut talk = Talk::<B>::homed();
        let zero = talk.table.bend;
        talk.say(&format!("M2,0,0,{}", 1400 * side));
        talk.wait(ms);
        talk.stop();
        talk.wait(200);
        talk.say("H3");
        talk.wait(400);
        talk.stop(); // in the middle of its way back
        talk.wait(200);
        talk.home(4);
        // Since the peg came out: the farthest that it was, on the side of the bend.
        let (mut at, mut farthest, mut out) = (0, None::<i64>, false);
        let total: i64 = talk.table.bend - talk.table.counted[BEND];
        for seen in &talk.table.seen {
            match seen.what {
                What::Pulse { axis: BEND, forward } => at += if forward { 1 } else { -1 },
                What::Servo { width_us: 2000 } => (out, farthest) = (true, None),
                What::Servo { width_us: 1000 } if out => {
                    let place = (at + total - zero) * side;
                    let most = farthest.unwrap_or(place);
                    assert!(
                        place <= (most - BACK_OFF).max(-NEAR_SIDE) + 4,
                        "{}, {ms} ms, side {side}: {OUT} to {IN} at {place} after {most}",
                        B::NAME
                    );
                    pressed_ones += u32::from(most > 0);
                    out = false;
                }
                _ => {}
            }
            if out {
                let place = (at + total - zero) * side;
                farthest = Some(farthest.map_or(place, |most| most.max(place)));
            }
        }
    }
    assert!(pressed_ones > 5, "{}: {pressed_ones} of them pressed on the wire", B::NAME);
}

#[test]
fn stopped_anywhere_in_a_bend_the_peg_goes_in_only_where_it_is_clear() {
    for side in [1, -1] {
        anywhere::<Host>(side, (0..60).map(|i| 1500 + i * 100));
        anywhere::<Avr>(side, (0..8).map(|i| 2600 + i * 500));
    }
}
