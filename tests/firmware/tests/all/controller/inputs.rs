//! Inputs besides the serial line: a door or feed hold, the sense of the emergency stop, and the limit switch.

use wirebend_driver_wirebend_kit::protocol::{Alarm, State};
use wirebend_tests_firmware::board::{Avr, Board, Host, MS, What};

use crate::controller::talk::Talk;

/// With both inputs wired, homed by line 2.
fn wired<B: Board>() -> Talk<B> {
    let mut talk = Talk::<B>::homed();
    talk.table.board.set_inputs(false, false);
    assert_eq!(talk.asked("W26,3"), ["v26,3"]);
    talk.home(2);
    talk
}

fn last_pulse<B: Board>(talk: &Talk<B>) -> u64 {
    talk.table.seen.iter().rev().find(|seen| matches!(seen.what, What::Pulse { .. })).unwrap().at
}

/// Waits while the host asks, as a host does.
fn wait<B: Board>(talk: &mut Talk<B>, ms: u64) {
    for _ in 0..ms / 100 {
        talk.say("Q");
        talk.wait(100);
    }
}

fn hold<B: Board>() {
    let mut talk = wired::<B>();
    let feed = talk.table.counted[0];
    talk.say("M3,12000,0,0");
    wait(&mut talk, 500);
    // A disturbance of less than 4 ms is none.
    talk.table.board.set_inputs(true, false);
    talk.wait(2);
    talk.table.board.set_inputs(false, false);
    wait(&mut talk, 200);
    assert_eq!(talk.status().state, State::Run, "{}", B::NAME);
    talk.table.board.set_inputs(true, false);
    let opened = talk.table.board.now();
    wait(&mut talk, 1000);
    assert!(talk.heard.contains(&"x8".to_owned()), "{}: {:?}", B::NAME, talk.heard);
    // From 6000 steps/s with 30000 steps/s² it stands within 200 ms.
    assert!(last_pulse(&talk) < opened + 220 * MS, "{}", B::NAME);
    let status = talk.status();
    assert_eq!(
        (status.state, status.alarm, status.homed),
        (State::Hold, Alarm::HoldInput, true),
        "{}",
        B::NAME
    );
    assert_eq!(talk.asked("G").last().unwrap(), "e11,4,71", "{}: it is open; 71 is G", B::NAME);
    talk.table.board.set_inputs(false, false);
    let held = talk.table.pulses();
    wait(&mut talk, 1000);
    assert_eq!(talk.table.pulses(), held, "{}: closing it is not enough", B::NAME);
    talk.asked("G");
    assert!(talk.done(3, 10_000), "{}: {:?}", B::NAME, talk.heard.last());
    assert_eq!(talk.table.counted[0], feed + 12_000, "{}: no step lost or done twice", B::NAME);
}

#[test]
fn an_open_door_holds_and_is_left_by_a_person() {
    hold::<Avr>();
    hold::<Host>();
}

/// With the door open nothing begins; closed again at rest, nothing has to be said.
fn open_at_rest<B: Board>() {
    let mut talk = wired::<B>();
    talk.table.board.set_inputs(true, false);
    talk.wait(50);
    let pulses = talk.table.pulses();
    assert_eq!(talk.asked("M3,100,0,0").last().unwrap(), "e11,3,77", "{}", B::NAME);
    assert_eq!(talk.asked("H3").last().unwrap(), "e11,3,72", "{}", B::NAME);
    wait(&mut talk, 1000);
    assert_eq!(talk.table.pulses(), pulses, "{}", B::NAME);
    talk.table.board.set_inputs(false, false);
    talk.wait(50);
    assert_eq!(talk.status().state, State::Idle, "{}", B::NAME);
    talk.heard.clear();
    talk.say("M3,100,0,0");
    assert!(talk.done(3, 2000), "{}", B::NAME);
}

#[test]
fn with_an_open_door_nothing_begins() {
    open_at_rest::<Avr>();
    open_at_rest::<Host>();
}

fn emergency<B: Board>() {
    let mut talk = wired::<B>();
    talk.say("M3,12000,0,0");
    talk.say("M4,100,0,0");
    wait(&mut talk, 500);
    talk.table.board.set_inputs(false, true);
    let pressed = talk.table.board.now();
    wait(&mut talk, 1000);
    // Four readings, one each 1.024 ms.
    assert!(last_pulse(&talk) < pressed + 6 * MS, "{}", B::NAME);
    assert!(talk.heard.contains(&"x7".to_owned()), "{}: {:?}", B::NAME, talk.heard);
    assert!(!talk.heard.iter().any(|heard| heard.starts_with('d')), "{}: {:?}", B::NAME, talk.heard);
    let status = talk.status();
    assert_eq!(
        (status.state, status.alarm, status.homed),
        (State::Alarm, Alarm::Emergency, false),
        "{}",
        B::NAME
    );
    assert_eq!(status.done, 2, "{}: neither line is run", B::NAME);
    assert_eq!(talk.asked("H5").last().unwrap(), "e12,5,72", "{}: while it is pressed", B::NAME);
    // STOP is answered all the same.
    talk.heard.clear();
    talk.stop();
    talk.wait(50);
    assert_eq!(talk.taken(), ["x1"], "{}", B::NAME);
    let pulses = talk.table.pulses();
    talk.table.board.set_inputs(false, false);
    wait(&mut talk, 1000);
    assert_eq!(talk.table.pulses(), pulses, "{}: releasing it moves nothing", B::NAME);
    assert_eq!(talk.asked("M5,100,0,0").last().unwrap(), "e3,5,77", "{}", B::NAME);
    talk.home(5);
    assert!(talk.status().homed);
}

