//! What a controller says when it has started, and what stays of before.

use wirebend_driver_wirebend_kit::protocol::{Alarm, Reset, State};
use wirebend_tests_firmware::{Ram, ResetCause};

use crate::controller::talk::{ANSWER_MS, SESSION, Talk};
use wirebend_tests_firmware::board::{Avr, Board, Host, What};

/// Protocol 1, firmware 1.12, machine 1, the cause, and how often it has started.
fn boot(cause: u8, boots: u32) -> String {
    format!("b1,113,1,{cause},{boots}")
}

fn causes<B: Board>() {
    let mut talk = Talk::<B>::new();
    // An empty memory reads as 65535 starts.
    assert_eq!(talk.taken(), [boot(0, 0)], "{}", B::NAME);
    let causes = [(Reset::External, 1), (Reset::BrownOut, 2), (Reset::Watchdog, 3), (Reset::PowerOn, 0)];
    for (boots, (reset, cause)) in (1..).zip(causes) {
        talk.reset(reset);
        assert_eq!(talk.taken(), [boot(cause, boots)], "{}: {reset:?}", B::NAME);
        talk.begin_session(3);
        let status = talk.status();
        let hung = cause == 3;
        assert_eq!(status.state, if hung { State::Alarm } else { State::Idle }, "{}: {reset:?}", B::NAME);
        assert_eq!(status.alarm, if hung { Alarm::Watchdog } else { Alarm::None });
        assert_eq!((status.homed, status.last, status.peg_out), (false, 0, None));
    }
    for boots in 5..300 {
        talk.reset(Reset::External);
        assert_eq!(talk.taken(), [boot(1, boots)], "{}", B::NAME);
    }
}

#[test]
fn a_start_tells_its_cause_and_is_counted() {
    causes::<Avr>();
    causes::<Host>();
}

/// A supply that rises slowly sets the flag of a brown-out as well as that of power-on.
#[test]
fn a_slow_power_on_is_a_power_on() {
    let mut talk = Talk::<Avr>::new();
    let uno = &mut talk.table.board.uno;
    uno.reset(ResetCause::PowerOn, Ram::Scrambled(3));
    uno.reset(ResetCause::BrownOut, Ram::Kept);
    talk.after_reset();
    assert_eq!(talk.taken(), [boot(0, 1)]);
}

fn in_motion<B: Board>() {
    let mut talk = Talk::<B>::homed();
    for line in ["M2,12000,0,0", "M3,12000,0,0"] {
        talk.say(line);
    }
    talk.wait(500);
    let pulses = talk.table.pulses();
    talk.reset(Reset::External);
    assert!(talk.taken()[0].starts_with("b1,113,1,1,"));
    talk.wait(3000);
    assert_eq!(talk.table.pulses(), pulses, "{}: nothing resumes by itself", B::NAME);
    talk.say_sealed("M4,100,0,0", SESSION);
    talk.wait(ANSWER_MS);
    assert_eq!(talk.taken(), ["e10,1,0"], "{}: nothing of before is obeyed", B::NAME);
    talk.begin_session(SESSION); // the same id, and nothing was taken in it: it is another session
    assert_eq!(talk.asked("M1,100,0,0"), ["e5,1,77"], "{}: it has to be homed", B::NAME);
}

#[test]
fn a_reset_in_motion_forgets_everything() {
    in_motion::<Avr>();
    in_motion::<Host>();
}

/// Pin D8 lets the drivers go until something moves; D11 gives no pulse until the peg was sent somewhere.
#[test]
fn motors_and_peg_are_off_until_a_line_needs_them() {
    let mut talk = Talk::<Avr>::open();
    talk.wait(1000);
    let seen: Vec<_> = talk.table.seen.iter().map(|seen| seen.what).collect();
    assert_eq!(seen, [What::Motors(false)]);
    assert!(talk.table.board.servo.is_empty());
    talk.say("H1");
    talk.wait(1000);
    let seen: Vec<_> = talk.table.seen.iter().map(|seen| seen.what).take(4).collect();
    let pulse = What::Pulse { axis: 2, forward: false };
    assert_eq!(seen, [What::Motors(false), What::Motors(true), What::Servo { width_us: 1000 }, pulse]);
}
