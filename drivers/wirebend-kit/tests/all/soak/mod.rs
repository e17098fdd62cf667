//! The shipped link against the real core of the firmware, over lines that damage what goes through them.

mod rig;

use std::time::Duration;

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rig::{Noise, Rig};
use wirebend_driver_wirebend_kit::link::{MachineEvent, Request};
use wirebend_driver_wirebend_kit::protocol::{Alarm, STOP, State, Status, sealed};

const SEEDS: u64 = 40;
const MOVES: u32 = 60;

/// How a run ended.
enum End {
    Made,
    /// A damaged byte happened to be a STOP.
    Stopped,
}

fn status(rig: &Rig) -> Option<Status> {
    rig.events
        .iter()
        .rev()
        .find_map(|event| if let MachineEvent::Status(status) = event { Some(*status) } else { None })
}

fn is_open(events: &[MachineEvent]) -> bool {
    events.iter().any(|event| matches!(event, MachineEvent::Open { .. }))
}

fn is_stopped(events: &[MachineEvent]) -> bool {
    events.iter().any(|event| matches!(event, MachineEvent::Alarm(alarm) if *alarm != Alarm::HostLost))
}

/// Opens a session, stores the settings that were compiled in, and homes.
fn ready(rig: &mut Rig) -> Result<(), End> {
    assert!(rig.until(Duration::from_secs(20), is_open), "no session");
    rig.link.request(Request::LoadDefaults);
    rig.link.request(Request::Read(1));
    assert!(
        rig.until(Duration::from_secs(20), |events| events
            .contains(&MachineEvent::Answered(Request::Read(1)))
            || is_stopped(events))
    );
    rig.link.line(b'H', &[]);
    assert!(
        rig.until(Duration::from_secs(200), |events| events.contains(&MachineEvent::Done(1))
            || is_stopped(events)),
        "{:?}",
        rig.events.iter().rev().take(5).collect::<Vec<_>>()
    );
    if is_stopped(&rig.events) { Err(End::Stopped) } else { Ok(()) }
}

/// Sixty moves; what the pins have done is what was asked, and what is reported.
fn soak(seed: u64, percent: f64) -> End {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let mut rig = Rig::new(random.random_range(1..0xFFFF), Noise::new(seed, percent));
    let end = run(&mut rig, &mut random).unwrap_or_else(|end| end);
    // A status that was sent after everything stood.
    rig.events.clear();
    let rest = |events: &[MachineEvent]| {
        events.iter().filter(|event| matches!(event, MachineEvent::Status(_))).count() > 2
    };
    assert!(rig.until(Duration::from_mins(1), rest), "no status after the run");
    let told = status(&rig).unwrap();
    match end {
        // It may have heard nothing for a second while it ran the last line.
        End::Made => assert!(matches!(told.state, State::Idle | State::Hold), "{told:?}"),
        End::Stopped => assert_eq!(told.state, State::Alarm),
    }
    let [feed, rotate, bend] = told.position.map(i64::from);
    assert_eq!(
        [feed, rotate],
        [rig.counted[0], rig.counted[1]],
        "seed {seed}, {percent} %: told and counted"
    );
    if told.homed {
        assert_eq!(bend, 0, "the bend axis comes back after every line");
    }
    end
}

fn run(rig: &mut Rig, random: &mut ChaCha8Rng) -> Result<End, End> {
    ready(rig)?;
    let home = rig.counted;
    let mut asked = [0_i64; 2];
    for _ in 0..MOVES {
        let feed = random.random_range(-400..2000);
        let rotate = random.random_range(-200..200);
        // A quarter of the moves: the peg takes its time.
        let bend = if random.random_bool(0.25) { random.random_range(-600..600) } else { 0 };
        rig.link.line(b'M', &[feed, rotate, bend]);
        asked = [asked[0] + i64::from(feed), asked[1] + i64::from(rotate)];
    }
    let last = MOVES + 1;
    let over = |events: &[MachineEvent]| events.contains(&MachineEvent::Done(last)) || is_stopped(events);
    let held = |events: &[MachineEvent]| matches!(events.last(), Some(MachineEvent::Status(status)) if status.state == State::Hold);
    while !over(&rig.events) {
        assert!(
            rig.until(Duration::from_mins(10), |events| over(events) || held(events)),
            "not made: {:?}",
            rig.link.progress()
        );
        // It has heard nothing for a second; a person is there, and says so.
        if held(&rig.events) && rig.link.is_answered() {
            rig.link.request(Request::Resume);
        }
        rig.slice();
    }
    if is_stopped(&rig.events) {
        return Ok(End::Stopped);
    }
    let made = [rig.counted[0] - home[0], rig.counted[1] - home[1], rig.counted[2] - home[2]];
    assert_eq!(made, [asked[0], asked[1], 0], "net position");
    Ok(End::Made)
}

/// So many percent of the bytes are damaged, each way. How many runs are made; the others were stopped by a
/// damaged byte that happened to be a STOP.
fn made(percent: f64) -> usize {
    let ends: Vec<End> = (0..SEEDS).map(|seed| soak(seed, percent)).collect();
    let made = ends.iter().filter(|end| matches!(end, End::Made)).count();
    println!("{percent} %: {made} of {SEEDS} runs of {MOVES} moves finished, the others stopped");
    made
}

#[test]
fn a_clean_line_makes_every_move() {
    assert_eq!(made(0.0), 40);
}

#[test]
fn no_line_is_lost_or_made_twice_when_a_byte_in_two_thousand_is_damaged() {
    assert!(made(0.05) > 0);
}

#[test]
fn no_line_is_lost_or_made_twice_when_a_byte_in_two_hundred_is_damaged() {
    assert!(made(0.5) > 0);
}

#[test]
fn no_line_is_lost_or_made_twice_when_a_byte_in_fifty_is_damaged() {
    assert!(made(2.0) > 0);
}

/// The main loop of a controller may be busy while a line and, after it, a STOP come in. The line must not
/// bring the machine out of the alarm that the STOP raises.
#[test]
fn a_line_that_came_before_a_stop_does_not_outlive_it() {
    let mut rig = Rig::new(77, Noise::new(0, 0.0));
    assert!(ready(&mut rig).is_ok());
    let before = rig.counted;
    for payload in ["H2", "M2,5000,0,0"] {
        let mut bytes = sealed(payload, 77);
        bytes.push(STOP);
        rig.controller.send_unseen(&bytes);
        rig.events.clear();
        rig.until(Duration::from_secs(3), |_| false);
        assert_eq!(rig.counted, before, "{payload} moved something after a STOP");
        assert_eq!(status(&rig).unwrap().state, State::Alarm);
    }
}

/// A person takes their time with a question, and the program does not look at the machine meanwhile.
#[test]
fn a_controller_that_nobody_listened_to_for_a_while_is_not_gone() {
    let mut rig = Rig::new(78, Noise::new(0, 0.0));
    assert!(ready(&mut rig).is_ok());
    for away in [1, 3, 60, 3600] {
        rig.events.clear();
        rig.away(Duration::from_secs(away));
        let stands =
            |events: &[MachineEvent]| events.iter().any(|event| matches!(event, MachineEvent::Status(_)));
        assert!(rig.until(Duration::from_secs(2), stands), "no answer after {away} s");
        assert!(!rig.events.contains(&MachineEvent::Silent), "after {away} s");
    }
}