#[test]
fn after_an_emergency_stop_no_step_counts_as_made() {
    emergency::<Avr>();
    emergency::<Host>();
}

/// Its power goes in the last milliseconds of a line: it is not known whether the last steps were done.
fn at_the_end<B: Board>() {
    let line = |talk: &mut Talk<B>| {
        talk.heard.clear();
        talk.say("M3,1500,0,0");
        talk.table.board.now()
    };
    let mut whole = wired::<B>();
    let begun = line(&mut whole);
    whole.wait(1000);
    assert!(whole.heard.contains(&"d3".to_owned()));
    let length = last_pulse(&whole) - begun;
    for before in [0, 1, 2, 3, 5, 8] {
        let mut talk = wired::<B>();
        let begun = line(&mut talk);
        talk.table.run_until(begun + length - before * MS - MS / 4);
        talk.table.board.set_inputs(false, true);
        talk.wait(500);
        assert!(talk.heard.contains(&"x7".to_owned()), "{}: {:?}", B::NAME, talk.heard);
        assert!(!talk.heard.contains(&"d3".to_owned()), "{}, {before} ms before its end", B::NAME);
        assert_eq!(talk.status().done, 2, "{}, {before} ms before its end", B::NAME);
    }
}

#[test]
fn an_emergency_stop_at_the_end_of_a_line_leaves_it_in_doubt() {
    at_the_end::<Avr>();
    at_the_end::<Host>();
}

/// The motors lost their power for a moment: that is an alarm, whatever the main loop was doing then.
#[test]
fn an_emergency_stop_is_no_shorter_for_a_busy_main_loop() {
    for open in [4, 5, 6, 8, 12] {
        for busy in [0, 3, 7, 14] {
            let mut talk = wired::<Host>();
            talk.say("M3,12000,0,0");
            wait(&mut talk, 500);
            talk.table.board.keep_busy(busy * MS);
            talk.table.board.set_inputs(false, true);
            // The first reading is up to 1.024 ms away.
            talk.table.run_until(talk.table.board.now() + open * MS + MS / 5);
            talk.table.board.set_inputs(false, false);
            wait(&mut talk, 200);
            let alarm = talk.heard.contains(&"x7".to_owned());
            let status = talk.status();
            let is = (status.state, status.alarm, status.homed);
            let expected =
                if alarm { (State::Alarm, Alarm::Emergency, false) } else { (State::Run, Alarm::None, true) };
            assert_eq!(is, expected, "open for {open} ms, busy for {busy} ms: {:?}", talk.heard);
            assert!(alarm || open < 5, "open for {open} ms, busy for {busy} ms: no alarm");
            let pulses = talk.table.pulses();
            wait(&mut talk, 200);
            assert_eq!(talk.table.pulses() == pulses, alarm, "open for {open} ms, busy for {busy} ms");
        }
    }
}

fn not_wired<B: Board>() {
    let mut talk = Talk::<B>::homed();
    talk.table.board.set_inputs(true, true);
    talk.say("M2,1500,0,0");
    assert!(talk.done(2, 5000), "{}: {:?}", B::NAME, talk.heard.last());
    assert_eq!(talk.status().alarm, Alarm::None);
}

#[test]
fn inputs_that_are_not_wired_are_not_looked_at() {
    not_wired::<Avr>();
    not_wired::<Host>();
}

/// The switch is pressed, or its wire breaks, while another axis moves; a disturbance of a millisecond is none.
fn limit<B: Board>() {
    for (line, axis) in [("M2,12000,0,0", 0), ("M2,0,9000,0", 1)] {
        let mut talk = Talk::<B>::homed();
        talk.say(line);
        wait(&mut talk, 500);
        talk.table.set_switch(Box::new(|_| true));
        talk.wait(1);
        talk.table.set_switch(Box::new(|_| false));
        wait(&mut talk, 300);
        assert_eq!(talk.status().state, State::Run, "{}: {line}", B::NAME);
        let from = talk.table.counted[axis];
        talk.table.set_switch(Box::new(|_| true));
        talk.wait(200);
        // Sixteen readings, one a step, and what was on its way.
        let ran = talk.table.counted[axis] - from;
        assert!(ran <= 17, "{}: {line}: {ran} steps", B::NAME);
        assert!(talk.heard.contains(&"x2".to_owned()), "{}: {line}: {:?}", B::NAME, talk.heard);
        let status = talk.status();
        assert_eq!((status.alarm, status.homed, status.done), (Alarm::Limit, false, 1), "{}", B::NAME);
    }
}

#[test]
fn the_switch_ends_the_move_of_every_axis() {
    limit::<Avr>();
    limit::<Host>();
}

/// On the way back from a bend to the far side, which leads away from the switch, it is watched as well.
fn limit_on_the_way_back<B: Board>() {
    let mut talk = Talk::<B>::homed();
    talk.say("M2,0,0,-1400");
    // The peg is out in the bend and goes in at its end.
    let mut out = false;
    for _ in 0..400 {
        let now = talk.status().peg_out == Some(true);
        if out && !now {
            break;
        }
        out |= now;
    }
    assert!(out, "{}: it does not bend", B::NAME);
    talk.wait(600); // the peg
    talk.table.set_switch(Box::new(|_| true));
    let from = talk.table.bend;
    talk.wait(500);
    assert!(talk.heard.contains(&"x2".to_owned()), "{}: {:?}", B::NAME, talk.heard);
    assert!((talk.table.bend - from).abs() <= 5, "{}: {} steps", B::NAME, talk.table.bend - from);
}

#[test]
fn the_switch_ends_a_move_away_from_it() {
    limit_on_the_way_back::<Avr>();
    limit_on_the_way_back::<Host>();
}
