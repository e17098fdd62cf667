//! Dry-run moves: the peg stays in, the axis goes there and back, and everything has a quarter of its speed.

use wirebend_driver_wirebend_kit::protocol::Alarm;
use wirebend_tests_firmware::board::{Avr, BEND, Board, HZ, Host, Observation, What};

use crate::controller::talk::Talk;

const FEED: usize = 0;
const ROTATE: usize = 1;

/// What a line makes a homed machine do.
fn done<B: Board>(line: &str) -> Vec<Observation> {
    let mut talk = Talk::<B>::homed();
    let from = talk.table.seen.len();
    talk.say(line);
    talk.wait(120_000);
    assert_eq!(talk.status().done, 2, "{}: {line}", B::NAME);
    assert_eq!(talk.status().position[BEND], 0, "{}: {line}", B::NAME);
    talk.table.seen.split_off(from)
}

/// The pulses of an axis, forward and backward, and the time between two of them at most places, cycles.
fn pulses(seen: &[Observation], wanted: usize) -> (usize, usize, u64) {
    let of_axis = seen.iter().filter_map(|seen| match seen.what {
        What::Pulse { axis, forward } if axis == wanted => Some((seen.at, forward)),
        _ => None,
    });
    let of_axis: Vec<(u64, bool)> = of_axis.collect();
    let forward = of_axis.iter().filter(|(_, forward)| *forward).count();
    let mut apart: Vec<u64> = of_axis.windows(2).map(|pair| pair[1].0 - pair[0].0).collect();
    apart.sort_unstable();
    (forward, of_axis.len() - forward, apart[apart.len() / 2])
}

fn slow<B: Board>() {
    let (wire, dry) = (done::<B>("M2,4000,-2000,1400"), done::<B>("Y2,4000,-2000,1400"));
    // With the setting of its speed.
    for (axis, setting, forward, backward) in
        [(FEED, 4, 4000, 0), (ROTATE, 5, 0, 2000), (BEND, 6, 1400, 1400)]
    {
        let (there, back, apart) = pulses(&dry, axis);
        assert_eq!((there, back), (forward, backward), "{}: axis {axis}", B::NAME);
        let rate: u64 = Talk::<B>::open().asked(&format!("C{setting}"))[0][3..].parse().unwrap();
        let percent = 100 * apart * rate / (4 * HZ);
        assert!((99..=101).contains(&percent), "{}: axis {axis}, {apart} cycles at {rate}", B::NAME);
    }
    let servo =
        |seen: &[Observation]| seen.iter().filter(|seen| matches!(seen.what, What::Servo { .. })).count();
    assert_eq!((servo(&wire), servo(&dry)), (2, 0), "{}", B::NAME);
}

#[test]
fn a_dry_run_move_is_slow_and_leaves_the_peg_in() {
    slow::<Avr>();
    slow::<Host>();
}

/// What was out by hand comes in first.
fn takes_the_peg_in<B: Board>() {
    let mut talk = Talk::<B>::homed();
    talk.say("K2,1");
    talk.wait(2000);
    assert_eq!(talk.status().peg_out, Some(true), "{}", B::NAME);
    let from = talk.table.seen.len();
    talk.say("Y3,0,0,300");
    talk.wait(30_000);
    assert_eq!((talk.status().done, talk.status().peg_out), (3, Some(false)), "{}", B::NAME);
    let first = talk.table.seen[from..].iter().find(|seen| !matches!(seen.what, What::Servo { .. }));
    let servo = talk.table.seen[from..].iter().position(|seen| matches!(seen.what, What::Servo { .. }));
    assert!(first.is_some() && servo == Some(0), "{}: {first:?}", B::NAME);
}

#[test]
fn a_peg_that_is_out_goes_in_before_a_dry_run_move() {
    takes_the_peg_in::<Avr>();
    takes_the_peg_in::<Host>();
}

fn refused<B: Board>() {
    let mut talk = Talk::<B>::open();
    // 5 is not homed, 2 the range and 6 the soft limit; 89 is Y.
    assert_eq!(talk.asked("Y1,100,0,0"), ["e5,1,89"], "{}", B::NAME);
    let mut talk = Talk::<B>::homed();
    for (line, code) in [
        ("Y2,0,0", 2),
        ("Y2,0,0,1400,-1200", 2),
        ("Y2,0,0,1500", 0),
        ("Y3,0,0,1501", 6),
        ("Y3,0,99999999,0", 6),
    ] {
        let expected = if code == 0 { "a2,7".to_owned() } else { format!("e{code},{},89", &line[1..2]) };
        assert_eq!(talk.asked(line), [expected], "{}: {line}", B::NAME);
    }
}

#[test]
fn a_dry_run_move_keeps_to_the_limits() {
    refused::<Avr>();
    refused::<Host>();
}

/// It holds, resumes and is stopped like every other line. No wire is in the way of the peg then, so that the axis is homed at once.
fn held_and_stopped<B: Board>() {
    let mut talk = Talk::<B>::homed();
    talk.say("Y2,0,0,1400");
    talk.wait(500);
    talk.say("P");
    talk.wait(1000);
    let held = talk.status().position[BEND];
    talk.wait(500);
    assert!(held > 0 && talk.status().position[BEND] == held, "{}: {held}", B::NAME);
    talk.say("G");
    talk.wait(500);
    assert!(talk.status().position[BEND] > held, "{}", B::NAME);
    talk.stop();
    talk.wait(500);
    let stopped = talk.status();
    assert_eq!((stopped.alarm, stopped.peg_out), (Alarm::Stop, Some(false)), "{}", B::NAME);
    talk.home(3);
    assert_eq!(talk.status().position[BEND], 0, "{}", B::NAME);
}

#[test]
fn a_dry_run_move_is_held_and_stopped_as_any_other() {
    held_and_stopped::<Avr>();
    held_and_stopped::<Host>();
}
