//! The shipped link against the real core of the firmware, over lines that damage what goes through them.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)] // a test may stop at what cannot be
#![allow(clippy::print_stdout)] // figures for whoever asks with --nocapture

mod rig;

use std::time::Duration;

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rig::{Noise, Rig};
use wirebend_driver_wirebend_kit::link::{Ask, News};
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
    rig.news.iter().rev().find_map(|news| if let News::Status(status) = news { Some(*status) } else { None })
}

fn is_open(news: &[News]) -> bool {
    news.iter().any(|news| matches!(news, News::Open { .. }))
}

fn is_stopped(news: &[News]) -> bool {
    news.iter().any(|news| matches!(news, News::Alarm(alarm) if *alarm != Alarm::HostLost))
}

/// Opens a session, stores the settings that were compiled in, and homes.
fn ready(rig: &mut Rig) -> Result<(), End> {
    assert!(rig.until(Duration::from_secs(20), is_open), "no session");
    rig.link.ask(Ask::LoadDefaults);
    rig.link.ask(Ask::Read(1));
    assert!(rig.until(Duration::from_secs(20), |news| news.contains(&News::Answered(Ask::Read(1)))
        || is_stopped(news)));
    rig.link.line(b'H', &[]);
    assert!(
        rig.until(Duration::from_secs(200), |news| news.contains(&News::Done(1)) || is_stopped(news)),
        "{:?}",
        rig.news.iter().rev().take(5).collect::<Vec<_>>()
    );
    if is_stopped(&rig.news) { Err(End::Stopped) } else { Ok(()) }
}

/// Sixty moves; what the pins have made is what was asked, and what is reported.
fn soak(seed: u64, percent: f64) -> End {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let mut rig = Rig::new(random.random_range(1..0xFFFF), Noise::new(seed, percent));
    let end = run(&mut rig, &mut random).unwrap_or_else(|end| end);
    // A status that was sent after everything stood.
    rig.news.clear();
    let rest = |news: &[News]| news.iter().filter(|news| matches!(news, News::Status(_))).count() > 2;
    assert!(rig.until(Duration::from_mins(1), rest), "no status after the run");
    let told = status(&rig).unwrap();
    match end {
        // It may have heard nothing for a second while it made the last line.
        End::Made => assert!(matches!(told.state, State::Idle | State::Held), "{told:?}"),
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
    let over = |news: &[News]| news.contains(&News::Done(last)) || is_stopped(news);
    let held =
        |news: &[News]| matches!(news.last(), Some(News::Status(status)) if status.state == State::Held);
    while !over(&rig.news) {
        assert!(
            rig.until(Duration::from_mins(10), |news| over(news) || held(news)),
            "not made: {:?}",
            rig.link.progress()
        );
        // It has heard nothing for a second; somebody is there, and says so.
        if held(&rig.news) && rig.link.is_answered() {
            rig.link.ask(Ask::GoOn);
        }
        rig.slice();
    }
    if is_stopped(&rig.news) {
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
    println!("{percent} %: {made} of {SEEDS} runs of {MOVES} moves made, the others stopped");
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
        rig.news.clear();
        rig.until(Duration::from_secs(3), |_| false);
        assert_eq!(rig.counted, before, "{payload} moved something after a STOP");
        assert_eq!(status(&rig).unwrap().state, State::Alarm);
    }
}

/// A person takes their time with a question, and nobody looks at the machine meanwhile.
#[test]
fn a_controller_that_nobody_listened_to_for_a_while_is_not_gone() {
    let mut rig = Rig::new(78, Noise::new(0, 0.0));
    assert!(ready(&mut rig).is_ok());
    for away in [1, 3, 60, 3600] {
        rig.news.clear();
        rig.away(Duration::from_secs(away));
        let stands = |news: &[News]| news.iter().any(|news| matches!(news, News::Status(_)));
        assert!(rig.until(Duration::from_secs(2), stands), "no answer after {away} s");
        assert!(!rig.news.contains(&News::Silent), "after {away} s");
    }
}
