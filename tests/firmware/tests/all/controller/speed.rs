//! How fast lines are: a share of their speed from the next move on, and all of it again in a new session.

use wirebend_tests_firmware::board::{Avr, Board, HZ, Host, MS, What};

use crate::controller::talk::{SESSION, Talk};

const FEED: usize = 0;
/// The setting of its speed.
const FEED_RATE: u64 = 4;

/// The speed at which most of the feed's pulses come, percent of its setting.
fn percent_of<B: Board>(talk: &Talk<B>, from: usize, rate: u64) -> u64 {
    let pulses = talk.table.seen[from..].iter().filter_map(|seen| match seen.what {
        What::Pulse { axis: FEED, .. } => Some(seen.at),
        _ => None,
    });
    let pulses: Vec<u64> = pulses.collect();
    let mut apart: Vec<u64> = pulses.windows(2).map(|pair| pair[1] - pair[0]).collect();
    apart.sort_unstable();
    (100 * HZ + rate * apart[apart.len() / 2] / 2) / (rate * apart[apart.len() / 2])
}

fn slower<B: Board>() {
    let mut talk = Talk::<B>::homed();
    let rate: u64 = talk.asked(&format!("C{FEED_RATE}"))[0][3..].parse().unwrap();
    let feed = |talk: &mut Talk<B>, letter, n| {
        let from = talk.table.seen.len();
        talk.say(&format!("{letter}{n},4000,0,0"));
        assert!(talk.done(n, 60_000), "{}", B::NAME);
        percent_of(talk, from, rate)
    };
    assert_eq!(feed(&mut talk, 'M', 2), 100, "{}", B::NAME);
    for (n, percent) in [(3, 50), (4, 10), (5, 100), (6, 30)] {
        assert_eq!(talk.asked(&format!("U{percent}")), [format!("i{percent}")], "{}", B::NAME);
        assert_eq!(feed(&mut talk, 'M', n), percent, "{}", B::NAME);
    }
    for asked in ["U", "U0"] {
        assert_eq!(talk.asked(asked), ["i30"], "{}: {asked}", B::NAME);
    }
    // A quarter of that in a dry run.
    let dry = feed(&mut talk, 'Y', 7);
    assert!((7..=8).contains(&dry), "{}: {dry} %", B::NAME);
    for refused in ["U9", "U101", "U-50", "U50,1"] {
        assert_eq!(talk.asked(refused), ["e2,8,85"], "{}: {refused}", B::NAME);
    }
    // The same session once more changes nothing; a new one begins with full speed.
    talk.say_sealed(&format!("S{SESSION}"), 0xFFFF);
    talk.wait(100);
    talk.heard.clear();
    assert_eq!(feed(&mut talk, 'M', 8), 30, "{}", B::NAME);
    talk.begin_session(SESSION + 1);
    assert_eq!(feed(&mut talk, 'M', 1), 100, "{}", B::NAME);
}

/// What is under way keeps its speed, held and resumed too: a person who wants it slower at once presses pause.
fn a_move_under_way<B: Board>() {
    let mut talk = Talk::<B>::homed();
    let rate: u64 = talk.asked(&format!("C{FEED_RATE}"))[0][3..].parse().unwrap();
    let from = talk.table.seen.len();
    talk.say("M2,20000,0,0");
    talk.wait(300);
    talk.asked("U20");
    talk.say("P");
    talk.wait(1000);
    talk.say("G");
    assert!(talk.done(2, 60_000), "{}", B::NAME);
    assert_eq!(percent_of(&talk, from, rate), 100, "{}", B::NAME);
}

#[test]
fn a_move_under_way_keeps_its_speed() {
    a_move_under_way::<Avr>();
    a_move_under_way::<Host>();
}

#[test]
fn lines_have_the_speed_that_is_asked_for() {
    slower::<Avr>();
    slower::<Host>();
}

/// Homing has speeds of its own, which bring it to its switch.
fn homing<B: Board>() {
    let time = |percent: Option<u32>| {
        let mut talk = Talk::<B>::homed();
        if let Some(percent) = percent {
            talk.asked(&format!("U{percent}"));
        }
        let begun = talk.table.board.now();
        talk.home(2);
        (talk.table.board.now() - begun) / MS
    };
    let (full, slow) = (time(None), time(Some(10)));
    assert!(slow.abs_diff(full) <= 5, "{}: {full} ms, {slow} ms", B::NAME);
}

#[test]
fn homing_is_as_fast_as_ever() {
    homing::<Avr>();
    homing::<Host>();
}
