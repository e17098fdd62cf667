//! Motors that let go at rest: asked for, or after a time.

use wirebend_tests_firmware::board::{Avr, Board, HZ, Host, What};

use crate::controller::talk::Talk;

/// Whether the drivers are on, as the pin says.
fn on<B: Board>(talk: &Talk<B>) -> bool {
    let last = talk.table.seen.iter().rev().find_map(|seen| match seen.what {
        What::Motors(on) => Some(on),
        _ => None,
    });
    last.unwrap_or(false)
}

fn asked<B: Board>() {
    let mut talk = Talk::<B>::homed();
    assert!(on(&talk), "{}", B::NAME);
    talk.say("M2,6000,0,0");
    talk.wait(200);
    assert_eq!(talk.asked("R").last().unwrap(), "e1,3,82", "{}: not while it moves; 82 is R", B::NAME);
    assert!(talk.done(2, 5000) && on(&talk));
    assert!(talk.asked("R")[0].starts_with("t0,0,"), "{}: at rest, no alarm", B::NAME);
    assert!(!on(&talk), "{}", B::NAME);
    assert!(!talk.status().homed, "{}: it is not known where the axes are", B::NAME);
    assert_eq!(talk.asked("M3,100,0,0"), ["e5,3,77"], "{}: it has to be homed", B::NAME);
    talk.home(3);
    assert!(on(&talk) && talk.status().homed);
}

#[test]
fn motors_are_released_when_it_is_asked_for() {
    asked::<Avr>();
    asked::<Host>();
}

fn at_rest<B: Board>() {
    let mut talk = Talk::<B>::homed();
    assert_eq!(talk.asked("W25,3"), ["v25,3"]);
    talk.home(2);
    // A line and a hold are no rest, however long they take.
    talk.say("M3,24000,0,0");
    talk.wait(500);
    talk.asked("P");
    for _ in 0..20 {
        talk.asked("Q");
        talk.wait(250);
    }
    assert!(on(&talk), "{}: in a hold", B::NAME);
    talk.asked("G");
    assert!(talk.done(3, 10_000), "{}: {:?}", B::NAME, talk.heard.last());
    let rest = talk.table.board.now();
    talk.wait(2800);
    assert!(on(&talk) && talk.status().homed, "{}: too soon", B::NAME);
    talk.wait(400);
    assert!(!on(&talk) && !talk.status().homed, "{}", B::NAME);
    let off = talk.table.seen.iter().rev().find(|seen| seen.what == What::Motors(false)).unwrap().at;
    // The end of the line was heard 10 ms late at most, and a tick is 1.024 ms.
    assert!((off - rest).abs_diff(3 * HZ) < HZ / 20, "{}: after {} cycles", B::NAME, off - rest);
    assert_eq!(talk.asked("M4,100,0,0"), ["e5,4,77"], "{}", B::NAME);
}

#[test]
fn motors_are_released_after_their_time_at_rest() {
    at_rest::<Avr>();
    at_rest::<Host>();
}

fn never<B: Board>() {
    let mut talk = Talk::<B>::homed();
    assert_eq!(talk.asked("C25"), ["v25,0"]);
    talk.wait(200_000);
    assert!(on(&talk) && talk.status().homed, "{}", B::NAME);
}

#[test]
fn motors_hold_for_ever_when_no_time_is_set() {
    never::<Avr>();
    never::<Host>();
}
