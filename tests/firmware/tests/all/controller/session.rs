//! Rule 2: a frame of another session is not obeyed.

use wirebend_driver_wirebend_kit::protocol::{Alarm, NO_SESSION, Reset, State};

use crate::controller::talk::{ANSWER_MS, SESSION, Talk};
use wirebend_tests_firmware::board::{Avr, Board, Host};

fn before_one<B: Board>() {
    let mut talk = Talk::<B>::new();
    talk.taken();
    for (payload, letter) in [("M1,100,0,0", 77), ("H1", 72), ("Q", 81), ("K1,1", 75), ("G", 71), ("L", 76)] {
        assert_eq!(
            talk.asked(payload),
            [format!("e10,1,{letter}")],
            "{}: {payload} without a session",
            B::NAME
        );
    }
    talk.say_sealed("M1,100,0,0", SESSION);
    talk.wait(ANSWER_MS);
    assert_eq!(talk.taken(), ["e10,1,0"], "{}: of a session that is none yet", B::NAME);
    for id in ["S0", "S65535", "S65536", "S-1", "S"] {
        assert_eq!(talk.asked(id), ["e2,1,83"], "{}: {id}", B::NAME);
    }
    talk.say_sealed("S77", 77);
    talk.wait(ANSWER_MS);
    assert_eq!(talk.taken(), ["e10,1,0"], "{}: a session frame is sealed with no session", B::NAME);
    assert_eq!(talk.table.pulses(), 0);
}

#[test]
fn without_a_session_nothing_is_obeyed() {
    before_one::<Avr>();
    before_one::<Host>();
}

fn stale<B: Board>() {
    let mut talk = Talk::<B>::homed();
    talk.begin_session(0x4321);
    let pulses = talk.table.pulses();
    for payload in ["M1,100,0,0", "H1", "K1,1", "M2,100,0,0", "W4,100", "L", "G", "Z5"] {
        for seal in [SESSION, NO_SESSION] {
            talk.say_sealed(payload, seal);
            talk.wait(ANSWER_MS);
            assert_eq!(talk.taken(), ["e8,1,0"], "{}: {payload} of another session", B::NAME);
        }
    }
    assert_eq!((talk.table.pulses(), talk.status().last), (pulses, 0));
    talk.reset(Reset::External);
    talk.taken();
    talk.say_sealed("M1,100,0,0", 0x4321);
    talk.wait(ANSWER_MS);
    assert_eq!(talk.taken(), ["e10,1,0"], "{}: of before the reset", B::NAME);
}

#[test]
fn frames_of_another_session_are_not_obeyed() {
    stale::<Avr>();
    stale::<Host>();
}

fn same_again<B: Board>() {
    let mut talk = Talk::<B>::homed();
    talk.say("M2,6000,0,0");
    talk.wait(700);
    // The session that is open, in motion: sent again, and nothing changes.
    assert_eq!(session(&mut talk, SESSION), [format!("o{SESSION},2,1,1,113,1,0")]);
    assert_eq!(session(&mut talk, 5), ["e1,3,83"], "{}: another one only at rest", B::NAME);
    assert!(talk.done(2, 5000));
    assert_eq!(session(&mut talk, SESSION), [format!("o{SESSION},2,2,1,113,1,0")]);
    let at = talk.table.counted;
    talk.begin_session(5);
    let status = talk.status();
    assert_eq!((status.last, status.done, status.homed), (0, 0, true), "{}", B::NAME);
    assert_eq!(status.position[0], i32::try_from(at[0]).unwrap(), "positions count on");
    assert_eq!(talk.table.counted, at);
}

fn session<B: Board>(talk: &mut Talk<B>, id: u16) -> Vec<String> {
    talk.heard.clear();
    talk.say_sealed(&format!("S{id}"), NO_SESSION);
    talk.wait(ANSWER_MS);
    talk.taken()
}

#[test]
fn the_same_session_again_changes_nothing_and_another_only_at_rest() {
    same_again::<Avr>();
    same_again::<Host>();
}

fn keeps_alarm<B: Board>() {
    let mut talk = Talk::<B>::homed();
    talk.stop();
    talk.wait(ANSWER_MS);
    talk.begin_session(9);
    let status = talk.status();
    assert_eq!((status.state, status.alarm), (State::Alarm, Alarm::Stop), "{}", B::NAME);
    assert_eq!(talk.asked("M1,5,0,0"), ["e3,1,77"]);
}

#[test]
fn a_new_session_does_not_clear_an_alarm() {
    keeps_alarm::<Avr>();
    keeps_alarm::<Host>();
}
