//! Rules 6 and 7: a host that is gone, and a controller that hangs.

use wirebend_driver_wirebend_kit::protocol::{Alarm, Reset, State};
use wirebend_tests_firmware::{HZ, Ram, ResetCause, UnoError};

use crate::controller::talk::{ANSWER_MS, Talk};
use wirebend_tests_firmware::board::{Avr, Board, Host, MS, What};

/// Feeds of 2 s each.
const LINES: [&str; 3] = ["M2,12000,0,0", "M3,12000,0,0", "M4,12000,0,0"];

fn host_gone<B: Board>(noise: &[u8]) {
    let mut talk = Talk::<B>::homed();
    let feed = talk.table.counted[0];
    for line in LINES {
        talk.say(line);
    }
    talk.wait(ANSWER_MS);
    talk.taken();
    let told = |talk: &mut Talk<B>| talk.taken().contains(&"x5".to_owned());
    let mut silence_ms = ANSWER_MS;
    while !told(&mut talk) {
        talk.table.board.send(noise);
        talk.wait(10);
        silence_ms += 10;
        assert!(silence_ms < 1100, "{}: not reported", B::NAME);
    }
    assert!(silence_ms >= 1000, "{}: reported after {silence_ms} ms already", B::NAME);
    assert!(talk.table.counted[0] < feed + 12000, "the line continues");
    talk.wait(8000);
    assert_eq!(talk.table.counted[0], feed + 12000, "{}: the running line, and no other", B::NAME);
    assert!(talk.heard.contains(&"d2".to_owned()));
    let status = talk.status();
    assert_eq!(
        (status.state, status.alarm, status.homed),
        (State::Hold, Alarm::HostLost, true),
        "{}",
        B::NAME
    );
    // To be heard again is not enough: the user has to say so.
    talk.wait(500);
    assert_eq!(talk.asked("M5,100,0,0"), ["a5,5"], "{}: lines are taken", B::NAME);
    talk.wait(500);
    assert_eq!(talk.table.counted[0], feed + 12000);
    assert!(talk.asked("G")[0].starts_with("t1,0,"), "{}: runs, and no alarm", B::NAME);
    assert!(talk.done(5, 10_000));
    assert_eq!(talk.table.counted[0], feed + 36_100, "{}", B::NAME);
}

#[test]
fn a_host_that_is_gone_finds_the_running_line_made_and_no_other() {
    host_gone::<Avr>(b"");
    host_gone::<Host>(b"");
}

#[test]
fn what_is_no_valid_frame_keeps_nothing_going() {
    host_gone::<Avr>(b"Q*0000\n");
    host_gone::<Host>(b"Q*0000\n");
}

fn asked_often<B: Board>() {
    let mut talk = Talk::<B>::homed();
    let feed = talk.table.counted[0];
    for line in LINES {
        talk.say(line);
    }
    assert!(talk.done(4, 10_000), "{}", B::NAME); // asks every 250 ms
    assert_eq!(talk.table.counted[0], feed + 36_000);
    talk.wait(3000);
    assert_eq!(talk.status().alarm, Alarm::None, "{}: at rest the host is not missed", B::NAME);
}

#[test]
fn a_host_that_asks_is_not_taken_for_gone() {
    asked_often::<Avr>();
    asked_often::<Host>();
}

