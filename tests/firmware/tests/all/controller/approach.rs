//! Where the peg comes out: at the near side, or farther where a line says so.

use wirebend_driver_wirebend_kit::protocol::Alarm;
use wirebend_tests_firmware::board::{Avr, BEND, Board, Host, What};

use crate::controller::talk::Talk;

/// Settings that the core was built with, steps.
const NEAR_SIDE: i64 = 1089;
const BACK_OFF: i64 = 1193;
/// Positions of the servo, µs.
const IN: u16 = 1000;
const OUT: u16 = 2000;

/// Where the bend axis stood when the peg was sent out, and in.
fn pegs<B: Board>(talk: &Talk<B>, from: usize) -> Vec<(u16, i64)> {
    let mut at = 0;
    let mut pegs = Vec::new();
    for (index, seen) in talk.table.seen.iter().enumerate() {
        match seen.what {
            What::Pulse { axis: BEND, forward } => at += if forward { 1 } else { -1 },
            What::Servo { width_us } if index >= from => pegs.push((width_us, at)),
            _ => {}
        }
    }
    pegs
}

/// What a line does with the peg, from a homed machine at zero on; places of the axis are from there.
fn bent<B: Board>(line: &str) -> Vec<(u16, i64)> {
    let mut talk = Talk::<B>::homed();
    let (from, zero) = (talk.table.seen.len(), pegs_zero(&talk));
    talk.say(line);
    talk.wait(60_000);
    assert_eq!(talk.status().done, 2, "{}: {line}", B::NAME);
    pegs(&talk, from).into_iter().map(|(width, at)| (width, at - zero)).collect()
}

/// How many steps of the bend axis were counted until it stood at zero.
fn pegs_zero<B: Board>(talk: &Talk<B>) -> i64 {
    let steps = talk.table.seen.iter().map(|seen| match seen.what {
        What::Pulse { axis: BEND, forward } => {
            if forward {
                1
            } else {
                -1
            }
        }
        _ => 0,
    });
    steps.sum()
}

fn comes_out<B: Board>() {
    for side in [1, -1] {
        let line = |approach: i64| format!("M2,0,0,{},{}", 1400 * side, -side * approach);
        // It backs off no further than to where it came out.
        for (said, out) in [(0, NEAR_SIDE), (700, NEAR_SIDE), (1090, 1090), (1450, 1450)] {
            let expected = [(OUT, -side * out), (IN, side * (1400 - BACK_OFF).max(-out))];
            assert_eq!(bent::<B>(&line(said)), expected, "{}: {said} to {side}", B::NAME);
        }
        let without = bent::<B>(&format!("M2,0,0,{}", 1400 * side));
        assert_eq!(without, bent::<B>(&line(0)), "{}", B::NAME);
    }
}

#[test]
fn the_peg_comes_out_where_a_line_says() {
    comes_out::<Avr>();
    comes_out::<Host>();
}

/// Where the bend axis stood each time that it turned round, from zero on, and at its end.
fn turns<B: Board>(talk: &Talk<B>, from: usize) -> Vec<i64> {
    let mut places = vec![0];
    let mut last = None;
    for seen in &talk.table.seen[from..] {
        if let What::Pulse { axis: BEND, forward } = seen.what {
            let at = places.last().copied().unwrap_or_default();
            if last.replace(forward) != Some(forward) {
                places.push(at);
            }
            if let Some(end) = places.last_mut() {
                *end += if forward { 1 } else { -1 };
            }
        }
    }
    places.split_off(1)
}

/// A wire that springs back little is bent enough before the peg is at zero: on the side from which it comes, the axis stops, goes
/// back to where the peg came out, and then to zero.
fn before_zero<B: Board>() {
    for side in [1, -1] {
        for (said, out) in [(600, NEAR_SIDE), (NEAR_SIDE, NEAR_SIDE), (1450, 1450)] {
            // As far as to the last step before where the peg came out.
            for stop in [300, 0, -300, 1 - out] {
                let line = format!("M2,0,0,{},{}", side * stop, -side * said);
                let mut talk = Talk::<B>::homed();
                let (from, zero) = (talk.table.seen.len(), pegs_zero(&talk));
                talk.say(&line);
                talk.wait(60_000);
                assert_eq!(talk.status().done, 2, "{}: {line}", B::NAME);
                let back = (stop - BACK_OFF).max(-out);
                let expected = [-out, stop, if back < 0 { back } else { 0 }, 0].map(|at| side * at);
                let expected = if back == 0 { &expected[..3] } else { &expected[..] };
                assert_eq!(turns(&talk, from), expected, "{}: {line}", B::NAME);
                let moved = pegs(&talk, from).into_iter().map(|(width, at)| (width, at - zero));
                assert_eq!(moved.collect::<Vec<_>>(), [(OUT, -side * out), (IN, side * back)], "{line}");
            }
        }
    }
}

#[test]
fn a_bend_may_stop_at_zero_or_before_it() {
    before_zero::<Avr>();
    before_zero::<Host>();
}

fn refused<B: Board>() {
    let mut talk = Talk::<B>::homed();
    // 2 is the range and 6 the soft limit; 77 is M.
    for (line, code) in [
        ("M2,0,0,1400,1200", 2),
        ("M2,0,0,-1400,-1200", 2),
        // Where the peg comes out, or farther out, nothing is bent.
        ("M2,0,0,-1200,-1200", 2),
        ("M2,0,0,1089,700", 2),
        ("M2,0,0,-1089,-1", 2),
        ("M2,0,0,-1300,-1200", 2),
        ("M2,0,0,1400,-1200,0", 2),
        ("M2,0,0,1400,", 2),
        ("M2,0,0,1400,-99999", 6),
    ] {
        assert_eq!(talk.asked(line), [format!("e{code},2,77")], "{}: {line}", B::NAME);
    }
    assert_eq!(talk.asked("M2,0,0,1400,-1200"), ["a2,7"], "{}", B::NAME);
}

#[test]
fn a_bend_that_ends_no_farther_than_the_peg_comes_out_or_beyond_the_limit_is_refused() {
    refused::<Avr>();
    refused::<Host>();
}

/// Stopped while it presses wire that it met before zero, it goes back as far as it came, not only to the near side: to the side of
/// the line, whatever the sign of its bend.
fn after_a_stop<B: Board>(bend: i64) {
    let mut talk = Talk::<B>::homed();
    talk.say(&format!("M2,0,0,{bend},-1450"));
    let out = |talk: &mut Talk<B>| {
        let status = talk.status();
        status.peg_out == Some(true) && i64::from(status.position[BEND]) > -1440
    };
    for _ in 0..2000 {
        if out(&mut talk) {
            break;
        }
        talk.wait(5);
    }
    talk.stop();
    talk.wait(1000);
    assert_eq!(talk.status().alarm, Alarm::Stop);
    let stands = i64::from(talk.status().position[BEND]);
    assert!((-1440..-NEAR_SIDE).contains(&stands), "{}: {stands}", B::NAME);
    let zero = pegs_zero(&talk) - stands;
    let from = talk.table.seen.len();
    talk.home(3);
    let (width, at) = pegs(&talk, from)[0];
    let expected = (stands - BACK_OFF).max(-1450);
    assert_eq!((width, at - zero), (IN, expected), "{}: from {stands}", B::NAME);
}

#[test]
fn after_a_stop_the_peg_goes_back_as_far_as_it_came() {
    for bend in [1400, 0, -200] {
        after_a_stop::<Avr>(bend);
        after_a_stop::<Host>(bend);
    }
}
