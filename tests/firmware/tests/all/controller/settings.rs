//! Rule 10: settings are kept, checked, and never guessed.

use wirebend_driver_wirebend_kit::protocol::{Reset, SETTINGS, Setting};

use crate::controller::talk::Talk;
use wirebend_tests_firmware::board::{Avr, Board, Host};

/// Where the settings stand in the stored bytes, twice: version, machine, numbers of 4 bytes, checksum.
pub const COPIES: [usize; 2] = [256, 512];
pub const LENGTH: usize = 2 + SETTINGS.len() * 4 + 2;
/// With damaged settings nothing moves, and they are not shown; 72 is H, 77 M, 67 C, 87 W, 75 K, 90 Z.
const DAMAGED: [(&str, &str); 6] = [
    ("H1", "e7,1,72"),
    ("M1,1,0,0", "e7,1,77"),
    ("C1", "e7,1,67"),
    ("W4,100", "e7,1,87"),
    ("K1,1", "e7,1,75"),
    ("Z5", "e7,1,90"),
];

pub fn value<B: Board>(talk: &mut Talk<B>, id: u8) -> i32 {
    let answers = talk.asked(&format!("C{id}"));
    let value = answers[0].strip_prefix(&format!("v{id},")).unwrap_or_else(|| panic!("{id}: {answers:?}"));
    value.parse().unwrap()
}

/// Some of the published machine: 54.44 steps/mm, gears of 18/7 and 26.85, 155 degrees, and the peg's times.
fn compiled_in<B: Board>() {
    let mut talk = Talk::<B>::open();
    for (id, expected) in [(1, 54_440), (2, 16_457), (3, 21_480), (12, 9248), (15, 1000), (16, 2000), (24, 0)]
    {
        assert_eq!(value(&mut talk, id), expected, "{}: setting {id}", B::NAME);
    }
    for Setting { id, min, max, .. } in SETTINGS {
        assert!((min..=max).contains(&value(&mut talk, id)), "{}: setting {id}", B::NAME);
    }
    assert_eq!(talk.asked("C0"), ["e4,1,67"]);
    assert_eq!(talk.asked("C27"), ["e4,1,67"]);
    assert_eq!(talk.asked("C-1"), ["e4,1,67"]);
    assert_eq!(talk.asked("W27,1"), ["e4,1,87"]);
    assert_eq!(talk.asked("W0,1"), ["e4,1,87"]);
}

#[test]
fn the_settings_that_were_compiled_in_can_be_read() {
    compiled_in::<Avr>();
    compiled_in::<Host>();
}

fn ranges<B: Board>() {
    for Setting { id, min, max, .. } in SETTINGS {
        let mut talk = Talk::<B>::open();
        talk.table.board.set_inputs(false, false); // what is said to be wired is looked at
        let before = value(&mut talk, id);
        for beyond in [i64::from(min) - 1, i64::from(max) + 1, i64::from(i32::MAX), -i64::from(i32::MAX)] {
            if !(i64::from(min)..=i64::from(max)).contains(&beyond) {
                assert_eq!(talk.asked(&format!("W{id},{beyond}")), ["e2,1,87"], "{}", B::NAME);
            }
        }
        assert_eq!(value(&mut talk, id), before, "{}: a refused value is not kept", B::NAME);
        // The switch is no nearer than the range of the axis, nor the peg's near side outside of it.
        let (low, high) = match id {
            12 => (1089, 9547),
            13 => (min, 9248),
            18 => (min, -9248),
            21 => (min, 20_000),
            22 => (120, max),
            _ => (min, max),
        };
        for good in [low, high, before] {
            assert_eq!(talk.asked(&format!("W{id},{good}")), [format!("v{id},{good}")], "{}", B::NAME);
        }
        for bad in [low - 1, high + 1] {
            assert_eq!(talk.asked(&format!("W{id},{bad}")), ["e2,1,87"], "{}: {id} = {bad}", B::NAME);
        }
    }
}

#[test]
fn a_setting_takes_what_its_range_has_and_nothing_else() {
    ranges::<Avr>();
    ranges::<Host>();
}

fn kept<B: Board>() {
    let mut talk = Talk::<B>::homed();
    assert_eq!(talk.asked("W4,1234"), ["v4,1234"]);
    assert!(!talk.status().homed, "{}: steps may mean something else", B::NAME);
    for cause in [Reset::External, Reset::PowerOn] {
        talk.reset(cause);
        talk.begin_session(3);
        assert_eq!(value(&mut talk, 4), 1234, "{}", B::NAME);
    }
    assert!(talk.asked("L")[0].starts_with("v1,"));
    assert_eq!(value(&mut talk, 4), 6000, "{}", B::NAME);
    talk.home(1);
    talk.say("M2,12000,0,0");
    talk.wait(300);
    for payload in ["W4,1234", "L"] {
        let answer = format!("e1,3,{}", payload.as_bytes()[0]);
        assert_eq!(talk.asked(payload), [answer], "{}: only at rest", B::NAME);
    }
}

#[test]
fn settings_outlive_a_reset() {
    kept::<Avr>();
    kept::<Host>();
}

fn damaged<B: Board>(bits: &[u8]) {
    let mut talk = Talk::<B>::open();
    let good = talk.table.board.stored();
    for place in 0..LENGTH {
        for bit in bits {
            let mut bytes = good.clone();
            for copy in COPIES {
                bytes[copy + place] ^= 1 << bit;
            }
            talk.table.board.store(&bytes);
            talk.reset(Reset::PowerOn);
            talk.begin_session(3);
            for (payload, answer) in DAMAGED {
                assert_eq!(talk.asked(payload), [answer], "{}: byte {place} bit {bit}", B::NAME);
            }
        }
    }
    assert_eq!(talk.table.pulses(), 0);
    assert!(talk.asked("L")[0].starts_with("v1,"));
    talk.home(1);
}

#[test]
fn damaged_settings_refuse_motion_and_say_so() {
    damaged::<Avr>(&[3]);
    damaged::<Host>(&[0, 1, 2, 3, 4, 5, 6, 7]);
}

/// A controller that was never set up, and one with a whole block of another version or machine.
fn never_set<B: Board>() {
    let mut talk = Talk::<B>::new();
    talk.begin_session(3);
    for (payload, answer) in DAMAGED {
        assert_eq!(talk.asked(payload), [answer], "{}", B::NAME);
    }
    for filling in [0, 0x80, 0xFF] {
        talk.table.board.store(&[filling; 1024]);
        talk.reset(Reset::PowerOn);
        talk.begin_session(3);
        for (payload, answer) in DAMAGED {
            assert_eq!(talk.asked(payload), [answer], "{}: filled with {filling}", B::NAME);
        }
    }
}

#[test]
fn a_controller_that_was_never_set_up_does_not_move() {
    never_set::<Avr>();
    never_set::<Host>();
}
