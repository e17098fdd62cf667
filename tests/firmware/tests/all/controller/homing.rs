//! Rule 8: homing, and switches that are not as they should be.

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use wirebend_driver_wirebend_kit::protocol::{Alarm, State};

use crate::controller::talk::Talk;
use wirebend_tests_firmware::board::{Avr, BEND, Board, HZ, Host, What};
use wirebend_tests_firmware::table::{EDGE, Switch, Table};

/// Two pulses at most from the edge to where it is taken to be: the switch is read four times in a row.
const READINGS: i64 = 4;
/// Settings: the longest homing move 20000 steps, at 600 steps/s; 90 s in all.
const TRAVEL: i64 = 20_000;
const TIME_S: u64 = 90;

struct Search {
    found: bool,
    alarm: Alarm,
    /// Steps that the bend axis made, both ways, and how far it got from where it was.
    steps: i64,
    farthest: i64,
    seconds: u64,
    /// Where the bend axis really stands at the end, from the real zero.
    zero: i64,
}

fn home<B: Board>(from: i64, switch: Switch, settings: &[&str]) -> Search {
    let mut table = Table::<B>::with_switch(switch);
    table.turn_to(from);
    let mut talk = Talk::open_at(table);
    for setting in settings {
        assert_eq!(talk.asked(&format!("W{setting}")), [format!("v{setting}")]);
    }
    talk.say("H1");
    let started = talk.table.board.now();
    let mut ended = started;
    while !talk.heard.iter().any(|heard| heard == "d1" || heard == "x3") {
        talk.say("Q");
        talk.wait(100);
        ended = talk.table.board.now();
        assert!(ended - started < (TIME_S + 5) * HZ, "{}: no end", B::NAME);
    }
    let end = talk.table.seen.len();
    talk.wait(3000);
    assert_eq!(talk.table.seen.len(), end, "{}: it continues after the end", B::NAME);
    let (mut at, mut steps, mut farthest) = (0_i64, 0, 0);
    for seen in &talk.table.seen {
        if let What::Pulse { axis, forward } = seen.what {
            assert_eq!(axis, BEND);
            at += if forward { 1 } else { -1 };
            (steps, farthest) = (steps + 1, farthest.max(at.abs()));
        }
    }
    let status = talk.status();
    let alarmed = status.state == State::Alarm;
    assert_eq!(status.homed, !alarmed);
    if status.homed {
        assert_eq!(status.position[BEND], 0);
    } else {
        assert_eq!(talk.asked("M2,100,0,0").last().unwrap(), "e3,2,77", "{}", B::NAME);
    }
    let seconds = (ended - started) / HZ;
    Search { found: status.homed, alarm: status.alarm, steps, farthest, seconds, zero: talk.table.bend }
}

fn finds<B: Board>(from: i64, switch: Switch, play: i64) {
    let homed = home::<B>(from, switch, &[]);
    println!(
        "{}: homed from {from} in {} s, zero off by {} steps of 0.017 degrees",
        B::NAME,
        homed.seconds,
        homed.zero
    );
    assert!(homed.found, "{} from {from}: {:?}", B::NAME, homed.alarm);
    assert!(homed.zero.abs() <= READINGS + play, "{}: zero is at {}", B::NAME, homed.zero);
}

fn good() -> Switch {
    Box::new(|bend| bend <= EDGE)
}

#[test]
fn homing_finds_zero_from_anywhere() {
    // From the far end, beside the switch, at its edge, and pressed by fifteen degrees.
    for from in [9000, 0, EDGE + 1, EDGE, EDGE - 3, EDGE - 900] {
        finds::<Host>(from, good(), 0);
    }
    finds::<Avr>(0, good(), 0);
    finds::<Avr>(EDGE - 900, good(), 0);
}

/// A contact that bounces: around its edge it reads as chance has it.
fn bouncing(seed: u64, play: i64) -> Switch {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    Box::new(move |bend| if (bend - EDGE).abs() <= play { random.random() } else { bend <= EDGE })
}

/// Motors make noise on the wire of the switch: each reading is wrong once in so many.
fn noisy(seed: u64, one_in: u32) -> Switch {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    Box::new(move |bend| (bend <= EDGE) != random.random_ratio(1, one_in))
}

#[test]
fn homing_bears_a_switch_that_bounces_and_noise() {
    for seed in 0..20 {
        finds::<Host>(-3000, bouncing(seed, 10), 10);
        finds::<Host>(-3000, noisy(seed, 50), 8);
    }
    finds::<Avr>(-3000, bouncing(0, 10), 10);
    finds::<Avr>(-3000, noisy(1, 50), 8);
}