/// An interrupt that returns to `rjmp .-2`: the main loop is never reached again. With interrupts on, the step
/// interrupt continues the move; with interrupts off nothing does.
fn hangs(interrupts: bool) {
    let mut talk = Talk::<Avr>::homed();
    talk.say("M2,12000,0,0");
    talk.say("M3,12000,0,0");
    talk.wait(300);
    let feed = talk.table.counted[0];
    // avr-libc ends a program with `_exit: cli` and `__stop_program: rjmp __stop_program`.
    talk.table.board.uno.derail("_exit", if interrupts { 2 } else { 0 }).unwrap();
    let hung = talk.table.board.now();
    let resets = |talk: &Talk<Avr>| talk.table.board.uno.watchdog_resets();
    while resets(&talk) == 0 && talk.table.board.now() < hung + 2 * HZ {
        talk.table.run(MS);
    }
    let after_ms = (talk.table.board.now() - hung) / MS;
    println!(
        "hangs, interrupts {interrupts}: reset after {after_ms} ms, {} steps done",
        talk.table.counted[0] - feed
    );
    assert_eq!(resets(&talk), 1);
    assert!((500..=1100).contains(&after_ms), "reset after {after_ms} ms");
    assert!(talk.table.counted[0] - feed <= 12000, "no other line begins");
    let pulses = talk.table.pulses();
    talk.after_reset();
    let boot = talk.taken();
    assert!(boot[0].starts_with("b1,113,1,3,"), "cause 3 is the watchdog: {boot:?}");
    assert_eq!(talk.table.seen.last().map(|seen| seen.what), Some(What::Motors(false)), "the motors are off");
    talk.begin_session(7);
    let status = talk.status();
    assert_eq!((status.state, status.alarm, status.homed), (State::Alarm, Alarm::Watchdog, false));
    assert_eq!(talk.asked("M1,100,0,0"), ["e3,1,77"]);
    talk.wait(3000);
    assert_eq!(talk.table.pulses(), pulses, "nothing moves by itself");
    talk.home(1);
    assert_eq!(talk.status().alarm, Alarm::None);
}

#[test]
fn a_controller_that_hangs_is_reset_and_stands_still() {
    hangs(true);
    hangs(false);
}

/// Behind the boot loader of an Uno, which has cleared the cause, a hang is still distinguished from the reset button.
#[test]
fn a_hang_is_told_although_the_boot_loader_clears_the_cause() {
    let mut talk = Talk::<Avr>::homed();
    let uno = &mut talk.table.board.uno;
    uno.reset(ResetCause::External, Ram::Kept);
    uno.forget_reset_cause();
    talk.after_reset();
    assert!(talk.taken()[0].starts_with("b1,113,1,1,"), "1 is the reset pin");
    let uno = &mut talk.table.board.uno;
    uno.derail("_exit", 2).unwrap();
    let hung = uno.cycle();
    uno.run_until(hung + HZ).unwrap();
    while uno.watchdog_resets() == 0 && uno.cycle() < hung + 2 * HZ {
        uno.run_for(1).unwrap();
    }
    uno.forget_reset_cause();
    talk.after_reset();
    assert!(talk.taken()[0].starts_with("b1,113,1,3,"), "3 is the watchdog");
    talk.begin_session(7);
    assert_eq!(talk.status().alarm, Alarm::Watchdog);
    // And noise in the RAM is no hang.
    for seed in 0..200 {
        talk.table.board.uno.reset(ResetCause::PowerOn, Ram::Scrambled(seed));
        talk.table.board.uno.forget_reset_cause();
        talk.after_reset();
        let boot = talk.taken();
        assert!(boot[0].starts_with("b1,113,1,1,"), "noise {seed}: {boot:?}");
    }
}

/// Until the watchdog comes, the step interrupt continues; STOP is looked at in an interrupt too.
#[test]
fn stop_ends_the_move_of_a_controller_that_hangs() {
    let mut talk = Talk::<Avr>::homed();
    talk.say("M2,12000,0,0");
    talk.wait(300);
    talk.table.board.uno.derail("_exit", 2).unwrap();
    talk.wait(50);
    let before = talk.table.pulses();
    talk.stop();
    talk.wait(1);
    let stopped = talk.table.pulses();
    talk.wait(500);
    assert!(stopped < before + 10, "{} pulses after the STOP", stopped - before);
    assert_eq!(talk.table.pulses(), stopped);
}

/// Nothing of the firmware takes so long that its watchdog mistakes it for hanging, stored settings included.
#[test]
fn a_controller_that_works_is_not_reset() {
    let mut talk = Talk::<Avr>::homed();
    for _ in 0..20 {
        talk.asked("L");
    }
    talk.wait(10_000);
    assert_eq!(talk.table.board.uno.watchdog_resets(), 0);
}

#[test]
fn there_is_no_returning_to_what_is_not_there() {
    let mut talk = Talk::<Avr>::new();
    assert!(matches!(talk.table.board.uno.derail("nobody", 0), Err(UnoError::NoSymbol { .. })));
    talk.reset(Reset::External);
    assert!(talk.taken()[0].starts_with("b1,113,1,1,"));
}
