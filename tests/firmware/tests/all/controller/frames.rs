//! Rule 1: what is damaged on its way is never obeyed, and is asked for again.

use wirebend_driver_wirebend_kit::protocol::sealed;

use crate::controller::talk::{SESSION, Talk};
use wirebend_tests_firmware::board::{Avr, Board, Host};

/// A damaged line and its answers are over by then, ms.
const OVER_MS: u64 = 6;

/// Sends a frame with bits flipped: none may be taken.
fn not_obeyed<B: Board>(talk: &mut Talk<B>, frame: &[u8], flips: &[usize]) {
    let mut bytes = frame.to_vec();
    for flip in flips {
        bytes[flip / 8] ^= 1 << (flip % 8);
    }
    bytes.push(b'\n'); // the end of the line may be what was damaged
    talk.table.board.send(&bytes);
    talk.wait(OVER_MS);
    let answers = talk.taken();
    let what = || format!("{}, bits {flips:?}: {}", B::NAME, bytes.escape_ascii());
    assert!(!answers.is_empty(), "{}: nothing is said", what());
    assert!(answers.iter().all(|answer| answer == "e8,2,0"), "{}: {answers:?}", what());
}

fn flips<B: Board>(payload: &str, doubles: bool) {
    let mut talk = Talk::<B>::homed();
    let pulses = talk.table.pulses();
    let frame = &sealed(payload, SESSION)[1..];
    let bits = frame.len() * 8;
    for first in 0..bits {
        not_obeyed(&mut talk, frame, &[first]);
        for second in first + 1..if doubles { bits } else { 0 } {
            not_obeyed(&mut talk, frame, &[first, second]);
        }
    }
    let tried = if doubles { bits * (bits + 1) / 2 } else { bits };
    println!("{}: {tried} ways to damage {payload}, none obeyed", B::NAME);
    assert_eq!(talk.table.pulses(), pulses);
    // And as it should be, it is.
    assert_eq!(talk.asked(payload), ["a2,7"]);
}

#[test]
fn no_flip_of_one_bit_of_a_line_is_obeyed() {
    flips::<Avr>("M2,1500,-200,300", false);
    flips::<Host>("M2,1500,-200,300", false);
}

#[test]
fn no_flip_of_two_bits_of_a_short_line_is_obeyed() {
    flips::<Avr>("M2,9,0,0", true);
    flips::<Host>("M2,9,0,0", true);
    flips::<Host>("M2,1500,-200,300", true);
}

/// Bytes that no frame has, lines too long and cut short.
fn no_frames<B: Board>() {
    let mut talk = Talk::<B>::homed();
    let good = &sealed("M2,9,0,0", SESSION)[1..];
    let mut bad: Vec<Vec<u8>> = (1..good.len() - 1).map(|cut| [&good[..cut], b"\n"].concat()).collect();
    bad.extend((0..good.len() - 1).map(|cut| [&good[..cut], &good[cut + 1..]].concat()));
    for byte in (0..=b' ').chain([127, 129, 200, 255]).filter(|&byte| byte != b'\n') {
        bad.push([&[byte], good].concat());
    }
    for length in [47, 48, 60, 61, 62, 300] {
        bad.push([&vec![b'M'; length], good].concat());
    }
    bad.push(good.to_ascii_lowercase());
    for line in bad {
        talk.table.board.send(&line);
        talk.wait(OVER_MS + u64::try_from(line.len()).unwrap() / 10);
        let said = talk.taken();
        assert_eq!(said, ["e8,2,0"], "{}: {}", B::NAME, line.escape_ascii());
    }
    talk.table.board.send(b"\n\n\n");
    talk.wait(OVER_MS);
    assert_eq!(talk.taken(), [""; 0], "empty lines only separate");
    assert_eq!(talk.status().last, 1);
}

#[test]
fn what_is_no_frame_is_asked_for_again() {
    no_frames::<Avr>();
    no_frames::<Host>();
}

/// Frames that are whole, and say what cannot be.
fn refused<B: Board>() {
    let mut talk = Talk::<B>::homed();
    let cases = [
        ("M2,9,0", "e2,2,77"),
        ("M2,9,0,0,0,0", "e2,2,77"),
        ("M0,9,0,0", "e2,2,77"),
        ("M02,9,0,0", "e2,2,77"),
        ("M2,-0,0,0", "e2,2,77"),
        ("M2,09,0,0", "e2,2,77"),
        ("M2,9,0,", "e2,2,77"),
        ("M2,+9,0,0", "e2,2,77"),
        ("M2,2147483648,0,0", "e2,2,77"),
        ("M4294967296,9,0,0", "e2,2,77"),
        ("M4294967295,9,0,0", "e9,2,77"),
        ("K2,2", "e2,2,75"),
        ("K2,-1", "e2,2,75"),
        ("Q1", "e2,2,81"),
        ("H", "e2,2,72"),
        ("X2,9,0,0", "e4,2,88"),
        ("m2,9,0,0", "e4,2,109"),
        ("*", "e4,2,42"),
    ];
    for (payload, answer) in cases {
        assert_eq!(talk.asked(payload), [answer], "{}: {payload}", B::NAME);
    }
    assert_eq!(talk.status().last, 1);
}

#[test]
fn what_cannot_be_is_refused_with_its_reason() {
    refused::<Avr>();
    refused::<Host>();
}

/// More comes than can be looked at, because every question has a long answer: a place is free when an answer has
/// gone out, and what comes before that is lost. What is left of a line is not obeyed, though it reads as a good one.
#[test]
fn what_is_left_of_a_line_that_lost_bytes_is_not_obeyed() {
    let mut talk = Talk::<Host>::homed();
    let frame = &sealed("M2,9,0,0", SESSION)[1..];
    let (head, tail) = frame.split_at(8);
    let questions = sealed("Q", SESSION)[1..].repeat(22);
    let mut lost = 0;
    for separators in 0..60 {
        for digits in 1..30 {
            let separators = vec![b'\n'; separators];
            let bytes = [&questions, &separators, head, &vec![b'7'; digits], tail, b"\n"].concat();
            talk.table.board.send(&bytes);
            talk.wait(150);
            let answers = talk.taken();
            assert!(
                !answers.contains(&"a2,7".to_owned()),
                "{} separators, {digits} digits lost: {answers:?}",
                separators.len()
            );
            lost += usize::from(answers.iter().filter(|answer| answer.starts_with('t')).count() < 22);
        }
    }
    assert!(lost > 0, "nothing was ever lost");
}

/// A framing error in any byte of a frame.
#[test]
fn a_framing_error_poisons_the_line() {
    let mut talk = Talk::<Avr>::homed();
    let frame = &sealed("M2,9,0,0", SESSION)[1..];
    for broken in 0..frame.len() - 1 {
        for (i, &byte) in frame.iter().enumerate() {
            if i == broken {
                talk.table.board.uno.send_broken(byte);
            } else {
                talk.table.board.uno.send(&[byte]);
            }
        }
        talk.wait(OVER_MS);
        assert_eq!(talk.taken(), ["e8,2,0"], "byte {broken}");
    }
}