fn fails<B: Board>(what: &str, from: i64, switch: Switch, farthest: i64, settings: &[&str]) -> Search {
    let homed = home::<B>(from, switch, settings);
    println!("{}: {what}: fails after {} steps and {} s", B::NAME, homed.steps, homed.seconds);
    assert_eq!((homed.found, homed.alarm), (false, Alarm::Homing), "{}: {what}", B::NAME);
    assert!(homed.farthest <= farthest, "{}: {what}: {} steps away", B::NAME, homed.farthest);
    assert!(homed.seconds <= TIME_S + 2, "{}: {what}", B::NAME);
    homed
}

#[test]
fn a_switch_that_is_never_pressed_ends_the_search() {
    fails::<Avr>("stuck open", 0, Box::new(|_| false), TRAVEL, &[]);
    fails::<Host>("stuck open", 0, Box::new(|_| false), TRAVEL, &[]);
}

/// The wire of the switch is broken, which reads as pressed: the axis must not run around to the other side.
#[test]
fn a_broken_wire_ends_the_search_soon() {
    // Ten times the way back from the switch, which is 2 degrees.
    fails::<Avr>("stuck pressed", 0, Box::new(|_| true), 1200, &[]);
    fails::<Host>("stuck pressed", 0, Box::new(|_| true), 1200, &[]);
}

/// It is pressed when it is met, and stays so.
#[test]
fn a_switch_that_sticks_ends_the_search() {
    fn sticking() -> Switch {
        let mut stuck = false;
        Box::new(move |bend| {
            stuck |= bend <= EDGE;
            stuck
        })
    }
    fails::<Avr>("sticks", EDGE + 500, sticking(), TRAVEL, &[]);
    fails::<Host>("sticks", EDGE + 500, sticking(), TRAVEL, &[]);
}

/// The second homing move goes twice the way back at most.
#[test]
fn a_switch_that_is_found_once_only_ends_the_search() {
    fn once() -> Switch {
        let (mut found, mut left) = (false, false);
        Box::new(move |bend| {
            found |= bend <= EDGE;
            left |= found && bend > EDGE;
            bend <= EDGE && !left
        })
    }
    let homed = fails::<Host>("found once", EDGE + 500, once(), TRAVEL, &[]);
    assert!(homed.steps < 500 + 20 + 120 + 240, "{} steps", homed.steps);
    fails::<Avr>("found once", EDGE + 500, once(), TRAVEL, &[]);
}

#[test]
fn homing_takes_no_longer_than_its_time() {
    for seconds in [2, 10] {
        let time = format!("23,{}", seconds * 1000);
        let homed = fails::<Avr>("too slow", 0, good(), TRAVEL, &[&time]);
        assert!(homed.seconds <= seconds, "{} s", homed.seconds);
        fails::<Host>("too slow", 0, good(), TRAVEL, &[&time]);
    }
}

/// A person pauses while it homes, has a look, and resumes: that time is not counted.
fn paused<B: Board>() {
    let mut talk = Talk::<B>::open();
    assert_eq!(talk.asked("W23,30000"), ["v23,30000"]);
    talk.say("H1");
    talk.wait(3000);
    talk.asked("P");
    for _ in 0..100 {
        talk.asked("Q");
        talk.wait(500);
    }
    let held = talk.table.pulses();
    talk.wait(500);
    assert_eq!(talk.table.pulses(), held, "{}", B::NAME);
    talk.asked("G");
    assert!(talk.done(1, 40_000), "{}: {:?}", B::NAME, talk.heard.last());
    assert!(talk.status().homed);
}

#[test]
fn a_pause_does_not_count_as_time_of_homing() {
    paused::<Avr>();
    paused::<Host>();
}

/// In a bend the axis meets its switch, which is not where it should be, or its wire breaks.
fn limit_hit<B: Board>() {
    let mut talk = Talk::<B>::homed();
    talk.say("M2,0,0,-1400");
    let mut waited = 0;
    while talk.status().peg_out != Some(true) || waited < 1500 {
        talk.wait(100);
        waited += 100;
    }
    talk.wait(1000);
    let from = talk.table.bend;
    talk.table.set_switch(Box::new(|_| true));
    talk.wait(1000);
    assert!(talk.heard.contains(&"x2".to_owned()), "{}: {:?}", B::NAME, talk.heard);
    assert!((talk.table.bend - from).abs() <= READINGS, "{}: {} steps", B::NAME, talk.table.bend - from);
    let status = talk.status();
    assert_eq!((status.state, status.alarm, status.homed), (State::Alarm, Alarm::Limit, false));
    let pulses = talk.table.pulses();
    assert_eq!(talk.asked("M3,100,0,0"), ["e3,3,77"]);
    talk.wait(2000);
    assert_eq!(talk.table.pulses(), pulses, "{}", B::NAME);
}

#[test]
fn the_switch_in_a_bend_stops_everything() {
    limit_hit::<Avr>();
    limit_hit::<Host>();
}
