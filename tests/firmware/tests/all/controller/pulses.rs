//! The pins, as the motor drivers and the servo see them.

use crate::controller::talk::Talk;
use wirebend_tests_firmware::board::{Avr, HZ, MS, Observation, What};

/// DRV8825, data sheet SLVSA73: a step is high for 1.9 µs or more, a direction stands 650 ns before it. Cycles of
/// 62.5 ns.
const STEP_HIGH: u64 = 31;
const SETUP: u64 = 11;
/// A frame of the servo, 20.48 ms, and its two widths; both to 8 µs.
const FRAME: u64 = 327_680;
const IN: u64 = 1000 * MS / 1000;
const OUT: u64 = 2000 * MS / 1000;
const TOLERANCE: u64 = 8 * MS / 1000;

/// Lines that go to and fro on every axis at full speed, the serial line busy with questions all the time.
fn busy() -> Talk<Avr> {
    let mut talk = Talk::<Avr>::homed();
    for n in (2..=8_u32).step_by(2) {
        talk.say(&format!("M{n},6000,3000,1400"));
        talk.say(&format!("M{},-6000,-3000,-1400", n + 1));
        while !talk.heard.iter().any(|heard| *heard == format!("d{}", n + 1)) {
            talk.heard.clear();
            talk.say("Q");
            talk.wait(5);
        }
    }
    talk
}

#[test]
fn steps_are_long_enough_and_directions_early_enough() {
    let talk = busy();
    let board = &talk.table.board;
    println!("step high for {} cycles at least, direction {} before", board.least_high, board.least_setup);
    assert!(board.least_high >= STEP_HIGH);
    assert!(board.least_setup >= SETUP);
    assert_eq!((board.uno.overruns(), board.uno.lost_sending()), (0, 0), "bytes lost");
}

#[test]
fn the_servo_gets_its_pulse_whatever_else_goes_on() {
    let talk = busy();
    let servo = &talk.table.board.servo;
    let off = |width: u64| width.abs_diff(IN).min(width.abs_diff(OUT));
    let worst = servo.iter().map(|&(_, width)| off(width)).max().unwrap();
    let period = servo.windows(2).map(|pair| (pair[1].0 - pair[0].0).abs_diff(FRAME)).max().unwrap();
    println!("{} pulses of the servo: width {worst} cycles off at most, period {period}", servo.len());
    assert!(servo.len() > 1000);
    assert!(worst <= TOLERANCE && period <= TOLERANCE);
}

/// The peg is commanded at every place of the servo's frame: no pulse is anything but in or out.
#[test]
fn the_servo_is_told_between_two_pulses() {
    let mut talk = Talk::<Avr>::homed();
    for (place, n) in (0..160).zip(2..) {
        talk.say(&format!("K{n},{}", n % 2));
        assert!(talk.done(n, 1000));
        talk.taken();
        // 640 ms and so much more of a frame.
        talk.wait_cycles(HZ / 10 + place * FRAME / 160);
    }
    let servo = &talk.table.board.servo;
    let widths: Vec<u64> = servo.iter().map(|&(_, width)| width).collect();
    let changes = widths.windows(2).filter(|pair| pair[0].abs_diff(pair[1]) > TOLERANCE).count();
    assert!(changes >= 159, "{changes}");
    for (i, width) in widths.iter().enumerate() {
        assert!(
            width.abs_diff(IN) <= TOLERANCE || width.abs_diff(OUT) <= TOLERANCE,
            "pulse {i}: {width} cycles"
        );
    }
    for pair in servo.windows(2) {
        assert!((pair[1].0 - pair[0].0).abs_diff(FRAME) <= 70 * 64, "{pair:?}"); // begins at count 128 or 192
    }
}

/// Every width that the settings take, on its way through the counts of the timer.
#[test]
fn the_servo_gets_every_width() {
    let mut talk = Talk::<Avr>::homed();
    let mut n = 1;
    for width in (512..=2500).step_by(28).chain([515, 519, 767, 771, 1023, 1027, 1535, 1539, 2499]) {
        talk.asked(&format!("W16,{width}"));
        talk.asked("W17,20");
        for out in 0..2 {
            n += 1;
            talk.say(&format!("K{n},{out}"));
            assert!(talk.done(n, 1000));
        }
        talk.table.board.servo.clear();
        talk.wait(100);
        let servo = &talk.table.board.servo;
        assert!(servo.len() >= 4, "{width} us: {servo:?}");
        for &(_, cycles) in &servo[1..] {
            assert!(cycles.abs_diff(width * MS / 1000) <= TOLERANCE, "{width} us: {cycles} cycles");
        }
    }
}

/// The fastest that a setting allows, on every axis, with a full queue and questions: no pulse is late.
#[test]
fn eight_thousand_steps_a_second_are_kept() {
    let mut talk = Talk::<Avr>::homed();
    for id in [4, 5, 6] {
        assert_eq!(talk.asked(&format!("W{id},8000")), [format!("v{id},8000")]);
        assert_eq!(talk.asked(&format!("W{},100000", id + 3)), [format!("v{},100000", id + 3)]);
    }
    talk.home(2);
    let from = talk.table.seen.len();
    for n in 3..=6 {
        talk.say(&format!("M{n},8000,4000,1400"));
    }
    while !talk.heard.contains(&"d6".to_owned()) {
        talk.heard.clear();
        talk.say("Q");
        talk.wait(5);
    }
    let mut worst = 0;
    for axis in 0..3 {
        let at = |seen: &Observation| match seen.what {
            What::Pulse { axis: of, .. } if of == axis => Some(seen.at),
            _ => None,
        };
        let at: Vec<u64> = talk.table.seen[from..].iter().filter_map(at).collect();
        // Most of a move is at full speed: 2000 cycles from step to step.
        let apart: Vec<u64> = at.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let fast = apart.iter().filter(|&&cycles| cycles.abs_diff(2000) < 200).count();
        assert!(fast * 2 > apart.len(), "axis {axis}: {fast} of {}", apart.len());
        let early = apart.iter().map(|&cycles| 2000_u64.saturating_sub(cycles)).max().unwrap();
        worst = worst.max(early);
    }
    println!("8000 steps/s: no interval is more than {worst} cycles of 62.5 ns too short");
    assert!(worst < 200);
}
