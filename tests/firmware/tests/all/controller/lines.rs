//! Rules 3 and 4: each line at most once, in order, and what was taken is not what was done.

use std::time::Duration;

use crate::controller::talk::{ANSWER_MS, Talk};
use wirebend_tests_firmware::board::{Avr, BEND, Board, Host, What};
use wirebend_tests_firmware::job::Job;

fn once<B: Board>() {
    let mut talk = Talk::<B>::homed();
    let feed = talk.table.counted[0];
    for _ in 0..3 {
        talk.say("M2,700,0,0");
    }
    talk.say("M2,900,0,0"); // the same number, another line
    talk.wait(ANSWER_MS);
    // Seven places are free while it waits, and all eight when it is done.
    assert_eq!(talk.taken(), ["a2,7", "a2,8", "a2,8", "a2,8"], "{}", B::NAME);
    assert!(talk.done(2, 5000));
    for old in ["M1,50,0,0", "M2,700,0,0", "K2,1", "H1"] {
        assert_eq!(talk.asked(old), ["a2,8"], "{}: {old} again", B::NAME);
    }
    talk.wait(1000);
    assert_eq!(talk.table.counted[0], feed + 700, "{}: run once", B::NAME);
}

#[test]
fn a_line_that_comes_again_is_not_made_again() {
    once::<Avr>();
    once::<Host>();
}

fn gap<B: Board>() {
    let mut talk = Talk::<B>::homed();
    let pulses = talk.table.pulses();
    assert_eq!(talk.asked("M3,700,0,0"), ["e9,2,77"], "{}", B::NAME);
    assert_eq!(talk.asked("H300"), ["e9,2,72"], "{}", B::NAME);
    assert_eq!((talk.table.pulses(), talk.status().last), (pulses, 1));
}

#[test]
fn a_line_out_of_order_is_refused_with_the_number_that_is_next() {
    gap::<Avr>();
    gap::<Host>();
}

/// The shipped host sends four lines ahead, and no more before it is answered.
#[test]
fn the_host_has_four_lines_on_their_way() {
    let mut job = Job::<Host>::ready();
    for _ in 0..20 {
        job.link.line(b'M', &[100, 0, 0]);
    }
    let mut sent = 0;
    for seconds in 1000..1010 {
        job.link.advance(&[], Duration::from_secs(seconds));
        let bytes = job.link.take_bytes();
        let lines = String::from_utf8(bytes).unwrap().lines().filter(|line| line.starts_with('M')).count();
        assert!(lines <= 4, "{lines} at once");
        sent += lines;
    }
    assert!(sent >= 8, "and repeats them: {sent}");
}

/// While the first runs, eight more wait; none is dropped.
fn full<B: Board>() {
    let mut talk = Talk::<B>::homed();
    let feed = talk.table.counted[0];
    talk.say("M2,9000,0,0");
    talk.wait(ANSWER_MS);
    talk.taken();
    for n in 3..=10_u32 {
        assert_eq!(talk.asked(&format!("M{n},100,0,0")), [format!("a{n},{}", 10 - n)], "{}", B::NAME);
    }
    for _ in 0..2 {
        assert_eq!(talk.asked("M11,100,0,0"), ["f10,0"], "{}", B::NAME);
    }
    assert_eq!(talk.asked("M12,100,0,0"), ["e9,11,77"], "{}", B::NAME);
    assert!(talk.done(10, 10_000));
    assert_eq!(talk.table.counted[0], feed + 9800);
    assert_eq!(talk.asked("M11,100,0,0"), ["a11,7"], "{}: and continues", B::NAME);
}

#[test]
fn a_full_controller_refuses_and_drops_nothing() {
    full::<Avr>();
    full::<Host>();
}

/// A line feeds, turns, bends, and comes back; it is done when all of that is over, and not before.
fn made<B: Board>() {
    let mut talk = Talk::<B>::homed();
    let before = talk.table.counted;
    let from = talk.table.seen.len();
    talk.say("M2,300,-200,1400");
    talk.wait(ANSWER_MS);
    assert_eq!(talk.taken(), ["a2,7"], "{}", B::NAME);
    assert!(talk.done(2, 20_000), "{}", B::NAME);
    let all = talk.table.seen.len();
    talk.wait(1000);
    assert_eq!(talk.table.seen.len(), all, "{}: something moved after it was reported as done", B::NAME);
    let mut order = Vec::new();
    for seen in &talk.table.seen[from..] {
        let what = match seen.what {
            What::Pulse { axis, forward } => format!("{}{axis}", if forward { '+' } else { '-' }),
            What::Servo { width_us } => format!("peg {width_us}"),
            What::Motors(_) | What::Byte(_) => continue,
        };
        if order.last() != Some(&what) {
            order.push(what);
        }
    }
    // To the near side 1089 before zero, the peg out, through zero to 1400, 1193 back, the peg in, and to zero.
    assert_eq!(order, ["+0", "-1", "-2", "peg 2000", "+2", "-2", "peg 1000", "-2"], "{}", B::NAME);
    assert_eq!(talk.table.counted[0], before[0] + 300);
    assert_eq!(talk.table.counted[1], before[1] - 200);
    assert_eq!(talk.table.counted[BEND], before[BEND]);
}

#[test]
fn a_line_is_told_as_made_when_it_is() {
    made::<Avr>();
    made::<Host>();
}
